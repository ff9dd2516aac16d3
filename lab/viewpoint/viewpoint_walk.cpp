// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/viewpoint/viewpoint_walk.h"

#include <algorithm>

#include "core/run/drawn_levels.h"
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

double mean_of(const std::vector<WalkFrame>& frames, const std::function<double(const WalkFrame&)>& value) {
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

}  // namespace

double WalkFrame::best_ms() const {
    double best = alone.front().ms();
    for (const FrameTime& time : alone) best = std::min(best, time.ms());
    return best;
}

double ViewpointWalk::adaptive_ms() const {
    return mean_of(frames, [](const WalkFrame& frame) { return frame.adaptive.ms(); });
}
double ViewpointWalk::hindsight_ms() const {
    return mean_of(frames, [](const WalkFrame& frame) { return frame.best_ms(); });
}
double ViewpointWalk::alone_ms(std::size_t technique) const {
    return mean_of(frames, [&](const WalkFrame& frame) { return frame.alone[technique].ms(); });
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

ViewpointWalk walk_by_viewpoint(const Method<3>& by_viewpoint, const Parameters& parameters,
                                const ViewpointTable<3>& table, const std::shared_ptr<const Scene<3>>& scene,
                                const CellComplex<3>& cells, const std::vector<View<3>>& views,
                                const TimeDrawing& time_drawing, int repeats,
                                const std::function<bool(std::size_t)>& go_on) {
    const ViewpointProblem<3>& of = table.problem();
    std::vector<Traveller> travellers;
    for (const Variant<3>& option : of.options) travellers.push_back({&option.method, option.parameters});
    travellers.push_back({&by_viewpoint, parameters});
    Services services;
    services.image = of.image;
    const auto drawn = one_scene(of, scene);
    ViewpointWalk walk;
    std::vector<double> empty;
    std::vector<std::uint32_t> ids;
    std::uint32_t last = none;
    for (const View<3>& view : views) {
        for (Traveller& t : travellers) {
            t.cull.clear();
            t.draw.clear();
        }
        WalkFrame& frame = walk.frames.emplace_back();
        for (int repeat = 0; repeat < repeats; ++repeat) {
            const DrawTimes nothing = time_drawing(drawn, view, {});
            const double nothing_ms = nothing.upload + nothing.draw;
            empty.push_back(nothing_ms);
            for (Traveller& t : travellers) {
                const Problem<3> problem =
                    make_problem(*t.method, t.parameters, *scene, cells, view, none, services, t.history);
                t.cull.push_back(run_milliseconds(*t.method, problem, t.run));
                drawn_ids(*t.run, ids);
                const DrawTimes times = time_drawing(drawn, view, ids);
                t.draw.push_back(std::max(0.0, times.upload + times.draw - nothing_ms));
                if (repeat == 0) t.next = t.run->next_history();
            }
        }
        for (Traveller& t : travellers) {
            const FrameTime time{median(t.cull), median(t.draw), t.run->counters().drawn()};
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
        if (!go_on(walk.frames.size())) break;
    }
    walk.empty_ms = median(empty);
    walk.look_up_ns = look_up_ns(table, views);
    return walk;
}

}  // namespace sightline::lab
