// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "core/base/index.h"
#include "core/space/object_levels.h"

namespace sightline {

namespace {

/// Squared, from p to the closed segment.
double squared_distance_to(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b) {
    const Vec<2> d = b - a, q = p - a;
    const double whole = glm::dot(d, d);
    const double t = whole > 0 ? std::clamp(glm::dot(q, d) / whole, 0.0, 1.0) : 0;
    const Vec<2> rest = q - d * t;
    return glm::dot(rest, rest);
}

/// Points in order along segments that meet two at a time; first and last are no inner points.
using Chain = std::vector<std::uint32_t>;

/// The segments of an object as chains.
class Chains {
public:
    Chains(const Scene<2>& scene, std::span<const std::uint32_t> object) {
        weld(scene, object);
        std::vector<std::uint32_t> degree(points.size());
        for (const auto& ends : segments_)
            for (const std::uint32_t end : ends) ++degree[end];
        std::vector<std::uint32_t> begin(points.size() + 1);
        for (std::size_t i = 0; i < points.size(); ++i) begin[i + 1] = begin[i] + degree[i];
        std::vector<std::uint32_t> at_point(begin.back()), next(begin.begin(), begin.end() - 1);
        for (std::uint32_t s = 0; s < segments_.size(); ++s)
            for (const std::uint32_t end : segments_[s]) at_point[next[end]++] = s;
        std::vector<std::uint8_t> taken(segments_.size());
        const auto walk = [&](std::uint32_t segment, std::uint32_t from) {
            Chain chain{from};
            while (segment != none) {
                taken[segment] = 1;
                const auto& ends = segments_[segment];
                const std::uint32_t to = ends[0] == chain.back() ? ends[1] : ends[0];
                chain.push_back(to);
                segment = none;
                if (degree[to] == 2 && to != from)
                    for (std::uint32_t i = begin[to]; i < begin[to + 1]; ++i)
                        if (!taken[at_point[i]]) segment = at_point[i];
            }
            add(std::move(chain));
        };
        for (std::uint32_t point = 0; point < points.size(); ++point)
            if (degree[point] != 2)
                for (std::uint32_t i = begin[point]; i < begin[point + 1]; ++i)
                    if (!taken[at_point[i]]) walk(at_point[i], point);
        for (std::uint32_t s = 0; s < segments_.size(); ++s)  // what is left are loops
            if (!taken[s]) walk(s, segments_[s][0]);
    }

    std::vector<Vec<2>> points;
    std::vector<Chain> chains;

private:
    /// Equal ends, bit for bit, are one point; points in the order of their first use.
    void weld(const Scene<2>& scene, std::span<const std::uint32_t> object) {
        std::vector<std::pair<std::array<double, 2>, std::uint32_t>> ends;
        for (const std::uint32_t id : object)
            for (const Vec<2>& end : scene.primitives[id])
                ends.push_back({{end.x + 0.0, end.y + 0.0}, static_cast<std::uint32_t>(ends.size())});
        std::vector<std::uint32_t> first_use(ends.size());
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0, same = 0; i < ends.size(); ++i) {
            if (ends[i].first != ends[same].first) same = i;
            first_use[ends[i].second] = ends[same].second;
        }
        std::vector<std::uint32_t> number(ends.size(), none);
        segments_.resize(object.size());
        for (std::uint32_t end = 0; end < first_use.size(); ++end) {
            const std::uint32_t first = first_use[end];
            if (number[first] == none) {
                number[first] = static_cast<std::uint32_t>(points.size());
                points.push_back(scene.primitives[object[end / 2]][end % 2]);
            }
            segments_[end / 2][end % 2] = number[first];
        }
    }

    /// A loop is cut where it is farthest from its first point.
    void add(Chain chain) {
        if (chain.front() != chain.back()) return chains.push_back(std::move(chain));
        std::size_t cut = 1;
        double most = -1;
        for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
            const Vec<2> d = points[chain[i]] - points[chain.front()];
            if (glm::dot(d, d) > most) most = glm::dot(d, d), cut = i;
        }
        const auto middle = chain.begin() + static_cast<std::ptrdiff_t>(cut);
        chains.emplace_back(chain.begin(), middle + 1);
        chains.emplace_back(middle, chain.end());
    }

    std::vector<std::array<std::uint32_t, 2>> segments_;
};

/// Per place of the chain, the squared error at which Douglas and Peucker's rule drops its point; no more than that of
/// the point whose choice brought it up. Ends: never.
std::vector<double> dropped_at(const std::vector<Vec<2>>& points, const Chain& chain) {
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> error(chain.size(), never);
    struct Stretch {
        std::size_t from, to;
        double most;
    };
    std::vector<Stretch> stretches{{0, chain.size() - 1, never}};
    while (!stretches.empty()) {
        const Stretch stretch = stretches.back();
        stretches.pop_back();
        if (stretch.to - stretch.from < 2) continue;
        std::size_t farthest = stretch.from + 1;
        double away = -1;
        for (std::size_t i = stretch.from + 1; i < stretch.to; ++i) {
            const double d =
                squared_distance_to(points[chain[i]], points[chain[stretch.from]], points[chain[stretch.to]]);
            if (d > away) away = d, farthest = i;
        }
        error[farthest] = std::min(away, stretch.most);
        stretches.push_back({stretch.from, farthest, error[farthest]});
        stretches.push_back({farthest, stretch.to, error[farthest]});
    }
    return error;
}

}  // namespace

void append_levels(const Scene<2>& scene, std::span<const std::uint32_t> object, ObjectLevels<2>& out) {
    const Chains all(scene, object);
    std::vector<std::vector<double>> errors;
    std::vector<double> inner;  // of the points that may go, the largest first
    for (const Chain& chain : all.chains) {
        errors.push_back(dropped_at(all.points, chain));
        inner.insert(inner.end(), errors.back().begin() + 1, errors.back().end() - 1);
    }
    std::sort(inner.begin(), inner.end(), std::greater<>());
    const std::size_t least = all.chains.size();
    for (std::size_t count = object.size(); count > least_object / 2 && count > least;) {
        const std::size_t kept = std::max(count / 2, least) - least;
        if (kept >= inner.size()) return;
        // Those of an equal error go together.
        const double error = inner[kept];
        std::vector<std::array<std::uint32_t, 2>> segments;
        for (std::size_t c = 0; c < all.chains.size(); ++c) {
            const Chain& chain = all.chains[c];
            for (std::size_t from = 0, i = 1; i < chain.size(); ++i)
                if (errors[c][i] > error) {
                    segments.push_back({std::min(chain[from], chain[i]), std::max(chain[from], chain[i])});
                    from = i;
                }
        }
        // The two halves of a loop may have become one.
        std::sort(segments.begin(), segments.end());
        segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
        if (segments.size() * 4 > count * 3) return;
        const auto begin = static_cast<std::uint32_t>(out.primitives.size());
        for (const auto& ends : segments) out.primitives.push_back({all.points[ends[0]], all.points[ends[1]]});
        out.levels.push_back({begin, static_cast<std::uint32_t>(out.primitives.size()), std::sqrt(error)});
        count = segments.size();
    }
}

}  // namespace sightline
