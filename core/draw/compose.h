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
    std::string title;          ///< e.g. "step 12"; panels of one figure get (a), (b), … before it
    std::vector<Side> sides{};  ///< as PictureOptions::sides
};

template <int D>
PanelSource(Session<D>, std::string) -> PanelSource<D>;
template <int D>
PanelSource(Session<D>, std::string, std::vector<Side>) -> PanelSource<D>;

/// One figure of all panels with one legend and one scale; palette, legend and caption as in the first panel.
Figure make_figure(std::span<const PanelSource<2>> panels);
Figure make_figure(std::span<const PanelSource<3>> panels);

/// A film: a figure of one panel for each frame, all with the same legend, scale of the heat map and world, so that
/// nothing jumps from one to the next (write_figure_pages). A frame's caption is about its own step. frame(i) is asked
/// for in order, more than once, and read before it is asked for another: one session walks through a film. `frames` >
/// 0.
template <int D>
std::vector<Figure> make_film(std::size_t frames, const std::function<const PanelSource<D>&(std::size_t)>& frame);

}  // namespace sightline
