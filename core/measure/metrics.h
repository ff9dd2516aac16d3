// How good an order is, measured against a reference.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/run/run.h"
#include "core/truth/reference.h"

namespace sightline {

/// |V ∩ T|, where T are those of `met` that are rendered.
std::size_t visible_rendered(const Reference& reference, std::span<const Met> met);

/// The share of all pixels of the reference whose primitive is not in T. No second image is needed: a visible
/// primitive that is rendered wins its pixels.
double wrong_pixels(const Reference& reference, std::span<const Met> met);

/// ε = |V ∩ T| / |V|; nothing when |V| = 0.
std::optional<double> coverage(const Reference& reference, std::size_t visible_rendered);

/// The share of a run's steps that popped a cell with key 0: there the order of entry alone decided. Nothing for a run
/// that has popped no cell.
template <int D>
std::optional<double> zero_key_share(const Run<D>& run);

/// The best that k primitives can do: min(1, k / |V|); nothing when |V| = 0.
std::optional<double> oracle(const Reference& reference, std::size_t k);

/// Coverage of whole cells by falling visible share, cut at the problem's budget as a traversal is: the bound of every
/// method that orders cells. Nothing when |V| = 0.
template <int D>
std::optional<double> cell_oracle(const Reference& reference, const Problem<D>& problem);

}  // namespace sightline
