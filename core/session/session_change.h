// Part of session.cpp: what changes a session (settings, views, scene, the lane of frames), and flying.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/run/drive.h"
#include "core/session/session.h"

namespace sightline {

template <int D>
void Session<D>::check(const CellNumber& number) const {
    if (number.kind != CellNumber::field) return;
    std::vector<std::string_view> known(cell_number_words.begin(), cell_number_words.end());
    for (const Field<D>& field : run_->fields()) {
        if (field.name == number.name) return;
        if (std::find(known.begin(), known.end(), field.name) == known.end()) known.push_back(field.name);
    }
    throw unknown_word("number", number.name, known);
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
    const bool another_image = what == Invalidates::reference && method_.needs.image;
    if (what >= Invalidates::traversal || another_view || another_image) {
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
    // A field that was shown stays when another method does not have it; a new one must be there.
    try {
        if (settings_.heat != before.heat) check(settings_.heat);
        if (settings_.label != before.label) check(settings_.label);
    } catch (const InputError&) {
        settings_.heat = before.heat;
        settings_.label = before.label;
        throw;
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
    if (method_.needs.keeps_lane() && run_->finished()) {
        lane_.push_back(culling_view_);
        history_ = run_->next_history();
    }
    const Stopwatch flight;
    aim(view);
    restart();
    flying_ = true;
    const Stop stop = drive(settings_.budget, *run_, frame_cost_, flight);
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
    if (method_.needs.keeps_lane()) {
        const ViewSpec<D> here = culling_view_;
        for (const ViewSpec<D>& view : lane_) {
            aim(view);
            restart();
            drive(settings_.budget, *run_, frame_cost_);
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
    objects_.reset();
    start_again(step);
}

template <int D>
void Session<D>::freeze(Frozen part) {
    land();
    if (!frozen()) display_view_ = culling_view_;
    frozen_ = part;
}

}  // namespace sightline
