// Lines of the plane that stab a sequence of segments, each from the side from which it is passed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/geometry/vec.h"

namespace sightline {

/// A segment by its ends as one sees it who passes it.
struct Doorway2 {
    Vec<2> left, right;
};

/// A line stabs the segments where it leaves all left ends on its left and all right ones on its right (Teller and
/// Séquin 1991). Known by the outermost two of these lines: the one that turns right most passes a left end and then a
/// right one, the other a right end and then a left one.
struct StabbingLines {
    std::array<Vec<2>, 2> to_right{}, to_left{};

    StabbingLines() = default;
    explicit StabbingLines(const Doorway2& first)
        : to_right{first.left, first.right}, to_left{first.right, first.left} {}
};

/// Those of `lines`, which stab all of `passed`, that stab one more segment. False: there are none, or only such as
/// touch ends on both sides at once, which no eye sees through at an angle. Exact.
bool stab(const StabbingLines& lines, std::span<const Doorway2> passed, const Doorway2& next, StabbingLines& narrower);

}  // namespace sightline
