// The command table: everything a person can do. Keys, menus, --do and scripts run these same entries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "shell/commands/workbench.h"

namespace sightline {

struct Command {
    std::string_view id;
    std::string_view arguments;  ///< as help shows them
    std::string_view text;       ///< what it does, one line
    std::string_view key;        ///< the key of the window; empty: none
    void (*run)(Workbench&, const std::string& argument);
};

std::span<const Command> command_table();

/// Runs "COMMAND; COMMAND; …" until the end or quit. A ';' inside double quotes does not separate. Throws InputError
/// that names the command; those before it have been carried out.
void run_commands(Workbench& bench, std::string_view text);

}  // namespace sightline
