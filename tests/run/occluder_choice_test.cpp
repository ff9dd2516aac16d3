// Area-angles, the regions in which they are large, and who is found from where.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/methods/coorg_teller/choose_occluders.h"
#include "core/methods/coorg_teller/occluder_region.h"
#include "core/methods/coorg_teller/shadow.h"
#include "core/scene/make/catalogue.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

TEST(OccluderRegion, TheExtentsOfTheBrief) {
    // A square of area 2 that faces up; from the centre upward the region reaches R = √(A / t), sideways 0.620 R.
    const Box<3> box = occluder_region<3>({0, 0, 2}, {5, 6, 7}, 0.5, false);
    EXPECT_DOUBLE_EQ(box.max.z - 7, 2);
    EXPECT_DOUBLE_EQ(box.min.z, 7);
    EXPECT_NEAR(box.max.x - 5, 0.620403 * 2, 1e-5);
    EXPECT_NEAR(6 - box.min.y, 0.620403 * 2, 1e-5);
    EXPECT_DOUBLE_EQ(occluder_region<3>({0, 0, 2}, {5, 6, 7}, 0.5, true).min.z, 5);
    // 2D: a circle through the centre, of diameter length / t.
    const Box<2> circle = occluder_region<2>({0, 3}, {1, 1}, 0.5, false);
    EXPECT_DOUBLE_EQ(circle.max.y, 7);
    EXPECT_DOUBLE_EQ(circle.max.x, 4);
    EXPECT_DOUBLE_EQ(circle.min.y, 1);
}

template <int D>
Vec<D> any_point(Random& random, double reach) {
    Vec<D> p;
    for (int i = 0; i < D; ++i) p[i] = random.uniform(-reach, reach);
    return p;
}

/// Tight: some eyes near each face of the box exceed the threshold, none outside does.
template <int D>
void region_is_tight(std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
        const Vec<D> area = any_point<D>(random, 1), centre = any_point<D>(random, 1);
        const double threshold = random.uniform(0.01, 1);
        const bool both = random.below(2);
        const Box<D> box = occluder_region<D>(area, centre, threshold, both);
        const double reach = box.longest_side();
        Box<D> found;
        for (int k = 0; k < 4000; ++k) {
            Vec<D> eye = centre + any_point<D>(random, reach);
            const double value = area_angle<D>(area, centre, eye);
            if ((both ? std::abs(value) : value) < threshold) continue;
            found.add(eye);
            for (int axis = 0; axis < D; ++axis) {
                ASSERT_LE(eye[axis], box.max[axis] + 1e-9 * reach);
                ASSERT_GE(eye[axis], box.min[axis] - 1e-9 * reach);
            }
        }
        ASSERT_FALSE(found.empty());
        for (int axis = 0; axis < D; ++axis)
            EXPECT_GT(found.max[axis] - found.min[axis], 0.7 * (box.max[axis] - box.min[axis]));
        // The outline lies where the area-angle is the threshold.
        for (const Vec<D>& p : region_outline<D>(area, centre, threshold, any_point<D>(random, 1), 9))
            if (const Vec<D> away = p - centre; glm::dot(away, away) > 1e-6 * reach * reach) {
                EXPECT_NEAR(area_angle<D>(area, centre, p), threshold, 1e-6 * threshold);
            }
    }
}
TEST(OccluderRegion, IsTight2d) { region_is_tight<2>(91); }
TEST(OccluderRegion, IsTight3d) { region_is_tight<3>(92); }

Scene<2> scene_of(Random& random, Scene<2>) { return test::random_scene(random, 200); }
Scene<3> scene_of(Random& random, Scene<3>) { return test::random_scene_3d(random, 200); }

