// The constants of the cost model, fitted to measured times of this machine (DAS 3.1.1: "evaluated experimentally").
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/measure/frame_clock.h"
#include "core/methods/by_viewpoint/viewpoint_table.h"

namespace sightline::lab {

/// A technique in a view, timed.
struct CostSample {
    std::uint32_t option = 0;
    double steps = 0, met = 0;
    std::vector<DrawnSize> sizes;  ///< of what is drawn, part by part
    double cull_ms = 0;            ///< the median
    double draw_ms = 0;            ///< upload and drawing, the median, without those of an empty frame
    double ms() const { return cull_ms + draw_ms; }
};

struct Calibration {
    DrawingCost cost;
    CostReading reading = CostReading::max_of_sums;
    std::vector<CullTime> cull_times;  ///< of the options
    double r2_draw = 0, r2 = 0;        ///< of drawing alone, and of whole frames

    double draw_ms(const CostSample& sample) const;
    double ms(const CostSample& sample) const;
};

/// What all techniques draw numbers of: with levels behind it where one of them draws levels, so that no time goes into
/// changing from one scene to the other.
std::shared_ptr<const Scene<3>> one_scene(const ViewpointProblem<3>& problem,
                                          const std::shared_ptr<const Scene<3>>& scene);

/// Of each option in each view, after a run to warm up. `go_on` is asked after each view; false ends it early.
std::vector<CostSample> cost_samples(const ViewpointProblem<3>& problem, const std::vector<View<3>>& views,
                                     const std::shared_ptr<const Scene<3>>& scene, const TimeDrawing& time_drawing,
                                     int repeats, const std::function<bool(std::size_t)>& go_on);

/// Least squares without negative constants; α_v and α_p by turns with which of them decides where.
Calibration fit(const std::vector<CostSample>& samples, std::size_t options, CostReading reading);

/// 1 - the squared errors over the squared deviations from the mean.
double r_squared(const std::vector<double>& predicted, const std::vector<double>& measured);

/// "vertex_ns=9.1 pixel_ns=.2 cost=max_of_sums cull_times='view 60/8; …'"
std::string parameters_text(const Calibration& fitted, const std::vector<Variant<3>>& options);

}  // namespace sightline::lab
