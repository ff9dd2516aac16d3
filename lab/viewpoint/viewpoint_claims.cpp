// What the paper says of its campus (DAS 3 and 6), beside what a walk finds.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number.h"
#include "lab/viewpoint/viewpoint_report.h"

namespace sightline::lab {

namespace {

/// The paper's frames a second: nothing but drawing, the worst with view culling, in rooms at least, on the ground at
/// least where a few large occluders stand near.
constexpr double plain_fps = 0.6, view_fps = 2, room_fps = 30, street_fps = 10;

std::string fps_text(double ms) { return short_number(1000 / ms, 2); }
std::string times_text(double times) { return short_number(times, 3) + " times"; }

std::optional<std::size_t> option(const ViewpointScene& scene, std::string_view id) {
    for (std::size_t i = 0; i < scene.options().size(); ++i)
        if (scene.options()[i].method.id == id) return i;
    return std::nullopt;
}

struct WalkJudge {
    const char *source, *text, *test;
    std::optional<Regime> (*judge)(const ViewpointScene& scene);
};

Regime regime_of(const ViewpointScene& scene, std::string figures, bool holds) {
    return {scene.scene, scene.path, std::move(figures), holds, nullptr};
}

std::optional<Regime> view_culling_helps(const ViewpointScene& scene) {
    const auto view = option(scene, "view");
    if (!view) return std::nullopt;
    double plain = 0;
    for (const WalkFrame& frame : scene.walk.frames) plain = std::max(plain, frame.everything.ms());
    const double worst = scene.walk.worst_alone_ms(*view);
    return regime_of(scene,
                     fps_text(plain) + " and " + fps_text(worst) + " frames a second, " + times_text(plain / worst),
                     plain / worst >= view_fps / plain_fps);
}

std::optional<Regime> rooms_are_fast(const ViewpointScene& scene) {
    const auto view = option(scene, "view");
    if (!view || scene.walk.frames_at(EyePlace::inside) == 0) return std::nullopt;
    double slowest = 0, fastest = INFINITY;
    for (const WalkFrame& frame : scene.walk.frames)
        if (frame.where == EyePlace::inside) {
            slowest = std::max(slowest, frame.adaptive.ms());
            fastest = std::min(fastest, frame.adaptive.ms());
        }
    const double times = scene.walk.worst_alone_ms(*view) / slowest;
    return regime_of(scene,
                     fps_text(slowest) + " to " + fps_text(fastest) + " frames a second, the slowest " +
                         times_text(times) + " as fast as view culling's worst",
                     times >= room_fps / view_fps);
}

std::optional<Regime> shadows_help(const ViewpointScene& scene) {
    const auto view = option(scene, "view"), shadows = option(scene, "shadow-frusta");
    if (!view || !shadows || scene.walk.frames_at(EyePlace::street) == 0) return std::nullopt;
    const double ours =
        scene.walk.mean_at(EyePlace::street, [&](const WalkFrame& f) { return f.alone[*shadows].ms(); });
    const double without =
        scene.walk.mean_at(EyePlace::street, [&](const WalkFrame& f) { return f.alone[*view].ms(); });
    const double times = scene.walk.worst_alone_ms(*view) / ours;
    return regime_of(scene,
                     fps_text(ours) + " frames a second in the mean, " + times_text(times) +
                         " as fast as view culling's worst, and " + times_text(without / ours) +
                         " as view culling there",
                     times >= street_fps / view_fps);
}

/// Of what the paper had: view culling, shadow frusta, portals.
std::optional<Regime> nothing_helps_high_up(const ViewpointScene& scene) {
    const auto view = option(scene, "view");
    if (!view || scene.walk.frames_at(EyePlace::above) == 0) return std::nullopt;
    const auto mean = [&](std::size_t i) {
        return scene.walk.mean_at(EyePlace::above, [&](const WalkFrame& f) { return f.alone[i].ms(); });
    };
    double best = mean(*view);
    for (const char* const id : {"shadow-frusta", "portals"})
        if (const auto i = option(scene, id)) best = std::min(best, mean(*i));
    const double times = mean(*view) / best;
    return regime_of(scene, fps_text(best) + " frames a second, " + times_text(times) + " as fast as view culling",
                     times < 1.2);
}

std::optional<Regime> maps_help_high_up(const ViewpointScene& scene) {
    const auto view = option(scene, "view"), maps = option(scene, "hom");
    if (!view || !maps || scene.walk.frames_at(EyePlace::above) == 0) return std::nullopt;
    const auto mean = [&](std::size_t i) {
        return scene.walk.mean_at(EyePlace::above, [&](const WalkFrame& f) { return f.alone[i].ms(); });
    };
    std::string others;
    if (const auto boxes = option(scene, "boxes"))
        others = "; boxes against a depth image " + times_text(mean(*view) / mean(*boxes));
    const double times = mean(*view) / mean(*maps);
    return regime_of(scene, times_text(times) + " as fast as view culling" + others, times > 1);
}

std::optional<Regime> none_is_best_everywhere(const ViewpointScene& scene) {
    std::vector<std::size_t> wins(scene.options().size());
    for (const WalkFrame& frame : scene.walk.frames) ++wins[frame.best()];
    std::string text;
    for (std::size_t i = 0; i < wins.size(); ++i)
        if (wins[i] > 0)
            text += (text.empty() ? "best: " : ", ") + scene.options()[i].text + " in " + std::to_string(wins[i]);
    const ViewpointWalk& walk = scene.walk;
    const std::size_t best = walk.best_alone();
    const double share = walk.hindsight_ms() / walk.alone_ms(best);
    return regime_of(scene,
                     text + " of " + std::to_string(walk.frames.size()) + " frames; with hindsight " +
                         short_number(walk.hindsight_ms()) + " ms, " + scene.options()[best].text + " alone " +
                         short_number(walk.alone_ms(best)) + " ms",
                     share < 0.9);
}

std::optional<Regime> choosing_pays(const ViewpointScene& scene) {
    const ViewpointWalk& walk = scene.walk;
    const std::size_t best = walk.best_alone();
    return regime_of(scene,
                     inequality_text(walk, best) + " ms (" + scene.options()[best].text + "); " +
                         short_number(walk.adaptive_ms() / walk.hindsight_ms(), 3) + " times the best of each frame",
                     1e-6 * walk.look_up_ns + walk.adaptive_ms() < walk.alone_ms(best));
}

constexpr std::array walk_judges{
    WalkJudge{"DAS 6", "All of it is drawn at 0.6 frames a second; with view culling the worst views reach 2.",
              "view culling's worst frame at least 3.3 times as fast as drawing everything", view_culling_helps},
    WalkJudge{"DAS 6", "In rooms 30 to 75 frames a second are easily reached.",
              "by viewpoint, the slowest frame at least 15 times as fast as view culling's worst", rooms_are_fast},
    WalkJudge{"DAS 6", "Near the ground shadow frusta reach 10 to 30 where large objects stand close.",
              "their mean at least 5 times as fast as view culling's worst", shadows_help},
    WalkJudge{"DAS 6", "In the open and above the roofs its techniques fall back to 2.",
              "view culling, shadow frusta and portals there: at most 1.2 times as fast as view culling",
              nothing_helps_high_up},
    WalkJudge{"DAS 6", "It expects occlusion maps to help there.", "hom faster than view culling there",
              maps_help_high_up},
    WalkJudge{"DAS 1", "No technique is the best one everywhere.",
              "the best of each frame takes less than .9 of the best single one", none_is_best_everywhere},
    WalkJudge{"DAS 3", "Choosing pays: t_select / valid_frames + t(α) < t(β).", "β: the best single one",
              choosing_pays}};

}  // namespace

std::vector<Claim> viewpoint_claims(const ViewpointResults& results) {
    std::vector<Claim> claims;
    for (const WalkJudge& row : walk_judges) {
        Claim claim{row.source, row.text, row.test, {}};
        for (const ViewpointScene& scene : results.scenes)
            if (std::optional<Regime> regime = row.judge(scene)) claim.regimes.push_back(std::move(*regime));
        if (!claim.regimes.empty()) claims.push_back(std::move(claim));
    }
    return claims;
}

}  // namespace sightline::lab
