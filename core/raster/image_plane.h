// The image of a 3D view: where a point of space lies in it, and which ray a pixel stands for.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/view.h"

namespace sightline {

/// Coordinates in the view's cone. A point p has w = dot(across[2], p - eye) > 0 when it lies in front of the eye (1 on
/// the plane of the corners) and is seen at x = dot(across[0], p - eye) / w and y = dot(across[1], p - eye) / w, from
/// -1 (left, bottom) to +1. The four corners may be any parallelogram, also one beside the line of sight.
struct ImagePlane {
    Vec<3> eye{};
    std::array<Vec<3>, 3> across{};

    /// (x w, y w, w)
    Vec<3> project(const Vec<3>& p) const {
        const Vec<3> q = p - eye;
        return {glm::dot(across[0], q), glm::dot(across[1], q), glm::dot(across[2], q)};
    }
};

inline ImagePlane image_plane(const View<3>& view) {
    const auto& c = view.corners;
    const Vec<3> right = (c[1] - c[0]) * 0.5, up = (c[3] - c[0]) * 0.5, middle = (c[0] + c[2]) * 0.5 - view.eye;
    // The inverse of the matrix with these columns.
    const Vec<3> x = glm::cross(up, middle), y = glm::cross(middle, right), w = glm::cross(right, up);
    return {view.eye, {x / glm::dot(right, x), y / glm::dot(up, y), w / glm::dot(middle, w)}};
}

}  // namespace sightline
