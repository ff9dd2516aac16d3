// Repeated clicks at one place go through what lies there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "shell/window/ui.h"

namespace sightline {

class ClickCycle {
public:
    /// Which of the choices this click takes, as `select` takes it; "none" when there are none. The first one, unless
    /// the click before was less than `reach` away.
    std::string next(std::span<const std::string> choices, const ImVec2& at, float reach);
    /// A click at the same place begins anew.
    void forget() { last_ = {-1e9f, -1e9f}; }

private:
    ImVec2 last_{-1e9f, -1e9f};
    std::size_t clicks_ = 0;
};

}  // namespace sightline
