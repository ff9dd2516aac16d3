// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/click_cycle.h"

#include <cmath>

namespace sightline {

std::string ClickCycle::next(std::span<const std::string> choices, const ImVec2& at, float reach) {
    clicks_ = std::hypot(at.x - last_.x, at.y - last_.y) < reach ? clicks_ + 1 : 0;
    last_ = at;
    return choices.empty() ? "none" : choices[clicks_ % choices.size()];
}

}  // namespace sightline
