// What a study found: a row per scene, method and budget, with every frame. Written and read as results.json.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/measure_table.h"
#include "core/measure/summary.h"
#include "core/space/density.h"
#include "core/space/stabbing.h"
#include "lab/measure/conditions.h"
#include "lab/measure/study.h"

namespace sightline::lab {

/// The tessellation of a row.
struct CellNumbers {
    double seconds = std::numeric_limits<double>::quiet_NaN();  ///< to build it and to assign the primitives
    std::size_t cell_bytes = 0, reference_bytes = 0, scene_bytes = 0;
    std::size_t references = 0;  ///< from cells to primitives
    Stabbing lines, eye_rays;    ///< random lines; rays from the eyes of the frames
    Density density;
};

/// One scene, path, method and budget.
struct Row {
    std::string scene, path;
    MethodChoice method;
    bool approximate = true;
    std::string budget;      ///< as asked for, e.g. "5%"
    double error_bound = 0;  ///< of the tessellation
    std::uint32_t primitives = 0, cells = 0;
    std::size_t memory_bytes = 0;  ///< tessellation and references
    CellNumbers tessellation{};
    std::string reference;  ///< "exact, item buffer 8192", "item buffer 1024x768" or "software item buffer …"
    std::vector<std::uint32_t> frames;  ///< of the path
    std::vector<Values> values;         ///< one per frame
};

/// A frame with a budget in time: what the method rendered in it, and milliseconds. The total is the whole frame's.
struct TimedFrame {
    std::uint32_t rendered = 0;
    double traverse_ms = 0, upload_ms = 0, draw_ms = 0, total_ms = 0;
};
/// One scene, path, method and budget in time: frames one after the other, all repeats.
struct TimedFlight {
    std::string scene, path;
    MethodChoice method;
    std::string budget;
    double budget_ms = 0;
    std::vector<TimedFrame> frames;
};

/// A frame whose budget follows the wrong pixels of those before.
struct WrongFrame {
    std::uint32_t budget = 0, rendered = 0;  ///< primitives
    double wrong = 0;                        ///< share of pixels
    std::uint32_t needed = 0;                ///< the smallest budget that would have done; none: none does
};
/// One scene, path, method and share of wrong pixels.
struct WrongFlight {
    std::string scene, path;
    MethodChoice method;
    double wrong = 0;
    std::vector<WrongFrame> frames;
};

struct Results {
    Conditions conditions;
    std::vector<Row> rows;
    std::vector<TimedFlight> flights{};        ///< whether budgets in time were kept
    std::vector<WrongFlight> wrong_flights{};  ///< whether budgets in wrong pixels were
};

/// Flights as JSON of one line, and back.
std::string flights_json(const std::vector<TimedFlight>& flights);
std::vector<TimedFlight> read_flights(std::string_view json);
std::string wrong_flights_json(const std::vector<WrongFlight>& flights);
std::vector<WrongFlight> read_wrong_flights(std::string_view json);

/// sightline::summary of the frames.
double summary(const Row& row, Measure measure);
/// That of the worst frame: the least for what is better when higher, else the largest.
double worst(const Row& row, Measure measure);
/// The frame (index into Row::frames) that has it; 0 where none has a value.
std::size_t worst_frame(const Row& row, Measure measure);
/// Frames per second: of 1000 / total_ms over frames; NaN where it was not timed.
Spread hz(const Row& row);
/// Means over frames of Values::wrong_at or Values::pixels_at.
DistanceBins mean_of(const Row& row, DistanceBins Values::*at);
/// Pearson's r between the visible primitives that were rendered and the visible ones, over frames (field notes C2);
/// NaN for fewer than 3 frames or where either does not vary.
double likeness(const Row& row);

/// {"format": "sightline-results", "version": 1, "conditions": {…}, "rows": […]}, fields as in design.md: each row has
/// the summaries by id, ID_min or ID_max of the worst frame, hz, wrong_at and pixels_at by distance (their ends, as
/// shares of the scene's longest side, are in distance_ends) and per_frame arrays. NaN is null. `claims`: a JSON value
/// that says what the rows make of the papers' claims, left out where it is empty and not read back.
std::string results_json(const Results& results, const std::string& claims = {});
/// Throws InputError "name: place: reason".
Results read_results(std::string_view text, const std::string& name);

/// Those of a file, or of the results.json in a folder.
Results load_results(const std::string& name);
/// Whether load_results would find something to read.
bool has_results(const std::string& name);

/// A line per row, the summaries; numbers as they are in results.json.
std::string results_csv(const Results& results);

/// results.json and results.csv. Throws WorkError.
void write_results(const Results& results, const std::filesystem::path& folder, const std::string& claims = {});

/// Rows of several parts of one study, e.g. shards, in the order of the study. Throws InputError where two parts belong
/// to different studies, were measured by different builds or hold the same row.
Results merge(const std::vector<Results>& parts);

}  // namespace sightline::lab
