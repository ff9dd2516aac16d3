// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/embedded_scene.h"

#include <bit>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/scene/read/parsed_scene.h"
#include "core/scene/read/read_json.h"

namespace sightline {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson coordinates(const Vec<3>& p) { return {p.x, p.y, p.z}; }

Vec<3> vector_of(const Json& json) {
    if (!json.is_array() || json.size() != 3) throw InputError("a point of the scene is not 3 numbers");
    Vec<3> p;
    for (int i = 0; i < 3; ++i) {
        p[i] = json.at(static_cast<std::size_t>(i)).get<double>();
        if (!std::isfinite(p[i])) throw InputError("a point of the scene is not finite");
    }
    return p;
}

/// A whole number below `count`, of an index in a list.
std::uint32_t index_of(const Json& json, std::size_t count) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() >= count)
        throw InputError("an index of the scene is not a whole number below " + std::to_string(count));
    return json.get<std::uint32_t>();
}

OrderedJson rooms_json(const Rooms<3>& rooms) {
    OrderedJson json{{"all", OrderedJson::array()}, {"portals", OrderedJson::array()}};
    for (const Room<3>& room : rooms.all)
        json["all"].push_back(
            {{"name", room.name}, {"corners", {coordinates(room.shape.min), coordinates(room.shape.max)}}});
    for (const Portal<3>& portal : rooms.portals) {
        OrderedJson corners = OrderedJson::array(), between = OrderedJson::array();
        for (const Vec<3>& p : portal.corners) corners.push_back(coordinates(p));
        for (const std::uint32_t room : portal.rooms)
            between.push_back(room == none ? OrderedJson() : OrderedJson(room));
        json["portals"].push_back({{"rooms", between}, {"corners", corners}});
    }
    if (std::isfinite(rooms.closed_from)) json["closed_from"] = rooms.closed_from;
    return json;
}

Rooms<3> rooms_of(const Json& json, const std::string& name) {
    Rooms<3> rooms;
    for (const Json& one : json.at("all"))
        rooms.all.push_back({one.at("name").get<std::string>(),
                             {vector_of(one.at("corners").at(0)), vector_of(one.at("corners").at(1))}});
    for (const Json& one : json.at("portals")) {
        Portal<3> portal;
        for (std::size_t side = 0; side < 2; ++side)
            if (const Json& room = one.at("rooms").at(side); !room.is_null())
                portal.rooms[side] = index_of(room, rooms.all.size());
        for (const Json& p : one.at("corners")) portal.corners.push_back(vector_of(p));
        rooms.portals.push_back(std::move(portal));
    }
    rooms.closed_from = json.value("closed_from", rooms.closed_from);
    check_rooms(rooms, name);
    return rooms;
}

OrderedJson mesh_json(const Scene<3>& scene) {
    OrderedJson points = OrderedJson::array(), triangles = OrderedJson::array();
    std::map<std::array<std::uint64_t, 3>, std::uint32_t> known;  // by their bits: -0 is another one than 0
    for (const Primitive<3>& triangle : scene.primitives)
        for (const Vec<3>& p : triangle) {
            const std::array bits{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                                  std::bit_cast<std::uint64_t>(p.z)};
            const auto [place, fresh] = known.emplace(bits, static_cast<std::uint32_t>(known.size()));
            if (fresh)
                for (const double number : {p.x, p.y, p.z}) points.push_back(number);
            triangles.push_back(place->second);
        }
    OrderedJson json{{"title", scene.title}, {"lesson", scene.lesson}, {"up_axis", scene.up_axis}};
    json["origin"] = coordinates(scene.origin);
    json["points"] = std::move(points);
    json["triangles"] = std::move(triangles);
    if (!scene.two_sided.empty()) json["two_sided"] = scene.two_sided;
    if (!scene.objects.empty()) json["objects"] = {{"names", scene.objects.names}, {"of", scene.objects.of}};
    return json;
}

Scene<3> mesh_of(const Json& json) {
    Scene<3> scene;
    scene.title = json.at("title").get<std::string>();
    scene.lesson = json.at("lesson").get<std::string>();
    scene.up_axis = static_cast<int>(index_of(json.at("up_axis"), 3));
    scene.origin = vector_of(json.at("origin"));
    const std::vector<double> numbers = json.at("points").get<std::vector<double>>();
    for (const double number : numbers)
        if (!std::isfinite(number)) throw InputError("a point of the scene is not finite");
    const Json& corners = json.at("triangles");
    if (corners.size() % 3 != 0) throw InputError("a triangle of the scene has no three corners");
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        Primitive<3> triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t at = 3 * std::size_t{index_of(corners[i + k], numbers.size() / 3)};
            triangle[k] = {numbers[at], numbers[at + 1], numbers[at + 2]};
        }
        scene.primitives.push_back(triangle);
    }
    if (json.contains("two_sided")) scene.two_sided = json["two_sided"].get<std::vector<std::uint8_t>>();
    if (json.contains("objects")) {
        scene.objects.names = json["objects"].at("names").get<std::vector<std::string>>();
        for (const Json& object : json["objects"].at("of"))
            scene.objects.of.push_back(index_of(object, scene.objects.names.size()));
    }
    const std::size_t count = scene.primitives.size();
    if ((!scene.two_sided.empty() && scene.two_sided.size() != count) ||
        (json.contains("objects") && scene.objects.of.size() != count))
        throw InputError("the scene does not say the same of each triangle");
    return scene;
}

}  // namespace

template <int D>
void embed_scene(const Scene<D>& scene, OrderedJson& part) {
    if constexpr (D == 2) {
        part["embedded"] = OrderedJson::parse(write_json(scene));
    } else {
        part["embedded"] = mesh_json(scene);
        if (!scene.rooms.empty()) part["embedded"]["rooms"] = rooms_json(scene.rooms);
    }
}

template <int D>
Scene<D> embedded_scene(const Json& part, const std::string& name) {
    Scene<D> scene;
    if constexpr (D == 2) {
        scene = scene_from_json(part.at("embedded"), name);
    } else {
        scene = mesh_of(part.at("embedded"));
        scene.id = part.at("id").get<std::string>();
        scene.seed = part.value("seed", scene.seed);
        if (part.at("embedded").contains("rooms")) scene.rooms = rooms_of(part["embedded"]["rooms"], name);
    }
    // What a scene's own file does not say.
    scene.source = part.value("source", scene.source);
    if (part.contains("dropped")) {
        const Json& dropped = part["dropped"];
        const auto count = [&](const char* key) { return dropped.value(key, std::size_t{0}); };
        scene.dropped = {count("degenerate"), count("duplicate"), count("not_finite")};
    }
    return scene;
}

template void embed_scene<2>(const Scene<2>&, OrderedJson&);
template void embed_scene<3>(const Scene<3>&, OrderedJson&);
template Scene<2> embedded_scene<2>(const Json&, const std::string&);
template Scene<3> embedded_scene<3>(const Json&, const std::string&);

}  // namespace sightline
