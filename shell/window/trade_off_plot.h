// Where the dots and the numbers of the trade-off's chart stand. Pure functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "shell/desk/workbench.h"
#include "shell/window/ui.h"

namespace sightline {

/// x is the logarithm of milliseconds, y per cent from 0.
struct TradeOffPlot {
    struct Dot {
        std::size_t index = 0;  ///< into TradeOffStudy::dots
        ImVec2 at;
    };
    struct Tick {
        float at = 0;
        std::string text;
    };
    Area area;
    std::vector<Dot> dots;  ///< that have a value; by method, then by budget, as a line joins them
    std::vector<Tick> times, shares;
};

/// Every dot inside `area`, and a few numbers on each axis.
template <int D>
TradeOffPlot trade_off_plot(const Workbench<D>& bench, const Area& area);

/// The nearest one to the mouse, at most `reach` away; nullptr when there is none.
const TradeOffPlot::Dot* dot_at(const TradeOffPlot& plot, const ImVec2& mouse, float reach);

}  // namespace sightline
