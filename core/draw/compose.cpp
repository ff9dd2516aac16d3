// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/compose.h"

#include <algorithm>

#include "core/draw/cell_number.h"
#include "core/draw/insets.h"
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
            std::make_shared<const SolidList>(make_solid(source.session, options)), make_insets(source.session)};
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

/// What all panels or frames share. The first one's settings say what the numbers, the legend and the colours are.
template <int D>
struct Common {
    Settings settings;
    HeatRange range;
    std::optional<Box<2>> world;  ///< that of all; nothing: each has its own
    std::vector<Figure::Panel> panels;
    std::vector<Note<D>> notes;  ///< those that some panel shows
};

/// Each source is met before the first one is drawn.
template <int D>
void meet(const PanelSource<D>& source, Common<D>& common) {
    if (common.settings.heat == CellNumber::none) return;
    const HeatRange own = number_range(source.session, common.settings.heat);
    HeatRange& range = common.range;
    if (!own) return;
    if (!range) range = own;
    range = {std::min((*range)[0], (*own)[0]), std::max((*range)[1], (*own)[1])};
}

/// What a film shows of the scene in all its frames.
void widen_world(const PanelSource<2>& frame, Common<2>& common) {
    const Box<2> own = figure_world(frame.session);
    if (!common.world) common.world = own;
    common.world->add(own.min);
    common.world->add(own.max);
}
void widen_world(const PanelSource<3>&, Common<3>&) {}

template <int D>
void draw(const PanelSource<D>& source, Common<D>& common) {
    common.panels.push_back(draw_panel(source, common.range, common.world));
    const Figure::Panel& panel = common.panels.back();
    for (const Note<D>& note : current_notes(source.session)) {
        const auto at = place_of(panel, anchor_point(source.session, note));
        if (at && panel.list.world.contains(*at)) common.notes.push_back(note);
    }
}

/// A figure without its panels.
template <int D>
Figure empty_figure(const Common<D>& common) {
    const Settings& settings = common.settings;
    Figure figure;
    figure.legend_place = settings.legend == Legend::inside    ? LegendPlace::inside
                          : settings.legend == Legend::outside ? LegendPlace::outside
                                                               : LegendPlace::off;
    figure.legend = rows_of(common.panels, settings, common.notes);
    if (common.range)
        figure.bar = ColourBar{std::string(number_title(settings.heat)), short_number((*common.range)[0]),
                               short_number((*common.range)[1]), colours(settings.palette).heat};
    figure.background = colours(settings.palette).background;
    figure.ink = colours(settings.palette).ink;
    return figure;
}

template <int D>
Figure figure_of(std::span<const PanelSource<D>> sources) {
    Common<D> common{sources.front().session.settings(), {}, {}, {}, {}};
    for (const PanelSource<D>& source : sources) meet(source, common);
    for (const PanelSource<D>& source : sources) draw(source, common);
    Figure figure = empty_figure(common);
    figure.panels = std::move(common.panels);
    if (sources.size() > 1)
        for (std::size_t i = 0; i < sources.size(); ++i)
            figure.panels[i].title = "(" + std::string(1, panel_letter(i)) + ") " + sources[i].title;
    if (common.settings.caption == Switch::on) figure.caption = caption(sources);
    return figure;
}

}  // namespace

Figure make_figure(std::span<const PanelSource<2>> panels) { return figure_of(panels); }
Figure make_figure(std::span<const PanelSource<3>> panels) { return figure_of(panels); }

template <int D>
std::vector<Figure> make_film(std::size_t frames, const std::function<const PanelSource<D>&(std::size_t)>& frame) {
    Common<D> common{frame(0).session.settings(), {}, {}, {}, {}};
    for (std::size_t i = 0; i < frames; ++i) {
        const PanelSource<D>& source = frame(i);
        meet(source, common);
        widen_world(source, common);
    }
    std::vector<std::string> captions(frames);
    for (std::size_t i = 0; i < frames; ++i) {
        const PanelSource<D>& source = frame(i);
        draw(source, common);
        common.panels.back().title = source.title;
        if (common.settings.caption == Switch::on) captions[i] = caption(std::span(&source, 1));
    }
    std::vector<Figure> film(frames, empty_figure(common));
    for (std::size_t i = 0; i < frames; ++i) {
        film[i].panels.push_back(std::move(common.panels[i]));
        film[i].caption = std::move(captions[i]);
    }
    return film;
}

template std::vector<Figure> make_film<2>(std::size_t, const std::function<const PanelSource<2>&(std::size_t)>&);
template std::vector<Figure> make_film<3>(std::size_t, const std::function<const PanelSource<3>&(std::size_t)>&);

}  // namespace sightline
