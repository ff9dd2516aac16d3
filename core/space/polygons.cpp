// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/polygons.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/predicates.h"

namespace sightline {

namespace {

/// The same number for corners at the same place, in the order in which they are first met.
template <int D>
class MergedPoints {
public:
    explicit MergedPoints(const std::vector<Primitive<D>>& primitives) {
        const std::size_t count = primitives.size() * D;
        std::vector<std::uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        const auto at = [&](std::uint32_t corner) -> const Vec<D>& { return primitives[corner / D][corner % D]; };
        const auto less = [&](const Vec<D>& a, const Vec<D>& b) {
            for (int i = 0; i < D; ++i)
                if (a[i] != b[i]) return a[i] < b[i];
            return false;
        };
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            if (less(at(a), at(b))) return true;
            return !less(at(b), at(a)) && a < b;
        });
        std::vector<std::uint32_t> first(count);  // the lowest corner at the same place
        for (std::size_t i = 0; i < count; ++i)
            first[order[i]] = i > 0 && at(order[i]) == at(order[i - 1]) ? first[order[i - 1]] : order[i];
        point_of.resize(count);
        for (std::uint32_t corner = 0; corner < count; ++corner) {
            if (first[corner] == corner) {
                point_of[corner] = static_cast<std::uint32_t>(points.size());
                points.push_back(at(corner));
            } else {
                point_of[corner] = point_of[first[corner]];
            }
        }
    }

    std::vector<Vec<D>> points;
    std::vector<std::uint32_t> point_of;  ///< of corner primitive * D + i
};

/// Joins triangles, the longest shared edges first: the diagonals of what were once rectangles.
class Joiner {
public:
    explicit Joiner(const Scene<3>& scene) : scene_(scene), merged_(scene.primitives) {
        const std::size_t count = scene.primitives.size();
        loops_.resize(count);
        normals_.resize(count);
        joined_to_.resize(count);
        std::iota(joined_to_.begin(), joined_to_.end(), 0u);
        double largest = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Primitive<3>& t = scene.primitives[i];
            for (std::uint32_t c = 0; c < 3; ++c) {
                loops_[i].push_back(merged_.point_of[3 * i + c]);
                for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(t[c][axis]));
            }
            normals_[i] = glm::cross(t[1] - t[0], t[2] - t[0]) / 2.0;
        }
        rounding_ = largest * 0x1p-22;
        join_all();
    }

    Polygons<3> take() {
        Polygons<3> made;
        made.points = std::move(merged_.points);
        const std::size_t count = scene_.primitives.size();
        std::vector<std::vector<std::uint32_t>> members(count);
        for (std::uint32_t i = 0; i < count; ++i) members[find(i)].push_back(i);
        made.polygon_of.resize(count);
        for (std::uint32_t i = 0; i < count; ++i)
            if (!members[find(i)].empty() && members[find(i)].front() == i) add(made, members[find(i)]);
        number_edges(made);
        return made;
    }

