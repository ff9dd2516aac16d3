// Small pictures of the scenes that can be opened.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "shell/gl/target.h"
#include "shell/window/stage.h"

namespace sightline {

/// Made, used and destroyed while one OpenGL context is current.
class Thumbnails {
public:
    /// Makes one. Throws for a scene that cannot be read.
    using Make = std::function<std::unique_ptr<GlTarget>(const std::string& scene, int width, int height)>;
    explicit Thumbnails(Make make) : make_(std::move(make)) {}

    /// As Stage::thumbnail. Makes at most one between two calls of next_frame; 0 for a scene that cannot be read.
    GLuint texture(const SceneChoice& scene, int width, int height);
    void next_frame() { made_one_ = false; }

private:
    Make make_;
    std::map<std::string, std::unique_ptr<GlTarget>> made_;  ///< by name; without a picture: cannot be read
    bool made_one_ = false;
};

}  // namespace sightline
