// The facets of a tetrahedron in terms of its corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sightline {

/// Corners of the facet opposite each corner, counter-clockwise as seen from inside; orient() of the corners is +1.
inline constexpr std::size_t facet_corners[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};

}  // namespace sightline
