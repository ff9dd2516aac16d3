// The solidity of TVCG fig. 5 (TR fig. 6), with a parameter for each thing that the papers leave open.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_run.h"
#include "core/methods/cells/facet_geometry.h"
#include "core/methods/cells/star_shape.h"
#include "core/methods/plp/plp_parameters.h"

namespace sightline {

/// The terms of one key: ρ_B = content + angle · handed on, with own_content=on + own content, then the penalty.
struct SolidityTerms {
    std::uint32_t count = 0;      ///< |A|
    double content = 0;           ///< |A| / ρ_max, cut at 1 with solidity_scale = p95
    double alignment = 0;         ///< v · n_B in [-1, 1]
    double angle = 0;             ///< alignment after transfer_sign
    double handed_on = 0;         ///< ρ_A, the key of the cell just projected
    std::uint32_t own_count = 0;  ///< |B|
    double own_content = 0;       ///< |B| / ρ_max with own_content=on
    bool star_tested = false;
    bool star_shaped = true;
    double unpenalised = 0;
    double key = 0;
};

/// What they say of a key, and the lines of fig. 5 with their values.
KeyExplanation explain_solidity(const SolidityTerms& terms, const PlpParameters& parameters, int digits);
void add_solidity_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, const PlpParameters& parameters,
                        double scale, int digits);

template <int D>
class PublishedSolidity {
public:
    static constexpr double seed_key = 0;
    static constexpr std::string_view key_title = "accumulated solidity ρ";
    /// A neighbour that is already in the front is updated again (TVCG fig. 4, line 10).
    OnReenqueue on_reenqueue;

    explicit PublishedSolidity(const Problem<D>& problem)
        : on_reenqueue(problem.parameters.template choice<OnReenqueue>(on_reenqueue_row())),
          parameters_(problem.parameters),
          scale_(sightline::solidity_scale(problem)),
          forward_(problem.view.forward()) {}

    /// All of them, or those that the key depends on.
    template <bool all = true>
    SolidityTerms terms(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half) const {
        const CellComplex<D>& cells = *problem.cells;
        SolidityTerms t;
        t.handed_on = key_a;
        t.count = cells.count(a);
        t.content = std::min(t.count / scale_, 1.0);
        if (all || key_a != 0) {
            const FacetGeometry<D> facet = facet_geometry(cells, half);
            t.alignment =
                cosine<D>(parameters_.view_vector == ViewVector::eye ? facet.centroid - problem.view.eye : forward_,
                          facet.normal);
        }
        t.angle = t.alignment;
        if (parameters_.transfer_sign == TransferSign::clamp) t.angle = std::max(t.alignment, 0.0);
        if (parameters_.transfer_sign == TransferSign::abs) t.angle = std::abs(t.alignment);
        t.unpenalised = t.content + t.angle * key_a;
        if (parameters_.own_content) {
            t.own_count = cells.count(half.neighbour);
            t.own_content = std::min(t.own_count / scale_, 1.0);
            t.unpenalised += t.own_content;
        }
        t.key = t.unpenalised;
        const bool penalty_matters = parameters_.penalty == Penalty::add || t.key != 0;
        if (parameters_.tests_star_shape && (all || penalty_matters)) {
            t.star_tested = true;
            t.star_shaped = star_shaped(cells, half, problem.view.eye, cells.centre(half.neighbour));
            if (!t.star_shaped)
                t.key = parameters_.penalty == Penalty::multiply ? t.key * parameters_.penalty_amount
                                                                 : t.key + parameters_.penalty_amount;
        }
        return t;
    }

    Key key(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half) const {
        const SolidityTerms t = terms(problem, a, key_a, half);
        return {t.key, !t.star_shaped};
    }
    double key_value(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half) const {
        return terms<false>(problem, a, key_a, half).key;
    }
    KeyExplanation explain(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half,
                           int digits) const {
        return explain_solidity(terms(problem, a, key_a, half), parameters_, digits);
    }
    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const {
        add_solidity_lines(lines, explained, parameters_, scale_, digits);
    }

private:
    PlpParameters parameters_;
    double scale_;
    Vec<D> forward_;  ///< unit vector
};

}  // namespace sightline
