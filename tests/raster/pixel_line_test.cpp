// A line of pixels: any order draws the same, and what lies in a cell is never called hidden when it would be seen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/pixel_line.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/random.h"
#include "core/space/builders.h"
#include "core/truth/item_buffer.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

Vec<2> plane_point(Random& random, const Vec<2>& middle, double reach) {
    const double x = random.uniform(-reach, reach);
    return middle + Vec<2>(x, random.uniform(-reach, reach));
}

std::vector<Primitive<2>> some_segments(Random& random, std::size_t count) {
    std::vector<Primitive<2>> segments;
    while (segments.size() < count) {
        const Vec<2> middle = plane_point(random, {0, 0}, 1);
        segments.push_back({plane_point(random, middle, 0.4), plane_point(random, middle, 0.4)});
    }
    return segments;
}

View<2> plane_view(Random& random) {
    ViewSpec<2> spec;
    spec.eye = plane_point(random, {0, 0}, random.below(2) ? 2 : 0.5);
    spec.look_at = plane_point(random, {0, 0}, 0.3);
    spec.fov = random.below(3) ? random.uniform(20, 170) : 360;
    return make_view(spec);
}

constexpr int line_width = 400;

TEST(PixelLine, AnyOrderDrawsTheSameAsTheItemBuffer) {
    Random random(1);
    for (int n = 0; n < soak_count(100); ++n) {
        std::vector<Primitive<2>> segments = some_segments(random, 40);
        segments.push_back(segments[3]);  // two that coincide
        segments.push_back({segments[4][1], segments[4][0]});
        const View<2> view = plane_view(random);
        PixelLine line(view, line_width), mixed(view, line_width);
        draw_line(line, segments, view);
        EXPECT_EQ(line.ids, item_buffer(segments, view, line_width).ids);
        std::vector<std::uint32_t> order(segments.size());
        std::iota(order.begin(), order.end(), 0u);
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
        draw_line(mixed, segments, view, std::span(order).first(20));
        draw_line(mixed, segments, view, std::span(order).subspan(20));
        EXPECT_EQ(mixed, line);
    }
    EXPECT_THROW(PixelLine(plane_view(random), 0), InputError);
}

/// Every pixel that the contents change is among the seen ones. Whether there is one.
bool expect_conservative_line(const LineShape& shape, const PixelLine& line, const View<2>& view,
                              std::span<const Primitive<2>> contents) {
    PixelLine with = line;
    draw_line(with, contents, view);  // with the lowest ids, which win where depths are equal
    const LineSight sight = look_at(shape, line);
    EXPECT_EQ(find_seen(shape, line), sight.witness);
    EXPECT_EQ(sight.witness.has_value(), sight.seen > 0);
    bool changed = false;
    std::uint32_t seen = 0, covers = 0;
    for (int x = 0; x < line.width(); ++x) {
        const auto at = static_cast<std::size_t>(x);
        bool shows = shape.everywhere, covered = shape.everywhere;
        for (const LineShape::Piece& piece : shape.pieces)
            if (x >= piece.first && x < piece.end) {
                covered = true;
                shows |= piece.nearness(x) >= line.nearness[at];
            }
        seen += shows;
        covers += covered;
        const bool differs = with.ids[at] != line.ids[at] || with.nearness[at] != line.nearness[at];
        EXPECT_TRUE(shows || !differs) << "pixel " << x;
        changed |= differs;
        if (covered && !shows) {
            EXPECT_TRUE(std::binary_search(sight.hidden_by.begin(), sight.hidden_by.end(), line.ids[at]));
        }
    }
    EXPECT_EQ(seen, sight.seen);
    EXPECT_EQ(covers, sight.pixels);
    return changed;
}

TEST(PixelLine, ACellIsNeverHiddenWhenWhatLiesInItWouldBeSeen) {
    Random random(2);
    int changed = 0, hidden = 0, everywhere = 0;
    for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree}) {
        TessellationSettings settings;
        settings.tessellation = kind;
        settings.error_bound = 0.1;
        Scene<2> scene;
        scene.primitives = some_segments(random, 60);
        const CellComplex<2> cells = build_cells(scene, settings);
        ASSERT_GT(cells.cell_count(), 20u);
        for (int n = 0; n < soak_count(100); ++n) {
            const View<2> view = plane_view(random);
            PixelLine line(view, line_width);
            draw_line(line, some_segments(random, 12), view);
            for (int k = 0; k < 10; ++k) {
                const auto cell =
                    k == 0 ? locate(cells, view.eye) : static_cast<std::uint32_t>(random.below(cells.cell_count()));
                if (cell == none) continue;
                const auto corners = cells.corners_of(cell);
                std::vector<Vec<2>> polygon;
                for (const std::uint32_t corner : corners) polygon.push_back(cells.points[corner]);
                const auto hull = [&] {
                    if (random.below(2)) return polygon[random.below(polygon.size())];
                    const double a = random.unit(), b = random.unit() * (1 - a);
                    return polygon[0] * a + polygon[1] * b + polygon[2] * (1 - a - b);
                };
                std::vector<Primitive<2>> contents;
                for (int i = 0; i < 6; ++i) contents.push_back({hull(), hull()});
                const LineShape shape = seen_cell(view, line_width, cells, cell);
                changed += expect_conservative_line(shape, line, view, contents);
                hidden += !shape.pieces.empty() && !find_seen(shape, line);
                everywhere += shape.everywhere;
                if (k % 2) std::reverse(polygon.begin(), polygon.end());
                expect_conservative_line(seen_polygon(view, line_width, polygon), line, view, contents);
            }
        }
    }
    EXPECT_GT(changed, 200);
    EXPECT_GT(hidden, 200);
    EXPECT_GT(everywhere, 50);
}

TEST(PixelLine, ACellShowsInNoMorePixelsThanItsBorderDrawn) {
    Random random(3);
    double drawn = 0, counted = 0;
    for (int n = 0; n < soak_count(200); ++n) {
        const View<2> view = plane_view(random);
        const Vec<2> a = plane_point(random, {0, 0}, 1);
        const std::vector<Vec<2>> corners{a, a + Vec<2>(0.2, 0.05), a + Vec<2>(0.1, 0.3)};
        const LineShape shape = seen_polygon(view, line_width, corners);
        if (shape.everywhere) continue;
        PixelLine line(view, line_width), with;
        draw_line(line, some_segments(random, 12), view);
        with = line;
        const std::vector<Primitive<2>> border{
            {corners[0], corners[1]}, {corners[1], corners[2]}, {corners[2], corners[0]}};
        draw_line(with, border, view);
        for (std::size_t x = 0; x < with.ids.size(); ++x) drawn += with.nearness[x] != line.nearness[x];
        counted += look_at(shape, line).seen;
    }
    EXPECT_GT(drawn, 1000);
    EXPECT_LT(counted, drawn * 1.02);
}

}  // namespace
}  // namespace sightline::test
