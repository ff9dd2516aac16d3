// No more than a scene needs: the coarsest tessellation, and the simplest method, that are nearly as good as the best.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lab/measure/results.h"

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
    std::string also{};  ///< a setting of these cells beside their error bound: "split_for=opacity"; empty: none
};

/// Error bounds that are swept unless others are asked for: each half of the one before, as the sides of leaves are.
std::vector<double> default_error_bounds();

/// The study of a sweep: its approximate methods that order cells, at these error bounds from coarse to fine.
Study sweep_study(Study study, std::vector<double> error_bounds);

/// A kind of cells that is tried.
struct CellsKind {
    Tessellation tessellation = Tessellation::delaunay;
    std::string also{};  ///< as CellsCurve
    bool operator==(const CellsKind&) const = default;
};
/// "delaunay", "tree" or "kd", with "+opacity" for split_for=opacity or, of Delaunay cells, "+merge" for
/// empty_leaves=merge; "all": every one of these. Throws InputError for anything else, and for one that is given twice.
std::vector<CellsKind> parse_kinds(const std::vector<std::string>& texts);

/// The study of a sweep on other cells than its methods ask for: one study for each setting that these have beside,
/// each method once for each of its kinds. Those with a setting of their own are not the study's to set: InputError.
struct KindStudy {
    std::string also;
    Study study;
};
std::vector<KindStudy> kind_studies(const Study& sweep, const std::vector<CellsKind>& kinds);

/// The study of its methods that need no cells, which no error bound changes.
Study cell_free_study(Study study);

/// The rows of a sweep: a curve per scene, path, method and budget, in their order.
std::vector<CellsCurve> curves_of(const Results& results, const std::string& also = "");

/// The coarsest point (fewest cells) whose mean `measure` is at most `within` worse than the best of the curve; index
/// into points. 0 for an empty curve or one without values.
std::size_t knee(const CellsCurve& curve, Measure measure, double within);

/// A point of one of several curves.
struct CurvePoint {
    std::size_t curve = 0, point = 0;
};
/// The knee over all kinds of cells: the fewest cells of all curves of this method and budget on its scene and path
/// that come within `within` of the best of them all. `of` is any of these curves.
CurvePoint coarsest(const std::vector<CellsCurve>& curves, const CellsCurve& of, Measure measure, double within);

/// "tree, split_for=opacity, error bound 0.1"
std::string kind_text(const CellsCurve& curve, std::size_t point);

/// Like "380 cells, the coarsest that was tried": of the knee; nothing says that fewer would not do.
std::string knee_text(const CellsCurve& curve, std::size_t knee);

/// Methods from simple to elaborate: no order, sorted primitives, layers, then the others in the order of the table.
std::size_t complexity(const MethodChoice& method);

/// The simplest row whose mean `measure` reaches `target` (at most or at least, as the measure is better); of equally
/// simple methods that with the fewest cells, then the fastest, or without times the one that renders least. nullptr
/// when none does.
const Row* simplest(const std::vector<const Row*>& rows, Measure measure, double target);

}  // namespace sightline::lab
