// Parsed JSON with places for error lines. Pulls in nlohmann-json, so only .cpp files include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace sightline {

using Json = nlohmann::json;

/// Deeper nesting than any scene has; readers may recurse this far.
inline constexpr int deepest_json = 64;
/// A parsed file takes about ten times its bytes.
inline constexpr std::uint64_t largest_json = std::uint64_t{256} << 20;

/// Throws InputError "name: line L, column C: reason" for anything but one JSON value of bounded depth and size.
Json parse_json(std::string_view text, const std::string& name);

/// Where a value sits: a list through the callers' frames, turned into a JSON pointer only when something is wrong.
struct JsonPlace {
    const JsonPlace* parent = nullptr;
    const char* key = nullptr;  ///< nullptr: `index` counts
    std::size_t index = 0;

    JsonPlace member(const char* name) const { return {this, name, 0}; }
    JsonPlace element(std::size_t i) const { return {this, nullptr, i}; }
    std::string text() const;
};

/// "an object", "a number", ...
const char* json_kind(const Json& value);

/// Throws InputError at the place when the value is no finite number.
double json_number(const Json& value, const JsonPlace& place, const std::string& name);

}  // namespace sightline
