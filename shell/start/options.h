// The command line of both viewers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/methods/method_table.h"

namespace sightline {

/// What was asked for; empty or nothing: not asked.
struct Options {
    std::string scene;  ///< or a state file
    bool list = false, headless = false;
    std::string eye, look_at;
    std::string up;  ///< 3D
    std::optional<double> fov;
    std::string method, preset, budget;
    bool automatic = false;  ///< --auto
    std::string settings_file;
    std::vector<std::string> settings;
    std::optional<std::uint32_t> steps;
    std::string until, commands;
    std::string path;                     ///< 3D: of the scene, or a file
    std::optional<std::uint32_t> frame;   ///< of the path, from 0
    std::optional<std::uint32_t> frames;  ///< how many of them go into --stats
    std::string panels, size;
    std::optional<double> font_pt, dpi;
    std::optional<std::uint32_t> columns;
    std::vector<std::string> shots;
    std::string cells, state, trace, stats, page;
    std::optional<double> scale;               ///< of the window
    std::optional<std::array<int, 2>> window;  ///< its size

    bool writes() const { return !shots.empty() || !trace.empty() || !stats.empty(); }
};

/// Nothing when help was asked for (and printed). Throws InputError for wrong usage.
template <int D>
std::optional<Options> parse_options(int argc, const char* const* argv, std::span<const Method<D>> methods);

}  // namespace sightline
