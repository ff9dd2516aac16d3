// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/stage2d.h"

#include <memory>

#include "core/scene/read/load.h"
#include "shell/pane/stage_of.h"
#include "viewer2d/picture2d.h"
#include "viewer2d/thumbnails.h"

namespace sightline {

namespace {

std::vector<SceneChoice> scene_choices() {
    std::vector<SceneChoice> all;
    add_catalogue<2>(all);
    add_lessons<2>(all);
    for (const CatalogueRow<3>& row : catalogue<3>())
        all.push_back({std::string("3D ") + row.id, row.title, row.lesson, "3D, in a window of its own",
                       "viewer3d " + std::string(row.id)});
    add_failures<2>(all);
    for (const std::string& map : installed_maps()) all.push_back({map, map, "A level of Freedoom.", "Doom levels"});
    return all;
}

struct Held {
    explicit Held(Workbench<2>& bench) : picture(bench) {}
    Picture2d picture;
    Thumbnails thumbnails{thumbnails2d()};
};

}  // namespace

Stage stage2d(Workbench<2>& bench) { return stage_of(std::make_shared<Held>(bench), scene_choices()); }

}  // namespace sightline
