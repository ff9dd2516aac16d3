// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/legend.h"

#include <algorithm>
#include <array>

#include "core/draw/box_palette.h"
#include "core/draw/cell_number.h"
#include "core/draw/palette.h"
#include "core/draw/solid_palette.h"
#include "core/draw/viewpoint_map.h"

namespace sightline {

namespace {

std::uint16_t style_index(Look look) { return static_cast<std::uint16_t>(look); }

struct Entry {
    Look look;
    ShapeKind swatch;
    const char* text;
};

constexpr std::array entries{
    Entry{Look::projected, ShapeKind::polygon, "projected"},
    Entry{Look::completed, ShapeKind::polygon, "projected in a round"},
    Entry{Look::enqueued, ShapeKind::polygon, "in the front (enqueued)"},
    Entry{Look::hidden, ShapeKind::polygon, "tested: hidden"},
    Entry{Look::postponed, ShapeKind::polygon, "covered: postponed"},
    Entry{Look::unseen, ShapeKind::polygon, "outside the view (unseen)"},
    Entry{Look::only_here, ShapeKind::polyline, "projected only here"},
    Entry{Look::only_there, ShapeKind::polygon, "projected only in the other"},
    Entry{Look::clean, ShapeKind::polygon, "not touched (clean)"},
    Entry{Look::last, ShapeKind::polygon, "projected last"},
    Entry{Look::next, ShapeKind::polygon, "runner-up of the last step"},
    Entry{Look::selected, ShapeKind::polygon, "selected cell"},
    Entry{Look::rendered, ShapeKind::polyline, "visible, rendered"},
    Entry{Look::missed, ShapeKind::polyline, "visible, not rendered"},
    Entry{Look::wasted, ShapeKind::polyline, "rendered but hidden"},
    Entry{Look::other, ShapeKind::polyline, "hidden, not rendered"},
    Entry{Look::level_1, ShapeKind::polyline, "level 1 of an object"},
    Entry{Look::level_2, ShapeKind::polyline, "level 2"},
    Entry{Look::level_3, ShapeKind::polyline, "level 3 or coarser"},
    Entry{Look::eye, ShapeKind::disc, "eye"},
    Entry{Look::view, ShapeKind::polyline, "border of the view"},
    Entry{Look::seed, ShapeKind::polygon, "seed cell"},
    Entry{Look::display_view, ShapeKind::polyline, "display view (frozen)"},
    Entry{Look::eye_ray, ShapeKind::polyline, "eye ray v"},
    Entry{Look::normal, ShapeKind::arrow, "facet normal n"},
    Entry{Look::penalty, ShapeKind::cross, "penalty: not star-shaped"},
    Entry{Look::chain, ShapeKind::arrow, "chain of updates"},
    Entry{Look::selected_primitive, ShapeKind::polyline, "selected segment"},
};

constexpr const char* text_of(Look look) {
    for (const Entry& entry : entries)
        if (entry.look == look) return entry.text;
    return nullptr;
}

struct SolidEntry {
    SolidLook look;
    const char* text;
};

constexpr std::array solid_entries{
    SolidEntry{SolidLook::projected, text_of(Look::projected)},
    SolidEntry{SolidLook::completed, text_of(Look::completed)},
    SolidEntry{SolidLook::enqueued, text_of(Look::enqueued)},
    SolidEntry{SolidLook::hidden, text_of(Look::hidden)},
    SolidEntry{SolidLook::postponed, text_of(Look::postponed)},
    SolidEntry{SolidLook::unseen, text_of(Look::unseen)},
    SolidEntry{SolidLook::only_here, text_of(Look::only_here)},
    SolidEntry{SolidLook::only_there, text_of(Look::only_there)},
    SolidEntry{SolidLook::clean, text_of(Look::clean)},
    SolidEntry{SolidLook::fresh, "rendered in the last step"},
    SolidEntry{SolidLook::added, "rendered to complete the picture"},
    SolidEntry{SolidLook::rendered, text_of(Look::rendered)},
    SolidEntry{SolidLook::missed, text_of(Look::missed)},
    SolidEntry{SolidLook::wasted, text_of(Look::wasted)},
    SolidEntry{SolidLook::other, text_of(Look::other)},
    SolidEntry{SolidLook::plain, "rendered"},
    SolidEntry{SolidLook::level_1, text_of(Look::level_1)},
    SolidEntry{SolidLook::level_2, text_of(Look::level_2)},
    SolidEntry{SolidLook::level_3, text_of(Look::level_3)},
    SolidEntry{SolidLook::rest, "not rendered"},
};

/// Styles that only pictures of three dimensions have.
struct StarEntry {
    const char* name;
    ShapeKind swatch;
    const char* text;
};

constexpr std::array star_entries{
    StarEntry{"star_ray", ShapeKind::polyline, "ray to the cell's centre"},
    StarEntry{"star_facet", ShapeKind::polyline, "facet through which the cell was reached"},
};

/// Whether some of the shape may lie in the picture: a legend says nothing about what a magnification leaves out.
bool is_shown(const DrawList& list, const Shape& shape) {
    Box<2> box;
    for (std::uint32_t i = 0; i < shape.point_count; ++i) box.add(list.points[shape.first_point + i]);
    const Box<2>& world = list.world;
    return box.min.x <= world.max.x && box.min.y <= world.max.y && box.max.x >= world.min.x && box.max.y >= world.min.y;
}

std::string text_of(const Entry& entry, const Settings& settings) {
    if (settings.show_visibility == Switch::off) {
        if (entry.look == Look::rendered) return "rendered";
        if (entry.look == Look::other) return "not rendered";
    }
    return entry.text;
}

/// What may be seen of a list: before its eye, in its cone and not cut off.
class Sight {
public:
    explicit Sight(const SolidList& list) : eye_(list.camera.eye), slice_(list.slice) {
        const auto& corners = list.camera.corners;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec<3> inward = glm::cross(corners[i] - eye_, corners[(i + 1) % 4] - eye_);
            inward_[i] = glm::dot(inward, list.camera.look_at - eye_) < 0 ? -inward : inward;
        }
    }
    template <typename Points>
    bool shows(const Points& points) const {
        const auto some = [&](auto holds) { return std::any_of(std::begin(points), std::end(points), holds); };
        for (const Vec<3>& inward : inward_)
            if (!some([&](const Vec<3>& p) { return glm::dot(inward, p - eye_) > 0; })) return false;
        return !slice_ || some([&](const Vec<3>& p) { return glm::dot(slice_->normal, p) <= slice_->offset; });
    }

private:
    Vec<3> eye_;
    std::optional<Slice> slice_;
    std::array<Vec<3>, 4> inward_;
};

LegendRow solid_row(const SolidStyle& look, const UsedStyles::Solid& use, const char* text, Colour rim) {
    Style style{look.name};
    style.width_pt = use.faces ? 0.5 : look.width_pt;
    style.stroke = use.faces ? rim : look.colour;
    if (use.faces) style.fill = look.colour;
    return {use.faces ? ShapeKind::polygon : ShapeKind::polyline, style, text};
}

/// Panels may carry the same note.
void add_text(std::string text, std::vector<LegendRow>& rows) {
    if (std::any_of(rows.begin(), rows.end(), [&](const LegendRow& row) { return row.text == text; })) return;
    LegendRow row;
    row.text = std::move(text);
    rows.push_back(std::move(row));
}

/// What the texts of a picture stand for.
template <int D>
void add_texts(const Settings& settings, std::string_view key_title, std::span<const Note<D>> notes,
               std::vector<LegendRow>& rows) {
    if (settings.label != CellNumber::none)
        add_text("number: " + std::string(number_title(settings.label, key_title)), rows);
    for (const LegendRow& row : callout_rows(notes)) add_text(row.text, rows);
}

/// Of a short legend.
constexpr std::size_t short_rows = 5;
/// Styles that can be left out, the first first: what they are can be guessed, or is seldom asked.
constexpr auto seldom_asked =
    std::to_array<std::string_view>({"view", "other", "rest", "eye", "clean", "seed", "unseen", "display_view", "last",
                                     "plain", "hidden", "completed", "wasted"});
/// After those.
constexpr auto seldom_asked_of_planes =
    std::to_array<std::string_view>({"own", "own_fails", "region_box", "last_box", "separating", "separating_fails",
                                     "potential", "supporting", "supporting_fails", "outside", "lit"});

}  // namespace

