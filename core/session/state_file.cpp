// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/state_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/percent.h"
#include "core/base/text.h"
#include "core/scene/read/load.h"
#include "core/scene/read/read_json.h"
#include "core/session/condition.h"
#include "core/session/embedded_scene.h"
#include "core/session/start_settings.h"
#include "core/session/state_scene.h"

namespace sightline {

namespace {

using OrderedJson = nlohmann::ordered_json;

template <int D>
OrderedJson point_json(const Vec<D>& point) {
    OrderedJson json = OrderedJson::array();
    for (int i = 0; i < D; ++i) json.push_back(point[i]);
    return json;
}

template <int D>
OrderedJson view_json(const ViewSpec<D>& view) {
    return {{"eye", point_json<D>(view.eye)}, {"look_at", point_json<D>(view.look_at)}, {"fov", view.fov}};
}

template <int D>
Vec<D> read_point(const Json& json) {
    if (json.size() != D)
        throw InputError(D == 2 ? "a point is not a pair of numbers" : "a point is not three numbers");
    Vec<D> point;
    for (int i = 0; i < D; ++i) point[i] = json.at(static_cast<std::size_t>(i)).get<double>();
    return point;
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
    if (!object.at(key).is_array()) throw InputError("\"" + std::string(key) + "\" is not a list");
    return object.at(key);
}

std::string reason_of(const Json::exception& error) {
    std::string why = error.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: …"
    if (const std::size_t end = why.find("] "); end != std::string::npos) why.erase(0, end + 2);
    return why;
}

std::string why_not(const Json::exception& error) { return "not a state file: " + reason_of(error); }

/// What `read` makes of a member. Its errors get the member's place: "/view/eye: reason".
template <typename Read>
auto at_member(const Json& json, const std::string& key, const Read& read) {
    try {
        return read(json.at(key));
    } catch (const Json::exception& error) {
        throw InputError("/" + key + ": " + reason_of(error));
    } catch (const InputError& error) {
        const std::string why = error.what();
        throw InputError("/" + key + (why.starts_with('/') ? "" : ": ") + why);
    }
}

template <int D>
ViewSpec<D> read_view(const Json& json) {
    return {at_member(json, "eye", read_point<D>), at_member(json, "look_at", read_point<D>),
            at_member(json, "fov", [](const Json& fov) { return fov.get<double>(); })};
}

template <int D>
OrderedJson note_json(const Note<D>& note) {
    OrderedJson json{{"kind", note_kind_words[static_cast<std::size_t>(note.kind)]},
                     {"anchor", note_anchor_words[static_cast<std::size_t>(note.anchor)]},
                     {"text", note.text},
                     {"offset_pt", {note.offset_pt.x, note.offset_pt.y}}};
    if (note.anchor == Note<D>::Anchor::point)
        json["point"] = point_json<D>(note.point);
    else
        json["index"] = note.index;
    if (note.kind == Note<D>::Kind::callout) json["number"] = note.number;
    // Files from before callouts could be moved have an offset that meant nothing.
    if (note.kind == Note<D>::Kind::callout) json["moved"] = note.offset_pt != Vec<2>(0);
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

template <int D>
Note<D> read_note(const Json& json) {
    Note<D> note;
    note.kind = read_word<typename Note<D>::Kind>(json.at("kind"), note_kind_words);
    note.anchor = read_word<typename Note<D>::Anchor>(json.at("anchor"), note_anchor_words);
    note.text = json.at("text").get<std::string>();
    note.offset_pt = read_point<2>(json.at("offset_pt"));
    if (note.kind == Note<D>::Kind::callout && !json.value("moved", false)) note.offset_pt = {0, 0};
    if (note.anchor == Note<D>::Anchor::point)
        note.point = read_point<D>(json.at("point"));
    else
        note.index = read_count(json.at("index"));
    note.number = read_count(json, "number", 0);
    note.first_step = read_count(json, "first_step", 0);
    note.last_step = read_count(json, "last_step", none);
    return note;
}

template <int D>
Scene<D> read_scene(const Json& json, const std::string& name, LoadOptions options) {
    if (json.contains("embedded")) {
        Scene<D> scene = embedded_scene<D>(json, name + ": scene");
        if (json.contains("hash") &&  // else written by hand
            hash_text(scene_hash(scene)) != json.at("hash").get<std::string>())
            throw InputError("scene '" + scene.id + "' is not the one the state was made with (its hash differs)");
        return scene;
    }
    std::string file = json.value("name", json.at("id").get<std::string>());
    if (json.contains("name_bytes")) file = percent_decoded(json.at("name_bytes").get<std::string>());
    options.choose_view = false;  // the state has its own
    return find_state_scene<D>(file, json.at("hash").get<std::string>(), name, options);
}

/// An index into something of that size; none when it is missing.
std::uint32_t read_selected(const Json& json, const char* key, std::size_t size) {
    const std::uint32_t selected = read_count(json, key, none);
    if (selected != none && selected >= size) throw InputError("\"" + std::string(key) + "\" does not exist");
    return selected;
}

template <int D>
void read_breakpoints(const Json& json, Session<D>& session) {
    for (const Json& breakpoint : list(json, "breakpoints")) {
        session.breakpoints.push_back({breakpoint.at("condition").get<std::string>(), breakpoint.at("on").get<bool>()});
        condition_for(session, session.breakpoints.back().condition);  // throws for what is none
    }
}

Settings settings_of_state(const Json& json) {
    Settings settings;
    for (const auto& [field, value] : json.items()) apply_setting(settings, field + "=" + value.get<std::string>());
    return settings;
}

FigureSpec figure_of_state(const Json& json) {
    FigureSpec figure;
    figure.size = json.at("size").get<std::string>();
    figure.font_pt = json.at("font_pt").get<double>();
    figure.panels = json.at("panels").get<std::vector<std::string>>();
    figure.dpi = json.value("dpi", FigureSpec{}.dpi);
    figure.columns = read_count(json, "columns", 0);
    return figure;
}

/// The scene of a state that has none of its own, or another one in place of it.
template <int D>
struct GivenScene {
    std::shared_ptr<const Scene<D>> scene{};
    bool replaces = false;  ///< also that of a state that has one
    bool differs = false;   ///< from the one that the state was made with
};

template <int D>
OpenedState<D> read_state(const Json& json, const std::string& name, std::span<const Method<D>> methods,
                          const DrawIds& draw_ids, const Progress& progress, GivenScene<D>& given) {
    if (json.at("format") != "sightline-state") throw InputError("\"format\" is not \"sightline-state\"");
    if (json.at("version") != 1) throw InputError("\"version\" is not 1, the only one known");
    if (const int dimension = json.value("dimension", 2); dimension != D)
        throw InputError("the state is one of " + std::to_string(dimension) + "D: open it with viewer" +
                         std::to_string(dimension) + "d");
    Settings settings = settings_of_state(json.at("settings"));
    // Files from before the setting say nothing, and meant this.
    if (D == 3 && !json.at("settings").contains("up")) settings.up = Up::format;
    if (given.replaces)
        given.differs = json.at("scene").value("hash", "") != hash_text(scene_hash(*given.scene));
    else if (!given.scene || json.contains("scene"))
        given = {
            std::make_shared<const Scene<D>>(read_scene<D>(json.at("scene"), name, read_options(settings, progress)))};
    OpenedState<D> opened{
        Session<D>(given.scene, at_member(json, "view", read_view<D>), settings, methods, draw_ids, progress), {}, {}};
    Session<D>& session = opened.session;
    if (json.contains("lane")) {
        std::vector<ViewSpec<D>> lane;
        for (const Json& view : list(json, "lane")) lane.push_back(read_view<D>(view));
        session.set_lane(std::move(lane));
    }
    if (json.contains("figure")) opened.figure = figure_of_state(json.at("figure"));
    read_breakpoints(json, session);
    if (given.differs) {  // the rest is about steps, cells and primitives of another scene
        opened.of_another_scene = true;
        opened.warnings.push_back(
            name + ": opened with another scene than it was made with: its view and settings, at " + "step 0");
        return opened;
    }
    if (json.contains("time_stop")) session.set_time_stop(read_count(json.at("time_stop")));
    const std::uint32_t step = read_count(json.at("step"));
    session.seek(step);
    if (session.position() != step)
        opened.warnings.push_back(name + ": the traversal ends at step " + std::to_string(session.position()) +
                                  ", before the saved step " + std::to_string(step));
    else if (json.contains("state_hash") && json.at("state_hash").get<std::string>() != hash_text(session.hash()))
        opened.warnings.push_back(name + ": step " + std::to_string(step) + " differs from what was saved");
    if (json.contains("display_view")) {
        // Frozen as a whole first: to set the display view must not move the culling view.
        session.freeze();
        session.set_view(at_member(json, "display_view", read_view<D>));
        if (json.contains("frozen")) session.freeze(read_word<Frozen>(json.at("frozen"), frozen_words));
    }
    for (const Json& bookmark : list(json, "bookmarks"))
        session.bookmarks.push_back({read_count(bookmark.at("step")), bookmark.at("label").get<std::string>()});
    for (const Json& note : list(json, "notes")) {
        session.notes.push_back(read_note<D>(note));
        const Note<D>& read = session.notes.back();
        if ((read.anchor == Note<D>::Anchor::cell && read.index >= session.cells().cell_count()) ||
            (read.anchor == Note<D>::Anchor::primitive && read.index >= session.scene().primitives.size()))
            throw InputError("a note is anchored to something that does not exist");
    }
    session.selected_cell = read_selected(json, "selected_cell", session.cells().cell_count());
    session.selected_primitive = read_selected(json, "selected_primitive", session.scene().primitives.size());
    const BoxTree<D>* const tree = session.traversal().boxes();
    session.selected_node = read_selected(json, "selected_node", tree ? tree->nodes.size() : 0);
    session.selected_plane = read_count(json, "selected_plane", none);
    return opened;
}

/// The state that stands beside the first one, if there is one.
template <int D>
void read_other(const Json& json, const std::string& name, std::span<const Method<D>> methods, const DrawIds& draw_ids,
                const Progress& progress, bool scene_differs, OpenedState<D>& opened) {
    if (json.contains("align")) opened.align = read_word<Align>(json.at("align"), align_words);
    if (!json.contains("other")) return;
    const std::string place = name + ": other";
    try {
        GivenScene<D> shared{opened.session.shared_scene(), false, scene_differs};
        OpenedState<D> other = read_state<D>(json.at("other"), place, methods, draw_ids, progress, shared);
        opened.other = std::move(other.session);
        opened.warnings.insert(opened.warnings.end(), other.warnings.begin(), other.warnings.end());
    } catch (const Json::exception& error) {
        throw InputError(place + ": " + why_not(error));
    } catch (const InputError& error) {
        const std::string why = error.what();
        throw InputError(why.starts_with(place) ? why : place + ": " + why);
    }
}

/// Whether the scene lies in the state itself.
template <int D>
bool embeds(const Scene<D>& scene, Carry carry) {
    if (scene.source == "edited") return true;
    if (carry == Carry::what_no_generator_makes) return scene.source != "generated" || scene.name.empty();
    if constexpr (D == 2) return write_json(scene).size() <= embed_limit_bytes;
    return false;
}

template <int D>
OrderedJson scene_part(const Scene<D>& scene, Carry carry) {
    OrderedJson json{{"id", scene.id},
                     {"seed", scene.seed},
                     {"hash", hash_text(scene_hash(scene))},
                     {"source", scene.source},
                     {"dropped",
                      {{"degenerate", scene.dropped.degenerate},
                       {"duplicate", scene.dropped.duplicate},
                       {"not_finite", scene.dropped.not_finite}}}};
    if (embeds(scene, carry)) {
        embed_scene(scene, json);
        return json;
    }
    const std::string& file = scene.name.empty() ? scene.id : scene.name;
    json["name"] = file;
    // Names of files are bytes, of which JSON keeps those that are text.
    if (clean_text(file) != file) json["name_bytes"] = percent_encoded(file);
    return json;
}

/// With the parameters that the table of settings does not have: those of a method from another table.
template <int D>
std::string method_text(const Session<D>& session) {
    VariantText text{session.settings().method, {}};
    const auto known = all_parameters();
    for (const ParameterRow* row : session.method().parameters)
        if (std::none_of(known.begin(), known.end(), [&](const auto* other) { return other->name == row->name; }))
            text.assignments.emplace_back(row->name, session.settings().parameters.text(*row));
    return text.text();
}

/// All but the scene and the figure, which two states may share.
template <int D>
OrderedJson session_part(const Session<D>& session) {
    OrderedJson settings;
    for (const SettingRow& row : settings_table())
        if (row.dimension == 0 || row.dimension == D) settings[std::string(row.name)] = row.get(session.settings());
    settings["method"] = method_text(session);
    OrderedJson json{{"settings", std::move(settings)},
                     {"view", view_json<D>(session.culling_view())},
                     {"step", session.position()},
                     {"state_hash", hash_text(session.hash())}};
    if (session.frozen()) json["display_view"] = view_json<D>(session.display_view());
    if (session.frozen() && session.frozen_part() != Frozen::all)
        json["frozen"] = frozen_words[static_cast<std::size_t>(session.frozen_part())];
    for (const ViewSpec<D>& view : session.lane()) json["lane"].push_back(view_json<D>(view));
    if (session.time_stop() != none) json["time_stop"] = session.time_stop();
    if (session.selected_cell != none) json["selected_cell"] = session.selected_cell;
    if (session.selected_primitive != none) json["selected_primitive"] = session.selected_primitive;
    if (session.selected_node != none) json["selected_node"] = session.selected_node;
    if (session.selected_plane != none) json["selected_plane"] = session.selected_plane;
    for (const Bookmark& bookmark : session.bookmarks)
        json["bookmarks"].push_back({{"step", bookmark.step}, {"label", bookmark.label}});
    for (const Breakpoint& breakpoint : session.breakpoints)
        if (condition_here(session, breakpoint.condition))  // one over another method's fields could not be read again
            json["breakpoints"].push_back({{"condition", breakpoint.condition}, {"on", breakpoint.on}});
    for (const Note<D>& note : session.notes) json["notes"].push_back(note_json<D>(note));
    return json;
}

}  // namespace

template <int D>
std::string state_json(const Session<D>& session, const FigureSpec& figure, const Session<D>* other, Align align,
                       Carry carry) {
    OrderedJson head{{"format", "sightline-state"}, {"version", 1}};
    if (D == 3) head["dimension"] = D;
    OrderedJson json = head;
    json["scene"] = scene_part(session.scene(), carry);
    json["figure"] = {{"size", figure.size},
                      {"font_pt", figure.font_pt},
                      {"dpi", figure.dpi},
                      {"panels", figure.panels},
                      {"columns", figure.columns}};
    json.update(session_part(session));
    if (other) {
        OrderedJson beside = head;
        const Scene<D>&one = session.scene(), &two = other->scene();
        if (scene_hash(one) != scene_hash(two) || one.up_axis != two.up_axis)
            beside["scene"] = scene_part(other->scene(), carry);
        beside.update(session_part(*other));
        json["align"] = align_words[static_cast<std::size_t>(align)];
        json["other"] = std::move(beside);
    }
    return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

template <int D>
OpenedState<D> open_state(std::string_view text, const std::string& name, std::span<const Method<D>> methods,
                          const DrawIds& draw_ids, const Progress& progress, const std::string& scene) {
    GivenScene<D> given;
    try {
        const Json json = parse_json(text, name);
        if (!scene.empty()) {
            const Settings settings = settings_of_state(json.at("settings"));
            given = {std::make_shared<const Scene<D>>(
                         load_scene<D>(scene, {.two_sided = settings.two_sided == Switch::on, .progress = progress})),
                     true};
        }
        OpenedState<D> opened = read_state<D>(json, name, methods, draw_ids, progress, given);
        read_other<D>(json, name, methods, draw_ids, progress, given.differs, opened);
        return opened;
    } catch (const Json::exception& error) {
        throw input_error(name, "", why_not(error));
    } catch (const InputError& error) {
        const std::string why = error.what();
        if (why.starts_with(name + ": ")) throw InputError(one_line(why, 4096));
        throw input_error(name, "", why);
    }
}

#define SIGHTLINE_INSTANTIATE(D)                                                                               \
    template std::string state_json<D>(const Session<D>&, const FigureSpec&, const Session<D>*, Align, Carry); \
    template OpenedState<D> open_state<D>(std::string_view, const std::string&, std::span<const Method<D>>,    \
                                          const DrawIds&, const Progress&, const std::string&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
