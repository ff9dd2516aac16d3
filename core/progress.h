// How far a long piece of work is, for whoever waits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace sightline {

/// `share` in [0, 1]. May be empty.
using Progress = std::function<void(std::string_view what, double share)>;

}  // namespace sightline
