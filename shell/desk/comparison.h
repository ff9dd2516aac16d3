// A second session beside the first: left is the one that a person moves and changes, right goes along.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/session/comparison.h"

namespace sightline {

/// Where the two runs first differ.
struct Difference {
    std::uint32_t step = none;  ///< from 1; none: they agree to the end
    std::string sentence;
    std::uint64_t run = 0;  ///< Workbench::run that it was made for
};

/// The session on the right.
template <int D>
struct Other {
    Session<D> session;
    Align align = Align::step;
    std::string title;  ///< what was asked for: "centroid", "jitter=0.1", a file

    // The left side's as they were when this one was last moved along, to see what has changed there.
    std::shared_ptr<const Scene<D>> lead_scene{};
    ViewSpec<D> lead_view{};
    mutable std::optional<Difference> difference{};  ///< made on first use
};

}  // namespace sightline
