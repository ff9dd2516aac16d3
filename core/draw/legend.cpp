// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/legend.h"

#include <algorithm>
#include <array>

#include "core/draw/cell_number.h"
#include "core/draw/palette.h"

namespace sightline {

namespace {

std::uint16_t index(Look look) { return static_cast<std::uint16_t>(look); }

struct Entry {
    Look look;
    ShapeKind swatch;
    const char* text;
};

constexpr std::array entries{
    Entry{Look::projected, ShapeKind::polygon, "projected"},
    Entry{Look::enqueued, ShapeKind::polygon, "in the front (enqueued)"},
    Entry{Look::unseen, ShapeKind::polygon, "outside the view (unseen)"},
    Entry{Look::both, ShapeKind::polygon, "projected by both"},
    Entry{Look::only_left, ShapeKind::polygon, "only by the left method"},
    Entry{Look::only_right, ShapeKind::polygon, "only by the right method"},
    Entry{Look::clean, ShapeKind::polygon, "not touched (clean)"},
    Entry{Look::last, ShapeKind::polygon, "projected last"},
    Entry{Look::selected, ShapeKind::polygon, "selected cell"},
    Entry{Look::rendered, ShapeKind::polyline, "visible, rendered"},
    Entry{Look::missed, ShapeKind::polyline, "visible, not rendered"},
    Entry{Look::wasted, ShapeKind::polyline, "rendered but hidden"},
    Entry{Look::other, ShapeKind::polyline, "hidden, not rendered"},
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

/// Whether some of the shape may lie in the picture: a legend says nothing about what a magnification leaves out.
bool is_shown(const DrawList& list, const Shape& shape) {
    Box<2> box;
    for (std::uint32_t i = 0; i < shape.point_count; ++i) box.add(list.points[shape.first_point + i]);
    const Box<2>& world = list.world;
    return box.min.x <= world.max.x && box.min.y <= world.max.y && box.max.x >= world.min.x && box.max.y >= world.min.y;
}

/// Per look whether some shape of a list has it.
std::vector<std::uint8_t> looks_used(std::span<const DrawList* const> lists) {
    std::vector<std::uint8_t> used(index(Look::count));
    for (const DrawList* list : lists)
        for (const Shape& shape : list->shapes)
            if (shape.style < used.size() && !used[shape.style] && is_shown(*list, shape)) used[shape.style] = 1;
    return used;
}

std::string text_of(const Entry& entry, bool beside, const Settings& settings) {
    if (entry.look == Look::clean && beside) return "projected by neither";
    if (settings.show_visibility == Switch::off) {
        if (entry.look == Look::rendered) return "rendered";
        if (entry.look == Look::other) return "not rendered";
    }
    return entry.text;
}

}  // namespace

std::vector<LegendRow> legend_rows(std::span<const DrawList* const> lists, const Settings& settings,
                                   std::span<const Note<2>> notes) {
    std::vector<std::uint8_t> used = looks_used(lists);
    const bool states = settings.heat == CellNumber::none && settings.show_states == Switch::on;
    used[index(Look::clean)] = states && settings.show_tessellation == Switch::on;
    const bool beside = used[index(Look::both)] || used[index(Look::only_left)] || used[index(Look::only_right)];
    const std::vector<Style>& looks = colours(settings.palette).looks;
    std::vector<LegendRow> rows;
    for (const Entry& entry : entries)
        if (used[index(entry.look)]) {
            Style style = looks[index(entry.look)];
            // An area without a border of its own would not show as a swatch when it is as light as the page.
            if (entry.swatch == ShapeKind::polygon && style.stroke.a == 0)
                style.stroke = looks[index(Look::tessellation)].stroke;
            rows.push_back({entry.swatch, style, text_of(entry, beside, settings)});
        }
    const auto add_text = [&](std::string text) {
        // Panels may carry the same note.
        if (std::any_of(rows.begin(), rows.end(), [&](const LegendRow& row) { return row.text == text; })) return;
        LegendRow row;
        row.text = std::move(text);
        rows.push_back(std::move(row));
    };
    if (settings.label != CellNumber::none) add_text("number: " + std::string(number_title(settings.label)));
    for (const Note<2>& note : notes)
        if (note.kind == Note<2>::Kind::callout) add_text(std::to_string(note.number) + ": " + note.text);
    return rows;
}

}  // namespace sightline
