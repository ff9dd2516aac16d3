// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/viewer2d.h"

#include <iostream>

#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "shell/start/start.h"
#include "viewer2d/stage2d.h"

namespace sightline {

namespace {

void print_catalogue() {
    for (const CatalogueRow<2>& row : catalogue<2>()) {
        std::string id = row.id;
        id.resize(14, ' ');
        std::cout << id << row.title << " (" << make_scene(row).primitives.size() << " segments, seed " << row.seed
                  << "). " << row.lesson << "\n";
    }
    std::cout << "Scenes in which methods fail (./run lab gallery):";
    for (const CatalogueRow<2>& row : failure_scenes<2>()) std::cout << ' ' << row.id;
    std::cout << "\n";
    const auto maps = installed_maps();
    if (maps.empty()) {
        std::cout << "No Freedoom levels found: Debian's package freedoom has dozens.\n";
    } else {
        std::cout << "Levels of the installed package freedoom:";
        for (const std::string& map : maps) std::cout << ' ' << map;
        std::cout << "\n";
    }
}

}  // namespace

int viewer2d(int argc, const char* const* argv, std::span<const Method<2>> methods) {
    return start<2>(argc, argv, methods, {"viewer2d", print_catalogue, stage2d});
}

}  // namespace sightline
