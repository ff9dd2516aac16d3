// The named terms of a key that a person makes up: in a typed formula, or in a function of a script.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/methods/plp/plp_parameters.h"
#include "core/run/explanation.h"

namespace sightline {

/// A is the cell just projected, B the cell that gets the key; sizes are shares of the longest side of the
/// tessellation.
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

/// What a term is about, for the colours of explanations.
KeyAbout about_of(FormulaTerm term);

/// Those that the terms obey.
inline std::vector<const ParameterRow*> formula_term_rows() {
    return {&view_vector_row(), &transfer_sign_row(), &on_reenqueue_row(), &solidity_scale_row()};
}

template <int D>
class FormulaTerms {
public:
    /// `hops`: whether that term will be asked for; it looks at every cell.
    FormulaTerms(const Problem<D>& problem, bool hops);

    bool has_hops() const { return !hops_.empty(); }
    double value(FormulaTerm term, const Problem<D>& problem, std::uint32_t a, double key_a,
                 const HalfFacet& half) const;

private:
    PlpParameters parameters_;
    double scale_;  ///< what |A| is divided by
    double size_;   ///< the longest side of the tessellation
    Vec<D> forward_;
    std::vector<std::uint32_t> hops_;  ///< per cell; empty where they are not used
};

extern template class FormulaTerms<2>;
extern template class FormulaTerms<3>;

}  // namespace sightline
