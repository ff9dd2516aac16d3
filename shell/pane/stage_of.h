// A viewer's picture and thumbnails as the window takes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/scene/make/catalogue.h"
#include "shell/pane/thumbnails.h"
#include "shell/window/stage.h"

namespace sightline {

/// `held` has a `picture` and `thumbnails`, and lives as long as the stage.
template <typename Held>
Stage stage_of(const std::shared_ptr<Held>& held, std::vector<SceneChoice> scenes) {
    Stage stage;
    stage.draw = [held](Ui& ui, const Area& area) { held->picture.draw(ui, area); };
    stage.interact = [held](Ui& ui, const Area& area) {
        held->thumbnails.next_frame();
        held->picture.interact(ui, area);
    };
    stage.cancel = [held] { return held->picture.cancel(); };
    stage.scenes = std::move(scenes);
    stage.thumbnail = [held](const SceneChoice& scene, int width, int height) {
        return held->thumbnails.texture(scene, width, height);
    };
    return stage;
}

/// The catalogue's scenes.
template <int D>
void add_catalogue(std::vector<SceneChoice>& scenes) {
    for (const CatalogueRow<D>& row : catalogue<D>()) scenes.push_back({row.id, row.title, row.lesson});
}

/// Those in which methods fail.
template <int D>
void add_failures(std::vector<SceneChoice>& scenes) {
    for (const CatalogueRow<D>& row : failure_scenes<D>())
        scenes.push_back({row.id, "Gallery: " + std::string(row.title), row.lesson});
}

}  // namespace sightline
