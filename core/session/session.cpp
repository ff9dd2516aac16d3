// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"

#include <algorithm>
#include <utility>

#include "core/run/drive.h"
#include "core/session/session_change.h"
#include "core/session/session_measures.h"
#include "core/session/timed.h"
#include "core/space/builders.h"
#include "core/truth/truth.h"

namespace sightline {

template <int D>
Session<D>::Session(std::shared_ptr<const Scene<D>> scene, const ViewSpec<D>& view, const Settings& settings,
                    std::span<const Method<D>> methods, DrawIds draw_ids, const Progress& progress,
                    std::shared_ptr<const CellComplex<D>> cells)
    : scene_(std::move(scene)),
      cells_(std::move(cells)),
      methods_(methods),
      settings_(settings),
      draw_ids_(std::move(draw_ids)),
      culling_view_(view),
      display_view_(view),
      view_(scene_view(view, *scene_, settings.reference_size)) {
    resolve_method(settings_, method_);
    if (!cells_) tessellate(progress);
    restart();
    for (const CellNumber& number : {settings_.heat, settings_.label}) check(number);
}

template <int D>
void Session<D>::tessellate(const Progress& progress) {
    report(progress, "making the cells", 0);
    CellComplex<D> cells = timed(times_.tessellate, [&] { return tessellation(*scene_, settings_); });
    timed(times_.assign, [&] { assign_primitives(cells, scene_->primitives, progress); });
    report(progress, "assigning to cells", 1);
    cells_ = std::make_shared<const CellComplex<D>>(std::move(cells));
    drop_dangling();
}

/// Forgets what refers to cells or primitives that are no more.
template <int D>
void Session<D>::drop_dangling() {
    const auto cells = cells_->cell_count();
    const auto primitives = scene_->primitives.size();
    if (selected_cell != none && selected_cell >= cells) selected_cell = none;
    if (selected_primitive != none && selected_primitive >= primitives) selected_primitive = none;
    std::erase_if(notes, [&](const Note<D>& note) {
        return (note.anchor == Note<D>::Anchor::cell && note.index >= cells) ||
               (note.anchor == Note<D>::Anchor::primitive && note.index >= primitives);
    });
}

template <int D>
void Session<D>::forget_measures() {
    inversions_.reset();
    reference_.reset();
    layering_.reset();
    wrong_ = {};
}

/// Finds the method; the assignments of a variant go to the parameters.
template <int D>
void Session<D>::resolve_method(Settings& settings, Method<D>& method) const {
    Parameters parameters = settings.parameters;
    method = find_variant<D>(methods_, read_variant(settings.method), parameters);
    settings.method = method.id;
    settings.parameters = std::move(parameters);
}

template <int D>
void Session<D>::restart() {
    if (method_.needs.visible_set) reference();
    const Services services = reference_ ? known_services({reference_, &reference_->visible}, settings_.reference_size)
                                         : Services{{}, settings_.reference_size};
    const Problem<D> problem = make_problem(method_, settings_.parameters, *scene_, *cells_, view_,
                                            settings_.budget.primitives(scene_->primitives.size()), services, history_);
    const BoxTree<D>* const tree = run_ ? run_->boxes() : nullptr;
    run_.start(problem, method_.start);
    if (run_->boxes() != tree) selected_node = selected_plane = none;  // numbers of another tree
    flying_ = false;
    timeline_.begin(*run_);
    inversions_.reset();
    wrong_ = {};
    time_stop_ = none;
    times_.traverse = 0;
}

template <int D>
Stop Session<D>::step() {
    land();
    if (run_->steps() >= time_stop_) return Stop::budget;
    if (run_->steps() < recorded()) return timeline_.forward(run_);
    return timed(times_.traverse, [&] { return timeline_.forward(run_); });
}

template <int D>
bool Session<D>::finished() const {
    if (run_->steps() >= time_stop_) return true;
    if (!flying_ && run_->steps() < recorded()) return false;
    return run_->finished();
}

template <int D>
bool Session<D>::back() {
    land();
    return timeline_.back(run_);
}

template <int D>
template <typename Holds>
Stop Session<D>::advance(std::uint32_t steps, Holds holds) {
    // A budget in milliseconds ends a run once; from then on the step at which it did is the end.
    const Stopwatch running;
    const Stop stop = drive(
        time_stop_ == none ? settings_.budget : Budget{}, frame_cost_, steps, [&] { return step(); },
        [&] { return holds(*this); }, [&] { return run_->counters().drawn(); }, [&] { return running.milliseconds(); });
    if (stop == Stop::budget && time_stop_ == none && settings_.budget.kind == Budget::Kind::milliseconds)
        time_stop_ = run_->steps();
    return stop;
}

template <int D>
Stop Session<D>::run(std::uint32_t steps) {
    return advance(steps, [](const Session&) { return false; });
}

template <int D>
Stop Session<D>::run_until(const std::function<bool(const Session&)>& holds) {
    return advance(none, holds);
}

template <int D>
Stop Session<D>::seek(std::uint32_t step) {
    land();
    timeline_.seek(run_, std::min({step, recorded(), std::max(time_stop_, run_->steps())}));
    while (run_->steps() < step)
        if (const Stop stop = this->step(); stop != Stop::none) return stop;
    return Stop::steps;
}

template class Session<2>;
template class Session<3>;

}  // namespace sightline
