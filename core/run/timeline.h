// The recorded steps of a run and the way back and forth in them: by the marks of the changes, or from a keyframe where
// marks do not suffice.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/run/run.h"

namespace sightline {

/// A clone of the run as it stood after a step.
template <int D>
struct Keyframe {
    std::uint32_t step = 0;
    std::shared_ptr<const Run<D>> run;
};

/// Copies share their keyframes, which nobody changes.
template <int D>
class Timeline : public Recording {
public:
    /// Empties it for a run that stands at its start.
    void begin(const Run<D>& run);

    /// One step: again where it is recorded, else a new one, recorded. Stop::none when it was made, else why not.
    Stop forward(OwnRun<D>& run);
    /// One step back; false at the start.
    bool back(OwnRun<D>& run);
    /// To a recorded step, from wherever the run stands in the recording.
    void seek(OwnRun<D>& run, std::uint32_t step);

    const std::vector<Keyframe<D>>& keyframes() const { return keyframes_; }
    std::size_t keyframe_bytes() const;
    std::size_t memory_bytes() const { return Recording::memory_bytes() + keyframe_bytes(); }

    /// Keyframes may take so many bytes; beyond, every second one goes and new ones come half as often.
    std::size_t most_keyframe_bytes = std::size_t{256} << 20;

private:
    void keep(const Run<D>& run);
    void restore(OwnRun<D>& run, std::uint32_t step) const;

    std::vector<Keyframe<D>> keyframes_;  ///< by step, the first at the start
    std::uint32_t interval_ = 16;         ///< steps between them
};

extern template class Timeline<2>;
extern template class Timeline<3>;

}  // namespace sightline
