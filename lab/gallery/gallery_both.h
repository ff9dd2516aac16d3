// Inside the gallery: rows that are the same in both dimensions, word by word.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "lab/gallery/gallery.h"

namespace sightline::lab {

// As the tables write them.
inline constexpr Expect pass = Expect::pass, fail = Expect::fail, pending = Expect::pending;
inline constexpr Bound at_least = Bound::at_least, at_most = Bound::at_most;

/// The rows of a dimension and those of both, by number.
template <int D>
std::vector<GalleryRow<D>> with_rows_of_both(std::vector<GalleryRow<D>> rows) {
    std::vector<GalleryRow<D>> both{
        {"forget",
         5,
         "forget",
         {},
         "the store is projected with solidity 0: the wall before it is forgotten",
         "visible_share == 0 && hidden_now >= 4 && rho == 0",
         {{"published", fail, "coverage", at_least, 0.9, "the reeds come before the store"},
          {"layers", pass, "coverage", at_least, 0.9, "the reeds come before the store: they are nearer"},
          {"flux", pass, "coverage", at_least, 0.9, "the reeds come before the store"}}},
        {"hullgap",
         7,
         "fence",
         {},
         "the fence is never drawn: the cells end half a leaf before it",
         "",
         {{"cells border=none", fail, "unassigned", at_most, 0, "every primitive lies in a cell"},
          {"cells border=inflated", pass, "unassigned", at_most, 0, "every primitive lies in a cell"},
          {"cells tessellation=tree", pass, "unassigned", at_most, 0, "every primitive lies in a leaf"},
          {"published border=none", fail, "missed", at_most, 0, "all is drawn without a budget"},
          {"published border=inflated", pass, "missed", at_most, 0, "all is drawn without a budget"},
          {"centroid border=none", pass, "missed", at_most, 0, "without cells nothing falls between them"}}},
        {"grazing",
         16,
         "graze",
         {},
         "the wall in line with the eye: cosines and projected areas are 0",
         "step:20",
         {{"published", pass, "bad_keys", at_most, 0, "every key is a number"},
          {"published view_vector=camera transfer_sign=signed", pass, "bad_keys", at_most, 0, "every key is a number"},
          {"published", pass, "sweep_jump", at_most, 0.02, "coverage does not jump within a tenth of a degree"},
          {"layers", pass, "sweep_jump", at_most, 0.02, "coverage does not jump within a tenth of a degree"}}},
        {"eye-in-box",
         17,
         "booth",
         {},
         "walls 2 to 20 cm round the eye, and a slit of 4 cm: cells reach from before the eye to behind it",
         "rendered > 0",
         {{"cplp", pass, "missed", at_most, 0, "a cell with a part behind the eye is not called hidden"},
          {"cplp", pass, "wrong", at_most, 0, "what the slit shows is drawn"},
          {"cplp first=layers budget=0", pass, "missed", at_most, 0, "the rounds alone find it"},
          {"boxes", pass, "wrong", at_most, 0, "a box with a part behind the eye is not called hidden"},
          {"hzb", pass, "wrong", at_most, 0, "a box with a part behind the eye is not called hidden"},
          {"hom", pass, "wrong", at_most, 0, "a box with a part behind the eye is not called hidden"},
          {"two-pass", pass, "wrong", at_most, 0, "a box with a part behind the eye is not called hidden"},
          {"view budget=unlimited", pass, "missed", at_most, 0, "a conservative method misses nothing"}}},
        {"cplp-hull",
         20,
         "niche",
         {},
         "the walls of the niche reach past the cells: beside them the hull itself is in plain view",
         "coverage >= 0.1",
         {{"cplp", pass, "missed", at_most, 0, "rounds start from every cell of the hull that the eye looks at"},
          {"cplp", pass, "wrong", at_most, 0, "rounds start from every cell of the hull that the eye looks at"},
          {"cplp first=layers budget=0", pass, "missed", at_most, 0, "the rounds alone find it"},
          {"view budget=unlimited", pass, "missed", at_most, 0, "a conservative method misses nothing"}}},
        {"tiny-budget",
         22,
         "bottleneck",
         {},
         "budgets of 0, 1, 2, … primitives end inside a cell",
         "rendered > 0",
         {{"published", pass, "off_budget", at_most, 0, "a budget is kept to the primitive"},
          {"layers", pass, "off_budget", at_most, 0, "a budget is kept to the primitive"},
          {"centroid", pass, "off_budget", at_most, 0, "a budget is kept to the primitive"},
          {"everything", pass, "off_budget", at_most, 0, "a budget is kept to the primitive"}}},
        {"non-convex",
         25,
         "zigzag",
         {},
         "a folded wall hides as one piece what no fold hides alone",
         "hidden_now >= 4",
         {{"coorg-teller connected=on budget=unlimited", pass, "missed", at_most, 0,
           "gives up rather than hide what is visible"},
          {"coorg-teller budget=unlimited", fail, "culled", at_least, 0.95, "all that is hidden is culled"},
          {"coorg-teller connected=on budget=unlimited", fail, "culled", at_least, 0.95,
           "all that is hidden is culled"},
          {"view budget=unlimited", fail, "culled", at_least, 0.01, "anything hidden is culled"},
          {"published", pass, "detour", at_most, 3, "the wall comes before the crates"}}},
        {"empty",
         27,
         "empty",
         {},
         "no primitive: nothing to see, to draw or to miss",
         "",
         {{"published", pass, "rendered_count", at_most, 0, "draws nothing"},
          {"published", pass, "missed", at_most, 0, "misses nothing"},
          {"published tessellation=tree", pass, "bad_keys", at_most, 0, "every key is a number"}}},
        {"one-cell",
         27,
         "onecell",
         {},
         "all in one cell: the order inside it is that of the file",
         "rendered > 0",
         {{"published", fail, "of_oracle", at_least, 0.5, "visible ones come first"},
          {"layers", fail, "of_oracle", at_least, 0.5, "visible ones come first"},
          {"centroid", pass, "of_oracle", at_least, 0.5, "visible ones come first: no cells, no such limit"}}}};
    rows.insert(rows.end(), std::move_iterator(both.begin()), std::move_iterator(both.end()));
    std::stable_sort(rows.begin(), rows.end(),
                     [](const GalleryRow<D>& a, const GalleryRow<D>& b) { return a.number < b.number; });
    return rows;
}

}  // namespace sightline::lab
