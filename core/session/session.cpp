// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/stopwatch.h"
#include "core/measure/first_wrong.h"
#include "core/methods/cells/cell_rules.h"
#include "core/run/drive.h"
#include "core/space/builders.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"

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

/// Whether the step gave a key that carries a penalty.
bool gives_penalty(const Change& change) {
    return change.penalty && (Rule{change.rule} == Rule::enqueued || Rule{change.rule} == Rule::reenqueued);
}

}  // namespace

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
    Problem<D> problem{scene_.get(),
                       cells_.get(),
                       view_,
                       settings_.budget.primitives(scene_->primitives.size()),
                       settings_.parameters,
                       method_.needs.history ? history_ : nullptr};
    if (method_.needs.visible_set) {
        reference();
        const std::shared_ptr<const std::vector<std::uint8_t>> visible(reference_, &reference_->visible);
        problem.services.visible_set = [visible] { return visible; };
    }
    run_.start(problem, method_.start);
    flying_ = false;
    timeline_.begin(*run_);
    inversions_.reset();
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
    const Stop stop = drive(
        time_stop_ == none ? settings_.budget : Budget{}, steps, [&] { return step(); }, [&] { return holds(*this); });
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

template <int D>
Invalidates Session<D>::change(const Settings& settings) {
    Settings wanted = settings;
    Method<D> method;
    resolve_method(wanted, method);
    const Invalidates what = difference(settings_, wanted);
    const View<D> view = scene_view(culling_view_, *scene_, settings.reference_size);
    land();
    const std::uint32_t step = run_->steps();
    const Settings before = std::exchange(settings_, wanted);
    if (what >= Invalidates::tessellation) {
        try {
            tessellate();
        } catch (...) {  // too many cells, say: everything stays
            settings_ = before;
            throw;
        }
        forget_measures();
    }
    if (method.id != method_.id) run_ = {};
    std::swap(method_, method);
    if (what == Invalidates::reference) forget_measures();
    const bool another_view = view.corners != view_.corners;  // the reference's size is the view's aspect
    view_ = view;
    if (what >= Invalidates::traversal || another_view) {
        try {
            start_again(step);
        } catch (...) {  // the method cannot run here
            settings_.method = before.method;
            settings_.parameters = before.parameters;
            std::swap(method_, method);
            run_ = {};
            start_again(step);
            throw;
        }
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
    const std::uint32_t step = run_->steps();
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
    if (method_.needs.history && run_->finished()) {
        lane_.push_back(culling_view_);
        history_ = run_->next_history();
    }
    aim(view);
    restart();
    flying_ = true;
    const Stopwatch flight;
    const Stop stop = drive(settings_.budget, *run_);
    if (stop == Stop::budget && settings_.budget.kind == Budget::Kind::milliseconds) time_stop_ = run_->steps();
    times_.traverse = flight.milliseconds();
    return stop;
}

template <int D>
void Session<D>::land() {
    if (!flying_) return;
    const std::uint32_t step = run_->steps(), time_stop = time_stop_;
    restart();
    time_stop_ = time_stop;
    seek(step);
}

template <int D>
void Session<D>::set_lane(std::vector<ViewSpec<D>> lane) {
    land();
    const std::uint32_t step = run_->steps();
    lane_ = std::move(lane);
    start_again(step);
}

/// Another run, at the same step as far as it has one; what the frame depends on is run before.
template <int D>
void Session<D>::start_again(std::uint32_t step) {
    history_ = nullptr;
    if (method_.needs.history) {
        const ViewSpec<D> here = culling_view_;
        for (const ViewSpec<D>& view : lane_) {
            aim(view);
            restart();
            drive(settings_.budget, *run_);
            history_ = run_->next_history();
        }
        if (!lane_.empty()) aim(here);
    }
    restart();
    seek(step);
}

template <int D>
void Session<D>::step_into(std::size_t frame) {
    std::vector<ViewSpec<D>> before = lane_;
    const ViewSpec<D> view = before.at(frame);
    before.resize(frame);
    set_lane(std::move(before));
    set_culling_view(view);
    run();
}

template <int D>
void Session<D>::set_scene(std::shared_ptr<const Scene<D>> scene) {
    land();
    const std::uint32_t step = run_->steps();
    std::swap(scene_, scene);
    try {
        tessellate();
    } catch (...) {
        std::swap(scene_, scene);
        throw;
    }
    forget_measures();
    start_again(step);
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
            return std::make_shared<const Reference>(make_reference(*scene_, *cells_, view_, settings_.reference_size,
                                                                    drawing_of(settings_.reference, draw_ids_)));
        });
    return *reference_;
}

