// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/stopwatch.h"
#include "core/measure/first_wrong.h"
#include "core/scene/scene_view.h"
#include "core/space/builders.h"

namespace sightline {

namespace {

/// Adds the time that `work` takes to `milliseconds`.
template <typename Work>
auto timed(double& milliseconds, Work work) {
    struct Clock {
        double& sum;
        Stopwatch stopwatch;
        ~Clock() { sum += stopwatch.milliseconds(); }
    } clock{milliseconds, {}};
    return work();
}

Reference make_reference(const Scene<2>& scene, const CellComplex<2>& cells, const View<2>& view, const Settings&,
                         const DrawIds&) {
    return exact_reference(scene.primitives, cells, view);
}

Reference make_reference(const Scene<3>& scene, const CellComplex<3>& cells, const View<3>& view,
                         const Settings& settings, const DrawIds& draw_ids) {
    if (!draw_ids) throw WorkError("the exact image cannot be drawn: there is no OpenGL");
    auto images = draw_ids(scene, view, image_size<3>(settings.reference_size), 1);
    return image_reference(std::move(images.front()), scene, cells, view);
}

std::vector<std::uint32_t> make_layering(const Scene<2>& scene, const View<2>& view, const Settings&, const DrawIds&) {
    return layering_numbers(scene.primitives, view);
}

std::vector<std::uint32_t> make_layering(const Scene<3>& scene, const View<3>& view, const Settings& settings,
                                         const DrawIds& draw_ids) {
    if (!draw_ids) throw WorkError("layering numbers cannot be drawn: there is no OpenGL");
    return layering_numbers(draw_ids(scene, view, image_size<3>(settings.reference_size), most_layers),
                            scene.primitives.size());
}

}  // namespace

template <int D>
Session<D>::Session(std::shared_ptr<const Scene<D>> scene, const ViewSpec<D>& view, const Settings& settings,
                    std::span<const Method<D>> methods, DrawIds draw_ids, const Progress& progress,
                    std::shared_ptr<const CellComplex<D>> cells)
    : scene_(std::move(scene)),
      cells_(std::move(cells)),
      methods_(methods),
      method_(find_method<D>(methods, settings.method)),
      settings_(settings),
      draw_ids_(std::move(draw_ids)),
      culling_view_(view),
      display_view_(view),
      view_(scene_view(view, *scene_, settings.reference_size)) {
    if (!cells_) tessellate(progress);
    restart();
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
    reference_.reset();
    layering_.reset();
}

template <int D>
void Session<D>::restart() {
    flying_ = false;
    frame_ = make_frame<D>(scene_->primitives, *cells_, view_, settings_, scene_->two_sided);
    method_.start(frame_, state_);
    timeline_ = {};
    timeline_.seed_count = state_.front_size;
    time_stop_ = none;
    times_.traverse = 0;
}

template <int D>
Stop Session<D>::step() {
    land();
    if (state_.step >= time_stop_) return Stop::budget;
    if (state_.step < timeline_.steps.size()) {
        redo_step(frame_, state_, timeline_);
        return Stop::none;
    }
    return timed(times_.traverse, [&] { return method_.record(frame_, state_, timeline_); });
}

template <int D>
bool Session<D>::finished() const {
    if (state_.step >= time_stop_) return true;
    if (!flying_ && state_.step < recorded()) return false;
    if (state_.spent >= frame_.budget) return true;
    return method_.orders_cells ? state_.front_size == 0 && state_.partial_cell == none
                                : state_.offset >= state_.order.size();
}

template <int D>
bool Session<D>::back() {
    land();
    if (state_.step == 0) return false;
    undo_step(frame_, state_, timeline_);
    return true;
}

template <int D>
template <typename Holds>
Stop Session<D>::advance(std::uint32_t steps, Holds holds) {
    const bool limited_by_time = settings_.budget.kind == Budget::Kind::milliseconds && time_stop_ == none;
    const Stopwatch running;
    for (std::uint32_t made = 0; made < steps; ++made) {
        if (const Stop stop = step(); stop != Stop::none) return stop;
        if (limited_by_time && running.milliseconds() >= settings_.budget.value) time_stop_ = state_.step;
        if (holds(*this)) return Stop::breakpoint;
    }
    return Stop::steps;
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
    while (state_.step > step) undo_step(frame_, state_, timeline_);
    while (state_.step < std::min<std::size_t>({step, timeline_.steps.size(), time_stop_}))
        redo_step(frame_, state_, timeline_);
    while (state_.step < step)
        if (const Stop stop = this->step(); stop != Stop::none) return stop;
    return Stop::steps;
}

template <int D>
Invalidates Session<D>::change(const Settings& settings) {
    const Invalidates what = difference(settings_, settings);
    const Method<D>& method = find_method<D>(methods_, settings.method);
    const View<D> view = scene_view(culling_view_, *scene_, settings.reference_size);
    land();
    const std::uint32_t step = state_.step;
    const Settings before = std::exchange(settings_, settings);
    if (what >= Invalidates::tessellation) {
        try {
            tessellate();
        } catch (...) {  // too many cells, say: everything stays
            settings_ = before;
            throw;
        }
        forget_measures();
    }
    method_ = method;
    if (what == Invalidates::reference) forget_measures();
    const bool another_view = view.corners != view_.corners;  // the reference's size is the view's aspect
    view_ = view;
    if (what >= Invalidates::traversal || another_view) {
        restart();
        seek(step);
    }
    return what;
}

/// Makes this the culling view; throws where it cannot be one, then nothing has changed.
template <int D>
void Session<D>::aim(const ViewSpec<D>& view) {
    view_ = scene_view(view, *scene_, settings_.reference_size);
    culling_view_ = view;
    forget_measures();
}

template <int D>
void Session<D>::check(const ViewSpec<D>& view) const {
    scene_view(view, *scene_, settings_.reference_size);
}

template <int D>
void Session<D>::set_culling_view(const ViewSpec<D>& view) {
    land();
    const std::uint32_t step = state_.step;
    aim(view);
    restart();
    seek(step);
}

template <int D>
void Session<D>::set_view(const ViewSpec<D>& view) {
    if (!frozen()) return set_culling_view(view);
    check(view);
    display_view_ = view;
    const Vec<D> direction = culling_view_.look_at - culling_view_.eye;
    if (frozen_ == Frozen::eye)
        set_culling_view({culling_view_.eye, culling_view_.eye + (view.look_at - view.eye), view.fov});
    else if (frozen_ == Frozen::direction)
        set_culling_view({view.eye, view.eye + direction, culling_view_.fov});
}

template <int D>
Stop Session<D>::fly(const ViewSpec<D>& view) {
    aim(view);
    restart();
    flying_ = true;
    const Stopwatch flight;
    Stop stop = Stop::none;
    if (settings_.budget.kind == Budget::Kind::milliseconds) {
        while ((stop = method_.run(frame_, state_, 1)) == Stop::steps)
            if (flight.milliseconds() >= settings_.budget.value) break;
        if (stop == Stop::steps) {
            time_stop_ = state_.step;
            stop = Stop::budget;
        }
    } else {
        stop = method_.run(frame_, state_, none);
    }
    times_.traverse = flight.milliseconds();
    return stop;
}

template <int D>
void Session<D>::land() {
    if (!flying_) return;
    const std::uint32_t step = state_.step, time_stop = time_stop_;
    restart();
    time_stop_ = time_stop;
    seek(step);
}

template <int D>
void Session<D>::set_scene(std::shared_ptr<const Scene<D>> scene) {
    land();
    const std::uint32_t step = state_.step;
    std::swap(scene_, scene);
    try {
        tessellate();
    } catch (...) {
        std::swap(scene_, scene);
        throw;
    }
    forget_measures();
    restart();
    seek(step);
}

template <int D>
void Session<D>::freeze(Frozen part) {
    land();
    if (!frozen()) display_view_ = culling_view_;
    frozen_ = part;
}

template <int D>
const Reference& Session<D>::reference() const {
    if (!reference_)
        reference_ = timed(times_.reference, [&] {
            return std::make_shared<const Reference>(make_reference(*scene_, *cells_, view_, settings_, draw_ids_));
        });
    return *reference_;
}

template <int D>
const std::vector<std::uint32_t>& Session<D>::layering() const {
    if (!layering_)
        layering_ =
            std::make_shared<const std::vector<std::uint32_t>>(make_layering(*scene_, view_, settings_, draw_ids_));
    return *layering_;
}

template <int D>
std::size_t Session<D>::visible_rendered() const {
    return sightline::visible_rendered<D>(reference(), std::span(state_.touched).first(state_.touched_count));
}

template <int D>
std::vector<Inversion> Session<D>::inversions() const {
    return sightline::inversions(reference(), frame_, state_, timeline_);
}

template <int D>
std::vector<HalfFacet> Session<D>::penalised_facets(std::uint32_t step) const {
    std::vector<HalfFacet> found;
    const std::uint32_t cell = timeline_.steps[step - 1].cell;
    if (cell == none) return found;
    const auto records = timeline_.facets_of(step);
    const auto facets = cells_->facets_of(cell);
    for (std::size_t i = 0; i < records.size(); ++i)
        if ((records[i].rule == Rule::enqueued || records[i].rule == Rule::reenqueued) &&
            method_.terms(frame_, cell, state_.mark(cell).key, facets[i]).penalised())
            found.push_back(facets[i]);
    return found;
}

template <int D>
std::vector<Marker> Session<D>::markers() const {
    std::vector<Marker> markers;
    if (method_.terms) {
        // The keys of cells projected later are known where all is done.
        const Session end = copy_at(*this, recorded());
        for (std::uint32_t step = 1; step <= end.position(); ++step)
            if (const std::size_t penalised = end.penalised_facets(step).size(); penalised > 0)
                markers.push_back({step, Marker::Kind::penalty, std::to_string(penalised) + " penalised"});
    }
    for (const Inversion& inversion : inversions())
        markers.push_back(
            {inversion.step,
             inversion.kind == Inversion::Kind::mis_ranked ? Marker::Kind::mis_ranked : Marker::Kind::unreached,
             std::to_string(inversion.wasted) + " wasted"});
    if (const auto lost = first_wrong<D>(reference(), state_.touched, timeline_, frame_.budget))
        markers.push_back({lost->step, Marker::Kind::first_wrong,
                           std::to_string(lost->missing) + " visible still missing, budget for " +
                               std::to_string(lost->left) + " left"});
    for (const double share : {0.01, 0.02, 0.05, 0.10}) {
        const std::uint32_t wanted = Budget{Budget::Kind::share, share}.primitives(scene_->primitives.size());
        const auto reached = std::find_if(timeline_.steps.begin(), timeline_.steps.end(),
                                          [&](const StepRecord& record) { return record.spent >= wanted; });
        if (reached != timeline_.steps.end())
            markers.push_back({static_cast<std::uint32_t>(reached - timeline_.steps.begin()) + 1, Marker::Kind::budget,
                               short_number(share * 100) + " %"});
    }
    std::stable_sort(markers.begin(), markers.end(), [](const Marker& a, const Marker& b) { return a.step < b.step; });
    return markers;
}

template class Session<2>;
template class Session<3>;

}  // namespace sightline
