// Which part of a car each primitive of the generated scenes `cars` is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sightline {

enum class CarPart : std::uint8_t {
    none,   ///< ground, lamp posts
    front,  ///< half of the shell, in 2D with its mirrors, in 3D both sides of the sheet
    back,   ///< the other half of the shell
    engine,
    other,  ///< wheels, seats, luggage
};

/// Per primitive of the 2D scene with this seed: the generator runs again and tells.
std::vector<CarPart> car_parts(std::uint64_t seed);
/// The same for the 3D scene of this size.
std::vector<CarPart> car_parts(std::uint64_t seed, std::size_t triangles);

}  // namespace sightline
