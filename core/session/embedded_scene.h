// A scene that travels inside a state file. Pulls in nlohmann-json, so only .cpp files include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json_input.h"
#include "core/scene/scene.h"

namespace sightline {

/// Members "embedded" and, where the scene has any, "rooms" of `part`, which says all else of the scene (2D: its
/// segments as in a scene's file; 3D: points once each, and three a triangle). Reading them back gives the same
/// primitives, bit for bit.
template <int D>
void embed_scene(const Scene<D>& scene, nlohmann::ordered_json& part);

/// The scene of such members. `name` begins every error line. Throws InputError and Json::exception.
template <int D>
Scene<D> embedded_scene(const Json& part, const std::string& name);

}  // namespace sightline
