// The numbers above a picture: what a frame costs and what it finds, always in sight.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "shell/window/ui.h"

namespace sightline {

struct Counter {
    std::string text;
    std::string widest{};  ///< as wide as the text gets, so that nothing moves while numbers run
    bool bold = false;
};

/// `title` first. `draw_ms`: of the last picture; `speed`: of flying, scene units a second.
std::vector<Counter> counters(const Session<3>& session, const std::string& title, double draw_ms,
                              std::optional<double> speed);

/// Of as many lines as a width asks for.
float counters_height(const Ui& ui, const std::vector<Counter>& counters, float width);
void draw_counters(ImDrawList& list, const Ui& ui, const std::vector<Counter>& counters, const Area& area);

}  // namespace sightline
