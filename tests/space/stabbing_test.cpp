// How many cells a line crosses, and how primitives are spread over cells, against brute force.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/stabbing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/space/density.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"
#include "tests/space/random_cells.h"

namespace sightline {
namespace {

/// How far p lies on the inner side of the facet, rounded, in units of the facet's size.
double inside_by(const CellComplex<2>& cells, const HalfFacet& half, const Vec<2>& p) {
    const auto [a, b] = facet_ends(cells, half);
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}
double inside_by(const CellComplex<3>& cells, const HalfFacet& half, const Vec<3>& p) {
    const auto polygon = cells.points_of_facet(half.facet());
    const Vec<3>&a = cells.points[polygon[0]], &b = cells.points[polygon[1]], &c = cells.points[polygon[2]];
    // orient(a, b, c, p) is positive where the path a, b, c turns counter-clockwise as p sees it.
    const double volume = glm::dot(glm::cross(b - a, c - a), p - a);
    return half.flipped() ? -volume : volume;
}

/// Every cell of which the segment has a stretch inside, longer than rounding explains.
template <int D>
std::vector<std::uint32_t> crossed_by_clipping(const CellComplex<D>& cells, const Vec<D>& from, const Vec<D>& to) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        double first = 0, last = 1;
        for (const HalfFacet& half : cells.facets_of(cell)) {
            double a = inside_by(cells, half, from), b = inside_by(cells, half, to);
            if (facet_side(cells, half, from) * a < 0) a = -a, b = -b;  // the sign of the exact test
            if (a < 0 && b < 0) last = -1;
            if (a < 0 && b >= 0) first = std::max(first, a / (a - b));
            if (a >= 0 && b < 0) last = std::min(last, a / (a - b));
        }
        if (last - first > 1e-9) found.push_back(cell);
    }
    return found;
}

template <int D>
Vec<D> random_point(Random& random, double low, double high) {
    Vec<D> p;
    for (int i = 0; i < D; ++i) p[i] = random.uniform(low, high);
    return p;
}

template <int D>
void check_lines(const CellComplex<D>& cells, Random& random, std::size_t& crossings, std::size_t& from_inside) {
    const double low = -0.3, high = 1.3;  // the scenes lie in the unit box
    for (int i = 0; i < 40; ++i) {
        const Vec<D> from = random_point<D>(random, low, high), to = random_point<D>(random, low, high);
        auto along = cells_along(cells, from, to);
        ASSERT_TRUE(along) << "random lines meet no corner";
        for (std::size_t k = 0; k + 1 < along->size(); ++k) {
            const auto facets = cells.facets_of((*along)[k]);
            ASSERT_TRUE(std::any_of(facets.begin(), facets.end(), [&](const HalfFacet& half) {
                return half.neighbour == (*along)[k + 1];
            })) << "one after the other";
        }
        from_inside += !along->empty() && locate(cells, from) == along->front();
        crossings += along->size();
        std::sort(along->begin(), along->end());
        ASSERT_EQ(*along, crossed_by_clipping(cells, from, to));
    }
}

TEST(Stabbing, WalksThroughTheCellsThatClippingFinds) {
    Random random(81);
    std::size_t crossings = 0, from_inside = 0;
    for (int i = 0; i < test::soak_count(60); ++i) {
        SCOPED_TRACE(i);
        // Without jitter leaf centres that lie on a line make cells of no width.
        Settings settings = test::random_settings(random);
        settings.jitter = 0.02;
        const CellComplex<2> plane = build_cells(test::random_scene(random, random.below(60)), settings);
        ASSERT_NO_FATAL_FAILURE(check_lines(plane, random, crossings, from_inside));
        ASSERT_NO_FATAL_FAILURE(check_lines(test::random_cells(random), random, crossings, from_inside));
    }
    EXPECT_GT(crossings, 20000u);
    EXPECT_GT(from_inside, 500u);
}

