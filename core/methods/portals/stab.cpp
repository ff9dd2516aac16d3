// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/portals/stab.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace sightline {

namespace {

using LinePoints = std::array<Vec<2>, 2>;

bool leaves(const LinePoints& line, const Doorway2& segment) {
    return orient(line[0], line[1], segment.left) >= 0 && orient(line[0], line[1], segment.right) <= 0;
}
bool leaves_all(const LinePoints& line, std::span<const Doorway2> passed, const Doorway2& next) {
    return line[0] != line[1] && leaves(line, next) &&
           std::all_of(passed.begin(), passed.end(), [&](const Doorway2& segment) { return leaves(line, segment); });
}

}  // namespace

bool stab(const StabbingLines& lines, std::span<const Doorway2> passed, const Doorway2& next, StabbingLines& narrower) {
    for (const Doorway2& segment : passed)
        if (segment.left == next.right || segment.right == next.left) return false;
    narrower = lines;
    // An outermost line that does not stab the new segment gives way to one through an end of it.
    bool found = leaves(lines.to_right, next);
    const auto try_right = [&](const Vec<2>& left, const Vec<2>& right) {
        if (found || !leaves_all({left, right}, passed, next)) return;
        narrower.to_right = {left, right};
        found = true;
    };
    if (!found) try_right(next.left, next.right);
    for (std::size_t i = 0; i < passed.size() && !found; ++i) {
        try_right(next.left, passed[i].right);
        try_right(passed[i].left, next.right);
    }
    if (!found) return false;
    found = leaves(lines.to_left, next);
    const auto try_left = [&](const Vec<2>& right, const Vec<2>& left) {
        if (found || !leaves_all({right, left}, passed, next)) return;
        narrower.to_left = {right, left};
        found = true;
    };
    if (!found) try_left(next.right, next.left);
    for (std::size_t i = 0; i < passed.size() && !found; ++i) {
        try_left(passed[i].right, next.left);
        try_left(next.right, passed[i].left);
    }
    if (!found) return false;
    const auto& [a, b] = narrower.to_right;
    return orient(a, b, narrower.to_left[0]) != 0 || orient(a, b, narrower.to_left[1]) != 0;
}

}  // namespace sightline