/// What the tree of regions finds is what asking every polygon finds, wherever the eye is.
template <int D>
void all_are_found(std::uint64_t seed, int count) {
    Random random(seed);
    std::size_t sum = 0;
    for (int i = 0; i < count; ++i) {
        const Scene<D> scene = scene_of(random, Scene<D>{});
        const double threshold = random.uniform(0.01, 0.5);
        const Prepared<D> prepared = prepare<D>(scene, random.below(2) ? TreeKind::kd : TreeKind::octree, 4, threshold);
        std::vector<Candidate> found;
        for (int k = 0; k < 40; ++k) {
            View<D> view;
            view.eye = any_point<D>(random, 2);
            view.all_round = true;
            const Vec<D>& eye = view.eye;
            found = potential_occluders<D>(prepared, scene, view);
            const std::size_t few = random.below(found.size() + 2);
            const auto first = potential_occluders<D>(prepared, scene, view, few);
            ASSERT_EQ(first.size(), std::min(few, found.size()));
            for (std::size_t i = 0; i < first.size(); ++i) ASSERT_EQ(first[i].polygon, found[i].polygon);
            std::vector<std::uint32_t> by_tree, by_hand;
            for (const Candidate& candidate : found) by_tree.push_back(candidate.polygon);
            for (std::uint32_t p = 0; p < prepared.polygons.size(); ++p) {
                double value = area_angle<D>(prepared.polygons.area[p], prepared.polygons.centre[p], eye);
                if (prepared.polygons.two_sided[p]) value = std::abs(value);
                if (value >= threshold && side_seen<D>(scene, prepared.polygons, p, eye) != 0) by_hand.push_back(p);
            }
            ASSERT_TRUE(std::is_sorted(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
                return a.area_angle > b.area_angle;
            }));
            std::sort(by_tree.begin(), by_tree.end());
            ASSERT_EQ(by_tree, by_hand);
            sum += by_hand.size();
        }
    }
    EXPECT_GT(sum, 100u);
}
TEST(OccluderChoice, AllAreFound2d) { all_are_found<2>(93, test::soak_count(20)); }
TEST(OccluderChoice, AllAreFound3d) { all_are_found<3>(94, test::soak_count(20)); }

/// Convex occluders: no polygon reaches before another's plane, each polygon is in one at most, and the shadow's sides
/// are a single ring as the eye sees them.
TEST(OccluderChoice, ConvexOccludersAreConvex) {
    std::size_t larger = 0, near = 0, all = 0;
    for (const char* id : {"blocks", "soda", "tetra"}) {
        const CatalogueRow<3>& row = *find_in_catalogue<3>(id);
        const Scene<3> scene = make_scene(row, row.triangles);
        const Prepared<3> prepared = prepare<3>(scene, TreeKind::kd, 8, 0.01);
        const Polygons<3>& polygons = prepared.polygons;
        for (std::size_t frame = 0; frame < scene.paths.front().frames.size(); frame += 60) {
            const Vec<3> eye = scene.paths.front().frames[frame].eye;
            const View<3> view = make_view(scene.paths.front().frames[frame], 1.5);
            const std::vector<Candidate> found = potential_occluders<3>(prepared, scene, view);
            near += prepared.near(eye).size();
            all += polygons.size();
            std::vector<std::uint8_t> taken(polygons.size());
            for (const auto& body : convex_occluders<3>(prepared, scene, eye, found, 16)) {
                larger += body.size() > 1;
                Shadow<3> shadow;
                make_shadow<3>(scene, polygons, body, eye, shadow);
                for (const std::uint32_t polygon : body) {
                    ASSERT_FALSE(taken[polygon]++);
                    for (const std::uint32_t other : body)
                        for (const std::uint32_t plane : polygons.planes_of(other))
                            for (const Vec<3>& corner : polygons.corners_of(polygon)) {
                                const Primitive<3>& t = scene.primitives[plane];
                                ASSERT_LE(orient(t[0], t[1], t[2], corner), 0);
                            }
                }
                // Each side ends where exactly one begins.
                for (const ShadowSide<3>& side : shadow.sides)
                    ASSERT_EQ(std::count_if(shadow.sides.begin(), shadow.sides.end(),
                                            [&](const ShadowSide<3>& next) { return next.a == side.b; }),
                              1);
            }
        }
    }
    EXPECT_GT(larger, 20u);
    EXPECT_LT(near, all / 2) << "the tree keeps most away";
}

}  // namespace
}  // namespace sightline
