// What the papers say of their scenes beside what this study finds on ours.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/measure/results.h"

namespace sightline::lab {

/// A scene and path on which a claim is judged.
struct Regime {
    std::string scene, path;
    std::string figures;  ///< what the study finds there
    bool holds = false;
    const Row* row = nullptr;  ///< whose picture shows why not; nullptr for a claim about time
};

struct Claim {
    std::string source;           ///< "TVCG 5.2.3, table 1"
    std::string text;             ///< what the papers say
    std::string test;             ///< when we say that it holds; empty where the text says it
    std::vector<Regime> regimes;  ///< at least one
};

/// Those that the study can judge, on each scene and path that stands for one of the papers': city for CITY, cars for
/// 5CBEM, room for ROOM, plant for the gem's power plant (PLANT), soda, blocks and tetra for the models of Coorg and
/// Teller. They need methods and budgets; what needs
/// neighbouring frames is judged on parts of paths (part_of_path), the rest on whole ones. The papers' data are not to
/// be had: shapes are compared, not figures. Rows are those of `results`.
std::vector<Claim> judge_claims(const Results& results);

enum class Judgement : std::uint8_t { holds, fails, depends };
Judgement judgement(const Claim& claim);
/// "holds", "does not hold", "depends (on path, on size)": on what its regimes differ in where they disagree.
std::string verdict_text(const Claim& claim);
/// "city:100k, street: 97 % (holds)"; the outcome only where the claim depends.
std::string regime_text(const Claim& claim, const Regime& regime);
/// That of the first regime that does not hold and has one.
const Row* row_to_show(const Claim& claim);

/// As a JSON array for results.json.
std::string claims_json(const std::vector<Claim>& claims);

/// What stands under the claims.
inline constexpr const char* claims_note =
    "Speeds are judged against view culling (method view), since the papers cull what is out of view or turns its back "
    "in all that they compare. The papers' data are not available: generated scenes stand in for them, so trends can "
    "be "
    "compared, not numbers. Our reading of the formula and the renderer differ too.";

/// The papers' name for a scene that stands for one of theirs, else nullptr.
const char* papers_name(const std::string& scene);

}  // namespace sightline::lab
