// The scenes that come with the program: an explicit table, shared by viewers, tests and benchmarks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace sightline {

/// A setting that the scene's lesson starts with and that differs from the default; both as on the command line.
struct SettingOverride {
    const char* field;
    const char* value;
};

/// A place in the traversal worth stopping at; the condition is one that --until takes.
struct CatalogueBookmark {
    const char* condition;
    const char* label;
};

struct CatalogueRow {
    const char* id;
    std::uint64_t seed;
    const char* title;
    const char* lesson;  ///< one sentence for students
    std::vector<Primitive<2>> (*generate)(std::uint64_t seed);
    ViewSpec<2> view;
    double error_bound;  ///< the largest side of a leaf, as a share of the longest side of the scene
    const char* method;  ///< id of the method to start with
    const char* budget;  ///< as --budget takes it
    std::vector<SettingOverride> settings;
    std::vector<CatalogueBookmark> bookmarks;
};

/// All rows, in the order in which a lecture would show them.
std::span<const CatalogueRow> catalogue();

/// nullptr when no row has this id.
const CatalogueRow* find_in_catalogue(std::string_view id);

/// The row's scene, cleaned; origin 0, source "generated". The same bits on every machine.
Scene<2> make_scene(const CatalogueRow& row);

}  // namespace sightline
