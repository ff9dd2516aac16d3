// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/viewpoint/viewpoint_walk.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/measure/drawn_image.h"
#include "core/run/drawn_levels.h"
#include "core/truth/truth.h"
#include "lab/viewpoint/calibrate.h"

namespace sightline::lab {

namespace {

/// A technique, or the choice of one, on its way along the path.
struct Traveller {
    const Method<3>* method;
    Parameters parameters;
    OwnRun<3> run{};
    std::shared_ptr<const FrameHistory> history{}, next{};
    std::vector<double> cull{}, draw{};
};

double mean_over(const std::vector<WalkFrame>& frames, const std::function<double(const WalkFrame&)>& value) {
    double sum = 0;
    for (const WalkFrame& frame : frames) sum += value(frame);
    return frames.empty() ? 0 : sum / static_cast<double>(frames.size());
}

double most_of(const std::vector<WalkFrame>& frames, const std::function<double(const WalkFrame&)>& value) {
    double most = 0;
    for (const WalkFrame& frame : frames) most = std::max(most, value(frame));
    return most;
}

double look_up_ns(const ViewpointTable<3>& table, const std::vector<View<3>>& views) {
    constexpr int times = 2000;
    std::size_t sum = 0;
    const Stopwatch clock;
    for (int i = 0; i < times; ++i)
        for (const View<3>& view : views)
            if (const Entry* entry = table.find(table.place(view))) sum += entry->chosen + 1;
    const double ns = 1e6 * clock.milliseconds() / (times * static_cast<double>(views.size()));
    return sum > 0 ? ns : 0;
}

/// Nobody asks which cells are seen.
Reference exact_image(const Scene<3>& scene, const View<3>& view, const ImageSize& size, const DrawIds& draw_ids) {
    return make_reference(scene, CellComplex<3>{}, view, size, draw_ids);
}

}  // namespace

EyePlace eye_place(const Scene<3>& scene, const Vec<3>& eye) {
    if (!rooms_at(scene.rooms, eye).rooms.empty()) return EyePlace::inside;
    const int up = scene.up_axis;
    double top = -std::numeric_limits<double>::infinity();
    for (const Primitive<3>& primitive : scene.primitives)
        for (const Vec<3>& vertex : primitive) top = std::max(top, vertex[up]);
    return eye[up] > top ? EyePlace::above : EyePlace::street;
}

std::size_t WalkFrame::best() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < alone.size(); ++i)
        if (alone[i].ms() < alone[best].ms()) best = i;
    return best;
}
double WalkFrame::best_ms() const { return alone[best()].ms(); }

double ViewpointWalk::adaptive_ms() const {
    return mean_over(frames, [](const WalkFrame& frame) { return frame.adaptive.ms(); });
}
double ViewpointWalk::hindsight_ms() const {
    return mean_over(frames, [](const WalkFrame& frame) { return frame.best_ms(); });
}
double ViewpointWalk::alone_ms(std::size_t technique) const {
    return mean_over(frames, [&](const WalkFrame& frame) { return frame.alone[technique].ms(); });
}
double ViewpointWalk::worst_adaptive_ms() const {
    return most_of(frames, [](const WalkFrame& frame) { return frame.adaptive.ms(); });
}
double ViewpointWalk::worst_alone_ms(std::size_t technique) const {
    return most_of(frames, [&](const WalkFrame& frame) { return frame.alone[technique].ms(); });
}
std::size_t ViewpointWalk::best_alone() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < frames.front().alone.size(); ++i)
        if (alone_ms(i) < alone_ms(best)) best = i;
    return best;
}

double ViewpointWalk::mean_at(EyePlace where, const std::function<double(const WalkFrame&)>& value) const {
    std::vector<WalkFrame> there;
    for (const WalkFrame& frame : frames)
        if (frame.where == where) there.push_back(frame);
    return there.empty() ? std::numeric_limits<double>::quiet_NaN() : mean_over(there, value);
}
std::size_t ViewpointWalk::frames_at(EyePlace where) const {
    return static_cast<std::size_t>(
        std::count_if(frames.begin(), frames.end(), [&](const WalkFrame& frame) { return frame.where == where; }));
}
double ViewpointWalk::r2() const {
    std::vector<double> predicted, measured;
    for (const WalkFrame& frame : frames) {
        predicted.push_back(frame.predicted_ms);
        measured.push_back(frame.adaptive.ms());
    }
    return r_squared(predicted, measured);
}

ViewpointWalk walk_by_viewpoint(const Variant<3>& by_viewpoint, const ViewpointTable<3>& table,
                                const std::shared_ptr<const Scene<3>>& scene, const CellComplex<3>& cells,
                                const std::vector<View<3>>& views, const WalkTools& tools) {
    const ViewpointProblem<3>& of = table.problem();
    std::vector<Traveller> travellers;
    for (const Variant<3>& option : of.options) travellers.push_back({&option.method, option.parameters});
    travellers.push_back({&by_viewpoint.method, by_viewpoint.parameters});
    Services services;
    services.image = of.image;
    const auto drawn = one_scene(of, scene);
    ViewpointWalk walk;
    std::vector<double> empty;
    std::vector<std::uint32_t> ids, all(scene->primitives.size());
    std::iota(all.begin(), all.end(), 0u);
    std::uint32_t last = none;
    for (const View<3>& view : views) {
        for (Traveller& t : travellers) {
            t.cull.clear();
            t.draw.clear();
        }
        WalkFrame& frame = walk.frames.emplace_back();
        frame.where = eye_place(*scene, view.eye);
        std::vector<double> everything;
        for (int repeat = 0; repeat < tools.repeats; ++repeat) {
            const DrawTimes nothing = tools.time_drawing(drawn, view, {});
            const double nothing_ms = nothing.upload + nothing.draw;
            empty.push_back(nothing_ms);
            for (Traveller& t : travellers) {
                const Problem<3> problem =
                    make_problem(*t.method, t.parameters, *scene, cells, view, none, services, t.history);
                t.cull.push_back(run_milliseconds(*t.method, problem, t.run));
                drawn_ids(*t.run, ids);
                const DrawTimes times = tools.time_drawing(drawn, view, ids);
                t.draw.push_back(std::max(0.0, times.upload + times.draw - nothing_ms));
                if (repeat == 0) t.next = t.run->next_history();
            }
            const DrawTimes times = tools.time_drawing(drawn, view, all);
            everything.push_back(std::max(0.0, times.upload + times.draw - nothing_ms));
        }
        frame.everything = {0, median(everything), static_cast<std::uint32_t>(all.size()), 0};
        const Reference exact = exact_image(*scene, view, of.image, tools.draw_ids);
        for (Traveller& t : travellers) {
            const FrameTime time{median(t.cull), median(t.draw), t.run->counters().drawn(),
                                 wrong_pixels(exact, *t.run, tools.draw_ids)};
            if (&t == &travellers.back())
                frame.adaptive = time;
            else
                frame.alone.push_back(time);
            t.history = t.next;
        }
        const auto& run = dynamic_cast<const ViewpointRun<3>&>(*travellers.back().run);
        frame.technique = run.technique();
        frame.place = run.place();
        frame.entry = run.table().find(run.place())->chosen;
        frame.predicted_ms = run.table().find(run.place())->facts.costs[frame.technique].ms();
        walk.switches += last != none && last != frame.technique;
        last = frame.technique;
        if (!tools.go_on(walk.frames.size())) break;
    }
    walk.empty_ms = median(empty);
    walk.look_up_ns = look_up_ns(table, views);
    return walk;
}

}  // namespace sightline::lab
