// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/plan_mesh.h"

#include <algorithm>
#include <deque>

#include "core/geometry/predicates.h"

namespace sightline {

namespace {

bool comes_first(const Vec<2>& a, const Vec<2>& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// On the open segment ab, if on its line.
bool is_between(const Vec<2>& a, const Vec<2>& p, const Vec<2>& b) {
    return comes_first(a, b) ? comes_first(a, p) && comes_first(p, b) : comes_first(b, p) && comes_first(p, a);
}

class PlanMesher {
public:
    explicit PlanMesher(std::span<const PlanLine> lines) {
        for (const PlanLine& line : lines) points().insert(points().end(), line.ends.begin(), line.ends.end());
        std::sort(points().begin(), points().end(), comes_first);
        points().erase(std::unique(points().begin(), points().end()), points().end());
        sweep();
        if (mesh_.from.empty()) return;
        shorten();
        for (const PlanLine& line : lines) insert(index_of(line.ends[0]), index_of(line.ends[1]), line.bit);
        shorten();
    }

    PlanMesh take() { return std::move(mesh_); }

private:
    std::vector<Vec<2>>& points() { return mesh_.points; }
    const Vec<2>& at(std::uint32_t point) const { return mesh_.points[point]; }
    int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const { return orient(at(a), at(b), at(c)); }
    std::uint32_t index_of(const Vec<2>& p) const {
        return static_cast<std::uint32_t>(std::lower_bound(mesh_.points.begin(), mesh_.points.end(), p, comes_first) -
                                          mesh_.points.begin());
    }

    std::uint32_t add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto first = static_cast<std::uint32_t>(mesh_.from.size());
        mesh_.from.insert(mesh_.from.end(), {a, b, c});
        mesh_.twin.insert(mesh_.twin.end(), 3, none);
        mesh_.kept.insert(mesh_.kept.end(), 3, 0);
        leaving_[a] = first, leaving_[b] = first + 1, leaving_[c] = first + 2;
        return first;
    }
    void join(std::uint32_t half, std::uint32_t other) {
        if (half != none) mesh_.twin[half] = other;
        if (other != none) mesh_.twin[other] = half;
    }

    /// Points from left to right, each joined with what it sees of the hull so far.
    void sweep() {
        const auto count = static_cast<std::uint32_t>(points().size());
        leaving_.assign(count, none);
        std::uint32_t first = 2;  // not in line with those before
        while (first < count && turn(0, 1, first) == 0) ++first;
        if (first >= count) return;
        // The hull, counter-clockwise: per point the next one and the half-edge to it, whose twin is outside.
        hull_next_.assign(count, none), hull_before_.assign(count, none), hull_half_.assign(count, none);
        const bool left = turn(0, 1, first) > 0;
        std::uint32_t before = none;
        for (std::uint32_t i = 0; i + 1 < first; ++i) {
            const std::uint32_t half = left ? add(i, i + 1, first) : add(i + 1, i, first);
            const std::uint32_t low = left ? half + 2 : half + 1, high = left ? half + 1 : half + 2;
            join(before, low);
            before = high;
            set_hull(left ? i : i + 1, left ? i + 1 : i, half);
            if (i == 0) set_hull(left ? first : 0, left ? 0 : first, low);
            if (i + 2 == first) set_hull(left ? first - 1 : first, left ? first : first - 1, high);
        }
        for (std::uint32_t p = first + 1; p < count; ++p) add_to_hull(p, p - 1);
    }
    void set_hull(std::uint32_t a, std::uint32_t b, std::uint32_t half) {
        hull_next_[a] = b, hull_before_[b] = a, hull_half_[a] = half;
    }
    /// `last` lies on the hull and is seen from p.
    void add_to_hull(std::uint32_t p, std::uint32_t last) {
        std::uint32_t low = last, high = last, joined = none;  // joined: the half-edge from p to high
        std::uint32_t first_half = none;                       // from low to p
        while (turn(high, hull_next_[high], p) < 0) {
            const std::uint32_t next = hull_next_[high], half = add(next, high, p);
            join(half, hull_half_[high]);
            join(half + 1, joined);
            if (joined == none) first_half = half + 1;
            joined = half + 2;
            high = next;
        }
        while (turn(hull_before_[low], low, p) < 0) {
            const std::uint32_t before = hull_before_[low], half = add(low, before, p);
            join(half, hull_half_[before]);
            join(half + 2, first_half);
            if (first_half == none) joined = half + 2;
            first_half = half + 1;
            low = before;
        }
        set_hull(low, p, first_half);
        set_hull(p, high, joined);
    }

    /// The edge of two triangles becomes the other diagonal of their quadrilateral; `half` and its twin stay what they
    /// are called.
    void flip(std::uint32_t half) {
        const std::uint32_t other = mesh_.twin[half];
        const std::uint32_t a1 = PlanMesh::next(half), a2 = PlanMesh::next(a1);
        const std::uint32_t b1 = PlanMesh::next(other), b2 = PlanMesh::next(b1);
        const std::uint32_t a = mesh_.from[half], b = mesh_.from[other], c = mesh_.from[a2], d = mesh_.from[b2];
        const std::array<std::uint32_t, 4> twins{mesh_.twin[a1], mesh_.twin[a2], mesh_.twin[b1], mesh_.twin[b2]};
        const std::array<std::uint8_t, 4> kept{mesh_.kept[a1], mesh_.kept[a2], mesh_.kept[b1], mesh_.kept[b2]};
        // Triangles d, c, a and c, d, b.
        mesh_.from[half] = d, mesh_.from[a1] = c, mesh_.from[a2] = a;
        mesh_.from[other] = c, mesh_.from[b1] = d, mesh_.from[b2] = b;
        join(a1, twins[1]), join(a2, twins[2]), join(b1, twins[3]), join(b2, twins[0]);
        mesh_.kept[a1] = kept[1], mesh_.kept[a2] = kept[2], mesh_.kept[b1] = kept[3], mesh_.kept[b2] = kept[0];
        leaving_[a] = a2, leaving_[b] = b2, leaving_[c] = a1, leaving_[d] = b1;
    }
    /// Whether both triangles make a strictly convex quadrilateral.
    bool is_convex(std::uint32_t half) const {
        const std::uint32_t other = mesh_.twin[half], a = mesh_.from[half], b = mesh_.from[other];
        const std::uint32_t c = mesh_.to(PlanMesh::next(half)), d = mesh_.to(PlanMesh::next(other));
        return turn(d, b, c) > 0 && turn(c, a, d) > 0;
    }

    double squared_length(std::uint32_t a, std::uint32_t b) const {
        const Vec<2> way = at(std::max(a, b)) - at(std::min(a, b));
        return glm::dot(way, way);
    }
    /// Flips to shorter diagonals while there are any: fewer needles. The lengths' sum falls, so it ends.
    void shorten() {
        std::vector<std::uint32_t> waiting;
        for (std::uint32_t half = 0; half < mesh_.from.size(); ++half) waiting.push_back(half);
        while (!waiting.empty()) {
            const std::uint32_t half = waiting.back(), other = mesh_.twin[half];
            waiting.pop_back();
            if (other == none || mesh_.kept[half] || !is_convex(half)) continue;
            const std::uint32_t c = mesh_.to(PlanMesh::next(half)), d = mesh_.to(PlanMesh::next(other));
            if (!(squared_length(c, d) < squared_length(mesh_.from[half], mesh_.from[other]))) continue;
            flip(half);
            for (const std::uint32_t side : {half, other})
                waiting.insert(waiting.end(), {PlanMesh::next(side), PlanMesh::next(PlanMesh::next(side))});
        }
    }

    void keep(std::uint32_t half, std::uint8_t bit) {
        mesh_.kept[half] |= bit;
        if (mesh_.twin[half] != none) mesh_.kept[mesh_.twin[half]] |= bit;
    }

    /// Where a line leaves point a toward b: along an edge, or through the edge opposite a.
    struct Exit {
        std::uint32_t along = none, across = none;
    };
    Exit exit_of(std::uint32_t a, std::uint32_t b) const {
        const auto look = [&](std::uint32_t half, Exit& exit) {  // a half-edge that leaves a
            const std::uint32_t p = mesh_.to(half), opposite = PlanMesh::next(half), q = mesh_.to(opposite);
            const int right = turn(a, b, p), left = turn(a, b, q);
            if (p == b || (right == 0 && is_between(at(a), at(p), at(b))))
                exit.along = half;
            else if (q == b || (left == 0 && is_between(at(a), at(q), at(b))))
                exit.along = PlanMesh::next(opposite);
            else if (right < 0 && left > 0)
                exit.across = opposite;
            else
                return false;
            return true;
        };
        Exit exit;
        std::uint32_t half = leaving_[a];
        do {  // counter-clockwise about a
            if (look(half, exit)) return exit;
            half = mesh_.twin[PlanMesh::next(PlanMesh::next(half))];
        } while (half != none && half != leaving_[a]);
        if (half == none)
            for (half = mesh_.twin[leaving_[a]]; half != none; half = mesh_.twin[half]) {  // and the other way
                half = PlanMesh::next(half);
                if (look(half, exit)) return exit;
            }
        return exit;
    }

    /// Makes the line edges, flipping those that it crosses (Sloan 1993).
    void insert(std::uint32_t a, std::uint32_t b, std::uint8_t bit) {
        while (a != b) {
            const Exit exit = exit_of(a, b);
            if (exit.along != none) {
                keep(exit.along, bit);
                a = mesh_.from[exit.along] == a ? mesh_.to(exit.along) : mesh_.from[exit.along];
                continue;
            }
            if (exit.across == none) return;                   // cannot be
            std::deque<std::array<std::uint32_t, 2>> crossed;  // by their ends: a flip moves half-edges
            bool is_free = true;
            std::uint32_t half = exit.across, end = none;
            while (end == none) {  // through triangle after triangle to b, or to a point on the way
                crossed.push_back({mesh_.from[half], mesh_.to(half)});
                is_free &= !mesh_.kept[half];
                const std::uint32_t other = mesh_.twin[half], tip = mesh_.to(PlanMesh::next(other));
                const int side = turn(a, b, tip);
                if (side == 0) end = tip;
                half = side > 0 ? PlanMesh::next(other) : PlanMesh::next(PlanMesh::next(other));
            }
            if (is_free) {
                while (!crossed.empty()) {
                    const auto [from, to] = crossed.front();
                    const std::uint32_t at_hand = exit_of(from, to).along;
                    crossed.pop_front();
                    if (is_convex(at_hand)) {
                        flip(at_hand);
                        const std::uint32_t c = mesh_.from[at_hand], d = mesh_.to(at_hand);
                        if (turn(a, end, c) * turn(a, end, d) < 0) crossed.push_back({c, d});
                    } else {
                        crossed.push_back({from, to});
                    }
                }
                const Exit edge = exit_of(a, end);
                if (edge.along != none) keep(edge.along, bit);
            } else {
                ++mesh_.left_out;
            }
            a = end;
        }
    }

    PlanMesh mesh_;
    std::vector<std::uint32_t> leaving_;  ///< per point: a half-edge that leaves it
    std::vector<std::uint32_t> hull_next_, hull_before_, hull_half_;
};

}  // namespace

PlanMesh triangulate_plan(std::span<const PlanLine> lines) { return PlanMesher(lines).take(); }

}  // namespace sightline
