// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/item_buffer.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using Ids = std::vector<std::uint32_t>;

View<2> see_round(const Vec<2>& eye) { return {eye, eye + Vec<2>(1, 0), 360, true, {}}; }
/// 90 degrees towards +x.
View<2> look_ahead(const Vec<2>& eye) {
    return {eye, eye + Vec<2>(1, 0), 90, false, {eye + Vec<2>(1, -1), eye + Vec<2>(1, 1)}};
}

std::vector<Primitive<2>> random_segments(Random& random, std::size_t count, std::uint64_t size) {
    const auto point = [&] { return Vec<2>(random.below(size), random.below(size)); };
    std::vector<Primitive<2>> scene;
    while (scene.size() < count) scene.push_back({point(), point()});
    return scene;
}

/// By exact arithmetic, pixel by pixel; for integers below 2^17. Rays through an end are left to the half-open rule.
Ids exact_buffer(const std::vector<Primitive<2>>& scene, const View<2>& view, int width) {
    using Integer = __int128;
    Ids ids;
    for (int i = 0; i < width; ++i) {
        const Vec<2> right = view.corners[0] - view.eye, left = view.corners[1] - view.eye;
        const Vec<2> ray = right * double(2 * (width - i) - 1) + left * double(2 * i + 1);
        const Integer x(ray.x), y(ray.y);
        Integer above = 0, below = 0;
        std::uint32_t owner = none;
        for (std::uint32_t k = 0; k < scene.size(); ++k) {
            Vec<2> a = scene[k][0] - view.eye, b = scene[k][1] - view.eye;
            if (cross(a, b) < 0) std::swap(a, b);
            const Integer turn(cross(a, b)), from_a = Integer(a.x) * y - Integer(a.y) * x;
            const Integer to_b = x * Integer(b.y) - y * Integer(b.x);
            if (turn == 0 || from_a < 0 || to_b <= 0) continue;
            if (owner == none || turn * below < above * (from_a + to_b)) owner = k, above = turn, below = from_a + to_b;
        }
        ids.push_back(owner);
    }
    return ids;
}

TEST(ItemBuffer, PixelsRunFromTheRightToTheLeft) {
    const std::vector<Primitive<2>> walls{{{{2, -1}, {2, 0}}}, {{{3, 3}, {3, -3}}}};
    EXPECT_EQ(item_buffer(walls, look_ahead({0, 0}), 8).ids, (Ids{1, 1, 0, 0, 1, 1, 1, 1}));
}

TEST(ItemBuffer, AnAllRoundViewHasFourLines) {
    const std::vector<Primitive<2>> box{{{{1, -1}, {1, 1}}},   {{{1, 1}, {-1, 1}}}, {{{-1, 1}, {-1, -1}}},
                                        {{{-1, -1}, {1, -1}}}, {{{2, 0}, {2, 5}}},  {{{-0.5, 0}, {-0.5, 0.5}}}};
    EXPECT_EQ(item_buffer(box, see_round({0, 0}), 16).ids, (Ids{0, 0, 0, 0, 1, 1, 1, 1, 5, 5, 2, 2, 3, 3, 3, 3}));
}

TEST(ItemBuffer, AHiddenWallAndAGap) {
    const std::vector<Primitive<2>> walls{
        {{{4, -1}, {4, 1}}}, {{{2, -2}, {2, 0.9}}}, {{{2, 1.1}, {2, 2}}}, {{{5, 1}, {5, 4}}}};
    const ItemBuffer coarse = item_buffer(walls, look_ahead({0, 0}), 4),
                     fine = item_buffer(walls, look_ahead({0, 0}), 4000);
    EXPECT_EQ(visible_in(coarse, 4), (std::vector<std::uint8_t>{0, 1, 1, 0}));
    EXPECT_EQ(visible_in(fine, 4), (std::vector<std::uint8_t>{0, 1, 1, 1}));
    EXPECT_EQ(std::count(fine.ids.begin(), fine.ids.end(), 3u), 200);  // 0.2 of 4
    EXPECT_EQ(exact_visible_set(walls, look_ahead({0, 0})).visible, visible_in(fine, 4));
}

TEST(ItemBuffer, OnEqualDepthTheLowestIdWins) {
    const std::vector<Primitive<2>> walls{
        {{{3, 3}, {3, -3}}}, {{{2, 0}, {2, 2}}}, {{{2, 2}, {2, 0}}}, {{{2, -2}, {2, 2}}}};
    EXPECT_EQ(item_buffer(walls, look_ahead({0, 0}), 4).ids, (Ids{3, 3, 1, 1}));
}

TEST(ItemBuffer, SegmentsAreCutAtTheEyePlane) {
    const std::vector<Primitive<2>> walls{{{{-7, -1}, {9, -1}}}, {{{5, 1}, {-1, 1}}}};
    const Ids ids = item_buffer(walls, look_ahead({0, 0}), 8).ids;
    EXPECT_EQ(ids, (Ids{0, 0, 0, 0, none, 1, 1, 1}));
    const std::vector<Primitive<2>> beside{{{{0, -2}, {0, -1}}}, {{{-1, -2}, {-1, 2}}}, {{{0, 1}, {4, 1}}}};
    EXPECT_EQ(item_buffer(beside, look_ahead({0, 0}), 4).ids, (Ids{none, none, 2, 2}));
}

