// The matrix that draws a 3D scene as a view sees it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>

#include "core/raster/image_plane.h"

namespace sightline {

/// For a vertex shader: gl_Position = clip * vec4((corner - eye) - eye_rest, 1). The eye is subtracted in two parts, so
/// that what is near it stays sharp however far it is from the origin.
struct CameraMatrix {
    glm::mat4 clip{1};
    glm::vec3 eye{0}, eye_rest{0};
};

/// Depth is reversed and without a far plane: near / distance, which floats hold best; test with GL_GREATER after
/// clearing to 0 (ReversedDepth does both). `zero_to_one` as ReversedDepth says. What is nearer than 2^-22 (without
/// zero_to_one 2^-12) times the farthest corner of the box is cut off.
inline CameraMatrix camera_matrix(const View<3>& view, const Box<3>& scene, bool zero_to_one) {
    const ImagePlane plane = image_plane(view);
    double far = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec<3> p(corner & 1 ? scene.max.x : scene.min.x, corner & 2 ? scene.max.y : scene.min.y,
                       corner & 4 ? scene.max.z : scene.min.z);
        far = std::max(far, plane.project(p).z);
    }
    if (!(far > 0 && std::isfinite(far))) far = 1;  // nothing lies before the eye
    // w is 1 at the distance that one looks at, whatever that is; in a unit of its own floats neither over- nor
    // underflow.
    const Vec<3> x = plane.across[0] / far, y = plane.across[1] / far, w = plane.across[2] / far;
    const double near = zero_to_one ? 0x1p-22 : 0x1p-12;
    CameraMatrix camera;
    for (int i = 0; i < 3; ++i) {
        camera.clip[i] = glm::vec4(x[i], y[i], zero_to_one ? 0 : -w[i], w[i]);
        camera.eye[i] = static_cast<float>(view.eye[i]);
        camera.eye_rest[i] = static_cast<float>(view.eye[i] - static_cast<double>(camera.eye[i]));
    }
    camera.clip[3] = glm::vec4(0, 0, zero_to_one ? near : 2 * near, 0);
    return camera;
}

}  // namespace sightline
