// The command table: everything a person can do. Keys, menus, the help sheet, --do and scripts run these same entries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "shell/commands/command.h"

namespace sightline {

/// Commands of one subject: a menu, a paragraph of help. Each group is a file of this folder, NAME_commands.cpp.
template <int D>
struct CommandGroup {
    std::string_view title;
    std::span<const Command<D>> commands;
};

template <int D>
std::span<const CommandGroup<D>> command_groups();

/// All groups in one list.
template <int D>
std::span<const Command<D>> command_table();

/// Runs "COMMAND; COMMAND; …" until the end or quit. A ':' before a command is ignored. A ';' inside double quotes does not separate, and two double
/// quotes there are one. Throws InputError that names the command; those before it have been carried out.
template <int D>
void run_commands(Workbench<D>& bench, std::string_view text);

/// What a person is to be told before run_commands takes this text (Command::slow); empty: nothing, also for a text
/// that it refuses.
template <int D>
std::string_view slow_word(std::string_view text);

/// One command as run_commands takes it, whatever characters it has.
std::string quote_command(std::string_view command);

}  // namespace sightline
