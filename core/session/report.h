// A session in numbers: the statistics of a run and the trace of its steps, as JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/session/session.h"

namespace sightline {

/// One object with the fields of `--stats` (docs/command-line.md). 2D: `coverage` is against the exact set;
/// `item_buffer` repeats it against the papers' reference of reference_size pixels.
template <int D>
std::string stats_json(const Session<D>& session, Stop stop);

/// The records of all steps up to the session's position, with the terms of every key.
template <int D>
std::string trace_json(const Session<D>& session);

/// The conditions of a number in one line: scene, seed, method, cells, budget, reference.
template <int D>
std::string conditions(const Session<D>& session);

}  // namespace sightline
