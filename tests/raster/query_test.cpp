// Occlusion queries against brute force: never hidden what would be seen, and not much more.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/query.h"

#include <gtest/gtest.h>

#include "core/space/builders.h"
#include "tests/scene/soup_scenes.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

constexpr ImageSize asked{90, 70};

View<3> query_view(Random& random) {
    const double away = random.below(3) ? 1.6 : 0.3;
    return make_view({around(random, {0, 0, 0}, away), around(random, {0, 0, 0}, 0.2), random.uniform(30, 120)},
                     9.0 / 7);
}

/// Some walls with gaps.
DepthImage walls(Random& random, const View<3>& view) {
    Scene<3> scene = soup(25, {0, 0, 0}, 0.8, random.bits());
    scene.two_sided.assign(scene.primitives.size(), 1);
    DepthImage image(asked);
    draw_depth(image, scene, view);
    return image;
}

Box<3> some_box(Random& random) {
    Box<3> box;
    const double size = std::ldexp(1.0, -static_cast<int>(random.below(9)));
    const Vec<3> middle = around(random, {0, 0, 0}, 1);
    box.add(around(random, middle, size));
    box.add(around(random, middle, size));
    if (random.below(6) == 0) box.max[static_cast<int>(random.below(3))] = box.min.x;  // flat, or turned over
    const Box<3> given = box;
    for (int i = 0; i < 3; ++i) {
        box.min[i] = std::min(given.min[i], given.max[i]);
        box.max[i] = std::max(given.min[i], given.max[i]);
    }
    return box;
}

/// The image with triangles of points of the convex hull drawn over it; `hull`: a random point of it.
template <typename Hull>
DepthImage with_contents(DepthImage image, const View<3>& view, const Hull& hull) {
    Scene<3> scene;
    for (int i = 0; i < 8; ++i) scene.primitives.push_back({hull(), hull(), hull()});
    scene.two_sided.assign(scene.primitives.size(), 1);
    draw_depth(image, scene, view);  // with the lowest ids, so that they win where depths are equal
    return image;
}

/// Every pixel that the contents change is among the seen ones. The number of changed pixels.
int expect_conservative(const SeenShape& shape, const DepthImage& image, const DepthImage& changed) {
    const DepthPyramid pyramid(image);
    const ShapeSight sight = look_at(shape, image);
    const auto witness = find_seen(shape, image, pyramid);
    EXPECT_EQ(count_seen(shape, image, pyramid), sight.seen);
    EXPECT_EQ(witness.has_value(), sight.seen > 0);
    EXPECT_LE(sight.seen, sight.pixels);
    const auto shows = [&](int x, int y) {
        if (shape.everywhere) return true;
        for (const SeenFace& face : shape.faces)
            if (face.holds(x, y) && face.nearness(x, y) >= image.nearness[image.index(x, y)]) return true;
        return false;
    };
    if (witness) {
        EXPECT_TRUE(shows(witness->x, witness->y));
    }
    int changes = 0, missed = 0;
    std::vector<std::uint32_t> hidden_by;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::size_t at = image.index(x, y);
            const bool differs = changed.ids[at] != image.ids[at] || changed.nearness[at] != image.nearness[at];
            changes += differs;
            missed += differs && !shows(x, y);
            for (const SeenFace& face : shape.faces)
                if (!shows(x, y) && face.holds(x, y)) hidden_by.push_back(image.ids[at]);
        }
    EXPECT_EQ(missed, 0) << "of " << changes;
    std::sort(hidden_by.begin(), hidden_by.end());
    hidden_by.erase(std::unique(hidden_by.begin(), hidden_by.end()), hidden_by.end());
    std::erase(hidden_by, none);
    EXPECT_EQ(sight.hidden_by, hidden_by);
    return changes;
}

