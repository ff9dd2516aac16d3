// What one change would make of what is selected, kept as long as selection and traversal stay.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

/// The selected primitive, else the selected cell; of kind none: nothing is selected.
template <int D>
Item selected_item(const Workbench<D>& bench);

/// The one that is kept, where it is of the selection and of this traversal; else nullptr.
template <int D>
const Counterfactuals* what_if(const Workbench<D>& bench);

/// Makes it where something is selected and it is not there; `however_long`: also where it may take more than a moment.
/// True when it was made now.
template <int D>
bool update_what_if(Workbench<D>& bench, bool however_long = false);

}  // namespace sightline
