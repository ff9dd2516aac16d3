// What the window remembers for a person from one time to the next: its place, the arrangement, what was opened.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shell/desk/desk.h"
#include "shell/window/placement.h"

namespace sightline {

struct Memory {
    Placement placement;
    Desk desk;                        ///< its lasting parts; the rest is as at a first start
    std::vector<std::string> recent;  ///< what `open` took, newest first
};

/// The desk without what belongs to the moment: projector mode, overlays, tool, the timeline's zoom.
Desk lasting(const Desk& desk);

std::string memory_json(const Memory& memory);
/// Throws InputError for anything but what memory_json writes: wrong types, absurd numbers, panels that do not exist.
template <int D>
Memory read_memory(const std::string& text, const std::string& name);

/// PROGRAM.json in sightline's folder under $XDG_CONFIG_HOME or ~/.config; empty where neither is known.
std::filesystem::path memory_file(const std::string& program);

struct Recalled {
    Memory memory;     ///< as at a first start where there is nothing to recall
    std::string word;  ///< what went wrong; empty: nothing
};

/// Reads the file. A damaged one is set aside as FILE.damaged, FILE.damaged2, …
template <int D>
Recalled recall(const std::filesystem::path& file);

/// Writes the file, and makes its folder. `known`: the names that were in the file when it was read or written last;
/// those that other windows have put there since stay. Returns the names that are in it now. Throws WorkError.
template <int D>
std::vector<std::string> keep(const std::filesystem::path& file, Memory memory, const std::vector<std::string>& known);

}  // namespace sightline
