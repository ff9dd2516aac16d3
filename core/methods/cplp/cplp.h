// cPLP, the conservative version of PLP (the gem): any method of cells to its budget, then rounds that project every
// cell of the front that could still change the image.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/method.h"

namespace sightline {

/// "first": the method of the first phase, as a variant.
const ParameterRow& cplp_first_row();
/// "test", "listing", "tiles", "total": RoundForm (cells/rounds.h).
const ParameterRow& cplp_test_row();
const ParameterRow& cplp_listing_row();
const ParameterRow& cplp_tiles_row();
const ParameterRow& cplp_total_row();

/// `firsts`: the methods that may come first, those of cells. Conservative at Services::image once it is finished: each
/// pixel's nearest primitive is rendered. A round is a step (cells/rounds.h).
template <int D>
Method<D> cplp_method(std::vector<Method<D>> firsts, std::vector<const ParameterRow*> parameters);

}  // namespace sightline
