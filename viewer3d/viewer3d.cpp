// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/viewer3d.h"

#include <iostream>

#include "core/scene/make/catalogue.h"
#include "shell/start/start.h"
#include "viewer3d/renderers.h"
#include "viewer3d/stage3d.h"

namespace sightline {

namespace {

void print_catalogue() {
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        std::string id = row.id;
        id.resize(14, ' ');
        std::cout << id << row.title;
        if (row.triangles > 0)
            std::cout << " (" << row.triangles << " triangles, or as many as " << row.id << ":100k asks for, seed ";
        else
            std::cout << " (one size, seed ";
        std::cout << row.seed << "). " << row.lesson;
        for (const char* path : row.paths) std::cout << (path == row.paths.front() ? " Paths: " : ", ") << path;
        std::cout << (row.paths.empty() ? "\n" : ".\n");
    }
    std::cout << "Scenes in which methods fail (./run lab gallery):";
    for (const CatalogueRow<3>& row : failure_scenes<3>()) std::cout << ' ' << row.id;
    std::cout << "\n";
}

}  // namespace

int viewer3d(int argc, const char* const* argv, std::span<const Method<3>> methods) {
    const auto renderers = std::make_shared<Renderers>();
    Viewer<3> viewer{"viewer3d", print_catalogue, {}, graphics_of(renderers)};
    viewer.stage = [renderers](Workbench<3>& bench) { return stage3d(bench, renderers); };
    return start<3>(argc, argv, methods, viewer);
}

}  // namespace sightline
