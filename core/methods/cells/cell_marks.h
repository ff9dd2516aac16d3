// The marks of all cells, in arrays that are used again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/run/step.h"

namespace sightline {

/// Marks of an earlier epoch count as clean: starting anew costs nothing however many cells there are.
class CellMarks {
public:
    void begin(std::size_t cell_count) {
        if (marks_.size() != cell_count || epoch_ == last_epoch) {
            marks_.assign(cell_count, {});
            epoch_ = 0;
        }
        ++epoch_;
    }
    std::uint32_t size() const { return static_cast<std::uint32_t>(marks_.size()); }

    Mark operator[](std::uint32_t cell) const {
        const Packed& m = marks_[cell];
        if (m.epoch_and_state >> 2 != epoch_) return {};
        return {m.key, m.stamp, static_cast<CellState>(m.epoch_and_state & 3)};
    }
    void set(std::uint32_t cell, const Mark& mark) {
        marks_[cell] = {mark.key, mark.stamp, epoch_ << 2 | static_cast<std::uint32_t>(mark.state)};
    }
    /// Whether the cell is in the front with that stamp.
    bool is_enqueued(std::uint32_t cell, std::uint32_t stamp) const {
        const Packed& m = marks_[cell];
        return m.epoch_and_state == (epoch_ << 2 | static_cast<std::uint32_t>(CellState::enqueued)) && m.stamp == stamp;
    }
    /// To be fetched ahead.
    const void* address_of(std::uint32_t cell) const { return &marks_[cell]; }
    std::size_t memory_bytes() const { return marks_.capacity() * sizeof(Packed); }

private:
    /// In 16 bytes.
    struct Packed {
        double key = 0;
        std::uint32_t stamp = 0;
        std::uint32_t epoch_and_state = 0;  ///< epoch * 4 + state
    };
    static constexpr std::uint32_t last_epoch = 0x3fffffffu;
    std::vector<Packed> marks_;
    std::uint32_t epoch_ = 0;
};

}  // namespace sightline
