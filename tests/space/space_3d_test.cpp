// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/trig.h"
#include "core/space/builders.h"
#include "core/space/triangle_test.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"
#include "tests/space/space_support.h"

namespace sightline {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

Exact::Point_3 exact(const Vec<3>& p) { return {p.x, p.y, p.z}; }
Exact::Triangle_3 exact(const Primitive<3>& t) { return {exact(t[0]), exact(t[1]), exact(t[2])}; }

double volume(const CellComplex<3>& cells, std::uint32_t cell) {
    const auto corners = cells.corners_of(cell);
    const auto corner = [&](std::size_t i) { return cells.points[corners[i]]; };
    if (corners.size() == 8) {
        const Vec<3> extent = corner(7) - corner(0);
        return extent.x * extent.y * extent.z;
    }
    return glm::dot(glm::cross(corner(1) - corner(0), corner(2) - corner(0)), corner(3) - corner(0)) / 6;
}

bool sliver(const CellComplex<3>& cells, std::uint32_t cell) { return volume(cells, cell) < 1e-13; }

/// Settings of the tessellation only differ; small trees keep brute force cheap.
Settings settings_for(Random& random) {
    Settings settings = test::random_wide_settings(random);
    settings.error_bound = random.below(2) ? 0.3 : 0.13;
    return settings;
}

TEST(Space3, CellsAreLinkedBothWaysAndFillTheirBox) {
    Random random(31);
    for (int i = 0; i < test::soak_count(60); ++i) {
        const Scene<3> scene = test::random_scene_3d(random, random.below(60));
        const Settings settings = settings_for(random);
        const CellComplex<3> cells = build_cells(scene, settings);
        test::expect_linked(cells, sliver);
        double sum = 0;
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) sum += volume(cells, cell);
        const Vec<3> root = cells.tree.root_box().extent();
        const double side = root.x;
        if (cells.has_boxes()) {
            ASSERT_NEAR(sum, root.x * root.y * root.z, 1e-12);
        } else if (settings.border == Border::inflated) {
            ASSERT_NEAR(sum, std::pow(side * 1.1, 3), 1e-12);
        }
        if (cells.has_boxes() || settings.border == Border::inflated) {
            ASSERT_EQ(cells.unassigned, 0u);
        }
    }
}

TEST(Space3, TetrahedraArePositiveHaveEmptyCircumspheresAndAConvexBorder) {
    Random random(32);
    for (int i = 0; i < test::soak_count(24); ++i) {
        Settings settings;
        settings.jitter = i % 2 ? 0 : 0.02;
        settings.border = i % 3 ? Border::inflated : Border::none;
        settings.error_bound = 0.13;
        const CellComplex<3> cells = build_cells(test::random_scene_3d(random, 20), settings);
        std::vector<std::array<std::uint32_t, 4>> rows;
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            const auto c = cells.corners_of(cell);
            const auto corner = [&](std::size_t k) -> const Vec<3>& { return cells.points[c[k]]; };
            rows.push_back({c[0], c[1], c[2], c[3]});
            ASSERT_EQ(orient(corner(0), corner(1), corner(2), corner(3)), 1);
            for (const Vec<3>& p : cells.points)
                ASSERT_NE(CGAL::side_of_oriented_sphere(exact(corner(0)), exact(corner(1)), exact(corner(2)),
                                                        exact(corner(3)), exact(p)),
                          CGAL::ON_POSITIVE_SIDE);
            for (std::size_t k = 0; k < 4; ++k) {
                const HalfFacet& half = cells.facets_of(cell)[k];
                const auto facet = cells.points_of_facet(half.facet());
                ASSERT_EQ(std::find(facet.begin(), facet.end(), c[k]), facet.end());
                if (half.neighbour != none) continue;
                for (const Vec<3>& p : cells.points) ASSERT_GE(facet_side(cells, half, p), 0);
            }
        }
        ASSERT_TRUE(std::is_sorted(rows.begin(), rows.end()));
    }
}

TEST(Space3, TheOrderOfTheTrianglesDoesNotChangeTheCells) {
    Random random(33);
    Scene<3> scene = test::random_scene_3d(random, 200);
    for (const double jitter : {0.0, 0.02}) {
        Settings settings;
        settings.jitter = jitter;
        const CellComplex<3> before = tessellation(scene, settings);
        std::reverse(scene.primitives.begin(), scene.primitives.end());
        const CellComplex<3> after = tessellation(scene, settings);
        ASSERT_EQ(before.points, after.points);
        ASSERT_EQ(before.cell_points, after.cell_points);
        ASSERT_EQ(before.facet_points, after.facet_points);
    }
}

