// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_json.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/scene/clean.h"
#include "core/scene/read/parsed_scene.h"

namespace sightline {

namespace {

std::string string_member(const Json& root, const char* key, const std::string& otherwise, const std::string& name) {
    const auto found = root.find(key);
    if (found == root.end()) return otherwise;
    if (!found->is_string())
        throw input_error(name, std::string("/") + key, std::string("expected a string, found ") + json_kind(*found));
    return found->get<std::string>();
}

template <std::size_t N>
std::array<double, N> numbers(const Json& value, const JsonPlace& place, const std::string& name) {
    if (!value.is_array() || value.size() != N)
        throw input_error(name, place.text(),
                          "expected an array of " + std::to_string(N) + " numbers, found " +
                              (value.is_array() ? "one of " + std::to_string(value.size()) : json_kind(value)));
    std::array<double, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = json_number(value[i], place.element(i), name);
    return result;
}

const Json& required(const Json& object, const char* key, const JsonPlace& place, const std::string& name) {
    const auto found = object.find(key);
    if (found == object.end()) throw input_error(name, place.text(), std::string("\"") + key + "\" is missing");
    return *found;
}

void check_header(const Json& root, const std::string& name) {
    const JsonPlace top;
    const Json& format = required(root, "format", top, name);
    if (format == "sightline-state") throw input_error(name, "/format", "is a state file: open it with --state");
    if (format == "sightline-path") throw input_error(name, "/format", "is a flight path, not a scene");
    if (format != "sightline-scene") throw input_error(name, "/format", "expected \"sightline-scene\"");
    const Json& version = required(root, "version", top, name);
    if (version != 1) throw input_error(name, "/version", "expected 1; this program reads no other version");
    const Json& dimension = required(root, "dimension", top, name);
    if (dimension != 2) throw input_error(name, "/dimension", "expected 2");
}

ViewSpec<2> view_of(const Json& value, const std::string& name) {
    const JsonPlace top, place = top.member("view");
    if (!value.is_object())
        throw input_error(name, "/view", std::string("expected an object, found ") + json_kind(value));
    const auto eye = numbers<2>(required(value, "eye", place, name), place.member("eye"), name);
    const auto look_at = numbers<2>(required(value, "look_at", place, name), place.member("look_at"), name);
    ViewSpec<2> view{{eye[0], eye[1]}, {look_at[0], look_at[1]}, 60};
    if (value.contains("fov")) view.fov = json_number(value["fov"], place.member("fov"), name);
    check_view(view, name, "/view");
    return view;
}

/// {"names": ["wall", …], "of": [0, 0, 1, …]}
Objects objects_of(const Json& value, std::size_t primitives, const std::string& name) {
    const JsonPlace top, place = top.member("objects");
    if (!value.is_object())
        throw input_error(name, "/objects", std::string("expected an object, found ") + json_kind(value));
    const Json &names = required(value, "names", place, name), &of = required(value, "of", place, name);
    if (!names.is_array() || !of.is_array() || of.size() != primitives)
        throw input_error(name, "/objects", "expected an array of names, and in \"of\" a number for each segment");
    Objects objects;
    for (const Json& one : names) {
        if (!one.is_string()) throw input_error(name, "/objects/names", "expected strings");
        objects.names.push_back(one.get<std::string>());
    }
    for (const Json& one : of) {
        if (!one.is_number_unsigned() || one.get<std::uint64_t>() >= names.size())
            throw input_error(name, "/objects/of", "expected numbers of names, from 0");
        objects.of.push_back(one.get<std::uint32_t>());
    }
    return objects;
}

std::vector<Vec<2>> points_of(const Json& value, const JsonPlace& place, const std::string& name) {
    if (!value.is_array())
        throw input_error(name, place.text(), std::string("expected an array, found ") + json_kind(value));
    std::vector<Vec<2>> points;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const auto p = numbers<2>(value[i], place.element(i), name);
        points.push_back({p[0], p[1]});
    }
    return points;
}

/// {"all": [{"name": "hall", "shape": [[0, 0], …]}, …],
///  "portals": [{"rooms": [0, null], "corners": [[0, 1], [0, 2]]}, …]}; null: the outside.
Rooms<2> rooms_of(const Json& value, const std::string& name) {
    const JsonPlace top, place = top.member("rooms");
    if (!value.is_object())
        throw input_error(name, "/rooms", std::string("expected an object, found ") + json_kind(value));
    const Json &all = required(value, "all", place, name), &portals = required(value, "portals", place, name);
    if (!all.is_array() || !portals.is_array())
        throw input_error(name, "/rooms", "expected arrays of rooms and of portals");
    Rooms<2> rooms;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const JsonPlace of_rooms = place.member("all"), at = of_rooms.element(i);
        if (!all[i].is_object() || !all[i].value("name", Json()).is_string())
            throw input_error(name, at.text(), "expected a room with a name");
        rooms.all.push_back({all[i]["name"].get<std::string>(),
                             points_of(required(all[i], "shape", at, name), at.member("shape"), name)});
    }
    for (std::size_t i = 0; i < portals.size(); ++i) {
        const JsonPlace of_portals = place.member("portals"), at = of_portals.element(i);
        if (!portals[i].is_object()) throw input_error(name, at.text(), "expected a portal");
        const auto corners = points_of(required(portals[i], "corners", at, name), at.member("corners"), name);
        const Json& leads = required(portals[i], "rooms", at, name);
        if (corners.size() != 2 || !leads.is_array() || leads.size() != 2)
            throw input_error(name, at.text(), "expected two corners and two rooms");
        Portal<2> portal;
        for (std::size_t k = 0; k < 2; ++k) {
            portal.corners.push_back(corners[k]);
            if (leads[k].is_null()) continue;
            if (!leads[k].is_number_unsigned() || leads[k].get<std::uint64_t>() >= all.size())
                throw input_error(name, at.text(),
                                  "no room " + leads[k].dump() + ": there are " + std::to_string(all.size()) +
                                      ", from 0; null is the outside");
            portal.rooms[k] = leads[k].get<std::uint32_t>();
        }
        rooms.portals.push_back(portal);
    }
    check_rooms(rooms, name);
    return rooms;
}

