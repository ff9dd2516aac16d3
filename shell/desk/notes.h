// Changes of the notes that more than one command makes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"

namespace sightline {

/// The note of this index.
template <int D>
void delete_note(Workbench<D>& bench, std::uint32_t index);

}  // namespace sightline
