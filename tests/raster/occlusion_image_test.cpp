// Images that are drawn a batch after the other, and boxes tested between: against brute force, in both dimensions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/occlusion_image.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/random.h"
#include "tests/raster/raster_cases.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

std::vector<std::uint32_t> mixed_ids(Random& random, std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
}

TEST(SnapPrimitives, IsBitForBitWhatSnapsThemOneByOne) {
    std::size_t snapped = 0;
    for (int seed = 1; seed <= soak_count(5); ++seed)
        for (const RasterCase& c : raster_cases(static_cast<std::uint64_t>(seed))) {
            SCOPED_TRACE(testing::Message() << c.what << ' ' << seed);
            Random random(static_cast<std::uint64_t>(seed));
            const auto ids = mixed_ids(random, c.scene.primitives.size());
            const ImageOf image(c.scene, c.view, small_size);
            SnappedTriangles expected;
            for (std::size_t i = 0; i < ids.size(); ++i) {
                std::vector<ImageCorner> corners;
                append_image_triangle(c.scene, c.view, image.plane, small_size, ids[i], corners);
                for (std::size_t k = 0; k < corners.size(); k += 3) {
                    FixedTriangle triangle;
                    if (!snap_triangle(&corners[k], small_size, triangle)) continue;
                    expected.triangles.push_back(triangle);
                    expected.place.push_back(static_cast<std::uint32_t>(i) + 7);
                }
            }
            snapped += expected.place.size();
            for (const bool best : {false, true}) {
                SnappedTriangles out;
                snap_primitives(image, ids, 7, best, out);
                EXPECT_EQ(out.place, expected.place);
                ASSERT_EQ(out.triangles.size(), expected.triangles.size());
                for (std::size_t i = 0; i < out.triangles.size(); ++i) {
                    const FixedTriangle &a = out.triangles[i], &b = expected.triangles[i];
                    EXPECT_TRUE(a.x == b.x && a.y == b.y && a.nearness == b.nearness && a.id == b.id) << i;
                }
            }
        }
    EXPECT_GT(snapped, 1000u);
}

/// Which primitives change the image when they are drawn one after the other.
std::vector<std::uint8_t> winners(const Scene<3>& scene, const View<3>& view, std::span<const std::uint32_t> order) {
    std::vector<std::uint8_t> won;
    DepthImage image(small_size);
    for (const std::uint32_t id : order) {
        const DepthImage before = image;
        draw_depth(image, scene, view, {&id, 1}, {1, false});
        won.push_back(image.ids != before.ids);
    }
    return won;
}

TEST(OcclusionImage, BatchesDrawTheImageAndSayWhoChangedIt) {
    OcclusionImage<3> drawing;
    for (const RasterCase& c : raster_cases(6)) {
        SCOPED_TRACE(c.what);
        Random random(2);
        const auto order = mixed_ids(random, c.scene.primitives.size());
        const auto expected = winners(c.scene, c.view, order);
        for (const RasterWork work : {RasterWork{1, false}, RasterWork{1, true}, RasterWork{2, true}}) {
            drawing.begin(c.scene, c.view, small_size, work);
            std::vector<std::uint8_t> won(order.size());
            for (std::size_t at = 0; at < order.size();) {
                const std::size_t count = std::min(order.size() - at, std::size_t{1} + random.below(90));
                drawing.draw(std::span(order).subspan(at, count), std::span(won).subspan(at, count));
                at += count;
                if (random.below(2)) drawing.refresh();
            }
            EXPECT_EQ(won, expected);
            EXPECT_EQ(drawing.image(), whole_image(c));
            drawing.refresh();
            for (std::size_t level = 0; level < drawing.pyramid().levels.size(); ++level)
                EXPECT_EQ(drawing.pyramid().levels[level].farthest,
                          DepthPyramid(drawing.image()).levels[level].farthest);
        }
    }
}

TEST(OcclusionImage, ManyTrianglesAtOnceAreDrawnBySeveralThreads) {
    const RasterCase c{"many", soup(5000, {0, 0, 0}, 1, 3), raster_view({-2, 0.2, 0.1}, {0, 0, 0}, 60)};
    std::vector<std::uint32_t> ids(c.scene.primitives.size());
    std::iota(ids.begin(), ids.end(), 0u);
    std::vector<std::uint8_t> one(ids.size()), two(ids.size());
    OcclusionImage<3> drawing;
    drawing.begin(c.scene, c.view, small_size, {1, true});
    drawing.draw(ids, one);
    EXPECT_EQ(drawing.image(), whole_image(c));
    drawing.begin(c.scene, c.view, small_size, {3, true});
    drawing.draw(ids, two);
    EXPECT_EQ(drawing.image(), whole_image(c));
    EXPECT_EQ(one, two);
    EXPECT_GT(std::accumulate(one.begin(), one.end(), 0), 50);
}

