// Where a lesson stands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/stopwatch.h"
#include "shell/lesson/lesson.h"

namespace sightline {

/// Cells that the class took and keys that it named, and how often the method had the same.
struct GuessScore {
    std::uint32_t made = 0, right = 0;
};

struct Teaching {
    Lesson lesson;
    std::size_t part = 0;
    /// In the part. Beats before it are done; its own question is asked, unless that is empty.
    std::size_t presses = 0;
    std::optional<double> answer;  ///< to the exercise that the next press tells
    std::string guessed;           ///< what became of the last guess, as a sentence
    GuessScore score;
    Stopwatch since;  ///< the lesson began

    const LessonPart& now() const { return lesson.parts[part]; }
    /// The last one that was done; nullptr at the start.
    const Beat* done() const { return presses > 0 ? &now().beats[presses - 1] : nullptr; }
    /// The next one; nullptr at the end of the part.
    const Beat* next() const { return presses < now().beats.size() ? &now().beats[presses] : nullptr; }
};

}  // namespace sightline
