// Points and colours in the text of lists.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/number.h"
#include "core/draw/draw_list.h"

namespace sightline {

template <int D>
std::string point_text(const Vec<D>& p) {
    std::string text;
    for (int i = 0; i < D; ++i) text += (i > 0 ? "," : "") + number_text(p[i]);
    return text;
}

inline std::string colour_text(const Colour& c) {
    std::string text = "#";
    for (const std::uint8_t part : {c.r, c.g, c.b, c.a}) {
        text += "0123456789abcdef"[part >> 4];
        text += "0123456789abcdef"[part & 15];
    }
    return text;
}

}  // namespace sightline
