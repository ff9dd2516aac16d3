// What the commands work on: one session, the figure it is put into, and where words for the person go.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/session/figure_spec.h"
#include "core/session/session.h"

namespace sightline {

struct Workbench {
    Session<2> session;
    FigureSpec figure;
    Stop last_stop = Stop::none;  ///< why the last move ended
    bool quit = false;
    std::function<void(const std::string&)> say;  ///< one line for the person
};

/// Runs forward to the budget or the end of the front.
void run_to_end(Workbench& bench);

/// To a step; last_stop is Stop::steps when it is there.
void go_to_step(Workbench& bench, std::uint32_t step);

/// Sets the size of figures. Throws InputError for what is none; the old size stays.
void set_figure_size(Workbench& bench, const std::string& size);

/// Writes the figure and beside it FILE.json, a state file that opens the same again.
void write_shot(Workbench& bench, const std::string& file);

/// Writes the text of stats, trace or state; the name "-" is standard output.
void write_text(const std::string& file, const std::string& text);

/// A point of the scene's file, as people write it ("X,Y"), in the coordinates of the session.
Vec<2> parse_point(const std::string& text, const Scene<2>& scene);

}  // namespace sightline
