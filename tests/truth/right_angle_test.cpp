// The borders of a view of 90 degrees are exact on whole numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/scene/view.h"
#include "core/truth/visible_set.h"
#include "tests/soak.h"
#include "tests/truth/brute_visibility.h"

namespace sightline {
namespace {

TEST(RightAngle, AWallThatOnlyTouchesTheBorderIsNotVisible) {
    const std::vector<Primitive<2>> walls{{Vec<2>(4, 5), Vec<2>(0, 7)}, {Vec<2>(8, 2), Vec<2>(3, 8)}};
    const View<2> view = make_view(ViewSpec<2>{{3, 6}, {4, 6}, 90});
    EXPECT_EQ(exact_visible_set(walls, view).count, 1u);
}

TEST(RightAngle, ScenesOfWholeNumbersAgreeWithBruteForce) {
    Random random(11);
    std::size_t slanted = 0, pieces = 0;
    for (int i = 0; i < test::soak_count(6000); ++i) {
        SCOPED_TRACE(i);
        const auto point = [&] { return Vec<2>(random.below(10), random.below(10)); };
        std::vector<Primitive<2>> walls;
        for (std::size_t k = 0; k < 2 + random.below(8); ++k) walls.push_back({point(), point()});
        ViewSpec<2> spec{point(), point(), 90};
        if (spec.eye == spec.look_at) spec.look_at.x += 1;
        const Vec<2> d = spec.look_at - spec.eye;
        slanted += d.x != 0 && d.y != 0;
        const View<2> exact{spec.eye,
                            spec.look_at,
                            90,
                            false,
                            {spec.eye + Vec<2>(d.x + d.y, d.y - d.x), spec.eye + Vec<2>(d.x - d.y, d.x + d.y)},
                            {}};
        const VisibleSet found = exact_visible_set(walls, make_view(spec));
        ASSERT_EQ(found.visible, brute::visibility<__int128>(walls, exact).visible);
        pieces += found.pieces.size();
    }
    EXPECT_GT(slanted, 2000u);
    EXPECT_GT(pieces, 2000u);
}

}  // namespace
}  // namespace sightline
