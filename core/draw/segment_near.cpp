// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/segment_near.h"

#include <algorithm>

#include "core/base/index.h"

namespace sightline {

namespace {

double distance_to_segment(const Vec<2>& p, const Primitive<2>& s) {
    const Vec<2> d = s[1] - s[0];
    const double t = std::clamp(glm::dot(p - s[0], d) / glm::dot(d, d), 0.0, 1.0);
    return glm::length(p - (s[0] + d * t));
}

}  // namespace

std::uint32_t segment_near(std::span<const Primitive<2>> segments, const Vec<2>& at, double reach) {
    std::uint32_t found = none;
    for (std::uint32_t i = 0; i < segments.size(); ++i)
        if (const double d = distance_to_segment(at, segments[i]); d <= reach) {
            reach = d;
            found = i;
        }
    return found;
}

}  // namespace sightline
