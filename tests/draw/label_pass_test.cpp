// The pass that places labels as figures ask for it; viewer2d_canvas_test.cpp has it as the window does.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/label_pass.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace sightline {
namespace {

const Box<2> sheet{{0, 0}, {200, 150}};

/// A page of points, in whose font each letter is 5 wide.
LabelGround page() {
    LabelGround ground;
    ground.frame = sheet;
    ground.least_room = 2;
    ground.keep_apart = true;
    ground.to_paper = [](const Vec<2>& p) { return p; };
    ground.size = [](const Label& label, std::size_t form) -> std::optional<LabelSize> {
        const double width = 5.0 * static_cast<double>(label.text.size());
        if (form == 0) return LabelSize{width, 5, 1, label.disc ? 7.0 : 0};
        return form == 1 && label.note ? std::optional(LabelSize{width / 2, 10, 1, 0}) : std::nullopt;
    };
    return ground;
}

Label note(const Vec<2>& at, const std::string& text) {
    Label label;
    label.at = at;
    label.text = text;
    label.note = true;
    return label;
}

Label number(const Vec<2>& at) {
    Label label;
    label.at = at;
    label.text = "0.25";
    label.yields = true;
    return label;
}

Label badge(const Vec<2>& at) {
    Label label = note(at, "1");
    label.disc = Colour{};
    return label;
}

bool overlap(const Box<2>& a, const Box<2>& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

const StandingLabel* of(const std::vector<StandingLabel>& all, std::size_t label) {
    for (const StandingLabel& own : all)
        if (own.label == label) return &own;
    return nullptr;
}

TEST(LabelPass, BadgesAndNotesHaveTheirPlacesAndNumbersYield) {
    const std::vector<Label> labels{number({100, 70}), note({100, 70}, "a note"), badge({90, 70})};
    const auto all = stand_labels(labels, page(), {});
    ASSERT_TRUE(of(all, 2));
    EXPECT_EQ(of(all, 2)->box.centre(), Vec<2>(90, 70)) << "a badge stands where it points";
    ASSERT_TRUE(of(all, 1));
    EXPECT_TRUE(of(all, 1)->leader) << "the note moved and points back";
    EXPECT_FALSE(of(all, 0)) << "a number without room is left out";
}

TEST(LabelPass, AMovedNoteStandsNearAndItsLeaderIsClear) {
    const std::vector<Label> labels{badge({100, 70}), note({100, 70}, "something"), number({100, 90}),
                                    number({100, 50})};
    const auto all = stand_labels(labels, page(), {});
    const StandingLabel* const moved = of(all, 1);
    ASSERT_TRUE(moved);
    ASSERT_TRUE(moved->leader);
    EXPECT_FALSE(of(all, 0)->box.contains(moved->tip)) << "it ends at the badge that lies over its point";
    EXPECT_LT(glm::length(moved->tip - of(all, 0)->box.centre()), 14);
    EXPECT_LT(glm::length(moved->box.centre() - Vec<2>(100, 70)), 60);
}

TEST(LabelPass, WithoutRoomInOneLineANoteTakesSeveral) {
    LabelGround narrow = page();
    const std::string text(36, 'x');  // 180 of 200 wide
    const std::vector<Box<2>> taken{{{0, 0}, {95, 150}}, {{95, 60}, {200, 150}}};
    const auto all = stand_labels(std::vector<Label>{note({100, 100}, text)}, narrow, taken);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].form, 1u);
    const std::vector<Box<2>> full{{{0, 0}, {200, 150}}};
    EXPECT_TRUE(stand_labels(std::vector<Label>{note({100, 100}, text)}, narrow, full).empty()) << "no room at all";
}

TEST(LabelPass, TheWindowLetsThoseThatMustShowOverlap) {
    LabelGround ground = page();
    ground.keep_apart = false;
    const std::vector<Label> labels{note({100, 70}, "a note"), badge({100, 70}), number({100, 70})};
    const auto all = stand_labels(labels, ground, {});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].label, 0u) << "in their order";
    EXPECT_EQ(all[0].box.centre(), all[1].box.centre());
    EXPECT_FALSE(all[0].leader || all[1].leader);
}

TEST(LabelPass, FixedLabelsStayAndOthersKeepOff) {
    std::vector<Label> labels{note({100, 70}, "note"), note({100, 70}, "drawn")};
    labels[1].fixed = true;
    const auto all = stand_labels(labels, page(), {});
    EXPECT_EQ(of(all, 1)->box.centre(), Vec<2>(100, 70));
    EXPECT_FALSE(overlap(of(all, 0)->box, of(all, 1)->box));
}

TEST(LabelPass, NothingOverlapsInRandomCrowds) {
    Random random(5);
    std::size_t leaders = 0;
    for (int round = 0; round < 100; ++round) {
        std::vector<Label> labels;
        const auto anywhere = [&] { return Vec<2>(random.uniform(0, 200), random.uniform(0, 150)); };
        for (std::size_t i = random.below(6); i > 0; --i) labels.push_back(note(anywhere(), "some words"));
        for (std::size_t i = random.below(4); i > 0; --i) labels.push_back(badge(anywhere()));
        for (std::size_t i = random.below(30); i > 0; --i) {
            labels.push_back(number(anywhere()));
            labels.back().room = random.uniform(0, 20);
            labels.back().yields = random.below(5) > 0;
        }
        const std::vector<Box<2>> taken{{{150, 0}, {200, 30}}};
        const auto all = stand_labels(labels, page(), taken);
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_TRUE(sheet.contains(all[i].box.min) && sheet.contains(all[i].box.max));
            EXPECT_FALSE(overlap(all[i].box, taken[0]));
            leaders += all[i].leader;
            for (std::size_t k = 0; k < all.size(); ++k) {
                if (k == i) continue;
                EXPECT_FALSE(overlap(all[i].box, all[k].box));
                if (!all[i].leader) continue;
                const Vec<2> from = leader_start(all[i].box, all[i].tip);
                for (double t = 0; t <= 1; t += 0.02) {
                    const Vec<2> at = from + (all[i].tip - from) * t;
                    EXPECT_FALSE(overlap({at, at}, all[k].box)) << "a leader runs through a text";
                }
            }
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(leaders, 50u);
}

}  // namespace
}  // namespace sightline
