// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/draw_list.h"

#include <array>
#include <charconv>

namespace sightline {

namespace {

constexpr std::array kind_names{"polygon", "polyline", "disc", "ring", "cross", "arrow"};

std::string number(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string point(const Vec<2>& p) { return number(p.x) + "," + number(p.y); }

std::string colour(const Colour& c) {
    std::string text = "#";
    for (const std::uint8_t part : {c.r, c.g, c.b, c.a}) {
        text += "0123456789abcdef"[part >> 4];
        text += "0123456789abcdef"[part & 15];
    }
    return text;
}

}  // namespace

std::string to_text(const DrawList& list) {
    std::string text = "world " + point(list.world.min) + " " + point(list.world.max) + "\n";
    for (const Style& s : list.styles)
        text += "style " + s.name + " fill " + colour(s.fill) + " hatch " + std::to_string(static_cast<int>(s.hatch)) +
                " " + colour(s.hatch_colour) + " stroke " + colour(s.stroke) + " width " + number(s.width_pt) +
                " dash " + std::to_string(static_cast<int>(s.dash)) + "\n";
    for (const Shape& s : list.shapes) {
        text += std::string(kind_names[static_cast<std::size_t>(s.kind)]) + " " + list.styles[s.style].name;
        if (s.size_pt != 0) text += " size " + number(s.size_pt);
        for (std::uint32_t i = 0; i < s.point_count; ++i) text += " " + point(list.points[s.first_point + i]);
        text += "\n";
    }
    for (const Label& l : list.labels) {
        text += "label " + point(l.at) + " offset " + point(l.offset_pt) + " scale " + number(l.scale) + " " +
                colour(l.colour);
        if (l.disc) text += " disc " + colour(*l.disc);
        if (l.leader) text += " leader";
        if (l.yields) text += " yields";
        text += " \"";
        text += l.text;
        text += "\"\n";
    }
    return text;
}

}  // namespace sightline
