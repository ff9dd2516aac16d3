// Light at corners, for people.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/transmittance/corner_light.h"
#include "core/run/explanation.h"

namespace sightline {

/// The light at the corners of a cell.
struct CornerTerms {
    std::vector<double> corners;  ///< in their order
    double least = 1, most = 0, mean = 0;
    std::uint32_t before = none;  ///< the cell that the darkest corner's light comes through
    double opacity = 0;           ///< of that cell, as the eye sees it
};

template <int D>
CornerTerms corner_terms(const CornerLight<D>& light, const Problem<D>& problem, std::uint32_t cell);

/// "0.9 0.8 0.4", of many "0.4 to 0.9".
std::string listed(const CornerTerms& terms, int digits);
/// What keeps light away from the darkest corner: "… passes through cell 12, of which 0.4 is covered"; empty: nothing.
std::string what_darkens(const CornerTerms& terms);
void add_terms(std::vector<Term>& terms, const CornerTerms& corners);
/// The lines that say how the light of the cell is found.
void add_corner_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits);

/// Of the key 1 − T.
KeyExplanation explain_corners(const CornerTerms& terms, int digits);

}  // namespace sightline
