// Wrong pixels by distance, and how values are spread.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/distance.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/measure/summary.h"
#include "core/truth/software_ids.h"
#include "core/truth/truth.h"

namespace sightline {
namespace {

TEST(Distance, BinsArePowersOfTwoOfTheLongestSide) {
    EXPECT_EQ(distance_bin_end(0), 1 / 64.0);
    EXPECT_EQ(distance_bin_end(5), 0.5);
    EXPECT_EQ(distance_bin_end(6), 1);
    EXPECT_TRUE(std::isinf(distance_bin_end(7)));
}

/// Two walls across the view, the near one in front of the right half; the scene is 64 long.
TEST(Distance, InThePlaneIsWhereTheRayMeetsTheSegment) {
    Scene<2> scene;
    scene.primitives = {
        {Vec<2>(3, -64), Vec<2>(3, 0)}, {Vec<2>(40, -1), Vec<2>(40, 64)}, {Vec<2>(-24, 0), Vec<2>(-23, 0)}};
    const View<2> view = make_view(ViewSpec<2>{{0, 0}, {1, 0}, 60});
    const IdImage image = item_row(scene, view, {1000, 0});
    const auto bins = distance_bins_of<2>(image, scene, view);
    ASSERT_EQ(bins.size(), image.ids.size());
    // 128 is the longest side: 3 to 3.5 lies in [2, 4), 40 to 47 in [32, 64).
    for (std::size_t i = 0; i < bins.size(); ++i) EXPECT_EQ(bins[i], image.ids[i] == 0 ? 1 : 5) << i;
    Values values;
    std::vector<std::uint8_t> wrong(bins.size());
    for (std::size_t i = 0; i < wrong.size(); i += 4) wrong[i] = 1;
    count_distances(bins, wrong, values);
    EXPECT_NEAR(values.pixels_at[1], 0.5, 0.01);
    EXPECT_NEAR(values.wrong_at[5], 0.125, 0.01);
    EXPECT_DOUBLE_EQ(std::accumulate(values.wrong_at.begin(), values.wrong_at.end(), 0.0), 0.25);
    EXPECT_EQ(values.pixels_at[0], 0);
    // All round the same walls lie ahead, and the short one is seen edge-on: nothing is there.
    const View<2> round = make_view(ViewSpec<2>{{0, 0}, {1, 0}, 360});
    const IdImage all = item_row(scene, round, {4000, 0});
    const auto there = distance_bins_of<2>(all, scene, round);
    for (std::size_t i = 0; i < there.size(); ++i) {
        if (all.ids[i] == none) {
            EXPECT_EQ(there[i], no_bin);
            continue;
        }
        EXPECT_GE(there[i], all.ids[i] == 0 ? 1 : 5) << i;
    }
    EXPECT_EQ(there[499], 1) << "straight ahead, to the right";
    EXPECT_EQ(there[500], 5) << "straight ahead, to the left";
}

TEST(Distance, InSpaceIsThatOfThePointBehindThePixel) {
    Scene<3> scene;
    // A floor that runs from under the eye to the horizon.
    scene.primitives = {{Vec<3>(-64, -64, 0), Vec<3>(64, -64, 0), Vec<3>(64, 64, 0)},
                        {Vec<3>(-64, -64, 0), Vec<3>(64, 64, 0), Vec<3>(-64, 64, 0)}};
    const View<3> view = make_view(ViewSpec<3>{{0, 0, 2}, {10, 0, 1}, 60}, 4.0 / 3);
    const IdImage image = draw_ids_in_software(scene, view, {80, 60}, 1).front();
    const auto bins = distance_bins_of<3>(image, scene, view);
    std::size_t seen = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const auto at = static_cast<std::size_t>(y * 80 + x);
            if (image.ids[at] == none) {
                EXPECT_EQ(bins[at], no_bin);
                continue;
            }
            const Vec<3> ray = pixel_centre(view, {80, 60}, x, y) - view.eye;
            const double distance = std::sqrt(glm::dot(ray, ray)) * 2 / -ray.z;
            const double begin = bins[at] == 0 ? 0 : distance_bin_end(bins[at] - 1u);
            EXPECT_GE(distance, 128 * begin * (1 - 1e-9));
            EXPECT_LT(distance, 128 * distance_bin_end(bins[at]) * (1 + 1e-9));
            ++seen;
        }
    EXPECT_GT(seen, 1000u);
}

TEST(Summary, SpreadIsMeanAndQuartiles) {
    const Spread of_five = spread({5, 1, 2, 9, 3});
    EXPECT_DOUBLE_EQ(of_five.mean, 4);
    EXPECT_DOUBLE_EQ(of_five.lower_quartile, 2);
    EXPECT_DOUBLE_EQ(of_five.median, 3);
    EXPECT_DOUBLE_EQ(of_five.upper_quartile, 5);
    EXPECT_DOUBLE_EQ(quantile({1, 2}, 0.25), 1.25);
    EXPECT_DOUBLE_EQ(quantile({7}, 0.9), 7);
    EXPECT_EQ(quantile({3, 4}, 1), 4);
    EXPECT_TRUE(std::isnan(spread({}).mean) && std::isnan(spread({}).median));
}

}  // namespace
}  // namespace sightline
