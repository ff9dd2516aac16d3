// Files that say what was rendered in each frame: those of `lab sets`, and those that an engine writes of its own set.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/flight_path.h"

namespace sightline {

/// A frame and what was rendered in it, in the file's order. It has a number, a view, or both.
template <int D>
struct SetFrame {
    std::optional<std::uint32_t> number;  ///< in the path that was flown
    std::optional<ViewSpec<D>> view;
    std::vector<std::uint32_t> primitives;
    std::vector<std::string> objects;  ///< names; all their primitives
};

/// Coordinates are the scene's own where its origin is `origin`.
template <int D>
struct SetsFile {
    Vec<D> origin{};
    std::vector<SetFrame<D>> frames;
};

/// JSON, where the text begins with '{', else CSV with a line of names (docs/measuring.md has both). Throws InputError
/// "name: place: reason".
template <int D>
SetsFile<D> read_sets(std::string_view text, const std::string& name);

}  // namespace sightline
