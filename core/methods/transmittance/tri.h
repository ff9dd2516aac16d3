// Primitives by transmittance and apparent size; cells are projected as far as that order needs them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/transmittance/transmittance.h"
#include "core/methods/transmittance/waiting.h"

namespace sightline {

/// What no light reaches comes last, but by size.
inline constexpr float least_light = 0x1p-20f;

/// `tri`: the key of a cell is 1 / (T sqrt(u / r)), with maximise=pixels 1 / (T u / r): r is the distance of its centre
/// and u the usual size of a primitive, so that u / r is what a primitive of that size would look like there.
/// Primitives of projected cells wait with keys of the same form, from what they do look like and from the light of the
/// cell, or at their centroids where corners have it, and are rendered when no cell that waits comes before them. So a
/// small one waits until the front has passed where larger ones might be.
template <int D>
class Tri : public LitHeuristic<D> {
public:
    static constexpr std::string_view key_title = "key by light and size";
    /// What finds more in the scenes of docs/methods.md: in the plane cells are few, and gaps sharp.
    static constexpr LightTransport usual_transport = D == 3 ? LightTransport::corners : LightTransport::facets;

    explicit Tri(const Problem<D>& problem) : LitHeuristic<D>(problem, usual_transport) { set(problem); }
    void begin(const Problem<D>& problem) {
        LitHeuristic<D>::begin(problem, usual_transport);
        set(problem);
    }

    Key key(const Problem<D>& problem, const Marks& marks, CellsInView<D>& in_view, std::uint32_t a,
            const HalfFacet& half) const {
        if (corners_) return key_at(problem, half.neighbour, corners_->of_cell(problem, half.neighbour));
        const double shade = light_.shade(
            problem, marks, in_view, a, half, [&](std::uint32_t n, double k) { return transmittance(problem, n, k); },
            [](const HalfFacet&, double, double) {});
        return key_at(problem, half.neighbour, 1 - shade);
    }
    KeyExplanation explain(const Problem<D>& problem, const Marks& marks, CellsInView<D>& in_view, std::uint32_t a,
                           const HalfFacet& half, int digits) const;
    void add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* explained, int digits) const;

    /// Of a cell with that key.
    double transmittance(const Problem<D>& problem, std::uint32_t cell, double key) const {
        return key == 0 ? 1 : std::min(1.0, distance_ratio(problem, cell) / key);
    }

    // What waits to be rendered. A cell that is projected adds what it holds.

    mutable Waiting waiting;

    void add_waiting(const Problem<D>& problem, const CellContents<D>& contents, std::uint32_t cell, double key) const;

private:
    using LitHeuristic<D>::light_;
    using LitHeuristic<D>::corners_;

    void set(const Problem<D>& problem) {
        maximise_ = problem.parameters.template choice<Maximise>(maximise_row());
        usual_size_ = light_.of_scene().usual_size;
        waiting.clear();
    }

    double of_ratio(double ratio) const { return maximise_ == Maximise::count ? std::sqrt(ratio) : ratio; }
    double distance_in_sizes(const Problem<D>& problem, std::uint32_t cell) const {
        const Vec<D> away = light_.of_scene().centres[cell] - problem.view.eye;
        return std::sqrt(glm::dot(away, away)) / usual_size_;
    }
    double distance_ratio(const Problem<D>& problem, std::uint32_t cell) const {
        double& known = light_.known().of(*problem.cells, cell).ratio;
        if (known < 0) known = of_ratio(distance_in_sizes(problem, cell));
        return known;
    }
    double key_at(const Problem<D>& problem, std::uint32_t cell, double transmittance) const {
        // At corners a key is asked for once.
        const double ratio = corners_ ? of_ratio(distance_in_sizes(problem, cell)) : distance_ratio(problem, cell);
        return ratio / std::max(transmittance, double{least_light});
    }

    Maximise maximise_;
    double usual_size_;
};

extern template class Tri<2>;
extern template class Tri<3>;

/// `tri-seen`: starts from the cells that showed something in the frame before, too.
template <int D>
class TriSeen : public Tri<D> {
public:
    using Tri<D>::Tri;
    static constexpr bool from_seen = true;
};

}  // namespace sightline
