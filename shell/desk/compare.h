// Comparing: a second session beside the first (comparison.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "shell/desk/workbench.h"

namespace sightline {

/// Puts a session on the right. It shares the scene of the left one when it is the same bit for bit.
template <int D>
void compare_with(Workbench<D>& bench, Session<D> other, const std::string& title, Align align = Align::step);

/// The left one again, with other settings. Throws InputError for a method that does not exist; then nothing has
/// changed.
template <int D>
void compare_settings(Workbench<D>& bench, const Settings& settings, const std::string& title);

/// Nothing on the right.
template <int D>
void compare_off(Workbench<D>& bench);

/// How the right one is moved along. This and the next two throw InputError when there is none.
template <int D>
void align_with(Workbench<D>& bench, Align align);

/// Of the whole runs; there must be a second session. Made once for each pair of runs.
template <int D>
const Difference& first_difference(const Workbench<D>& bench);

/// Both to the first step that differs, if there is one.
template <int D>
void go_to_difference(Workbench<D>& bench);

/// Left becomes right. Breakpoints and bookmarks stay on the left. Undo begins anew.
template <int D>
void swap_sides(Workbench<D>& bench);

/// A setting in which the two sides differ, other than settings of the picture.
struct SettingPair {
    std::string_view name;
    std::string left, right;
};
std::vector<SettingPair> different_settings(const Settings& left, const Settings& right);

/// A few words for each side that tell them apart.
template <int D>
std::array<std::string, 2> side_titles(const Workbench<D>& bench);

/// What stands over a side's picture: who it is, and what came of it.
struct SideHead {
    std::string title;
    std::string drawn;    ///< "101 drawn"
    std::string visible;  ///< "10 of 22 visible"; empty while that is concealed (show_visibility) or not known

    /// "no penalty · 101 drawn · 10 of 22 visible"
    std::string text() const;
};
template <int D>
SideHead side_head(const Session<D>& session, std::string title);

}  // namespace sightline
