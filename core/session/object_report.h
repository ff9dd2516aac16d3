// Objects as an engine has them: what is seen and drawn of each, what its box alone would say, what it costs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/raster/box_sight.h"
#include "core/session/session.h"

namespace sightline {

struct ObjectReport {
    std::uint32_t object = 0;  ///< index into Session::objects()
    std::uint32_t primitives = 0;
    std::uint32_t visible = 0;                    ///< in V
    std::uint32_t rendered = 0;                   ///< what the run spends on it
    std::uint32_t missed = 0;                     ///< visible, not rendered
    std::uint32_t pixels = 0;                     ///< of the exact image (2D: of its row)
    std::uint32_t wrong = 0;                      ///< of them: shown by a primitive that is not rendered
    std::uint32_t first_step = 0, last_step = 0;  ///< that render something of it; 0: none does
    BoxSight box = BoxSight::seen;                ///< of its axis-aligned box, against the depth of all the scene
};

/// One for each object, at the session's position, in their order. Box: conservative, at the reference's size. Cost: an
/// image of the scene and the reference.
template <int D>
std::vector<ObjectReport> object_reports(const Session<D>& session);

/// What an engine would want to know, one sentence: "visible and drawn", "missed: 3 of 12 visible triangles", …
template <int D>
std::string verdict_words(const ObjectReport& report);

/// Those that matter most first: by wrong pixels, then missed primitives, then what is drawn in vain, then by number.
void sort_by_fault(std::vector<ObjectReport>& reports);

}  // namespace sightline
