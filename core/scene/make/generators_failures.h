// Small scenes in which methods fail, as floor plans (field-notes D). Every function returns the same bits on every
// machine for the same seed; lengths are metres.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/make/catalogue.h"
#include "core/scene/scene.h"

namespace sightline::failures {

// What lies at the border of the scene, or beyond it.

/// A lawn with a fence exactly on the border of the scene's box; 0..40 x 0..40.
std::vector<Primitive<2>> fence(std::uint64_t seed);
/// A closed front from end to end of the scene with rows of crates behind it; 0..60 x 0..30.
std::vector<Primitive<2>> warehouse(std::uint64_t seed);
/// Two blocks of houses and the street between them; -20..30 x 6..37.
std::vector<Primitive<2>> corner(std::uint64_t seed);

/// A niche in the front whose side walls reach past the cells, with crates beside it; 0..40 x 0..40.
std::vector<Primitive<2>> niche(std::uint64_t seed);

// Primitives of awkward size or place.

/// Forty planks, each from side to side of the scene, over crates; 0..40 x 0..40.
std::vector<Primitive<2>> planks(std::uint64_t seed);
/// A screen of slats thinner than a pixel and a wall behind it; 0..24 x 0..24.
std::vector<Primitive<2>> needles(std::uint64_t seed);
/// Bars a few millimetres before the eye and crates in a hall; 0..40 x 0..40.
std::vector<Primitive<2>> cockpit(std::uint64_t seed);
/// A booth of 40 cm round the eye at (20, 20), closed but for a slit, in a hall of crates; 0..40 x 0..40.
std::vector<Primitive<2>> booth(std::uint64_t seed);
/// A corridor whose left wall lies in line with the eye at (0, 0); 0..60 x -12..4.
std::vector<Primitive<2>> graze(std::uint64_t seed);
/// Posters that lie in the very walls they hang on; 0..40 x 0..40.
std::vector<Primitive<2>> posters(std::uint64_t seed);
/// Crates, and among them 40 segments that no scene can use: ten not a number, ten infinite, ten of no length and ten
/// that repeat another.
std::vector<Primitive<2>> broken(std::uint64_t seed);

// Few primitives, or all in one place.

/// Not a single segment.
std::vector<Primitive<2>> empty(std::uint64_t seed);
/// One segment.
std::vector<Primitive<2>> single(std::uint64_t seed);
/// 400 segments within a centimetre and one at either end of the scene; 0..40 x 0..40.
std::vector<Primitive<2>> onecell(std::uint64_t seed);
/// A hundred segments on one line, with gaps; 0..40 x 0.
std::vector<Primitive<2>> line(std::uint64_t seed);
/// A small segment in the middle of each unit square of 0..32 x 0..32: the leaves' centres form a lattice.
std::vector<Primitive<2>> lattice(std::uint64_t seed);

/// A blade of 4 cm in the middle of each unit square of 0..80 x 0..80: hardly anything hides anything.
std::vector<Primitive<2>> meadow(std::uint64_t seed);

// Who hides what.

/// A thick bush before the eye, an empty ring, and a far wall; 0..40 x 0..40.
std::vector<Primitive<2>> thicket(std::uint64_t seed);
/// A wall that folds back and forth, joined at its folds, with crates behind it; 0..40 x 0..40.
std::vector<Primitive<2>> zigzag(std::uint64_t seed);
/// Wedges of two walls, whose common edge is where the wedge ends for the eye; crates just beside; 0..40 x 0..40.
std::vector<Primitive<2>> ridge(std::uint64_t seed);
/// Large flakes near the eye, few enough to see a fine far wall between them; 0..60 x 0..60.
std::vector<Primitive<2>> fog(std::uint64_t seed);
/// A wall with one gap of 8 cm, a sculpture that shows through it, and a store beside that; 0..40 x 0..40.
std::vector<Primitive<2>> gap(std::uint64_t seed);

/// The plan with walls of `height`, seen from both sides: two triangles a segment.
Generated raise(const std::vector<Primitive<2>>& plan, double height);

/// A screen of needle triangles that share one corner, beside one whose pieces meet in T-junctions, before a wall.
Generated needles_3d(std::uint64_t seed, std::size_t);
/// A small triangle in the middle of each unit cube of 0..16 in all directions.
Generated lattice_3d(std::uint64_t seed, std::size_t);
/// A bowl-shaped valley of 64 x 64 squares; 0..128 x 0..128.
Generated valley(std::uint64_t seed, std::size_t);

}  // namespace sightline::failures
