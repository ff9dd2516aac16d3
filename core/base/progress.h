// Word of something that takes long.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace sightline {

/// Called at least every half second while something long goes on, on the caller's thread; may be empty. `what` names
/// the step for people; `share` in [0, 1] is how much of that step is done and never shrinks within it.
using Progress = std::function<void(std::string_view what, double share)>;

inline void report(const Progress& progress, std::string_view what, double share) {
    if (progress) progress(what, share);
}

}  // namespace sightline