TEST(OcclusionQuery, ABoxIsNeverHiddenWhenWhatLiesInItWouldBeSeen) {
    Random random(1);
    int changed = 0, hidden = 0, everywhere = 0;
    for (int n = 0; n < soak_count(400); ++n) {
        SCOPED_TRACE(n);
        const View<3> view = query_view(random);
        const DepthImage image = walls(random, view);
        for (int k = 0; k < 4; ++k) {
            Box<3> box = some_box(random);
            if (k == 3) {  // close to the eye, beside it or around it
                box.min += view.eye - box.centre();
                box.max = glm::max(box.max + view.eye - box.centre(), box.min);
            }
            const SeenShape shape = seen_box(view, asked, box);
            const auto hull = [&] {
                Vec<3> p;
                for (int i = 0; i < 3; ++i) {
                    const auto where = random.below(3);
                    p[i] = where == 0 ? box.min[i] : where == 1 ? box.max[i] : random.uniform(box.min[i], box.max[i]);
                }
                return p;
            };
            changed += expect_conservative(shape, image, with_contents(image, view, hull)) > 0;
            hidden += !shape.faces.empty() && !find_seen(shape, image, DepthPyramid(image));
            everywhere += shape.everywhere;
        }
    }
    EXPECT_GT(changed, 300);
    EXPECT_GT(hidden, 50);
    EXPECT_GT(everywhere, 20);
}

TEST(OcclusionQuery, NeitherIsACellOfEitherTessellation) {
    Random random(2);
    int changed = 0, hidden = 0;
    for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree}) {
        TessellationSettings settings;
        settings.tessellation = kind;
        settings.error_bound = 0.2;
        const CellComplex<3> cells = build_cells(soup(120, {0, 0, 0}, 0.8, 3), settings);
        ASSERT_GT(cells.cell_count(), 20u);
        for (int n = 0; n < soak_count(60); ++n) {
            const View<3> view = query_view(random);
            const DepthImage image = walls(random, view);
            for (int k = 0; k < 8; ++k) {
                const auto cell = static_cast<std::uint32_t>(random.below(cells.cell_count()));
                const auto corners = cells.corners_of(cell);
                const auto hull = [&] {
                    Vec<3> p(0);
                    double rest = 1;
                    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
                        const double share = random.below(3) ? random.unit() * rest : 0;
                        p += cells.points[corners[i]] * share;
                        rest -= share;
                    }
                    return p + cells.points[corners.back()] * rest;
                };
                const SeenShape shape = seen_cell(view, asked, cells, cell);
                changed += expect_conservative(shape, image, with_contents(image, view, hull)) > 0;
                hidden += !shape.faces.empty() && !find_seen(shape, image, DepthPyramid(image));
            }
        }
    }
    EXPECT_GT(changed, 100);
    EXPECT_GT(hidden, 15);
}

TEST(OcclusionQuery, NorATriangleThatIsDrawn) {
    Random random(3);
    int changed = 0;
    for (int n = 0; n < soak_count(300); ++n) {
        const View<3> view = query_view(random);
        const DepthImage image = walls(random, view);
        const Scene<3> scene = n % 2 ? slivers(10, random.bits()) : soup(10, {0, 0, 0}, 1, random.bits());
        for (const Primitive<3>& triangle : scene.primitives) {
            Scene<3> one;
            one.primitives = {triangle};
            one.two_sided = {1};
            const SeenShape shape = seen_polygon(view, asked, triangle);
            DepthImage with = image;
            draw_depth(with, one, view);
            changed += expect_conservative(shape, image, with) > 0;
            // On one that coincides with it: the lower id wins.
            one.primitives.push_back(triangle);
            one.two_sided.push_back(1);
            DepthImage covered = image;
            const std::uint32_t second = 1;
            draw_depth(covered, one, view, {&second, 1});
            with = covered;
            draw_depth(with, one, view);
            expect_conservative(shape, covered, with);
        }
    }
    EXPECT_GT(changed, 500);
}

