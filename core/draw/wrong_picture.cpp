// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/wrong_picture.h"

#include <cmath>

namespace sightline {

namespace {

/// How far a surface turns to a fixed lamp: [0, 1].
double turned(const Primitive<3>& triangle) {
    const Vec<3> normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double length = std::sqrt(glm::dot(normal, normal));
    return length > 0 ? std::abs(glm::dot(normal, Vec<3>(0.36, 0.48, 0.8))) / length : 0;
}

/// What is right is pale, so that red is the only colour; both keep the shapes.
Colour shaded(const Primitive<3>& triangle, bool right) {
    const double light = turned(triangle);
    const auto grey = static_cast<std::uint8_t>(200 + 45 * light);
    return right ? Colour{grey, grey, grey} : Colour{static_cast<std::uint8_t>(185 + 70 * light), 0, 0};
}

}  // namespace

Pixels wrong_picture(const Reference& reference, std::span<const std::uint8_t> wrong, const Scene<3>& scene) {
    constexpr Colour nothing{255, 255, 255};
    Pixels pixels{reference.image.width, reference.image.height, {}};
    pixels.colours.reserve(reference.image.ids.size());
    std::uint32_t before = none;
    bool right_before = true;
    Colour colour = nothing;
    for (std::size_t pixel = 0; pixel < reference.image.ids.size(); ++pixel) {
        const std::uint32_t id = reference.image.ids[pixel];
        const bool right = !wrong[pixel];
        if (id != before || right != right_before)
            colour = id != none ? shaded(scene.primitives[id], right) : right ? nothing : Colour{255, 0, 0};
        before = id;
        right_before = right;
        pixels.colours.push_back(colour);
    }
    return pixels;
}

}  // namespace sightline
