// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/state_file.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/scene/json_input.h"
#include "core/scene/load.h"
#include "core/scene/read_json.h"
#include "core/scene/text.h"

namespace sightline {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson view_json(const ViewSpec<2>& view) {
    return {{"eye", {view.eye.x, view.eye.y}}, {"look_at", {view.look_at.x, view.look_at.y}}, {"fov", view.fov}};
}

Vec<2> read_point(const Json& json) {
    if (json.size() != 2) throw InputError("a point is no pair of numbers");
    return {json.at(0).get<double>(), json.at(1).get<double>()};
}

/// Only whole numbers: the library would round and wrap others.
std::uint32_t read_count(const Json& json) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() > none)
        throw InputError("'" + json.dump(-1, ' ', false, Json::error_handler_t::replace) +
                         "' is not a whole number from 0 to " + std::to_string(none));
    return json.get<std::uint32_t>();
}

std::uint32_t read_count(const Json& object, const char* key, std::uint32_t otherwise) {
    return object.contains(key) ? read_count(object.at(key)) : otherwise;
}

/// The elements of an array that may be missing.
const Json& list(const Json& object, const char* key) {
    static const Json nothing = Json::array();
    if (!object.contains(key)) return nothing;
    if (!object.at(key).is_array()) throw InputError("\"" + std::string(key) + "\" is no list");
    return object.at(key);
}

ViewSpec<2> read_view(const Json& json) {
    return {read_point(json.at("eye")), read_point(json.at("look_at")), json.at("fov").get<double>()};
}

OrderedJson note_json(const Note<2>& note) {
    OrderedJson json{{"kind", note_kind_words[static_cast<std::size_t>(note.kind)]},
                     {"anchor", note_anchor_words[static_cast<std::size_t>(note.anchor)]},
                     {"text", note.text},
                     {"offset_pt", {note.offset_pt.x, note.offset_pt.y}}};
    if (note.anchor == Note<2>::Anchor::point)
        json["point"] = {note.point.x, note.point.y};
    else
        json["index"] = note.index;
    if (note.kind == Note<2>::Kind::callout) json["number"] = note.number;
    if (note.first_step > 0) json["first_step"] = note.first_step;
    if (note.last_step != none) json["last_step"] = note.last_step;
    return json;
}

template <typename Enum, std::size_t n>
Enum read_word(const Json& json, const std::array<std::string_view, n>& known) {
    const std::string word = json.get<std::string>();
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) throw InputError("unknown word '" + word + "'");
    return static_cast<Enum>(found - known.begin());
}

Note<2> read_note(const Json& json) {
    Note<2> note;
    note.kind = read_word<Note<2>::Kind>(json.at("kind"), note_kind_words);
    note.anchor = read_word<Note<2>::Anchor>(json.at("anchor"), note_anchor_words);
    note.text = json.at("text").get<std::string>();
    note.offset_pt = read_point(json.at("offset_pt"));
    if (note.anchor == Note<2>::Anchor::point)
        note.point = read_point(json.at("point"));
    else
        note.index = read_count(json.at("index"));
    note.number = read_count(json, "number", 0);
    note.first_step = read_count(json, "first_step", 0);
    note.last_step = read_count(json, "last_step", none);
    return note;
}

Scene<2> read_scene(const Json& json, const std::string& name, bool two_sided) {
    Scene<2> scene;
    if (json.contains("embedded")) {
        scene = scene_from_json(json.at("embedded"), name + ": scene");
        // What a scene's own file does not say.
        scene.source = json.value("source", scene.source);
        if (json.contains("dropped")) {
            const Json& dropped = json.at("dropped");
            scene.dropped = {read_count(dropped, "degenerate", 0), read_count(dropped, "duplicate", 0),
                             read_count(dropped, "not_finite", 0)};
        }
        if (!json.contains("hash")) return scene;  // written by hand
    } else {
        // A file that is not where it was may lie beside the state file.
        std::string file = json.value("name", json.at("id").get<std::string>());
        const auto exists = [](const std::string& path) {
            std::error_code error;
            return std::filesystem::exists(path.substr(0, path.rfind('#')), error);
        };
        const std::string beside = (std::filesystem::path(name).parent_path() / file).string();
        if (!exists(file) && exists(beside)) file = beside;
        scene = load_scene(file, {.two_sided = two_sided});
    }
    if (hash_text(scene_hash(scene)) != json.at("hash").get<std::string>())
        throw InputError("scene '" + scene.id + "' is not the one the state was made with (its hash differs)");
    return scene;
}

