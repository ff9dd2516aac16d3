// The claims of the papers, a row each, with the function that judges it on one scene and path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/report/claims.h"
#include "lab/report/study_charts.h"

namespace sightline::lab {

/// Where a claim is judged, and what else the study measured.
struct Place {
    const Group& here;
    const std::vector<Group>& all;

    /// nullptr when it was not measured here.
    const Row* row(const std::string& method, const std::string& budget) const;
};

enum class Frames : std::uint8_t { whole_path, neighbours };

struct ClaimRow {
    const char *source, *text, *test;
    std::vector<std::string> scenes;  ///< by the papers' names
    Frames frames;
    /// Nothing where a row or a number is missing. Scene and path are filled in by the caller.
    std::optional<Regime> (*judge)(const Place& place);
};

std::span<const ClaimRow> claim_table();

}  // namespace sightline::lab
