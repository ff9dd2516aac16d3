// Small pictures of the scenes of the catalogue.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"
#include "shell/window/stage.h"

namespace sightline {

/// Made, used and destroyed while one OpenGL context is current.
class Thumbnails3d {
public:
    /// As Stage::thumbnail: the scene at its smallest size, from its start view. Makes at most one between two calls of
    /// next_frame; 0 for a scene that cannot be read.
    GLuint texture(const SceneChoice& scene, int width, int height);
    void next_frame() { made_one_ = false; }

private:
    std::unique_ptr<SolidRenderer> renderer_;                ///< made on first use
    std::map<std::string, std::unique_ptr<GlTarget>> made_;  ///< by name; without a picture: cannot be read
    bool made_one_ = false;
};

}  // namespace sightline
