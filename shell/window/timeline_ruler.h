// The words over the timeline: numbers, budgets and the end of the run, none over another. Pure functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shell/window/timeline_axis.h"

namespace sightline {

/// A share of the scene that is spent after a step.
struct BudgetTick {
    std::uint32_t step = 0;
    std::string label;  ///< e.g. "5 %"
};

struct RulerLabel {
    enum class Kind : std::uint8_t { number, end };
    Kind kind = Kind::number;
    std::string text;
    float at = 0;           ///< what it names
    float left = 0, w = 0;  ///< where the text goes
};

/// The end of the run first, then as many numbers as have room. All lie between the ends of the axis if they fit;
/// `width` measures a text, `gap` is kept between two.
std::vector<RulerLabel> ruler_labels(const StepAxis& axis, const std::function<float(const std::string&)>& width,
                                     float gap);

/// The budgets, on a line of their own; they join their words where they would overlap.
std::vector<RulerLabel> budget_labels(const StepAxis& axis, const std::vector<BudgetTick>& budgets,
                                      const std::function<float(const std::string&)>& width, float gap);

}  // namespace sightline
