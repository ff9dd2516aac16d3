// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cells/cell_parameters.h"

namespace sightline {

const ParameterRow& outside_view_row() {
    static const ParameterRow row = choice_row("outside_view", OutsideView::unseen, "gem, add_neighbors_to_front",
                                               "cells outside the view are marked unseen, or enqueued like others");
    return row;
}

const ParameterRow& neighbours_before_break_row() {
    static const ParameterRow row =
        choice_row("neighbours_before_break", YesNo::yes, "TVCG fig. 4, lines 4-6",
                   "whether a cell's neighbours are still enqueued when the budget ends inside it");
    return row;
}

const ParameterRow& seeds_row() {
    static const ParameterRow row =
        choice_row("seeds", Seeds::one, "docs/algorithm.md, seeds",
                   "where an eye outside all cells starts: the nearest cell, or every hull cell facing it");
    return row;
}

const ParameterRow& budget_counts_row() {
    static const ParameterRow row =
        choice_row("budget_counts", BudgetCounts::each_once, "gem, project",
                   "each primitive counts once, or all those of each cell, which is then rendered whole");
    return row;
}

const ParameterRow& on_reenqueue_row() {
    static const ParameterRow row =
        choice_row("on_reenqueue", OnReenqueue::replace, "TVCG fig. 4, line 10",
                   "the key of a cell reached again: the new one, the smaller, or the larger of the two");
    return row;
}

}  // namespace sightline
