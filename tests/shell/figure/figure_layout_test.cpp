// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/text.h"
#include "shell/figure/lay_out.h"
#include "tests/shell/figure/figure_samples.h"
#include "tests/shell/figure/tidy.h"

namespace sightline {
namespace {

FigureSize in_pixels(int width, int height, double font = 8) {
    FigureSize size;
    size.width_px = width;
    size.height_px = height;
    size.font_pt = font;
    return size;
}

FigureSize millimetres(double width) {
    FigureSize size;
    size.width_mm = width;
    return size;
}

Layout lay_out_one(const Figure& figure, const FigureSize& size) {
    static const Font font = find_font();
    return lay_out({&figure, 1}, size, font).front();
}

TEST(FigureLayout, NothingOverlapsOrLeavesThePageOfRandomFigures) {
    Random random(7);
    int inside = 0, refused = 0;
    for (int i = 0; i < 600; ++i) {
        const Figure figure = random_figure(random);
        const FigureSize size = i % 2 == 0 ? millimetres(random.uniform(40, 200))
                                           : in_pixels(200 + static_cast<int>(random.below(1500)),
                                                       200 + static_cast<int>(random.below(1000)));
        try {
            const Layout layout = lay_out_one(figure, size);
            SCOPED_TRACE("figure " + std::to_string(i));
            test::expect_tidy(figure, layout);
            inside += layout.legend_box.has_value();
        } catch (const InputError&) {
            ++refused;
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(inside, 20);
    // Only small pages with long texts may be refused.
    EXPECT_LT(refused, 60);
}

TEST(FigureLayout, ThePageHasTheAskedSize) {
    const Layout mm = lay_out_one(sample_figure(1, LegendPlace::outside), millimetres(84));
    EXPECT_NEAR(mm.width, 84 * 72 / 25.4, 1e-9);
    const Layout px = lay_out_one(sample_figure(3, LegendPlace::outside), in_pixels(1280, 720, 14));
    EXPECT_DOUBLE_EQ(px.width, 960);
    EXPECT_DOUBLE_EQ(px.height, 540);
    EXPECT_DOUBLE_EQ(px.font_pt, 14);
}

TEST(FigureLayout, ContentStandsInTheMiddleOfAPageInPixels) {
    Figure figure = sample_figure(1, LegendPlace::off);
    const Layout layout = lay_out_one(figure, in_pixels(900, 300));
    const Rect& frame = layout.panels[0].frame;
    EXPECT_NEAR(frame.x, layout.width - frame.right(), 1e-9);
    EXPECT_NEAR(layout.panels[0].title_box.y, layout.height - layout.caption_box.bottom(), 1e-6);
}

TEST(FigureLayout, PanelsStandInARowWhenThereIsRoomAndWrapWhenNot) {
    const Layout wide = lay_out_one(sample_figure(3, LegendPlace::outside), millimetres(174));
    EXPECT_DOUBLE_EQ(wide.panels[0].frame.y, wide.panels[2].frame.y);
    EXPECT_GT(wide.panels[0].frame.w, 0.3 * wide.width);
    const Layout narrow = lay_out_one(sample_figure(3, LegendPlace::outside), millimetres(84));
    EXPECT_DOUBLE_EQ(narrow.panels[0].frame.y, narrow.panels[1].frame.y);
    EXPECT_GT(narrow.panels[2].frame.y, narrow.panels[0].frame.bottom());
    const Layout one = lay_out_one(sample_figure(1, LegendPlace::outside), millimetres(84));
    EXPECT_GT(one.panels[0].frame.w, 0.98 * one.width);
}

TEST(FigureLayout, PixelsGetTheLargestPanelsOfAnyArrangement) {
    for (const auto& [w, h] : {std::pair(1200, 400), std::pair(400, 1200), std::pair(900, 900)}) {
        Figure figure = sample_figure(4, LegendPlace::off);
        figure.caption.clear();
        for (Figure::Panel& panel : figure.panels) panel.title.clear();
        const FigureSize size = in_pixels(w, h);
        const Layout layout = lay_out_one(figure, size);
        const double side = layout.panels[0].frame.w, gap = 1.2 * size.font_pt;
        double best = 0;
        for (int columns = 1; columns <= 4; ++columns) {
            const int rows = (4 + columns - 1) / columns;
            best = std::max(best, std::min((layout.width - 2 * size.font_pt - (columns - 1) * gap) / columns,
                                           (layout.height - 2 * size.font_pt - (rows - 1) * gap) / rows));
        }
        EXPECT_NEAR(side, best, 1e-6);
    }
}

TEST(FigureLayout, LegendGoesToTheEmptiestCorner) {
    Figure figure = sample_figure(1, LegendPlace::inside);
    figure.bar.reset();
    for (const Vec<2>& corner : {Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(0, 1), Vec<2>(1, 1)}) {
        DrawList& list = figure.panels[0].list;
        list.shapes.clear();
        list.labels.clear();
        for (const Vec<2>& other : {Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(0, 1), Vec<2>(1, 1)})
            if (other != corner) list.add(ShapeKind::polyline, 6, {other, other * 0.6 + Vec<2>(0.2)});
        const Layout layout = lay_out_one(figure, millimetres(84));
        ASSERT_TRUE(layout.legend_box);
        const Vec<2> at = to_page(layout.panels[0], layout.scale, corner);
        EXPECT_LT(std::abs(layout.legend_box->x + layout.legend_box->w / 2 - at.x), layout.panels[0].frame.w / 2);
        EXPECT_LT(std::abs(layout.legend_box->y + layout.legend_box->h / 2 - at.y), layout.panels[0].frame.h / 2);
    }
}

TEST(FigureLayout, LegendOffShowsNeitherRowsNorBar) {
    const Layout layout = lay_out_one(sample_figure(2, LegendPlace::off), millimetres(84));
    EXPECT_TRUE(layout.legend.empty());
    EXPECT_FALSE(layout.bar);
    EXPECT_FALSE(layout.legend_box);
}

TEST(FigureLayout, WorldsWithoutAreaGiveFiniteFrames) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const Box<2>& world :
         {Box<2>{}, Box<2>{Vec<2>(3), Vec<2>(3)}, Box<2>{{1, 2}, {1, 5}}, Box<2>{{-inf, 0}, {inf, 1}},
          Box<2>{{nan, 0}, {1, 1}}, Box<2>{{-1e308, -1e308}, {1e308, 1e308}}, Box<2>{{0, 0}, {1e-300, 5e-324}},
          Box<2>{{1e300, 0}, {1e300, 0}}, Box<2>{{0, 0}, {1, 1e9}}}) {
        Figure figure = sample_figure(1, LegendPlace::outside);
        figure.panels[0].list.world = world;
        for (const FigureSize& size : {millimetres(84), in_pixels(640, 480)}) {
            const Layout layout = lay_out_one(figure, size);
            const Rect& frame = layout.panels[0].frame;
            for (const double value : {frame.x, frame.y, frame.w, frame.h, layout.scale, layout.height})
                EXPECT_TRUE(std::isfinite(value));
            EXPECT_GT(std::min(frame.w, frame.h), 1);
            EXPECT_TRUE((Rect{0, 0, layout.width, layout.height}.contains(frame, 1e-6)));
        }
    }
}

TEST(FigureLayout, PagesShareOneLayout) {
    std::vector<Figure> pages;
    for (int i = 0; i < 3; ++i) {
        Figure page = sample_figure(2, LegendPlace::outside);
        for (int k = 0; k < i * 12; ++k) page.caption += " and more";
        page.panels[1].title += i == 1 ? ", which takes a title that needs at least two lines to say it all" : "";
        page.legend[0].text += i == 2 ? " cells in the front" : "";
        page.panels[0].list.world.max = Vec<2>(1 + 0.2 * i, 1);
        pages.push_back(page);
    }
    const Font font = find_font();
    const std::vector<Layout> layouts = lay_out(pages, millimetres(84), font);
    ASSERT_EQ(layouts.size(), 3u);
    for (std::size_t p = 0; p < layouts.size(); ++p) {
        const Layout& layout = layouts[p];
        test::expect_tidy(pages[p], layout);
        EXPECT_DOUBLE_EQ(layout.height, layouts[0].height);
        EXPECT_DOUBLE_EQ(layout.scale, layouts[0].scale);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_DOUBLE_EQ(layout.panels[i].frame.x, layouts[0].panels[i].frame.x);
            EXPECT_DOUBLE_EQ(layout.panels[i].frame.y, layouts[0].panels[i].frame.y);
            EXPECT_DOUBLE_EQ(layout.panels[i].frame.w, layouts[0].panels[i].frame.w);
        }
        for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(layout.legend[i].swatch.y, layouts[0].legend[i].swatch.y);
        EXPECT_DOUBLE_EQ(layout.caption_box.y, layouts[0].caption_box.y);
    }
    EXPECT_GT(layouts[2].caption.size(), layouts[0].caption.size());
}

TEST(FigureLayout, ImpossibleSizesAreRefused) {
    const Figure figure = sample_figure(1, LegendPlace::outside);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double mm : {0.0, -84.0, 2000.1, nan, std::numeric_limits<double>::infinity()})
        EXPECT_THROW(lay_out_one(figure, millimetres(mm)), InputError) << mm;
    for (const auto& [w, h] : {std::pair(0, 100), std::pair(100, 0), std::pair(-1, -1), std::pair(20001, 10)})
        EXPECT_THROW(lay_out_one(figure, in_pixels(w, h)), InputError) << w << "x" << h;
    for (const double font : {0.0, -8.0, nan, 1e9})
        EXPECT_THROW(lay_out_one(figure, in_pixels(640, 480, font)), InputError);
    FigureSize size;
    size.dpi = nan;
    EXPECT_THROW(lay_out_one(figure, size), InputError);
    // Valid, but there is no room for the texts.
    EXPECT_THROW(lay_out_one(figure, in_pixels(8, 8)), InputError);
    EXPECT_NO_THROW(lay_out_one(figure, in_pixels(320, 240)));
}

