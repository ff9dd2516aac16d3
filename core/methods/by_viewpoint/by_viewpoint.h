// Method `by-viewpoint`: the technique that a table recommends for the eye's region and direction (DAS).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/method.h"

namespace sightline {

inline constexpr std::string_view by_viewpoint_id = "by-viewpoint";

/// `methods`: what it may choose from.
template <int D>
Method<D> viewpoint_method(std::vector<Method<D>> methods);

}  // namespace sightline
