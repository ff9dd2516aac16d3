// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formula/formula_heuristic.h"

#include <algorithm>
#include <limits>

#include "core/base/number.h"

namespace sightline {

namespace {

std::string check_key(const ParameterRow&, std::string_view text) {
    const Formula compiled(text, formula_term_words, "key");  // throws for what cannot be
    return std::string(text);
}

}  // namespace

const ParameterRow& formula_key_row() {
    static const ParameterRow row =
        text_row("key", "content + angle * handed_on", "an expression", "docs/command-line.md, methods",
                 "the key of a cell, the lowest first: an expression of content, angle, handed_on, star, own_content, "
                 "facing, depth, distance, hops, area",
                 check_key);
    return row;
}

std::vector<const ParameterRow*> formula_parameter_rows() {
    std::vector<const ParameterRow*> rows = formula_term_rows();
    rows.insert(rows.begin(), &formula_key_row());
    return rows;
}

template <int D>
FormulaHeuristic<D>::FormulaHeuristic(const Problem<D>& problem)
    : on_reenqueue(problem.parameters.template choice<OnReenqueue>(on_reenqueue_row())),
      formula_(problem.parameters.text(formula_key_row()), formula_term_words, "key"),
      terms_(problem, std::count(formula_.used().begin(), formula_.used().end(),
                                 static_cast<std::size_t>(FormulaTerm::hops)) > 0) {}

/// What is no number comes last: a front needs an order.
template <int D>
double FormulaHeuristic<D>::key_of(const Values& values) const {
    const double key = formula_.value(values);
    return key == key ? key : std::numeric_limits<double>::infinity();
}

template <int D>
KeyExplanation FormulaHeuristic<D>::explain(const Problem<D>& problem, std::uint32_t a, double key_a,
                                            const HalfFacet& half, int digits) const {
    Values values;
    set_terms(problem, a, key_a, half, values);
    KeyExplanation e;
    e.key = key_of(values);
    e.parts = {{"key = " + formula_.text() + " = " + short_number(e.key, digits)}};
    std::size_t largest = formula_term_words.size();
    for (const std::size_t term : formula_.used()) {
        e.terms.push_back({formula_term_words[term], values[term], {}});
        e.parts.push_back({e.parts.size() == 1 ? " (" : ", "});
        e.parts.push_back({std::string(formula_term_words[term]) + " " + short_number(values[term], digits),
                           about_of(static_cast<FormulaTerm>(term)), formula_term_words[term]});
        if (largest == formula_term_words.size() || values[term] > values[largest]) largest = term;
    }
    if (e.parts.size() > 1) e.parts.push_back({")"});
    e.terms.push_back({"key", e.key, {}});
    e.tip = "the expression, its value, and the terms in it";
    e.weightiest = largest == formula_term_words.size()
                       ? "its key, " + short_number(e.key)
                       : "the largest of its terms, " + std::string(formula_term_words[largest]) + " (" +
                             short_number(values[largest]) + ")";
    return e;
}

template <int D>
void FormulaHeuristic<D>::add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained,
                                        int digits) const {
    lines.push_back({"key(n, c): the expression you typed", 0, false, {}, {}});
    for (const std::size_t term : formula_.used()) {
        lines.push_back(
            {std::string(formula_term_words[term]) + " = " + std::string(formula_term_help()[term]), 1, false, {}, {}});
        if (!explained) continue;
        for (const Term& value : explained->terms)
            if (value.name == formula_term_words[term]) lines.back().values = short_number(value.value, digits);
    }
    lines.push_back({"key = " + formula_.text(), 1, false, {}, {}});
    if (explained) lines.back().values = short_number(explained->key, digits);
}

template class FormulaHeuristic<2>;
template class FormulaHeuristic<3>;

}  // namespace sightline
