// Writes the steps of a run down while it makes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/step.h"

namespace sightline {

class Recorder {
public:
    explicit Recorder(Recording& recording) : recording_(recording) {}

    /// Begins a step.
    void popped(const Item& item, const Mark& mark, const Item& runner_up = {}, double runner_up_key = 0) {
        Step step;
        step.item = item;
        step.key = mark.key;
        step.stamp = mark.stamp;
        step.runner_up = runner_up;
        step.runner_up_key = runner_up_key;
        step.first_change = static_cast<std::uint32_t>(recording_.changes.size());
        step.first_note = static_cast<std::uint32_t>(recording_.notes.size());
        recording_.steps.push_back(step);
    }
    /// The step's item, where it is known only at the end.
    void ends_with(const Item& item, const Mark& mark) {
        recording_.steps.back().item = item;
        recording_.steps.back().key = mark.key;
        recording_.steps.back().stamp = mark.stamp;
    }
    /// Of the step that was begun last; `before` is the item's mark before the step.
    void changed(const Item& item, const Mark& before, std::uint8_t rule, std::uint32_t via = none,
                 bool penalty = false) {
        recording_.changes.push_back({before.key, before.stamp, item.id, via, rule, penalty, item.kind, before.state});
    }
    void note(std::span<const std::byte> bytes) {
        recording_.notes.insert(recording_.notes.end(), bytes.begin(), bytes.end());
    }
    /// Ends it, or what the budget had left of it.
    void finished(const Counters& after) { recording_.steps.back().after = after; }

private:
    Recording& recording_;
};

}  // namespace sightline
