// Sessions over random scenes, and what a traversal is without one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/methods/cells/cell_rules.h"
#include "core/run/front.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/session/session.h"
#include "tests/run/run_support.h"
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
inline std::vector<Mark> marks(const Session<2>& session) {
    std::vector<Mark> all(session.cells().cell_count());
    for (std::uint32_t cell = 0; cell < all.size(); ++cell) all[cell] = session.mark(cell);
    return all;
}

/// The front as the marks tell it, first to last.
inline std::vector<Front::Entry> sorted_front(const std::vector<Mark>& marks) {
    std::vector<Front::Entry> front;
    for (std::uint32_t cell = 0; cell < marks.size(); ++cell)
        if (marks[cell].state == CellState::enqueued) front.push_back({marks[cell].key, marks[cell].stamp, cell});
    std::sort(front.begin(), front.end(),
              [](const auto& a, const auto& b) { return a.key != b.key ? a.key < b.key : a.stamp < b.stamp; });
    return front;
}

/// The number of a term that a key was made of.
inline double term(const KeyExplanation& key, std::string_view name) {
    for (const Term& t : key.terms)
        if (t.name == name) return t.value;
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace sightline::test