template <int D>
std::vector<LegendRow> callout_rows(std::span<const Note<D>> notes) {
    std::vector<LegendRow> rows;
    for (const Note<D>& note : notes)
        if (note.kind == Note<D>::Kind::callout) add_text(std::to_string(note.number) + ": " + note.text, rows);
    return rows;
}
template std::vector<LegendRow> callout_rows<2>(std::span<const Note<2>>);
template std::vector<LegendRow> callout_rows<3>(std::span<const Note<3>>);

std::vector<LegendRow> short_legend(std::vector<LegendRow> rows) {
    const auto leave_out = [&](std::span<const std::string_view> names) {
        for (const std::string_view name : names) {
            if (rows.size() <= short_rows) break;
            std::erase_if(rows, [&](const LegendRow& row) { return row.style.name == name; });
        }
    };
    leave_out(seldom_asked);
    leave_out(seldom_asked_of_planes);
    return rows;
}

void add_used(const DrawList& list, UsedStyles& used) {
    used.looks.resize(style_index(Look::count));
    for (const Shape& shape : list.shapes) {
        if (shape.style < used.looks.size()) {
            if (!used.looks[shape.style] && is_shown(list, shape)) used.looks[shape.style] = 1;
            continue;
        }
        const Style& style = list.styles[shape.style];
        const auto has_its_name = [&](const auto& other) { return other.name == style.name; };
        if ((std::any_of(star_entries.begin(), star_entries.end(), has_its_name) || box_entry(style.name) ||
             region_row(style)) &&
            std::none_of(used.others.begin(), used.others.end(), has_its_name) && is_shown(list, shape))
            used.others.push_back(style);
    }
}

