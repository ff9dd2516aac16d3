// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/levels/levels_method.h"

#include "core/methods/levels/levels_run.h"

namespace sightline {

const ParameterRow& pixel_error_row() {
    static const ParameterRow row =
        number_row("pixel_error", "1", 0, 1e6, "[0, 1000000]", "docs/methods.md",
                   "how many pixels of the image a level may be off that stands in for its object");
    return row;
}

const ParameterRow& frame_ms_row() {
    static const ParameterRow row =
        number_row("frame_ms", "0", 0, 1e6, "[0, 1000000]", "DAS 3.1.3",
                   "once the frame is predicted to take no longer, the objects left stay as they are; 0: none does");
    return row;
}

const ParameterRow& vertex_ns_row() {
    static const ParameterRow row = number_row("vertex_ns", "100", 0, 1e6, "[0, 1000000]", "DAS 3.1.1",
                                               "what a vertex costs, as the prediction has it, in nanoseconds");
    return row;
}

const ParameterRow& pixel_ns_row() {
    static const ParameterRow row = number_row("pixel_ns", "2", 0, 1e6, "[0, 1000000]", "DAS 3.1.1",
                                               "what a pixel costs, as the prediction has it, in nanoseconds");
    return row;
}

const ParameterRow& cost_row() {
    static const ParameterRow row =
        choice_row("cost", CostReading::sum_of_max, "DAS 3.1.1",
                   "of a frame: the sum over its objects of the slower of vertices and pixels, or the slower sum");
    return row;
}

template <int D>
Method<D> levels_method() {
    Method<D> row{
        "levels", "levels of detail",
        "objects in the view, from far to near at the coarsest level that looks alike (DAS 2002)",
        [](const Problem<D>& problem) -> std::unique_ptr<Run<D>> { return std::make_unique<LevelsRun<D>>(problem); }};
    row.pops = Kind::object;
    row.prepare = [](const Problem<D>& problem) { levels_of(*problem.cells, *problem.scene); };
    row.needs.cells = false;
    row.needs.image = true;
    row.budgeted = false;
    row.draws_levels = true;
    row.parameters = {&pixel_error_row(), &frame_ms_row(), &vertex_ns_row(), &pixel_ns_row(), &cost_row()};
    return row;
}

template Method<2> levels_method<2>();
template Method<3> levels_method<3>();

}  // namespace sightline
