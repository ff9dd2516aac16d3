// Whether a triangle meets a tetrahedron or a box: conservative, by separating axes with a margin for rounding.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/scene/scene.h"

namespace sightline {

/// A triangle prepared for tests against many cells. A test may say that it meets a cell that it misses by a rounding
/// error (some 1e-12 of the size of the larger one, unless they are needles), never that it misses one whose closure it
/// meets. Any finite coordinates.
class TriangleTest {
public:
    explicit TriangleTest(const Primitive<3>& triangle);

    struct Contact {
        bool meets = false;
        /// Bit i: the triangle may reach the plane of the facet opposite corner i. 0: it lies inside the tetrahedron.
        std::uint8_t reaches = 0;
    };
    /// Corners with orient() = +1.
    Contact with(const std::array<Vec<3>, 4>& tetrahedron) const;

    bool meets(const Box<3>& box) const;

    const Box<3>& bounds() const { return bounds_; }

private:
    Vec<3> origin_;  ///< the first corner; what follows is relative to it
    std::array<Vec<3>, 3> corners_;
    std::array<Vec<3>, 3> edges_;  ///< from corner i to the next
    Vec<3> normal_;
    double size_;    ///< largest coordinate
    Box<3> bounds_;  ///< not relative
};

}  // namespace sightline
