// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/embedded_scene.h"

#include <bit>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/scene/read/parsed_scene.h"

namespace sightline {

namespace {

using OrderedJson = nlohmann::ordered_json;

template <int D>
OrderedJson coordinates(const Vec<D>& p) {
    OrderedJson json = OrderedJson::array();
    for (int i = 0; i < D; ++i) json.push_back(p[i]);
    return json;
}

template <int D>
Vec<D> vector_of(const Json& json) {
    if (!json.is_array() || json.size() != D)
        throw InputError("a point of the scene is not " + std::to_string(D) + " numbers");
    Vec<D> p;
    for (int i = 0; i < D; ++i) {
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

/// As the file of a scene in the plane says it.
OrderedJson segments_json(const Scene<2>& scene) {
    OrderedJson json{{"format", "sightline-scene"}, {"version", 1},           {"dimension", 2},    {"id", scene.id},
                     {"title", scene.title},        {"lesson", scene.lesson}, {"seed", scene.seed}};
    if (scene.origin != Vec<2>(0, 0)) json["origin"] = coordinates<2>(scene.origin);
    if (scene.start_view)
        json["view"] = {{"eye", coordinates<2>(scene.start_view->eye)},
                        {"look_at", coordinates<2>(scene.start_view->look_at)},
                        {"fov", scene.start_view->fov}};
    OrderedJson& segments = json["segments"] = OrderedJson::array();
    for (const Primitive<2>& s : scene.primitives) segments.push_back({s[0].x, s[0].y, s[1].x, s[1].y});
    if (!scene.objects.empty()) json["objects"] = {{"names", scene.objects.names}, {"of", scene.objects.of}};
    return json;
}

template <int D>
OrderedJson rooms_json(const Rooms<D>& rooms) {
    OrderedJson json{{"all", OrderedJson::array()}, {"portals", OrderedJson::array()}};
    for (const Room<D>& room : rooms.all) {
        OrderedJson corners = OrderedJson::array();
        if constexpr (D == 2)
            for (const Vec<2>& p : room.shape) corners.push_back(coordinates<2>(p));
        else
            for (const Vec<3>& p : {room.shape.min, room.shape.max}) corners.push_back(coordinates<3>(p));
        json["all"].push_back({{"name", room.name}, {"corners", corners}});
    }
    for (const Portal<D>& portal : rooms.portals) {
        OrderedJson corners = OrderedJson::array(), between = OrderedJson::array();
        for (const Vec<D>& p : portal.corners) corners.push_back(coordinates<D>(p));
        for (const std::uint32_t room : portal.rooms)
            between.push_back(room == none ? OrderedJson() : OrderedJson(room));
        json["portals"].push_back({{"rooms", between}, {"corners", corners}});
    }
    if (std::isfinite(rooms.closed_from)) json["closed_from"] = rooms.closed_from;
    return json;
}

template <int D>
Rooms<D> rooms_of(const Json& json, const std::string& name) {
    Rooms<D> rooms;
    for (const Json& one : json.at("all")) {
        Room<D> room;
        room.name = one.at("name").get<std::string>();
        const Json& corners = one.at("corners");
        if constexpr (D == 2) {
            for (const Json& p : corners) room.shape.push_back(vector_of<2>(p));
        } else {
            room.shape.min = vector_of<3>(corners.at(0));
            room.shape.max = vector_of<3>(corners.at(1));
        }
        rooms.all.push_back(std::move(room));
    }
    for (const Json& one : json.at("portals")) {
        Portal<D> portal;
        for (std::size_t side = 0; side < 2; ++side)
            if (const Json& room = one.at("rooms").at(side); !room.is_null())
                portal.rooms[side] = index_of(room, rooms.all.size());
        for (const Json& p : one.at("corners")) portal.corners.push_back(vector_of<D>(p));
        rooms.portals.push_back(std::move(portal));
    }
    rooms.closed_from = json.value("closed_from", Rooms<3>{}.closed_from);
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
    json["origin"] = coordinates<3>(scene.origin);
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
    scene.origin = vector_of<3>(json.at("origin"));
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
    if constexpr (D == 2)
        part["embedded"] = segments_json(scene);
    else
        part["embedded"] = mesh_json(scene);
    if (!scene.rooms.empty()) part["rooms"] = rooms_json(scene.rooms);
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
    }
    // What a scene's own file does not say.
    scene.source = part.value("source", scene.source);
    if (part.contains("rooms")) scene.rooms = rooms_of<D>(part["rooms"], name);
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
