// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/draw_list.h"

#include <array>

#include "core/draw/list_text.h"

namespace sightline {

namespace {

constexpr std::array kind_names{"polygon", "polyline", "disc", "ring", "cross", "arrow"};

}  // namespace

std::string to_text(const DrawList& list) {
    std::string text = "world " + point_text(list.world.min) + " " + point_text(list.world.max) + "\n";
    for (const Style& s : list.styles)
        text += "style " + s.name + " fill " + colour_text(s.fill) + " hatch " +
                std::to_string(static_cast<int>(s.hatch)) + " " + colour_text(s.hatch_colour) + " stroke " +
                colour_text(s.stroke) + " width " + number_text(s.width_pt) + " dash " +
                std::to_string(static_cast<int>(s.dash)) + "\n";
    for (const Shape& s : list.shapes) {
        text += std::string(kind_names[static_cast<std::size_t>(s.kind)]) + " " + list.styles[s.style].name;
        if (s.size_pt != 0) text += " size " + number_text(s.size_pt);
        for (std::uint32_t i = 0; i < s.point_count; ++i) text += " " + point_text(list.points[s.first_point + i]);
        text += "\n";
    }
    for (const Label& l : list.labels) {
        text += "label " + point_text(l.at) + " offset " + point_text(l.offset_pt) + " scale " + number_text(l.scale) +
                " " + colour_text(l.colour);
        if (l.disc) text += " disc " + colour_text(*l.disc);
        if (l.leader) text += " leader";
        if (l.yields) text += " yields";
        text += " \"";
        text += l.text;
        text += "\"\n";
    }
    return text;
}

}  // namespace sightline
