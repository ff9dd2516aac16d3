// What would have become of a primitive or a cell with one thing changed: each single change is run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/session/session.h"

namespace sightline {

/// What becomes of a primitive or a cell in a run from its start to its end.
struct Outcome {
    std::uint32_t step = 0;   ///< that meets the primitive or projects the cell; 0: none does
    bool culled = false;      ///< met, but found outside the view
    Stop stop = Stop::none;   ///< why the run ended before, where no step does
    std::uint32_t steps = 0;  ///< that the run took: up to `step`, else to its end
    bool operator==(const Outcome&) const = default;
};

/// One thing changed, written as `--set` takes it: "on_reenqueue=min".
struct Alternative {
    std::string change;
    Outcome outcome;
};

struct Counterfactuals {
    Item item;
    Outcome now;
    std::vector<Alternative> changes;  ///< those that bring it sooner first, then by step, those without it last
};

/// With one parameter of the method changed, else the session's parameters and budget. `item` is a cell or a primitive.
/// Throws InputError for a value that cannot be.
template <int D>
Outcome outcome_with(const Session<D>& session, const Item& item, const ParameterRow& row, std::string_view value);

/// Every other word of each parameter that is a choice, half and twice each number, no budget where there is one; for
/// a primitive with `seeds`, other seeds of the tessellation, 1 to 5, which take as long as tessellating. The session's
/// position does not matter. Cost: a run each, up to the step that the item comes in.
template <int D>
Counterfactuals counterfactuals(const Session<D>& session, const Item& item, bool seeds = false);

/// How many steps counterfactuals() may take at most, without `seeds`: to say beforehand whether that is quick.
template <int D>
std::uint64_t most_steps(const Session<D>& session);

/// Whether the item comes at another time, or otherwise.
bool differs(const Outcome& a, const Outcome& b);

/// "step 550", "not within the budget, 812 steps", …
std::string outcome_words(const Outcome& outcome);

/// The outcome now, a line for each change that makes a difference, and one for all that make none.
std::vector<std::string> rows(const Counterfactuals& all);

}  // namespace sightline
