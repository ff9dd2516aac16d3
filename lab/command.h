// The commands of the lab: `lab COMMAND …`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "core/methods/method_table.h"

namespace sightline::lab {

struct Command {
    std::string_view id;
    std::string_view text;  ///< one sentence
    /// Arguments as main has them, argv[0] being "lab COMMAND". Returns the exit status; throws InputError, WorkError.
    int (*run)(int argc, const char* const* argv, const MethodTables& tables);
};

std::span<const Command> commands();

/// The program: argv as main has it. Another table of methods makes a lab that measures those. Returns the exit status
/// and writes errors to standard error.
int lab_program(int argc, const char* const* argv, const MethodTables& tables = {});

int measure_command(int argc, const char* const* argv, const MethodTables& tables);
int gallery_command(int argc, const char* const* argv, const MethodTables& tables);
int merge_command(int argc, const char* const* argv, const MethodTables& tables);
int stability_command(int argc, const char* const* argv, const MethodTables& tables);
int cells_command(int argc, const char* const* argv, const MethodTables& tables);
int compare_command(int argc, const char* const* argv, const MethodTables& tables);
int viewpoint_command(int argc, const char* const* argv, const MethodTables& tables);
int object_space_command(int argc, const char* const* argv, const MethodTables& tables);
int sets_command(int argc, const char* const* argv, const MethodTables& tables);
int reduce_command(int argc, const char* const* argv, const MethodTables& tables);

}  // namespace sightline::lab
