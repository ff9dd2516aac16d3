// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "core/base/text.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/scene/read/no_scene.h"
#include "core/scene/read/read_mesh.h"
#include "core/scene/up_axis.h"

namespace sightline {

namespace {

bool exists(const std::string& path) {
    std::error_code error;
    return std::filesystem::exists(path, error);
}

/// "a.obj;b.obj"
std::vector<std::string> split(const std::string& names) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= names.size();) {
        const std::size_t end = std::min(names.find(';', begin), names.size());
        if (end > begin) parts.push_back(names.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

Scene<3> find_scene(const std::string& name, const LoadOptions& options) {
    if (auto scene = generated_scene(name)) {
        turn_up(*scene, options.up, true);
        if (options.two_sided) scene->two_sided.assign(scene->primitives.size(), 1);
        return std::move(*scene);
    }
    const MeshOptions mesh{options.two_sided, options.progress, options.up, options.choose_view};
    if (exists(name)) return read_mesh(name, name, mesh);
    if (name.find(';') != std::string::npos) return read_meshes(split(name), name, mesh);
    throw no_scene<3>(name);
}

}  // namespace

template <>
Scene<3> load_scene<3>(const std::string& name, const LoadOptions& options) {
    Scene<3> scene = find_scene(name, options);
    scene.name = name;
    return scene;
}

}  // namespace sightline
