// Inside the lab: the functions behind the gallery's own measures, by what they look at. Formulas stand in the table
// (gallery_measures.cpp).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/truth/truth.h"
#include "lab/gallery/gallery_measures.h"
#include "lab/one_run.h"

namespace sightline::lab {

// gallery_measures.cpp: the run of the probe's method in its view, or in another.
template <int D>
OneRun ran(const Probe<D>& probe, const ViewSpec<D>& view);
template <int D>
OneRun ran(const Probe<D>& probe) {
    return ran(probe, probe.view);
}

// gallery_changes.cpp: what should not matter.
template <int D>
double least_overlap_under_shifts(const Probe<D>& probe);
template <int D>
double fewest_steps_under_shifts(const Probe<D>& probe);
template <int D>
double change_by_powers_of_two(const Probe<D>& probe);
template <int D>
double overlap_scaled(const Probe<D>& probe);
template <int D>
double overlap_moved(const Probe<D>& probe);
template <int D>
double overlap_moved_and_read(const Probe<D>& probe);
template <int D>
double spread_over_seeds(const Probe<D>& probe);
template <int D>
double bad_keys_in_sweep(const Probe<D>& probe);
template <int D>
double largest_jump_in_sweep(const Probe<D>& probe);
template <int D>
double largest_pop(const Probe<D>& probe);
template <int D>
double largest_visible_change(const Probe<D>& probe);

// gallery_parts.cpp: split by part, after GalleryScene::parts().
template <int D>
double front_coverage(const Probe<D>& probe);
template <int D>
double back_coverage(const Probe<D>& probe);
template <int D>
double hidden_engine(const Probe<D>& probe);

// gallery_references.cpp: the yardstick itself.
template <int D>
double lost_by_pixels(const Probe<D>& probe);
template <int D>
double churn(const Probe<D>& probe);
template <int D>
double churn_in_reverse(const Probe<D>& probe);
template <int D>
double unexplained_in_reverse(const Probe<D>& probe);
template <int D>
double wrong_against_rays(const Probe<D>& probe);

}  // namespace sightline::lab
