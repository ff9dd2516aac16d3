// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/window2d.h"

#include "core/scene/catalogue.h"
#include "core/scene/load.h"
#include "shell/window/window.h"
#include "viewer2d/picture2d.h"
#include "viewer2d/thumbnails.h"

namespace sightline {

namespace {

std::vector<SceneChoice> choices() {
    std::vector<SceneChoice> all;
    for (const CatalogueRow& row : catalogue()) all.push_back({row.id, row.title, row.lesson});
    for (const std::string& map : installed_maps()) all.push_back({map, map, "A level of Freedoom."});
    return all;
}

}  // namespace

void run_window(Workbench<2>& bench) {
    Window<2> window(bench, {});
    Picture2d picture(bench);
    Thumbnails thumbnails;
    window.stage.draw = [&](Ui& ui, const Area& area) { picture.draw(ui, area); };
    window.stage.interact = [&](Ui& ui, const Area& area) {
        thumbnails.next_frame();
        picture.interact(ui, area);
    };
    window.stage.cancel = [&] { return picture.cancel(); };
    window.stage.scenes = choices();
    window.stage.thumbnail = [&](const SceneChoice& scene, int width, int height) {
        return thumbnails.texture(scene, width, height);
    };
    window.run();
}

}  // namespace sightline
