// What no cell holds whole, against where its corners lie.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/outside.h"

#include <gtest/gtest.h>

#include "tests/run/cplp_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// The tessellation is convex: a primitive lies within it where all its corners do.
template <int D>
void is_told(std::uint64_t seed, int count) {
    Random random(seed);
    std::size_t outside = 0, inside = 0;
    for (int i = 0; i < count; ++i) {
        test::CplpCase<D> made = test::random_cplp_case<D>(random);
        made.settings.border = i % 3 == 0 ? Border::inflated : Border::none;
        made.cells = build_cells(made.scene, made.settings);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t id = 0; id < made.scene.primitives.size(); ++id) {
            const auto& corners = made.scene.primitives[id];
            if (std::any_of(corners.begin(), corners.end(),
                            [&](const Vec<D>& corner) { return locate(made.cells, corner) == none; }))
                expected.push_back(id);
        }
        ASSERT_EQ(reaching_outside<D>(made.cells, made.scene.primitives), expected) << i;
        if (i % 3 == 0) {
            ASSERT_TRUE(expected.empty()) << "an inflated border holds all";
        }
        outside += expected.size();
        inside += made.scene.primitives.size() - expected.size();
    }
    EXPECT_GT(outside, 30u);
    EXPECT_GT(inside, 30u);
}

TEST(Outside, InThePlaneItIsWhatHasACornerInNoCell) { is_told<2>(31, test::soak_count(60)); }
TEST(Outside, InSpaceItIsWhatHasACornerInNoCell) { is_told<3>(32, test::soak_count(30)); }

}  // namespace
}  // namespace sightline