void add_used(const SolidList& list, UsedStyles& in) {
    in.solids.resize(static_cast<std::size_t>(SolidLook::count));
    std::vector<UsedStyles::Solid> used = in.solids;
    used.resize(std::max(used.size(), list.styles.size()));
    const Sight sight(list);
    const std::span points(list.points), ends(list.edge_points);
    for (std::size_t i = 0; i < list.face_style.size(); ++i)
        if (const std::uint8_t style = list.face_style[i]; style < used.size() && !used[style].faces)
            used[style].faces =
                sight.shows(points.subspan(list.face_begin[i], list.face_begin[i + 1] - list.face_begin[i]));
    for (std::size_t i = 0; i < list.edge_style.size(); ++i)
        if (const std::uint8_t style = list.edge_style[i]; style < used.size() && !used[style].edges)
            used[style].edges = sight.shows(ends.subspan(2 * i, 2));
    for (const SolidList::Run& run : list.runs)
        for (std::uint32_t i = 0; run.style < used.size() && i < run.count && !used[run.style].faces; ++i)
            used[run.style].faces = sight.shows(list.scene->primitives[list.triangles[run.first + i]]);
    for (std::size_t i = in.solids.size(); i < list.styles.size(); ++i) {
        if (!(used[i].faces || used[i].edges) || !box_entry(list.styles[i].name)) continue;
        auto& others = in.other_solids;
        auto other = std::find_if(others.begin(), others.end(), [&](const UsedStyles::OtherSolid& known) {
            return known.style.name == list.styles[i].name;
        });
        if (other == others.end()) other = others.insert(others.end(), {list.styles[i], {}});
        other->use.faces |= used[i].faces;
        other->use.edges |= used[i].edges;
    }
    std::copy_n(used.begin(), in.solids.size(), in.solids.begin());
}