void warn_of_unknown(const Json& root, Scene<2>& scene) {
    static constexpr std::array known = {"format", "version",  "dimension", "id",     "title",   "lesson",
                                         "seed",   "segments", "view",      "origin", "objects", "rooms"};
    for (const auto& [key, value] : root.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            scene.warnings.push_back("member \"" + one_line(key, 40) + "\" is not known and was ignored");
}

}  // namespace

Scene<2> scene_from_json(const Json& root, const std::string& name) {
    const JsonPlace top;
    if (!root.is_object()) throw input_error(name, "", std::string("expected an object, found ") + json_kind(root));
    check_header(root, name);

    Scene<2> scene;
    scene.source = "json";
    scene.id = string_member(root, "id", name, name);
    scene.title = string_member(root, "title", scene.id, name);
    scene.lesson = string_member(root, "lesson", "", name);
    if (root.contains("seed")) {
        if (!root["seed"].is_number_unsigned()) throw input_error(name, "/seed", "expected a whole number from 0");
        scene.seed = root["seed"].get<std::uint64_t>();
    }
    if (root.contains("origin")) {
        const auto origin = numbers<2>(root["origin"], top.member("origin"), name);
        scene.origin = {origin[0], origin[1]};
    }

    const Json& segments = required(root, "segments", top, name);
    const JsonPlace place = top.member("segments");
    if (!segments.is_array())
        throw input_error(name, "/segments", std::string("expected an array, found ") + json_kind(segments));
    scene.primitives.reserve(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const auto s = numbers<4>(segments[i], place.element(i), name);
        scene.primitives.push_back({Vec<2>(s[0], s[1]), Vec<2>(s[2], s[3])});
    }
    if (root.contains("objects")) scene.objects = objects_of(root["objects"], scene.primitives.size(), name);
    if (root.contains("rooms")) scene.rooms = rooms_of(root["rooms"], name);
    warn_of_unknown(root, scene);
    clean(scene, Recentre::no, name);
    scene.start_view = root.contains("view") ? view_of(root["view"], name) : default_view(scene.primitives);
    return scene;
}

Scene<2> read_json(std::string_view text, const std::string& name) {
    return scene_from_json(parse_json(text, name), name);
}

std::string write_json(const Scene<2>& scene) {
    // Members in the order in which people read them, a segment a line.
    const auto quoted = [](const std::string& text) {
        return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
    };
    const auto number = [](double value) { return Json(value).dump(); };
    const auto point = [&](const Vec<2>& p) {
        std::string text = "[";
        return text.append(number(p.x)).append(", ").append(number(p.y)).append("]");
    };

    std::string out = "{\n";
    out += "  \"format\": \"sightline-scene\",\n  \"version\": 1,\n  \"dimension\": 2,\n";
    out += "  \"id\": " + quoted(scene.id) + ",\n";
    out += "  \"title\": " + quoted(scene.title) + ",\n";
    out += "  \"lesson\": " + quoted(scene.lesson) + ",\n";
    out += "  \"seed\": " + std::to_string(scene.seed) + ",\n";
    if (scene.origin != Vec<2>(0, 0)) out += "  \"origin\": " + point(scene.origin) + ",\n";
    if (scene.start_view)
        out += "  \"view\": {\"eye\": " + point(scene.start_view->eye) +
               ", \"look_at\": " + point(scene.start_view->look_at) + ", \"fov\": " + number(scene.start_view->fov) +
               "},\n";
    out += "  \"segments\": [";
    const char* separator = "\n";
    for (const Primitive<2>& s : scene.primitives) {
        out += separator;
        out += "    [" + number(s[0].x) + ", " + number(s[0].y) + ", " + number(s[1].x) + ", " + number(s[1].y) + "]";
        separator = ",\n";
    }
    out += "\n  ]";
    if (!scene.objects.empty()) {
        Json names = Json::array();
        for (const std::string& object : scene.objects.names) names.push_back(object);
        out += ",\n  \"objects\": {\"names\": " + names.dump(-1, ' ', false, Json::error_handler_t::replace) +
               ",\n    \"of\": " + Json(scene.objects.of).dump() + "}";
    }
    if (!scene.rooms.empty()) {
        const auto room = [](std::uint32_t number) { return number == none ? "null" : std::to_string(number); };
        out += ",\n  \"rooms\": {\"all\": [";
        separator = "\n";
        for (const Room<2>& one : scene.rooms.all) {
            out += separator + std::string("    {\"name\": ") + quoted(one.name) + ", \"shape\": [";
            for (std::size_t i = 0; i < one.shape.size(); ++i) out += (i ? ", " : "") + point(one.shape[i]);
            out += "]}";
            separator = ",\n";
        }
        out += "\n   ], \"portals\": [";
        separator = "\n";
        for (const Portal<2>& portal : scene.rooms.portals) {
            out += separator + std::string("    {\"rooms\": [") + room(portal.rooms[0]) + ", " + room(portal.rooms[1]) +
                   "], \"corners\": [" + point(portal.corners[0]) + ", " + point(portal.corners[1]) + "]}";
            separator = ",\n";
        }
        out += "\n   ]}";
    }
    return out + "\n}\n";
}

}  // namespace sightline
