// What leaves the bench: figures with their sidecars, and texts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"
#include "shell/figure/figure.h"

namespace sightline {

/// The size that a figure's words ask for ("84mm", "1280x720"). Throws InputError for what is none.
FigureSize figure_size(const FigureSpec& spec);

/// Sets the size of figures, with "8pt" that of their text, with "600dpi" the resolution of PNGs in millimetres. Throws
/// InputError for what is none; the old size stays.
template <int D>
void set_figure_size(Workbench<D>& bench, const std::string& size);

/// The figure of what is on the bench.
template <int D>
Figure shot_figure(const Workbench<D>& bench);

/// Writes the figure and beside it FILE.json, a state file that opens the same again. Says, there too, what the figure
/// does not show as it was asked for.
template <int D>
void write_shot(Workbench<D>& bench, const std::string& file);

/// The state file of all that is on the bench, with the second session.
template <int D>
std::string bench_state(const Workbench<D>& bench);

/// Writes the tessellation and the assignment of the session on the bench (cells_file.h).
template <int D>
void write_cells(Workbench<D>& bench, const std::string& file);

/// Writes the text of stats, trace or state; the name "-" is standard output.
void write_text(const std::string& file, const std::string& text);

}  // namespace sightline
