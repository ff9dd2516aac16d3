// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/scene_filter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace sightline {
namespace {

std::vector<SceneChoice> choices() {
    return {{"city", "City", "Streets and houses.", "Scenes"},
            {"rooms", "Rooms", "Doors.", "Scenes"},
            {"cars", "Cars", "A car park.", "Scenes"},
            {"lesson plp", "PLP, cell by cell", "11 parts", "Lessons", "lesson plp"},
            {"freedoom1#E1M1", "freedoom1#E1M1", "A level of Freedoom.", "Doom levels"},
            {"freedoom1#E1M2", "freedoom1#E1M2", "A level of Freedoom.", "Doom levels"}};
}

using Rows = std::vector<std::vector<std::size_t>>;

TEST(SceneFilter, TakesWordsInAnyCaseFromNameTitleSentenceAndGroup) {
    EXPECT_EQ(scene_rows(choices(), "", 2).rows, (Rows{{0, 1}, {2}, {3}, {4, 5}}));
    EXPECT_EQ(scene_rows(choices(), "DOOM", 2).rows, (Rows{{4, 5}}));
    EXPECT_EQ(scene_rows(choices(), " level  m2 ", 2).rows, (Rows{{5}}));
    EXPECT_EQ(scene_rows(choices(), "lessons", 3).rows, (Rows{{3}}));
    EXPECT_EQ(scene_rows(choices(), "car", 3).rows, (Rows{{2}}));
    EXPECT_TRUE(scene_rows(choices(), "xyz", 3).rows.empty());
    EXPECT_EQ(scene_rows(choices(), "", 1).count(), 6u);
}

TEST(SceneFilter, ArrowsReachEverySceneAndStayInTheList) {
    Random random(3);
    for (const std::size_t columns : {1u, 2u, 3u}) {
        const SceneRows rows = scene_rows(choices(), "", columns);
        // Right goes through all of them, left back.
        SceneSpot spot;
        std::vector<std::size_t> order{rows.rows[0][0]};
        for (int i = 0; i < 5; ++i) {
            spot = moved_spot(rows, spot, 0, 1);
            order.push_back(rows.rows[spot.row][spot.column]);
        }
        EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
        EXPECT_EQ(moved_spot(rows, spot, 0, 1), spot);
        EXPECT_EQ(moved_spot(rows, spot, 0, -5), SceneSpot{});
        for (int i = 0; i < 200; ++i) {
            const auto by = [&] { return static_cast<int>(random.below(9)) - 4; };
            const SceneSpot to = moved_spot(rows, {random.below(9), random.below(9)}, by(), by());
            ASSERT_LT(to.row, rows.rows.size());
            ASSERT_LT(to.column, rows.rows[to.row].size());
        }
    }
    EXPECT_EQ(moved_spot(scene_rows(choices(), "", 2), {0, 1}, 1, 0), (SceneSpot{1, 0})) << "a shorter row";
    EXPECT_EQ(moved_spot({}, {3, 3}, 1, 1), SceneSpot{});
}

}  // namespace
}  // namespace sightline
