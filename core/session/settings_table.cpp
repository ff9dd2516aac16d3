// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/settings_table.h"

#include <algorithm>
#include <charconv>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/methods/method_table.h"

namespace sightline {

namespace {

template <auto member>
struct MemberText;  // reads and writes one member of Settings as text

template <typename C, typename T, T C::*member>
struct MemberText<member> {
    static std::string get(const Settings& s) {
        if constexpr (std::is_enum_v<T>)
            return std::string(words<T>[static_cast<std::size_t>(s.*member)]);
        else if constexpr (std::is_same_v<T, std::string>)
            return s.*member;
        else if constexpr (std::is_same_v<T, Budget>)
            return budget_text(s.*member);
        else if constexpr (std::is_same_v<T, ImageSize>)
            return (s.*member).width == 0 ? "auto" : image_size_text(s.*member);
        else if constexpr (std::is_integral_v<T>)
            return std::to_string(s.*member);
        else
            return number_text(s.*member);
    }
};

template <auto member>
SettingRow choice(std::string_view name, Invalidates invalidates, std::string_view source, std::string_view help) {
    using E = std::remove_cvref_t<decltype(Settings{}.*member)>;
    return {name,
            help,
            source,
            invalidates,
            word_list<E>(),
            MemberText<member>::get,
            [](Settings& s, std::string_view value) {
                const auto found = std::find(words<E>.begin(), words<E>.end(), value);
                if (found == words<E>.end())
                    throw InputError("'" + std::string(value) + "' is not one of " + std::string(word_list<E>()));
                s.*member = static_cast<E>(found - words<E>.begin());
            },
            words<E>};
}

std::string cell_number_text(const CellNumber& number) {
    return number.kind == CellNumber::field ? number.name : std::string(cell_number_words[number.kind]);
}

/// A word, or the name of a field of the method's run: what fields there are a session knows.
template <auto member>
SettingRow cell_number(std::string_view name, std::string_view help) {
    return {name,
            help,
            "docs/figures.md",
            Invalidates::picture,
            "none | solidity | count | order | zeta | share | id",
            [](const Settings& s) { return cell_number_text(s.*member); },
            [](Settings& s, std::string_view value) {
                CellNumber& number = s.*member;
                const auto found = std::find(cell_number_words.begin(), cell_number_words.end(), value);
                if (found != cell_number_words.end()) {
                    number = static_cast<CellNumber::Kind>(found - cell_number_words.begin());
                    return;
                }
                const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
                if (value.empty() || !std::all_of(value.begin(), value.end(), letter))
                    throw InputError("'" + std::string(value) +
                                     "' is neither a field of the method nor one of none | solidity | count | order | "
                                     "zeta | share | id");
                number = CellNumber::field;
                number.name = value;
            },
            cell_number_words};
}

struct Range {
    double low, high;
    bool low_open = false, high_open = false;

