// What changes between two frames that should not, or should only as far as the truth itself does.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace sightline {

// Sets of primitives: 1 per member, indexed by primitive, all of one length.

/// |A ∩ B| / |A ∪ B|; 1 when both are empty.
double jaccard(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b);

/// |{p in V and V': rendered in exactly one of T and T'}| / |V ∩ V'|; nothing when V ∩ V' is empty. No change of the
/// exact set explains it.
std::optional<double> pop(std::span<const std::uint8_t> visible_before, std::span<const std::uint8_t> rendered_before,
                          std::span<const std::uint8_t> visible, std::span<const std::uint8_t> rendered);

/// Share of the places where two masks of one length differ; 0 when they are empty.
double difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b);

}  // namespace sightline
