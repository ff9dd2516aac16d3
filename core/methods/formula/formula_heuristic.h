// A heuristic that a person types: the key of a cell as an expression over named terms, compiled once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/formula.h"
#include "core/methods/cells/cell_run.h"
#include "core/methods/formula/formula_terms.h"

namespace sightline {

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

    /// Those that the expression uses.
    void set_terms(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half,
                   Values& values) const {
        for (const std::size_t term : formula_.used())
            values[term] = terms_.value(static_cast<FormulaTerm>(term), problem, a, key_a, half);
    }
    double key_of(const Values& values) const;

    Formula formula_;
    FormulaTerms<D> terms_;
};

extern template class FormulaHeuristic<2>;
extern template class FormulaHeuristic<3>;

}  // namespace sightline
