// What `lab object-space` found, as tables beside the paper's, as claims, JSON and a page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "lab/measure/conditions.h"
#include "lab/object_space/object_space.h"
#include "lab/report/claims.h"
#include "lab/report/papers_tables.h"

namespace sightline::lab {

struct ObjectSpaceScene {
    std::string name;
    std::vector<std::uint64_t> seeds;              ///< the first one is that of the catalogue
    std::vector<Construction> construction;        ///< of the first seed
    std::vector<std::vector<AllRound>> all_round;  ///< per seed, by method
    std::vector<AtSpeed> speeds;                   ///< of the first seed, as all below
    std::vector<WithWorkers> workers;
    std::vector<InView> in_view;  ///< the first one is view culling
};

struct ObjectSpaceResults {
    Conditions conditions;
    ObjectSpaceOptions options;
    std::vector<ObjectSpaceScene> scenes;
};

/// What view culling spends on what the method hides: its frame less the drawing of what the method leaves.
double hidden_ms(const InView& view, const InView& method);
/// Culled::share(), the mean over the seeds.
double mean_cull(const ObjectSpaceScene& scene, std::size_t method);

/// ".806": a share as the paper writes it.
std::string share_text(double value);

struct TitledTable {
    std::string title, caption;
    TextTable table;
};

/// Tables 1 to 4 with the paper's rows above ours, and what a frame costs in a view; those without rows are left out.
std::vector<TitledTable> object_space_tables(const ObjectSpaceResults& results);

/// What the paper says, judged on each scene that stands for one of its own, and what we ask of the method.
std::vector<Claim> object_space_claims(const ObjectSpaceResults& results);

/// For the console: columns that stand under one another.
std::string plain_text(const TitledTable& table);

std::string object_space_json(const ObjectSpaceResults& results);

/// results.json and object-space.html. Throws WorkError.
void write_object_space(const ObjectSpaceResults& results, const std::filesystem::path& folder);

/// As a part of a page of documentation, from "## " on. `command` is what made it.
std::string object_space_markdown(const ObjectSpaceResults& results, const std::string& command);

}  // namespace sightline::lab
