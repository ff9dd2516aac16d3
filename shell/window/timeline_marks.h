// The marks on the timeline: what was found in the recording, and what people put there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/draw/draw_list.h"
#include "shell/desk/workbench.h"
#include "shell/window/timeline_axis.h"

namespace sightline {

enum class MarkKind : std::uint8_t {
    penalty,
    mis_ranked,
    unreached,
    first_wrong,
    pop,
    matched,
    breakpoint,
    bookmark,
    difference,
    count
};
enum class MarkShape : std::uint8_t { triangle, diamond, ring, cross, disc, flag };

/// How each kind looks, in the order of MarkKind, which is also the order of drawing.
struct MarkLook {
    std::string_view word;
    std::string_view text;  ///< one line for the key
    MarkShape shape;
    Colour colour;
    int row;  ///< of the marks' lane, from the top
};
inline constexpr int mark_rows = 5;
inline constexpr auto mark_looks = std::to_array<MarkLook>({
    {"penalty", "facets of the step carry a penalty", MarkShape::triangle, {200, 70, 0}, 0},
    {"mis-ranked",
     "a hidden cell was projected before a visible one in the front",
     MarkShape::diamond,
     {125, 30, 110},
     1},
    {"unreached", "a hidden cell was projected while a visible one was clean", MarkShape::ring, {30, 70, 140}, 2},
    {"first wrong pixel", "from this step on the frame must end below the oracle", MarkShape::cross, {190, 0, 60}, 3},
    {"pop",
     "visible in this frame and the previous one, rendered in only one of them",
     MarkShape::ring,
     {150, 90, 0},
     3},
    {"match", "the step matches the condition given to mark", MarkShape::cross, {0, 110, 90}, 4},
    {"breakpoint", "a breakpoint on this step", MarkShape::disc, {170, 30, 20}, 4},
    {"bookmark", "a named step", MarkShape::flag, {0, 90, 170}, 4},
    {"difference", "the first step in which the two sides differ", MarkShape::diamond, {0, 0, 0}, 4},
});
inline const MarkLook& look(MarkKind kind) { return mark_looks[static_cast<std::size_t>(kind)]; }

struct TimelineMark {
    std::uint32_t step = 0;
    MarkKind kind = MarkKind::penalty;
    std::string label;  ///< what more there is to say
};

/// By kind, then by step; only those on steps of the run.
template <int D>
std::vector<TimelineMark> timeline_marks(const Workbench<D>& bench, const std::vector<Marker>& found);

/// Marks of one kind that share a place.
struct MarkGroup {
    MarkKind kind = MarkKind::penalty;
    float x = 0;              ///< the middle
    std::uint32_t first = 0;  ///< index of its first mark
    std::uint32_t count = 1;
    bool crowded = false;  ///< another one of its kind is nearer than `size`: there is room for a stroke only
};

/// Marks on the shown part, by kind and x; those in the same stretch of `stroke` are one group.
std::vector<MarkGroup> mark_groups(const StepAxis& axis, const std::vector<TimelineMark>& marks, float size,
                                   float stroke);

}  // namespace sightline
