// How a figure of a session is put down: what a sidecar needs to write the same figure again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sightline {

struct FigureSpec {
    std::string size = "84mm";  ///< a width in millimetres, or WxH in pixels
    double font_pt = 8;
    std::vector<std::string> panels{};  ///< places in the timeline ("step 12"); empty: one panel, as the session stands
    std::uint32_t columns = 0;          ///< of the panels; 0: as many as make good use of the page
    double dpi = 300;                   ///< of PNGs with a width in millimetres, and of images in SVG and PDF
};

}  // namespace sightline
