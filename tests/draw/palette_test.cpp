// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/palette.h"

#include <gtest/gtest.h>

#include "tests/draw/picture_support.h"

namespace sightline {
namespace {

using namespace test;

TEST(Palette, CellsStayApartWithoutColour) {
    // Those that stand in one picture.
    const std::vector<Look> by_state{Look::clean, Look::enqueued, Look::projected, Look::unseen};
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        const Colours& all = colours(palette);
        const auto& looks = all.looks;
        ASSERT_EQ(looks.size(), style_of(Look::count));
        const auto check = [&](Look a, Look b, bool papers_own) {
            const Style &first = looks[style_of(a)], &second = looks[style_of(b)];
            EXPECT_EQ(first.fill.a, 255);
            EXPECT_EQ(second.fill.a, 255);
            const double apart = std::abs(lightness(first.fill) - lightness(second.fill));
            const bool other_lines = first.hatch != second.hatch || first.stroke.a != second.stroke.a;
            EXPECT_TRUE(apart >= 20 || (papers_own && other_lines)) << first.name << " and " << second.name;
        };
        for (const Look a : by_state)
            for (const Look b : by_state)
                // The papers' own colours of states lie close together: a hatch or an outline helps.
                if (a < b) check(a, b, palette == Palette::paper && b <= Look::unseen);
        EXPECT_NE(looks[style_of(Look::enqueued)].hatch, Hatch::none);
        EXPECT_NE(looks[style_of(Look::unseen)].hatch, Hatch::none);
        EXPECT_NE(looks[style_of(Look::enqueued)].hatch, looks[style_of(Look::unseen)].hatch);
        // What only one of two runs projected lies over each state and leaves it to be seen.
        const Style &here = looks[style_of(Look::only_here)], &there = looks[style_of(Look::only_there)];
        EXPECT_EQ(here.fill.a, 0);
        EXPECT_GE(here.width_pt, 2);
        EXPECT_EQ(there.fill.a, 0);
        EXPECT_EQ(there.stroke.a, 0);
        EXPECT_NE(there.hatch, Hatch::none);
        for (const Look state : by_state) {
            const Style& below = looks[style_of(state)];
            EXPECT_TRUE(there.hatch != below.hatch || there.hatch_colour != below.hatch_colour) << below.name;
            for (const Colour& mark : {here.stroke, there.hatch_colour}) {
                const int apart = std::max({std::abs(mark.r - below.fill.r), std::abs(mark.g - below.fill.g),
                                            std::abs(mark.b - below.fill.b)});
                EXPECT_GE(apart, 80) << below.name;
            }
        }
        for (const Style& style : looks)
            if (style.stroke.a > 0) {
                EXPECT_GE(style.width_pt, 0.5) << style.name;
            }
        // A heat map grows lighter or darker all the way.
        const auto& heat = all.heat;
        for (std::size_t i = 2; i < heat.size(); ++i)
            EXPECT_GT((lightness(heat[i]) - lightness(heat[i - 1])) * (lightness(heat[1]) - lightness(heat[0])), 0);
    }
    EXPECT_NEAR(lightness({0, 0, 0}), 0, 1e-9);
    EXPECT_NEAR(lightness({255, 255, 255}), 100, 1e-6);
    EXPECT_NEAR(lightness({119, 119, 119}), 50.03, 0.01);
}

/// Lines that may stand beside each other: told apart by dash, width or lightness, and in colour by the colour.
TEST(Palette, LinesOfOneKindLookDifferentEvenInPrint) {
    const std::vector<std::vector<Look>> kinds{
        {Look::seed, Look::selected, Look::last, Look::next, Look::only_here},
        {Look::rendered, Look::missed, Look::wasted, Look::other, Look::selected_primitive}};
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print})
        for (const std::vector<Look>& kind : kinds)
            for (const Look one : kind)
                for (const Look two : kind) {
                    if (one >= two) continue;
                    const auto& looks = colours(palette).looks;
                    const Style &a = looks[style_of(one)], &b = looks[style_of(two)];
                    const int apart = std::abs(a.stroke.r - b.stroke.r) + std::abs(a.stroke.g - b.stroke.g) +
                                      std::abs(a.stroke.b - b.stroke.b);
                    EXPECT_TRUE(a.dash != b.dash || std::abs(a.width_pt - b.width_pt) >= 0.6 || apart >= 120)
                        << a.name << " and " << b.name << " in " << words<Palette>[static_cast<std::size_t>(palette)];
                }
}

TEST(Palette, TextStandsOutFromWhatIsBehindIt) {
    EXPECT_NEAR(contrast({0, 0, 0}, {255, 255, 255}), 21, 1e-9);
    EXPECT_NEAR(contrast({118, 118, 118}, {255, 255, 255}), 4.54, 0.01);  // WCAG's own example of 4.5:1
    EXPECT_EQ(contrast({9, 90, 200}, {9, 90, 200}), 1);
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    session.seek(20);
    for (const Note<2>::Kind kind : {Note<2>::Kind::text, Note<2>::Kind::arrow, Note<2>::Kind::callout}) {
        Note<2> note;
        note.kind = kind;
        note.text = "x";
        session.notes.push_back(note);
    }
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        Settings settings = session.settings();
        settings.palette = palette;
        settings.label = CellNumber::solidity;
        session.change(settings);
        const DrawList list = make_picture(session);
        ASSERT_GT(list.labels.size(), 5u);
        for (const Label& label : list.labels) {
            const Colour behind = label.disc.value_or(label.halo);
            ASSERT_EQ(behind.a, 255);
            EXPECT_GE(contrast(label.colour, behind), 7) << label.text;
        }
        EXPECT_GE(contrast(colours(palette).ink, colours(palette).background), 7);
    }
}

}  // namespace
}  // namespace sightline
