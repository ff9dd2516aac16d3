// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/stage3d.h"

#include "core/scene/make/catalogue.h"
#include "viewer3d/picture3d.h"
#include "viewer3d/thumbnails.h"

namespace sightline {

namespace {

std::vector<SceneChoice> choices() {
    std::vector<SceneChoice> all;
    for (const CatalogueRow<3>& row : catalogue<3>()) all.push_back({row.id, row.title, row.lesson});
    for (const CatalogueRow<3>& row : failure_scenes<3>())
        all.push_back({row.id, "Gallery: " + std::string(row.title), row.lesson});
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
    Thumbnails3d thumbnails;
};

}  // namespace

Stage stage3d(Workbench<3>& bench, const std::shared_ptr<Renderers>& renderers) {
    const auto held = std::make_shared<Held>(bench, renderers);
    Stage stage;
    stage.draw = [held](Ui& ui, const Area& area) { held->picture.draw(ui, area); };
    stage.interact = [held](Ui& ui, const Area& area) {
        held->thumbnails.next_frame();
        held->picture.interact(ui, area);
    };
    stage.cancel = [held] { return held->picture.cancel(); };
    stage.takes_key = [held](const std::string& key) { return held->picture.takes_key(key); };
    stage.lively = [held] { return held->picture.lively(); };
    stage.scenes = choices();
    stage.thumbnail = [held](const SceneChoice& scene, int width, int height) {
        return held->thumbnails.texture(scene, width, height);
    };
    return stage;
}

}  // namespace sightline
