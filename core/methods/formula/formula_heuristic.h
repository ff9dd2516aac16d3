// A heuristic that a person types: the key of a cell as an expression over named terms, compiled once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/formula.h"
#include "core/methods/cells/cell_run.h"
#include "core/methods/plp/plp_parameters.h"

namespace sightline {

/// The terms of a formula. A is the cell just projected, B the cell that gets the key; sizes are shares of the longest
/// side of the tessellation.
enum class FormulaTerm : std::uint8_t {
    content,      ///< |A| / ρ_max, cut at 1
    angle,        ///< v · n of the facet after transfer_sign
    handed_on,    ///< the key of A
    star,         ///< 1 where the ray from the eye to the centre of B passes through the facet, else 0
    own_content,  ///< |B| / ρ_max, cut at 1
    facing,       ///< the same of the primitives in B that turn a seen side to the eye
    depth,        ///< from the eye to the centre of B along the view direction
    distance,     ///< from the eye to the centre of B
    hops,         ///< facets between B and the nearest seed
    area,         ///< of the facet; 2D: its length
    count,
};
inline constexpr auto formula_term_words = std::to_array<std::string_view>(
    {"content", "angle", "handed_on", "star", "own_content", "facing", "depth", "distance", "hops", "area"});
/// A line each, in that order.
std::span<const std::string_view> formula_term_help();

/// The expression.
const ParameterRow& formula_key_row();
std::vector<const ParameterRow*> formula_parameter_rows();

template <int D>
class FormulaHeuristic {
public:
    static constexpr double seed_key = 0;
    OnReenqueue on_reenqueue;

    explicit FormulaHeuristic(const Problem<D>& problem);

    Key key(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half) const {
        Values values;
        set_terms(problem, a, key_a, half, values);
        return key_of(values);
    }
    KeyExplanation explain(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half,
                           int digits) const;
    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const;

private:
    using Values = std::array<double, static_cast<std::size_t>(FormulaTerm::count)>;

    bool uses(FormulaTerm term) const { return uses_ >> static_cast<unsigned>(term) & 1; }
    /// Those that the expression uses.
    void set_terms(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half,
                   Values& values) const;
    double key_of(const Values& values) const;

    Formula formula_;
    std::uint32_t uses_ = 0;  ///< a bit per term
    PlpParameters parameters_;
    double scale_;  ///< what |A| is divided by
    double size_;   ///< the longest side of the tessellation
    Vec<D> forward_;
    std::vector<std::uint32_t> hops_;  ///< per cell; empty where they are not used
};

extern template class FormulaHeuristic<2>;
extern template class FormulaHeuristic<3>;

}  // namespace sightline