TEST(OcclusionQuery, AWallAcrossTheViewDoesNotHideWhatLiesInItsOwnPlane) {
    // Its depth is the same everywhere: but for the step of a float, rounding would decide.
    Random random(7);
    for (int n = 0; n < soak_count(100); ++n) {
        const double at = random.uniform(0.1, 3);
        const View<3> view = make_view({{-0.3, 0, 0}, {1, 0, 0}, 60}, 9.0 / 7);
        Scene<3> scene;
        for (int i = 0; i < 2; ++i)
            scene.primitives.push_back({Vec<3>(at, -9, -9), Vec<3>(at, 9 + i, -9), Vec<3>(at, 0, 9 + 3 * i)});
        scene.two_sided = {1, 1};
        DepthImage wall(asked);
        const std::uint32_t second = 1;
        draw_depth(wall, scene, view, {&second, 1});
        DepthImage with = wall;
        draw_depth(with, scene, view);
        EXPECT_GT(expect_conservative(seen_polygon(view, asked, scene.primitives[0]), wall, with), 1000);
        EXPECT_GT(expect_conservative(seen_box(view, asked, {{at, -9, -9}, {at + 1, 9, 9}}), wall, with), 1000);
    }
}

/// One over the distance at which the ray through a point of the image enters the box; 0 where it misses it.
double entered(const View<3>& view, const Box<3>& box, double x, double y) {
    const Vec<3> ray = view.corners[3] + (view.corners[2] - view.corners[3]) * (x / asked.width) +
                       (view.corners[0] - view.corners[3]) * (y / asked.height) - view.eye;
    double in = 0, out = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double a = (box.min[i] - view.eye[i]) / ray[i], b = (box.max[i] - view.eye[i]) / ray[i];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    return in <= out && in > 0 ? 1 / in : 0;
}

TEST(OcclusionQuery, CountsLittleMoreThanThePixelsWhoseRaysEnterTheBoxUnhindered) {
    Random random(4);
    double sure = 0, counted = 0;
    for (int n = 0; n < soak_count(150); ++n) {
        const View<3> view = query_view(random);
        const DepthImage image = walls(random, view);
        Box<3> box = some_box(random);
        if (box.contains(view.eye)) continue;
        const SeenShape shape = seen_box(view, asked, box);
        if (shape.everywhere) continue;
        std::uint32_t rays = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                rays += entered(view, box, x + 0.5, y + 0.5) > std::ldexp(image.nearness[image.index(x, y)], 63);
        const std::uint32_t ours = count_seen(shape, image, DepthPyramid(image));
        EXPECT_GE(ours, rays);
        sure += rays;
        counted += ours;
    }
    EXPECT_GT(sure, 10000);
    EXPECT_LT(counted, sure * 1.02);
}

TEST(DepthPyramid, EachBlockHasTheFarthestOfItsPixelsAlsoAfterMoreIsDrawn) {
    Random random(5);
    for (const ImageSize size : {ImageSize{90, 70}, ImageSize{8, 8}, ImageSize{1, 1}, ImageSize{65, 9}}) {
        DepthImage image(size);
        DepthPyramid pyramid(image);
        for (int round = 0; round < 20; ++round) {
            const int x = static_cast<int>(random.below(static_cast<std::uint64_t>(size.width))),
                      y = static_cast<int>(random.below(static_cast<std::uint64_t>(size.height)));
            const int right = std::min(size.width, x + 30), bottom = std::min(size.height, y + 30);
            for (int row = y; row < bottom; ++row)
                for (int column = x; column < right; ++column)
                    image.nearness[image.index(column, row)] += static_cast<float>(random.unit());
            constexpr int block = DepthPyramid::block;
            std::vector<std::uint32_t> changed;
            for (int row = y / block; row <= (bottom - 1) / block; ++row)
                for (int column = x / block; column <= (right - 1) / block; ++column)
                    changed.push_back(static_cast<std::uint32_t>(row * pyramid.levels[0].width + column));
            pyramid.update(image, changed);
            int side = DepthPyramid::block;
            for (const DepthPyramid::Level& level : pyramid.levels) {
                std::vector<float> brute(level.farthest.size(), std::numeric_limits<float>::infinity());
                for (int row = 0; row < size.height; ++row)
                    for (int column = 0; column < size.width; ++column) {
                        float& at = brute[static_cast<std::size_t>(row / side * level.width + column / side)];
                        at = std::min(at, image.nearness[image.index(column, row)]);
                    }
                EXPECT_EQ(level.farthest, brute);
                side *= 2;
            }
            EXPECT_EQ(pyramid.levels.back().farthest.size(), 1u);
        }
    }
}

}  // namespace
}  // namespace sightline::test
