// The traversal as the papers describe it, written a second time and on purpose in their way: cells linked by pointers,
// a std::set as the front, erase and insert on every update (TVCG section 4.2). Tests compare its order with that of
// the program; benchmarks its speed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "core/run/run.h"

namespace sightline::test {

struct PaperPrimitive {
    Primitive<2> ends;
    std::uint32_t id;
    bool rendered = false;
};

struct PaperCell {
    struct Link {
        PaperCell* neighbour;
        Vec<2> from, to;  // this cell lies on the left
    };
    std::uint32_t id = 0;
    std::vector<Vec<2>> corners;
    Vec<2> centre{};
    std::vector<Link> neighbours;
    std::vector<PaperPrimitive*> geometry;
    double solidity = 0;
    std::uint64_t time_stamp = 0;
    CellState state = CellState::clean;
};

struct CompareSolidity {
    bool operator()(const PaperCell* a, const PaperCell* b) const {
        if (a->solidity != b->solidity) return a->solidity < b->solidity;
        return a->time_stamp < b->time_stamp;
    }
};

class PaperTraversal {
public:
    PaperTraversal(const Scene<2>& scene, const CellComplex<2>& complex) {
        for (std::uint32_t i = 0; i < scene.primitives.size(); ++i)
            primitives_.push_back(std::make_unique<PaperPrimitive>(PaperPrimitive{scene.primitives[i], i}));
        for (std::uint32_t i = 0; i < complex.cell_count(); ++i) cells_.push_back(std::make_unique<PaperCell>());
        for (std::uint32_t i = 0; i < complex.cell_count(); ++i) {
            PaperCell& cell = *cells_[i];
            cell.id = i;
            cell.centre = complex.centre(i);
            for (const std::uint32_t p : complex.corners_of(i)) cell.corners.push_back(complex.points[p]);
            for (const HalfFacet& half : complex.facets_of(i)) {
                const auto [from, to] = facet_ends(complex, half);
                cell.neighbours.push_back({half.neighbour == none ? nullptr : cells_[half.neighbour].get(), from, to});
            }
            for (const std::uint32_t p : complex.primitives_of(i)) cell.geometry.push_back(primitives_[p].get());
            rho_max_ = std::max(rho_max_, cell.geometry.size());
        }
    }

    /// fig. 4 with the default settings; `projected` gets the ids of the cells in order.
    void run(const View<2>& view, std::uint32_t seed, std::size_t budget, std::vector<std::uint32_t>& projected,
             std::vector<std::uint32_t>& rendered) {
        for (auto& cell : cells_) {
            cell->state = CellState::clean;
            cell->solidity = 0;
        }
        for (auto& p : primitives_) p->rendered = false;
        front_.clear();
        stamp_ = 0;
        enqueue(cells_[seed].get(), 0);
        while (!front_.empty() && rendered.size() < budget) {
            PaperCell* c = *front_.begin();
            front_.erase(front_.begin());
            c->state = CellState::projected;
            projected.push_back(c->id);
            for (PaperPrimitive* p : c->geometry) {
                if (p->rendered || !in_view(view, p->ends)) continue;
                if (rendered.size() >= budget) break;
                p->rendered = true;
                rendered.push_back(p->id);
            }
            for (const PaperCell::Link& link : c->neighbours) {
                PaperCell* n = link.neighbour;
                if (!n || n->state == CellState::projected || n->state == CellState::unseen) continue;
                if (n->state == CellState::clean && !in_view(view, std::span<const Vec<2>>(n->corners))) {
                    n->state = CellState::unseen;
                    continue;
                }
                enqueue(n, update_solidity(*c, *n, link, view.eye));
            }
        }
    }

private:
    /// fig. 5: eye -> facet, clamped, doubled when not star-shaped.
    double update_solidity(const PaperCell& a, const PaperCell& b, const PaperCell::Link& link,
                           const Vec<2>& eye) const {
        const Vec<2> v = (link.from + link.to) * 0.5 - eye;
        const Vec<2> n(link.to.y - link.from.y, link.from.x - link.to.x);
        const double length = std::sqrt(glm::dot(v, v) * glm::dot(n, n));
        const double cosine = length > 0 ? glm::dot(v, n) / length : 0;
        double rho = static_cast<double>(a.geometry.size()) / static_cast<double>(std::max<std::size_t>(1, rho_max_)) +
                     (cosine > 0 ? cosine : 0) * a.solidity;
        const bool star = orient(link.from, link.to, eye) >= 0 && orient(eye, link.from, b.centre) >= 0 &&
                          orient(eye, b.centre, link.to) >= 0;
        if (!star) rho = 2 * rho;
        return rho;
    }

    void enqueue(PaperCell* cell, double solidity) {
        if (cell->state == CellState::enqueued) front_.erase(cell);
        cell->solidity = solidity;
        cell->time_stamp = stamp_++;
        cell->state = CellState::enqueued;
        front_.insert(cell);
    }

    std::vector<std::unique_ptr<PaperPrimitive>> primitives_;
    std::vector<std::unique_ptr<PaperCell>> cells_;
    std::size_t rho_max_ = 0;
    std::set<PaperCell*, CompareSolidity> front_;
    std::uint64_t stamp_ = 0;
};

}  // namespace sightline::test
