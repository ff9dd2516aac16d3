// The marks of all items of one kind, in arrays that are used again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/base/large_pages.h"
#include "core/run/front.h"
#include "core/run/step.h"

namespace sightline {

/// Marks of an earlier epoch count as clean: starting anew costs nothing however many items there are.
class Marks {
public:
    void begin(std::size_t count) {
        if (marks_.size() != count || epoch_ == last_epoch) {
            marks_.assign(count, {});
            epoch_ = 0;
        }
        ++epoch_;
    }
    std::uint32_t size() const { return static_cast<std::uint32_t>(marks_.size()); }

    Mark operator[](std::uint32_t id) const {
        const Packed& m = marks_[id];
        if (m.epoch_and_state >> state_bits != epoch_) return {};
        return {m.key, m.stamp, static_cast<CellState>(m.epoch_and_state & ((1u << state_bits) - 1))};
    }
    void set(std::uint32_t id, const Mark& mark) {
        marks_[id] = {mark.key, mark.stamp, epoch_ << state_bits | static_cast<std::uint32_t>(mark.state)};
    }
    /// Whether the item is in the front with that stamp.
    bool is_enqueued(std::uint32_t id, std::uint32_t stamp) const {
        const Packed& m = marks_[id];
        return m.epoch_and_state == (epoch_ << state_bits | static_cast<std::uint32_t>(CellState::enqueued)) &&
               m.stamp == stamp;
    }
    /// To be fetched ahead.
    const void* address_of(std::uint32_t id) const { return &marks_[id]; }
    std::size_t memory_bytes() const { return marks_.capacity() * sizeof(Packed); }

private:
    /// In 16 bytes.
    struct Packed {
        double key = 0;
        std::uint32_t stamp = 0;
        std::uint32_t epoch_and_state = 0;  ///< epoch * 8 + state
    };
    static constexpr int state_bits = 3;
    static constexpr std::uint32_t last_epoch = (1u << (32 - state_bits)) - 1;
    LargeVector<Packed> marks_;
    std::uint32_t epoch_ = 0;
};

/// The item gets the change's mark, the change the item's: undo and redo.
inline void exchange(Marks& marks, Change& change) {
    const Mark here = marks[change.id];
    marks.set(change.id, change.mark());
    change.set_mark(here);
}

/// The changes of a step, the last first when they are undone: an item may be changed twice.
inline void exchange(Marks& marks, std::span<Change> changes, bool undo) {
    const auto put = [&](Change& change) { exchange(marks, change); };
    if (undo)
        std::for_each(changes.rbegin(), changes.rend(), put);
    else
        std::for_each(changes.begin(), changes.end(), put);
}

/// Undoes the last changes of a step, and forgets them, until so many are left.
inline void undo_behind(Marks& marks, std::vector<Change>& changes, std::size_t kept) {
    while (changes.size() > kept) {
        marks.set(changes.back().id, changes.back().mark());
        changes.pop_back();
    }
}

/// A front of the items that wait: after marks were put back.
inline void refill(Front& front, const Marks& marks) {
    front.clear();
    for (std::uint32_t id = 0; id < marks.size(); ++id)
        if (const Mark mark = marks[id]; mark.state == CellState::enqueued) front.push({mark.key, mark.stamp, id});
}

/// The items that wait, first to last; all are of that kind.
inline std::vector<std::pair<Item, Mark>> waiting_items(const Marks& marks, Kind kind) {
    std::vector<std::pair<Item, Mark>> waiting;
    for (std::uint32_t id = 0; id < marks.size(); ++id)
        if (const Mark mark = marks[id]; mark.state == CellState::enqueued) waiting.emplace_back(Item{id, kind}, mark);
    std::sort(waiting.begin(), waiting.end(),
              [](const auto& a, const auto& b) { return comes_before(a.second, b.second); });
    return waiting;
}

}  // namespace sightline