TEST(ItemBuffer, SegmentsThroughTheEyeAreNotDrawn) {
    const std::vector<Primitive<2>> walls{
        {{{0, 0}, {2, 0.3}}}, {{{-1, -1}, {1, 1}}}, {{{1, 0.5}, {2, 1}}}, {{{0, 0}, {0, 0}}}};
    EXPECT_EQ(item_buffer(walls, look_ahead({0, 0}), 4096).ids, Ids(4096, none));
    // All but through the eye.
    const std::vector<Primitive<2>> grazing{
        {{{-1, -0x1p-52}, {1, 0x1p-53}}}, {{{0.3, 0.1}, {0.9, 0.3}}}, {{{3, 3}, {3, -3}}}};
    for (const std::uint32_t id : item_buffer(grazing, look_ahead({0, 0}), 4096).ids) EXPECT_NE(id, none);
}

TEST(ItemBuffer, EveryPixelHasTheNearestPrimitive) {
    Random random(1);
    for (int i = 0; i < test::soak_count(3000); ++i) {
        SCOPED_TRACE(i);
        const auto scene = random_segments(random, 1 + random.below(12), 1 << 16);
        View<2> view;
        do
            view = {Vec<2>(random.below(1 << 16), random.below(1 << 16)),
                    {},
                    90,
                    false,
                    random_segments(random, 1, 1 << 16)[0]};
        while (orient(view.eye, view.corners[0], view.corners[1]) <= 0);
        ASSERT_EQ(item_buffer(scene, view, 64).ids, exact_buffer(scene, view, 64));
    }
}

TEST(ItemBuffer, GrowsToTheExactVisibleSet) {
    Random random(2);
    std::size_t coarse = 0, fine = 0, exact = 0;
    for (int i = 0; i < test::soak_count(60); ++i) {
        SCOPED_TRACE(i);
        auto scene = random_segments(random, 200, 1 << 16);
        for (auto& [a, b] : scene) b = a + glm::round((b - a) / 16.0);
        const Vec<2> eye(random.below(1 << 16), random.below(1 << 16));
        const View<2> view = i % 2 == 0 ? see_round(eye) : look_ahead(eye);
        const VisibleSet set = exact_visible_set(scene, view);
        std::vector<std::uint8_t> visible;
        for (const int width : {64, 1024, 1 << 18}) {
            visible = visible_in(item_buffer(scene, view, width), scene.size());
            for (std::size_t k = 0; k < scene.size(); ++k) ASSERT_LE(visible[k], set.visible[k]) << width << " " << k;
            if (width == 64) coarse += std::count(visible.begin(), visible.end(), 1);
        }
        fine += std::count(visible.begin(), visible.end(), 1);
        exact += set.count;
    }
    EXPECT_LT(coarse, exact * 9 / 10);
    EXPECT_GT(fine, exact * 999 / 1000);
}

TEST(ItemBuffer, AVisiblePieceOwnsThePixelsItCovers) {
    Random random(3);
    constexpr int width = 1 << 14;
    for (int i = 0; i < test::soak_count(100); ++i) {
        SCOPED_TRACE(i);
        const auto scene = random_segments(random, 20, 1 << 16);
        const View<2> view = look_ahead(Vec<2>(random.below(1 << 16), random.below(1 << 16)));
        const ItemBuffer buffer = item_buffer(scene, view, width);
        std::vector<double> expected(scene.size(), 0), pieces(scene.size(), 0);
        const auto pixel = [&](const Vec<2>& p) {
            const Vec<2> d = p - view.eye;
            return (1 + d.y / d.x) / 2 * width;
        };
        for (const VisiblePiece& piece : exact_visible_set(scene, view).pieces) {
            expected[piece.primitive] += pixel(piece.to) - pixel(piece.from);
            pieces[piece.primitive] += 1;
        }
        for (std::uint32_t k = 0; k < scene.size(); ++k)
            ASSERT_LE(std::abs(std::count(buffer.ids.begin(), buffer.ids.end(), k) - expected[k]), pieces[k] * 1.0001);
    }
}

TEST(ItemBuffer, DegenerateScenesAndScalesDoNoHarm) {
    Random random(4);
    for (int i = 0; i < test::soak_count(2000); ++i) {
        SCOPED_TRACE(i);
        auto scene = random_segments(random, 8, 5);
        View<2> view =
            i % 2 == 0 ? see_round({random.below(5), random.below(5)}) : look_ahead({random.below(5), random.below(5)});
        const Ids ids = item_buffer(scene, view, 256).ids;
        for (const std::uint32_t id : ids) ASSERT_TRUE(id < scene.size() || id == none);
        for (const int exponent : {-1000, -300, -3, 20, 200, 990}) {
            const double factor = std::ldexp(1.0, exponent);
            auto scaled = scene;
            for (auto& p : scaled)
                for (auto& v : p) v *= factor;
            View<2> scaled_view = view;
            scaled_view.eye *= factor;
            for (auto& v : scaled_view.corners) v *= factor;
            ASSERT_EQ(item_buffer(scaled, scaled_view, 256).ids, ids) << exponent;
        }
    }
}

TEST(ItemBuffer, RejectsWidthsItCannotServe) {
    EXPECT_THROW(item_buffer({}, look_ahead({0, 0}), 0), InputError);
    EXPECT_THROW(item_buffer({}, look_ahead({0, 0}), (1 << 24) + 1), InputError);
    EXPECT_THROW(item_buffer({}, see_round({0, 0}), 6), InputError);
    EXPECT_EQ(item_buffer({}, look_ahead({0, 0}), 3).ids, Ids(3, none));
}

}  // namespace
}  // namespace sightline
