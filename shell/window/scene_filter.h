// Which scenes the chooser lists, and where the arrow keys lead among them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "shell/window/stage.h"

namespace sightline {

/// Indices into the choices, in rows of at most `columns`; a row holds one group only.
struct SceneRows {
    std::vector<std::vector<std::size_t>> rows;

    std::size_t count() const;
};

/// Every word of the filter stands in the name, the title, the sentence or the group, whatever the case of its letters.
SceneRows scene_rows(const std::vector<SceneChoice>& choices, std::string_view filter, std::size_t columns);

struct SceneSpot {
    std::size_t row = 0, column = 0;
    bool operator==(const SceneSpot&) const = default;
};

/// From one spot by so many rows down and places to the right: along a row on to the next one, up and down in the
/// column as far as the row there reaches; at the ends it stays.
SceneSpot moved_spot(const SceneRows& rows, SceneSpot from, int down, int right);

}  // namespace sightline