namespace {

/// What tells techniques by region, boxes, occluders and planes apart; the latter in the order of their table.
std::vector<LegendRow> box_rows(const UsedStyles& used, const Colours& palette) {
    std::vector<std::pair<std::size_t, LegendRow>> placed;
    const Colour rim = palette.looks[style_index(Look::tessellation)].stroke;
    for (const UsedStyles::OtherSolid& other : used.other_solids)
        if (const BoxEntry* entry = box_entry(other.style.name))
            placed.push_back({row_of(*entry), solid_row(other.style, other.use, entry->text, rim)});
    for (const Style& style : used.others)
        if (const BoxEntry* entry = box_entry(style.name))
            placed.push_back({row_of(*entry), {entry->swatch, style, entry->text}});
    std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<LegendRow> rows;
    for (const Style& style : used.others)
        if (const auto row = region_row(style)) rows.push_back(*row);
    // Techniques as the method lists them, which is as their hatches follow each other.
    const auto place = [](const LegendRow& row) {
        return row.style.hatch_colour.a > 0 ? static_cast<int>(row.style.hatch) : static_cast<int>(hatch_count);
    };
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const LegendRow& a, const LegendRow& b) { return place(a) < place(b); });
    for (auto& [place, row] : placed) rows.push_back(std::move(row));
    return rows;
}

}  // namespace

std::vector<LegendRow> legend_rows(const UsedStyles& styles, const Settings& settings, std::span<const Note<2>> notes) {
    std::vector<std::uint8_t> used = styles.looks;
    used.resize(style_index(Look::count));
    const bool states = settings.heat == CellNumber::none && settings.show_states == Switch::on;
    const std::vector<Style>& looks = colours(settings.palette).looks;
    std::vector<LegendRow> rows = box_rows(styles, colours(settings.palette));
    used[style_index(Look::clean)] = states && settings.show_tessellation == Switch::on && rows.empty();
    for (const Entry& entry : entries)
        if (used[style_index(entry.look)]) {
            Style style = looks[style_index(entry.look)];
            // An area without a border of its own would not show as a swatch when it is as light as the page.
            if (entry.swatch == ShapeKind::polygon && style.stroke.a == 0)
                style.stroke = looks[style_index(Look::tessellation)].stroke;
            rows.push_back({entry.swatch, style, text_of(entry, settings)});
        }
    add_texts(settings, styles.key_title, notes, rows);
    return rows;
}

std::vector<LegendRow> legend_rows(const UsedStyles& used, const Settings& settings, std::span<const Note<3>> notes) {
    const Colours& palette = colours(settings.palette);
    std::vector<LegendRow> rows = box_rows(used, palette);
    for (const SolidEntry& entry : solid_entries)
        if (const auto look = static_cast<std::size_t>(entry.look);
            look < used.solids.size() && (used.solids[look].faces || used.solids[look].edges))
            rows.push_back(solid_row(solid_styles(settings.palette)[look], used.solids[look], entry.text,
                                     palette.looks[style_index(Look::tessellation)].stroke));
    for (const Entry& entry : entries)
        if (style_index(entry.look) < used.looks.size() && used.looks[style_index(entry.look)])
            rows.push_back({entry.swatch, palette.looks[style_index(entry.look)],
                            entry.look == Look::selected_primitive ? "selected triangle" : entry.text});
    for (const StarEntry& entry : star_entries)
        for (const Style& style : used.others)
            if (style.name == entry.name) rows.push_back({entry.swatch, style, entry.text});
    add_texts(settings, used.key_title, notes, rows);
    return rows;
}

std::vector<LegendRow> legend_rows(std::span<const DrawList* const> lists, const Settings& settings,
                                   std::string_view key_title, std::span<const Note<2>> notes) {
    UsedStyles used;
    used.key_title = key_title;
    for (const DrawList* list : lists) add_used(*list, used);
    return legend_rows(used, settings, notes);
}

std::vector<LegendRow> legend_rows(std::span<const DrawList* const> lists, std::span<const SolidList* const> solids,
                                   const Settings& settings, std::string_view key_title,
                                   std::span<const Note<3>> notes) {
    UsedStyles used;
    used.key_title = key_title;
    for (const DrawList* list : lists) add_used(*list, used);
    for (const SolidList* solid : solids) add_used(*solid, used);
    return legend_rows(used, settings, notes);
}

}  // namespace sightline
