// The front: a priority queue of items by (key, stamp), lowest first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace sightline {

/// A heap with four children a node. An item that gets a new key is pushed again; the entry it leaves behind is known
/// by its outdated stamp and dropped when it surfaces (stamps are never given twice). The papers use a std::set and
/// erase (TVCG 4.2): same order, more memory traffic.
class Front {
public:
    struct Entry {
        double key;
        std::uint32_t stamp;
        std::uint32_t id;
        bool before(const Entry& other) const { return key < other.key || (key == other.key && stamp < other.stamp); }
    };

    void clear() { heap_.clear(); }

    void push(const Entry& entry) {
        std::size_t hole = heap_.size();
        heap_.push_back(entry);
        while (hole > 0 && entry.before(heap_[(hole - 1) / 4])) {
            heap_[hole] = heap_[(hole - 1) / 4];
            hole = (hole - 1) / 4;
        }
        heap_[hole] = entry;
    }

    /// The lowest entry for which is_current holds, or nullptr; drops those before it that are outdated.
    template <typename IsCurrent>
    const Entry* top(IsCurrent is_current) {
        while (!heap_.empty() && !is_current(heap_.front())) pop();
        return heap_.empty() ? nullptr : &heap_.front();
    }

    /// The item at the top, outdated or not; `otherwise` when the heap is empty. A guess at what comes next.
    std::uint32_t likely_next(std::uint32_t otherwise) const { return heap_.empty() ? otherwise : heap_.front().id; }

    void pop() {
        const Entry last = heap_.back();
        heap_.pop_back();
        const std::size_t size = heap_.size();
        if (size == 0) return;
        std::size_t hole = 0;
        for (;;) {
            const std::size_t first = 4 * hole + 1;
            if (first >= size) break;
            std::size_t least = first;
            const std::size_t end = first + 4 < size ? first + 4 : size;
            for (std::size_t child = first + 1; child < end; ++child)
                if (heap_[child].before(heap_[least])) least = child;
            if (!heap_[least].before(last)) break;
            heap_[hole] = heap_[least];
            hole = least;
        }
        heap_[hole] = last;
    }

private:
    std::vector<Entry> heap_;
};

}  // namespace sightline
