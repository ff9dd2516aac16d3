// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/picking.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/draw/segment_near.h"
#include "core/draw/shown_boxes.h"

namespace sightline {

namespace {

float distance(const ImVec2& a, const ImVec2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

std::uint32_t segment_near(const Session<2>& session, const Camera& camera, const ImVec2& mouse, float unit) {
    return segment_near(session.scene().primitives, camera.to_scene(mouse), primitive_reach * unit / camera.scale());
}

Pick pick(const Session<2>& session, const Camera& camera, std::span<const HandlePoint> handles, const ImVec2& mouse,
          float unit, bool edit) {
    Pick found;
    if (walks_boxes(session))
        found.node = box_near(session, camera.to_scene(mouse), primitive_reach * unit / camera.scale());
    else
        found.cell = locate(session.cells(), camera.to_scene(mouse));
    found.primitive = segment_near(session, camera, mouse, unit);
    float nearest = handle_reach * unit;
    bool any = false;
    for (const HandlePoint& point : handles)
        if (const float d = distance(mouse, point.at); any ? d < nearest : d <= nearest) {
            nearest = d;
            any = true;
            found.handle = point.handle;
            found.segment = point.segment;
        }
    if (!any && edit && found.primitive != none) {
        found.handle = Handle::segment;
        found.segment = found.primitive;
    }
    return found;
}

Vec<2> snapped_to_end(const Session<2>& session, const Camera& camera, const Vec<2>& at, float unit,
                      std::uint32_t but) {
    double reach = primitive_reach * unit / camera.scale();
    Vec<2> found = at;
    const auto& segments = session.scene().primitives;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        if (i == but) continue;
        for (const Vec<2>& end : segments[i])
            if (const double d = glm::length(end - at); d <= reach) {
                reach = d;
                found = end;
            }
    }
    return found;
}

std::uint32_t centre_near(const Session<2>& session, const Camera& camera, const Vec<2>& at, float unit) {
    const CellComplex<2>& cells = session.cells();
    double reach = primitive_reach * unit / camera.scale();
    std::uint32_t found = none;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        if (const double d = glm::length(cells.centre(cell) - at); d <= reach) {
            reach = d;
            found = cell;
        }
    return found;
}

std::vector<std::string> choices(const Pick& under) {
    std::vector<std::string> here;
    if (under.primitive != none) here.push_back("primitive:" + std::to_string(under.primitive));
    if (under.node != none) here.push_back("node:" + std::to_string(under.node));
    if (under.cell != none) here.push_back(std::to_string(under.cell));
    return here;
}

}  // namespace sightline
