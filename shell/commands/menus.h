// The menus: which commands a person finds where. They have the words of the command table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shell/desk/workbench.h"

namespace sightline {

/// What a command with its argument is called where people look for it.
struct SpokenCommand {
    std::string label;  ///< two or three words
    std::string text;   ///< what it does, one line
    std::string keys;   ///< "Right, PageDown"
};

/// Of a text as keys and menus have it: "seek start", "tool gap", "open". Empty where the table does not know it.
template <int D>
SpokenCommand spoken(std::string_view command);

struct MenuRow {
    enum class Kind : std::uint8_t { command, line, menu, recent, methods, panels } kind = Kind::command;
    std::string command;  ///< with its argument
    bool asks = false;    ///< for the argument, in the command line
    SpokenCommand says{};
    std::vector<MenuRow> inside{};  ///< of a menu in the menu
};

struct Menu {
    std::string_view title;
    std::vector<MenuRow> rows;
};

/// In the order of the menu bar.
template <int D>
const std::vector<Menu>& menus();

/// What opens beside a row: for some it depends on the bench. Empty: nothing does.
template <int D>
std::vector<MenuRow> rows_inside(const Workbench<D>& bench, const MenuRow& row);

}  // namespace sightline
