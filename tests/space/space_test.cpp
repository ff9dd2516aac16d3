// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <set>

#include "core/space/builders.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"
#include "tests/space/space_support.h"

namespace sightline {
namespace {

using test::expect_linked;
using test::holds;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

Exact::Point_2 exact(const Vec<2>& p) { return {p.x, p.y}; }

double area(const CellComplex<2>& cells, std::uint32_t cell) {
    double sum = 0;
    const auto corners = cells.corners_of(cell);
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += cross(cells.points[corners[i]], cells.points[corners[(i + 1) % corners.size()]]) / 2;
    return sum;
}

/// Without jitter, rounded leaf centres make slivers an ulp wide whose rounded centre may lie outside them.
bool sliver(const CellComplex<2>& cells, std::uint32_t cell) { return area(cells, cell) < 1e-14; }

TEST(Space, CellsAreLinkedBothWaysAndFillTheirBox) {
    Random random(21);
    for (int i = 0; i < test::soak_count(100); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        Settings settings = test::random_wide_settings(random);
        const CellComplex<2> cells = build_cells(scene, settings);
        expect_linked(cells, sliver);
        double sum = 0;
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            ASSERT_GT(area(cells, cell), settings.jitter > 0 ? 0 : -1e-16);
            sum += area(cells, cell);
        }
        const double side = cells.tree.root_box().extent().x;
        if (cells.has_boxes()) {
            ASSERT_NEAR(sum, side * cells.tree.root_box().extent().y, 1e-12);
            ASSERT_EQ(cells.unassigned, 0u);
        } else if (settings.border == Border::inflated) {
            ASSERT_NEAR(sum, side * side * 1.1 * 1.1, 1e-12);
            ASSERT_EQ(cells.unassigned, 0u);
        }
    }
}

TEST(Space, DelaunayCellsHaveEmptyCircumcircles) {
    Random random(23);
    for (int i = 0; i < test::soak_count(20); ++i) {
        Settings settings;
        settings.jitter = i % 2 ? 0 : 0.02;
        const CellComplex<2> cells = build_cells(test::random_scene(random, 30), settings);
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            const auto c = cells.corners_of(cell);
            for (const Vec<2>& p : cells.points)
                ASSERT_NE(CGAL::side_of_oriented_circle(exact(cells.points[c[0]]), exact(cells.points[c[1]]),
                                                        exact(cells.points[c[2]]), exact(p)),
                          CGAL::ON_POSITIVE_SIDE);
        }
    }
}

TEST(Space, PrimitivesGoToEveryCellTheyMeetAndToNoOther) {
    Random random(24);
    for (int i = 0; i < test::soak_count(60); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(40));
        const Settings settings = test::random_wide_settings(random);
        const CellComplex<2> cells = build_cells(scene, settings);
        std::vector<int> in_cells(scene.primitives.size());
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            std::vector<Exact::Point_2> corners;
            for (const std::uint32_t p : cells.corners_of(cell)) corners.push_back(exact(cells.points[p]));
            const auto assigned = cells.primitives_of(cell);
            for (std::uint32_t p = 0; p < scene.primitives.size(); ++p) {
                const Exact::Segment_2 segment(exact(scene.primitives[p][0]), exact(scene.primitives[p][1]));
                bool meets = false;
                for (std::size_t c = 2; c < corners.size(); ++c)
                    meets |= CGAL::do_intersect(Exact::Triangle_2(corners[0], corners[c - 1], corners[c]), segment);
                ASSERT_EQ(std::count(assigned.begin(), assigned.end(), p), meets);
                in_cells[p] += meets;
            }
        }
        ASSERT_EQ(cells.unassigned, std::count(in_cells.begin(), in_cells.end(), 0));
    }
}

TEST(Space, LocateFindsTheLowestCellThatHoldsThePoint) {
    Random random(25);
    for (int i = 0; i < test::soak_count(100); ++i) {
        const CellComplex<2> cells =
            build_cells(test::random_scene(random, random.below(60)), test::random_wide_settings(random));
        for (int query = 0; query < 50; ++query) {
            Vec<2> p(random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2));
            if (cells.cell_count() > 0 && query % 3 == 0) p = cells.points[random.below(cells.points.size())];
            if (cells.facet_count() > 0 && query % 3 == 1) {
                const auto ends = cells.points_of_facet(static_cast<std::uint32_t>(random.below(cells.facet_count())));
                p = (cells.points[ends[0]] + cells.points[ends[1]]) * 0.5;
            }
            ASSERT_EQ(locate(cells, p), test::lowest_holding(cells, p));
        }
    }
}

