// Measuring the trade-off (trade_off.h): while a person watches, and never in the way.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/draw/variant_look.h"
#include "shell/desk/workbench.h"

namespace sightline {

/// Frames of a path that are measured, spread evenly.
inline constexpr std::size_t trade_off_frames = 8;

/// Nothing plays, flies or is recorded: there is time to measure.
template <int D>
bool stands_still(const Workbench<D>& bench);

/// Begins anew where scene, cells, settings or path are others than those that are measured, and says why in
/// Trade-off::word; takes the session's method and budget along. The views are those of the chosen path, else the
/// culling view alone.
template <int D>
void update_trade_off(Workbench<D>& bench);

/// Forgets what is measured.
template <int D>
void restart_trade_off(Workbench<D>& bench);

/// update_trade_off, then slices until about so many milliseconds are over. True when there is more to do. An error
/// stops it, and is its word.
template <int D>
bool advance_trade_off(Workbench<D>& bench, double milliseconds);

/// "30 of 112", and whether it goes on or how long it still takes, if the rest takes as long as what is done.
template <int D>
std::string trade_off_progress_text(const Workbench<D>& bench);

/// What is being measured, for people; empty: nothing.
template <int D>
std::string trade_off_work_text(const Workbench<D>& bench);

/// What the times of the trade-off are, for an axis.
template <int D>
std::string trade_off_time_text(const Workbench<D>& bench);

/// The command that sets the method and the budget of a dot.
template <int D>
std::string trade_off_command(const Workbench<D>& bench, const TradeOffDot& dot);

/// How the variants that are measured look, in their order; with open markers on the leaves of a tree.
template <int D>
std::vector<VariantLook> trade_off_looks(const Workbench<D>& bench);

/// The session's method, written with the parameters that are not those that all methods share.
template <int D>
Variant<D> current_variant(const Workbench<D>& bench);

/// Whether the dot is that of the session's method and budget.
template <int D>
bool is_current(const Workbench<D>& bench, const TradeOffDot& dot);

/// By index of the dots, by time.
template <int D>
std::vector<std::size_t> pareto_dots(const Workbench<D>& bench);

}  // namespace sightline
