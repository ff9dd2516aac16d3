// Two sessions beside each other: who projected what, where they first differ, moving one along with the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/session.h"

namespace sightline {

/// Whether both have the same tessellation (points, corners, facets), so that cell ids mean the same.
template <int D>
bool same_cells(const Session<D>& a, const Session<D>& b);

/// Whether only one of two sessions has projected a cell.
enum class Differs : std::uint8_t { no, only_here, only_there };

/// Whether the session's method goes through cells, so that they have states and the run may have inversions.
template <int D>
bool goes_through_cells(const Session<D>& session) {
    return session.method().needs.cells;
}

/// Per cell, as the picture of `here` shows it beside `there`, at their positions. Empty where there is nothing to
/// compare: unless same_cells, or when one of the methods goes through no cells.
template <int D>
std::vector<Differs> cell_differences(const Session<D>& here, const Session<D>& there);

/// The first recorded step, from 1, that pops another cell; for orders of primitives and for different cells, that
/// renders other primitives. Also the step that only one recording has. Nothing when they agree to the end.
template <int D>
std::optional<std::uint32_t> first_difference(const Session<D>& a, const Session<D>& b);

/// One sentence about as many steps as both have recorded so far: where they differ, or that they do not.
template <int D>
std::string so_far_sentence(const Session<D>& a, const Session<D>& b);

enum class Align : std::uint8_t { step, rendered };
inline constexpr auto align_words = std::to_array<std::string_view>({"step", "rendered"});

/// Moves `other` to the place that belongs to the lead's position: the same step, or the first step with at least as
/// many rendered primitives; as near as its budget and its front allow.
template <int D>
void follow(const Session<D>& lead, Session<D>& other, Align align);

/// How they are aligned and how far apart that leaves them: "aligned by step: both have made 40 steps".
template <int D>
std::string align_sentence(const Session<D>& lead, const Session<D>& other, Align align);

/// One sentence about a step from 1: what each of them (`a` left, `b` right) does in it, with the keys that the popped
/// cells have in both.
template <int D>
std::string difference_sentence(const Session<D>& a, const Session<D>& b, std::uint32_t step);

}  // namespace sightline
