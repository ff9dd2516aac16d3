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

enum class Side : std::uint8_t { neither, both, left, right };

/// Per cell: who has projected it, `a` (left) or `b` (right), at their positions. Empty unless same_cells.
template <int D>
std::vector<Side> projected_sides(const Session<D>& a, const Session<D>& b);

/// The first recorded step, from 1, that pops another cell; for orders of primitives and for different cells, that
/// renders other primitives. Also the step that only one recording has. Nothing when they agree to the end.
template <int D>
std::optional<std::uint32_t> first_difference(const Session<D>& a, const Session<D>& b);

enum class Align : std::uint8_t { step, rendered };
inline constexpr auto align_words = std::to_array<std::string_view>({"step", "rendered"});

/// Moves `other` to the place that belongs to the lead's position: the same step, or the first step with at least as
/// many rendered primitives; as near as its budget and its front allow.
template <int D>
void follow(const Session<D>& lead, Session<D>& other, Align align);

/// One sentence about a step from 1: what each of them (`a` left, `b` right) does in it, with the keys that the popped
/// cells have in both.
template <int D>
std::string difference_sentence(const Session<D>& a, const Session<D>& b, std::uint32_t step);

}  // namespace sightline
