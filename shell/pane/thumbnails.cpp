// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/thumbnails.h"

#include <exception>

namespace sightline {

GLuint Thumbnails::texture(const SceneChoice& scene, int width, int height) {
    const auto found = made_.find(scene.name);
    const bool there = found != made_.end() &&
                       (!found->second || (found->second->width() == width && found->second->height() == height));
    if (there) return found->second ? found->second->texture() : 0;
    if (made_one_ || width < 1 || height < 1) return 0;
    made_one_ = true;
    std::unique_ptr<GlTarget>& target = made_[scene.name];
    target.reset();
    try {
        target = make_(scene.picture.empty() ? scene.name : scene.picture, width, height);
    } catch (const std::exception&) {
        return 0;  // the chooser shows an empty frame; opening the scene says why
    }
    return target->texture();
}

}  // namespace sightline
