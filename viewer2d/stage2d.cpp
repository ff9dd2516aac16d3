// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/stage2d.h"

#include <memory>

#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "viewer2d/picture2d.h"
#include "viewer2d/thumbnails.h"

namespace sightline {

namespace {

std::vector<SceneChoice> choices() {
    std::vector<SceneChoice> all;
    for (const CatalogueRow<2>& row : catalogue<2>()) all.push_back({row.id, row.title, row.lesson});
    for (const CatalogueRow<3>& row : catalogue<3>())
        all.push_back({std::string("3D ") + row.id, "3D: " + std::string(row.title), row.lesson,
                       "viewer3d " + std::string(row.id)});
    for (const CatalogueRow<2>& row : failure_scenes<2>())
        all.push_back({row.id, "Gallery: " + std::string(row.title), row.lesson});
    for (const std::string& map : installed_maps()) all.push_back({map, map, "A level of Freedoom."});
    return all;
}

}  // namespace

Stage stage2d(Workbench<2>& bench) {
    const auto picture = std::make_shared<Picture2d>(bench);
    const auto thumbnails = std::make_shared<Thumbnails>();
    Stage stage;
    stage.draw = [picture](Ui& ui, const Area& area) { picture->draw(ui, area); };
    stage.interact = [picture, thumbnails](Ui& ui, const Area& area) {
        thumbnails->next_frame();
        picture->interact(ui, area);
    };
    stage.cancel = [picture] { return picture->cancel(); };
    stage.scenes = choices();
    stage.thumbnail = [thumbnails](const SceneChoice& scene, int width, int height) {
        return thumbnails->texture(scene, width, height);
    };
    return stage;
}

}  // namespace sightline
