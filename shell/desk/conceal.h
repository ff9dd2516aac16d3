// The key that a class has to find: kept out of the words that it may read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shell/desk/workbench.h"

namespace sightline {

/// The cell whose key the next press of the lesson tells; none without an exercise, or where the cell does not wait.
template <int D>
std::uint32_t concealed_cell(const Workbench<D>& bench);

/// Whether the class is asked which cell comes next: then nothing points at one.
template <int D>
bool asks_for_cell(const Workbench<D>& bench);

/// The text with ? for that key, to whatever number of digits it is written. A whole number is too common to hide
/// wherever it stands: it goes where words make it a key. Equal keys of other cells go too.
template <int D>
std::string conceal(const Workbench<D>& bench, std::string text);

}  // namespace sightline