TEST(Stabbing, CountsLinesAndRays) {
    Random random(82);
    const CellComplex<3> cells = test::random_cells(random);
    const Stabbing lines = random_lines(cells, 500);
    EXPECT_EQ(lines.lines, 500u);
    EXPECT_GE(lines.mean, 1);
    EXPECT_LE(lines.mean, lines.most);
    EXPECT_LE(lines.most, cells.cell_count());
    EXPECT_EQ(random_lines(cells, 500).mean, lines.mean) << "the same every time";
    const std::vector<View<3>> views{make_view({{0.5, 0.5, 0.5}, {1, 0.7, 0.6}, 60}, 4.0 / 3)};
    const Stabbing rays = eye_rays<3>(cells, views, 100);
    EXPECT_EQ(rays.lines, 100u) << "the eye is inside";
    EXPECT_LT(rays.mean, lines.mean + 1) << "from the middle to one side";
    EXPECT_EQ(random_lines(CellComplex<3>(), 10).lines, 0u);
    EXPECT_EQ(eye_rays<3>(CellComplex<3>(), views, 10).lines, 0u);
}

double size_of_facet(const CellComplex<2>& cells, std::uint32_t facet) {
    const auto ends = cells.points_of_facet(facet);
    const Vec<2> d = cells.points[ends[1]] - cells.points[ends[0]];
    return std::sqrt(glm::dot(d, d));
}
double size_of_facet(const CellComplex<3>& cells, std::uint32_t facet) {
    const auto polygon = cells.points_of_facet(facet);
    Vec<3> sum(0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += glm::cross(cells.points[polygon[i]] - cells.points[polygon[0]],
                          cells.points[polygon[i + 1]] - cells.points[polygon[0]]);
    return std::sqrt(glm::dot(sum, sum)) / 2;
}

/// Cauchy and Crofton: a line that is uniform among those that meet a convex body crosses a surface inside it as often,
/// in the mean, as twice its area over that of the body's border; in the plane with lengths.
template <int D>
void expect_uniform(const CellComplex<D>& cells) {
    double border = 0, twice_inner = 0;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (const HalfFacet& half : cells.facets_of(cell))
            (half.neighbour == none ? border : twice_inner) += size_of_facet(cells, half.facet());
    const double expected = 1 + twice_inner / border;
    EXPECT_NEAR(random_lines(cells, 20000).mean, expected, 0.03 * expected);
}

TEST(Stabbing, EveryLineIsAsLikely) {
    Random random(84);
    Settings settings;
    settings.error_bound = 0.1;
    for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree}) {
        settings.tessellation = kind;
        expect_uniform(build_cells(test::random_scene(random, 60), settings));
    }
    for (int i = 0; i < 4; ++i) expect_uniform(test::random_cells(random));
}

TEST(Density, AgreesWithCounting) {
    Random random(83);
    for (int i = 0; i < test::soak_count(40); ++i) {
        const CellComplex<2> cells =
            build_cells(test::random_scene(random, random.below(200)), test::random_settings(random));
        const Density found = density(cells);
        std::vector<double> counts;
        std::size_t all = 0, empty = 0;
        for (const std::uint32_t cells_of : found.histogram) all += cells_of;
        EXPECT_EQ(all, cells.cell_count());
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            const std::size_t count = cells.primitives_of(cell).size();
            if (count == 0)
                ++empty;
            else
                counts.push_back(static_cast<double>(count));
        }
        for (std::size_t place = 0; place < found.histogram.size(); ++place) {
            const double least = place == 0 ? 0 : std::ldexp(1.0, static_cast<int>(place) - 1),
                         beyond = std::ldexp(1.0, static_cast<int>(place));
            const auto in = std::count_if(counts.begin(), counts.end(),
                                          [&](double count) { return count >= least && count < beyond; });
            EXPECT_EQ(found.histogram[place], place == 0 ? empty : static_cast<std::size_t>(in)) << place;
        }
        if (cells.cell_count() == 0) continue;
        EXPECT_NEAR(found.empty, static_cast<double>(empty) / cells.cell_count(), 1e-12);
        if (counts.empty()) {
            EXPECT_TRUE(std::isnan(found.mean));
            continue;
        }
        double sum = 0, sum2 = 0;
        for (const double count : counts) sum += count, sum2 += count * count;
        const double n = static_cast<double>(counts.size()), mean = sum / n;
        EXPECT_NEAR(found.mean, mean, 1e-9 * mean);
        EXPECT_NEAR(found.deviation, std::sqrt(std::max(0.0, sum2 / n - mean * mean)) / mean, 1e-6);
        const auto below = std::count_if(counts.begin(), counts.end(), [&](double c) { return c < found.median; }),
                   above = std::count_if(counts.begin(), counts.end(), [&](double c) { return c > found.median; });
        EXPECT_LE(2 * std::max(below, above), static_cast<std::ptrdiff_t>(counts.size()));
    }
}

}  // namespace
}  // namespace sightline
