// Sessions over random scenes, and what a traversal is without one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/session/session.h"
#include "tests/scene/random_scene.h"

namespace sightline::test {

/// What a session is made of.
struct Start {
    std::shared_ptr<const Scene<2>> scene;
    ViewSpec<2> view;
    Settings settings;

    Session<2> session() const { return {scene, view, settings}; }
};

inline Start random_start(Random& random, std::size_t most_segments = 60) {
    Start start;
    start.scene = std::make_shared<const Scene<2>>(random_scene(random, random.below(most_segments)));
    start.view = random_view(random);
    start.settings = random_settings(random);
    return start;
}

/// As random_start, for a method that orders cells.
inline Start random_cell_start(Random& random, std::size_t most_segments = 60) {
    Start start = random_start(random, most_segments);
    start.settings.method = random.below(4) == 0 ? "layers" : "published";
    return start;
}

/// Marks of all cells, to compare before and after a step.
inline std::vector<CellMark> marks(const Session<2>& session) {
    std::vector<CellMark> all(session.cells().cell_count());
    for (std::uint32_t cell = 0; cell < all.size(); ++cell) all[cell] = session.state().mark(cell);
    return all;
}

/// The front as the marks tell it, first to last.
inline std::vector<Front::Entry> sorted_front(const std::vector<CellMark>& marks) {
    std::vector<Front::Entry> front;
    for (std::uint32_t cell = 0; cell < marks.size(); ++cell)
        if (marks[cell].state == CellState::enqueued) front.push_back({marks[cell].key, marks[cell].stamp, cell});
    std::sort(front.begin(), front.end(),
              [](const auto& a, const auto& b) { return a.key != b.key ? a.key < b.key : a.stamp < b.stamp; });
    return front;
}

}  // namespace sightline::test
