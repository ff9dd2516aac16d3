// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formula/formula_heuristic.h"

#include <limits>

#include "core/base/number.h"
#include "core/methods/cells/facet_geometry.h"
#include "core/methods/cells/seed_cells.h"
#include "core/methods/cells/star_shape.h"

namespace sightline {

namespace {

std::string check_key(const ParameterRow&, std::string_view text) {
    const Formula compiled(text, formula_term_words, "key");  // throws for what cannot be
    return std::string(text);
}

/// Of the facet: length in 2D, area of its polygon in 3D.
double size_of(const CellComplex<2>& cells, const HalfFacet& half) {
    const auto [a, b] = facet_ends(cells, half);
    return std::sqrt(glm::dot(b - a, b - a));
}
double size_of(const CellComplex<3>& cells, const HalfFacet& half) {
    const auto polygon = cells.points_of_facet(half.facet());
    Vec<3> twice(0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        twice += glm::cross(cells.points[polygon[i - 1]] - cells.points[polygon[0]],
                            cells.points[polygon[i]] - cells.points[polygon[0]]);
    return std::sqrt(glm::dot(twice, twice)) / 2;
}

/// Breadth first from the seeds.
template <int D>
std::vector<std::uint32_t> hops_from_seeds(const Problem<D>& problem) {
    const CellComplex<D>& cells = *problem.cells;
    std::vector<std::uint32_t> hops(cells.cell_count(), none), queue = seed_cells(problem);
    for (const std::uint32_t seed : queue) hops[seed] = 0;
    for (std::size_t next = 0; next < queue.size(); ++next)
        for (const HalfFacet& half : cells.facets_of(queue[next])) {
            if (half.neighbour == none || hops[half.neighbour] != none) continue;
            hops[half.neighbour] = hops[queue[next]] + 1;
            queue.push_back(half.neighbour);
        }
    return hops;
}

KeyAbout about_of(FormulaTerm term) {
    switch (term) {
        case FormulaTerm::content:
            return KeyAbout::content;
        case FormulaTerm::angle:
        case FormulaTerm::area:
            return KeyAbout::angle;
        case FormulaTerm::handed_on:
            return KeyAbout::handed_on;
        case FormulaTerm::star:
            return KeyAbout::star;
        default:
            return KeyAbout::own;
    }
}

template <int D>
double longest_side(const CellComplex<D>& cells) {
    Box<D> box;
    for (const Vec<D>& point : cells.points) box.add(point);
    return cells.points.empty() ? 1 : box.longest_side();
}

}  // namespace

std::span<const std::string_view> formula_term_help() {
    static constexpr auto help = std::to_array<std::string_view>({
        "primitives in the cell before, as a share of the most in one cell",
        "v · n of the facet, after transfer_sign",
        "the key of the cell before",
        "1 where the ray from the eye to the cell's centre passes through the facet, else 0",
        "primitives in the cell itself, as a share of the most in one cell",
        "the same, counting only those that turn a visible side to the eye",
        "from the eye to the cell's centre along the view direction, over the longest side of the tessellation",
        "from the eye to the cell's centre, over the longest side of the tessellation",
        "facets between the cell and the nearest seed",
        "area of the facet over the square of that side (2D: its length over the side)",
    });
    static_assert(help.size() == formula_term_words.size());
    return help;
}

const ParameterRow& formula_key_row() {
    static const ParameterRow row =
        text_row("key", "content + angle * handed_on", "an expression", "docs/command-line.md, methods",
                 "the key of a cell, the lowest first: an expression of content, angle, handed_on, star, own_content, "
                 "facing, depth, distance, hops, area",
                 check_key);
    return row;
}

std::vector<const ParameterRow*> formula_parameter_rows() {
    return {&formula_key_row(), &view_vector_row(), &transfer_sign_row(), &on_reenqueue_row(), &solidity_scale_row()};
}

template <int D>
FormulaHeuristic<D>::FormulaHeuristic(const Problem<D>& problem)
    : on_reenqueue(problem.parameters.template choice<OnReenqueue>(on_reenqueue_row())),
      formula_(problem.parameters.text(formula_key_row()), formula_term_words, "key"),
      parameters_(problem.parameters),
      scale_(sightline::solidity_scale(problem)),
      size_(longest_side(*problem.cells)),
      forward_(problem.view.forward()) {
    for (const std::size_t term : formula_.used()) uses_ |= 1u << term;
    if (uses(FormulaTerm::hops)) hops_ = hops_from_seeds(problem);
}

template <int D>
void FormulaHeuristic<D>::set_terms(const Problem<D>& problem, std::uint32_t a, double key_a, const HalfFacet& half,
                                    Values& values) const {
    const CellComplex<D>& cells = *problem.cells;
    const std::uint32_t b = half.neighbour;
    const Vec<D>& eye = problem.view.eye;
    const auto set = [&](FormulaTerm term, auto value) {
        if (uses(term)) values[static_cast<std::size_t>(term)] = value();
    };
    set(FormulaTerm::content, [&] { return std::min(cells.count(a) / scale_, 1.0); });
    set(FormulaTerm::angle, [&] {
        const FacetGeometry<D> facet = facet_geometry(cells, half);
        const double alignment =
            cosine<D>(parameters_.view_vector == ViewVector::eye ? facet.centroid - eye : forward_, facet.normal);
        if (parameters_.transfer_sign == TransferSign::clamp) return std::max(alignment, 0.0);
        return parameters_.transfer_sign == TransferSign::abs ? std::abs(alignment) : alignment;
    });
    values[static_cast<std::size_t>(FormulaTerm::handed_on)] = key_a;
    set(FormulaTerm::star, [&] { return star_shaped(cells, half, eye, cells.centre(b)) ? 1.0 : 0.0; });
    set(FormulaTerm::own_content, [&] { return std::min(cells.count(b) / scale_, 1.0); });
    set(FormulaTerm::facing, [&] {
        double facing = 0;
        for (const std::uint32_t primitive : cells.primitives_of(b)) facing += turns_a_seen_side(problem, primitive);
        return std::min(facing / scale_, 1.0);
    });
    set(FormulaTerm::depth, [&] { return glm::dot(cells.centre(b) - eye, forward_) / size_; });
    set(FormulaTerm::distance, [&] {
        const Vec<D> d = cells.centre(b) - eye;
        return std::sqrt(glm::dot(d, d)) / size_;
    });
    set(FormulaTerm::hops, [&] { return static_cast<double>(hops_[b]); });
    set(FormulaTerm::area, [&] {
        double area = size_of(cells, half);
        for (int i = 1; i < D; ++i) area /= size_;
        return area;
    });
}

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
