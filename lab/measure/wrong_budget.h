// Budgets in wrong pixels: how well a controller keeps them that knows no more than the frames before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/truth/id_image.h"
#include "lab/measure/lab_scene.h"
#include "lab/measure/results.h"

namespace sightline::lab {

/// Whether a budget selects a prefix of the method's order, which no frame before changes.
template <int D>
bool can_follow_wrong_pixels(const Method<D>& method) {
    return method.budgeted && method.prefixes && !method.needs.visible_set && !method.needs.history;
}

/// The frames of the path in order, for each budgeted method and each of the study's wrong pixels: drawn with what
/// predict_needed (core/run/wrong_budget.h) says, then measured as far as they were drawn. Nothing is timed. Methods
/// that cannot follow them are left out. Empty where `go_on` says no.
template <int D>
std::vector<WrongFlight> fly_in_wrong_pixels(const LabScene<D>& lab, const Study& study, const DrawIds& draw_ids,
                                             const std::function<bool()>& go_on);

/// "wrong:0.5%"
std::string wrong_budget_text(double share);
/// Nothing for what does not begin with "wrong:". Throws InputError for what does and has no share in [0 %, 100 %).
std::optional<double> parse_wrong_budget(std::string_view text);

/// Share of the frames within the share of wrong pixels, or a tenth above; NaN for none. The first frame, which nothing
/// is known of, is left out.
double share_kept(const WrongFlight& flight);

/// "80 % of 5 frames (all but the first, which nothing is known of) within wrong:0.5% + 10 %"
std::string kept_text(const WrongFlight& flight);

}  // namespace sightline::lab