TEST(FigureText, WrapsAtSpacesAndInsideLongWords) {
    const Font font = find_font();
    const std::string text =
        "a short line and anextraordinarilylongwordthatfitsnowhere\nnew paragraph \u03c1\u03c1\u03c1";
    std::string joined;
    for (const Line& line : wrap_text(font, text, 8, 60)) {
        EXPECT_LE(line.width, 60);
        EXPECT_NEAR(line.width, text_width(font, line.text) * 8, 1e-9);
        joined += line.text;
    }
    std::string letters;
    for (const char c : text)
        if (c != ' ' && c != '\n') letters += c;
    std::string kept;
    for (const char c : joined)
        if (c != ' ') kept += c;
    EXPECT_EQ(kept, letters);
}

TEST(FigureText, BrokenBytesAndControlCharactersAreReplaced) {
    EXPECT_EQ(clean_text("a\x01"
                         "b\xff"
                         "c\xc3"),
              "ab\uFFFDc\uFFFD");
    EXPECT_EQ(clean_text("\u03c1\t\u2229\U0001F600"), "\u03c1 \u2229\U0001F600");
    EXPECT_EQ(clean_text("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");
    EXPECT_EQ(code_points("\u03c1x\U0001F600"), U"\u03c1x\U0001F600");
}

TEST(FigureText, AMissingFontNamesItsPackage) {
    try {
        find_font("No Such Font");
        FAIL();
    } catch (const WorkError& error) {
        EXPECT_NE(std::string(error.what()).find("fonts-dejavu-core"), std::string::npos);
    }
}

}  // namespace
}  // namespace sightline
