// A second session beside the first: left is the one that a person moves and changes, right goes along.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/comparison.h"

namespace sightline {

template <int D>
struct Workbench;

/// Where the two runs first differ.
struct Difference {
    std::uint32_t step = none;  ///< from 1; none: they agree to the end
    std::string sentence;
    std::uint64_t run = 0;  ///< Workbench::run that it was made for
};

/// The session on the right.
template <int D>
struct Other {
    Session<D> session;
    Align align = Align::step;
    std::string title;  ///< what was asked for: "centroid", "jitter=0.1", a file

    // The left side's as they were when this one was last moved along, to see what has changed there.
    std::shared_ptr<const Scene<D>> lead_scene{};
    ViewSpec<D> lead_view{};
    mutable std::optional<Difference> difference{};  ///< made on first use
};

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

/// Moves the right one along; part of moved(), and alone after changes of notes and selection, which leave the middle
/// of a step as it is. The right one gets the left one's new scene and view when both had the same scene.
template <int D>
void take_along(Workbench<D>& bench);

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

}  // namespace sightline
