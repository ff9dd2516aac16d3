// The options that all commands that measure share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "lab/measure/study.h"

namespace sightline::lab {

/// What was typed, before it is understood.
struct StudyOptions {
    std::vector<std::string> scenes, paths, settings, methods, budgets;
    std::uint32_t frames = 0, repeats = 3;
    std::string size, settings_file;
};

/// Adds SCENE…, --path, --frames, --methods, --budgets, --size, --set, --settings and --repeats to a command line.
/// `timed`: false leaves out --repeats.
void add_study_options(CLI::App& app, StudyOptions& options, bool timed = true);

/// Where neither scenes nor paths are asked for: what the papers' claims are judged on (lab/report/claims.h). CITY from
/// the street and from the air at two sizes, ROOM from inside and outside, and neighbouring frames for what changes
/// between them; 8 frames of each path unless others are asked for.
void ask_for_claims(StudyOptions& options);

/// Throws InputError that names the option.
Study study_of(const StudyOptions& options, const MethodTables& tables);

/// Parses; false when help was asked for (and printed). Throws InputError for wrong usage.
bool parse(CLI::App& app, int argc, const char* const* argv);

}  // namespace sightline::lab
