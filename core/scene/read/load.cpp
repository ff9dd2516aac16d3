// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/load.h"

#include <filesystem>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/utf8_mark.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/file_kind.h"
#include "core/scene/read/no_scene.h"
#include "core/scene/read/parsed_scene.h"
#include "core/scene/read/read_wad.h"

namespace sightline {

namespace {

constexpr const char* games[] = {"freedoom1", "freedoom2"};

bool exists(const std::string& path) {
    std::error_code error;
    return std::filesystem::exists(path, error);
}

bool is_wad(std::string_view bytes) { return bytes.starts_with("IWAD") || bytes.starts_with("PWAD"); }

bool is_json(std::string_view bytes) {
    bytes = without_mark(bytes);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && (bytes[first] == '{' || bytes[first] == '[' || bytes[first] == '\x1e');
}

Scene<2> read_any(const std::string& path, const std::string& map, const std::string& name,
                  const LoadOptions& options) {
    const std::string bytes = read_file(path);
    if (bytes.empty()) throw input_error(name, "", "the file is empty");
    if (is_wad(bytes)) return read_wad(bytes, name, {map, options.two_sided});
    if (!map.empty()) throw input_error(name, "", "is not a WAD file, so #" + one_line(map, 40) + " has no meaning");
    if (!is_json(bytes)) {
        const std::string kind = kind_of(bytes);
        throw input_error(
            name, "byte 0",
            "is not a WAD, GeoJSON or Sightline JSON file" + (kind.empty() ? "" : " (it begins like " + kind + ")"));
    }
    if (const std::optional<Json> features = geojson_sequence(bytes, name))
        return scene_from_geojson(*features, name, options.degrees);
    const Json root = parse_json(bytes, name);
    const bool ours = root.is_object() && root.contains("format");
    if (root.is_object() && root.contains("type") && !(ours && root["format"] == "sightline-scene"))
        return scene_from_geojson(root, name, options.degrees);
    if (ours) return scene_from_json(root, name);
    throw input_error(name, "", "is JSON, but neither GeoJSON (\"type\") nor a scene (\"format\")");
}

Scene<2> find_scene(const std::string& name, const LoadOptions& options) {
    if (const CatalogueRow<2>* row = find_in_catalogue(name)) return make_scene(*row);
    if (exists(name)) return read_any(name, "", name, options);

    const std::size_t hash = name.rfind('#');
    const std::string base = name.substr(0, hash);
    const std::string map = hash == std::string::npos ? "" : name.substr(hash + 1);
    if (hash != std::string::npos && exists(base)) return read_any(base, map, base, options);
    for (const std::string game : games) {
        if (base != game) continue;
        const std::string path = options.games_folder + "/" + game + ".wad";
        if (!exists(path))
            throw input_error(name, "", path + " is missing: install Debian's package freedoom (apt install freedoom)");
        return read_any(path, map, base, options);
    }
    throw no_scene<2>(name);
}

}  // namespace

template <>
Scene<2> load_scene<2>(const std::string& name, const LoadOptions& options) {
    Scene<2> scene = find_scene(name, options);
    scene.name = name;
    return scene;
}

std::vector<std::string> list_wad_maps(const std::string& path) { return wad_maps(read_file(path), path); }

std::vector<std::string> installed_maps(const std::string& folder) {
    std::vector<std::string> names;
    for (const std::string game : games) {
        const std::string path = folder + "/" + game + ".wad";
        if (!exists(path)) continue;
        for (const std::string& map : list_wad_maps(path)) names.push_back(game + "#" + map);
    }
    return names;
}

}  // namespace sightline
