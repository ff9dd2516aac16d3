// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/stabbing.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace sightline {

namespace {

/// Whether the line through p and q crosses the inside of the facet; nothing when it meets its rim. Exact.
std::optional<bool> crosses(const CellComplex<2>& cells, std::uint32_t facet, const Vec<2>& p, const Vec<2>& q) {
    const auto ends = cells.points_of_facet(facet);
    const int a = orient(p, q, cells.points[ends[0]]), b = orient(p, q, cells.points[ends[1]]);
    if (a * b > 0) return false;
    if (a * b < 0) return true;
    return std::nullopt;
}
std::optional<bool> crosses(const CellComplex<3>& cells, std::uint32_t facet, const Vec<3>& p, const Vec<3>& q) {
    const auto polygon = cells.points_of_facet(facet);
    bool left = false, right = false, rim = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const int side =
            orient(p, q, cells.points[polygon[i]], cells.points[polygon[i + 1 < polygon.size() ? i + 1 : 0]]);
        left |= side > 0;
        right |= side < 0;
        rim |= side == 0;
    }
    if (left && right) return false;
    if (rim) return std::nullopt;
    return true;
}

/// A way into the tessellation or out of a cell; `facet` none: there is no such way.
struct Way {
    std::uint32_t facet = none, cell = none;
};

/// The facet through which the line leaves the cell towards `to`, unless `to` comes first, and what lies behind it.
template <int D>
std::optional<Way> way_out(const CellComplex<D>& cells, std::uint32_t cell, std::uint32_t entry, const Vec<D>& from,
                           const Vec<D>& to) {
    for (const HalfFacet& half : cells.facets_of(cell)) {
        if (half.facet() == entry || facet_side(cells, half, to) >= 0) continue;
        const std::optional<bool> crossed = crosses(cells, half.facet(), from, to);
        if (!crossed) return std::nullopt;
        if (*crossed) return Way{half.facet(), half.neighbour};
    }
    return Way{};
}

/// From outside: the border is convex, so that at most one facet is crossed from its outer to its inner side.
template <int D>
std::optional<Way> way_in(const CellComplex<D>& cells, const Vec<D>& from, const Vec<D>& to) {
    for (const std::uint32_t cell : cells.border_cells)
        for (const HalfFacet& half : cells.facets_of(cell)) {
            if (half.neighbour != none || facet_side(cells, half, from) >= 0 || facet_side(cells, half, to) <= 0)
                continue;
            const std::optional<bool> crossed = crosses(cells, half.facet(), from, to);
            if (!crossed) return std::nullopt;
            if (*crossed) return Way{half.facet(), cell};
        }
    return Way{};
}

