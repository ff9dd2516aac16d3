// Hand-outs: what is on the bench as one HTML file that opens in any browser and shows just that.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shell/desk/workbench.h"

namespace sightline {

/// All that is on the bench, as a state file with one more member: where the lesson stands, the panel at the right, the
/// substep. Scenes that no generator makes travel inside.
template <int D>
std::string handout_text(const Workbench<D>& bench);

/// Whether it says where the lesson stands: only for lessons of the project, which every page has.
template <int D>
bool carries_lesson(const Workbench<D>& bench);

/// Opens it, or any other state file; `name` begins error lines. Throws InputError; then nothing has changed.
template <int D>
void open_handout(Workbench<D>& bench, const std::string& text, const std::string& name);

/// The page that `./run web` makes, with a hand-out in it in place of the one that it had, if any. Throws InputError
/// for a page that has no room for one; `name` begins the line.
std::string page_with(std::string_view page, const std::string& handout, const std::string& name);

/// Where `./run web` puts the page.
std::filesystem::path page_of_the_project();

/// Writes the page with the hand-out of the bench (in a browser the hand-out alone, for the page to put into itself).
/// Throws InputError where Workbench::page names none.
template <int D>
void write_page(Workbench<D>& bench, const std::string& file);

}  // namespace sightline