private:
    struct SharedEdge {
        std::uint32_t low, high;  ///< points
        std::uint32_t a, b;       ///< triangles: a runs from low to high, b back
        double length2;
    };

    std::uint32_t find(std::uint32_t i) {
        while (joined_to_[i] != i) i = joined_to_[i] = joined_to_[joined_to_[i]];
        return i;
    }

    /// Edges of exactly two triangles that turn the same side.
    std::vector<SharedEdge> shared_edges() const {
        struct Half {
            std::uint32_t low, high, triangle;
            bool reversed;
        };
        std::vector<Half> halves;
        halves.reserve(3 * loops_.size());
        for (std::uint32_t i = 0; i < loops_.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t from = loops_[i][c], to = loops_[i][(c + 1) % 3];
                halves.push_back({std::min(from, to), std::max(from, to), i, from > to});
            }
        std::sort(halves.begin(), halves.end(), [](const Half& x, const Half& y) {
            if (x.low != y.low) return x.low < y.low;
            if (x.high != y.high) return x.high < y.high;
            return x.triangle < y.triangle;
        });
        std::vector<SharedEdge> edges;
        for (std::size_t i = 0, end; i < halves.size(); i = end) {
            end = i + 1;
            while (end < halves.size() && halves[end].low == halves[i].low && halves[end].high == halves[i].high) ++end;
            if (end - i != 2 || halves[i].reversed == halves[i + 1].reversed || halves[i].low == halves[i].high)
                continue;
            const Half &forth = halves[i].reversed ? halves[i + 1] : halves[i],
                       &back = halves[i].reversed ? halves[i] : halves[i + 1];
            const Vec<3> along = merged_.points[forth.high] - merged_.points[forth.low];
            edges.push_back({forth.low, forth.high, forth.triangle, back.triangle, glm::dot(along, along)});
        }
        std::sort(edges.begin(), edges.end(), [](const SharedEdge& x, const SharedEdge& y) {
            if (x.length2 != y.length2) return x.length2 > y.length2;
            return x.low != y.low ? x.low < y.low : x.high < y.high;
        });
        return edges;
    }

    /// Again as long as something is joined: what was not convex with a part may be with the whole.
    void join_all() {
        std::vector<SharedEdge> edges = shared_edges();
        for (bool joined = true; joined;) {
            joined = false;
            std::erase_if(edges, [&](const SharedEdge& edge) {
                const std::uint32_t a = find(edge.a), b = find(edge.b);
                if (a == b || shows_both_sides(scene_, edge.a) != shows_both_sides(scene_, edge.b)) return true;
                if (!in_one_plane(a, edge.b) || !in_one_plane(b, edge.a)) return true;
                const bool is_joined = join(a, b, edge.low, edge.high);
                joined |= is_joined;
                return is_joined;
            });
        }
    }

    /// Whether the corners of a triangle are no farther from the polygon's plane than rounding to floats may have moved
    /// them, nor farther than 2^-10 of its longest edge, which small curved surfaces exceed.
    bool in_one_plane(std::uint32_t polygon, std::uint32_t triangle) const {
        const Vec<3>& normal = normals_[polygon];
        const Primitive<3>& t = scene_.primitives[triangle];
        double longest2 = 0;
        for (std::size_t c = 0; c < 3; ++c)
            longest2 = std::max(longest2, glm::dot(t[(c + 1) % 3] - t[c], t[(c + 1) % 3] - t[c]));
        const double allowed = std::min(rounding_, std::sqrt(longest2) * 0x1p-10);
        const Vec<3>& base = merged_.points[loops_[polygon].front()];
        const double size2 = glm::dot(normal, normal);
        for (const Vec<3>& corner : t) {
            const double away = glm::dot(normal, corner - base);
            if (away * away > allowed * allowed * size2) return false;
        }
        return glm::dot(normal, normals_[triangle]) > 0;
    }

    /// Joins two polygons along all of the border that they share round the edge, if what comes out is convex.
    bool join(std::uint32_t a, std::uint32_t b, std::uint32_t low, std::uint32_t high) {
        const auto& p = loops_[a];
        const auto& q = loops_[b];
        const std::size_t n = p.size(), m = q.size();
        std::size_t i = 0, j = 0;  // p runs from low = p[i] to high = p[i + 1], q back: q[j] = high, q[j + 1] = low
        while (i < n && !(p[i] == low && p[(i + 1) % n] == high)) ++i;
        while (j < m && !(q[j] == high && q[(j + 1) % m] == low)) ++j;
        if (i == n || j == m) return false;
        std::size_t end = i + 1, begin_q = j;  // the shared chain: p[i..end], which is q[begin_q..j + 1] backwards
        std::size_t shared = 1;
        while (shared + 1 < std::min(n, m) && p[(end + 1) % n] == q[(begin_q + m - 1) % m]) {
            ++end;
            begin_q = (begin_q + m - 1) % m;
            ++shared;
        }
        std::size_t begin = i, end_q = j + 1;
        while (shared + 1 < std::min(n, m) && p[(begin + n - 1) % n] == q[(end_q + 1) % m]) {
            begin = (begin + n - 1) % n;
            ++end_q;
            ++shared;
        }
        std::vector<std::uint32_t> loop;
        loop.reserve(n + m - 2 * shared);
        for (std::size_t k = 0; k < n - shared; ++k) loop.push_back(p[(end + k) % n]);    // from the chain's end round
        for (std::size_t k = 0; k < m - shared; ++k) loop.push_back(q[(end_q + k) % m]);  // and from its begin back
        std::vector<std::uint32_t> sorted = loop;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
        const Vec<3> normal = normals_[a] + normals_[b];
        if (!turns_left(loop, 0, normal) || !turns_left(loop, n - shared, normal)) return false;
        loops_[a] = std::move(loop);
        loops_[b].clear();
        normals_[a] = normal;
        joined_to_[b] = a;
        return true;
    }

    /// Whether the loop turns left at a corner, or goes straight on but for the rounding of corners to floats: the
    /// corner lies no deeper than that inside the line of its neighbours.
    bool turns_left(const std::vector<std::uint32_t>& loop, std::size_t at, const Vec<3>& normal) const {
        const std::size_t n = loop.size();
        const Vec<3>&before = merged_.points[loop[(at + n - 1) % n]], &here = merged_.points[loop[at % n]],
              &after = merged_.points[loop[(at + 1) % n]];
        const Vec<3> come = here - before, go = after - here;
        const double turn = glm::dot(glm::cross(come, go), normal);
        const double slack2 = rounding_ * rounding_ * glm::dot(normal, normal);
        if (glm::dot(come, go) < 0)  // a sharp corner; not one that goes back where it came from
            return turn > 0 && turn * turn > slack2 * std::max(glm::dot(come, come), glm::dot(go, go));
        return turn >= 0 || turn * turn <= slack2 * glm::dot(come + go, come + go);
    }

    void add(Polygons<3>& made, const std::vector<std::uint32_t>& members) {
        const std::uint32_t root = find(members.front());
        Vec<3> sum(0);
        for (const std::uint32_t point : loops_[root]) {
            made.sides.push_back({point});
            sum += made.points[point];
        }
        for (const std::uint32_t member : members) {
            made.polygon_of[member] = made.size();
            made.members.push_back(member);
            const auto others = std::span(made.planes).subspan(made.plane_begin.back());
            const Primitive<3>& t = scene_.primitives[member];
            if (std::none_of(others.begin(), others.end(), [&](std::uint32_t other) {
                    const Primitive<3>& o = scene_.primitives[other];
                    return std::all_of(t.begin(), t.end(),
                                       [&](const Vec<3>& corner) { return orient(o[0], o[1], o[2], corner) == 0; });
                }))
                made.planes.push_back(member);
        }
        made.area.push_back(normals_[root]);
        made.centre.push_back(sum / static_cast<double>(loops_[root].size()));
        made.two_sided.push_back(shows_both_sides(scene_, members.front()));
        made.side_begin.push_back(static_cast<std::uint32_t>(made.sides.size()));
        made.member_begin.push_back(static_cast<std::uint32_t>(made.members.size()));
        made.plane_begin.push_back(static_cast<std::uint32_t>(made.planes.size()));
    }

    static void number_edges(Polygons<3>& made) {
        struct Half {
            std::uint32_t low, high, side;
        };
        std::vector<Half> halves;
        halves.reserve(made.sides.size());
        for (std::uint32_t polygon = 0; polygon < made.size(); ++polygon) {
            const std::uint32_t begin = made.side_begin[polygon], end = made.side_begin[polygon + 1];
            for (std::uint32_t side = begin; side < end; ++side) {
                const std::uint32_t from = made.sides[side].point,
                                    to = made.sides[side + 1 < end ? side + 1 : begin].point;
                made.sides[side].reversed = from > to;
                halves.push_back({std::min(from, to), std::max(from, to), side});
            }
        }
        std::sort(halves.begin(), halves.end(), [](const Half& x, const Half& y) {
            if (x.low != y.low) return x.low < y.low;
            return x.high != y.high ? x.high < y.high : x.side < y.side;
        });
        for (std::size_t i = 0; i < halves.size(); ++i) {
            if (i > 0 && (halves[i].low != halves[i - 1].low || halves[i].high != halves[i - 1].high))
                ++made.edge_count;
            made.sides[halves[i].side].edge = made.edge_count;
        }
        made.edge_count += !halves.empty();
    }

    const Scene<3>& scene_;
    MergedPoints<3> merged_;
    std::vector<std::vector<std::uint32_t>> loops_;  ///< of the polygon that a triangle stands for
    std::vector<Vec<3>> normals_;                    ///< as long as the area
    std::vector<std::uint32_t> joined_to_;
    /// How far rounding to floats may have moved a corner off a plane: each coordinate by 2^-25 of the largest one, so
    /// a plane through three of them and a fourth by less than 2^-22.
    double rounding_ = 0;
};

}  // namespace

Polygons<2> build_polygons(const Scene<2>& scene) {
    MergedPoints<2> merged(scene.primitives);
    Polygons<2> made;
    made.points = std::move(merged.points);
    made.edge_count = static_cast<std::uint32_t>(made.points.size());
    for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
        const auto& [a, b] = scene.primitives[i];
        for (std::uint32_t end = 0; end < 2; ++end) {
            const std::uint32_t point = merged.point_of[2 * i + end];
            made.sides.push_back({point, point, false});
        }
        made.side_begin.push_back(static_cast<std::uint32_t>(made.sides.size()));
        made.members.push_back(i);
        made.member_begin.push_back(i + 1);
        made.planes.push_back(i);
        made.plane_begin.push_back(i + 1);
        made.polygon_of.push_back(i);
        made.area.push_back({-(b - a).y, (b - a).x});
        made.centre.push_back((a + b) / 2.0);
        made.two_sided.push_back(1);
    }
    return made;
}

Polygons<3> build_polygons(const Scene<3>& scene) { return Joiner(scene).take(); }

}  // namespace sightline
