// The commands of the lab: `lab COMMAND …`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace sightline::lab {

struct Command {
    std::string_view id;
    std::string_view text;  ///< one sentence
    /// Arguments as main has them, argv[0] being "lab COMMAND". Returns the exit status; throws InputError, WorkError.
    int (*run)(int argc, const char* const* argv);
};

std::span<const Command> commands();

int measure_command(int argc, const char* const* argv);
int gallery_command(int argc, const char* const* argv);
int merge_command(int argc, const char* const* argv);
int stability_command(int argc, const char* const* argv);
int cells_command(int argc, const char* const* argv);
int compare_command(int argc, const char* const* argv);
int reduce_command(int argc, const char* const* argv);

}  // namespace sightline::lab
