// Simple polygons as triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vec.h"

namespace sightline {

/// Appends indices into the polygon, three to a triangle. Either direction of turning; convex polygons in linear time,
/// others by cutting off ears, made for outlines of some hundred corners. Where a polygon crosses itself the triangles
/// are some that use all corners.
void triangulate(std::span<const Vec<2>> polygon, std::vector<std::uint32_t>& triangles);

}  // namespace sightline
