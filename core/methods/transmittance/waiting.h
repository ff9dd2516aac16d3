// What waits to be rendered, in an order that is good to a sixteenth of a power of two.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/base/index.h"

namespace sightline {

/// References of cells to primitives (places in CellComplex::cell_primitives) by class of key, lowest first, and by
/// place within a class. What comes first depends on what is in it, not on the order in which it came.
class Waiting {
public:
    /// Those of keys between which less than a sixteenth of a power of two lies. `key`: positive.
    static std::uint32_t class_of(float key) {
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(key) >> 19;
        return std::min(bits < first_bits ? 0 : bits - first_bits, class_count - 1);
    }

    void clear() {
        if (lowest_ < class_count)
            for (Class& each : classes_) each.places.clear();
        classes_.resize(class_count);
        lowest_ = class_count;
    }
    void add(float key, std::uint32_t place) {
        const std::uint32_t at = class_of(key);
        classes_[at].places.push_back(place);
        classes_[at].sorted = false;
        lowest_ = std::min(lowest_, at);
    }
    /// The first, where its class comes before `end`; none: there is no such.
    std::uint32_t first(std::uint32_t end) {
        while (lowest_ < end && lowest_ < class_count && classes_[lowest_].places.empty()) ++lowest_;
        if (lowest_ >= std::min(end, class_count)) return none;
        Class& at = classes_[lowest_];
        if (!at.sorted) std::sort(at.places.begin(), at.places.end(), std::greater<>());
        at.sorted = true;
        return at.places.back();
    }
    void drop_first() { classes_[lowest_].places.pop_back(); }

private:
    struct Class {
        std::vector<std::uint32_t> places;  ///< once sorted, the first is the last
        bool sorted = false;
    };
    /// Of floats from 2^-32 to 2^32.
    static constexpr std::uint32_t first_bits = (127 - 32) * 16, class_count = 64 * 16;

    std::vector<Class> classes_;
    std::uint32_t lowest_ = class_count;  ///< no class below it holds any
};

}  // namespace sightline
