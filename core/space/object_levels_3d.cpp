// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/index.h"
#include "core/space/object_levels.h"

namespace sightline {

namespace {

/// So many grids are tried from one level to one with half of its triangles, each √2 as wide as the one before.
constexpr double wider = 1.4142135623730951;
/// Cells of a grid along a side of its object: numbers of cells along three axes fit one word.
constexpr double most_cells = 1 << 20;

/// A triangle of the object: its number there, and what becomes of it.
struct Kept {
    std::array<std::uint32_t, 3> groups;  ///< of its corners, the least first; turning as the triangle does
    std::uint32_t triangle;
    bool both_sides;
    bool is_twin_of(const Kept& other) const { return groups == other.groups && both_sides == other.both_sides; }
};
/// A triangle that has collapsed to the line between two groups, or to one of them.
struct Collapsed {
    std::uint32_t from, to;  ///< from <= to
    double area2;            ///< of the triangle, squared and times four
    std::uint32_t triangle;
};
using Edge = std::pair<std::uint32_t, std::uint32_t>;

double squared(const Vec<3>& v) { return glm::dot(v, v); }
Vec<3> normal_of(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) { return glm::cross(b - a, c - a); }

/// The corners of one object, and what a grid makes of them. The arrays are used again from grid to grid.
class Clusters {
public:
    Clusters(const Scene<3>& scene, std::span<const std::uint32_t> object) : scene_(scene), object_(object) {
        for (const std::uint32_t id : object)
            for (const Vec<3>& corner : scene.primitives[id]) box_.add(corner);
        std::size_t size = 16;
        while (size < object.size() * 6) size *= 2;
        keys_.resize(size);
        slots_.resize(size);
        group_of_.resize(object.size() * 3);
    }

    const Box<3>& box() const { return box_; }
    double mean_side() const {
        double sum = 0;
        for (const std::uint32_t id : object_) {
            const Primitive<3>& t = scene_.primitives[id];
            for (std::size_t i = 0; i < 3; ++i) sum += std::sqrt(squared(t[(i + 1) % 3] - t[i]));
        }
        return sum / static_cast<double>(3 * object_.size());
    }

    /// How many triangles a grid of that width leaves.
    std::size_t simplify(double width) {
        group(width);
        sort_triangles();
        keep_what_is_alone();
        return kept_.size() + alone_.size();
    }

    /// What simplify() left, in the order of the object's triangles.
    void append(ObjectLevels<3>& out) {
        std::sort(kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) { return a.triangle < b.triangle; });
        std::sort(alone_.begin(), alone_.end());
        const auto begin = static_cast<std::uint32_t>(out.primitives.size());
        std::size_t next = 0;
        const auto add_alone = [&](std::uint32_t before) {
            for (; next < alone_.size() && alone_[next] < before; ++next) {
                out.primitives.push_back(triangle(alone_[next]));
                out.two_sided.push_back(both_sides(alone_[next]));
            }
        };
        for (const Kept& kept : kept_) {
            add_alone(kept.triangle);
            out.primitives.push_back({at(kept.groups[0]), at(kept.groups[1]), at(kept.groups[2])});
            out.two_sided.push_back(kept.both_sides);
        }
        add_alone(none);
        // What has collapsed lies within `moved_` of where it went, and so does the one that is drawn for it.
        out.levels.push_back(
            {begin, static_cast<std::uint32_t>(out.primitives.size()), std::sqrt(moved2_) * (alone_.empty() ? 1 : 2)});
    }

private:
    struct Group {
        Vec<3> sum{};
        double count = 0;
        std::uint32_t nearest = none;  ///< the corner that all of them fall to
        double away2 = 0;
    };

    const Primitive<3>& triangle(std::uint32_t t) const { return scene_.primitives[object_[t]]; }
    bool both_sides(std::uint32_t t) const { return shows_both_sides(scene_, object_[t]); }
    const Vec<3>& corner(std::uint32_t k) const { return triangle(k / 3)[k % 3]; }
    const Vec<3>& at(std::uint32_t group) const { return corner(groups_[group].nearest); }

    void group(double width) {
        std::fill(slots_.begin(), slots_.end(), none);
        groups_.clear();
        const auto corners = static_cast<std::uint32_t>(group_of_.size());
        for (std::uint32_t k = 0; k < corners; ++k) {
            const Vec<3> cell = (corner(k) - box_.min) / width;
            const std::uint64_t key = static_cast<std::uint64_t>(cell.x) << 42 |
                                      static_cast<std::uint64_t>(cell.y) << 21 | static_cast<std::uint64_t>(cell.z);
            Group& group = groups_[group_of_[k] = group_with(key)];
            group.sum += corner(k) - box_.min;
            ++group.count;
        }
        for (std::uint32_t k = 0; k < corners; ++k) {
            Group& group = groups_[group_of_[k]];
            const double away2 = squared(corner(k) - box_.min - group.sum / group.count);
            if (group.nearest != none && !(away2 < group.away2)) continue;
            group.nearest = k;
            group.away2 = away2;
        }
        moved2_ = 0;
        for (std::uint32_t k = 0; k < corners; ++k) moved2_ = std::max(moved2_, squared(corner(k) - at(group_of_[k])));
    }

