// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/compose.h"

#include <algorithm>

#include "core/draw/cell_number.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/number.h"
#include "core/session/report.h"

namespace sightline {

namespace {

std::uint16_t index(Look look) { return static_cast<std::uint16_t>(look); }

struct LegendEntry {
    Look look;
    ShapeKind swatch;
    const char* text;
};

constexpr std::array legend_entries{
    LegendEntry{Look::projected, ShapeKind::polygon, "projected"},
    LegendEntry{Look::enqueued, ShapeKind::polygon, "in the front (enqueued)"},
    LegendEntry{Look::unseen, ShapeKind::polygon, "outside the view (unseen)"},
    LegendEntry{Look::clean, ShapeKind::polygon, "not touched (clean)"},
    LegendEntry{Look::last, ShapeKind::polygon, "projected last"},
    LegendEntry{Look::selected, ShapeKind::polygon, "selected cell"},
    LegendEntry{Look::rendered, ShapeKind::polyline, "visible, rendered"},
    LegendEntry{Look::missed, ShapeKind::polyline, "visible, not rendered"},
    LegendEntry{Look::wasted, ShapeKind::polyline, "rendered but hidden"},
    LegendEntry{Look::other, ShapeKind::polyline, "hidden, not rendered"},
    LegendEntry{Look::eye, ShapeKind::disc, "eye"},
    LegendEntry{Look::view, ShapeKind::polyline, "border of the view"},
    LegendEntry{Look::seed, ShapeKind::polygon, "seed cell"},
    LegendEntry{Look::display_view, ShapeKind::polyline, "display view (frozen)"},
    LegendEntry{Look::eye_ray, ShapeKind::polyline, "eye ray v"},
    LegendEntry{Look::normal, ShapeKind::arrow, "facet normal n"},
    LegendEntry{Look::penalty, ShapeKind::cross, "penalty: not star-shaped"},
    LegendEntry{Look::chain, ShapeKind::arrow, "chain of updates"},
};

/// Whether some of the shape may lie in the picture: a legend says nothing about what a magnification leaves out.
bool is_shown(const DrawList& list, const Shape& shape) {
    Box<2> box;
    for (std::uint32_t i = 0; i < shape.point_count; ++i) box.add(list.points[shape.first_point + i]);
    const Box<2>& world = list.world;
    return box.min.x <= world.max.x && box.min.y <= world.max.y && box.max.x >= world.min.x && box.max.y >= world.min.y;
}

std::vector<LegendRow> legend(std::span<const Figure::Panel> panels, const Settings& settings,
                              std::span<const Note<2>> notes) {
    std::vector<std::uint8_t> used(index(Look::count));
    for (const Figure::Panel& panel : panels)
        for (const Shape& shape : panel.list.shapes)
            if (shape.style < used.size() && is_shown(panel.list, shape)) used[shape.style] = 1;
    const bool states = settings.heat == CellNumber::none && settings.show_states == Switch::on;
    used[index(Look::clean)] = states && settings.show_tessellation == Switch::on;
    std::vector<LegendRow> rows;
    for (const LegendEntry& entry : legend_entries)
        if (used[index(entry.look)]) {
            Style style = colours(settings.palette).looks[index(entry.look)];
            // An area without a border of its own would not show as a swatch when it is as light as the page.
            if (entry.swatch == ShapeKind::polygon && style.stroke.a == 0)
                style.stroke = colours(settings.palette).looks[index(Look::tessellation)].stroke;
            std::string text = entry.text;
            if (settings.show_visibility == Switch::off) {
                if (entry.look == Look::rendered) text = "rendered";
                if (entry.look == Look::other) text = "not rendered";
            }
            rows.push_back({entry.swatch, style, std::move(text)});
        }
    const auto add_text = [&](std::string text) {
        LegendRow row;
        row.text = std::move(text);
        rows.push_back(std::move(row));
    };
    if (settings.label != CellNumber::none) add_text("number: " + std::string(number_title(settings.label)));
    for (const Note<2>& note : notes)
        if (note.kind == Note<2>::Kind::callout) add_text(std::to_string(note.number) + ": " + note.text);
    return rows;
}

char panel_letter(std::size_t i) { return static_cast<char>('a' + std::min<std::size_t>(i, 25)); }

std::string caption(std::span<const PanelSource> panels) {
    std::string text = conditions(panels.front().session);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Session<2>& s = panels[i].session;
        text += panels.size() > 1 ? " (" + std::string(1, panel_letter(i)) + ") step " : " Step ";
        text += std::to_string(s.position()) + ": ";
        text += std::to_string(s.state().rendered_count) + " rendered";
        if (const auto share = coverage(s.reference(), s.visible_rendered()))
            text += ", coverage ε = " + short_number(*share);
        text += ".";
    }
    text += " Reference: exact visible set, |V| = " + std::to_string(panels.front().session.reference().count) + ".";
    return text;
}

}  // namespace

Figure make_figure(std::span<const PanelSource> panels) {
    const Settings& settings = panels.front().session.settings();
    const Colours& palette = colours(settings.palette);
    std::optional<std::array<double, 2>> range;
    if (settings.heat != CellNumber::none)
        for (const PanelSource& panel : panels)
            if (const auto own = number_range(panel.session, settings.heat)) {
                if (!range) range = own;
                range = {std::min((*range)[0], (*own)[0]), std::max((*range)[1], (*own)[1])};
            }
    Figure figure;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        std::string title;
        if (panels.size() > 1) title = "(" + std::string(1, panel_letter(i)) + ") " + panels[i].title;
        figure.panels.push_back({make_picture(panels[i].session, range), title});
    }
    figure.legend_place = settings.legend == Legend::inside    ? LegendPlace::inside
                          : settings.legend == Legend::outside ? LegendPlace::outside
                                                               : LegendPlace::off;
    figure.legend = legend(figure.panels, settings, panels.front().session.notes);
    if (range)
        figure.bar = ColourBar{std::string(number_title(settings.heat)), short_number((*range)[0]),
                               short_number((*range)[1]), palette.heat};
    if (settings.caption == Switch::on) figure.caption = caption(panels);
    figure.background = palette.background;
    figure.ink = palette.ink;
    return figure;
}

}  // namespace sightline
