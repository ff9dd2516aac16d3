// Nearest first, sorted by and by, against a sort of all.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/orders/nearest_first.h"

#include <gtest/gtest.h>

#include "tests/run/run_support.h"
#include "tests/scene/soup_scenes.h"
#include "tests/soak.h"

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
        std::vector<Shown> shown;
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
            if (shown[i] != Shown::unsure) {
                ASSERT_EQ(shown[i] == Shown::yes, shows(problem, order[i]));
            }
        }
    }
}

TEST(NearestFirst, IsASortOfAll) {
    for (int seed = 1; seed <= soak_count(40); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Scene<3> scene = seed % 2 ? soup(1 + random.below(9000), {0, 0, 0}, 1, random.bits())
                                  : coplanar(1 + random.below(3000), random.bits());
        if (seed % 3 == 0)  // many at the same distance
            for (auto& t : scene.primitives) t = scene.primitives[random.below(1 + scene.primitives.size() / 50)];
        if (seed % 5 == 0)  // most of them together, and one far away
            for (auto& corner : scene.primitives[0]) corner += Vec<3>(1e6, 0, 0);
        ViewSpec<3> spec;
        spec.eye = around(random, {0, 0, 0}, seed % 4 ? 2 : 300);
        spec.look_at = around(random, {0, 0, 0}, 1);
        expect_sorted(scene, make_view(spec, 4.0 / 3));
    }
}

TEST(NearestFirst, AlsoWhereSquaresLeaveTheRangeOfDoubles) {
    for (const double scale : {1e-100, 1e120}) {
        Scene<3> scene = soup(3000, {0, 0, 0}, 1, 5);
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
