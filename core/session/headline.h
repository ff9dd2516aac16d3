// What a run is and what it has found, in a line: for titles, banners and headers of panes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/session/explain.h"

namespace sightline {

/// Whether the picture tells what is visible (show_visibility): where it does not, no line of words does either.
template <int D>
bool tells_truth(const Session<D>& session) {
    return session.settings().show_visibility == Switch::on;
}

/// "Bottleneck: PLP as published, 76 cells, 22 of 337 segments visible"; of a frame in flight no more than is known.
template <int D>
std::string headline(const Session<D>& session);

/// A coverage for people: 1 only where nothing is missing ("0.9997"); "none" where nothing is visible.
std::string coverage_text(std::optional<double> coverage);

/// "101 drawn, 10 of 22 visible found (45.5 %)"; "all 22 visible found".
template <int D>
std::string result_line(const Session<D>& session);

/// "Step 7 took cell 26 (0.274). Next was 13 (0.301). 16 drawn, none visible." `of` names the run, where there are two:
/// "Left, step 7 …".
std::string step_line(const StepExplanation& step, bool truth, std::string_view of = {});

}  // namespace sightline
