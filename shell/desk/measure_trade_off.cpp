// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/measure_trade_off.h"

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/truth/software_ids.h"
#include "shell/desk/frames_to_measure.h"

namespace sightline {

namespace {

/// Milliseconds between two slices that a frame of the window may take; what is longer was a pause.
constexpr double longest_frame = 300;

/// Why what is measured is not what is on the bench; empty: it is.
template <int D>
std::string what_changed(const Workbench<D>& bench, const std::vector<ViewSpec<D>>& views, const std::string& path) {
    const TradeOff<D>& trade_off = bench.trade_off;
    const TradeOffTask<D>& task = trade_off.study.task();
    if (!task.scene) return "first";
    if (task.scene != bench.session.shared_scene()) return "another scene";
    if (task.cells != bench.session.shared_cells()) return "another tessellation";
    if (!(task.reference_size == bench.session.settings().reference_size)) return "another reference size";
    if (trade_off.reference != bench.session.settings().reference) return "another reference";
    if (trade_off.path != path) return "another path";
    if (trade_off.views != views) return bench.flight.path.frames.empty() ? "the view moved" : "another path";
    return "";
}

}  // namespace

template <int D>
bool stands_still(const Workbench<D>& bench) {
    const Flight<D>& flight = bench.flight;
    return !bench.transport.playing && !flight.on && !flight.recording && !flight.replaying && !bench.session.flying();
}

template <int D>
void update_trade_off(Workbench<D>& bench) {
    TradeOff<D>& trade_off = bench.trade_off;
    const Session<D>& session = bench.session;
    const auto& all = bench.flight.path.frames;
    const auto frames = frames_to_measure(all, session.culling_view(), trade_off_frames);
    std::vector<ViewSpec<D>> views;
    for (const FrameToMeasure<D>& frame : frames) views.push_back(frame.view);
    const std::string path = all.empty() ? "current view only"
                                         : "path " + bench.flight.path.id + ", " + std::to_string(views.size()) +
                                               " of " + std::to_string(all.size()) + " frames";
    if (const std::string why = what_changed(bench, views, path); !why.empty()) {
        TradeOffTask<D> task{session.shared_scene(), session.shared_cells(), session.settings().reference_size, {}, {}};
        add_frames(task, frames);
        for (const Method<D>& method : bench.methods)
            if (method.compared && !method.needs.history)  // the frames of a chart follow no path
                task.variants.push_back(
                    variant_of(method, session.settings().parameters, session.settings().parameters));
        task.draw_ids = drawing_of(session.settings().reference, bench.graphics.draw_ids);
        if (D == 3 && bench.graphics.time_drawing)
            task.time_drawing = bench.graphics.time_drawing(session.settings().reference_size);
        const bool begun = trade_off.study.done() > 0;
        trade_off.study = TradeOffStudy<D>(std::move(task));
        trade_off.base = session.settings().parameters;
        trade_off.reference = session.settings().reference;
        trade_off.path = path;
        trade_off.views = std::move(views);
        trade_off.word = begun ? "restarted: " + why : "";
        trade_off.spent_ms = 0;
        trade_off.since.reset();
    }
    for (const std::string& text : trade_off.added)
        trade_off.study.ask(make_variant<D>(bench.methods, text, trade_off.base), {});
    trade_off.study.ask(current_variant(bench), session.settings().budget);
}

template <int D>
void restart_trade_off(Workbench<D>& bench) {
    std::vector<std::string> added = std::move(bench.trade_off.added);
    bench.trade_off = {bench.trade_off.shown};
    bench.trade_off.added = std::move(added);
    update_trade_off(bench);
}

template <int D>
bool advance_trade_off(Workbench<D>& bench, double milliseconds) {
    update_trade_off(bench);
    TradeOff<D>& trade_off = bench.trade_off;
    const double between = trade_off.since ? trade_off.since->milliseconds() : 0;
    const Stopwatch stopwatch;
    try {
        while (!trade_off.stopped && !trade_off.study.finished() && stopwatch.milliseconds() < milliseconds)
            trade_off.study.advance();
    } catch (const WorkError& error) {
        trade_off.stopped = true;
        trade_off.word = error.what();
    }
    trade_off.spent_ms += stopwatch.milliseconds() + (between < longest_frame ? between : 0);
    trade_off.since.emplace();
    return !trade_off.stopped && !trade_off.study.finished();
}

template <int D>
std::string trade_off_progress_text(const Workbench<D>& bench) {
    const TradeOffStudy<D>& study = bench.trade_off.study;
    const std::string count = std::to_string(study.done()) + " of " + std::to_string(study.total());
    if (study.finished()) return count;
    if (bench.trade_off.stopped) return count + ", stopped";
    if (!stands_still(bench)) return count + ", paused during playback and flight";
    if (study.done() == 0) return count;
    const auto done = static_cast<double>(study.done()), total = static_cast<double>(study.total());
    return count + ", about " + duration_text(bench.trade_off.spent_ms / 1000 / done * (total - done)) + " left";
}

template <int D>
std::string trade_off_work_text(const Workbench<D>& bench) {
    const TradeOffStudy<D>& study = bench.trade_off.study;
    const TradeOffDot* const dot = study.next_dot();
    if (!dot || bench.trade_off.stopped || !stands_still(bench)) return "";
    return "measuring " + study.task().variants[dot->variant].text + " " + budget_text(dot->budget) + ", frame " +
           std::to_string(dot->frames.size() + 1) + " of " + std::to_string(study.task().views.size());
}

template <int D>
std::string trade_off_time_text(const Workbench<D>& bench) {
    if (!bench.trade_off.study.task().time_drawing) return "traversal alone, ms per frame";
    return "traversal + upload + drawing, ms per frame";
}

template <int D>
std::string trade_off_command(const Workbench<D>& bench, const TradeOffDot& dot) {
    return "trade-off " + bench.trade_off.study.task().variants[dot.variant].text + " " + budget_text(dot.budget);
}

template <int D>
std::vector<VariantLook> trade_off_looks(const Workbench<D>& bench) {
    const std::vector<Variant<D>>& variants = bench.trade_off.study.task().variants;
    std::vector<std::string> texts;
    for (const Variant<D>& variant : variants) texts.push_back(variant.text);
    std::vector<VariantLook> looks = variant_looks(texts);
    const bool tree = bench.session.settings().tessellation != Tessellation::delaunay;
    for (std::size_t i = 0; i < looks.size(); ++i) looks[i].filled = !(tree && variants[i].method.orders_cells());
    return looks;
}

template <int D>
Variant<D> current_variant(const Workbench<D>& bench) {
    return variant_of(bench.session.method(), bench.session.settings().parameters, bench.trade_off.base);
}

template <int D>
bool is_current(const Workbench<D>& bench, const TradeOffDot& dot) {
    return bench.trade_off.study.task().variants[dot.variant].text == current_variant(bench).text &&
           dot.budget == bench.session.settings().budget;
}

template <int D>
std::vector<std::size_t> pareto_dots(const Workbench<D>& bench) {
    const TradeOff<D>& trade_off = bench.trade_off;
    std::vector<Trade> trades;
    for (const TradeOffDot& dot : trade_off.study.dots())
        trades.push_back({trade_off.study.value(dot, Measure::total_ms), trade_off.study.value(dot, trade_off.shown)});
    return pareto_points(trades, measure_row(trade_off.shown).better);
}

#define SIGHTLINE_INSTANTIATE(D)                                                            \
    template bool stands_still<D>(const Workbench<D>&);                                     \
    template void update_trade_off<D>(Workbench<D>&);                                       \
    template void restart_trade_off<D>(Workbench<D>&);                                      \
    template bool advance_trade_off<D>(Workbench<D>&, double);                              \
    template std::string trade_off_progress_text<D>(const Workbench<D>&);                   \
    template std::string trade_off_work_text<D>(const Workbench<D>&);                       \
    template std::string trade_off_time_text<D>(const Workbench<D>&);                       \
    template std::string trade_off_command<D>(const Workbench<D>&, const TradeOffDot& dot); \
    template std::vector<VariantLook> trade_off_looks<D>(const Workbench<D>&);              \
    template Variant<D> current_variant<D>(const Workbench<D>&);                            \
    template bool is_current<D>(const Workbench<D>&, const TradeOffDot& dot);               \
    template std::vector<std::size_t> pareto_dots<D>(const Workbench<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
