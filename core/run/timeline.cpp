// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/timeline.h"

#include <algorithm>
#include <cassert>

namespace sightline {

template <int D>
void Timeline<D>::begin(const Run<D>& run) {
    steps.clear();
    changes.clear();
    notes.clear();
    start = run.counters();
    keyframes_.clear();
    interval_ = 16;
}

template <int D>
std::size_t Timeline<D>::keyframe_bytes() const {
    std::size_t bytes = 0;
    for (const Keyframe<D>& keyframe : keyframes_) bytes += keyframe.run->memory_bytes();
    return bytes;
}

template <int D>
void Timeline<D>::keep(const Run<D>& run) {
    keyframes_.push_back({run.steps(), std::shared_ptr<const Run<D>>(run.clone())});
    while (keyframes_.size() > 2 && keyframe_bytes() > most_keyframe_bytes) {
        interval_ *= 2;
        std::erase_if(keyframes_, [&](const Keyframe<D>& keyframe) { return keyframe.step % interval_ != 0; });
        if (interval_ > size()) break;
    }
}

/// From the last keyframe at or before the step, stepped again without a recording.
template <int D>
void Timeline<D>::restore(OwnRun<D>& run, std::uint32_t step) const {
    const auto after = std::upper_bound(keyframes_.begin(), keyframes_.end(), step,
                                        [](std::uint32_t s, const Keyframe<D>& k) { return s < k.step; });
    assert(after != keyframes_.begin());
    const Keyframe<D>& from = *(after - 1);
    const std::uint32_t budget = run->problem().budget;
    const std::vector<Met> all(run->drawn().all().begin(), run->drawn().all().end());
    // Going forward the run itself may be nearer than any keyframe.
    if (run->steps() > step || run->steps() < from.step) run = OwnRun<D>(from.run->clone());
    run->set_budget(budget);
    if (run->steps() < step) run->run(step - run->steps());
    assert(run->steps() == step);
    run->remember(all);  // what undone steps met is asked for
}

template <int D>
Stop Timeline<D>::forward(OwnRun<D>& run) {
    const std::uint32_t step = run->steps();
    if (step < size()) {
        if (!run->move(Direction::forward, steps[step], Recording::changes_of(step + 1), after(step)))
            restore(run, step + 1);
        return Stop::none;
    }
    // The start is kept with the first step, not before: a flight records none.
    if (keyframes_.empty() && !run->undoes_by_marks()) keep(*run);
    Recorder recorder(*this);
    const Stop stop = run->run(1, &recorder);
    if (stop != Stop::steps) return stop;
    if (!run->undoes_by_marks() && run->steps() % interval_ == 0 && run->steps() > step) keep(*run);
    return Stop::none;
}

template <int D>
bool Timeline<D>::back(OwnRun<D>& run) {
    const std::uint32_t step = run->steps();
    if (step == 0) return false;
    if (!run->move(Direction::back, steps[step - 1], Recording::changes_of(step), before(step))) restore(run, step - 1);
    return true;
}

template <int D>
void Timeline<D>::seek(OwnRun<D>& run, std::uint32_t step) {
    if (!run->undoes_by_marks()) {
        if (run->steps() != step) restore(run, step);
        return;
    }
    while (run->steps() > step) back(run);
    while (run->steps() < step) forward(run);
}

template class Timeline<2>;
template class Timeline<3>;

}  // namespace sightline
