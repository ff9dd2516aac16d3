// Small pictures of the scenes that can be opened.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "shell/gl/list_renderer.h"
#include "shell/gl/target.h"
#include "shell/window/stage.h"

namespace sightline {

/// Made, used and destroyed while one OpenGL 3.3 context is current.
class Thumbnails {
public:
    /// As Stage::thumbnail: a scene of the catalogue at the end of its run, the segments alone of others. Makes at most
    /// one between two calls of next_frame; 0 for a scene that cannot be read.
    GLuint texture(const SceneChoice& scene, int width, int height);
    void next_frame() { made_one_ = false; }

private:
    ListRenderer renderer_;
    std::map<std::string, std::unique_ptr<GlTarget>> made_;  ///< by name; without a picture: cannot be read
    bool made_one_ = false;
};

}  // namespace sightline
