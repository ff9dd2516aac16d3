// Planes in floats: what they say for sure of a triangle is what exact arithmetic says.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/facing.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "tests/scene/soup_scenes.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

TEST(FacingPlanes, SayForSureOnlyWhatIsSo) {
    std::array<std::size_t, 3> said{};
    for (int seed = 1; seed <= soak_count(40); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const double scale = std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
        const Vec<3> away = around(random, {0, 0, 0}, random.below(2) ? 1000 : 0) * scale;
        Scene<3> scene = seed % 2 ? soup(300, {0, 0, 0}, 1, random.bits()) : slivers(300, random.bits());
        if (seed % 2 == 0) scene.two_sided.clear();
        for (auto& triangle : scene.primitives)
            for (auto& corner : triangle) corner = corner * scale + away;
        std::vector<std::uint32_t> order(scene.primitives.size());
        std::iota(order.rbegin(), order.rend(), 0u);
        const FacingPlanes planes(scene, order);
        for (int k = 0; k < 20; ++k) {
            // Also eyes in the plane of a triangle, or a hair beside it.
            const auto& close = scene.primitives[random.below(scene.primitives.size())];
            const Vec<3> in_plane = close[0] + (close[1] - close[0]) * random.uniform(-2, 2) +
                                    (close[2] - close[0]) * random.uniform(-2, 2);
            const Vec<3> eye = k % 2 ? in_plane : away + around(random, {0, 0, 0}, 3) * scale;
            std::vector<SideSeen> facing(order.size() - 7);
            planes.tell(eye, 7, facing);
            for (std::size_t i = 0; i < facing.size(); ++i) {
                const std::uint32_t id = order[i + 7];
                const auto& t = scene.primitives[id];
                const bool both = !scene.two_sided.empty() && scene.two_sided[id];
                const bool seen = both || orient(t[0], t[1], t[2], eye) > 0;
                ++said[static_cast<std::size_t>(facing[i])];
                if (facing[i] == SideSeen::seen) {
                    ASSERT_TRUE(seen) << seed << ' ' << id;
                } else if (facing[i] == SideSeen::away) {
                    ASSERT_FALSE(seen) << seed << ' ' << id;
                }
            }
        }
    }
    EXPECT_GT(said[0], 20'000u);
    EXPECT_GT(said[1], 100u);
    EXPECT_GT(said[2], 20'000u);
    EXPECT_LT(said[1], said[0] / 4) << "hardly anything is sure";
}

}  // namespace
}  // namespace sightline::test
