// What a command is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "shell/desk/workbench.h"

namespace sightline {

/// An argument that menus and the list of keys call by a name of its own: "seek start" is "Go to the start".
struct NamedArgument {
    std::string_view label, argument;
};

template <int D>
struct Command {
    std::string_view id;
    std::string_view label;      ///< in menus and in the list of keys, two or three words
    std::string_view arguments;  ///< as help shows them
    std::string_view text;       ///< what it does, one line
    /// Keys of the window, separated by spaces: KEY runs it without an argument, KEY=ARGUMENT with one, and KEY=? opens
    /// the line to type the argument into. KEY is e.g. Right, Ctrl+Shift+Z, F1, PageDown, Space, ].
    std::string_view keys;
    void (*run)(Workbench<D>&, const std::string& argument);
    std::string_view slow{};  ///< what a person is told before it begins, where it takes seconds; empty: it does not
    std::span<const NamedArgument> named{};
};

}  // namespace sightline
