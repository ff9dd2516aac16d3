// Item buffers against queries of each shape by itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/item_image.h"

#include <gtest/gtest.h>

#include "core/base/index.h"
#include "tests/raster/raster_cases.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

double nearness_at(const SeenShape& shape, const DepthImage& image, int x, int y) {
    double nearest = -1;
    for (const SeenFace& face : shape.faces)
        if (face.holds(x, y) && face.nearness(x, y) >= image.nearness[image.index(x, y)])
            nearest = std::max(nearest, face.nearness(x, y));
    return nearest;
}

TEST(ItemImage, ShowsAtEachPixelTheNearestOrTheLastShapeThatAQueryFindsThere) {
    Random random(71);
    std::size_t shown = 0, differ = 0;
    for (int i = 0; i < soak_count(20); ++i) {
        Scene<3> walls = soup(20, {0, 0, 0}, 0.8, random.bits());
        walls.two_sided.assign(walls.primitives.size(), 1);
        const View<3> view = raster_view(around(random, {0, 0, 0}, 1.6), {0, 0, 0}, 60);
        DepthImage image(small_size);
        draw_depth(image, walls, view);
        const DepthPyramid pyramid(image);
        std::vector<SeenShape> shapes;
        for (int k = 0; k < 12; ++k) {
            Box<3> box;
            const Vec<3> middle = around(random, {0, 0, 0}, 1);
            box.add(around(random, middle, 0.2));
            box.add(around(random, middle, 0.2));
            shapes.push_back(seen_box(view, small_size, box));
        }
        const auto nearest = draw_items(shapes, image, pyramid, ItemWins::nearest),
                   last = draw_items(shapes, image, pyramid, ItemWins::last);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                std::uint32_t near = none, late = none;
                double best = -1;
                for (std::uint32_t k = 0; k < shapes.size(); ++k) {
                    const double here = shapes[k].everywhere ? -0.5 : nearness_at(shapes[k], image, x, y);
                    if (here == -1) continue;
                    late = k;
                    if (here > best) {
                        best = here;
                        near = k;
                    }
                }
                ASSERT_EQ(nearest[image.index(x, y)], near) << x << ", " << y;
                ASSERT_EQ(last[image.index(x, y)], late) << x << ", " << y;
                shown += near != none;
                differ += near != late;
            }
        const TileGrid grid = tiles_of(image);
        for (std::uint32_t t = 0; t < grid.count(); ++t) {
            const Tile tile = grid.tile(t);
            bool shows = false;
            for (int y = tile.top; y < tile.bottom; ++y)
                for (int x = tile.left; x < tile.right; ++x) shows |= nearest[image.index(x, y)] != none;
            ASSERT_TRUE(!shows || tile_may_show(shapes, image, tile));
        }
    }
    EXPECT_GT(shown, 1000u);
    EXPECT_GT(differ, 100u);
}

TEST(ItemImage, ATileOutlivesWhatPassesItByLessThanTheMargin) {
    // A polygon whose right edge ends 2/128 of a pixel left of the centres of column 64, where the second tile begins.
    const View<3> view = raster_view({0, 0, 0}, {0, 0, 1}, 90, {128, 128});
    const ImageSize size{128, 128};
    for (const double beyond : {-4.0, 2.0, 100.0}) {  // in 1/128 pixels, short of that column's centres
        const auto at = [&](double column) { return (column / 64 - 1) * 1.0; };
        const double right = at(64.5 - beyond / 128);
        std::array<Vec<3>, 4> corners{{{at(20), -0.5, 1}, {right, -0.5, 1}, {right, 0.5, 1}, {at(20), 0.5, 1}}};
        DepthImage image(size);
        const std::vector<SeenShape> shapes{seen_polygon(view, size, corners)};
        const TileGrid grid = tiles_of(image);
        ASSERT_EQ(grid.count(), 4u);
        const auto owners = draw_items(shapes, image, DepthPyramid(image), ItemWins::nearest);
        // Seen from within, x may run either way: one of the two halves has it all.
        std::array<bool, 2> shows{}, may{};
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x)
                if (owners[image.index(x, y)] != none) shows[static_cast<std::size_t>(x / 64)] = true;
        for (std::uint32_t t = 0; t < 4; ++t)
            if (tile_may_show(shapes, image, grid.tile(t))) may[t % 2] = true;
        EXPECT_EQ(shows[0] && shows[1], beyond < 0) << beyond;
        EXPECT_EQ(may[0] && may[1], beyond < 100) << beyond;
    }
}

TEST(ItemImage, TilesCoverTheImageOnce) {
    for (const auto& [width, height] : {std::pair{1024, 768}, {100, 1}, {64, 64}, {65, 63}, {1, 1}}) {
        const TileGrid grid{width, height};
        std::size_t pixels = 0;
        for (std::uint32_t t = 0; t < grid.count(); ++t) pixels += grid.tile(t).pixels();
        EXPECT_EQ(pixels, static_cast<std::size_t>(width * height));
    }
}

}  // namespace
}  // namespace sightline::test
