// Insets: what they show, and where they stand in figures.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/insets.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "core/base/file.h"
#include "core/draw/compose.h"
#include "core/draw/depth_picture.h"
#include "core/draw/depth_strip.h"
#include "core/draw/solid_list.h"
#include "core/measure/metrics.h"
#include "core/raster/query.h"
#include "shell/figure/cover.h"
#include "shell/figure/figure.h"
#include "shell/figure/inset.h"
#include "shell/figure/lay_out.h"
#include "tests/session/session_3d_support.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

TEST(Insets, ShowWhatIsRenderedAndWhatIsMissedAtThisStep) {
    Random random(71);
    std::size_t with_missed = 0;
    for (int i = 0; i < 30; ++i) {
        Session<3> session = test::random_frozen_session(random, test::random_start_3d(random));
        Settings settings = session.settings();
        for (const Inset asked : {Inset::off, Inset::image, Inset::missed, Inset::both, Inset::exact}) {
            settings.inset = asked;
            session.change(settings);
            const std::vector<Figure::Inset> insets = make_insets(session);
            std::size_t solids = 0, pictures = 0;
            for (const Figure::Inset& inset : insets) {
                ASSERT_NE(inset.solid == nullptr, inset.pixels == nullptr);
                if (inset.solid) {
                    ++solids;
                    EXPECT_EQ(inset.solid->triangles.size(),
                              asked == Inset::exact ? session.reference().count : session.counters().rendered_count);
                    EXPECT_EQ(inset.solid->camera.eye, session.culling_view().eye);
                } else {
                    ++pictures;
                    std::size_t red = 0;
                    for (const Colour& colour : inset.pixels->colours) red += colour.r > 0 && colour.g == 0 && colour.b == 0;
                    EXPECT_EQ(static_cast<double>(red) / static_cast<double>(inset.pixels->colours.size()),
                              wrong_pixels(session.reference(), session.met()));
                    with_missed += red > 0;
                }
            }
            EXPECT_EQ(solids, asked == Inset::off || asked == Inset::missed ? 0u : 1u);
            EXPECT_EQ(pictures, asked == Inset::missed || asked == Inset::both ? 1u : 0u);
        }
    }
    EXPECT_GT(with_missed, 5u);
}

TEST(Insets, DepthsAreThoseOfWhatIsRenderedAndMarkTheCell) {
    Random random(73);
    std::size_t with_hidden = 0, with_seen = 0, darker = 0;
    for (int i = 0; i < 30; ++i) {
        Session<3> session = test::random_frozen_session(random, test::random_start_3d(random));
        Settings settings = session.settings();
        settings.reference_size = {160, 120};
        settings.inset = Inset::depth;
        session.change(settings);
        session.run();
        session.selected_cell = session.selected_primitive = none;
        const std::vector<Figure::Inset> insets = make_insets(session);
        ASSERT_EQ(insets.size(), 1u);
        const Pixels& marked = *insets[0].pixels;
        DepthImage image(image_size<3>(settings.reference_size));
        draw_depth(image, session.scene(), session.problem().view, rendered_ids(session.met()));
        const bool is_marked = last_cell(session) != none;
        EXPECT_EQ(insets[0].title.find("covered") == std::string::npos, is_marked) << insets[0].title;

        // Grey where something is and no mark, the nearer the lighter; never lighter in the pyramid.
        settings.inset = Inset::pyramid;
        session.change(settings);
        const Pixels blocks = *make_insets(session).at(0).pixels;
        ASSERT_EQ(blocks.colours.size(), marked.colours.size());
        for (std::size_t at = 0; at < image.ids.size(); ++at) {
            const Colour& c = marked.colours[at];
            const bool grey = c.r == c.g && c.g == c.b;
            if (!grey) continue;
            ASSERT_NE(image.ids[at], none);
            ASSERT_LE(blocks.colours[at].r, c.r);
            darker += blocks.colours[at].r < c.r;
        }
        for (int k = 0; k < 5; ++k) {
            session.selected_cell = static_cast<std::uint32_t>(random.below(session.cells().cell_count()));
            const ShapeSight sight =
                look_at(seen_cell(session.problem().view, image.size(), session.cells(), session.selected_cell), image);
            with_seen += sight.seen > 0;
            with_hidden += sight.pixels > sight.seen;
            const DepthPicture picture = depth_picture(session, false);
            EXPECT_NE(picture.text.find(std::to_string(sight.seen) + " seen, " +
                                        std::to_string(sight.pixels - sight.seen) + " hidden"),
                      std::string::npos)
                << picture.text;
            std::size_t marks = 0;  // what is marked is neither grey nor the colour of nothing
            for (const Colour& c : picture.pixels.colours)
                marks += !(c.r == c.g && c.g == c.b) && !(c == Colour{22, 30, 66});
            EXPECT_EQ(marks, sight.pixels) << "cell " << session.selected_cell;
        }
    }
    EXPECT_GT(with_hidden, 3u);
    EXPECT_GT(with_seen, 3u);
    EXPECT_GT(darker, 0u);
}