TEST(Space3, LocateFindsTheLowestCellThatHoldsThePoint) {
    Random random(34);
    for (int i = 0; i < test::soak_count(40); ++i) {
        const CellComplex<3> cells = build_cells(test::random_scene_3d(random, random.below(60)), settings_for(random));
        for (int query = 0; query < 50; ++query) {
            const auto coordinate = [&] { return random.uniform(-0.2, 1.2); };
            Vec<3> p(coordinate(), coordinate(), coordinate());
            if (cells.cell_count() > 0 && query % 3 == 0) p = cells.points[random.below(cells.points.size())];
            if (cells.facet_count() > 0 && query % 3 == 1) {
                const auto facet = cells.points_of_facet(static_cast<std::uint32_t>(random.below(cells.facet_count())));
                p = (cells.points[facet[0]] + cells.points[facet[1]]) * 0.5;
            }
            ASSERT_EQ(locate(cells, p), test::lowest_holding(cells, p));
        }
    }
}

bool meets(const CellComplex<3>& cells, std::uint32_t cell, const Exact::Triangle_3& triangle) {
    const auto corners = cells.corners_of(cell);
    const auto corner = [&](std::size_t i) { return exact(cells.points[corners[i]]); };
    if (corners.size() == 8) return CGAL::do_intersect(Exact::Iso_cuboid_3(corner(0), corner(7)), triangle);
    return CGAL::do_intersect(Exact::Tetrahedron_3(corner(0), corner(1), corner(2), corner(3)), triangle);
}

TEST(Space3, TrianglesGoToEveryCellTheyMeetAndToNoOther) {
    Random random(35);
    std::size_t met = 0, unassigned = 0;
    for (int i = 0; i < test::soak_count(100); ++i) {
        const Scene<3> scene = test::random_scene_3d(random, 1 + random.below(20));
        const CellComplex<3> cells = build_cells(scene, settings_for(random));
        std::vector<int> in_cells(scene.primitives.size());
        for (std::uint32_t p = 0; p < scene.primitives.size(); ++p) {
            const Primitive<3>& t = scene.primitives[p];
            if (CGAL::collinear(exact(t[0]), exact(t[1]), exact(t[2]))) continue;  // readers drop them
            const Exact::Triangle_3 triangle = exact(t);
            for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
                const auto assigned = cells.primitives_of(cell);
                const bool meeting = meets(cells, cell, triangle);
                ASSERT_EQ(std::count(assigned.begin(), assigned.end(), p), meeting);
                in_cells[p] += meeting;
            }
            met += static_cast<std::size_t>(in_cells[p]);
            unassigned += in_cells[p] == 0;
        }
    }
    EXPECT_GT(met, 4000u);
    EXPECT_GT(unassigned, 10u);
}

/// Every cell whose closure holds a point of a triangle lists the triangle. The points are exact: triangle and weights
/// have few bits.
TEST(Space3, NoPointOfATriangleIsUncovered) {
    Random random(36);
    std::size_t held = 0;
    for (int i = 0; i < test::soak_count(30); ++i) {
        const Scene<3> scene = test::random_scene_3d(random, 40);
        const CellComplex<3> cells = build_cells(scene, settings_for(random));
        for (std::uint32_t p = 0; p < scene.primitives.size(); ++p) {
            const auto& [a, b, c] = scene.primitives[p];
            for (int query = 0; query < 10; ++query) {
                const double u = static_cast<double>(random.below(65)) / 64;
                const double v = static_cast<double>(random.below(static_cast<std::uint64_t>(65 - 64 * u))) / 64;
                const Vec<3> point = a + (b - a) * u + (c - a) * v;
                for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
                    if (!test::holds(cells, cell, point)) continue;
                    const auto assigned = cells.primitives_of(cell);
                    ASSERT_TRUE(std::binary_search(assigned.begin(), assigned.end(), p));
                    ++held;
                }
            }
        }
    }
    EXPECT_GT(held, 10000u);
}

