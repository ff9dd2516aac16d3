// Cells by the optical depth between them and the eye: what the gem asks for as a better heuristic than layers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_run.h"
#include "core/methods/cells/facet_geometry.h"
#include "core/methods/extinction/cell_extinction.h"

namespace sightline {

/// The terms of one key: handed on + depth · way.
struct ExtinctionTerms {
    double handed_on = 0;  ///< the key of the cell just projected: the depth from the eye to it
    double depth = 0;      ///< of that cell along its mean chord (CellExtinction)
    double way = 0;        ///< length of the eye ray in it, over its mean chord; 0 where it does not leave it there
    double key = 0;
};

KeyExplanation explain_extinction(const ExtinctionTerms& terms, int digits);
void add_extinction_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits);

template <int D>
class Extinction {
public:
    static constexpr double seed_key = 0;
    static constexpr std::string_view key_title = "optical depth from the eye";
    /// Of several ways to a cell that through which most is seen counts.
    static constexpr OnReenqueue on_reenqueue = OnReenqueue::min;

    explicit Extinction(const Problem<D>& problem) : cells_(cell_extinction(problem)) {}

    /// The eye ray is that to the centroid of the facet.
    ExtinctionTerms terms(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half) const {
        ExtinctionTerms t;
        t.handed_on = key_a;
        t.depth = cells_->depth[a];
        // Exact: a ray that enters the cell there has no way in it, and a rounded length would break ties at random. A
        // contact has no side.
        if (t.depth > 0 &&
            (problem.cells->is_contact(half.facet()) || facet_side(*problem.cells, half, problem.view.eye) > 0))
            t.way = length_in_cell(*problem.cells, a, problem.view.eye, facet_geometry(*problem.cells, half).centroid) /
                    cells_->chord[a];
        t.key = t.handed_on + t.depth * t.way;
        return t;
    }

    Key key(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half) const {
        return terms(problem, a, key_a, half).key;
    }
    KeyExplanation explain(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half,
                           int digits) const {
        return explain_extinction(terms(problem, a, key_a, half), digits);
    }
    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const {
        add_extinction_lines(lines, explained, digits);
    }

private:
    std::shared_ptr<const CellExtinction<D>> cells_;
};

}  // namespace sightline
