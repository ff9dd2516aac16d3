// The numbers that a picture can show on cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/session/session.h"

namespace sightline {

/// Per cell the number at the session's position: solidity (the key of cells enqueued or projected), count |A|, order
/// (the step that projected the cell), zeta (the smallest layering number in it), share (visible share), id; or a field
/// of the method's run, which a method without it has nowhere.
template <int D>
std::vector<std::optional<double>> cell_numbers(const Session<D>& session, const CellNumber& what);

/// Lowest and highest of them over the whole recording (a field: now and at its end), so that a scale does not move
/// while one steps; nothing when there are none. The title of a field lives as long as `what`.
template <int D>
std::optional<std::array<double, 2>> number_range(const Session<D>& session, const CellNumber& what);

/// What the number is called on scales and in legends; a key has the name that its method gives it.
std::string_view number_title(const CellNumber& what, std::string_view key_title);

}  // namespace sightline