OpenedState read_state(const Json& json, const std::string& name, std::span<const Method<2>> methods) {
    if (json.at("format") != "sightline-state") throw InputError("\"format\" is not \"sightline-state\"");
    if (json.at("version") != 1) throw InputError("\"version\" is not 1, the only one known");
    Settings settings;
    for (const auto& [field, value] : json.at("settings").items())
        apply_setting(settings, field + "=" + value.get<std::string>());
    auto scene = std::make_shared<const Scene<2>>(read_scene(json.at("scene"), name, settings.two_sided == Switch::on));
    OpenedState opened{Session<2>(std::move(scene), read_view(json.at("view")), settings, methods), {}, {}};
    Session<2>& session = opened.session;
    if (json.contains("time_stop")) session.set_time_stop(read_count(json.at("time_stop")));
    const std::uint32_t step = read_count(json.at("step"));
    session.seek(step);
    if (session.position() != step)
        opened.warnings.push_back(name + ": the traversal ends at step " + std::to_string(session.position()) +
                                  ", before the saved step " + std::to_string(step));
    else if (json.contains("state_hash") && json.at("state_hash").get<std::string>() != hash_text(session.hash()))
        opened.warnings.push_back(name + ": step " + std::to_string(step) + " differs from what was saved");
    if (json.contains("display_view")) {
        session.freeze();
        session.set_view(read_view(json.at("display_view")));
    }
    for (const Json& bookmark : list(json, "bookmarks"))
        session.bookmarks.push_back({read_count(bookmark.at("step")), bookmark.at("label").get<std::string>()});
    for (const Json& note : list(json, "notes")) {
        session.notes.push_back(read_note(note));
        const Note<2>& read = session.notes.back();
        if ((read.anchor == Note<2>::Anchor::cell && read.index >= session.cells().cell_count()) ||
            (read.anchor == Note<2>::Anchor::primitive && read.index >= session.scene().primitives.size()))
            throw InputError("a note is anchored to something that does not exist");
    }
    if (json.contains("figure")) {
        const Json& figure = json.at("figure");
        opened.figure.size = figure.at("size").get<std::string>();
        opened.figure.font_pt = figure.at("font_pt").get<double>();
        opened.figure.panels = figure.at("panels").get<std::vector<std::string>>();
    }
    session.selected_cell = read_count(json, "selected_cell", none);
    if (session.selected_cell != none && session.selected_cell >= session.cells().cell_count())
        throw InputError("\"selected_cell\" does not exist");
    return opened;
}

}  // namespace

std::string state_json(const Session<2>& session, const FigureSpec& figure) {
    const Scene<2>& scene = session.scene();
    OrderedJson scene_part{{"id", scene.id},
                           {"seed", scene.seed},
                           {"hash", hash_text(scene_hash(scene))},
                           {"source", scene.source},
                           {"dropped",
                            {{"degenerate", scene.dropped.degenerate},
                             {"duplicate", scene.dropped.duplicate},
                             {"not_finite", scene.dropped.not_finite}}}};
    if (std::string embedded = write_json(scene); embedded.size() <= embed_limit_bytes)
        scene_part["embedded"] = OrderedJson::parse(embedded);
    else
        scene_part["name"] = scene.name.empty() ? scene.id : scene.name;
    OrderedJson settings;
    for (const SettingRow& row : settings_table()) settings[std::string(row.name)] = row.get(session.settings());
    OrderedJson json{{"format", "sightline-state"},
                     {"version", 1},
                     {"scene", std::move(scene_part)},
                     {"settings", std::move(settings)},
                     {"view", view_json(session.culling_view())},
                     {"figure", {{"size", figure.size}, {"font_pt", figure.font_pt}, {"panels", figure.panels}}},
                     {"step", session.position()},
                     {"state_hash", hash_text(session.hash())}};
    if (session.frozen()) json["display_view"] = view_json(session.display_view());
    if (session.time_stop() != none) json["time_stop"] = session.time_stop();
    if (session.selected_cell != none) json["selected_cell"] = session.selected_cell;
    for (const Bookmark& bookmark : session.bookmarks)
        json["bookmarks"].push_back({{"step", bookmark.step}, {"label", bookmark.label}});
    for (const Note<2>& note : session.notes) json["notes"].push_back(note_json(note));
    return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

OpenedState open_state(std::string_view text, const std::string& name, std::span<const Method<2>> methods) {
    try {
        return read_state(parse_json(text, name), name, methods);
    } catch (const Json::exception& error) {
        std::string why = error.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: …"
        if (const std::size_t end = why.find("] "); end != std::string::npos) why.erase(0, end + 2);
        throw input_error(name, "", "not a state file: " + why);
    } catch (const InputError& error) {
        const std::string why = error.what();
        if (why.starts_with(name + ": ")) throw InputError(one_line(why, 4096));
        throw input_error(name, "", why);
    }
}

}  // namespace sightline
