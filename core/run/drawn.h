// What a run has rendered: the primitives that it met, in order, each once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"

namespace sightline {

/// A primitive that a run met; culled: it lies outside the view and is not rendered.
class Met {
public:
    Met() = default;
    Met(std::uint32_t primitive, bool culled) : bits_(culled ? primitive | culled_bit : primitive) {}

    std::uint32_t primitive() const { return bits_ & ~culled_bit; }
    bool culled() const { return bits_ & culled_bit; }
    std::uint32_t bits() const { return bits_; }  ///< for hashes
    bool operator==(const Met&) const = default;

private:
    static constexpr std::uint32_t culled_bit = 0x80000000u;
    std::uint32_t bits_ = 0;
};

/// Calls `each(primitive)` for those that are rendered, in order.
template <typename Each>
void for_rendered(std::span<const Met> met, Each each) {
    for (const Met entry : met)
        if (!entry.culled()) each(entry.primitive());
}

/// The rendered primitives, in order.
inline void rendered_ids(std::span<const Met> met, std::vector<std::uint32_t>& ids) {
    ids.clear();
    for_rendered(met, [&](std::uint32_t primitive) { ids.push_back(primitive); });
}
inline std::vector<std::uint32_t> rendered_ids(std::span<const Met> met) {
    std::vector<std::uint32_t> ids;
    rendered_ids(met, ids);
    return ids;
}

/// Per primitive, 1 where it is rendered.
inline std::vector<std::uint8_t> rendered_mask(std::span<const Met> met, std::size_t primitive_count) {
    std::vector<std::uint8_t> mask(primitive_count);
    for_rendered(met, [&](std::uint32_t primitive) { mask[primitive] = 1; });
    return mask;
}

/// The list of a run, and which primitives are in it: a bit each, so that those of a large scene stay in a cache in
/// whatever order they come. Starting anew takes no longer than meeting what was met before.
class Drawn {
public:
    /// Empties it for a scene of so many primitives.
    void begin(std::size_t primitive_count) {
        const std::size_t words = (primitive_count + 63) / 64;
        if (words_.size() != words || met_.size() > words)
            words_.assign(words, 0);
        else
            for (const Met met : met_) words_[met.primitive() / 64] = 0;
        met_.clear();
    }
    bool has(std::uint32_t primitive) const { return words_[primitive / 64] >> primitive % 64 & 1; }
    /// To be fetched ahead.
    const void* address_of(std::uint32_t primitive) const { return &words_[primitive / 64]; }

    /// Appends behind the first `count`; what stood there, a recording's undone future, is replaced.
    void add(std::uint32_t count, Met met) {
        put(met.primitive());
        met_.resize(count);
        met_.push_back(met);
    }
    /// What is appended to the list, one after the other, until end().
    class Tail {
    public:
        /// Whether it was not in the list; from now on it counts as if it were.
        bool put(std::uint32_t primitive) {
            std::uint64_t& word = words_[primitive / 64];
            const bool fresh = !(word >> primitive % 64 & 1);
            word |= bit(primitive);
            return fresh;
        }
        void append_if(bool appended, Met met) {
            *next_ = met;
            next_ += appended;
        }

    private:
        friend Drawn;
        std::uint64_t* words_;
        Met* next_;
    };
    /// Appends behind the first `count`, at most `more`.
    Tail tail(std::uint32_t count, std::uint32_t more) {
        met_.resize(std::size_t{count} + more + 1);
        Tail tail;
        tail.words_ = words_.data();
        tail.next_ = met_.data() + count;
        return tail;
    }
    /// How many are in the list.
    std::uint32_t end(const Tail& tail) {
        met_.resize(static_cast<std::size_t>(tail.next_ - met_.data()));
        return static_cast<std::uint32_t>(met_.size());
    }

    /// Several that are not in it, none of them culled.
    void add_all(std::uint32_t count, std::span<const std::uint32_t> primitives) {
        met_.resize(count);
        met_.reserve(count + primitives.size());
        for (const std::uint32_t primitive : primitives) {
            put(primitive);
            met_.push_back({primitive, false});
        }
    }
    /// Forgets, or remembers, entries [begin, end); they stay in the list for redo.
    void take_back(std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t primitive = met_[i].primitive();
            words_[primitive / 64] &= ~bit(primitive);
        }
    }
    void put_back(std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) put(met_[i].primitive());
    }

    /// Puts behind the list what a run on the same way, which has gone farther, has met.
    void remember(std::span<const Met> all) {
        if (all.size() > met_.size())
            met_.insert(met_.end(), all.begin() + static_cast<std::ptrdiff_t>(met_.size()), all.end());
    }

    /// All that was met, also what an undo has taken back; Run::met() is the part that counts.
    std::span<const Met> all() const { return met_; }
    std::size_t memory_bytes() const {
        return met_.capacity() * sizeof(Met) + words_.capacity() * sizeof(std::uint64_t);
    }

private:
    static std::uint64_t bit(std::uint32_t primitive) { return std::uint64_t{1} << primitive % 64; }
    void put(std::uint32_t primitive) { words_[primitive / 64] |= bit(primitive); }

    std::vector<Met> met_;
    std::vector<std::uint64_t> words_;  ///< of bits: met
};

}  // namespace sightline
