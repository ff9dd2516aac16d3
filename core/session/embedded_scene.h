// A scene that travels inside a state file. Pulls in nlohmann-json, so only .cpp files include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json_input.h"
#include "core/scene/scene.h"

namespace sightline {

/// Member "embedded" of `part`, which says all else of the scene (2D: its file; 3D: points once each, and three a
/// triangle, with the rooms). Reading it back gives the same primitives, bit for bit.
template <int D>
void embed_scene(const Scene<D>& scene, nlohmann::ordered_json& part);

/// The scene of such members. `name` begins every error line. Throws InputError and Json::exception.
template <int D>
Scene<D> embedded_scene(const Json& part, const std::string& name);

}  // namespace sightline
