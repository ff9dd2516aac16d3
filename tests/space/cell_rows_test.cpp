// The copies of cells that traversals read, and what is remembered of a view, against the cell complex.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/cell_rows.h"

#include <gtest/gtest.h>

#include "core/methods/cells/star_shape.h"
#include "core/session/settings.h"
#include "core/space/cell_in_view.h"
#include "tests/soak.h"
#include "tests/space/random_cells.h"

namespace sightline::test {
namespace {

TEST(CellRows, KnowTheCornersBehindEachFacet) {
    Random random(3);
    for (int i = 0; i < soak_count(30); ++i) {
        const CellComplex<3> cells = random_cells(random);
        const auto rows = cell_rows(cells);
        if (cells.has_boxes()) {
            EXPECT_TRUE(rows.empty());
            continue;
        }
        ASSERT_EQ(rows.size(), cells.cell_count());
        for (std::uint32_t cell = 0; cell < rows.size(); ++cell)
            for (std::size_t f = 0; f < 4; ++f) {
                const HalfFacet half = cells.facets_of(cell)[f];
                ASSERT_EQ(rows[cell].corners[f], cells.corners_of(cell)[f]);
                ASSERT_EQ(rows[cell].facets[f].neighbour, half.neighbour);
                ASSERT_EQ(rows[cell].facets[f].facet_side, half.facet_side);
                if (half.neighbour == none) {
                    ASSERT_EQ(rows[cell].apex[f], none);
                    continue;
                }
                auto corners = rows[cell].corners;
                corners[f] = rows[cell].apex[f];
                const auto behind = cells.corners_of(half.neighbour);
                ASSERT_TRUE(std::is_permutation(corners.begin(), corners.end(), behind.begin(), behind.end()));
            }
    }
}

TEST(CellsInView, AreThoseThatTheCornersSay) {
    Random random(4);
    for (int i = 0; i < soak_count(30); ++i) {
        const CellComplex<3> cells = random_cells(random);
        CellsInView<3> in_view;
        for (int k = 0; k < 10; ++k) {
            ViewSpec<3> spec;
            spec.eye = {random.uniform(-1, 2), random.uniform(-1, 2), random.uniform(-1, 2)};
            spec.look_at = {random.unit(), random.unit(), random.unit()};
            spec.fov = random.uniform(5, 120);
            const View<3> view = make_view(spec, 1.5);
            in_view.begin(cells);
            for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
                ASSERT_EQ(in_view.has(cells, view, cell, cells.corners_of(cell)), cell_in_view(cells, view, cell));
        }
    }
}

/// By exact signs alone.
bool star_shaped_exactly(const CellComplex<3>& cells, const HalfFacet& half, const Vec<3>& eye, const Vec<3>& centre) {
    if (facet_side(cells, half, eye) < 0) return false;
    const auto polygon = cells.points_of_facet(half.facet());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<3>&p = cells.points[polygon[i]], &q = cells.points[polygon[(i + 1) % polygon.size()]];
        if (orient(eye, p, q, centre) == (half.flipped() ? -1 : 1)) return false;
    }
    return true;
}

/// Also from eyes in the planes of facets, on their edges and in their corners, at all scales.
TEST(StarShape, IsWhatExactSignsSay) {
    Random random(5);
    std::size_t yes = 0, no = 0;
    for (int i = 0; i < soak_count(60); ++i) {
        CellComplex<3> cells = random_cells(random);
        constexpr std::array scales{1.0, 1.0, 0x1p-400, 0x1p-340, 0x1p320};
        const double scale = scales[random.below(scales.size())];
        for (Vec<3>& p : cells.points) p *= scale;
        if (cells.cell_count() == 0) continue;
        for (int k = 0; k < 200; ++k) {
            const auto cell = static_cast<std::uint32_t>(random.below(cells.cell_count()));
            const auto facets = cells.facets_of(cell);
            const HalfFacet half = facets[random.below(facets.size())];
            if (half.neighbour == none) continue;
            const auto polygon = cells.points_of_facet(half.facet());
            const Vec<3>&a = cells.points[polygon[0]], &b = cells.points[polygon[1]], &c = cells.points[polygon[2]];
            Vec<3> centre(0);
            for (const std::uint32_t corner : cells.corners_of(half.neighbour)) centre += cells.points[corner];
            centre /= static_cast<double>(cells.corners_of(half.neighbour).size());
            const Vec<3> through = centre + (b + (a - b) * random.unit() - centre) * 3.0;  // by an edge
            const std::array<Vec<3>, 5> eyes{
                Vec<3>(random.uniform(-1, 2), random.uniform(-1, 2), random.uniform(-1, 2)) * scale, a,
                a + (b - a) * random.uniform(-1, 2) + (c - a) * random.uniform(-1, 2), through, (a + b) * 0.5};
            const Vec<3>& eye = eyes[random.below(eyes.size())];
            const bool star = star_shaped(cells, half, eye, centre);
            ASSERT_EQ(star, star_shaped_exactly(cells, half, eye, centre));
            ++(star ? yes : no);
        }
    }
    EXPECT_GT(yes, 300u);
    EXPECT_GT(no, 300u);
}

}  // namespace
}  // namespace sightline::test
