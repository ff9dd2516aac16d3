// Nearest first, sorted by and by, against a sort of all.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/orders/nearest_first.h"

#include <gtest/gtest.h>

#include "tests/run/run_support.h"
#include "tests/soak.h"
#include "tests/space/random_cells.h"

namespace sightline::test {
namespace {

void expect_sorted(const Scene<3>& scene, const View<3>& view) {
    CellComplex<3> cells;
    Problem<3> problem;
    problem.scene = &scene;
    problem.cells = &cells;
    problem.view = view;
    std::vector<std::pair<double, std::uint32_t>> keys;
    for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
        const auto& t = scene.primitives[i];
        const Vec<3> d = (Vec<3>(0) + t[0] + t[1] + t[2]) / 3.0 - view.eye;
        keys.emplace_back(glm::dot(d, d), i);
    }
    std::sort(keys.begin(), keys.end());
    NearestFirst<3> nearest;
    for (int again = 0; again < 2; ++again) {
        nearest.begin(problem);
        std::vector<std::uint32_t> order;
        std::vector<Showing> shown;
        NearestFirst<3> copy;
        std::vector<std::uint32_t> of_copy;
        std::size_t before = 0;
        while (nearest.extend(order, shown)) {
            ASSERT_GT(order.size(), before);
            before = order.size();
            if (of_copy.empty()) copy = nearest, of_copy = order;
        }
        ASSERT_EQ(order.size(), keys.size());
        ASSERT_EQ(shown.size(), keys.size());
        while (copy.extend(of_copy, shown)) {
        }
        ASSERT_EQ(of_copy, order);
        for (std::size_t i = 0; i < order.size(); ++i) {
            ASSERT_EQ(order[i], keys[i].second) << i;
            if (shown[i] != Showing::unsure) {
                ASSERT_EQ(shown[i] == Showing::yes, shows(problem, order[i]));
            }
        }
    }
}

/// About the middle of the unit cube, every third seen from both sides.
Scene<3> mixed_scene(Random& random, std::size_t count) {
    Scene<3> scene;
    scene.primitives = random_triangles(random, count);
    for (std::size_t i = 0; i < count; ++i) scene.two_sided.push_back(i % 3 == 0);
    return scene;
}

TEST(NearestFirst, IsASortOfAll) {
    for (int seed = 1; seed <= soak_count(40); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Scene<3> scene = mixed_scene(random, 1 + random.below(9000));
        if (seed % 2 == 0)  // in one plane
            for (auto& t : scene.primitives)
                for (auto& corner : t) corner.z = 0.5;
        if (seed % 3 == 0)  // many at the same distance
            for (auto& t : scene.primitives) t = scene.primitives[random.below(1 + scene.primitives.size() / 50)];
        if (seed % 5 == 0)  // most of them together, and one far away
            for (auto& corner : scene.primitives[0]) corner += Vec<3>(1e6, 0, 0);
        ViewSpec<3> spec;
        for (int i = 0; i < 3; ++i) {
            spec.eye[i] = random.uniform(-1, 2) * (seed % 4 ? 1 : 300);
            spec.look_at[i] = random.unit();
        }
        expect_sorted(scene, make_view(spec, 4.0 / 3));
    }
}

TEST(NearestFirst, AlsoWhereSquaresLeaveTheRangeOfDoubles) {
    for (const double scale : {1e-100, 1e120}) {
        Random random(5);
        Scene<3> scene = mixed_scene(random, 3000);
        for (auto& t : scene.primitives)
            for (auto& corner : t) corner *= scale;
        scene.primitives[7][0] = Vec<3>(scale > 1 ? 1e155 : 1, 0, 0);
        ViewSpec<3> spec;
        spec.eye = Vec<3>(0.1, 0.2, 0.3) * scale;
        spec.look_at = Vec<3>(1, 0, 0) * scale;
        expect_sorted(scene, make_view(spec, 1));
    }
}

TEST(NearestFirst, OfNothingIsNothing) {
    ViewSpec<3> spec;
    spec.look_at = Vec<3>(1, 0, 0);
    expect_sorted({}, make_view(spec, 1));
}

}  // namespace
}  // namespace sightline::test
