// A parameter of methods swept as the size of cells is: which value does best, and what the others cost.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/measure/results.h"
#include "lab/report/chart.h"

namespace sightline::lab {

/// A parameter of a method by its name, and values as assignments write them.
struct Sweep {
    std::string parameter;
    std::vector<std::string> values;
};
/// "occluder_count=8,16,32". Throws InputError.
Sweep parse_sweep(const std::string& text);

/// The study's methods that have one of the parameters, once for each of its values. Throws InputError for a parameter
/// that none of them has, and for values that cannot be.
Study parameter_study(Study study, const std::vector<Sweep>& sweeps);

/// A method over the values of a parameter, in their order.
struct SweepCurve {
    std::string scene, path;
    MethodChoice method;  ///< without the parameter
    std::string parameter, budget;
    std::vector<std::string> values;
    std::vector<Row> rows;  ///< one for each value
};
std::vector<SweepCurve> sweep_curves(const Study& study, const std::vector<Sweep>& sweeps, const Results& results);

/// The value with the best mean; of equal ones the first. Index into values.
std::size_t best(const SweepCurve& curve, Measure measure);

/// charts/ and sweep.html. Throws WorkError.
void write_sweep_report(const std::vector<SweepCurve>& curves, Measure measure, const std::filesystem::path& folder,
                        const ChartFormat& format = {});

/// The best value as a settings file that --settings takes.
std::string sweep_settings(const SweepCurve& curve, Measure measure);

}  // namespace sightline::lab
