// How much of a cell its primitives cover, as an eye in one of a few directions sees it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/space/cell_complex.h"

namespace sightline {

/// Towards the eye, of length 1. 2D: 16, a sixteenth of a turn apart, roughly; 3D: along the axes and along the
/// diagonals of a cube.
template <int D>
std::span<const Vec<D>> opacity_directions();

/// The one that is closest to `to_eye`, which may have any length but 0.
std::size_t nearest_direction(const Vec<2>& to_eye);
std::size_t nearest_direction(const Vec<3>& to_eye);

/// Of each cell in each direction: the share of the cell's outline that the parts of primitives in the cell cover,
/// those of triangles that turn a seen side to the direction. 2D: exact but for rounding; 3D: of 16 x 16 samples over
/// the outline's rectangle.
template <int D>
class CellOpacity {
public:
    CellOpacity() = default;
    /// `threads`: 0, as many as the machine has; the result is the same.
    CellOpacity(const Scene<D>& scene, const CellComplex<D>& cells, int threads = 0);

    /// In [0, 1], a multiple of 1/255.
    double of(std::uint32_t cell, std::size_t direction) const {
        return shares_[cell * direction_count + direction] / 255.0;
    }
    /// To be fetched ahead.
    const void* address_of(std::uint32_t cell) const { return &shares_[cell * direction_count]; }

private:
    static constexpr std::size_t direction_count = D == 2 ? 16 : 14;
    std::vector<std::uint8_t> shares_;  ///< a row of directions for each cell
};

extern template class CellOpacity<2>;
extern template class CellOpacity<3>;

/// That of one cell in one direction, not rounded.
double covered_share(const Scene<2>& scene, const CellComplex<2>& cells, std::uint32_t cell, const Vec<2>& to_eye);
double covered_share(const Scene<3>& scene, const CellComplex<3>& cells, std::uint32_t cell, const Vec<3>& to_eye);

}  // namespace sightline