TEST(Space, NeighboursOfLeavesAreThoseThatShareAFacetOrTouch) {
    Random random(27);
    for (int i = 0; i < test::soak_count(40); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(40));
        Settings settings = test::random_wide_settings(random);
        settings.tessellation = i % 2 ? Tessellation::kd : Tessellation::tree;
        test::expect_neighbours_of_boxes(build_cells(scene, settings), settings.neighbours);
    }
}

TEST(Space, KdLeavesAreSplitAtTheMedianAcrossTheLongestSide) {
    Random random(28);
    for (int i = 0; i < test::soak_count(60); ++i)
        test::expect_kd_rule<2>(test::random_scene(random, 1 + random.below(60)).primitives, random.uniform(0.01, 0.5),
                                static_cast<std::uint32_t>(1 + random.below(5)));
}

TEST(Space, DroppedLeavesTakeTheirCentresAwayAndNoOther) {
    Random random(29);
    for (int i = 0; i < test::soak_count(40); ++i) {
        const Scene<2> scene = test::random_scene(random, 1 + random.below(60));
        TessellationSettings settings = test::random_wide_settings(random);
        settings.tessellation = Tessellation::delaunay;
        settings.empty_leaves = EmptyLeaves::keep;
        const CellComplex<2> all = build_cells(scene, settings);
        settings.empty_leaves = EmptyLeaves::drop;
        const CellComplex<2> some = build_cells(scene, settings);
        std::vector<bool> occupied(all.tree.leaves.size());
        for (const Primitive<2>& segment : scene.primitives)
            for (const Vec<2>& p : segment) occupied[all.tree.leaf_at(p)] = true;
        std::vector<Vec<2>> kept;
        for (std::size_t point = 0; point < all.points.size(); ++point)
            if (point >= occupied.size() || occupied[point]) kept.push_back(all.points[point]);
        ASSERT_EQ(some.points, kept);
        ASSERT_EQ(some.tree.leaves, all.tree.leaves);
        for (int query = 0; query < 20; ++query) {
            const Vec<2> p(random.unit(), random.unit());
            ASSERT_EQ(locate(some, p), test::lowest_holding(some, p));
        }
    }
}

TEST(Space, LeavesHoldAsManyVerticesAsTheyMayOrAreAtTheErrorBound) {
    Random random(26);
    for (int i = 0; i < test::soak_count(50); ++i) {
        const Scene<2> scene = test::random_scene(random, 1 + random.below(60));
        const double bound = random.uniform(0.01, 0.5);
        const auto capacity = static_cast<std::uint32_t>(i % 2 ? 1 : 1 + random.below(8));
        const Tree<2> tree = build_tree<2>(scene.primitives, bound, capacity);
        const double limit = bounds<2>(scene.primitives).longest_side() * bound;
        std::vector<std::vector<Vec<2>>> held(tree.leaves.size());
        for (const auto& segment : scene.primitives)
            for (const Vec<2>& p : segment) held[tree.leaf_at(p)].push_back(p);
        for (std::size_t leaf = 0; leaf < held.size(); ++leaf) {
            const double side = tree.nodes[tree.leaves[leaf]].box.extent().x;
            std::set<std::pair<double, double>> distinct;
            for (const Vec<2>& p : held[leaf]) {
                ASSERT_TRUE(tree.nodes[tree.leaves[leaf]].box.contains(p));
                distinct.insert({p.x, p.y});
            }
            if (distinct.size() > capacity) {
                ASSERT_LT(side, limit);
            }
            ASSERT_EQ(distinct.empty(), std::binary_search(tree.empty_leaves.begin(), tree.empty_leaves.end(), leaf));
        }
        // And no node is split that need not be.
        for (const auto& node : tree.nodes) {
            if (node.first_child == none) continue;
            std::set<std::pair<double, double>> inside;
            for (const auto& segment : scene.primitives)
                for (const Vec<2>& p : segment)
                    if (node.box.contains(p)) inside.insert({p.x, p.y});
            ASSERT_GT(inside.size(), capacity);
        }
    }
}

}  // namespace
}  // namespace sightline
