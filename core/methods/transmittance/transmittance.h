// Cells by transmittance: how much of the light from the eye comes through what was projected before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_run.h"
#include "core/methods/transmittance/light.h"
#include "core/methods/transmittance/seen_cells.h"
#include "core/methods/transmittance/transmittance_parameters.h"

namespace sightline {

/// What comes into a cell, as shares of what would if nothing were in the way.
struct LightTerms {
    double share = 0;      ///< the angle of the facet to the cell just projected, of that of all that turn to the eye
    double handed_on = 0;  ///< the transmittance of that cell
    double opacity = 0;    ///< of that cell, as the eye sees it
    double others = 0;     ///< what comes through the other facets
    double shade = 0;      ///< 1 - share * handed_on * (1 - opacity) - others; exactly 0 where nothing is missing

    double transmittance() const { return 1 - shade; }
};

/// Light as marks know it: a projected cell is as bright as the key says that it was projected with.
/// What comes into cell B is Σ w T (1 − α) / Σ w, over the facets of B that turn to the eye: w is the angle that the
/// facet fills, T the transmittance of the cell behind it, 0 where that is not projected yet, α how much of that cell
/// is covered. Facets at the border of the tessellation are lit; those to cells outside the view do not count. It is
/// the star-shape test made continuous: of a cell half of whose light has not arrived, half is trusted.
template <int D>
class Light {
public:
    explicit Light(const Problem<D>& problem)
        : light_(cell_light(problem)),
          eye_((problem.view.eye - light_->origin) / light_->unit),
          in_view_(problem.cells->cell_count()),
          directions_(problem.cells->cell_count(), unknown) {}

    const CellLight<D>& of_scene() const { return *light_; }

    /// What the cell behind `half` of cell `a` gets when `a`, just projected, is the last to give.
    /// transmittance(cell, key): of a projected cell.
    template <typename Transmittance>
    LightTerms into(const Problem<D>& problem, const Marks& marks, std::uint32_t a, const HalfFacet& half,
                    Transmittance transmittance) const {
        const CellComplex<D>& cells = *problem.cells;
        const std::uint32_t b = half.neighbour, last = marks[a].stamp;
        double all = 0, others = 0, missing = 0;  // sums of what is missing are exact where nothing is
        LightTerms t;
        t.handed_on = transmittance(a, marks[a].key);
        t.opacity = opacity_of(problem, a);
        const auto facets = cells.facets_of(b);
        const LitFacet<D>* const lit =
            &light_->facets[static_cast<std::size_t>(facets.data() - cells.half_facets.data())];
        for (std::size_t i = 0; i < facets.size(); ++i) {
            const double angle = angle_of(lit[i], eye_);
            if (angle == 0) continue;
            const std::uint32_t n = facets[i].neighbour;
            if (n == none) {
                all += angle;
                others += angle;
                continue;
            }
            const Mark mark = marks[n];
            // Of a later step, where this one is asked about afterwards, it was not projected yet.
            const bool gives = mark.state == CellState::projected && mark.stamp <= last;
            if (!gives && !in_view_.holds(problem, n)) continue;
            all += angle;
            if (!gives) {
                missing += angle;
                continue;
            }
            const double given =
                n == a ? t.handed_on * (1 - t.opacity) : transmittance(n, mark.key) * (1 - opacity_of(problem, n));
            missing += angle * (1 - given);
            if (facets[i].facet() == half.facet())
                t.share = angle;
            else
                others += angle * given;
        }
        if (all > 0) {
            t.share /= all;
            t.others = others / all;
            t.shade = missing / all;
        } else {  // the eye lies in it, or looks in through cells outside the view alone
            t.share = 1;
            t.shade = 1 - t.handed_on * (1 - t.opacity);
        }
        return t;
    }

    double opacity_of(const Problem<D>& problem, std::uint32_t cell) const {
        if (problem.cells->count(cell) == 0) return 0;
        std::uint8_t& direction = directions_[cell];
        if (direction == unknown)
            direction = static_cast<std::uint8_t>(nearest_direction<D>(problem.view.eye - problem.cells->centre(cell)));
        return light_->opacity.of(cell, direction);
    }

private:
    std::shared_ptr<const CellLight<D>> light_;
    Vec<D> eye_;
    SeenCells<D> in_view_;
    static constexpr std::uint8_t unknown = 255;
    mutable std::vector<std::uint8_t> directions_;  ///< a cache: that of each cell in which the eye lies
};

/// What makes the cell as dark as it is, for people.
std::string weightiest_of(const LightTerms& terms);
KeyExplanation explain_light(const LightTerms& terms, int digits);
/// A line of the key, with the value of the explanation's term of that name.
void add_term_line(std::vector<CodeLine>& lines, std::string text, const KeyExplanation* explained,
                   std::string_view name, int digits);
void add_light_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits);

/// What all that order by light say of themselves (cells/cell_run.h).
struct LitHeuristic {
    static constexpr double seed_key = 0;
    static constexpr OnReenqueue on_reenqueue = OnReenqueue::replace;
    static constexpr bool stamps_pops = true;
    static constexpr Seeds seeds = Seeds::hull;  ///< light comes in through all that an eye outside looks at
};

/// `flux`: the key is the shade, 1 − T.
template <int D>
class Flux : public LitHeuristic {
public:
    static constexpr std::string_view key_title = "shade 1 − T";

    explicit Flux(const Problem<D>& problem) : light_(problem) {}

    LightTerms terms(const Problem<D>& problem, const Marks& marks, std::uint32_t a, const HalfFacet& half) const {
        return light_.into(problem, marks, a, half, [](std::uint32_t, double key) { return 1 - key; });
    }
    Key key(const Problem<D>& problem, const Marks& marks, std::uint32_t a, double, const HalfFacet& half) const {
        return terms(problem, marks, a, half).shade;
    }
    KeyExplanation explain(const Problem<D>& problem, const Marks& marks, std::uint32_t a, double,
                           const HalfFacet& half, int digits) const {
        return explain_light(terms(problem, marks, a, half), digits);
    }
    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const {
        add_light_lines(lines, explained, digits);
    }

private:
    Light<D> light_;
};

}  // namespace sightline