TEST(Space3, TrianglesOutsideTheHullAreCounted) {
    Random random(37);
    std::size_t outside = 0;
    for (int i = 0; i < test::soak_count(40); ++i) {
        const Scene<3> scene = test::random_scene_3d(random, 30);
        Settings settings;
        settings.border = Border::none;
        settings.error_bound = 0.3;
        const CellComplex<3> cells = build_cells(scene, settings);
        std::vector<bool> listed(scene.primitives.size());
        for (const std::uint32_t p : cells.cell_primitives) listed[p] = true;
        const auto missing = static_cast<std::size_t>(std::count(listed.begin(), listed.end(), false));
        ASSERT_EQ(cells.unassigned, missing);
        outside += missing;
    }
    EXPECT_GT(outside, 20u);
}

TEST(TriangleTest, NeverMissesATetrahedronOrABoxAndSaysWhenItLiesInside) {
    Random random(38);
    const auto grid = [&] { return Vec<3>(random.below(4), random.below(4), random.below(4)); };
    const auto free = [&] { return Vec<3>(random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4)); };
    std::size_t tried = 0, inside = 0, extra = 0;
    for (int i = 0; i < test::soak_count(20000); ++i) {
        const double scale = i % 5 == 4 ? std::ldexp(1.0, static_cast<int>(random.below(2000)) - 1000) : 1;
        const auto point = [&] { return (i % 2 ? free() : grid()) * scale; };
        std::array<Vec<3>, 4> tet{point(), point(), point(), point()};
        Primitive<3> t{point(), point(), point()};
        if (i % 3 == 0)
            for (Vec<3>& p : t) p = (tet[0] + tet[1] + tet[2] + tet[3]) * 0.25 + (p - t[0]) * 0.0625;
        if (i % 7 == 0) t[2] = t[1] + (t[0] - t[1]) * 1e-9 + Vec<3>(1e-12, 0, 0) * scale;
        if (i % 11 == 0) tet[3] = tet[0] + (tet[1] - tet[2]) * 0.5 + Vec<3>(0, 1e-12, 0) * scale;
        if (orient(tet[0], tet[1], tet[2], tet[3]) < 0) std::swap(tet[0], tet[1]);
        if (orient(tet[0], tet[1], tet[2], tet[3]) == 0 || CGAL::collinear(exact(t[0]), exact(t[1]), exact(t[2])))
            continue;
        ++tried;
        const TriangleTest test(t);
        const Exact::Tetrahedron_3 exact_tet(exact(tet[0]), exact(tet[1]), exact(tet[2]), exact(tet[3]));
        const TriangleTest::Contact contact = test.with(tet);
        const bool meets = CGAL::do_intersect(exact_tet, exact(t));
        ASSERT_TRUE(contact.meets || !meets) << i;
        extra += contact.meets && !meets && scale == 1;
        if (contact.meets && contact.reaches == 0) {
            for (const Vec<3>& p : t) ASSERT_TRUE(exact_tet.has_on_bounded_side(exact(p))) << i;
            ++inside;
        }
        Box<3> box;
        box.add(tet[0]);
        box.add(tet[1]);
        if (box.min.x == box.max.x || box.min.y == box.max.y || box.min.z == box.max.z) continue;
        const bool meets_box = CGAL::do_intersect(Exact::Iso_cuboid_3(exact(box.min), exact(box.max)), exact(t));
        ASSERT_TRUE(test.meets(box) || !meets_box) << i;
        extra += test.meets(box) && !meets_box && scale == 1;
    }
    EXPECT_GT(tried, 10000u);
    EXPECT_GT(inside, 100u);
    // Needles; and scales at which products overflow, which are not counted.
    EXPECT_LE(extra, static_cast<std::size_t>(test::soak_count(10)));
}

