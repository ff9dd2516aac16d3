// Which way a face looks, small enough to go with every corner.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/geometry/vec.h"

namespace sightline {

/// A direction of length 127; zero where a face has no area.
struct FaceNormal {
    std::int8_t x = 0, y = 0, z = 0, unused = 0;
};

/// The mean over the face, so that a corner on the line between its neighbours does no harm.
inline FaceNormal normal_of(std::span<const Vec<3>> face) {
    Vec<3> sum(0);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) sum += glm::cross(face[i] - face[0], face[i + 1] - face[0]);
    const double longest = std::max({std::abs(sum.x), std::abs(sum.y), std::abs(sum.z)});
    if (!(longest > 0 && std::isfinite(longest))) return {};
    sum = sum / longest;  // or the squares of tiny ones would vanish
    const Vec<3> n = sum * (127 / std::sqrt(glm::dot(sum, sum)));
    const auto part = [](double x) { return static_cast<std::int8_t>(std::lround(x)); };
    return {part(n.x), part(n.y), part(n.z)};
}

}  // namespace sightline
