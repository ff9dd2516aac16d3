// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formula/formula_terms.h"

#include <algorithm>
#include <cmath>

#include "core/methods/cells/facet_geometry.h"
#include "core/methods/cells/seed_cells.h"
#include "core/methods/cells/star_shape.h"

namespace sightline {

namespace {

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

template <int D>
double longest_side(const CellComplex<D>& cells) {
    Box<D> box;
    for (const Vec<D>& point : cells.points) box.add(point);
    return cells.points.empty() ? 1 : box.longest_side();
}

}  // namespace

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

template <int D>
FormulaTerms<D>::FormulaTerms(const Problem<D>& problem, bool hops)
    : parameters_(problem.parameters),
      scale_(sightline::solidity_scale(problem)),
      size_(longest_side(*problem.cells)),
      forward_(problem.view.forward()) {
    if (hops) hops_ = hops_from_seeds(problem);
}

template <int D>
double FormulaTerms<D>::value(FormulaTerm term, const Problem<D>& problem, std::uint32_t a, double key_a,
                              const HalfFacet& half) const {
    const CellComplex<D>& cells = *problem.cells;
    const std::uint32_t b = half.neighbour;
    const Vec<D>& eye = problem.view.eye;
    switch (term) {
        case FormulaTerm::content:
            return std::min(cells.count(a) / scale_, 1.0);
        case FormulaTerm::angle: {
            const FacetGeometry<D> facet = facet_geometry(cells, half);
            const double alignment =
                cosine<D>(parameters_.view_vector == ViewVector::eye ? facet.centroid - eye : forward_, facet.normal);
            if (parameters_.transfer_sign == TransferSign::clamp) return std::max(alignment, 0.0);
            return parameters_.transfer_sign == TransferSign::abs ? std::abs(alignment) : alignment;
        }
        case FormulaTerm::handed_on:
            return key_a;
        case FormulaTerm::star:
            return star_shaped(cells, half, eye, cells.centre(b)) ? 1.0 : 0.0;
        case FormulaTerm::own_content:
            return std::min(cells.count(b) / scale_, 1.0);
        case FormulaTerm::facing: {
            double facing = 0;
            for (const std::uint32_t primitive : cells.primitives_of(b))
                facing += turns_a_seen_side(problem, primitive);
            return std::min(facing / scale_, 1.0);
        }
        case FormulaTerm::depth:
            return glm::dot(cells.centre(b) - eye, forward_) / size_;
        case FormulaTerm::distance: {
            const Vec<D> d = cells.centre(b) - eye;
            return std::sqrt(glm::dot(d, d)) / size_;
        }
        case FormulaTerm::hops:
            return static_cast<double>(hops_[b]);
        case FormulaTerm::area: {
            double area = size_of(cells, half);
            for (int i = 1; i < D; ++i) area /= size_;
            return area;
        }
        case FormulaTerm::count:
            break;
    }
    return 0;
}

template class FormulaTerms<2>;
template class FormulaTerms<3>;

}  // namespace sightline
