// Which side of a triangle the eye sees.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/scene/view.h"

namespace sightline {
namespace {

TEST(ViewFacing, TheFrontIsWhereTheCornersTurnCounterClockwise) {
    // Seen from above with x to the right and y up, the corners turn counter-clockwise.
    const Primitive<3> up{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)};
    const Primitive<3> down{up[0], up[2], up[1]};
    const View<3> above = make_view({{0.2, 0.2, 1}, {0.2, 0.3, 0}, 60}, 1);
    const View<3> below = make_view({{0.2, 0.2, -1}, {0.2, 0.3, 0}, 60}, 1);
    EXPECT_TRUE(faces(above, up));
    EXPECT_FALSE(faces(above, down));
    EXPECT_FALSE(faces(below, up));
    EXPECT_TRUE(faces(below, down));
}

TEST(ViewFacing, AnEyeInThePlaneSeesNeitherSideAndTheSmallestStepOutOfItSeesOne) {
    const Primitive<3> triangle{Vec<3>(0, 0, 1), Vec<3>(1, 0, 1), Vec<3>(0, 1, 1)};
    View<3> view = make_view({{5, 5, 1}, {0, 0, 1}, 60}, 1);
    EXPECT_FALSE(faces(view, triangle));
    EXPECT_FALSE(faces(view, {triangle[0], triangle[2], triangle[1]}));
    view.eye.z = std::nextafter(1.0, 2.0);
    EXPECT_TRUE(faces(view, triangle));
    view.eye.z = std::nextafter(1.0, 0.0);
    EXPECT_FALSE(faces(view, triangle));
}

}  // namespace
}  // namespace sightline
