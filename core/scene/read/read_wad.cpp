// Layout: https://doomwiki.org/wiki/WAD and the pages of the lumps; all numbers are little endian.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_wad.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/base/trig.h"
#include "core/scene/clean.h"
#include "core/scene/plan_rooms.h"

namespace sightline {

namespace {

constexpr std::size_t header_size = 12, entry_size = 16, vertex_size = 4, linedef_size = 14, thing_size = 10,
                      sidedef_size = 30;
constexpr std::uint32_t no_side = 0xffff;
constexpr double look_ahead = 256;  // map units; a door is 64 to 128 wide

std::uint32_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }
std::uint32_t u16(std::string_view bytes, std::size_t at) { return byte_at(bytes, at) | byte_at(bytes, at + 1) << 8; }
std::uint32_t u32(std::string_view bytes, std::size_t at) { return u16(bytes, at) | u16(bytes, at + 2) << 16; }
double i16(std::string_view bytes, std::size_t at) {
    const auto value = static_cast<std::int32_t>(u16(bytes, at));
    return value < 0x8000 ? value : value - 0x10000;
}

struct Lump {
    std::uint32_t offset, size;
    std::string name;
};

std::vector<Lump> directory(std::string_view bytes, const std::string& name) {
    if (bytes.size() < header_size)
        throw input_error(name, "byte 0", "only " + std::to_string(bytes.size()) + " bytes, a WAD header has 12");
    const std::string_view magic = bytes.substr(0, 4);
    if (magic != "IWAD" && magic != "PWAD") throw input_error(name, "byte 0", "is not a WAD: expected IWAD or PWAD");
    const std::uint64_t count = u32(bytes, 4), start = u32(bytes, 8);
    if (start + count * entry_size > bytes.size())
        throw input_error(name, "byte 4",
                          "the directory (" + std::to_string(count) + " lumps at byte " + std::to_string(start) +
                              ") lies beyond the end of the file (" + std::to_string(bytes.size()) + " bytes)");
    std::vector<Lump> lumps;
    lumps.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = start + i * entry_size;
        const std::string_view padded = bytes.substr(at + 8, 8);
        lumps.push_back({u32(bytes, at), u32(bytes, at + 4), one_line(padded.substr(0, padded.find('\0')))});
    }
    return lumps;
}

/// Indices of the lumps that name maps.
std::vector<std::size_t> map_markers(const std::vector<Lump>& lumps) {
    std::vector<std::size_t> markers;
    for (std::size_t i = 0; i + 4 < lumps.size(); ++i)
        if (lumps[i + 1].name == "THINGS" && lumps[i + 2].name == "LINEDEFS" && lumps[i + 3].name == "SIDEDEFS" &&
            lumps[i + 4].name == "VERTEXES")
            markers.push_back(i);
    return markers;
}

/// Maps of another format, whose text stands in one lump: UDMF.
std::vector<std::size_t> text_markers(const std::vector<Lump>& lumps) {
    std::vector<std::size_t> markers;
    for (std::size_t i = 0; i + 1 < lumps.size(); ++i)
        if (lumps[i + 1].name == "TEXTMAP") markers.push_back(i);
    return markers;
}

