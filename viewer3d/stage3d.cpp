// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/stage3d.h"

#include "shell/pane/stage_of.h"
#include "viewer3d/picture3d.h"
#include "viewer3d/thumbnails.h"

namespace sightline {

namespace {

std::vector<SceneChoice> scene_choices() {
    std::vector<SceneChoice> all;
    add_catalogue<3>(all);
    add_lessons<3>(all);
    add_failures<3>(all);
    return all;
}

/// What of OpenGL the window's end takes with it.
struct Held {
    Held(Workbench<3>& bench, std::shared_ptr<Renderers> shared) : renderers(std::move(shared)), picture(bench) {
        renderers->drop();  // made before there was a window
    }
    ~Held() { renderers->drop(); }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;

    std::shared_ptr<Renderers> renderers;
    Picture3d picture;
    Thumbnails thumbnails{thumbnails3d()};
};

}  // namespace

Stage stage3d(Workbench<3>& bench, const std::shared_ptr<Renderers>& renderers) {
    const auto held = std::make_shared<Held>(bench, renderers);
    Stage stage = stage_of(held, scene_choices());
    stage.takes_key = [held](const std::string& key) { return held->picture.takes_key(key); };
    return stage;
}

}  // namespace sightline
