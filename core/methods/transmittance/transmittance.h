// Cells by transmittance: how much of the light from the eye comes through what was projected before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/methods/cells/cell_run.h"
#include "core/methods/transmittance/corner_words.h"
#include "core/methods/transmittance/known_light.h"
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
    explicit Light(const Problem<D>& problem) { begin(problem); }
    void begin(const Problem<D>& problem) {
        light_ = cell_light(problem);
        eye_ = (problem.view.eye - light_->origin) / light_->unit;
        enqueued_show_ = CellParameters(problem.parameters).outside_view == OutsideView::unseen;
        known_.begin(*problem.cells);
    }

    const CellLight<D>& of_scene() const { return *light_; }
    /// Caches of the view's.
    KnownLight<D>& known() const { return known_; }

    /// What the cell behind `half` of cell `a` gets when `a`, just projected, is the last to give.
    /// transmittance(cell, key): of a projected cell.
    template <typename Transmittance>
    LightTerms into(const Problem<D>& problem, const Marks& marks, CellsInView<D>& in_view, std::uint32_t a,
                    const HalfFacet& half, Transmittance transmittance) const {
        double all = 0, others = 0;
        LightTerms t;
        t.handed_on = transmittance(a, marks[a].key);
        t.opacity = opacity_of(problem, a);
        t.shade = shade(problem, marks, in_view, a, half, transmittance,
                        [&](const HalfFacet& facet, double angle, double given) {
                            all += angle;
                            if (facet.facet() == half.facet())
                                t.share = angle;
                            else
                                others += angle * given;
                        });
        if (all > 0) {
            t.share /= all;
            t.others = others / all;
        } else {  // the eye lies in it, or looks in through cells outside the view alone
            t.share = 1;
        }
        return t;
    }
    /// Of those terms the shade. tell(facet, angle, given): of each facet that counts.
    template <typename Transmittance, typename Tell>
    double shade(const Problem<D>& problem, const Marks& marks, CellsInView<D>& in_view, std::uint32_t a,
                 const HalfFacet& half, Transmittance transmittance, Tell tell) const {
        const CellComplex<D>& cells = *problem.cells;
        const std::uint32_t b = half.neighbour, last = marks[a].stamp;
        double all = 0, missing = 0;  // a sum of what is missing is exact where nothing is
        const auto facets = cells.facets_of(b);
        const double* const angles = known_.angles_of(cells, b, light_->facets.data(), eye_);
        for (std::size_t i = 0; i < facets.size(); ++i) {
            const double angle = angles[i];
            if (angle == 0) continue;
            const std::uint32_t n = facets[i].neighbour;
            double given = 1;
            if (n != none) {
                const Mark mark = marks[n];
                // Of a later step, where this one is asked about afterwards, it was not projected yet.
                const bool gives = mark.state == CellState::projected && mark.stamp <= last;
                if (!gives && !shows_cell(problem, in_view, n, mark)) continue;
                given = gives ? given_by(problem, n, mark.key, transmittance) : 0;
                missing += gives ? angle * (1 - given) : angle;
            }
            all += angle;
            tell(facets[i], angle, given);
        }
        known_.of(cells, b).lit = all > 0;
        return all > 0 ? missing / all : 1 - given_by(problem, a, marks[a].key, transmittance);
    }
    /// Whether what comes into the cell behind facet i of `a` is what it was before `a` was projected: it turns another
    /// side than that facet to the eye. False where that is not known.
    bool keeps(const Problem<D>& problem, std::uint32_t a, std::size_t i, std::uint32_t cell) const {
        return known_.of(*problem.cells, cell).lit &&
               known_.angles_of(*problem.cells, a, light_->facets.data(), eye_)[i] > 0;
    }
    /// What the key of a cell needs is asked for ahead.
    void prefetch(const Problem<D>& problem, std::uint32_t cell) const {
        const std::size_t first = KnownLight<D>::first_facet(*problem.cells, cell),
                          end = first + problem.cells->facets_of(cell).size();
        known_.prefetch(cell, first);
        detail::prefetch(&light_->centres[cell]);
        detail::prefetch(&problem.cells->half_facets[first]);
        constexpr std::size_t a_line = 64 / sizeof(LitFacet<D>);
        for (std::size_t i = first; i < end; i += a_line) detail::prefetch(&light_->facets[i]);
    }

    double opacity_of(const Problem<D>& problem, std::uint32_t cell) const {
        if (problem.cells->count(cell) == 0) return 0;
        std::uint8_t& direction = known_.of(*problem.cells, cell).direction;
        if (direction == KnownLight<D>::unknown)
            direction = static_cast<std::uint8_t>(nearest_direction(problem.view.eye - light_->centres[cell]));
        return light_->opacity.of(cell, direction);
    }

