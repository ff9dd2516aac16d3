// What commands, panels and the window work on: a session with what a person does to it. Plain data; the functions that
// change it stand beside it in this folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/draw/key_light.h"
#include "core/session/counterfactual.h"
#include "core/session/figure_spec.h"
#include "core/session/missed.h"
#include "core/session/object_report.h"
#include "core/session/session.h"
#include "shell/desk/comparison.h"
#include "shell/desk/desk.h"
#include "shell/desk/flight.h"
#include "shell/desk/graphics.h"
#include "shell/desk/history.h"
#include "shell/desk/trade_off.h"
#include "shell/desk/transport.h"
#include "shell/lesson/teaching.h"

namespace sightline {

/// The clipboard of the window; both empty without one.
struct Clipboard {
    std::function<std::string()> get;
    std::function<void(const std::string&)> set;
};

/// Position of a named widget of the window, in its units, y down: for scripts and screen readers.
struct Place {
    std::string name;
    double x = 0, y = 0, w = 0, h = 0;
};

/// What one change would make of what was selected in a traversal (what_if.h).
struct WhatIf {
    std::uint64_t run = 0;  ///< Workbench::run
    Counterfactuals all;
};

/// What the whole run of the session misses (faults.h).
struct Faults {
    std::uint64_t run = 0;  ///< Workbench::run
    ImageSize size;         ///< of the reference
    Missed missed;
    std::optional<std::vector<ObjectReport>> objects{};  ///< those that matter most first
};

/// The budget that `complete` has set, and the one before; the step at which it was asked for, and that at which the
/// rounds begin: the steps between them rendered nothing new.
struct Completing {
    Budget before, now;
    std::uint32_t asked_at = 0, rounds_from = 0;
};

template <int D>
class ViewpointTable;  // core/methods/by_viewpoint/viewpoint_table.h

/// Entries of a table by viewpoint that are being worked out (work_out.h): places from `first` to before `end`.
template <int D>
struct WorkOut {
    std::shared_ptr<const ViewpointTable<D>> table;
    std::size_t first = 0, end = 0;
    std::size_t known_before = 0;  ///< of these
};

template <int D>
struct Workbench {
    Session<D> session;           ///< where it stands, and what is noted, marked and selected in it
    FigureSpec figure{};          ///< how figures are written
    Stop last_stop = Stop::none;  ///< why the last move ended
    bool quit = false;
    std::function<void(const std::string&)> say{};           ///< one line for the person
    std::span<const Method<D>> methods = method_table<D>();  ///< those that `method` can choose

    std::optional<std::uint32_t> substep{};  ///< where in the last step (step into); none: between two steps
    std::optional<Other<D>> other{};         ///< a second session, on the right
    bool record_ahead = false;               ///< keep the whole run recorded, for a timeline that shows where it leads
    Transport transport{};
    History<D> history{};
    std::vector<std::uint32_t> marked{};  ///< steps that `mark` found
    std::string marked_by{};              ///< its condition
    std::uint32_t hovered_cell = none;    ///< under the mouse, in whatever part of the window
    KeyLight lit{};                       ///< the term of a key that is under the mouse, for the picture to show
    std::uint32_t selected_note = none;   ///< index; being moved or edited
    Flight<D> flight{};
    Desk desk{};
    Clipboard clipboard{};
    std::vector<std::string> recent{};  ///< what `open` took, newest first
    std::vector<Place> places{};        ///< written anew by each frame of the window
    Graphics graphics{};                ///< 3D
    std::optional<Completing> completing{};
    TradeOff<D> trade_off{};
    std::filesystem::path auto_file{};  ///< where what `auto` measured is remembered; empty: nowhere
    std::filesystem::path page{};       ///< that hand-outs are made of; empty: the one that ./run web makes
    std::optional<WhatIf> what_if{};
    std::optional<Faults> faults{};
    std::optional<std::array<int, 2>> pixel{};  ///< 3D: column and row of the exact image, whose history is told
    std::optional<Teaching> teaching{};         ///< the lesson that is being given
    std::vector<Lesson> lessons{};              ///< those that the desk lists
    std::optional<WorkOut<D>> work_out{};
    bool attended = false;  ///< a window goes on with long work between its frames

    /// Counts the traversals: what was derived from the recording is made again when this has changed.
    std::uint64_t run = 0;
};

}  // namespace sightline
