// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/measure_frontier.h"

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/scene/scene_view.h"

namespace sightline {

namespace {

/// Milliseconds between two slices that a frame of the window may take; what is longer was a pause.
constexpr double longest_frame = 300;

/// Why what is measured is not what is on the bench; empty: it is.
template <int D>
std::string what_changed(const Workbench<D>& bench, const std::vector<ViewSpec<D>>& views, const std::string& path) {
    const Frontier<D>& frontier = bench.frontier;
    const FrontierTask<D>& task = frontier.study.task();
    if (!task.scene) return "first";
    if (task.scene != bench.session.shared_scene()) return "another scene";
    if (task.cells != bench.session.shared_cells()) return "another tessellation";
    if (!(task.reference_size == bench.session.settings().reference_size)) return "another reference size";
    if (frontier.path != path) return "another path";
    if (frontier.views != views) return bench.flight.path.frames.empty() ? "the view moved" : "another path";
    return "";
}

}  // namespace

template <int D>
bool stands_still(const Workbench<D>& bench) {
    const Flight<D>& flight = bench.flight;
    return !bench.transport.playing && !flight.on && !flight.recording && !flight.replaying && !bench.session.flying();
}

template <int D>
void update_frontier(Workbench<D>& bench) {
    Frontier<D>& frontier = bench.frontier;
    const Session<D>& session = bench.session;
    const auto& all = bench.flight.path.frames;
    std::vector<ViewSpec<D>> views;
    std::string path = "this view alone";
    if (all.empty()) {
        views.push_back(session.culling_view());
    } else {
        for (const std::size_t frame : spread_frames(all.size(), frontier_frames)) views.push_back(all[frame]);
        path = "path " + bench.flight.path.id + ", " + std::to_string(views.size()) + " of " +
               std::to_string(all.size()) + " frames";
    }
    if (const std::string why = what_changed(bench, views, path); !why.empty()) {
        FrontierTask<D> task{session.shared_scene(), session.shared_cells(), session.settings().reference_size, {}, {}};
        for (const ViewSpec<D>& view : views)
            task.views.push_back(scene_view(view, session.scene(), session.settings().reference_size));
        for (const Method<D>& method : bench.methods)
            if (method.compared)
                task.variants.push_back(
                    variant_of(method, session.settings().parameters, session.settings().parameters));
        task.draw_ids = bench.graphics.draw_ids;
        if (D == 3 && bench.graphics.time_drawing)
            task.time_drawing = bench.graphics.time_drawing(session.settings().reference_size);
        const bool begun = frontier.study.done() > 0;
        frontier.study = FrontierStudy<D>(std::move(task));
        frontier.base = session.settings().parameters;
        frontier.path = std::move(path);
        frontier.views = std::move(views);
        frontier.word = begun ? "begun anew: " + why : "";
        frontier.spent_ms = 0;
        frontier.since.reset();
    }
    for (const std::string& text : frontier.added)
        frontier.study.ask(make_variant<D>(bench.methods, text, frontier.base), {});
    frontier.study.ask(current_variant(bench), session.settings().budget);
}

template <int D>
void restart_frontier(Workbench<D>& bench) {
    std::vector<std::string> added = std::move(bench.frontier.added);
    bench.frontier = {bench.frontier.shown};
    bench.frontier.added = std::move(added);
    update_frontier(bench);
}

template <int D>
bool advance_frontier(Workbench<D>& bench, double milliseconds) {
    update_frontier(bench);
    Frontier<D>& frontier = bench.frontier;
    const double between = frontier.since ? frontier.since->milliseconds() : 0;
    const Stopwatch stopwatch;
    try {
        while (!frontier.stopped && !frontier.study.finished() && stopwatch.milliseconds() < milliseconds)
            frontier.study.advance();
    } catch (const WorkError& error) {
        frontier.stopped = true;
        frontier.word = error.what();
    }
    frontier.spent_ms += stopwatch.milliseconds() + (between < longest_frame ? between : 0);
    frontier.since.emplace();
    return !frontier.stopped && !frontier.study.finished();
}

template <int D>
std::string frontier_progress_text(const Workbench<D>& bench) {
    const FrontierStudy<D>& study = bench.frontier.study;
    const std::string count = std::to_string(study.done()) + " of " + std::to_string(study.total());
    if (study.finished()) return count;
    if (bench.frontier.stopped) return count + ", stopped";
    if (!stands_still(bench)) return count + ", waits for rest";
    if (study.done() == 0) return count;
    const auto done = static_cast<double>(study.done()), total = static_cast<double>(study.total());
    return count + ", about " + duration_text(bench.frontier.spent_ms / 1000 / done * (total - done)) + " left";
}

template <int D>
std::string frontier_work_text(const Workbench<D>& bench) {
    const FrontierStudy<D>& study = bench.frontier.study;
    const FrontierDot* const dot = study.next_dot();
    if (!dot || bench.frontier.stopped || !stands_still(bench)) return "";
    return "measuring " + study.task().variants[dot->variant].text + " " + budget_text(dot->budget) + ", frame " +
           std::to_string(dot->frames.size() + 1) + " of " + std::to_string(study.task().views.size());
}

template <int D>
std::string frontier_time_text(const Workbench<D>& bench) {
    if (!bench.frontier.study.task().time_drawing) return "traversal alone, ms per frame";
    return "traversal + upload + drawing, ms per frame";
}

template <int D>
std::string frontier_command(const Workbench<D>& bench, const FrontierDot& dot) {
    return "frontier " + bench.frontier.study.task().variants[dot.variant].text + " " + budget_text(dot.budget);
}

template <int D>
Variant<D> current_variant(const Workbench<D>& bench) {
    return variant_of(bench.session.method(), bench.session.settings().parameters, bench.frontier.base);
}

template <int D>
bool is_current(const Workbench<D>& bench, const FrontierDot& dot) {
    return bench.frontier.study.task().variants[dot.variant].text == current_variant(bench).text &&
           dot.budget == bench.session.settings().budget;
}

template <int D>
std::vector<std::size_t> frontier_front(const Workbench<D>& bench) {
    const Frontier<D>& frontier = bench.frontier;
    std::vector<Trade> trades;
    for (const FrontierDot& dot : frontier.study.dots())
        trades.push_back({frontier.study.value(dot, Measure::total_ms), frontier.study.value(dot, frontier.shown)});
    return pareto_front(trades, measure_row(frontier.shown).better);
}

#define SIGHTLINE_INSTANTIATE(D)                                                           \
    template bool stands_still<D>(const Workbench<D>&);                                    \
    template void update_frontier<D>(Workbench<D>&);                                       \
    template void restart_frontier<D>(Workbench<D>&);                                      \
    template bool advance_frontier<D>(Workbench<D>&, double);                              \
    template std::string frontier_progress_text<D>(const Workbench<D>&);                   \
    template std::string frontier_work_text<D>(const Workbench<D>&);                       \
    template std::string frontier_time_text<D>(const Workbench<D>&);                       \
    template std::string frontier_command<D>(const Workbench<D>&, const FrontierDot& dot); \
    template Variant<D> current_variant<D>(const Workbench<D>&);                           \
    template bool is_current<D>(const Workbench<D>&, const FrontierDot& dot);              \
    template std::vector<std::size_t> frontier_front<D>(const Workbench<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
