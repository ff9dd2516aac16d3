// The front: a priority queue of items by (key, stamp), lowest first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/index.h"

namespace sightline {

/// A heap with four children a node, in which an item that gets a new key is moved; and beside it two queues for keys
/// that many items share: whole numbers, such as layers and the solidity 0 of a flood, which come in the order of their
/// stamps and so need no heap. Where an item moves to or from a queue, the entry that it leaves behind is known by its
/// outdated stamp and dropped when it surfaces (stamps are never given twice). The papers use a std::set and erase
/// (TVCG 4.2): same order, more memory traffic.
class Front {
public:
    struct Entry {
        double key;
        std::uint32_t stamp;
        std::uint32_t id;
        bool before(const Entry& other) const { return key < other.key || (key == other.key && stamp < other.stamp); }
    };

    void clear() {
        for (const Entry& entry : heap_) places_[entry.id] = none;
        heap_.clear();
        for (Queue& queue : queues_) queue.clear();
    }

    void push(const Entry& entry) {
        if (is_whole(entry.key))
            for (Queue& queue : queues_)
                if (queue.accepts(entry)) return queue.entries.push_back(entry);
        if (entry.id >= places_.size()) places_.resize(entry.id + entry.id / 2 + 64, none);
        const std::uint32_t place = places_[entry.id];
        if (place == none) {
            heap_.push_back(entry);
            rise(heap_.size() - 1, entry);
        } else if (entry.before(heap_[place])) {
            rise(place, entry);
        } else {
            sink(place, entry);
        }
    }

    /// The lowest entry for which is_current holds, or nullptr; drops those before it that are outdated.
    template <typename IsCurrent>
    const Entry* top(IsCurrent is_current) {
        for (;;) {
            const Entry* const first = lowest();
            if (!first || is_current(*first)) return first;
            pop();
        }
    }

    /// A guess at what comes so many items after the first, outdated or not; `otherwise` where nothing is known.
    std::uint32_t likely_next(std::size_t after, std::uint32_t otherwise) const {
        const Queue* const queue = queue_of_lowest();
        const std::vector<Entry>& entries = queue ? queue->entries : heap_;
        const std::size_t place = queue ? queue->head + after : after;
        return place < entries.size() ? entries[place].id : otherwise;
    }

    void pop() {
        if (Queue* const queue = queue_of_lowest())
            queue->pop();
        else
            pop_heap();
    }

private:
    /// Entries of one key, by stamp.
    struct Queue {
        std::vector<Entry> entries;
        std::size_t head = 0;

        bool empty() const { return head == entries.size(); }
        const Entry& first() const { return entries[head]; }
        bool accepts(const Entry& entry) const {
            return empty() || (entries.back().key == entry.key && entries.back().stamp < entry.stamp);
        }
        void clear() {
            entries.clear();
            head = 0;
        }
        void pop() {
            if (++head == entries.size()) clear();
        }
    };

    static bool is_whole(double key) {
        return key >= 0 && key < 1e9 && static_cast<double>(static_cast<std::int32_t>(key)) == key;
    }

    /// nullptr: the heap has it, or all is empty.
    const Queue* queue_of_lowest() const {
        const Queue* found = nullptr;
        for (const Queue& queue : queues_)
            if (!queue.empty() && (!found || queue.first().before(found->first()))) found = &queue;
        return found && (heap_.empty() || found->first().before(heap_.front())) ? found : nullptr;
    }
    Queue* queue_of_lowest() { return const_cast<Queue*>(std::as_const(*this).queue_of_lowest()); }
    const Entry* lowest() const {
        if (const Queue* const queue = queue_of_lowest()) return &queue->first();
        return heap_.empty() ? nullptr : &heap_.front();
    }

    void put(std::size_t place, const Entry& entry) {
        heap_[place] = entry;
        places_[entry.id] = static_cast<std::uint32_t>(place);
    }
    /// The entry goes to a hole in the heap, or above it.
    void rise(std::size_t hole, const Entry entry) {
        for (; hole > 0 && entry.before(heap_[(hole - 1) / 4]); hole = (hole - 1) / 4) put(hole, heap_[(hole - 1) / 4]);
        put(hole, entry);
    }
    /// Or below it.
    void sink(std::size_t hole, const Entry entry) {
        const std::size_t size = heap_.size();
        for (;;) {
            const std::size_t first = 4 * hole + 1;
            if (first >= size) break;
            std::size_t least = first;
            const std::size_t end = first + 4 < size ? first + 4 : size;
            for (std::size_t child = first + 1; child < end; ++child)
                if (heap_[child].before(heap_[least])) least = child;
            if (!heap_[least].before(entry)) break;
            put(hole, heap_[least]);
            hole = least;
        }
        put(hole, entry);
    }
    void pop_heap() {
        places_[heap_.front().id] = none;
        const Entry last = heap_.back();
        heap_.pop_back();
        if (!heap_.empty()) sink(0, last);
    }

    std::vector<Entry> heap_;
    std::vector<std::uint32_t> places_;  ///< of items in the heap; none
    std::array<Queue, 2> queues_;
};

}  // namespace sightline
