// The generated scenes. Every function returns the same bits on every machine for the same seed; lengths are metres.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"

namespace sightline {

/// Blocks of furnished houses with yards and trees between streets; 0..166 x 0..86.
std::vector<Primitive<2>> streets(std::uint64_t seed);
/// A floor of offices: corridors, rooms with doors, furniture; 0..96 x 0..64.
std::vector<Primitive<2>> rooms(std::uint64_t seed);
/// The same without its furniture, as rooms that its walls close.
Rooms<2> rooms_of_rooms(std::uint64_t seed);
/// Two dense blocks with a gap between them; hidden crates behind; 0..16 x 0..16.
std::vector<Primitive<2>> bottleneck(std::uint64_t seed);
/// The same in the middle of a field; -16..48 x -16..48.
std::vector<Primitive<2>> field(std::uint64_t seed);
/// Parked cars: a closed shell around engine, seats and luggage; about 0..26 x 0..16.
std::vector<Primitive<2>> cars(std::uint64_t seed);
/// Thousands of leaves, none touching another; 0..40 x 0..40.
std::vector<Primitive<2>> jungle(std::uint64_t seed);
/// A valley in cross-section: ground, roofs and tree tops, all facing a viewer high above it; 0..200 x 0..50.
std::vector<Primitive<2>> terrain(std::uint64_t seed);
/// A thin wall with small holes and a store room behind it; 0..40 x 0..40.
std::vector<Primitive<2>> wallholes(std::uint64_t seed);
/// A wall of only two segments and a store room behind it; 0..40 x 0..40.
std::vector<Primitive<2>> wall2(std::uint64_t seed);
/// A museum hall where one statue has most of the segments; 0..40 x 0..40.
std::vector<Primitive<2>> statue(std::uint64_t seed);
/// A brick wall, a long empty run, and a store behind it; 0..80 x 0..20.
std::vector<Primitive<2>> forget(std::uint64_t seed);
/// A floor of offices, labs and a lecture hall with walls of real thickness; about 0..62 x 0..44.
std::vector<Primitive<2>> soda(std::uint64_t seed);
/// Its offices, corridors and doorways.
Rooms<2> rooms_of_soda(std::uint64_t seed);
/// Outlines of the buildings of a city, many of them turned out of the axes; about 600 x 600.
std::vector<Primitive<2>> blocks(std::uint64_t seed);
/// 900 triangles, none touching another; about 180 x 180.
std::vector<Primitive<2>> tetra(std::uint64_t seed);
/// Buildings of furnished rooms between streets and trees, at the height of an eye; -64..64 x -64..64.
std::vector<Primitive<2>> campus(std::uint64_t seed);
/// Its rooms and corridors.
Rooms<2> rooms_of_campus(std::uint64_t seed);

/// A city of houses with closed outlines and inner walls, for benchmarks of any size: exactly `segments` of them, of
/// which no two cross (walls may end on one another). The last house may be cut short. Cost: linear.
std::vector<Primitive<2>> city_blocks(std::size_t segments, std::uint64_t seed);

}  // namespace sightline