std::string upper(std::string text) {
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

std::size_t chosen_marker(const std::vector<Lump>& lumps, const std::string& map, const std::string& name) {
    const std::vector<std::size_t> markers = map_markers(lumps);
    for (const std::size_t i : text_markers(lumps))
        if (map.empty() ? markers.empty() : upper(lumps[i].name) == upper(map))
            throw input_error(name, lumps[i].name, "is a map in UDMF, which is not supported");
    if (markers.empty())
        throw input_error(name, "directory", "holds no map (no lump followed by THINGS LINEDEFS SIDEDEFS VERTEXES)");
    // Where a map stands twice the game takes the last one.
    const std::string wanted = upper(map.empty() ? lumps[markers.front()].name : map);
    for (auto i = markers.rbegin(); i != markers.rend(); ++i)
        if (upper(lumps[*i].name) == wanted) return *i;
    std::string known;
    for (const std::size_t i : markers) known += " " + lumps[i].name;
    throw input_error(name, "directory", "no map \"" + one_line(map, 40) + "\"; it has" + known);
}

std::string_view contents(std::string_view bytes, const Lump& lump, std::size_t record_size, const std::string& name) {
    const std::uint64_t end = std::uint64_t{lump.offset} + lump.size;
    if (end > bytes.size())
        throw input_error(name, lump.name,
                          std::to_string(lump.size) + " bytes at byte " + std::to_string(lump.offset) +
                              " lie beyond the end of the file (" + std::to_string(bytes.size()) + " bytes)");
    if (lump.size % record_size != 0)
        throw input_error(name, lump.name,
                          "has " + std::to_string(lump.size) + " bytes, no multiple of " + std::to_string(record_size));
    return bytes.substr(lump.offset, lump.size);
}

/// Of several starts of player 1 the last is the player's; the others are dolls.
std::optional<ViewSpec<2>> player_view(std::string_view things) {
    std::optional<ViewSpec<2>> view;
    for (std::size_t at = 0; at < things.size(); at += thing_size) {
        if (u16(things, at + 6) != 1) continue;
        const Vec<2> eye(i16(things, at), i16(things, at + 2));
        const SinCos direction = sincos_degrees(i16(things, at + 4));
        view = ViewSpec<2>{eye, eye + look_ahead * Vec<2>(direction.cos, direction.sin), 90};
    }
    return view;
}

/// Lines belong to the sector on their right side.
Objects sectors_of(std::string_view sidedefs, const std::vector<std::uint32_t>& right_sides) {
    Objects objects;
    const std::size_t sides = sidedefs.size() / sidedef_size;
    std::uint32_t most = 0;
    for (const std::uint32_t side : right_sides)
        if (side < sides) most = std::max(most, u16(sidedefs, side * sidedef_size + 28) + 1);
    if (most == 0) return objects;  // nothing is said of sectors
    for (std::uint32_t i = 0; i < most; ++i) objects.names.push_back("sector " + std::to_string(i));
    objects.names.emplace_back("no sector");
    for (const std::uint32_t side : right_sides)
        objects.of.push_back(side < sides ? u16(sidedefs, side * sidedef_size + 28) : most);
    return objects;
}

}  // namespace

std::vector<std::string> wad_maps(std::string_view bytes, const std::string& name) {
    const std::vector<Lump> lumps = directory(bytes, name);
    std::vector<std::string> maps;
    for (const std::size_t i : map_markers(lumps))
        if (std::find(maps.begin(), maps.end(), lumps[i].name) == maps.end()) maps.push_back(lumps[i].name);
    return maps;
}

Scene<2> read_wad(std::string_view bytes, const std::string& name, const WadOptions& options) {
    const std::vector<Lump> lumps = directory(bytes, name);
    const std::size_t marker = chosen_marker(lumps, options.map, name);
    // A map of the Hexen format ends with a lump BEHAVIOR and has longer records.
    for (std::size_t i = marker + 5; i < lumps.size() && i <= marker + 11; ++i)
        if (lumps[i].name == "BEHAVIOR")
            throw input_error(name, lumps[marker].name, "is a map in Hexen's format, which is not supported");

    const std::string_view things = contents(bytes, lumps[marker + 1], thing_size, name);
    const std::string_view linedefs = contents(bytes, lumps[marker + 2], linedef_size, name);
    const std::string_view sidedefs = contents(bytes, lumps[marker + 3], sidedef_size, name);
    const std::string_view vertexes = contents(bytes, lumps[marker + 4], vertex_size, name);
    const std::size_t vertex_count = vertexes.size() / vertex_size;

    Scene<2> scene;
    scene.id = name + "#" + lumps[marker].name;
    scene.title = lumps[marker].name + " of " + name;
    scene.source = "wad";
    std::size_t see_through = 0;
    std::vector<std::uint32_t> right_sides;  // per primitive
    for (std::size_t at = 0; at < linedefs.size(); at += linedef_size) {
        Primitive<2> segment;
        for (std::size_t end = 0; end < 2; ++end) {
            const std::size_t vertex = u16(linedefs, at + 2 * end);
            if (vertex >= vertex_count)
                throw input_error(name, "LINEDEFS record " + std::to_string(at / linedef_size),
                                  "vertex " + std::to_string(vertex) + " of " + std::to_string(vertex_count));
            segment[end] = {i16(vertexes, vertex * vertex_size), i16(vertexes, vertex * vertex_size + 2)};
        }
        const bool wall = u16(linedefs, at + 12) == no_side;
        if (wall || options.two_sided) {
            scene.primitives.push_back(segment);
            right_sides.push_back(u16(linedefs, at + 10));
        } else {
            ++see_through;
        }
    }
    if (see_through > 0)
        scene.warnings.push_back(std::to_string(see_through) +
                                 " two-sided lines, which can be seen through, are left out");
    scene.objects = sectors_of(sidedefs, right_sides);
    clean(scene, Recentre::no, name);
    scene.rooms = plan_rooms(scene.primitives);
    scene.start_view = player_view(things);
    if (!scene.start_view) {
        scene.warnings.push_back("no start of player 1 (thing of type 1): a start view is chosen instead");
        scene.start_view = default_view(scene.primitives);
    }
    return scene;
}

}  // namespace sightline
