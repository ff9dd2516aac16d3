// Scenes from JSON that is parsed already. Pulls in nlohmann-json, so only .cpp files include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json_input.h"
#include "core/scene/reading.h"
#include "core/scene/scene.h"

namespace sightline {

/// As read_json, of the parsed text.
Scene<2> scene_from_json(const Json& root, const std::string& name);
/// As read_geojson, of the parsed text.
Scene<2> scene_from_geojson(const Json& root, const std::string& name, Degrees degrees = Degrees::as_is);
/// The features of a file that holds one a line (newline-delimited, or RFC 8142) as a collection; nothing where it is
/// none.
std::optional<Json> geojson_sequence(std::string_view text, const std::string& name);

}  // namespace sightline
