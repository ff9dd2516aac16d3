// What every method that orders cells leaves open.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/parameters.h"

namespace sightline {

enum class YesNo : std::uint8_t { no, yes };
enum class OutsideView : std::uint8_t { unseen, enqueue };
enum class Seeds : std::uint8_t { one, hull };
enum class BudgetCounts : std::uint8_t { each_once, per_cell };
/// What happens to a cell in the front that is reached again; never: it keeps its key, and none is computed.
enum class OnReenqueue : std::uint8_t { replace, min, max, never };

template <>
inline constexpr auto words<YesNo> = std::to_array<std::string_view>({"no", "yes"});
template <>
inline constexpr auto words<OutsideView> = std::to_array<std::string_view>({"unseen", "enqueue"});
template <>
inline constexpr auto words<Seeds> = std::to_array<std::string_view>({"one", "hull"});
template <>
inline constexpr auto words<BudgetCounts> = std::to_array<std::string_view>({"each_once", "per_cell"});
/// A heuristic that never re-enqueues says so itself: the parameter has the other three.
template <>
inline constexpr auto words<OnReenqueue> = std::to_array<std::string_view>({"replace", "min", "max"});

const ParameterRow& outside_view_row();
const ParameterRow& neighbours_before_break_row();
const ParameterRow& seeds_row();
const ParameterRow& budget_counts_row();
const ParameterRow& on_reenqueue_row();

struct CellParameters {
    OutsideView outside_view;
    YesNo neighbours_before_break;
    BudgetCounts budget_counts;

    explicit CellParameters(const Parameters& parameters)
        : outside_view(parameters.choice<OutsideView>(outside_view_row())),
          neighbours_before_break(parameters.choice<YesNo>(neighbours_before_break_row())),
          budget_counts(parameters.choice<BudgetCounts>(budget_counts_row())) {}
};

}  // namespace sightline
