// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/work_out.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/methods/by_viewpoint/viewpoint_run.h"
#include "shell/desk/change.h"

namespace sightline {

namespace {

/// Of progress, where no window waits.
constexpr double between_words_ms = 250;

template <int D>
const ViewpointRun<D>* viewpoint_run(const Session<D>& session) {
    return dynamic_cast<const ViewpointRun<D>*>(&session.traversal());
}

std::string known_text(std::size_t known, std::size_t entries) {
    return known == entries ? "all " + counted(entries, "entry") + " of the table are known"
                            : std::to_string(known) + " of " + counted(entries, "entry") + " of the table are known";
}

/// Of the entry: "box 12, azimuth −22.5° to 22.5°: hom".
template <int D>
std::string entry_text(const ViewpointTable<D>& table, std::size_t place) {
    return table.regions().words(table.region_of(place)) + ", " + table.directions().words(table.interval_of(place)) +
           ": " + table.problem().options[table.find(place)->chosen].text;
}

/// Of the views that the entry looks at, the first that a look-up finds in it: a box may be full of rooms.
template <int D>
std::optional<ViewSpec<D>> view_in(const ViewpointTable<D>& table, std::size_t place, ViewSpec<D> view) {
    for (const ViewSpec<D>& sample :
         Analyst<D>(table.problem()).views(table.region_of(place), table.interval_of(place))) {
        view.eye = sample.eye;
        view.look_at = sample.look_at;
        if (table.place(view.eye, view.look_at - view.eye) == place) return view;
    }
    return std::nullopt;
}

/// The one that is being worked out, where the session still has it.
template <int D>
bool is_at_work(const Workbench<D>& bench) {
    const ViewpointRun<D>* const run = viewpoint_run(bench.session);
    return bench.work_out && run && run->shared_table() == bench.work_out->table;
}

template <int D>
void end_work_out(Workbench<D>& bench) {
    const WorkOut<D> work = *std::exchange(bench.work_out, std::nullopt);
    bench.say("worked out " + counted(work.table->known({work.first, work.end}) - work.known_before, "entry") + "; " +
              known_text(work.table->known(), work.table->size()));
}

}  // namespace

template <int D>
std::shared_ptr<const ViewpointTable<D>> table_on(const Workbench<D>& bench) {
    const ViewpointRun<D>* const run = viewpoint_run(bench.session);
    if (!run)
        throw InputError("method '" + std::string(bench.session.method().id) +
                         "' chooses nothing by viewpoint: `method by-viewpoint` does");
    return run->shared_table();
}

template <int D>
void begin_work_out(Workbench<D>& bench, bool all) {
    const auto table = table_on(bench);
    const ViewpointRun<D>& run = *viewpoint_run(bench.session);
    const auto range = all ? table->all() : table->of_region(table->region_of(run.place()));
    bench.work_out = WorkOut<D>{table, range.first, range.end, table->known(range)};
    if (!bench.attended)
        while (bench.work_out) {
            advance_work_out(bench, between_words_ms);
            report(bench.graphics.progress, "working out entries",
                   static_cast<double>(table->known(range)) / static_cast<double>(range.end - range.first));
        }
    else if (table->known(range) == range.end - range.first)
        end_work_out(bench);
    else
        bench.say("working out " + counted(range.end - range.first - table->known(range), "entry") + "; Esc stops");
}

template <int D>
bool advance_work_out(Workbench<D>& bench, double milliseconds) {
    if (!bench.work_out) return false;
    if (!is_at_work(bench)) {
        bench.work_out.reset();
        return false;
    }
    const std::shared_ptr<const ViewpointTable<D>> table = bench.work_out->table;
    const typename ViewpointTable<D>::Range range{bench.work_out->first, bench.work_out->end};
    const std::size_t before = table->known(), unknown = range.end - range.first - table->known(range);
    const Stopwatch stopwatch;
    table->fill(
        0, [&](std::size_t) { return stopwatch.milliseconds() < milliseconds; }, range);
    if (table->known() - before >= unknown) end_work_out(bench);
    return table->known() > before;
}

template <int D>
void stop_work_out(Workbench<D>& bench) {
    if (bench.work_out) end_work_out(bench);
}

template <int D>
std::string work_out_text(const Workbench<D>& bench) {
    if (!is_at_work(bench)) return "";
    const WorkOut<D>& work = *bench.work_out;
    return std::to_string(work.table->known({work.first, work.end})) + " of " + counted(work.end - work.first, "entry");
}

template <int D>
void go_to_next_entry(Workbench<D>& bench) {
    const auto table = table_on(bench);
    const std::size_t here = viewpoint_run(bench.session)->place();
    std::size_t place = here;
    do place = (place + 1) % table->size();
    while (place != here && table->find(place));
    if (place == here) return bench.say(known_text(table->known(), table->size()));
    table->at(place);
    const auto view = view_in(*table, place, bench.session.culling_view());
    if (view) change_culling_view(bench, *view);
    bench.say(entry_text(*table, place) + "; " + known_text(table->known(), table->size()) +
              (view ? "" : ". No eye of it can be shown: rooms fill the box"));
}

#define SIGHTLINE_INSTANTIATE(D)                                                              \
    template std::shared_ptr<const ViewpointTable<D>> table_on<D>(const Workbench<D>& bench); \
    template void begin_work_out<D>(Workbench<D>&, bool);                                     \
    template bool advance_work_out<D>(Workbench<D>&, double);                                 \
    template void stop_work_out<D>(Workbench<D>&);                                            \
    template std::string work_out_text<D>(const Workbench<D>&);                               \
    template void go_to_next_entry<D>(Workbench<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
