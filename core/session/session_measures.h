// Part of session.cpp: what is measured of a session, made when it is first asked for, and the marks of its timeline.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/base/number.h"
#include "core/measure/drawn_image.h"
#include "core/measure/first_wrong.h"
#include "core/methods/cells/cell_rules.h"
#include "core/session/session.h"
#include "core/session/timed.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"

namespace sightline {

/// Whether the step gave a key that carries a penalty.
inline bool gives_penalty(const Change& change) {
    return change.penalty && (Rule{change.rule} == Rule::enqueued || Rule{change.rule} == Rule::reenqueued);
}

template <int D>
const Objects& Session<D>::objects() const {
    if (!objects_) objects_ = std::make_shared<const Objects>(all_objects(*scene_));
    return *objects_;
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
    return visible_found(reference(), *run_);
}

template <int D>
const std::vector<std::uint8_t>& Session<D>::wrong_mask() const {
    if (wrong_.step != run_->steps() || wrong_.counters != counters())
        wrong_ = {run_->steps(), counters(),
                  sightline::wrong_mask(reference(), *run_, drawing_of(settings_.reference, draw_ids_))};
    return wrong_.mask;
}

template <int D>
double Session<D>::wrong_pixels() const {
    if (run_->stand_ins().empty()) return sightline::wrong_pixels(reference(), met());
    const std::vector<std::uint8_t>& mask = wrong_mask();
    if (mask.empty()) return 0;
    return static_cast<double>(std::count(mask.begin(), mask.end(), 1)) / static_cast<double>(mask.size());
}

template <int D>
const Inversions& Session<D>::followed_inversions() const {
    if (!inversions_) inversions_.emplace(reference().cell_share, reference().visible, run_->seeds());
    const auto count = [&](std::uint32_t cell) { return cells_->count(cell); };
    if (inversions_->followed() == recorded()) return *inversions_;
    inversions_->follow(timeline_, run_->drawn().all(), count);
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
    // A method that goes on beyond its budget has lost nothing there.
    const std::uint32_t budget = method_.prefixes ? problem().budget : none;
    if (const auto lost = first_wrong(reference(), run_->drawn().all(), timeline_, budget))
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

}  // namespace sightline
