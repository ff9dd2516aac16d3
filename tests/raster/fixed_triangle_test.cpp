// Coverage and depth of single triangles against exact arithmetic.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/fixed_triangle.h"

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

using Exact = CGAL::Exact_rational;
using Whole = __int128;

constexpr ImageSize grid{20, 14};

/// A triangle snapped by rationals: corners in places, turning so that the area is positive or 0.
struct ExactTriangle {
    std::array<std::int64_t, 3> x, y;
    std::array<float, 3> nearness;

    ExactTriangle(const ImageCorner* corners, const ImageSize& size) {
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = snapped(corners[i].x, size.width);
            y[i] = snapped(corners[i].y, size.height);
            nearness[i] = corners[i].nearness;
        }
        if (area() < 0) {
            std::swap(x[1], x[2]);
            std::swap(y[1], y[2]);
            std::swap(nearness[1], nearness[2]);
        }
    }
    Whole edge(std::size_t i, Whole px, Whole py) const {
        const std::size_t j = (i + 1) % 3;
        return Whole(x[j] - x[i]) * (py - y[i]) - Whole(y[j] - y[i]) * (px - x[i]);
    }
    Whole area() const { return edge(0, x[2], y[2]); }
    bool covers(int column, int row) const {
        if (area() == 0) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const Whole side = edge(i, 256 * column + 128, 256 * row + 128);
            const bool top = y[j] == y[i] && x[j] > x[i], left = y[j] < y[i];
            if (side < 0 || (side == 0 && !top && !left)) return false;
        }
        return true;
    }
    Exact nearness_at(int column, int row) const {
        Exact sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum +=
                Exact(static_cast<double>(edge((i + 1) % 3, 256 * column + 128, 256 * row + 128))) * Exact(nearness[i]);
        return sum / Exact(static_cast<double>(area()));
    }

private:
    static std::int64_t snapped(float v, int pixels) {
        const Exact place = (Exact(v) + 1) * 128 * pixels + Exact(1, 2);
        auto whole = static_cast<std::int64_t>(std::floor(CGAL::to_double(place)));
        while (Exact(static_cast<double>(whole)) > place) --whole;
        while (Exact(static_cast<double>(whole + 1)) <= place) ++whole;
        return whole;
    }
};

/// Corners of many kinds: anywhere, on centres and borders of pixels, on one line, close together, far outside.
std::array<ImageCorner, 3> some_triangle(Random& random, const ImageSize& size) {
    std::array<ImageCorner, 3> corners;
    const auto kind = random.below(6);
    for (ImageCorner& c : corners) {
        const double reach = kind == 0 ? 2 : 1.2;
        double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
        if (kind == 1 || kind == 2) {  // on the grid of centres and borders
            x = static_cast<double>(random.below(2 * static_cast<std::uint64_t>(size.width) + 3)) / size.width - 1;
            y = static_cast<double>(random.below(2 * static_cast<std::uint64_t>(size.height) + 3)) / size.height - 1;
        }
        if (kind == 3 && &c != corners.data()) {  // small
            x = corners[0].x + random.uniform(-0.1, 0.1);
            y = corners[0].y + random.uniform(-0.1, 0.1);
        }
        const double near = kind == 4 ? std::ldexp(random.uniform(0.5, 1), -static_cast<int>(random.below(100)))
                                      : random.uniform(0.1, 1);
        c = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(near), 7};
    }
    if (kind == 5) {  // thin, or with no area
        const double t = random.unit(), off = random.below(2) ? random.uniform(-0.01, 0.01) : 0;
        corners[2].x = static_cast<float>(corners[0].x + (corners[1].x - corners[0].x) * t + off);
        corners[2].y = static_cast<float>(corners[0].y + (corners[1].y - corners[0].y) * t);
    }
    return corners;
}

template <typename F>
void for_pixels(const ImageSize& size, const F& f) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) f(x, y);
}

/// 1 per pixel that the rows say is covered.
std::vector<std::uint8_t> covered(const CoveredRows& rows, const ImageSize& size) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(size.width * size.height));
    for (int y = rows.first_row; y < rows.end_row; ++y) {
        std::int32_t first, end;
        rows.span(y, first, end);
        for (int x = first; x < end; ++x) ++mask[static_cast<std::size_t>(y * size.width + x)];
    }
    return mask;
}

TEST(FixedTriangle, CoversThePixelsThatExactArithmeticSays) {
    Random random(1);
    int full = 0, empty = 0;
    for (int n = 0; n < soak_count(1000); ++n) {
        const ImageSize size = n % 50 == 49 ? ImageSize{1 + static_cast<int>(random.below(3)), 16384} : grid;
        const auto corners = some_triangle(random, size);
        const ExactTriangle exact(corners.data(), size);
        FixedTriangle triangle;
        const bool drawn = snap_triangle(corners.data(), size, triangle);
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(size.width * size.height));
        if (drawn) mask = covered(CoveredRows(triangle, size), size);
        int wrong = 0;
        bool any = false;
        for_pixels(size, [&](int x, int y) {
            const bool covers = exact.covers(x, y);
            any |= covers;
            wrong += mask[static_cast<std::size_t>(y * size.width + x)] != (covers ? 1 : 0);
        });
        EXPECT_EQ(wrong, 0) << "triangle " << n;
        full += any;
        empty += !any;
    }
    EXPECT_GT(full, 400);
    EXPECT_GT(empty, 50);
}

