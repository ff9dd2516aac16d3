// The groups that the command table is made of, one per file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "shell/commands/command.h"

namespace sightline {

template <int D>
std::span<const Command<D>> move_commands();
template <int D>
std::span<const Command<D>> lesson_commands();
template <int D>
std::span<const Command<D>> view_commands();
template <int D>
std::span<const Command<D>> flight_commands();
template <>
std::span<const Command<2>> flight_commands<2>();
template <>
std::span<const Command<3>> flight_commands<3>();
template <int D>
std::span<const Command<D>> path_commands();
template <int D>
std::span<const Command<D>> change_commands();
template <int D>
std::span<const Command<D>> compare_commands();
template <int D>
std::span<const Command<D>> trade_off_commands();
template <int D>
std::span<const Command<D>> edit_commands();
template <>
std::span<const Command<2>> edit_commands<2>();
template <>
std::span<const Command<3>> edit_commands<3>();
template <int D>
std::span<const Command<D>> mark_commands();
template <int D>
std::span<const Command<D>> note_commands();
template <int D>
std::span<const Command<D>> say_commands();
template <int D>
std::span<const Command<D>> file_commands();
template <int D>
std::span<const Command<D>> desk_commands();

}  // namespace sightline
