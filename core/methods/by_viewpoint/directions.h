// The directions that an eye can look into, cut into intervals of azimuth and elevation (DAS figure 1).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/vec.h"

namespace sightline {

/// 2D: `azimuths` sectors of equal width. 3D: so many in each of `elevations` bands, and a cap around either pole,
/// where azimuths mean nothing: with 8 and 3 that is 26. Sector 0 is centred on the first axis that is level, so that
/// looking along it and a little to either side is one interval, and there is no seam at ±180°.
template <int D>
class Directions {
public:
    Directions() = default;
    /// `azimuths` at least 3; `elevations` at least 1, of no meaning in 2D; up_axis: of the scene.
    Directions(std::uint32_t azimuths, std::uint32_t elevations, int up_axis);

    std::uint32_t count() const { return D == 2 ? azimuths_ : azimuths_ * elevations_ + 2; }
    std::uint32_t azimuths() const { return azimuths_; }
    /// The interval of a direction of any length but 0. Total: every direction lies in one.
    std::uint32_t at(const Vec<D>& direction) const;
    /// A unit vector in the interval: `across` and `up` in [0, 1] go from one end of it to the other.
    Vec<D> inside(std::uint32_t interval, double across, double up) const;
    /// Degrees: from and to, anticlockwise from the first level axis; 3D caps: 0 to 360.
    std::array<double, 2> azimuth(std::uint32_t interval) const;
    /// Degrees above the horizon; 2D: 0 and 0.
    std::array<double, 2> elevation(std::uint32_t interval) const;
    /// "azimuth −22.5° to 22.5°, elevation −22.5° to 22.5°"
    std::string words(std::uint32_t interval) const;

private:
    bool is_cap(std::uint32_t interval) const { return D == 3 && interval >= azimuths_ * elevations_; }
    std::uint32_t sector(double x, double y) const;

    std::uint32_t azimuths_ = 8, elevations_ = 3;
    int up_ = D - 1, x_ = 0, y_ = 1;  ///< axes
    std::vector<Vec<2>> first_;       ///< of each sector: where it begins
    std::vector<double> sine_;        ///< 3D: of the elevations between the bands, rising, the caps' included
};

extern template class Directions<2>;
extern template class Directions<3>;

}  // namespace sightline
