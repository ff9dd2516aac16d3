// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/corner_words.h"

#include "core/base/number.h"
#include "core/methods/transmittance/transmittance.h"

namespace sightline {

template <int D>
CornerTerms corner_terms(const CornerLight<D>& light, const Problem<D>& problem, std::uint32_t cell) {
    CornerTerms terms;
    const auto corners = problem.cells->corners_of(cell);
    std::uint32_t darkest = corners.front();
    for (const std::uint32_t corner : corners) {
        const double there = double{light.at(problem, corner)};
        terms.corners.push_back(there);
        if (there < terms.least) darkest = corner;
        terms.least = std::min(terms.least, there);
        terms.most = std::max(terms.most, there);
    }
    terms.mean = light.of_cell(problem, cell);
    const CornerRay<D> ray = light.ray(problem, darkest);
    if (!ray.ends) {
        terms.before = ray.cell;
        terms.opacity = 1 - double{light.open(ray)};
    }
    return terms;
}

std::string listed(const CornerTerms& terms, int digits) {
    constexpr std::size_t few = 4;
    if (terms.corners.size() > few)
        return short_number(terms.least, digits) + " to " + short_number(terms.most, digits);
    std::string all;
    for (const double corner : terms.corners) all += (all.empty() ? "" : " ") + short_number(corner, digits);
    return all;
}

std::string what_darkens(const CornerTerms& terms) {
    if (terms.least == 1) return {};
    const std::string darkest = "; its darkest corner has " + short_number(terms.least);
    if (terms.opacity == 0) return darkest;
    return darkest + ", through cell " + std::to_string(terms.before) + ", of which " + short_number(terms.opacity) +
           " is covered";
}

void add_terms(std::vector<Term>& terms, const CornerTerms& corners) {
    terms.insert(terms.end(), {{"corner_least", corners.least, {}},
                               {"corner_most", corners.most, {}},
                               {"opacity", corners.opacity, {}},
                               {"transmittance", corners.mean, {}}});
}

void add_corner_lines(std::vector<CodeLine>& lines, const KeyExplanation* e, int digits) {
    add_term_line(lines, "opacity = covered share of the cell before a corner of n", e, "opacity", digits);
    add_term_line(lines, "light at the corner = (1 − opacity) · light where its ray to the eye leaves that cell", e,
                  "corner_least", digits);
    add_term_line(lines, "T = mean of the light at the corners of n", e, "transmittance", digits);
}

KeyExplanation explain_corners(const CornerTerms& terms, int digits) {
    KeyExplanation e;
    e.key = 1 - terms.mean;
    e.parts = {{"1 − T = 1 − mean of "},
               {listed(terms, digits), KeyAbout::own, "light at its corners"},
               {" = " + short_number(e.key, digits)}};
    e.tip = "the light that comes to the corners of the cell through what lies before them, projected or not";
    e.weightiest = e.key == 0 ? "nothing is in the way: all its light has come"
                              : "the light that its corners lack, " + short_number(e.key) + what_darkens(terms);
    add_terms(e.terms, terms);
    e.terms.push_back({"key", e.key, {}});
    return e;
}

template CornerTerms corner_terms<2>(const CornerLight<2>&, const Problem<2>&, std::uint32_t);
template CornerTerms corner_terms<3>(const CornerLight<3>&, const Problem<3>&, std::uint32_t);

}  // namespace sightline
