// Labels and swatches, wherever they are put.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/label_place.h"

#include <gtest/gtest.h>

#include "core/draw/swatch.h"

namespace sightline {
namespace {

const Box<2> frame{{0, 0}, {100, 50}};

TEST(LabelPlace, TheAlignmentSaysOnWhichSideOfItsPointTheTextStands) {
    const LabelSize size{20, 5, 1, 0};
    Label label;
    const auto left_end = [&](TextAlign align) {
        label.align = align;
        return label_box(label, {50, 20}, size, frame).min;
    };
    EXPECT_EQ(left_end(TextAlign::centre), Vec<2>(39, 15));
    EXPECT_EQ(left_end(TextAlign::left), Vec<2>(49, 15));
    EXPECT_EQ(left_end(TextAlign::right), Vec<2>(29, 15));
}

TEST(LabelPlace, ADiscIsRoomForTheTextAndLabelsNearTheBorderMoveIn) {
    const Label label;
    const Box<2> disc = label_box(label, {99, 1}, {4, 3, 1, 8}, frame);
    EXPECT_EQ(disc.min, Vec<2>(84, 0));
    EXPECT_EQ(disc.max, Vec<2>(100, 16));
    const Box<2> wide = label_box(label, {99, 25}, {140, 5, 1, 0}, frame);
    EXPECT_EQ(wide.centre(), Vec<2>(50, 25)) << "what does not fit stands in the middle";
}

TEST(LabelPlace, ALeaderBeginsAtTheBorderOfTheLabel) {
    const Box<2> box{{40, 20}, {60, 30}};
    EXPECT_EQ(leader_start(box, {90, 25}), Vec<2>(60, 25));
    EXPECT_EQ(leader_start(box, {50, 0}), Vec<2>(50, 20));
    EXPECT_EQ(leader_start(box, {70, 45}), Vec<2>(55, 30)) << "through the nearer side";
    EXPECT_EQ(leader_start(box, {52, 26}), Vec<2>(52, 26)) << "a tip inside";
}

TEST(Swatch, FillsCrossesOrMarksItsBox) {
    const Box<2> box{{0, 0}, {18, 8}};
    LegendRow row;
    row.style.width_pt = 4;
    const auto of = [&](ShapeKind kind) {
        row.swatch = kind;
        return swatch_of(row, box, 10);
    };
    EXPECT_EQ(of(ShapeKind::polygon).points, (std::vector<Vec<2>>{{0, 0}, {18, 0}, {18, 8}, {0, 8}}));
    EXPECT_EQ(of(ShapeKind::polyline).points, (std::vector<Vec<2>>{{0, 4}, {18, 4}}));
    EXPECT_EQ(of(ShapeKind::arrow).size_pt, 12) << "a head that is wider than its line";
    EXPECT_EQ(of(ShapeKind::disc).points, (std::vector<Vec<2>>{{9, 4}}));
    EXPECT_DOUBLE_EQ(of(ShapeKind::ring).size_pt, 3.6);
}

}  // namespace
}  // namespace sightline
