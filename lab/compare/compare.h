// Two studies, or two methods of one, frame by frame: what changed, and whether it is more than the noise.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "lab/measure/results.h"

namespace sightline::lab {

/// Paired over frames: b - a.
struct Change {
    Measure measure = Measure::wrong;
    double a = 0, b = 0;  ///< means over the frames that both have a value for
    double mean = 0;      ///< of the differences
    /// Of the 95 % confidence interval of that mean, over frames (confidence_half_width) or, for times, over repeats
    /// where that is wider: t √(Σ e²) / n with the errors e of both sides, which have two degrees of freedom a frame at
    /// least. Infinite for a single time that was taken once.
    double half_width = 0;
    std::size_t frames = 0;            ///< pairs
    std::size_t lost = 0, gained = 0;  ///< indices into the frames where b is worst and best against a
    /// Times of two runs: as much as the machine alone may have changed them (machine_change).
    double machine = 0;

    /// The interval leaves out 0, and the machine does not explain it. Numbers without a clock have no noise in a
    /// single frame.
    bool significant() const { return std::abs(mean) > std::max(half_width, machine); }
};

/// Rows that belong together: the same scene, path and budget.
struct Pair {
    const Row *a, *b;
    std::vector<Change> changes;  ///< of each measure that can be better and that both have
};

/// By which share times of two runs may differ though no method changed: the largest change, with its interval, of the
/// time per frame of the methods that no heuristic touches (conservative ones: view, everything) on that scene and
/// path. Two runs are never taken on quite the same machine. Nothing where the studies have no such method in common.
std::optional<double> machine_change(const std::vector<Pair>& pairs, const std::string& scene, const std::string& path);

/// Studies that hold the same methods are matched by method; where each holds one method, that one. Frames are matched
/// by their number. Throws InputError when nothing matches.
std::vector<Pair> compare_results(const Results& a, const Results& b);

/// Rows of one study, by two of its methods. Throws InputError when one of them is not in it.
std::vector<Pair> compare_methods(const Results& results, const MethodChoice& a, const MethodChoice& b);

/// Half of the width of the 95 % interval of the mean of values in the order of frames: t(n - 1) s / sqrt(m). Frames
/// that follow one another resemble each other, so they count as m = n (1 - r) / (1 + r) of them, with r the
/// correlation of neighbours (0 where it is negative). 0 for fewer than two values.
double confidence_half_width(const std::vector<double>& values);

/// Nothing where the frames have no such measure in common.
std::optional<Change> change_of(const Row& a, const Row& b, Measure measure);

}  // namespace sightline::lab