TEST(Insets, TilesThatTheLastRoundDidNotReadAreDimmed) {
    Random random(74);
    std::size_t dimmed_tiles = 0;
    for (int i = 0; i < 10; ++i) {
        test::Start3 start = test::random_start_3d(random);
        start.settings.method = "cplp";
        start.settings.budget = {Budget::Kind::share, 0.05};
        apply_setting(start.settings, "test=item");
        Session<3> session = test::random_frozen_session(random, start);
        Settings settings = session.settings();
        settings.reference_size = {320, 200};
        session.change(settings);
        session.seek(0);
        EXPECT_TRUE(session.traversal().tiles().empty()) << "no round was made";
        session.run();
        session.selected_cell = session.selected_primitive = none;
        const auto tiles = session.traversal().tiles();
        ASSERT_EQ(tiles.size(), 20u);
        const DepthPicture picture = depth_picture(session, false);
        std::size_t read = 0;
        for (const auto& [tile, is_read] : tiles) {
            read += is_read;
            dimmed_tiles += !is_read;
            for (int y = tile.top + 1; y < tile.bottom; ++y)
                for (int x = tile.left + 1; x < tile.right; ++x) {
                    const Colour& c = picture.pixels.colours[static_cast<std::size_t>(y * 320 + x)];
                    const bool whole = (c.r == c.g && c.g == c.b) || c == Colour{22, 30, 66};
                    ASSERT_TRUE(is_read ? whole : c.b > c.r) << x << ", " << y;
                }
        }
        EXPECT_NE(picture.text.find(std::to_string(read) + " of 20 tiles read"), std::string::npos) << picture.text;
    }
    EXPECT_GT(dimmed_tiles, 10u);
}

TEST(Insets, NameSomeOfWhatHides) {
    const std::vector<std::uint32_t> ids{7, 9, 11, 12, 13};
    EXPECT_EQ(behind_text("segment", {}), "");
    EXPECT_EQ(behind_text("segment", std::span(ids).first(1)), " behind segment 7");
    EXPECT_EQ(behind_text("segment", std::span(ids).first(3)), " behind segments 7, 9 and 1 more");
    EXPECT_EQ(behind_text("segment", ids), " behind segments 7, 9 and 3 more");
}

