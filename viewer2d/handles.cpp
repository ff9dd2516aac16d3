// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sightline {

namespace {

/// From the eye on the screen.
constexpr double look_distance = 60, opening_distance = 84;
constexpr double degrees = 180 / std::numbers::pi;
/// A cone opened beyond this looks all round; narrower than this it is hard to take hold of.
constexpr double all_round_from = 250, narrowest = 4, widest = 179;
/// Where the openings of an all-round view stand.
constexpr double all_round_half = 150;

void add_view(const ViewSpec<2>& view, const Camera& camera, float unit, bool frozen, bool edit,
              std::vector<HandlePoint>& all) {
    const ImVec2 eye = camera.to_window(view.eye);
    const Vec<2> d = glm::normalize(view.look_at - view.eye);
    const auto at = [&](double angle, double distance) {
        const Vec<2> turned(d.x * std::cos(angle) - d.y * std::sin(angle),
                            d.x * std::sin(angle) + d.y * std::cos(angle));
        return ImVec2(eye.x + static_cast<float>(turned.x * distance) * unit,
                      eye.y - static_cast<float>(turned.y * distance) * unit);
    };
    const double half = (view.fov >= 180 ? all_round_half : view.fov / 2) / degrees;
    all.push_back({frozen ? Handle::frozen_eye : Handle::eye, eye});
    if (!edit) return;
    all.push_back({frozen ? Handle::frozen_look : Handle::look, at(0, look_distance)});
    all.push_back({frozen ? Handle::frozen_opening : Handle::opening, at(half, opening_distance)});
    all.push_back({frozen ? Handle::frozen_opening : Handle::opening, at(-half, opening_distance)});
}

}  // namespace

std::vector<HandlePoint> handle_points(const Session<2>& session, const Camera& camera, float unit,
                                       const EditMode& edit) {
    std::vector<HandlePoint> all;
    if (session.settings().show_view == Switch::on) {
        add_view(session.display_view(), camera, unit, false, edit.on, all);
        if (session.frozen() && session.culling_view() != session.display_view())
            add_view(session.culling_view(), camera, unit, true, edit.on, all);
    }
    if (!edit.on) return all;
    const auto add_ends = [&](std::uint32_t segment) {
        const Primitive<2>& s = session.scene().primitives[segment];
        all.push_back({Handle::segment_start, camera.to_window(s[0]), segment});
        all.push_back({Handle::segment_end, camera.to_window(s[1]), segment});
    };
    const std::uint32_t selected = session.selected_primitive;
    if (selected != none) add_ends(selected);
    if (edit.hovered != none && edit.hovered != selected) add_ends(edit.hovered);
    return all;
}

ViewSpec<2> dragged_view(const ViewSpec<2>& view, Handle handle, const Vec<2>& from, const Vec<2>& to) {
    ViewSpec<2> moved = view;
    const Vec<2> d = to - view.eye;
    switch (handle) {
        case Handle::eye:
        case Handle::frozen_eye:
            moved.eye += to - from;
            moved.look_at += to - from;
            return moved;
        case Handle::look:
        case Handle::frozen_look: {
            // Only the direction turns: the point keeps its distance.
            const double length = glm::length(d);
            if (length > 0) moved.look_at = view.eye + d * (glm::length(view.look_at - view.eye) / length);
            return moved;
        }
        case Handle::opening:
        case Handle::frozen_opening: {
            const Vec<2> forward = view.look_at - view.eye;
            const double half = std::abs(std::atan2(cross(forward, d), glm::dot(forward, d))) * degrees;
            if (d == Vec<2>(0)) return view;
            moved.fov = 2 * half > all_round_from ? 360 : std::clamp(std::round(2 * half), narrowest, widest);
            return moved;
        }
        default:
            return view;
    }
}

const char* handle_name(Handle handle) {
    switch (handle) {
        case Handle::eye:
            return "handle eye";
        case Handle::look:
            return "handle look";
        case Handle::opening:
            return "handle opening";
        case Handle::frozen_eye:
            return "handle frozen eye";
        case Handle::frozen_look:
            return "handle frozen look";
        case Handle::frozen_opening:
            return "handle frozen opening";
        case Handle::segment_start:
            return "handle segment start";
        case Handle::segment_end:
            return "handle segment end";
        default:
            return "";
    }
}

const char* handle_tip(Handle handle) {
    switch (handle) {
        case Handle::eye:
            return "drag: move the eye";
        case Handle::look:
            return "drag: turn the view";
        case Handle::opening:
            return "drag: widen or narrow the view";
        case Handle::frozen_eye:
            return "drag: move the frozen eye, which decides what is rendered";
        case Handle::frozen_look:
            return "drag: turn the frozen view, which decides what is rendered";
        case Handle::frozen_opening:
            return "drag: widen or narrow the frozen view, which decides what is rendered";
        case Handle::segment_start:
        case Handle::segment_end:
            return "drag: move this end; Delete removes the segment";
        case Handle::segment:
            return "drag: move the segment; Delete removes it";
        case Handle::note_text:
            return "drag: move; double-click: edit; Delete removes the note";
        case Handle::note_anchor:
            return "drag: point the note at something else";
        case Handle::none:
            break;
    }
    return "";
}

}  // namespace sightline