TEST(FixedTriangle, DepthIsTheExactMeanOfTheCornersUpToOneStepOfAFloat) {
    Random random(2);
    int checked = 0;
    for (int n = 0; n < soak_count(1000); ++n) {
        const auto corners = some_triangle(random, grid);
        const ExactTriangle exact(corners.data(), grid);
        FixedTriangle triangle;
        if (!snap_triangle(corners.data(), grid, triangle)) continue;
        const CoveredRows rows(triangle, grid);
        const NearnessPlane plane(triangle);
        for (int y = rows.first_row; y < rows.end_row; ++y) {
            std::int32_t first, end;
            rows.span(y, first, end);
            for (int x = first; x < end; x += 3) {
                const auto ours = static_cast<float>(plane.row(y, first).at(x - first));
                const Exact truth = exact.nearness_at(x, y);
                EXPECT_LE(Exact(std::nextafter(ours, 0.0f)), truth) << "triangle " << n;
                EXPECT_GE(Exact(std::nextafter(ours, 2.0f)), truth) << "triangle " << n;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 3000);
}

TEST(FixedTriangle, OfTwoThatOverlapTheNearerWinsAndOfEqualOnesTheLowestId) {
    Random random(3);
    int decided = 0, equal = 0;
    for (int n = 0; n < soak_count(1000); ++n) {
        auto a = some_triangle(random, grid), b = some_triangle(random, grid);
        if (n % 4 == 0) {  // the same one from another corner on, or the other way round
            b = a;
            std::swap(b[random.below(3)], b[random.below(3)]);
        }
        FixedTriangle first, second;
        if (!snap_triangle(a.data(), grid, first) || !snap_triangle(b.data(), grid, second)) continue;
        const ExactTriangle one(a.data(), grid), two(b.data(), grid);
        for_pixels(grid, [&](int x, int y) {
            if ((x + y) % 3 || !one.covers(x, y) || !two.covers(x, y)) return;
            const auto here = static_cast<float>(NearnessPlane(first).row(y, x).at(0)),
                       there = static_cast<float>(NearnessPlane(second).row(y, x).at(0));
            const Exact truth = one.nearness_at(x, y), other = two.nearness_at(x, y);
            if (n % 4 == 0) {
                EXPECT_EQ(here, there);
                ++equal;
            } else if (truth > other * (1 + Exact(1, 1 << 23))) {
                EXPECT_GT(here, there);
                ++decided;
            } else if (other > truth * (1 + Exact(1, 1 << 23))) {
                EXPECT_GT(there, here);
                ++decided;
            }
        });
    }
    EXPECT_GT(decided, 400);
    EXPECT_GT(equal, 1000);
}

TEST(FixedTriangle, AMeshCoversEachPixelOnceAlsoWhereItsPointsLieOnCentres) {
    Random random(4);
    for (int n = 0; n < soak_count(60); ++n) {
        // A net of points over more than the image; each quad in two triangles. Where the points are moved far, some
        // triangles turn over and lie on others.
        const double moved = n % 3 ? 0.15 : 0.4;
        constexpr int side = 7;
        std::array<std::array<ImageCorner, side>, side> net;
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const double x = (j + random.uniform(-moved, moved)) * 2.6 / (side - 1) - 1.3,
                             y = (i + random.uniform(-moved, moved)) * 2.6 / (side - 1) - 1.3;
                const auto on_grid = [&](double v, int pixels) {
                    return n % 2 ? v : std::floor((v + 1) * pixels) / pixels - 1;
                };
                const auto out_of = [](int at, double v) { return at == 0 ? -1.5 : at == side - 1 ? 1.5 : v; };
                net[i][j] = {static_cast<float>(on_grid(out_of(j, x), grid.width)),
                             static_cast<float>(on_grid(out_of(i, y), grid.height)), 0.5f, 0};
            }
        std::vector<int> count(static_cast<std::size_t>(grid.width * grid.height));
        for (int i = 0; i + 1 < side; ++i)
            for (int j = 0; j + 1 < side; ++j) {
                const ImageCorner quad[4] = {net[i][j], net[i][j + 1], net[i + 1][j + 1], net[i + 1][j]};
                for (const int k : {1, 2}) {
                    const ImageCorner corners[3] = {quad[0], quad[k], quad[k + 1]};
                    FixedTriangle triangle;
                    if (!snap_triangle(corners, grid, triangle)) continue;
                    const auto mask = covered(CoveredRows(triangle, grid), grid);
                    for (std::size_t p = 0; p < mask.size(); ++p) count[p] += mask[p];
                }
            }
        // One that is turned over lies on two others.
        for (const int c : count) EXPECT_EQ(n % 3 ? c : c % 2, 1) << "net " << n;
    }
}

TEST(FixedTriangle, ShrunkToPixelsThatLieWhollyInside) {
    Random random(5);
    int inside = 0;
    for (int n = 0; n < soak_count(1000); ++n) {
        const auto corners = some_triangle(random, grid);
        const ExactTriangle exact(corners.data(), grid);
        FixedTriangle triangle;
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(grid.width * grid.height));
        if (snap_triangle(corners.data(), grid, triangle)) mask = covered(CoveredRows(triangle, grid, true, 2), grid);
        for_pixels(grid, [&](int x, int y) {
            bool whole = exact.area() != 0;
            for (std::size_t i = 0; i < 3 && whole; ++i)
                for (const int corner : {0, 1, 2, 3})
                    whole &= exact.edge(i, 256 * x + 128 + (corner & 1 ? 130 : -130),
                                        256 * y + 128 + (corner & 2 ? 130 : -130)) >= 0;
            EXPECT_EQ(mask[static_cast<std::size_t>(y * grid.width + x)], whole ? 1 : 0) << "triangle " << n;
            inside += whole;
        });
    }
    EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace sightline::test
