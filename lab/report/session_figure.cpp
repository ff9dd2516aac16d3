// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/session_figure.h"

#include "core/draw/compose.h"
#include "shell/figure/figure.h"

namespace sightline::lab {

template <int D>
std::string write_session_figure(const Session<D>& session, const std::filesystem::path& file,
                                 const DrawSolid& draw_solid) {
    const PanelSource<D> panel{session, ""};
    Figure figure = make_figure(std::span(&panel, 1));
    const std::string caption = std::move(figure.caption);
    figure.caption.clear();
    FigureSize size;
    size.width_mm = 130;
    size.dpi = 192;  // twice that of a screen
    write_figure(figure, size, file, draw_solid);
    return caption;
}

template std::string write_session_figure<2>(const Session<2>&, const std::filesystem::path&, const DrawSolid&);
template std::string write_session_figure<3>(const Session<3>&, const std::filesystem::path&, const DrawSolid&);

}  // namespace sightline::lab
