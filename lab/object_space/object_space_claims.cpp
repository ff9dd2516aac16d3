// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "core/base/number.h"
#include "lab/object_space/object_space_report.h"
#include "lab/object_space/papers_scenes.h"

namespace sightline::lab {

namespace {

/// What "almost a factor of four" has to reach.
constexpr double almost_four = 3.5;
/// What a fourfold frame may take in threads to be worth them.
constexpr double least_parallel_ms = 1;

std::string two(double value) { return short_number(std::round(100 * value) / 100); }

/// Index of a method in the walks, or nothing.
std::optional<std::size_t> find(const ObjectSpaceScene& scene, const char* method) {
    if (scene.all_round.empty()) return std::nullopt;
    const auto& rows = scene.all_round.front();
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].method == method) return i;
    return std::nullopt;
}

double mean_ms(const ObjectSpaceScene& scene, std::size_t method) {
    double sum = 0;
    for (const auto& seed : scene.all_round) sum += seed[method].cost.visible_ms;
    return sum / static_cast<double>(scene.all_round.size());
}

constexpr const char *single = "coorg-teller", *connected = "coorg-teller connected=on";

struct Judge {
    const char *source, *text, *test;
    std::optional<Regime> (*judge)(const ObjectSpaceScene& scene, const ObjectSpaceOptions& options);
};

std::optional<Regime> connected_is_better(const ObjectSpaceScene& scene, const ObjectSpaceOptions& options) {
    const auto one = find(scene, single), several = find(scene, connected);
    if (!one || !several) return std::nullopt;
    const double a = mean_cull(scene, *one), b = mean_cull(scene, *several), ms_a = mean_ms(scene, *one),
                 ms_b = mean_ms(scene, *several);
    return Regime{{},
                  options.walk,
                  "Cull " + share_text(a) + " and " + share_text(b) + ", " + short_number(ms_a) + " and " +
                      short_number(ms_b) + " ms",
                  b > a && ms_b < ms_a,
                  nullptr};
}

std::optional<Regime> culls_as_much(const ObjectSpaceScene& scene, const ObjectSpaceOptions& options) {
    const auto several = find(scene, connected);
    const PapersScene* const paper = papers_scene(scene.name);
    if (!several || !paper) return std::nullopt;
    const double found = mean_cull(scene, *several);
    return Regime{{},
                  options.walk,
                  share_text(found) + " over " + std::to_string(scene.seeds.size()) + " seeds, theirs " +
                      share_text(paper->connected.culled),
                  found >= paper->connected.culled,
                  nullptr};
}

std::optional<Regime> misses_nothing(const ObjectSpaceScene& scene, const ObjectSpaceOptions& options) {
    if (scene.all_round.empty()) return std::nullopt;
    std::size_t missed = 0, pixels = 0;
    for (const auto& seed : scene.all_round)
        for (const AllRound& row : seed) {
            missed += row.culled.missed;
            pixels += row.culled.missed_pixels;
        }
    return Regime{{},
                  options.walk,
                  std::to_string(missed) + " visible triangles missed, " + std::to_string(pixels) + " pixels",
                  missed == 0,
                  nullptr};
}

std::optional<Regime> view_saves(const ObjectSpaceScene& scene, const ObjectSpaceOptions& options) {
    for (const InView& row : scene.in_view)
        if (row.method == connected) {
            const double times = row.all_round.visible_ms / row.cost.visible_ms;
            return Regime{
                {},
                options.walk,
                two(times) + " times as fast, " + two(row.all_round.boxes / row.cost.boxes) + " times fewer boxes",
                times >= almost_four,
                nullptr};
        }
    return std::nullopt;
}

std::optional<Regime> fast_eyes_cost(const ObjectSpaceScene& scene, const ObjectSpaceOptions& options) {
    const PapersScene* const paper = papers_scene(scene.name);
    if (scene.speeds.empty() || scene.speeds.back().speed != 16 || !paper) return std::nullopt;
    const double times = scene.speeds.back().keeping.visible_ms / scene.speeds.front().keeping.visible_ms,
                 theirs = paper->speeds.back() / paper->speeds.front();
    return Regime{{}, options.line, two(times) + " times, theirs " + two(theirs), times <= theirs, nullptr};
}

std::optional<Regime> threads_pay(const ObjectSpaceScene& scene, const ObjectSpaceOptions& options) {
    if (scene.workers.size() < 2 || scene.workers.front().cost.visible_ms < least_parallel_ms) return std::nullopt;
    const double times = scene.workers[0].cost.visible_ms / scene.workers[1].cost.visible_ms;
    return Regime{{},
                  options.walk,
                  two(times) + " times as fast from " + short_number(scene.workers[0].cost.visible_ms) + " ms",
                  times >= 1.3,
                  nullptr};
}

std::optional<Regime> pays(const ObjectSpaceScene& scene, const ObjectSpaceOptions& options) {
    for (const InView& row : scene.in_view)
        if (row.method == connected) {
            const double hidden = hidden_ms(scene.in_view.front(), row), cull = row.cost.cull_ms();
            const bool is_drawn = row.draw_ms > 0;
            return Regime{{},
                          options.walk,
                          short_number(cull) + " ms" +
                              (is_drawn ? ", " + two(cull / hidden) + " of the " + short_number(hidden) +
                                              " ms that view culling spends on what it hides"
                                        : std::string()),
                          cull <= 0.5 && (!is_drawn || (hidden > 0 && cull <= hidden / 4)),
                          nullptr};
        }
    return std::nullopt;
}

constexpr std::array judges{
    Judge{"CT 2", "What is visible is never culled.", "six item buffers, all methods and seeds", misses_nothing},
    Judge{"CT 4.2, table 2", "It finds .75 (Soda), .38 (City) and .69 (Tetra) of the polygons that are invisible.",
          "connected=on, mean over seeds", culls_as_much},
    Judge{"CT 4.2", "Connected occluders cull more than single ones, and take less time.", "Cull and Vis of table 2",
          connected_is_better},
    Judge{"CT 4.2", "Switching off what lies outside the view makes it almost four times as fast.",
          "connected=on, at least 3.5 times", view_saves},
    Judge{"CT 4.3, table 3", "At 16 times walking speed it takes 3.6 (Soda), 3.8 (City) and 4.3 (Tetra) times as long.",
          "at most that", fast_eyes_cost},
    Judge{"CT 4.4, table 4", "Two processors are 1.3 to 1.55 times as fast as one.",
          "at least 1.3 times, where a frame takes more than a millisecond", threads_pay},
    Judge{"CT 1", "It runs at interactive rates and culls more than it costs.",
          "connected=on: at most 0.5 ms a frame, and a quarter of what view culling spends on what it hides", pays}};

}  // namespace

std::string share_text(double value) {
    if (std::isnan(value)) return "–";
    std::string text = short_number(std::round(1000 * value) / 1000);
    return text.starts_with("0.") ? text.substr(1) : text;
}

std::vector<Claim> object_space_claims(const ObjectSpaceResults& results) {
    std::vector<Claim> claims;
    for (const Judge& row : judges) {
        Claim claim{row.source, row.text, row.test, {}};
        for (const ObjectSpaceScene& scene : results.scenes)
            if (std::optional<Regime> regime = row.judge(scene, results.options)) {
                regime->scene = scene.name;
                claim.regimes.push_back(std::move(*regime));
            }
        if (!claim.regimes.empty()) claims.push_back(std::move(claim));
    }
    return claims;
}

}  // namespace sightline::lab
