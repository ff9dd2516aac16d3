// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/window2d.h"

#include <iostream>
#include <memory>

#include "core/error.h"
#include "core/scene/catalogue.h"
#include "core/scene/load.h"
#include "shell/window/memory.h"
#include "viewer2d/picture2d.h"
#include "viewer2d/thumbnails.h"

namespace sightline {

namespace {

std::vector<SceneChoice> choices() {
    std::vector<SceneChoice> all;
    for (const CatalogueRow<2>& row : catalogue()) all.push_back({row.id, row.title, row.lesson});
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

void run_window(Workbench<2>& bench, const WindowOptions& options, const std::filesystem::path& memory,
                const std::string& word) {
    Window<2> window(bench, options);
    window.stage = stage2d(bench);
    if (!word.empty()) window.tell({word, true});
    const auto remember = [&] { keep(memory, {window.placement(), lasting(bench.desk), bench.recent}); };
    window.opened = [&] {
        try {
            remember();
        } catch (const WorkError& error) {
            window.tell({error.what(), true});
        }
    };
    window.run();
    try {
        remember();
    } catch (const WorkError& error) {
        std::cerr << "warning: " << error.what() << "\n";
    }
}

}  // namespace sightline