TEST(Insets, PixelsResizedAreTheMeansOfThoseUnderThem) {
    Random random(72);
    for (int i = 0; i < 50; ++i) {
        Pixels pixels{1 + static_cast<int>(random.below(9)), 1 + static_cast<int>(random.below(9)), {}};
        for (int k = 0; k < pixels.width * pixels.height; ++k)
            pixels.colours.push_back({static_cast<std::uint8_t>(random.below(256)), 7, 255, 255});
        EXPECT_EQ(resized(pixels, pixels.width, pixels.height).colours, pixels.colours);
        const Pixels twice = resized(pixels, 2 * pixels.width, 3 * pixels.height);
        for (int y = 0; y < twice.height; ++y)
            for (int x = 0; x < twice.width; ++x) ASSERT_EQ(twice.at(x, y), pixels.at(x / 2, y / 3));
        EXPECT_EQ(resized(twice, pixels.width, pixels.height).colours, pixels.colours);
        const Pixels one = resized(pixels, 1, 1);
        double sum = 0;
        for (const Colour& colour : pixels.colours) sum += colour.r;
        EXPECT_NEAR(one.at(0, 0).r, sum / static_cast<double>(pixels.colours.size()), 0.5001);
        EXPECT_EQ(one.at(0, 0).g, 7);
    }
}

Figure figure_with_insets(Random& random) {
    test::Start3 start = test::random_start_3d(random);
    start.settings.inset = Inset::both;
    start.settings.legend = Legend::inside;
    start.settings.label = CellNumber::id;
    start.settings.label_where = LabelWhere::all;
    const Session<3> session = test::random_frozen_session(random, start);
    const PanelSource<3> panel{session, ""};
    return make_figure(std::span(&panel, 1));
}

FigureSize pixels(int width, int height) {
    FigureSize size;
    size.width_px = width;
    size.height_px = height;
    return size;
}

TEST(Insets, StandInTheirPanelApartFromEachOtherAndTheLegend) {
    Random random(73);
    std::size_t inside = 0;
    const Font font = find_font();
    for (int i = 0; i < 20; ++i) {
        const Figure figure = figure_with_insets(random);
        for (const FigureSize& size : {FigureSize{}, pixels(1200, 800), pixels(320, 240), pixels(900, 200)}) {
            const Layout layout = lay_out({&figure, 1}, size, font).front();
            const auto placed = place_insets(figure.panels[0], layout.panels[0], layout, font);
            ASSERT_EQ(placed.size(), 2u);
            for (const PlacedInset& inset : placed) {
                EXPECT_TRUE(layout.panels[0].frame.contains(inset.box, 1e-9));
                EXPECT_TRUE(inset.box.contains(inset.paper, 1e-9));
                EXPECT_LE(inset.title.width, inset.box.w);
                EXPECT_NEAR(inset.box.w / inset.box.h, figure.panels[0].insets[0].aspect, 1e-9);
                EXPECT_GT(inset.box.w, 0.2 * layout.panels[0].frame.w);
                if (layout.legend_box && size.width_px >= 1200) {
                    EXPECT_FALSE(layout.legend_box->overlaps(inset.box));
                    ++inside;
                }
            }
            EXPECT_FALSE(placed[0].box.overlaps(placed[1].box));
        }
    }
    EXPECT_GT(inside, 10u);
}

TEST(Insets, AreImagesOfTheFigureOverItsNumbers) {
    Random random(74);
    const fs::path file = fs::temp_directory_path() / ("sightline-inset-" + std::to_string(getpid()) + ".svg");
    Figure figure = figure_with_insets(random);
    Label label;
    label.at = figure.panels[0].list.world.max - Vec<2>(0.05);  // under an inset
    label.text = "hidden";
    label.yields = true;
    figure.panels[0].list.labels.push_back(label);
    const DrawSolid grey = [](const SolidList&, int width, int height, double) {
        return Pixels{width, height, std::vector<Colour>(static_cast<std::size_t>(width * height), {128, 128, 128})};
    };
    write_figure(figure, {}, file, grey);
    const std::string svg = read_file(file);
    fs::remove(file);
    std::size_t images = 0;
    for (std::size_t at = svg.find("<image"); at != std::string::npos; at = svg.find("<image", at + 1)) ++images;
    EXPECT_EQ(images, 3u);
    EXPECT_NE(svg.find(">the culling eye, so far</text>"), std::string::npos);
    EXPECT_NE(svg.find(">wrong pixels in red</text>"), std::string::npos);
    EXPECT_EQ(svg.find(">hidden</text>"), std::string::npos);
}

}  // namespace
}  // namespace sightline