private:
    template <typename Transmittance>
    double given_by(const Problem<D>& problem, std::uint32_t cell, double key, Transmittance transmittance) const {
        const auto& known = known_.of(*problem.cells, cell);
        if (known.given >= 0 && known.key == key) return known.given;
        const double given = transmittance(cell, key) * (1 - opacity_of(problem, cell));
        auto& now = known_.of(*problem.cells, cell);
        now.key = key;
        now.given = given;
        return given;
    }
    /// Of a cell that does not give: whether it meets the view.
    bool shows_cell(const Problem<D>& problem, CellsInView<D>& in_view, std::uint32_t cell, const Mark& mark) const {
        if (mark.state == CellState::unseen) return false;
        // A seed may lie outside; it has the key 0.
        if (enqueued_show_ && mark.state == CellState::enqueued && mark.key != 0) return true;
        std::uint8_t& shows = known_.of(*problem.cells, cell).in_view;
        if (shows == KnownLight<D>::unknown)
            shows = in_view.has(*problem.cells, problem.view, cell, problem.cells->corners_of(cell));
        return shows != 0;
    }

    std::shared_ptr<const CellLight<D>> light_;
    Vec<D> eye_;
    bool enqueued_show_ = true;  ///< what does not meet the view does not come into the front
    mutable KnownLight<D> known_;
};

/// What makes the cell as dark as it is, for people.
std::string weightiest_of(const LightTerms& terms);
KeyExplanation explain_light(const LightTerms& terms, int digits);
/// A line of the key, with the value of the explanation's term of that name.
void add_term_line(std::vector<CodeLine>& lines, std::string text, const KeyExplanation* explained,
                   std::string_view name, int digits);
void add_light_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits);

/// What all that order by light say of themselves (cells/cell_run.h), and the two ways in which it comes.
template <int D>
class LitHeuristic {
public:
    static constexpr double seed_key = 0;
    static constexpr bool stamps_pops = true;
    static constexpr Seeds seeds = Seeds::hull;  ///< light comes in through all that an eye outside looks at

    /// At corners light depends on the view only, and so does a key.
    OnReenqueue on_reenqueue = OnReenqueue::replace;

    const Light<D>& light() const { return light_; }
    void prefetch(const Problem<D>& problem, std::uint32_t cell) const {
        if (corners_)
            corners_->prefetch(*problem.cells, cell);
        else
            light_.prefetch(problem, cell);
    }

protected:
    LitHeuristic(const Problem<D>& problem, LightTransport usual) : light_(problem) { set_transport(problem, usual); }
    void begin(const Problem<D>& problem, LightTransport usual) {
        light_.begin(problem);
        set_transport(problem, usual);
    }

    Light<D> light_;
    std::optional<CornerLight<D>> corners_;  ///< where light comes to corners

private:
    void set_transport(const Problem<D>& problem, LightTransport usual) {
        const bool corners = takes_corners(problem, usual);
        on_reenqueue = corners ? OnReenqueue::never : OnReenqueue::replace;
        if (!corners)
            corners_.reset();
        else if (corners_)
            corners_->begin(problem);
        else
            corners_.emplace(problem);
    }
};

/// `flux`: the key is the shade, 1 − T.
template <int D>
class Flux : public LitHeuristic<D> {
public:
    static constexpr std::string_view key_title = "shade 1 − T";

    explicit Flux(const Problem<D>& problem) : LitHeuristic<D>(problem, LightTransport::facets) {}
    void begin(const Problem<D>& problem) { LitHeuristic<D>::begin(problem, LightTransport::facets); }

    Key key(const Problem<D>& problem, const Marks& marks, CellsInView<D>& in_view, std::uint32_t a,
            const HalfFacet& half) const {
        if (this->corners_) return 1 - this->corners_->of_cell(problem, half.neighbour);
        return this->light_.shade(problem, marks, in_view, a, half, transmittance,
                                  [](const HalfFacet&, double, double) {});
    }
    KeyExplanation explain(const Problem<D>& problem, const Marks& marks, CellsInView<D>& in_view, std::uint32_t a,
                           const HalfFacet& half, int digits) const {
        if (this->corners_) return explain_corners(corner_terms(*this->corners_, problem, half.neighbour), digits);
        return explain_light(this->light_.into(problem, marks, in_view, a, half, transmittance), digits);
    }
    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const {
        lines.push_back({"key(n, c): how much of its light n lacks, 1 − T", 0, false, {}, {}});
        if (this->corners_)
            add_corner_lines(lines, explained, digits);
        else
            add_light_lines(lines, explained, digits);
    }

private:
    static double transmittance(std::uint32_t, double key) { return 1 - key; }
};

}  // namespace sightline
