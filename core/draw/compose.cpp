// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/compose.h"

#include <algorithm>

#include "core/draw/cell_number.h"
#include "core/draw/legend.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/draw/shown_world.h"
#include "core/number.h"
#include "core/session/report.h"

namespace sightline {

namespace {

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

/// What all panels or frames stand on together.
struct Common {
    std::optional<std::array<double, 2>> heat_range;
    std::vector<LegendRow> legend;
    std::optional<ColourBar> bar;
};

/// Draws each source, all of them with that world if there is one; the first one's settings say what the numbers, the
/// legend and the colours are.
Common draw(std::span<const PanelSource> sources, const std::optional<Box<2>>& world, std::vector<DrawList>& lists) {
    Common common;
    const Settings& settings = sources.front().session.settings();
    auto& range = common.heat_range;
    if (settings.heat != CellNumber::none)
        for (const PanelSource& source : sources)
            if (const auto own = number_range(source.session, settings.heat)) {
                if (!range) range = own;
                range = {std::min((*range)[0], (*own)[0]), std::max((*range)[1], (*own)[1])};
            }
    std::vector<Note<2>> notes;
    for (const PanelSource& source : sources) {
        lists.push_back(make_picture(source.session, {range, world, 0, source.sides}));
        for (const Note<2>& note : current_notes(source.session))
            if (lists.back().world.contains(anchor_point(source.session, note))) notes.push_back(note);
    }
    std::vector<const DrawList*> all;
    for (const DrawList& list : lists) all.push_back(&list);
    common.legend = legend_rows(all, settings, notes);
    if (range)
        common.bar = ColourBar{std::string(number_title(settings.heat)), short_number((*range)[0]),
                               short_number((*range)[1]), colours(settings.palette).heat};
    return common;
}

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

}  // namespace

Figure make_figure(std::span<const PanelSource> panels) {
    const Settings& settings = panels.front().session.settings();
    std::vector<DrawList> lists;
    Figure figure = empty_figure(draw(panels, std::nullopt, lists), settings);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        std::string title;
        if (panels.size() > 1) title = "(" + std::string(1, panel_letter(i)) + ") " + panels[i].title;
        figure.panels.push_back({std::move(lists[i]), title});
    }
    if (settings.caption == Switch::on) figure.caption = caption(panels);
    return figure;
}

std::vector<Figure> make_film(std::span<const PanelSource> frames) {
    const Settings& settings = frames.front().session.settings();
    Box<2> world;
    for (const PanelSource& frame : frames) {
        const Box<2> own = figure_world(frame.session);
        world.add(own.min);
        world.add(own.max);
    }
    std::vector<DrawList> lists;
    const Figure common = empty_figure(draw(frames, world, lists), settings);
    std::vector<Figure> film(frames.size(), common);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        film[i].panels.push_back({std::move(lists[i]), frames[i].title});
        if (settings.caption == Switch::on) film[i].caption = caption(frames.subspan(i, 1));
    }
    return film;
}

}  // namespace sightline
