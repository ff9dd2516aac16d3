// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/picking.h"

#include <algorithm>
#include <cmath>

namespace sightline {

namespace {

constexpr float look_distance = 60;

double distance_to_segment(const Vec<2>& p, const Primitive<2>& s) {
    const Vec<2> d = s[1] - s[0];
    const double t = std::clamp(glm::dot(p - s[0], d) / glm::dot(d, d), 0.0, 1.0);
    return glm::length(p - (s[0] + d * t));
}

bool near(const ImVec2& a, const ImVec2& b, float reach) { return std::hypot(a.x - b.x, a.y - b.y) <= reach; }

std::uint32_t nearest_primitive(const Session<2>& session, const Vec<2>& at, double reach) {
    std::uint32_t best = none;
    const auto& segments = session.scene().primitives;
    for (std::uint32_t i = 0; i < segments.size(); ++i)
        if (const double distance = distance_to_segment(at, segments[i]); distance <= reach) {
            reach = distance;
            best = i;
        }
    return best;
}

}  // namespace

ImVec2 look_handle(const ViewSpec<2>& view, const Camera& camera, float unit) {
    const ImVec2 eye = camera.to_window(view.eye);
    const Vec<2> d = glm::normalize(view.look_at - view.eye);
    return {eye.x + static_cast<float>(d.x) * look_distance * unit,
            eye.y - static_cast<float>(d.y) * look_distance * unit};
}

Pick pick(const Session<2>& session, const Camera& camera, const ImVec2& mouse, float unit) {
    Pick found;
    const Vec<2> at = camera.to_scene(mouse);
    found.cell = locate(session.cells(), at);
    found.primitive = nearest_primitive(session, at, primitive_reach * unit / camera.scale());
    const ViewSpec<2>& view = session.display_view();
    if (session.selected_primitive != none) {
        const Primitive<2>& s = session.scene().primitives[session.selected_primitive];
        if (found.primitive == session.selected_primitive) found.handle = Handle::segment;
        if (near(mouse, camera.to_window(s[0]), handle_reach * unit)) found.handle = Handle::segment_start;
        if (near(mouse, camera.to_window(s[1]), handle_reach * unit)) found.handle = Handle::segment_end;
    }
    if (near(mouse, look_handle(view, camera, unit), handle_reach * unit)) found.handle = Handle::look_at;
    if (near(mouse, camera.to_window(view.eye), handle_reach * unit)) found.handle = Handle::eye;
    return found;
}

}  // namespace sightline
