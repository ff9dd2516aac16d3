// What the papers say of their scenes beside what this study finds on ours.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lab/measure/results.h"

namespace sightline::lab {

struct Claim {
    std::string source;  ///< "TVCG 5.1, table 1"
    std::string text;    ///< what the papers say
    std::string ours;    ///< what the study finds, with the scene that stands for theirs
    bool holds = false;
    const Row* row = nullptr;  ///< whose picture shows why not; nullptr for a claim about time
};

/// Those that the study can judge: it needs their scenes (city for CITY, cars for 5CBEM, room for ROOM), methods and
/// budgets. The papers' data are not to be had: shapes are compared, not figures. Rows are those of `results`.
std::vector<Claim> judge_claims(const Results& results);

/// TVCG table 1: coverage of `published` by budget, the papers' figures beside ours.
struct Table1Row {
    std::string scene, papers_scene, method;
    std::vector<std::string> budgets;
    std::vector<double> ours, papers;  ///< shares; NaN: not there
};
std::vector<Table1Row> table_1(const Results& results);

}  // namespace sightline::lab
