// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/compose.h"

#include <algorithm>

#include "core/draw/cell_number.h"
#include "core/draw/legend.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/draw/picture_3d.h"
#include "core/draw/projection.h"
#include "core/draw/shown_world.h"
#include "core/number.h"
#include "core/session/report.h"

namespace sightline {

namespace {

char panel_letter(std::size_t i) { return static_cast<char>('a' + std::min<std::size_t>(i, 25)); }

template <int D>
std::string caption(std::span<const PanelSource<D>> panels) {
    std::string text = conditions(panels.front().session);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Session<D>& s = panels[i].session;
        text += panels.size() > 1 ? " (" + std::string(1, panel_letter(i)) + ") step " : " Step ";
        text += std::to_string(s.position()) + ": ";
        text += std::to_string(s.state().rendered_count) + " rendered";
        if (const auto share = coverage(s.reference(), s.visible_rendered()))
            text += ", coverage ε = " + short_number(*share);
        text += ".";
    }
    const Reference& reference = panels.front().session.reference();
    text += " Reference: " + (reference.name == "exact" ? "exact visible set" : reference.name) +
            ", |V| = " + std::to_string(reference.count) + ".";
    return text;
}

using HeatRange = std::optional<std::array<double, 2>>;

Figure::Panel draw_panel(const PanelSource<2>& source, const HeatRange& range, const std::optional<Box<2>>& world) {
    return {make_picture(source.session, {range, world, 0, source.sides}), ""};
}

/// The display view fills the picture, whatever the world of the others.
Figure::Panel draw_panel(const PanelSource<3>& source, const HeatRange& range, const std::optional<Box<2>>&) {
    const PictureOptions3 options{range, 0, source.sides};
    return {make_picture(source.session, options), "",
            std::make_shared<const SolidList>(make_solid(source.session, options))};
}

std::optional<Vec<2>> place_of(const Figure::Panel&, const Vec<2>& p) { return p; }
std::optional<Vec<2>> place_of(const Figure::Panel& panel, const Vec<3>& p) { return project(panel.solid->camera, p); }

std::vector<LegendRow> rows_of(std::span<const Figure::Panel> panels, const Settings& settings,
                               std::span<const Note<2>> notes) {
    std::vector<const DrawList*> lists;
    for (const Figure::Panel& panel : panels) lists.push_back(&panel.list);
    return legend_rows(lists, settings, notes);
}

std::vector<LegendRow> rows_of(std::span<const Figure::Panel> panels, const Settings& settings,
                               std::span<const Note<3>> notes) {
    std::vector<const DrawList*> lists;
    std::vector<const SolidList*> solids;
    for (const Figure::Panel& panel : panels) {
        lists.push_back(&panel.list);
        solids.push_back(panel.solid.get());
    }
    return legend_rows(lists, solids, settings, notes);
}

/// What all panels or frames stand on together.
struct Common {
    std::vector<LegendRow> legend;
    std::optional<ColourBar> bar;
};

/// Draws each source, all of them with that world if there is one; the first one's settings say what the numbers, the
/// legend and the colours are.
template <int D>
Common draw(std::span<const PanelSource<D>> sources, const std::optional<Box<2>>& world,
            std::vector<Figure::Panel>& panels) {
    Common common;
    const Settings& settings = sources.front().session.settings();
    HeatRange range;
    if (settings.heat != CellNumber::none)
        for (const PanelSource<D>& source : sources)
            if (const auto own = number_range(source.session, settings.heat)) {
                if (!range) range = own;
                range = {std::min((*range)[0], (*own)[0]), std::max((*range)[1], (*own)[1])};
            }
    std::vector<Note<D>> notes;
    for (const PanelSource<D>& source : sources) {
        panels.push_back(draw_panel(source, range, world));
        for (const Note<D>& note : current_notes(source.session)) {
            const auto at = place_of(panels.back(), anchor_point(source.session, note));
            if (at && panels.back().list.world.contains(*at)) notes.push_back(note);
        }
    }
    common.legend = rows_of(panels, settings, notes);
    if (range)
        common.bar = ColourBar{std::string(number_title(settings.heat)), short_number((*range)[0]),
                               short_number((*range)[1]), colours(settings.palette).heat};
    return common;
}

/// What a film shows of the scene in all its frames.
std::optional<Box<2>> film_world(std::span<const PanelSource<2>> frames) {
    Box<2> world;
    for (const PanelSource<2>& frame : frames) {
        const Box<2> own = figure_world(frame.session);
        world.add(own.min);
        world.add(own.max);
    }
    return world;
}
std::optional<Box<2>> film_world(std::span<const PanelSource<3>>) { return std::nullopt; }

/// A figure without its panels.
Figure empty_figure(const Common& common, const Settings& settings) {
    Figure figure;
    figure.legend_place = settings.legend == Legend::inside    ? LegendPlace::inside
                          : settings.legend == Legend::outside ? LegendPlace::outside
                                                               : LegendPlace::off;
    figure.legend = common.legend;
    figure.bar = common.bar;
    figure.background = colours(settings.palette).background;
    figure.ink = colours(settings.palette).ink;
    return figure;
}

template <int D>
Figure figure_of(std::span<const PanelSource<D>> sources) {
    const Settings& settings = sources.front().session.settings();
    std::vector<Figure::Panel> panels;
    Figure figure = empty_figure(draw(sources, std::nullopt, panels), settings);
    if (panels.size() > 1)
        for (std::size_t i = 0; i < panels.size(); ++i)
            panels[i].title = "(" + std::string(1, panel_letter(i)) + ") " + sources[i].title;
    figure.panels = std::move(panels);
    if (settings.caption == Switch::on) figure.caption = caption(sources);
    return figure;
}

template <int D>
std::vector<Figure> film_of(std::span<const PanelSource<D>> frames) {
    const Settings& settings = frames.front().session.settings();
    std::vector<Figure::Panel> panels;
    const Figure common = empty_figure(draw(frames, film_world(frames), panels), settings);
    std::vector<Figure> film(frames.size(), common);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        panels[i].title = frames[i].title;
        film[i].panels.push_back(std::move(panels[i]));
        if (settings.caption == Switch::on) film[i].caption = caption(frames.subspan(i, 1));
    }
    return film;
}

}  // namespace

Figure make_figure(std::span<const PanelSource<2>> panels) { return figure_of(panels); }
Figure make_figure(std::span<const PanelSource<3>> panels) { return figure_of(panels); }
std::vector<Figure> make_film(std::span<const PanelSource<2>> frames) { return film_of(frames); }
std::vector<Figure> make_film(std::span<const PanelSource<3>> frames) { return film_of(frames); }

}  // namespace sightline
