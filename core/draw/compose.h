// Pictures of sessions as one figure: panels, legend, scale and caption.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/session/comparison.h"
#include "core/session/session.h"

namespace sightline {

template <int D>
struct PanelSource {
    Session<D> session;
    std::string title;                   ///< e.g. "step 12"; panels of one figure get (a), (b), … before it
    std::vector<Differs> differences{};  ///< as PictureOptions::differences
};

template <int D>
PanelSource(Session<D>, std::string) -> PanelSource<D>;
template <int D>
PanelSource(Session<D>, std::string, std::vector<Differs>) -> PanelSource<D>;

/// One figure of all panels with one legend and one scale; palette, legend and caption as in the first panel.
Figure make_figure(std::span<const PanelSource<2>> panels);
Figure make_figure(std::span<const PanelSource<3>> panels);

/// A figure for each frame, all with the same legend, scale of the heat map and world, so that nothing jumps from one
/// to the next (write_figure_pages). A frame's caption is about its own step.
struct Film {
    std::vector<Figure> plan;                 ///< all that decides where things stand, but pictures of some frames only
    std::function<Figure(std::size_t)> page;  ///< the whole figure, made when it is asked for
};

/// The panels of a frame; those of one film have equally many. They are read before another frame is asked for: one
/// session may walk through a film.
template <int D>
using FilmFrame = std::function<std::span<const PanelSource<D>>(std::size_t)>;

/// Asks for the frames in order, twice; the film keeps `frame` and asks it again for each page. `frames` > 0.
template <int D>
Film make_film(std::size_t frames, FilmFrame<D> frame);

}  // namespace sightline