TEST(Space3, ScenesWithoutExtentHaveCellsInsideABorderOnly) {
    for (const std::size_t count : {0, 350'000}) {  // a million coincident vertices
        Scene<3> scene;
        scene.primitives.assign(count, {Vec<3>(5), Vec<3>(5), Vec<3>(5)});
        Settings settings;
        const CellComplex<3> inflated = build_cells(scene, settings);
        test::expect_linked(inflated, sliver);
        EXPECT_GT(inflated.cell_count(), 5u);
        EXPECT_EQ(inflated.unassigned, 0u);
        settings.border = Border::none;
        const CellComplex<3> hull = build_cells(scene, settings);
        EXPECT_EQ(hull.cell_count(), 0u);
        EXPECT_EQ(hull.unassigned, count);
        EXPECT_EQ(locate(hull, Vec<3>(5)), none);
        settings.tessellation = Tessellation::tree;
        const CellComplex<3> leaf = build_cells(scene, settings);
        EXPECT_EQ(leaf.cell_count(), 1u);
        EXPECT_EQ(leaf.count(0), count);
    }
}

TEST(Space3, FlatScenesAndSingleTrianglesHaveCells) {
    Random random(39);
    for (const std::size_t count : {50, 1}) {
        Scene<3> scene = test::random_scene_3d(random, count);
        for (Primitive<3>& t : scene.primitives)
            for (Vec<3>& p : t) p.z = 0.25;
        for (const Border border : {Border::inflated, Border::none}) {
            Settings settings;
            settings.border = border;
            const CellComplex<3> cells = build_cells(scene, settings);
            test::expect_linked(cells, sliver);
            EXPECT_GT(cells.cell_count(), 8u);
        }
    }
}

TEST(Space3, NeighboursOfLeavesAreThoseThatShareAFacetOrTouch) {
    Random random(44);
    for (int i = 0; i < test::soak_count(16); ++i) {
        const Scene<3> scene = test::random_scene_3d(random, random.below(30));
        Settings settings = settings_for(random);
        settings.error_bound = 0.3;
        settings.tessellation = i % 2 ? Tessellation::kd : Tessellation::tree;
        test::expect_neighbours_of_boxes(build_cells(scene, settings), settings.neighbours);
    }
}

TEST(Space3, KdLeavesAreSplitAtTheMedianAcrossTheLongestSide) {
    Random random(45);
    for (int i = 0; i < test::soak_count(30); ++i)
        test::expect_kd_rule<3>(test::random_scene_3d(random, 1 + random.below(60)).primitives,
                                random.uniform(0.05, 0.5), static_cast<std::uint32_t>(1 + random.below(5)));
}

TEST(Space3, ManyVerticesAtOnePlaceMakeNoCells) {
    // A fan about one corner, which every triangle has for itself.
    constexpr std::uint32_t count = 30000;
    Scene<3> scene;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto rim = [](std::uint32_t k) {
            const SinCos at = sincos_degrees(360.0 * k / count);
            return Vec<3>(at.cos, at.sin, 0.01 * (k % 3));
        };
        scene.primitives.push_back({Vec<3>(0), rim(i), rim(i + 1)});
    }
    for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree, Tessellation::kd}) {
        Settings settings;
        settings.tessellation = kind;
        const CellComplex<3> cells = build_cells(scene, settings);
        EXPECT_LT(cells.cell_count(), 30000u);
        EXPECT_EQ(cells.unassigned, 0u);
    }
}

TEST(Space3, MoreReferencesThanAllowedAreRefused) {
    Random random(41);
    const Scene<3> scene = test::random_scene_3d(random, 40);
    for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree, Tessellation::kd}) {
        Settings settings;
        settings.tessellation = kind;
        CellComplex<3> cells = build_cells(scene, settings);
        const std::size_t references = cells.cell_primitives.size();
        ASSERT_GT(references, 100u);
        assign_primitives(cells, scene.primitives, {}, references);
        EXPECT_EQ(cells.cell_primitives.size(), references);
        EXPECT_THROW(assign_primitives(cells, scene.primitives, {}, references - 1), InputError);
    }
}

TEST(Space3, TooManyReferencesAreForeseenAndNoOtherRefused) {
    Random random(43);
    const auto point = [&] { return Vec<3>(random.unit(), random.unit(), random.unit()); };
    for (const int large : {100, 90, 60, 30, 10, 1})  // per cent; the others are points, all but
        for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree}) {
            SCOPED_TRACE(large);
            Scene<3> scene;
            for (int i = 0; i < 3000; ++i) {
                const Vec<3> p = point();
                const bool tiny = random.below(100) >= static_cast<std::uint64_t>(large);
                scene.primitives.push_back(
                    {p, tiny ? p + Vec<3>(1e-6, 0, 0) : point(), tiny ? p + Vec<3>(0, 1e-6, 0) : point()});
            }
            Settings settings;
            settings.tessellation = kind;
            settings.error_bound = 0.3;
            CellComplex<3> cells = build_cells(scene, settings);
            const std::size_t references = cells.cell_primitives.size();
            assign_primitives(cells, scene.primitives, {}, references);
            ASSERT_EQ(cells.cell_primitives.size(), references);
            if (large < 60) continue;
            cells.unassigned = 77;  // who tries begins with 0
            EXPECT_THROW(assign_primitives(cells, scene.primitives, {}, references * 10 / (large < 90 ? 20 : 14)),
                         InputError);
            EXPECT_EQ(cells.unassigned, 77u);
        }
}

}  // namespace
}  // namespace sightline
