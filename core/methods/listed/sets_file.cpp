// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/listed/sets_file.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/base/excerpt.h"
#include "core/base/json_input.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/base/utf8_mark.h"

namespace sightline {

namespace {

constexpr double most_frames = 1e9;

std::uint32_t whole_of(const Json& value, const JsonPlace& place, const std::string& name) {
    const double number = json_number(value, place, name);
    if (number < 0 || number > most_frames || number != static_cast<std::uint32_t>(number))
        throw input_error(name, place.text(), "expected a whole number from 0 on");
    return static_cast<std::uint32_t>(number);
}

template <int D>
Vec<D> point_in(const Json& object, const char* key, const JsonPlace& at, const std::string& name) {
    const JsonPlace place = at.member(key);
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array() || found->size() != D)
        throw input_error(name, place.text(), "expected an array of " + std::to_string(D) + " numbers");
    Vec<D> point;
    for (int i = 0; i < D; ++i)
        point[i] = json_number((*found)[static_cast<std::size_t>(i)], place.element(static_cast<std::size_t>(i)), name);
    return point;
}

/// The array of that name; empty where there is none.
const Json& list_in(const Json& object, const char* key, const JsonPlace& at, const std::string& name) {
    static const Json nothing = Json::array();
    const auto found = object.find(key);
    if (found == object.end()) return nothing;
    if (!found->is_array())
        throw input_error(name, at.member(key).text(), std::string("expected an array, found ") + json_kind(*found));
    return *found;
}

template <int D>
SetFrame<D> frame_of(const Json& json, const JsonPlace& at, const std::string& name) {
    if (!json.is_object())
        throw input_error(name, at.text(), std::string("expected an object, found ") + json_kind(json));
    SetFrame<D> frame;
    if (json.contains("frame")) frame.number = whole_of(json["frame"], at.member("frame"), name);
    if (json.contains("view")) {
        const JsonPlace place = at.member("view");
        const Json& view = json["view"];
        if (!view.is_object()) throw input_error(name, place.text(), "expected an object");
        frame.view = ViewSpec<D>{point_in<D>(view, "eye", place, name), point_in<D>(view, "look_at", place, name)};
        if (view.contains("fov")) frame.view->fov = json_number(view["fov"], place.member("fov"), name);
    }
    if (!frame.number && !frame.view) throw input_error(name, at.text(), "needs \"frame\", \"view\" or both");
    if (!json.contains("rendered") && !json.contains("rendered_objects"))
        throw input_error(name, at.text(), "needs \"rendered\", \"rendered_objects\" or both");
    const JsonPlace ids = at.member("rendered"), names = at.member("rendered_objects");
    std::size_t index = 0;
    for (const Json& id : list_in(json, "rendered", at, name))
        frame.primitives.push_back(whole_of(id, ids.element(index++), name));
    index = 0;
    for (const Json& object : list_in(json, "rendered_objects", at, name)) {
        if (!object.is_string()) throw input_error(name, names.element(index).text(), "expected a name");
        frame.objects.push_back(object.get<std::string>());
        ++index;
    }
    return frame;
}

template <int D>
SetsFile<D> read_json(std::string_view text, const std::string& name) {
    const Json root = parse_json(text, name);
    const JsonPlace top;
    if (root.value("format", Json()) != "sightline-sets")
        throw input_error(name, "/format", "expected \"sightline-sets\"");
    if (root.value("version", Json()) != 1) throw input_error(name, "/version", "expected 1");
    if (root.value("dimension", Json()) != D)
        throw input_error(name, "/dimension", "expected " + std::to_string(D) + ", as the scene has");
    SetsFile<D> sets;
    if (root.contains("origin")) sets.origin = point_in<D>(root, "origin", top, name);
    const JsonPlace place = top.member("frames");
    std::size_t index = 0;
    for (const Json& frame : list_in(root, "frames", top, name))
        sets.frames.push_back(frame_of<D>(frame, place.element(index++), name));
    return sets;
}

/// The fields of a line of CSV (RFC 4180); quoted ones may not go on in the next line. False for a quote that does not
/// end.
bool split_line(std::string_view line, std::vector<std::string>& fields) {
    fields.clear();
    for (std::size_t at = 0;; ++at) {
        std::string& field = fields.emplace_back();
        if (at < line.size() && line[at] == '"') {
            for (++at;; ++at) {
                if (at >= line.size()) return false;
                if (line[at] != '"') {
                    field += line[at];
                } else if (at + 1 < line.size() && line[at + 1] == '"') {
                    field += line[++at];
                } else {
                    break;
                }
            }
            ++at;
        } else {
            while (at < line.size() && line[at] != ',') field += line[at++];
        }
        if (at >= line.size()) return true;
        if (line[at] != ',') return false;
    }
}

template <int D>
SetsFile<D> read_csv(std::string_view text, const std::string& name) {
    static constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    std::vector<std::string> fields;
    std::map<std::string, std::size_t> columns;
    std::map<std::vector<std::string>, std::size_t> index_of;  // of a frame, by what names it
    SetsFile<D> sets;
    std::size_t line_number = 0;
    const auto fail = [&](const std::string& reason) {
        throw input_error(name, "line " + std::to_string(line_number), reason);
    };
    text = without_mark(text);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++line_number;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.empty()) continue;
        if (!split_line(line, fields)) fail("a quote is out of place");
        if (columns.empty()) {
            for (std::size_t i = 0; i < fields.size(); ++i) columns.emplace(fields[i], i);
            if (!columns.contains("frame") && !columns.contains("eye_x"))
                fail("the first line names the columns: there must be frame, or eye_x, eye_y and so on");
            if (!columns.contains("primitive") && !columns.contains("object"))
                fail("the first line names the columns: there must be primitive or object");
            continue;
        }
        if (fields.size() != columns.size())
            fail("has " + counted(fields.size(), "field") + ", not " + std::to_string(columns.size()));
        const auto field = [&](const std::string& column) -> std::string_view {
            const auto at = columns.find(column);
            return at == columns.end() ? std::string_view() : std::string_view(fields[at->second]);
        };
        const auto number = [&](const std::string& column) {
            const auto value = parse_number(field(column));
            if (!value) fail(column + ": '" + excerpt(field(column)) + "' is no number");
            return value.value_or(0);
        };
        const auto whole = [&](const std::string& column) {
            const auto value = parse_whole(field(column));
            if (!value) fail(column + ": '" + excerpt(field(column)) + "' is no whole number");
            return value.value_or(0);
        };
        SetFrame<D> frame;
        std::vector<std::string> key;
        if (!field("frame").empty()) {
            frame.number = whole("frame");
            key.emplace_back(field("frame"));
        }
        if (!field("eye_x").empty()) {
            frame.view.emplace();
            for (int i = 0; i < D; ++i) {
                const std::string axis(axes[static_cast<std::size_t>(i)]);
                frame.view->eye[i] = number("eye_" + axis);
                frame.view->look_at[i] = number("look_at_" + axis);
                key.insert(key.end(), {std::string(field("eye_" + axis)), std::string(field("look_at_" + axis))});
            }
            if (columns.contains("fov")) frame.view->fov = number("fov");
            key.emplace_back(field("fov"));
        }
        if (key.empty()) fail("names no frame");
        const auto [at, is_new] = index_of.try_emplace(key, sets.frames.size());
        if (is_new) sets.frames.push_back(frame);
        SetFrame<D>& into = sets.frames[at->second];
        if (columns.contains("rendered") && field("rendered") == "0") continue;
        if (!field("primitive").empty())
            into.primitives.push_back(whole("primitive"));
        else if (!field("object").empty())
            into.objects.emplace_back(field("object"));
    }
    return sets;
}

}  // namespace

template <int D>
SetsFile<D> read_sets(std::string_view text, const std::string& name) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) throw input_error(name, "", "is empty");
    SetsFile<D> sets = text[first] == '{' ? read_json<D>(text, name) : read_csv<D>(text, name);
    if (sets.frames.empty()) throw input_error(name, "", "lists no frame");
    return sets;
}

template SetsFile<2> read_sets<2>(std::string_view, const std::string&);
template SetsFile<3> read_sets<3>(std::string_view, const std::string&);

}  // namespace sightline
