// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/flight_path.h"

#include "core/base/json_input.h"
#include "core/base/text.h"
#include "core/scene/clean.h"
#include "core/scene/flight_path_csv.h"

namespace sightline {

std::vector<std::size_t> spread_frames(std::size_t count, std::size_t wanted) {
    std::vector<std::size_t> frames;
    const std::size_t taken = std::min(count, wanted);
    // Rounded to the nearest; the quotient fits as long as paths have fewer than 2^32 frames.
    for (std::size_t i = 0; i < taken; ++i)
        frames.push_back(taken == 1 ? 0 : (2 * i * (count - 1) + taken - 1) / (2 * (taken - 1)));
    return frames;
}

namespace {

const Json& required(const Json& object, const char* key, const JsonPlace& place, const std::string& name) {
    const auto found = object.find(key);
    if (found == object.end()) throw input_error(name, place.text(), std::string("\"") + key + "\" is missing");
    return *found;
}

std::string string_member(const Json& root, const char* key, const std::string& name) {
    const auto found = root.find(key);
    if (found == root.end()) return "";
    if (!found->is_string())
        throw input_error(name, std::string("/") + key, std::string("expected a string, found ") + json_kind(*found));
    return found->get<std::string>();
}

template <int D>
Vec<D> point_of(const Json& value, const JsonPlace& place, const std::string& name) {
    if (!value.is_array() || value.size() != D)
        throw input_error(name, place.text(),
                          "expected an array of " + std::to_string(D) + " numbers, found " +
                              (value.is_array() ? "one of " + std::to_string(value.size()) : json_kind(value)));
    Vec<D> point;
    for (int i = 0; i < D; ++i)
        point[i] = json_number(value[static_cast<std::size_t>(i)], place.element(static_cast<std::size_t>(i)), name);
    return point;
}

template <int D>
ViewSpec<D> frame_of(const Json& value, const JsonPlace& place, const std::string& name) {
    if (!value.is_object())
        throw input_error(name, place.text(), std::string("expected an object, found ") + json_kind(value));
    ViewSpec<D> frame;
    frame.eye = point_of<D>(required(value, "eye", place, name), place.member("eye"), name);
    frame.look_at = point_of<D>(required(value, "look_at", place, name), place.member("look_at"), name);
    if (value.contains("fov")) frame.fov = json_number(value["fov"], place.member("fov"), name);
    check_view(frame, name, place.text());
    return frame;
}

std::string quoted(const std::string& text) { return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace); }

template <int D>
std::string point_text(const Vec<D>& p) {
    std::string text = "[";
    for (int i = 0; i < D; ++i) text += (i == 0 ? "" : ", ") + Json(p[i]).dump();
    return text + "]";
}

}  // namespace

template <int D>
FlightPath<D> read_path(std::string_view text, const std::string& name) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    if (first != std::string_view::npos && text[first] != '{' && text[first] != '[')
        return read_csv_path<D>(text, name);
    const Json root = parse_json(text, name);
    const JsonPlace top;
    if (!root.is_object()) throw input_error(name, "", std::string("expected an object, found ") + json_kind(root));
    if (required(root, "format", top, name) != "sightline-path")
        throw input_error(name, "/format", "expected \"sightline-path\"");
    if (required(root, "version", top, name) != 1)
        throw input_error(name, "/version", "expected 1; this program reads no other version");
    if (required(root, "dimension", top, name) != D)
        throw input_error(name, "/dimension", "expected " + std::to_string(D));

    FlightPath<D> path;
    path.id = string_member(root, "id", name);
    path.scene = string_member(root, "scene", name);
    if (root.contains("origin")) path.origin = point_of<D>(root["origin"], top.member("origin"), name);
    const Json& frames = required(root, "frames", top, name);
    const JsonPlace place = top.member("frames");
    if (!frames.is_array())
        throw input_error(name, "/frames", std::string("expected an array, found ") + json_kind(frames));
    if (frames.empty()) throw input_error(name, "/frames", "a path needs one frame at least");
    path.frames.reserve(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        path.frames.push_back(frame_of<D>(frames[i], place.element(i), name));
    return path;
}

template <int D>
std::string write_path(const FlightPath<D>& path) {
    std::string out = "{\n";
    out += "  \"format\": \"sightline-path\",\n  \"version\": 1,\n  \"dimension\": " + std::to_string(D) + ",\n";
    out += "  \"id\": " + quoted(path.id) + ",\n";
    out += "  \"scene\": " + quoted(path.scene) + ",\n";
    out += "  \"origin\": " + point_text<D>(path.origin) + ",\n";
    out += "  \"frames\": [";
    const char* separator = "\n";
    for (const ViewSpec<D>& frame : path.frames) {
        out += separator;
        out += "    {\"eye\": " + point_text<D>(frame.eye) + ", \"look_at\": " + point_text<D>(frame.look_at) +
               ", \"fov\": " + Json(frame.fov).dump() + "}";
        separator = ",\n";
    }
    return out + "\n  ]\n}\n";
}

template FlightPath<2> read_path<2>(std::string_view, const std::string&);
template FlightPath<3> read_path<3>(std::string_view, const std::string&);
template std::string write_path<2>(const FlightPath<2>&);
template std::string write_path<3>(const FlightPath<3>&);

}  // namespace sightline
