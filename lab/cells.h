// No more than a scene needs: the coarsest tessellation, and the simplest method, that are nearly as good as the best.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/lab_graphics.h"
#include "lab/results.h"

namespace sightline::lab {

/// One tessellation of a scene.
struct CellsPoint {
    double error_bound = 0;
    Row row;  ///< along the path, one method and budget
};

/// A method over all error bounds, from coarse to fine.
struct CellsCurve {
    std::string scene, path;
    MethodChoice method;
    std::string budget;
    std::vector<CellsPoint> points;
};

/// Error bounds that are swept unless others are asked for: each about 0.7 of the one before.
std::vector<double> default_error_bounds();

/// A curve per scene, path, approximate method that orders cells, and budget.
std::vector<CellsCurve> sweep_cells(const Study& study, const std::vector<double>& error_bounds, LabGraphics& graphics,
                                    const std::function<void(const std::string&)>& say = {});

/// The coarsest point (fewest cells) whose mean `measure` is at most `within` worse than the best of the curve; index
/// into points. 0 for an empty curve or one without values.
std::size_t knee(const CellsCurve& curve, Measure measure, double within);

/// Methods from simple to elaborate: no order, sorted primitives, layers, then the others in the order of the table.
std::size_t complexity(const MethodChoice& method);

/// The simplest row whose mean `measure` reaches `target` (at most or at least, as the measure is better); of equally
/// simple ones the fastest, or without times the one that renders least. nullptr when none does.
const Row* simplest(const std::vector<const Row*>& rows, Measure measure, double target);

}  // namespace sightline::lab
