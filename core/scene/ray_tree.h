// A small tree of boxes to cast a few thousand rays through a scene that has just been loaded.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace sightline {

class RayTree {
public:
    struct Hit {
        double distance = std::numeric_limits<double>::infinity();
        std::uint32_t triangle = 0;  ///< index in the scene
        bool front = false;          ///< the ray meets the side on which the corners turn counter-clockwise
        bool any() const { return distance < std::numeric_limits<double>::infinity(); }
    };

    /// Holds at most `most` triangles, the largest ones. A balanced tree over the order of their centres on a Morton
    /// curve: quick to build, fair to query. Single precision.
    explicit RayTree(const std::vector<Primitive<3>>& triangles, std::size_t most = 1000000);

    /// The nearest triangle at a distance above `after`, in lengths of `direction`.
    Hit cast(const Vec<3>& from, const Vec<3>& direction, double after = 0) const;

private:
    using Point = glm::vec3;
    struct Bounds {
        Point min{std::numeric_limits<float>::infinity()}, max{-std::numeric_limits<float>::infinity()};
    };
    struct Triangle {
        Point corner, edge, other_edge;
        std::uint32_t index;
    };
    static constexpr std::size_t leaf_size = 4;

    std::vector<Triangle> triangles_;  ///< in leaves of leaf_size
    std::vector<Bounds> nodes_;        ///< the children of node i are 2 i and 2 i + 1; the root is 1
    std::size_t first_leaf_ = 1;
};

}  // namespace sightline
