// The questions that choosing by viewpoint leaves open: which techniques, how finely space and directions are cut, what
// a frame costs, and by which rule the choice is made.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/parameters.h"

namespace sightline {

/// How an entry chooses. least: what the cost model says is cheapest; paper: by the number and size of occluders, and
/// only where there is something to gain (DAS 3.1.2).
enum class ChoiceRule : std::uint8_t { least, paper };
template <>
inline constexpr auto words<ChoiceRule> = std::to_array<std::string_view>({"least", "paper"});

const ParameterRow& techniques_row();   ///< variants, the first of them what is done where nothing pays
const ParameterRow& choice_rule_row();  ///< "choose_by"
const ParameterRow& grid_row();         ///< boxes along an axis; 0: 8 in 2D, 4 in 3D
const ParameterRow& azimuths_row();
const ParameterRow& elevations_row();
const ParameterRow& samples_row();      ///< views an entry
const ParameterRow& allotted_ms_row();  ///< what a frame may take; paper: below it nothing is done
const ParameterRow& few_row();          ///< so many occluders are few
const ParameterRow& few_cover_row();    ///< the share of the view that they must cover
const ParameterRow& switch_ms_row();    ///< t_select
const ParameterRow& valid_frames_row();
const ParameterRow& cull_times_row();
const ParameterRow& table_file_row();  ///< "table"

std::vector<const ParameterRow*> viewpoint_parameter_rows();

/// What a technique's own work takes: a line over its steps and over the primitives that it meets.
struct CullTime {
    double step_ns = 0, met_ns = 0;
    bool operator==(const CullTime&) const = default;
    double ms(double steps, double met) const { return 1e-6 * (step_ns * steps + met_ns * met); }
};

/// Of a variant, as cull_times lists it: "view 40/8; boxes 300/60" are nanoseconds a step and a primitive. One that is
/// not listed takes what its method is listed with, else a guess.
CullTime cull_time(std::string_view times, std::string_view variant);
/// "view 40/8"
std::string cull_time_text(std::string_view variant, const CullTime& time);

}  // namespace sightline
