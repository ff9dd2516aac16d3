// The tables of the papers with our numbers beside theirs: coverage by budget, and what preprocessing costs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lab/measure/results.h"

namespace sightline::lab {

/// TVCG table 1: coverage of `published` by budget on one scene and path.
struct Table1Row {
    std::string scene, path, papers_scene, method;
    std::vector<std::string> budgets;
    std::vector<double> ours, papers;  ///< shares; NaN: not there
};
std::vector<Table1Row> table_1(const Results& results);

/// A row per scene, tessellation and error bound.
struct PreprocessingRow {
    std::string scene, tessellation;
    double cells = 0, bytes_per_cell = 0, references_per_primitive = 0;
    double memory_share = 0;  ///< cells and references over the primitives themselves
    double seconds = 0;       ///< NaN: not known
    CellNumbers numbers{};    ///< of a row of ours
};
/// Rows of ours, each scene that stands for one of the papers' followed by that.
std::vector<PreprocessingRow> preprocessing(const Results& results);

/// What stands with the tables.
inline constexpr const char* table_1_caption =
    "Coverage in % by budget, theirs and ours. Their data are not available; generated scenes stand in for them, so "
    "that "
    "trends can be compared, not numbers.";
inline constexpr const char* preprocessing_caption =
    "Bytes per cell are those of the tessellation with its tree; the memory is that of cells and references over that "
    "of the primitives. Seconds are for building the cells and assigning the primitives. A line crosses so many cells "
    "in the mean over 1000 random ones (stabbing number, TVCG 3.1: the fewer, the cheaper the way to what is visible), "
    "and so does a ray from the eye to the border. TVCG 3 wants a uniform number of primitives per cell: the share of "
    "empty cells, the mean of the others and its spread (standard deviation over mean; 0 is uniform) say how far the "
    "cells are from it.";

/// A table in words, as a page or a text shows it.
struct TextTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  ///< the first cell is a name
};
TextTable text_table(const std::vector<Table1Row>& table);
TextTable text_table(const std::vector<PreprocessingRow>& table);
std::string html(const TextTable& table, const std::string& caption);
std::string markdown(const TextTable& table);

}  // namespace sightline::lab
