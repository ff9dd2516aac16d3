// Giving a lesson: parts are opened, beats played forward and back, guesses scored.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "shell/panels/panel.h"

namespace sightline {

/// Opens a part, from 0. Throws InputError for a lesson of the other dimension or a part that it does not have, and
/// what opening it throws; then the lesson that was given before goes on.
template <int D>
void begin_lesson(Workbench<D>& bench, const Lesson& lesson, std::size_t part = 0);

/// The next beat; after the last one of a part the next part. A guess is scored by the cell that the beat's step takes.
/// Throws InputError without a lesson.
template <int D>
void next_beat(Workbench<D>& bench);

/// The answer to the exercise of the next beat, which is then played: the key comes from the record of the run. Throws
/// InputError where nothing is asked.
template <int D>
void answer_exercise(Workbench<D>& bench, double key);

/// Takes the last beat back: opens the part anew and plays those before it. At the start of a part it goes to the end
/// of the one before. Throws InputError without a lesson.
template <int D>
void previous_beat(Workbench<D>& bench);

/// Whether pictures and words tell what is visible; no undo.
template <int D>
void tell_truth(Workbench<D>& bench, bool tell);

/// What a class reads of the lesson now: where it is, what the last beat says, what the next one asks.
template <int D>
std::vector<Row> lesson_lines(const Workbench<D>& bench);

/// What the one who speaks reads: the time, notes, what the next press asks and says, the part after this one.
template <int D>
std::vector<Row> speaker_rows(const Workbench<D>& bench);

}  // namespace sightline
