// Parts of cars: what the generators say against where the primitives lie and what is seen of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/car_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/read/load.h"
#include "core/scene/view.h"
#include "core/truth/visible_set.h"

namespace sightline {
namespace {

template <int D>
Vec<D> middle(const Primitive<D>& primitive) {
    Vec<D> sum(0);
    for (const Vec<D>& corner : primitive) sum += corner;
    return sum / static_cast<double>(D);
}

/// Mean y of a part of the cars that `take` takes.
template <int D, typename Take>
double mean_y(const Scene<D>& scene, const std::vector<CarPart>& parts, CarPart part, Take take) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Vec<D> at = middle<D>(scene.primitives[i]);
        if (parts[i] != part || !take(at)) continue;
        sum += at.y;
        ++count;
    }
    EXPECT_GT(count, 10);
    return sum / count;
}

TEST(CarParts, InPlanNobodySeesWhatTheShellsHide) {
    const Scene<2> scene = load_scene<2>("cars");
    const std::vector<CarPart> parts = car_parts(scene.seed);
    ASSERT_EQ(parts.size(), scene.primitives.size());
    std::array<int, 5> seen{};
    for (const Vec<2> eye : {Vec<2>(12, 8.5), Vec<2>(1, 8.5), Vec<2>(24, 8), Vec<2>(17, 0), Vec<2>(12, 30)}) {
        const ViewSpec<2> spec{eye, {12, 8}, 360};
        const auto visible = exact_visible_set(scene.primitives, make_view(spec)).visible;
        for (std::size_t i = 0; i < parts.size(); ++i) seen[static_cast<std::size_t>(parts[i])] += visible[i];
    }
    EXPECT_GT(seen[static_cast<std::size_t>(CarPart::none)], 0);
    EXPECT_GT(seen[static_cast<std::size_t>(CarPart::front)], 20);
    EXPECT_GT(seen[static_cast<std::size_t>(CarPart::back)], 20);
    EXPECT_EQ(seen[static_cast<std::size_t>(CarPart::engine)], 0);
    EXPECT_EQ(seen[static_cast<std::size_t>(CarPart::other)], 0);
}

TEST(CarParts, EnginesLieInFront) {
    const Scene<2> plan = load_scene<2>("cars");
    const std::vector<CarPart> parts = car_parts(plan.seed);
    for (const bool upper : {false, true}) {  // two rows, noses toward the lane between them, at y = 8.5
        const auto row = [&](const Vec<2>& at) { return (at.y > 8.5) == upper; };
        const double nose = std::abs(mean_y(plan, parts, CarPart::front, row) - 8.5);
        EXPECT_LT(nose + 1, std::abs(mean_y(plan, parts, CarPart::back, row) - 8.5));
        EXPECT_NEAR(nose, std::abs(mean_y(plan, parts, CarPart::engine, row) - 8.5), 0.7);
    }
    const Scene<3> hall = load_scene<3>("cars:10k");
    const std::vector<CarPart> solid = car_parts(hall.seed, 10'000);
    ASSERT_EQ(solid.size(), hall.primitives.size());
    for (int i = 0; i < 5; ++i) {  // beside each other, every other one turned round
        const auto car = [&](const Vec<3>& at) { return std::abs(at.x + 6 - 3 * i) < 1.5; };
        const double way = i % 2 == 0 ? 1 : -1;
        const double nose = way * mean_y(hall, solid, CarPart::front, car);
        EXPECT_LT(nose + 1.5, way * mean_y(hall, solid, CarPart::back, car));
        EXPECT_NEAR(nose, way * mean_y(hall, solid, CarPart::engine, car), 0.7);
    }
    for (std::size_t i = 0; i < solid.size(); ++i) {
        const Vec<3> at = middle<3>(hall.primitives[i]);
        EXPECT_EQ(solid[i] == CarPart::none, at.z == 0);
        EXPECT_TRUE(solid[i] != CarPart::engine || (at.z > 0.25 && at.z < 0.75)) << at.z;
    }
}

}  // namespace
}  // namespace sightline
