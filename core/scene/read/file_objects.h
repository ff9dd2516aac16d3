// Objects of scenes that are made of several files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace sightline {

/// Called after a file was appended behind `first_object` names. Where the scene is made of several files (`file` is
/// this one's name, else empty), its objects are called "file: name", or it is one itself where it names none.
inline void name_file_objects(Scene<3>& scene, std::size_t first_object, const std::string& file) {
    Objects& objects = scene.objects;
    if (file.empty()) return;
    for (std::size_t i = first_object; i < objects.names.size(); ++i) objects.names[i] = file + ": " + objects.names[i];
    if (objects.of.size() == scene.primitives.size()) return;
    objects.of.resize(scene.primitives.size(), static_cast<std::uint32_t>(objects.names.size()));
    objects.names.push_back(file);
}

}  // namespace sightline