    bool contains(double v) const { return (low_open ? v > low : v >= low) && (high_open ? v < high : v <= high); }
    std::string text() const {
        return (low_open ? "(" : "[") + number_text(low) + ", " + number_text(high) + (high_open ? ")" : "]");
    }
};

template <auto member>
SettingRow real(std::string_view name, const Range& range, Invalidates invalidates, std::string_view values,
                std::string_view source, std::string_view help) {
    return {
        name, help, source, invalidates, values, MemberText<member>::get, [range](Settings& s, std::string_view value) {
            const auto number = parse_number(value);
            if (!number || !range.contains(*number))
                throw InputError("'" + std::string(value) + "' is not a number in " + range.text());
            s.*member = *number;
        }};
}

constexpr const char* any_number = "a finite number";

template <auto member>
SettingRow finite(std::string_view name, Invalidates invalidates, std::string_view source, std::string_view help) {
    return {
        name, help, source, invalidates, any_number, MemberText<member>::get, [](Settings& s, std::string_view value) {
            const auto number = parse_number(value);
            if (!number) throw InputError("'" + std::string(value) + "' is not " + any_number);
            s.*member = *number;
        }};
}

template <auto member, std::uint64_t low, std::uint64_t high>
SettingRow whole(std::string_view name, Invalidates invalidates, std::string_view values, std::string_view source,
                 std::string_view help) {
    return {name, help, source, invalidates, values, MemberText<member>::get, [](Settings& s, std::string_view value) {
                std::uint64_t number = 0;
                const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
                if (error != std::errc() || end != value.data() + value.size() || number < low || number > high)
                    throw InputError("'" + std::string(value) + "' is not a whole number in [" + std::to_string(low) +
                                     ", " + std::to_string(high) + "]");
                s.*member = static_cast<std::remove_cvref_t<decltype(s.*member)>>(number);
            }};
}

constexpr const char* image_size_range = "auto, a width in [1, 16777216] or WxH in [1, 8192]";

ImageSize parse_image_size(std::string_view text) {
    if (text == "auto") return {};
    const std::size_t x = text.find('x');
    const auto width = parse_whole(text.substr(0, x));
    if (x == std::string_view::npos && width && *width >= 1 && *width <= 1u << 24) return {static_cast<int>(*width), 0};
    if (x != std::string_view::npos && width && *width >= 1 && *width <= 8192)
        if (const auto height = parse_whole(text.substr(x + 1)); height && *height >= 1 && *height <= 8192)
            return {static_cast<int>(*width), static_cast<int>(*height)};
    throw InputError("'" + std::string(text) + "' is not " + image_size_range);
}

/// The row of a setting that one dimension has to itself.
SettingRow only_in(int dimension, SettingRow row) {
    row.dimension = dimension;
    return row;
}

using S = Settings;

std::vector<SettingRow> own_rows() {
    return {
        choice<&S::two_sided>("two_sided", Invalidates::scene, "Doom WAD",
                              "also read the two-sided lines of a level, not only its solid walls"),
        only_in(3, choice<&S::up>("up", Invalidates::scene, "docs/three-dimensions.md",
                                  "the axis that points up: as the format says, else guessed (auto); by the format's "
                                  "rule or custom (format); or this one")),
        only_in(2, choice<&S::degrees>("degrees", Invalidates::scene, "RFC 7946",
                                       "GeoJSON in degrees: taken as they are, or x scaled by the cosine of the "
                                       "middle latitude")),

        choice<&S::tessellation>("tessellation", Invalidates::tessellation, "TVCG 4.3",
                                 "cells: Delaunay of the leaf centres, the leaves of the tree, or those of a kd-tree"),
        real<&S::error_bound>("error_bound", {0, 1, true, false}, Invalidates::tessellation, "(0, 1]",
                              "TVCG 4.3, note 4",
                              "tree nodes are split down to this share of the scene's longest side"),
        choice<&S::border>("border", Invalidates::tessellation, "docs/algorithm.md, border",
                           "add the corners of a larger box, so that cells reach the scene's border (Delaunay)"),
        real<&S::jitter>("jitter", {0, 0.5, false, true}, Invalidates::tessellation, "[0, 0.5)", "TVCG 4.3",
                         "random shift of a leaf's centre, as a share of the leaf's side"),
        whole<&S::seed, 0, 0xffffffffffffffffull>("seed", Invalidates::tessellation, "[0, 2^64)", "TVCG 4.3",
                                                  "seed of the jitter"),
        whole<&S::leaf_capacity, 1, 1'000'000>("leaf_capacity", Invalidates::tessellation, "[1, 1000000]", "TVCG 4.3",
                                               "a leaf that holds no more points than this is not split: ends or "
                                               "corners of primitives, in a kd-tree their middles"),
        choice<&S::empty_leaves>("empty_leaves", Invalidates::tessellation, "TVCG 4.3",
                                 "leaves without a vertex: their centres count too, are dropped, or those of one node "
                                 "are merged into one (Delaunay)"),
        choice<&S::split_for>(
            "split_for", Invalidates::tessellation, "docs/algorithm.md, cells",
            "a tree node is split for its vertices, or only where its parts are not as opaque as it is"),
        real<&S::opacity_tolerance>("opacity_tolerance", {0, 1, false, true}, Invalidates::tessellation, "[0, 1)",
                                    "docs/algorithm.md, cells",
                                    "with split_for=opacity: opacities that differ by no more than this are the same"),
        choice<&S::neighbours>("neighbours", Invalidates::tessellation, "gem, add_neighbors_to_front",
                               "cells next to a leaf share a facet with it, or touch it at all (tree and kd)"),

        choice<&S::automatic>("auto", Invalidates::traversal, "TVCG 7",
                              "method, cells and budget follow what the trade-off of a scene that is opened in a "
                              "viewer recommends, until one of them is set by hand"),
        SettingRow{"method", "the method that orders cells or primitives; --help lists the ids", "TVCG 5",
                   Invalidates::traversal, "a method id", MemberText<&S::method>::get,
                   [](Settings& s, std::string_view value) { s.method = std::string(value); }},
        SettingRow{"budget", "how much may be rendered: 500, 5%, 16ms or unlimited", "TVCG 3", Invalidates::traversal,
                   "500 | 5% | 16ms | unlimited", MemberText<&S::budget>::get,
                   [](Settings& s, std::string_view value) { s.budget = parse_budget(value); }},
        SettingRow{
            "reference_size",
            "pixels of the item buffer: a width in 2D (auto: 8192), width x height in 3D (auto: 1024x768), which "
            "also sets the aspect ratio of the view",
            "TVCG 4.4", Invalidates::reference, image_size_range, MemberText<&S::reference_size>::get,
            [](Settings& s, std::string_view value) { s.reference_size = parse_image_size(value); }},
        only_in(3, choice<&S::reference>("reference", Invalidates::reference, "TVCG 4.4",
                                         "what draws the item buffer: OpenGL, or the program itself (the same on every "
                                         "machine, and always used without OpenGL)")),

        choice<&S::palette>("palette", Invalidates::picture, "TR figs 1, 2, 4",
                            "colours: safe for colour-blind readers, as in the papers, or for print"),
        choice<&S::show_tessellation>("show_tessellation", Invalidates::picture, "TR fig. 1",
                                      "draw the cells' borders"),
        only_in(2, choice<&S::show_states>("show_states", Invalidates::picture, "TR figs 1, 4",
                                           "fill cells by their state")),
        only_in(2, choice<&S::show_primitives>("show_primitives", Invalidates::picture, "TR fig. 1",
                                               "draw the segments: rendered, missed, rendered but hidden")),
        choice<&S::show_visibility>(
            "show_visibility", Invalidates::picture, "TR figs 1, 4",
            "mark visible and hidden primitives; off: show only what is rendered, as the papers do"),
        choice<&S::show_view>("show_view", Invalidates::picture, "TR fig. 1", "draw eye, view cone and seed cell"),
        choice<&S::show_normals>("show_normals", Invalidates::picture, "TVCG fig. 6",
                                 "draw eye rays and facet normals of the last step"),
        choice<&S::show_penalties>("show_penalties", Invalidates::picture, "TVCG fig. 6",
                                   "mark facets of projected cells that cost a penalty"),
        choice<&S::show_chain>("show_chain", Invalidates::picture, "docs/figures.md",
                               "draw the chain of updates from the seed to the selected cell"),
        choice<&S::show_choice>("show_choice", Invalidates::picture, "docs/figures.md",
                                "outline the cell that came next when the last one was taken, name both, and show how "
                                "keys changed"),
        only_in(2, choice<&S::show_depth>("show_depth", Invalidates::picture, "docs/methods.md",
                                          "draw a strip of what the eye has before it so far, and which pixels of the "
                                          "selected or last cell or box are seen")),
        only_in(2,
                choice<&S::show_eye>("show_eye", Invalidates::picture, "docs/figures.md",
                                     "draw a strip under the plan: what the eye sees, exact above, drawn so far below, "
                                     "red where they differ")),
        choice<&S::show_planes>("show_planes", Invalidates::picture, "CT fig. 4a",
                                "draw the planes between the selected or last box and its occluder, where planes "
                                "decide what is hidden"),
        choice<&S::show_regions>(
            "show_regions", Invalidates::picture, "DAS fig. 2",
            "where a method chooses by viewpoint: the regions of eyes by technique, in place of the "
            "cells' states, and the directions round the eye; 3D: as a plan in a corner"),
        cell_number<&S::label>("label", "the number written on cells; also any field of the method, such as round"),
        choice<&S::label_where>("label_where", Invalidates::picture, "docs/figures.md",
                                "which cells carry numbers: the front and the last cell, all touched, or the selected"),
        cell_number<&S::heat>("heat", "the number shown as a heat map; also any field of the method, such as round"),
        choice<&S::legend>("legend", Invalidates::picture, "docs/figures.md",
                           "where the legend is placed; short: its five first rows; off: only what callouts say"),
        choice<&S::caption>("caption", Invalidates::picture, "docs/figures.md",
                            "add a caption that states the conditions"),
        only_in(2, real<&S::zoom>("zoom", {0.01, 1000}, Invalidates::picture, "[0.01, 1000]", "docs/figures.md",
                                  "magnification; 1 shows the whole scene")),
        only_in(2, choice<&S::zoom_at>(
                       "zoom_at", Invalidates::picture, "docs/figures.md",
                       "the middle of the picture: what the display eye looks at, the cell projected last, the "
                       "selected cell, or the point zoom_x, zoom_y")),
        only_in(2, finite<&S::zoom_x>("zoom_x", Invalidates::picture, "docs/figures.md",
                                      "x of the picture's centre with zoom_at=point, relative to the scene's origin")),
        only_in(2, finite<&S::zoom_y>("zoom_y", Invalidates::picture, "docs/figures.md",
                                      "y of the picture's centre with zoom_at=point, relative to the scene's origin")),

        only_in(3, choice<&S::clean_as>("clean_as", Invalidates::picture, "TVCG figs 1, 2",
                                        "how clean cells are drawn when the display eye is not the culling eye")),
        only_in(3,
                choice<&S::projected_as>("projected_as", Invalidates::picture, "TVCG fig. 1",
                                         "how projected cells are drawn when the display eye is not the culling eye")),
        only_in(
            3, choice<&S::enqueued_as>("enqueued_as", Invalidates::picture, "TVCG fig. 1",
                                       "how cells in the front are drawn when the display eye is not the culling eye")),
        only_in(3, choice<&S::unseen_as>(
                       "unseen_as", Invalidates::picture, "gem, NS_UNSEEN",
                       "how cells outside the view are drawn when the display eye is not the culling eye")),
        only_in(3, real<&S::shrink>("shrink", {0.05, 1}, Invalidates::picture, "[0.05, 1]", "docs/figures.md",
                                    "draw each cell at this share of its size, about its centre")),
        only_in(3, choice<&S::slice>("slice", Invalidates::picture, "docs/figures.md",
                                     "cut away what lies above slice_at along an axis, or (view) nearer to the eye")),
        only_in(3, real<&S::slice_at>("slice_at", {0, 1}, Invalidates::picture, "[0, 1]", "docs/figures.md",
                                      "position of the slice in the scene's bounding box; cells whose centre lies "
                                      "beyond it are not drawn")),
        only_in(3, choice<&S::only>("only", Invalidates::picture, "docs/figures.md",
                                    "which cells are drawn: all, the front, or those around the selected or last one")),
        only_in(3, whole<&S::around, 0, 1000>("around", Invalidates::picture, "[0, 1000]", "docs/figures.md",
                                              "with only=around: how many rings of neighbours")),
        only_in(3, choice<&S::triangles>("triangles", Invalidates::picture, "TVCG figs 1, 14",
                                         "which triangles are drawn")),
        only_in(3, choice<&S::inset>(
                       "inset", Invalidates::picture, "TVCG fig. 14",
                       "a picture in a corner: what the culling eye sees at this step, the pixels it "
                       "misses, both, the exact image, the depth of what is rendered, or the pyramid of it: the "
                       "farthest depth of blocks of pixels")),
        only_in(3, choice<&S::split>("split", Invalidates::picture, "TVCG fig. 13",
                                     "a second picture beside the first: the exact image from the culling eye, or "
                                     "the pixels that it misses")),
    };
}

/// Those of the session with the parameters of all methods behind the budget.
const std::vector<SettingRow>& all_rows() {
    static const std::vector<SettingRow> table = [] {
        std::vector<SettingRow> all = own_rows();
        auto at = std::find_if(all.begin(), all.end(), [](const SettingRow& row) { return row.name == "budget"; }) + 1;
        for (const ParameterRow* parameter : all_parameters()) at = all.insert(at, parameter_setting(*parameter)) + 1;
        return all;
    }();
    return table;
}

}  // namespace

std::span<const SettingRow> settings_table() { return all_rows(); }

SettingRow parameter_setting(const ParameterRow& row) {
    return {row.name,
            row.help,
            row.source,
            Invalidates::traversal,
            row.values,
            [&row](const Settings& s) { return std::string(s.parameters.text(row)); },
            [&row](Settings& s, std::string_view value) { s.parameters.set(row, value); },
            row.words,
            0,
            &row};
}

const SettingRow& setting_row(std::string_view name) {
    for (const SettingRow& row : all_rows())
        if (row.name == name) return row;
    std::vector<std::string_view> known;
    for (const SettingRow& row : all_rows()) known.push_back(row.name);
    throw unknown_word("setting", name, known);
}

const SettingRow& apply_setting(Settings& settings, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
        throw InputError("setting '" + std::string(assignment) + "': write FIELD=VALUE");
    const SettingRow& row = setting_row(assignment.substr(0, equals));
    if (row.parameter) {
        row.set(settings, assignment.substr(equals + 1));
        return row;
    }
    try {
        row.set(settings, assignment.substr(equals + 1));
    } catch (const InputError& error) {
        throw InputError("setting " + std::string(row.name) + ": " + error.what());
    }
    return row;
}

std::span<const Preset> presets() {
    static const std::vector<Preset> table{
        {"default",
         "the method's parameters at their defaults",
         {"view_vector=eye", "transfer_sign=clamp", "on_reenqueue=replace", "star_shaped=on", "penalty=multiply",
          "penalty_amount=2", "solidity_scale=max", "own_content=off", "budget_counts=each_once", "outside_view=unseen",
          "culled_cost=free", "neighbours_before_break=yes", "seeds=one"}},
        {"prototype-2d",
         "PLP as printed, without the star-shape test, as the 2D program of TR",
         {"view_vector=camera", "transfer_sign=signed", "on_reenqueue=replace", "star_shaped=off", "penalty=multiply",
          "penalty_amount=2", "solidity_scale=max", "own_content=off", "budget_counts=each_once",
          "outside_view=enqueue", "culled_cost=free", "neighbours_before_break=no", "seeds=one"},
         "published"},
        {"paper-3d",
         "PLP as printed, with the star-shape test, as the 3D program of TR and TVCG",
         {"view_vector=camera", "transfer_sign=signed", "on_reenqueue=replace", "star_shaped=on", "penalty=multiply",
          "penalty_amount=2", "solidity_scale=max", "own_content=off", "budget_counts=each_once",
          "outside_view=enqueue", "culled_cost=free", "neighbours_before_break=no", "seeds=one"},
         "published"},
    };
    return table;
}

namespace {

/// Presets that scripts of earlier versions name: they still do what they did. Shown nowhere.
std::span<const Preset> old_presets() {
    static const std::vector<Preset> table{
        {"letter",
         "prototype-2d, and the cells of the papers",
         {"view_vector=camera", "transfer_sign=signed", "on_reenqueue=replace", "star_shaped=off", "penalty=multiply",
          "penalty_amount=2", "solidity_scale=max", "own_content=off", "budget_counts=each_once",
          "outside_view=enqueue", "culled_cost=free", "neighbours_before_break=no", "seeds=one", "border=none",
          "jitter=0.02", "error_bound=0.05"},
         "published"},
    };
    return table;
}

}  // namespace

void apply_preset(Settings& settings, std::string_view id) {
    for (const auto table : {presets(), old_presets()})
        for (const Preset& preset : table)
            if (preset.id == id) {
                if (settings.automatic == Switch::on && !preset.method.empty()) settings.method = preset.method;
                for (const std::string_view assignment : preset.assignments) apply_setting(settings, assignment);
                return;
            }
    std::vector<std::string_view> known;
    for (const Preset& preset : presets()) known.push_back(preset.id);
    throw unknown_word("preset", id, known);
}

Invalidates difference(const Settings& a, const Settings& b) {
    Invalidates strongest = Invalidates::picture;
    for (const SettingRow& row : all_rows())
        if (row.get(a) != row.get(b)) strongest = std::max(strongest, row.invalidates);
    return strongest;
}

}  // namespace sightline