/// A ball round the tessellation.
template <int D>
struct Ball {
    Vec<D> centre{};
    double radius = 0;
};
template <int D>
Ball<D> ball_round(const CellComplex<D>& cells) {
    Vec<D> low = cells.points.front(), high = low;
    for (const Vec<D>& p : cells.points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const Vec<D> centre = (low + high) * 0.5, half = high - centre;
    return {centre, 1.001 * std::sqrt(glm::dot(half, half))};  // a little beyond the corners
}

/// Uniform over directions.
template <int D>
Vec<D> random_direction(Random& random) {
    for (;;) {
        Vec<D> d;
        for (int i = 0; i < D; ++i) d[i] = random.uniform(-1, 1);
        const double length2 = glm::dot(d, d);
        if (length2 > 0.01 && length2 <= 1) return d / std::sqrt(length2);
    }
}

/// Both ends lie on the ball.
std::pair<Vec<2>, Vec<2>> random_line(Random& random, const Ball<2>& ball) {
    const Vec<2> d = random_direction<2>(random), across(-d.y, d.x);
    const double offset = random.uniform(-1, 1), half = std::sqrt(1 - offset * offset);
    const Vec<2> middle = ball.centre + across * (offset * ball.radius), reach = d * (half * ball.radius);
    return {middle - reach, middle + reach};
}
/// Two independent points of a sphere are the ends of a uniform random chord.
std::pair<Vec<3>, Vec<3>> random_line(Random& random, const Ball<3>& ball) {
    const Vec<3> a = random_direction<3>(random), b = random_direction<3>(random);
    return {ball.centre + a * ball.radius, ball.centre + b * ball.radius};
}

Vec<2> random_ray(Random& random, const View<2>& view) {
    if (view.all_round) return random_direction<2>(random);
    const double u = random.unit();
    return view.corners[0] * (1 - u) + view.corners[1] * u - view.eye;
}
Vec<3> random_ray(Random& random, const View<3>& view) {
    const double u = random.unit(), v = random.unit();
    const Vec<3> low = view.corners[0] * (1 - u) + view.corners[1] * u;
    const Vec<3> high = view.corners[3] * (1 - u) + view.corners[2] * u;
    return low * (1 - v) + high * v - view.eye;
}

/// Adds a line up.
struct Sum {
    Stabbing result;
    double total = 0;
    void add(std::size_t cells) {
        total += static_cast<double>(cells);
        result.most = std::max(result.most, static_cast<std::uint32_t>(cells));
        result.mean = total / ++result.lines;
    }
};

}  // namespace

template <int D>
std::optional<std::vector<std::uint32_t>> cells_along(const CellComplex<D>& cells, const Vec<D>& from,
                                                      const Vec<D>& to) {
    std::vector<std::uint32_t> crossed;
    Way way{none, cells.cell_count() > 0 ? locate(cells, from) : none};
    if (way.cell == none) {
        const std::optional<Way> in = way_in(cells, from, to);
        if (!in) return std::nullopt;
        way = *in;
    }
    while (way.cell != none) {
        crossed.push_back(way.cell);
        const std::optional<Way> out = way_out(cells, way.cell, way.facet, from, to);
        if (!out) return std::nullopt;
        way = *out;
    }
    return crossed;
}

template <int D>
Stabbing random_lines(const CellComplex<D>& cells, std::uint32_t lines, std::uint64_t seed) {
    if (cells.cell_count() == 0) return {};
    const Ball<D> ball = ball_round(cells);
    Random random(seed);
    Sum sum;
    // Flat tessellations are missed by nearly all lines.
    for (std::uint64_t tries = 0; sum.result.lines < lines && tries < 100 * std::uint64_t{lines}; ++tries) {
        const auto [from, to] = random_line(random, ball);
        const auto crossed = cells_along(cells, from, to);
        if (crossed && !crossed->empty()) sum.add(crossed->size());
    }
    return sum.result;
}

template <int D>
Stabbing eye_rays(const CellComplex<D>& cells, std::span<const View<D>> views, std::uint32_t rays, std::uint64_t seed) {
    if (cells.cell_count() == 0) return {};
    const Ball<D> ball = ball_round(cells);
    Random random(seed);
    Sum sum;
    for (const View<D>& view : views) {
        const Vec<D> away = view.eye - ball.centre;
        const double reach = 2 * (ball.radius + std::sqrt(glm::dot(away, away)));
        for (std::uint32_t i = 0; i < rays; ++i) {
            const Vec<D> d = random_ray(random, view);
            const auto crossed = cells_along(cells, view.eye, view.eye + d * (reach / std::sqrt(glm::dot(d, d))));
            if (crossed && !crossed->empty()) sum.add(crossed->size());
        }
    }
    return sum.result;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                            \
    template std::optional<std::vector<std::uint32_t>> cells_along<D>(const CellComplex<D>&, const Vec<D>&, \
                                                                      const Vec<D>&);                       \
    template Stabbing random_lines<D>(const CellComplex<D>&, std::uint32_t, std::uint64_t);                 \
    template Stabbing eye_rays<D>(const CellComplex<D>&, std::span<const View<D>>, std::uint32_t, std::uint64_t);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
