// Four floats at once against one after the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/four_floats.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/random.h"

namespace sightline {
namespace {

using Four = std::array<float, 4>;

FourFloats load(const Four& four) { return FourColumns(&four, &four, &four, &four).x; }

/// Lane i of the result must be what `of` says of i, to the last bit; NaNs are all the same.
template <typename Of>
void expect_lanes(const FourFloats& result, Of of) {
    Four lanes;
    result.store(lanes.data());
    for (std::size_t i = 0; i < 4; ++i) {
        const float wanted = of(i);
        if (std::isnan(wanted))
            EXPECT_TRUE(std::isnan(lanes[i]));
        else
            EXPECT_EQ(std::bit_cast<std::uint32_t>(lanes[i]), std::bit_cast<std::uint32_t>(wanted));
    }
}

TEST(FourFloats, ComputeAsFloatsDo) {
    Random random(1);
    const std::array<float, 6> odd{0.0f,
                                   -0.0f,
                                   std::numeric_limits<float>::infinity(),
                                   -std::numeric_limits<float>::infinity(),
                                   std::numeric_limits<float>::quiet_NaN(),
                                   1e-40f};
    for (int round = 0; round < 5000; ++round) {
        std::array<Four, 4> rows;
        for (Four& row : rows)
            for (float& value : row)
                value = random.below(8) == 0
                            ? odd[random.below(odd.size())]
                            : static_cast<float>(random.uniform(-1, 1) * std::pow(10, random.uniform(-9, 9)));
        const FourColumns columns(&rows[0], &rows[1], &rows[2], &rows[3]);
        const FourFloats &x = columns.x, &y = columns.y;
        const auto a = [&](std::size_t i) { return rows[i][0]; };
        const auto b = [&](std::size_t i) { return rows[i][1]; };
        expect_lanes(columns.z, [&](std::size_t i) { return rows[i][2]; });
        expect_lanes(columns.w, [&](std::size_t i) { return rows[i][3]; });
        expect_lanes(x + y, [&](std::size_t i) { return a(i) + b(i); });
        expect_lanes(x - y, [&](std::size_t i) { return a(i) - b(i); });
        expect_lanes(x * y, [&](std::size_t i) { return a(i) * b(i); });
        expect_lanes(x / y, [&](std::size_t i) { return a(i) / b(i); });
        expect_lanes(-x, [&](std::size_t i) { return -a(i); });
        expect_lanes(abs(x), [&](std::size_t i) { return std::abs(a(i)); });
        expect_lanes(sqrt(x), [&](std::size_t i) { return std::sqrt(a(i)); });
        expect_lanes(lesser(x, y), [&](std::size_t i) { return a(i) < b(i) ? a(i) : b(i); });
        expect_lanes(greater(x, y), [&](std::size_t i) { return a(i) > b(i) ? a(i) : b(i); });
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ((x < y) >> i & 1, a(i) < b(i));
            EXPECT_EQ((x > y) >> i & 1, a(i) > b(i));
            if (!std::isnan(a(i))) {
                EXPECT_EQ(x.signs() >> i & 1, std::signbit(a(i)));
            }
        }
    }
    const Four one{1, 2, 3, 4};
    expect_lanes(load(one) + 2.5f, [](std::size_t) { return 3.5f; });
}

}  // namespace
}  // namespace sightline
