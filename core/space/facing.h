// Which triangles turn a side to the eye that is seen, many at a time, without their corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace sightline {

/// What a plane in floats says of its triangle.
enum class SideSeen : std::uint8_t { away, unsure, seen };

/// The planes of triangles, in an order of the caller's. 16 bytes each.
class FacingPlanes {
public:
    FacingPlanes() = default;
    FacingPlanes(const Scene<3>& scene, std::span<const std::uint32_t> order);

    bool empty() const { return x_.empty(); }
    /// Of places [begin, begin + out.size()) of the order. `away` and `seen` are what faces() and two-sidedness say for
    /// sure; unsure is what lies too close to edge-on for floats.
    void tell(const Vec<3>& eye, std::size_t begin, std::span<SideSeen> out) const;
    std::size_t memory_bytes() const { return 4 * x_.capacity() * sizeof(float); }

private:
    Vec<3> origin_{0};  ///< of the planes, so that floats suffice
    double reach_ = 0;  ///< no corner is farther from it, on any axis
    std::vector<float> x_, y_, z_, offset_;
};

}  // namespace sightline
