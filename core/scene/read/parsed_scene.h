// Scenes from JSON that is parsed already. Pulls in nlohmann-json, so only .cpp files include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json_input.h"
#include "core/scene/scene.h"

namespace sightline {

/// As read_json, of the parsed text.
Scene<2> scene_from_json(const Json& root, const std::string& name);
/// As read_geojson, of the parsed text.
Scene<2> scene_from_geojson(const Json& root, const std::string& name);

}  // namespace sightline
