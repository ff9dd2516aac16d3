// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "core/scene/catalogue.h"
#include "core/scene/load.h"
#include "core/scene/text.h"

namespace sightline {

namespace {

Scene<3> find_scene(const std::string& name, const LoadOptions& options) {
    if (auto scene = generated_scene(name)) {
        if (options.two_sided) scene->two_sided.assign(scene->primitives.size(), 1);
        return std::move(*scene);
    }
    throw input_error(name, "", "no such file, and no scene of the catalogue has this id");
}

}  // namespace

template <>
Scene<3> load_scene<3>(const std::string& name, const LoadOptions& options) {
    Scene<3> scene = find_scene(name, options);
    scene.name = name;
    return scene;
}

}  // namespace sightline
