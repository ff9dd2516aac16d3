// Which of the offers is taken, against a search through all of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/recommend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/random.h"

namespace sightline {
namespace {

Offer offer(double ms, double wrong, bool misses_nothing = false) {
    return {"layers", Tessellation::delaunay, {}, ms, wrong, misses_nothing};
}

TEST(Recommend, TheFastestThatIsRightEnoughElseTheRightest) {
    Random random(3);
    std::size_t right = 0;
    for (int round = 0; round < 500; ++round) {
        std::vector<Offer> offers;
        for (std::uint32_t i = random.below(12); i > 0; --i) {
            const double ms = random.below(20) == 0 ? std::nan("") : 1 + random.below(9);
            offers.push_back(offer(ms, 0.0005 * random.below(round % 2 ? 4 : 40), random.below(2) == 0));
        }
        const auto found = recommend(offers);
        bool any_right = false, any = false;
        for (const Offer& o : offers) {
            any |= !std::isnan(o.ms);
            any_right |= !std::isnan(o.ms) && o.wrong <= unseen_wrong;
        }
        ASSERT_EQ(found.has_value(), any);
        if (!any) continue;
        right += any_right;
        const Offer& taken = offers[*found];
        for (const Offer& o : offers) {
            if (std::isnan(o.ms)) continue;
            if (any_right) {
                EXPECT_LE(taken.wrong, unseen_wrong);
                EXPECT_FALSE(o.wrong <= unseen_wrong && o.ms < taken.ms);
                EXPECT_FALSE(o.ms == taken.ms && o.wrong < taken.wrong);
            } else {
                EXPECT_LE(taken.wrong, o.wrong);
                EXPECT_FALSE(o.wrong == taken.wrong && o.ms < taken.ms);
            }
            EXPECT_FALSE(o.ms == taken.ms && o.wrong == taken.wrong && o.misses_nothing && !taken.misses_nothing);
        }
    }
    EXPECT_GT(right, 100u);
    EXPECT_LT(right, 450u);
}

TEST(Recommend, NamesACloseSecond) {
    const auto offer = [](const char* variant, double ms, double wrong, double error = 0) {
        Offer made;
        made.variant = variant;
        made.ms = ms;
        made.wrong = wrong;
        made.error = error;
        return made;
    };
    std::vector<Offer> offers{offer("a", 10, 0), offer("a", 10, 0), offer("b", 10.9, 0.0009), offer("c", 9, 0.5),
                              offer("d", std::nan(""), 0)};
    EXPECT_EQ(close_second(offers, 0), 2u) << "another variant, right enough, measured";
    offers[2].ms = 11.1;
    EXPECT_EQ(close_second(offers, 0), std::nullopt);
    offers[2].error = 0.6;
    EXPECT_EQ(close_second(offers, 0), 2u) << "two standard errors are 1.2";
    offers[1].tessellation = Tessellation::tree;
    EXPECT_EQ(close_second(offers, 0), 1u) << "other cells, and faster";
    offers[0].error = std::nan("");
    offers[1].ms = 10.5;
    EXPECT_EQ(close_second(offers, 0), 1u) << "an error that is not known";
    EXPECT_EQ(close_second(offers, 3), std::nullopt) << "these take longer by more than the noise";
    offers[3].ms = 10;
    EXPECT_EQ(close_second(offers, 3), 0u) << "fewer wrong pixels, and the fastest of these";
}

TEST(Recommend, ViewCullingWhereNearlyAllIsVisible) {
    const double drawn[] = {100, 200}, most[] = {90, 190}, some[] = {95, 100}, unknown[] = {95, std::nan("")},
                 no[] = {0, 0};
    EXPECT_EQ(what_is_in_view(drawn, most), InView::nearly_all_visible);
    EXPECT_EQ(what_is_in_view(drawn, some), InView::much_hidden) << "in each frame";
    EXPECT_EQ(what_is_in_view(drawn, unknown), InView::much_hidden);
    EXPECT_EQ(what_is_in_view({}, {}), InView::much_hidden) << "nothing was measured";
    EXPECT_EQ(what_is_in_view(drawn, no), InView::nothing_visible);
    EXPECT_EQ(what_is_in_view(no, no), InView::nothing);
}

}  // namespace
}  // namespace sightline