TEST(OcclusionImage, ABoxThatItCallsHiddenOrOutsideHoldsNothingThatChangesTheImage) {
    std::array<int, 3> said{};
    int unchanged = 0;
    OcclusionImage<3> drawing;
    for (int n = 0; n < soak_count(400); ++n) {
        Random random(static_cast<std::uint64_t>(n));
        const double scale = n % 3 == 0 ? 1e-5 : n % 3 == 1 ? 1 : 1e6;
        Scene<3> scene = soup(90, {0, 0, 0}, 1.2 * scale, random.bits());
        scene.two_sided.assign(scene.primitives.size(), 1);
        const View<3> view = raster_view(around(random, {0, 0, 0}, random.below(3) ? 2 : 0.2) * scale,
                                         around(random, {0, 0, 0}, 0.2) * scale, random.uniform(20, 150));
        drawing.begin(scene, view, small_size);
        std::vector<std::uint32_t> ids(scene.primitives.size());
        std::iota(ids.begin(), ids.end(), 0u);
        std::vector<std::uint8_t> won(ids.size());
        drawing.draw(ids, won);
        drawing.refresh();
        for (int k = 0; k < 8; ++k) {
            Box<3> box;
            const double size = std::ldexp(scale, -static_cast<int>(random.below(12)));
            const Vec<3> middle = k == 0 ? view.eye : around(random, {0, 0, 0}, 1.2 * scale);
            box.add(around(random, middle, size));
            box.add(around(random, middle, size));
            const BoxSight sight = drawing.look(box);
            ++said[static_cast<std::size_t>(sight)];
            Scene<3> inside;
            const auto point = [&] {
                Vec<3> p;
                for (int i = 0; i < 3; ++i) {
                    const std::uint64_t place = random.below(4);  // often in a corner
                    p[i] = place == 0   ? box.min[i]
                           : place == 1 ? box.max[i]
                                        : box.min[i] + (box.max[i] - box.min[i]) * random.unit();
                }
                return p;
            };
            for (int i = 0; i < 8; ++i) inside.primitives.push_back({point(), point(), point()});
            inside.two_sided.assign(inside.primitives.size(), 1);
            DepthImage image = drawing.image();
            draw_depth(image, inside, view);
            unchanged += image == drawing.image();
            if (sight != BoxSight::seen) {
                EXPECT_EQ(image, drawing.image()) << n << ' ' << k;
            }
        }
    }
    for (const int count : said) EXPECT_GT(count, 50);
    // Most of those that may be called so are.
    EXPECT_GT(said[0] + said[1], unchanged / 2);
}

TEST(OcclusionLine, SaysWhoChangedItAndHidesNothingThatWould) {
    std::array<int, 3> said{};
    OcclusionImage<2> drawing;
    for (int n = 0; n < soak_count(400); ++n) {
        Random random(static_cast<std::uint64_t>(n));
        const auto point = [&](const Vec<2>& middle, double reach) {
            const double x = random.uniform(-reach, reach);
            return middle + Vec<2>(x, random.uniform(-reach, reach));
        };
        Scene<2> scene;
        for (int i = 0; i < 30; ++i) {
            const Vec<2> middle = point({0, 0}, 1);
            scene.primitives.push_back({point(middle, 0.4), point(middle, 0.4)});
        }
        ViewSpec<2> spec;
        spec.eye = point({0, 0}, random.below(2) ? 2 : 0.4);
        spec.look_at = point({0, 0}, 0.3);
        spec.fov = random.below(3) ? random.uniform(20, 170) : 360;
        const View<2> view = make_view(spec);
        drawing.begin(scene, view, {402, 1});
        const auto order = mixed_ids(random, scene.primitives.size());
        std::vector<std::uint8_t> won(order.size()), expected;
        PixelLine line(view, drawing.image().width());
        for (const std::uint32_t id : order) {
            const PixelLine before = line;
            draw_line(line, scene.primitives, view, {&id, 1});
            expected.push_back(!(line == before));
        }
        drawing.draw(std::span(order).first(11), std::span(won).first(11));
        drawing.draw(std::span(order).subspan(11), std::span(won).subspan(11));
        EXPECT_EQ(won, expected);
        EXPECT_EQ(drawing.image(), line);
        drawing.refresh();
        for (int k = 0; k < 8; ++k) {
            Box<2> box;
            const double size = std::ldexp(1.0, -static_cast<int>(random.below(10)));
            const Vec<2> middle = k == 0 ? view.eye : point({0, 0}, 1.3);
            box.add(point(middle, size));
            box.add(k % 3 == 1 ? Vec<2>(box.min.x, middle.y) : point(middle, size));  // also one without a width
            const BoxSight sight = drawing.look(box);
            ++said[static_cast<std::size_t>(sight)];
            std::vector<Primitive<2>> inside;
            const auto within = [&] {
                Vec<2> p;
                for (int i = 0; i < 2; ++i) p[i] = box.min[i] + (box.max[i] - box.min[i]) * random.unit();
                return p;
            };
            for (int i = 0; i < 8; ++i) inside.push_back({within(), random.below(2) ? box.min : within()});
            PixelLine changed = line;
            draw_line(changed, inside, view);
            if (sight != BoxSight::seen) {
                EXPECT_EQ(changed.nearness, line.nearness) << n << ' ' << k;
            }
        }
    }
    for (const int count : said) EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace sightline::test
