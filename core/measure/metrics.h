// How good an order is, measured against a reference.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/traversal/timeline.h"
#include "core/truth/reference.h"

namespace sightline {

/// |V ∩ T|, where `touched` are the primitives of State::touched.
template <int D>
std::size_t visible_rendered(const Reference& reference, std::span<const std::uint32_t> touched);

/// 3D: the share of all pixels of the reference whose primitive is not among those of State::touched that are
/// rendered. No second image is needed: a visible primitive that is rendered wins its pixels.
double wrong_pixels(const Reference& reference, std::span<const std::uint32_t> touched);

/// ε = |V ∩ T| / |V|; nothing when |V| = 0.
std::optional<double> coverage(const Reference& reference, std::size_t visible_rendered);

/// The best that k primitives can do: min(1, k / |V|); nothing when |V| = 0.
std::optional<double> oracle(const Reference& reference, std::size_t k);

/// Coverage of whole cells by falling visible share, cut at the frame's budget as a traversal is: the bound of every
/// method that orders cells. Nothing when |V| = 0.
template <int D>
std::optional<double> cell_oracle(const Reference& reference, const Frame<D>& frame);

/// A hidden cell with primitives was projected while a visible one waited.
struct Inversion {
    enum class Kind : std::uint8_t { mis_ranked, unreached };
    std::uint32_t step = 0;
    std::uint32_t cell = none;
    Kind kind = Kind::mis_ranked;  ///< the waiting cell was in the front, or still clean
    std::uint32_t waiting = none;  ///< of those that waited the one with the largest visible share
    std::uint32_t wasted = 0;      ///< hidden primitives that the step rendered
};

/// Every inversion of a recorded timeline, most wasted primitives first, then by step.
template <int D>
std::vector<Inversion> inversions(const Reference& reference, const Frame<D>& frame, const State<D>& state,
                                  const Timeline& timeline);

}  // namespace sightline