template <int D>
const std::vector<std::uint32_t>& Session<D>::layering() const {
    if (!layering_)
        layering_ = std::make_shared<const std::vector<std::uint32_t>>(
            make_layering(*scene_, view_, settings_.reference_size, drawing_of(settings_.reference, draw_ids_)));
    return *layering_;
}

template <int D>
std::size_t Session<D>::visible_rendered() const {
    return sightline::visible_rendered(reference(), met());
}

template <int D>
const Inversions& Session<D>::followed_inversions() const {
    if (!inversions_) inversions_.emplace(reference().cell_share, reference().visible, run_->seeds());
    const auto count = [&](std::uint32_t cell) { return cells_->count(cell); };
    if (inversions_->followed() == recorded()) return *inversions_;
    // What undone steps met is known to a run that undoes by marks; another has to be where they are done.
    if (run_->undoes_by_marks() || run_->steps() == recorded())
        inversions_->follow(timeline_, run_->drawn().all(), count);
    else
        inversions_->follow(timeline_, copy_at(*this, recorded()).met(), count);
    return *inversions_;
}

template <int D>
std::vector<Inversion> Session<D>::inversions() const {
    std::vector<Inversion> found = followed_inversions().found();
    std::stable_sort(found.begin(), found.end(),
                     [](const Inversion& a, const Inversion& b) { return a.wasted > b.wasted; });
    return found;
}

template <int D>
std::optional<Inversion> Session<D>::inversion_at(std::uint32_t step) const {
    const Inversion* const found = followed_inversions().at(step);
    return found ? std::optional(*found) : std::nullopt;
}

template <int D>
std::vector<HalfFacet> Session<D>::penalised_facets(std::uint32_t step) const {
    std::vector<HalfFacet> found;
    const std::uint32_t cell = id_of(timeline_.steps[step - 1].item, Kind::cell);
    if (cell == none) return found;
    for (const Change& change : timeline_.changes_of(step))
        if (gives_penalty(change))
            for (const HalfFacet& half : cells_->facets_of(cell))
                if (half.facet() == change.via) found.push_back(half);
    return found;
}

template <int D>
std::vector<Marker> Session<D>::markers() const {
    std::vector<Marker> markers;
    for (std::uint32_t step = 1; step <= recorded(); ++step) {
        const auto changes = timeline_.changes_of(step);
        if (const auto penalised = std::count_if(changes.begin(), changes.end(), gives_penalty); penalised > 0)
            markers.push_back({step, Marker::Kind::penalty, std::to_string(penalised) + " penalised"});
    }
    for (const Inversion& inversion : inversions())
        markers.push_back(
            {inversion.step,
             inversion.kind == Inversion::Kind::mis_ranked ? Marker::Kind::mis_ranked : Marker::Kind::unreached,
             std::to_string(inversion.wasted) + " wasted"});
    if (const auto lost = first_wrong(reference(), run_->drawn().all(), timeline_, problem().budget))
        markers.push_back({lost->step, Marker::Kind::first_wrong,
                           std::to_string(lost->missing) + " visible still missing, budget for " +
                               std::to_string(lost->left) + " left"});
    for (const double share : {0.01, 0.02, 0.05, 0.10}) {
        const std::uint32_t wanted = Budget{Budget::Kind::share, share}.primitives(scene_->primitives.size());
        const auto reached = std::find_if(timeline_.steps.begin(), timeline_.steps.end(),
                                          [&](const Step& step) { return step.after.spent >= wanted; });
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
