// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/frame_change.h"

#include <cstddef>

namespace sightline {

double jaccard(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    std::size_t both = 0, either = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a[i] & b[i];
        either += a[i] | b[i];
    }
    return either == 0 ? 1 : static_cast<double>(both) / static_cast<double>(either);
}

std::optional<double> pop(std::span<const std::uint8_t> visible_before, std::span<const std::uint8_t> rendered_before,
                          std::span<const std::uint8_t> visible, std::span<const std::uint8_t> rendered) {
    std::size_t both = 0, changed = 0;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        if (!visible[i] || !visible_before[i]) continue;
        ++both;
        changed += rendered[i] != rendered_before[i];
    }
    if (both == 0) return std::nullopt;
    return static_cast<double>(changed) / static_cast<double>(both);
}

double difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    std::size_t changed = 0;
    for (std::size_t i = 0; i < a.size(); ++i) changed += a[i] != b[i];
    return a.empty() ? 0 : static_cast<double>(changed) / static_cast<double>(a.size());
}

}  // namespace sightline
