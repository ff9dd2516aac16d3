// Inversions: a hidden cell with primitives was projected while a visible one waited. The one definition.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "core/run/run.h"
#include "core/truth/reference.h"

namespace sightline {

struct Inversion {
    enum class Kind : std::uint8_t { mis_ranked, unreached };
    std::uint32_t step = 0;
    std::uint32_t cell = none;
    Kind kind = Kind::mis_ranked;  ///< the waiting cell was in the front, or still clean
    std::uint32_t waiting = none;  ///< of those that waited the one with the largest visible share
    std::uint32_t wasted = 0;      ///< hidden primitives that the step rendered
};

/// Follows a recording as it grows.
class Inversions {
public:
    /// `cell_share` and `visible` outlive it; `seeds` are in the front at the start.
    Inversions(std::span<const double> cell_share, std::span<const std::uint8_t> visible, std::span<const Item> seeds);

    /// Looks at the steps of the recording that it has not seen. `met`: all that the recorded run met. `count` gives
    /// |A| of a cell.
    template <typename Count>
    void follow(const Recording& recording, std::span<const Met> met, Count count) {
        while (followed_ < recording.size()) follow_step(recording, met, count);
    }

    /// By step.
    const std::vector<Inversion>& found() const { return found_; }
    /// nullptr: the step is none.
    const Inversion* at(std::uint32_t step) const;
    std::uint32_t followed() const { return followed_; }

private:
    struct LargerShare {
        std::span<const double> share;
        bool operator()(std::uint32_t a, std::uint32_t b) const {
            return share[a] > share[b] || (share[a] == share[b] && a < b);
        }
    };
    template <typename Count>
    void follow_step(const Recording& recording, std::span<const Met> met, Count count) {
        const std::uint32_t step = ++followed_;
        const std::uint32_t cell = id_of(recording.steps[step - 1].item, Kind::cell);
        if (cell == none) return;
        in_front_.erase(cell);
        if (share_[cell] == 0 && count(cell) > 0) add_if_waiting(recording, met, step, cell);
        reach_enqueued(recording.changes_of(step));
    }
    void add_if_waiting(const Recording&, std::span<const Met>, std::uint32_t step, std::uint32_t cell);
    void reach_enqueued(std::span<const Change> changes);
    void reach(std::uint32_t cell);

    std::span<const double> share_;
    std::span<const std::uint8_t> visible_;
    std::set<std::uint32_t, LargerShare> in_front_, clean_;  ///< visible cells
    std::vector<Inversion> found_;
    std::uint32_t followed_ = 0;
};

/// Every inversion of a recording, most wasted primitives first, then by step. `run` stands at the recording's end, or
/// undoes by marks.
template <int D>
std::vector<Inversion> inversions(const Reference& reference, const Run<D>& run, const Recording& recording);

}  // namespace sightline
