// The generated 3D scenes. Every function returns the same bits on every machine for the same seed and size; lengths
// are metres, z is up, the ground is at z = 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/make/catalogue.h"

namespace sightline::generate {

/// Furnished houses between streets. A larger city has more of the same: what stands near the origin stays, bit for
/// bit. Paths "street" (stays near the origin whatever the size) and "air".
Generated city(std::uint64_t seed, std::size_t triangles);
/// Five parked cars: sheet bodies round engines of many small parts, one hood open. A larger scene has finer bodies and
/// fuller engines. Path "round".
Generated cars(std::uint64_t seed, std::size_t triangles);
/// A closed hall with rows of chairs, seen from inside. A larger one has more chairs, up to a thousand, then finer
/// ones. Paths "walk" and, round the closed hall, "outside".
Generated room(std::uint64_t seed, std::size_t triangles);
/// Loose two-sided leaves in bushes and tree tops, of which more stand farther out the larger the scene. Path "trail".
Generated jungle(std::uint64_t seed, std::size_t triangles);
/// Steel frames with tanks, tubes and pipes between lanes; grows in area as the city does. Path "round".
Generated plant(std::uint64_t seed, std::size_t triangles);
/// A floor of a university building: offices, labs and a lecture hall along corridors, doors open, little furniture. A
/// larger one has more wings. About 1,685 convex polygons unless asked otherwise. Paths "walk" and "line".
Generated soda(std::uint64_t seed, std::size_t triangles);
/// A city of boxes, towers and pitched roofs, many of them turned out of the axes, between streets; about 2,857 convex
/// polygons, more blocks in a larger one. Paths "walk" and "line".
Generated blocks(std::uint64_t seed, std::size_t triangles);
/// Tetrahedra on a plane, none touching another: 900 of them unless asked otherwise. Paths "walk" and "line".
Generated tetra(std::uint64_t seed, std::size_t triangles);
/// Furnished buildings of many rooms, which are marked, between streets, lawn and trees: about 3,500 named objects and
/// 75k triangles. Of a larger one there are copies, which fill squares. Path "walk": out of a room, along a corridor,
/// into the street and up over the roofs.
Generated campus(std::uint64_t seed, std::size_t triangles);
/// The 2D scene of this name as a hall: two blocks full of crates from floor to ceiling, a gap between them, hidden
/// crates behind and a house front beyond the gap. One size. Path "test".
Generated bottleneck(std::uint64_t seed, std::size_t);
/// A wall of two triangles with a store behind it. One size. Path "test".
Generated wall2(std::uint64_t seed, std::size_t);

}  // namespace sightline::generate
