// What leaves the bench: figures with their sidecars, and texts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"
#include "shell/figure/figure.h"

namespace sightline {

/// The size that a figure's words ask for ("84mm", "1280x720"). Throws InputError for what is none.
FigureSize figure_size(const FigureSpec& spec);

/// Sets the size of figures. Throws InputError for what is none; the old size stays.
template <int D>
void set_figure_size(Workbench<D>& bench, const std::string& size);

/// Writes the figure and beside it FILE.json, a state file that opens the same again.
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
