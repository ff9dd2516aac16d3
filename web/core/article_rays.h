// Rays of the eye through a plan: what each crosses, and the directions in which the picture is wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/draw/key_light.h"

namespace sightline {

/// Per ray, from left to right of the view, how many segments it crosses.
struct Crossed {
    std::vector<std::uint32_t> all, drawn;  ///< of the scene; of what is drawn so far
    double mean(const std::vector<std::uint32_t>& counts) const;
    std::size_t deepest() const;  ///< the most that a ray crosses in the scene
};

/// Rounded: for charts and words, no run decides by it.
Crossed crossed_by_rays(const Session<2>& session, int rays);

/// The ray from the eye through "X,Y" to the border of the scene, and a small cross where it meets each segment.
std::vector<LightLine<2>> ray_lines(const Session<2>& session, const std::string& through);

/// The same of the ray that crosses the most.
std::vector<LightLine<2>> deepest_lines(const Session<2>& session);

/// The wrong pixels that lie beside each other, as thin triangles from the eye.
std::vector<LightLine<2>> wrong_lines(const Session<2>& session);

}  // namespace sightline
