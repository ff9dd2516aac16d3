// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/compose.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/draw/cell_number.h"
#include "core/draw/insets.h"
#include "core/draw/legend.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/draw/picture_3d.h"
#include "core/draw/projection.h"
#include "core/draw/shown_world.h"
#include "core/scene/flight_path.h"
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
        text += std::to_string(s.counters().drawn()) + " rendered";
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
    return {make_picture(source.session, {range, world, 0, source.differences}), ""};
}

/// The display view fills the picture, whatever the world of the others.
Figure::Panel draw_panel(const PanelSource<3>& source, const HeatRange& range, const std::optional<Box<2>>&) {
    const PictureOptions3 options{range, 0, source.differences};
    return {make_picture(source.session, options), "",
            std::make_shared<const SolidList>(make_solid(source.session, options)), make_insets(source.session)};
}

std::optional<Vec<2>> place_of(const Figure::Panel&, const Vec<2>& p) { return p; }
std::optional<Vec<2>> place_of(const Figure::Panel& panel, const Vec<3>& p) { return project(panel.solid->camera, p); }

/// What all panels or frames share. The first one's settings say what the numbers, the legend and the colours are.
template <int D>
struct Common {
    Settings settings;
    HeatRange range;
    std::optional<Box<2>> world;  ///< that of all; nothing: each has its own
    UsedStyles used;
    std::vector<Note<D>> notes;  ///< those that some panel shows
};

/// Each source is met before the first one is drawn.
template <int D>
void meet_at(const PanelSource<D>& source, Common<D>& common) {
    if (common.used.key_title.empty()) common.used.key_title = key_title(source.session);
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

/// The panels of one figure; several have letters.
template <int D>
std::vector<Figure::Panel> draw_panels(std::span<const PanelSource<D>> sources, const Common<D>& common) {
    std::vector<Figure::Panel> panels;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        panels.push_back(draw_panel(sources[i], common.range, common.world));
        if (sources.size() > 1) panels[i].title = "(" + std::string(1, panel_letter(i)) + ") " + sources[i].title;
    }
    return panels;
}

/// What the legend has to explain, and which notes lie outside.
template <int D>
void note_use(std::span<const PanelSource<D>> sources, std::span<Figure::Panel> panels, Common<D>& common) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
        add_used(panels[i].list, common.used);
        if (panels[i].solid) add_used(*panels[i].solid, common.used);
        for (const Figure::Inset& inset : panels[i].insets)
            if (inset.list) add_used(*inset.list, common.used);
        for (const Note<D>& note : current_notes(sources[i].session)) {
            const auto at = place_of(panels[i], anchor_point(sources[i].session, note));
            if (at && panels[i].list.world.contains(*at))
                common.notes.push_back(note);
            else
                panels[i].notes_outside.push_back(note.text);
        }
    }
}

/// A figure without its panels.
template <int D>
Figure empty_figure(const Common<D>& common) {
    const Settings& settings = common.settings;
    Figure figure;
    figure.legend_place = settings.legend == Legend::inside ? LegendPlace::inside : LegendPlace::outside;
    figure.legend = settings.legend == Legend::off ? callout_rows<D>(common.notes)
                                                   : legend_rows(common.used, settings, common.notes);
    if (settings.legend == Legend::brief) figure.legend = short_legend(std::move(figure.legend));
    if (figure.legend.empty() && settings.legend == Legend::off) figure.legend_place = LegendPlace::off;
    if (common.range && settings.legend != Legend::off)
        figure.bar =
            ColourBar{std::string(number_title(settings.heat, common.used.key_title)), short_number((*common.range)[0]),
                      short_number((*common.range)[1]), colours(settings.palette).heat};
    figure.background = colours(settings.palette).background;
    figure.ink = colours(settings.palette).ink;
    return figure;
}

template <int D>
Common<D> common_of(std::span<const PanelSource<D>> sources) {
    return {sources.front().session.settings(), {}, {}, {}, {}};
}

template <int D>
Figure figure_of(std::span<const PanelSource<D>> sources) {
    Common<D> common = common_of(sources);
    for (const PanelSource<D>& source : sources) meet_at(source, common);
    std::vector<Figure::Panel> panels = draw_panels(sources, common);
    note_use<D>(sources, panels, common);
    Figure figure = empty_figure(common);
    figure.panels = std::move(panels);
    if (common.settings.caption == Switch::on) figure.caption = caption(sources);
    return figure;
}

/// Of so many frames a film keeps the pictures, to find a place for its legend.
constexpr std::size_t kept_pictures = 8;

/// What layout needs of a panel that it does not look at.
Figure::Panel outline_of(const Figure::Panel& panel) {
    Figure::Panel outline;
    outline.list.world = panel.list.world;
    outline.title = panel.title;
    return outline;
}

/// A frame alone has a title of its own, which tells it from the others.
template <int D>
std::vector<Figure::Panel> draw_frame(std::span<const PanelSource<D>> sources, const Common<D>& common) {
    std::vector<Figure::Panel> panels = draw_panels(sources, common);
    if (panels.size() == 1) panels[0].title = sources[0].title;
    return panels;
}

}  // namespace

Figure make_figure(std::span<const PanelSource<2>> panels) { return figure_of(panels); }
Figure make_figure(std::span<const PanelSource<3>> panels) { return figure_of(panels); }

template <int D>
Film make_film(std::size_t frames, FilmFrame<D> frame) {
    Common<D> common = common_of(frame(0));
    Film film;
    for (std::size_t i = 0; i < frames; ++i)
        for (const PanelSource<D>& source : frame(i)) {
            meet_at(source, common);
            widen_world(source, common);
        }
    const std::vector<std::size_t> kept = spread_frames(frames, kept_pictures);
    for (std::size_t i = 0; i < frames; ++i) {
        const std::span<const PanelSource<D>> sources = frame(i);
        Figure& figure = film.plan.emplace_back();
        figure.panels = draw_frame(sources, common);
        note_use<D>(sources, figure.panels, common);
        if (common.settings.caption == Switch::on) figure.caption = caption(sources);
        if (!std::binary_search(kept.begin(), kept.end(), i))
            for (Figure::Panel& panel : figure.panels) panel = outline_of(panel);
    }
    const Figure empty = empty_figure(common);
    std::vector<std::string> captions;
    for (Figure& figure : film.plan) {
        captions.push_back(figure.caption);
        std::vector<Figure::Panel> panels = std::move(figure.panels);
        figure = empty;
        figure.panels = std::move(panels);
        figure.caption = captions.back();
    }
    film.page = [frame = std::move(frame), common = std::move(common), empty, captions](std::size_t i) {
        Figure figure = empty;
        figure.panels = draw_frame(frame(i), common);
        figure.caption = captions[i];
        return figure;
    };
    return film;
}

template Film make_film<2>(std::size_t, FilmFrame<2>);
template Film make_film<3>(std::size_t, FilmFrame<3>);

}  // namespace sightline
