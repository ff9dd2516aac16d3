// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/state_file.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/scene/load.h"
#include "core/scene/read_json.h"

namespace sightline {

namespace {

using Json = nlohmann::ordered_json;

Json view_json(const ViewSpec<2>& view) {
    return {{"eye", {view.eye.x, view.eye.y}}, {"look_at", {view.look_at.x, view.look_at.y}}, {"fov", view.fov}};
}

Vec<2> read_point(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

ViewSpec<2> read_view(const Json& json) {
    return {read_point(json.at("eye")), read_point(json.at("look_at")), json.at("fov").get<double>()};
}

Json note_json(const Note<2>& note) {
    Json json{{"kind", note_kind_words[static_cast<std::size_t>(note.kind)]},
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
        note.index = json.at("index").get<std::uint32_t>();
    note.number = json.value("number", 0u);
    note.first_step = json.value("first_step", 0u);
    note.last_step = json.value("last_step", none);
    return note;
}

Scene<2> read_scene(const Json& json, const std::string& name, bool two_sided) {
    if (json.contains("embedded")) return read_json(json.at("embedded").dump(), name + ": scene");
    // A file that is not where it was may lie beside the state file.
    std::string id = json.at("id").get<std::string>();
    const auto exists = [](const std::string& path) {
        std::error_code error;
        return std::filesystem::exists(path.substr(0, path.rfind('#')), error);
    };
    const std::string beside = (std::filesystem::path(name).parent_path() / id).string();
    if (!exists(id) && exists(beside)) id = beside;
    Scene<2> scene = load_scene(id, {.two_sided = two_sided});
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
    if (json.contains("time_stop")) session.set_time_stop(json.at("time_stop").get<std::uint32_t>());
    const auto step = json.at("step").get<std::uint32_t>();
    session.seek(step);
    if (session.position() != step)
        opened.warnings.push_back(name + ": the traversal ends at step " + std::to_string(session.position()) +
                                  ", before the saved step " + std::to_string(step));
    else if (json.contains("state_hash") && json.at("state_hash") != hash_text(session.hash()))
        opened.warnings.push_back(name + ": step " + std::to_string(step) + " differs from what was saved");
    if (json.contains("display_view")) {
        session.freeze();
        session.set_view(read_view(json.at("display_view")));
    }
    for (const Json& bookmark : json.value("bookmarks", Json::array()))
        session.bookmarks.push_back(
            {bookmark.at("step").get<std::uint32_t>(), bookmark.at("label").get<std::string>()});
    for (const Json& note : json.value("notes", Json::array())) {
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
    session.selected_cell = json.value("selected_cell", none);
    if (session.selected_cell != none && session.selected_cell >= session.cells().cell_count())
        throw InputError("\"selected_cell\" does not exist");
    return opened;
}

}  // namespace

std::string state_json(const Session<2>& session, const FigureSpec& figure) {
    const Scene<2>& scene = session.scene();
    Json scene_part{{"id", scene.id}, {"seed", scene.seed}, {"hash", hash_text(scene_hash(scene))}};
    if (std::string embedded = write_json(scene); embedded.size() <= embed_limit_bytes)
        scene_part["embedded"] = Json::parse(embedded);
    Json settings;
    for (const SettingRow& row : settings_table()) settings[std::string(row.name)] = row.get(session.settings());
    Json json{{"format", "sightline-state"},
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
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

OpenedState open_state(std::string_view text, const std::string& name, std::span<const Method<2>> methods) {
    try {
        return read_state(Json::parse(text), name, methods);
    } catch (const Json::exception& error) {
        std::string why = error.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: …"
        if (const std::size_t end = why.find("] "); end != std::string::npos) why.erase(0, end + 2);
        throw InputError(name + ": not a state file: " + why);
    } catch (const InputError& error) {
        const std::string why = error.what();
        throw InputError(why.starts_with(name + ":") ? why : name + ": " + why);
    }
}

}  // namespace sightline
