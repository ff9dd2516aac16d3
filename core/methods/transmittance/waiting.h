// What waits to be rendered, in an order that is good to a sixteenth of a power of two.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/index.h"

namespace sightline {

/// A reference of a cell to a primitive. Lower ones are of lower places.
struct WaitingReference {
    std::uint32_t bits = none;

    WaitingReference() = default;
    WaitingReference(std::uint32_t place, bool shows) : bits(2 * place + shows) {}
    std::uint32_t place() const { return bits >> 1; }  ///< in CellComplex::cell_primitives, below 2^31
    bool shows() const { return bits & 1; }            ///< the view shows it, for sure
    explicit operator bool() const { return bits != none; }
};

/// References of cells to primitives by class of key, lowest first, and by place within a class. What comes first
/// depends on what is in it, not on the order in which it came.
class Waiting {
public:
    /// Those of keys between which less than a sixteenth of a power of two lies. `key`: positive.
    static std::uint32_t class_of(float key) {
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(key) >> 19;
        return std::min(bits < first_bits ? 0 : bits - first_bits, class_count - 1);
    }

    void clear() {
        if (lowest_ < class_count)
            for (Class& each : classes_) each.references.clear();
        classes_.resize(class_count);
        lowest_ = class_count;
    }
    void add(float key, const WaitingReference& reference) {
        const std::uint32_t at = class_of(key);
        classes_[at].references.push_back(reference.bits);
        classes_[at].sorted = false;
        lowest_ = std::min(lowest_, at);
    }
    /// The first, where its class comes before `end`; empty: there is no such.
    WaitingReference first(std::uint32_t end) {
        while (lowest_ < end && lowest_ < class_count && classes_[lowest_].references.empty()) ++lowest_;
        WaitingReference found;
        if (lowest_ >= std::min(end, class_count)) return found;
        Class& at = classes_[lowest_];
        if (!at.sorted) std::sort(at.references.begin(), at.references.end(), std::greater<>());
        at.sorted = true;
        found.bits = at.references.back();
        return found;
    }
    /// So many behind the first, in its class; empty: there is no such. To be fetched ahead.
    WaitingReference behind_first(std::size_t places) const {
        const std::vector<std::uint32_t>& all = classes_[lowest_].references;
        WaitingReference found;
        if (places < all.size()) found.bits = all[all.size() - 1 - places];
        return found;
    }
    void drop_first() { classes_[lowest_].references.pop_back(); }
    /// The lowest key of the class that the reference to this place is in; nothing: there is none.
    std::optional<double> key_of(std::uint32_t place) const {
        for (std::uint32_t at = 0; at < classes_.size(); ++at)
            for (const std::uint32_t bits : classes_[at].references)
                if (bits >> 1 == place) return std::bit_cast<float>((first_bits + at) << 19);
        return std::nullopt;
    }

private:
    struct Class {
        std::vector<std::uint32_t> references;  ///< WaitingReference::bits; once sorted, the first is the last
        bool sorted = false;
    };
    /// Of floats from 2^-32 to 2^32.
    static constexpr std::uint32_t first_bits = (127 - 32) * 16, class_count = 64 * 16;

    std::vector<Class> classes_;
    std::uint32_t lowest_ = class_count;  ///< no class below it holds any
};

}  // namespace sightline
