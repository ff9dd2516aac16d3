// The layer heuristic of the gem: a cell's key is its distance from the seed in facets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_run.h"

namespace sightline {

struct LayerNumber {
    static constexpr double seed_key = 0;
    static constexpr std::string_view key_title = "layer";
    /// Only clean neighbours get a layer (gem, add_neighbors_to_front).
    static constexpr OnReenqueue on_reenqueue = OnReenqueue::never;

    template <int D>
    Key key(const Problem<D>&, std::uint32_t, double layer_a, const HalfFacet&) const {
        return layer_a + 1;
    }

    template <int D>
    KeyExplanation explain(const Problem<D>& problem, std::uint32_t a, double layer_a, const HalfFacet& half,
                           int digits) const {
        KeyExplanation e;
        e.key = key(problem, a, layer_a, half).value;
        e.parts = {{"layer = "},
                   {short_number(layer_a, digits), KeyAbout::handed_on, "layer before"},
                   {" + 1 = " + short_number(e.key, digits)}};
        e.tip = "the layer of the cell it was reached from, plus 1";
        e.weightiest = "its way from the seed: " + short_number(e.key) + (e.key == 1 ? " facet" : " facets");
        e.terms = {{"layer_a", layer_a, {}}, {"key", e.key, {}}};
        return e;
    }

    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int) const {
        lines.push_back({"key(n, c): the layer of n, behind c", 0, false, {}, {}});
        lines.push_back({"the layer of c + 1", 1, false, {}, "gem, add_neighbors_to_front"});
        if (!explained) return;
        const std::string sum = explained->sum();
        lines.back().values = sum.substr(sum.find('=') + 2);
    }
};

}  // namespace sightline
