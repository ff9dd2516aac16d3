// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/solid_palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/draw/palette.h"

namespace sightline {
namespace {

TEST(SolidPalette, WhatStandsInOnePictureStaysApart) {
    using enum SolidLook;
    const std::vector<SolidLook> states{clean, enqueued, projected, unseen},
        differences{projected, only_here, only_there}, plain_triangles{plain, rest, fresh},
        told_triangles{rendered, missed, wasted, other, fresh};
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        const auto& looks = solid_styles(palette);
        ASSERT_EQ(looks.size(), static_cast<std::size_t>(SolidLook::count));
        std::set<std::string> names;
        for (const SolidStyle& style : looks) {
            EXPECT_TRUE(names.insert(style.name).second) << style.name;
            EXPECT_EQ(style.colour.a, 255) << style.name;
            EXPECT_GE(style.width_pt, 0.5) << style.name;
        }
        for (const auto& set : {states, differences, plain_triangles, told_triangles})
            for (const SolidLook a : set)
                for (const SolidLook b : set) {
                    if (a >= b) continue;
                    const Colour p = looks[static_cast<std::size_t>(a)].colour,
                                 q = looks[static_cast<std::size_t>(b)].colour;
                    // Light makes all of a look lighter or darker: hues tell in colour, steps of grey in print.
                    const int apart = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
                    EXPECT_GE(apart, 30) << static_cast<int>(a) << " and " << static_cast<int>(b);
                    if (palette == Palette::print) {
                        EXPECT_GE(std::abs(lightness(p) - lightness(q)), 14)
                            << static_cast<int>(a) << " and " << static_cast<int>(b);
                    }
                }
    }
}

}  // namespace
}  // namespace sightline