    std::uint32_t group_with(std::uint64_t key) {
        const std::size_t mask = slots_.size() - 1;
        std::uint64_t mixed = key * 0x9e3779b97f4a7c15u;
        std::size_t i = (mixed ^ mixed >> 32) & mask;
        while (slots_[i] != none && keys_[i] != key) i = (i + 1) & mask;
        if (slots_[i] == none) {
            keys_[i] = key;
            slots_[i] = static_cast<std::uint32_t>(groups_.size());
            groups_.emplace_back();
        }
        return slots_[i];
    }

    /// Into those that stay triangles, each once, and those that do not.
    void sort_triangles() {
        kept_.clear();
        collapsed_.clear();
        const auto count = static_cast<std::uint32_t>(object_.size());
        for (std::uint32_t t = 0; t < count; ++t) {
            std::array<std::uint32_t, 3> g{group_of_[3 * t], group_of_[3 * t + 1], group_of_[3 * t + 2]};
            const Primitive<3>& whole = triangle(t);
            const Vec<3> normal = normal_of(whole[0], whole[1], whole[2]);
            if (g[0] != g[1] && g[1] != g[2] && g[2] != g[0]) {
                const Vec<3> now = normal_of(at(g[0]), at(g[1]), at(g[2]));
                if (squared(now) > 0) {
                    std::rotate(g.begin(), std::min_element(g.begin(), g.end()), g.end());
                    const bool both = both_sides(t) || !(glm::dot(normal, now) > 0);
                    if (both && g[1] > g[2]) std::swap(g[1], g[2]);
                    kept_.push_back({g, t, both});
                    continue;
                }
            }
            // The longest of its sides holds all of it.
            std::size_t longest = 0;
            double most = -1;
            for (std::size_t i = 0; i < 3; ++i)
                if (const double side = squared(at(g[(i + 1) % 3]) - at(g[i])); side > most) most = side, longest = i;
            const std::uint32_t a = g[longest], b = g[(longest + 1) % 3];
            collapsed_.push_back({std::min(a, b), std::max(a, b), squared(normal), t});
        }
        std::sort(kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) {
            return std::tie(a.groups, a.both_sides, a.triangle) < std::tie(b.groups, b.both_sides, b.triangle);
        });
        kept_.erase(
            std::unique(kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) { return a.is_twin_of(b); }),
            kept_.end());
    }

    /// Of those that collapsed to a line or a point that no triangle draws, the largest each.
    void keep_what_is_alone() {
        alone_.clear();
        if (collapsed_.empty()) return;
        edges_.clear();
        for (const Kept& kept : kept_)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = kept.groups[i], b = kept.groups[(i + 1) % 3];
                edges_.push_back({std::min(a, b), std::max(a, b)});
                edges_.push_back({a, a});
            }
        std::sort(edges_.begin(), edges_.end());
        std::sort(collapsed_.begin(), collapsed_.end(), [](const Collapsed& a, const Collapsed& b) {
            return std::tie(a.from, a.to, b.area2, a.triangle) < std::tie(b.from, b.to, a.area2, b.triangle);
        });
        // Lines before points, which they draw too.
        for (const bool points : {false, true}) {
            Edge last{none, none};
            const std::size_t lines = edges_.size();
            for (const Collapsed& c : collapsed_) {
                const Edge edge{c.from, c.to};
                if ((c.from == c.to) != points || edge == last) continue;
                last = edge;
                if (std::binary_search(edges_.begin(), edges_.begin() + static_cast<std::ptrdiff_t>(lines), edge))
                    continue;
                alone_.push_back(c.triangle);
                if (!points) edges_.insert(edges_.end(), {{c.from, c.from}, {c.to, c.to}});
            }
            std::sort(edges_.begin(), edges_.end());
        }
    }

    const Scene<3>& scene_;
    std::span<const std::uint32_t> object_;
    Box<3> box_;
    std::vector<std::uint64_t> keys_;
    std::vector<std::uint32_t> slots_;     ///< the group of the key; none: free
    std::vector<std::uint32_t> group_of_;  ///< per corner
    std::vector<Group> groups_;
    double moved2_ = 0;  ///< the farthest that a corner has moved, squared
    std::vector<Kept> kept_;
    std::vector<Collapsed> collapsed_;
    std::vector<Edge> edges_;           ///< that are drawn; from == to: a point
    std::vector<std::uint32_t> alone_;  ///< triangles that stay as they were
};

}  // namespace

void append_levels(const Scene<3>& scene, std::span<const std::uint32_t> object, ObjectLevels<3>& out) {
    Clusters clusters(scene, object);
    const double side = clusters.box().longest_side();
    if (!(side > 0) || !std::isfinite(side)) return;
    double error = 0;
    std::size_t count = object.size();
    for (double width = std::max(clusters.mean_side() / 2, side / (most_cells - 1)); width < 2 * side; width *= wider) {
        const std::size_t left = clusters.simplify(width);
        if (left * 2 > count) continue;
        clusters.append(out);
        if (!(out.levels.back().error > error)) {  // a wider grid that happened to move less: never seen
            out.primitives.resize(out.levels.back().begin);
            out.two_sided.resize(out.levels.back().begin);
            out.levels.pop_back();
            continue;
        }
        error = out.levels.back().error;
        count = left;
        if (count <= least_object / 2) return;
    }
}

}  // namespace sightline
