// Images of the rasteriser against brute force, and against themselves: threads, vectors and order change nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/depth_image.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>

#include "core/base/error.h"
#include "core/base/workers.h"
#include "core/raster/band.h"
#include "tests/raster/raster_cases.h"
#include "tests/soak.h"
#include "tests/truth/image_judge.h"

namespace sightline::test {
namespace {

TEST(DepthImage, ShowsWhatRaysSeeButForWhatNobodyCanDecide) {
    for (int seed = 1; seed <= soak_count(2); ++seed)
        for (const RasterCase& c : raster_cases(static_cast<std::uint64_t>(seed))) {
            SCOPED_TRACE(testing::Message() << c.what << ' ' << seed);
            const DepthImage image = whole_image(c);
            const ImageJudge judge(c.scene, c.view, small_size);
            int covered = 0, wrong = 0;
            for (int y = 0; y < small_size.height; ++y)
                for (int x = 0; x < small_size.width; ++x) {
                    const auto along = judge.along(x, y);
                    const std::uint32_t met = along.empty() ? none : along[0], seen = image.ids[image.index(x, y)];
                    covered += met != none;
                    wrong += seen != met && !judge.undecided(seen, met, x, y);
                    if (seen == none) {
                        EXPECT_EQ(image.nearness[image.index(x, y)], 0);
                    }
                }
            EXPECT_EQ(wrong, 0);
            EXPECT_GT(covered, 200);
        }
}

TEST(DepthImage, ThreadsVectorsAndOrderChangeNothing) {
    if (!has_avx2()) GTEST_LOG_(INFO) << "no AVX2 here: one kind of vectors only";
    for (const RasterCase& c : raster_cases(9)) {
        SCOPED_TRACE(c.what);
        const DepthImage one = whole_image(c, {1, false});
        for (const RasterWork work : {RasterWork{1, true}, RasterWork{2, true}, RasterWork{5, false}, RasterWork{}})
            EXPECT_EQ(whole_image(c, work), one);
        std::vector<std::uint32_t> order(c.scene.primitives.size());
        std::iota(order.begin(), order.end(), 0u);
        Random random(3);
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
        DepthImage mixed(small_size);
        const auto part = std::span(order).first(order.size() / 3);
        draw_depth(mixed, c.scene, c.view, part);
        draw_depth(mixed, c.scene, c.view, std::span(order).subspan(part.size()), {2, false});
        EXPECT_EQ(mixed, one);
    }
}

/// The scene with every primitive once more behind the others.
RasterCase doubled(RasterCase c) {
    const auto once = c.scene.primitives;
    c.scene.primitives.insert(c.scene.primitives.end(), once.begin(), once.end());
    const auto sides = c.scene.two_sided;
    c.scene.two_sided.insert(c.scene.two_sided.end(), sides.begin(), sides.end());
    return c;
}

TEST(DepthImage, OfTwoThatCoincideTheOneOfTheLowestIdIsSeen) {
    for (const RasterCase& c : raster_cases(8)) {
        SCOPED_TRACE(c.what);
        EXPECT_EQ(whole_image(doubled(c)), whole_image(c));
        std::vector<std::uint32_t> backwards(2 * c.scene.primitives.size());
        std::iota(backwards.rbegin(), backwards.rend(), 0u);
        DepthImage image(small_size);
        const RasterCase twice = doubled(c);
        draw_depth(image, twice.scene, twice.view, backwards);
        EXPECT_EQ(image, whole_image(c));
    }
}

TEST(DepthImage, LayersAreWhatIsSeenWhenTheOnesBeforeAreTakenAway) {
    for (RasterCase c : raster_cases(4)) {
        SCOPED_TRACE(c.what);
        c = doubled(std::move(c));
        const std::vector<DepthImage> layers = draw_layers(c.scene, c.view, small_size, 5, {2, true});
        ASSERT_GE(layers.size(), 1u);
        ASSERT_LE(layers.size(), 5u);
        EXPECT_EQ(layers[0], whole_image(c));
        // Each primitive alone gives all that a pixel can show.
        std::vector<std::vector<std::pair<float, std::uint32_t>>> hits(layers[0].ids.size());
        for (std::uint32_t id = 0; id < c.scene.primitives.size(); ++id) {
            DepthImage alone(small_size);
            draw_depth(alone, c.scene, c.view, {&id, 1}, {1, true});
            for (std::size_t p = 0; p < hits.size(); ++p)
                if (alone.ids[p] == id) hits[p].emplace_back(-alone.nearness[p], id);
        }
        std::size_t deepest = 0;
        for (std::size_t p = 0; p < hits.size(); ++p) {
            std::sort(hits[p].begin(), hits[p].end());
            deepest = std::max(deepest, hits[p].size());
            for (std::size_t i = 0; i < layers.size(); ++i) {
                EXPECT_EQ(layers[i].ids[p], i < hits[p].size() ? hits[p][i].second : none);
                EXPECT_EQ(layers[i].nearness[p], i < hits[p].size() ? -hits[p][i].first : 0);
            }
        }
        EXPECT_EQ(layers.size(), std::clamp<std::size_t>(deepest, 1, 5));
    }
}

TEST(DepthImage, OccludersAreNowhereNearerThanTheyAre) {
    int covered = 0;
    for (int seed = 1; seed <= soak_count(2); ++seed)
        for (const RasterCase& c : raster_cases(static_cast<std::uint64_t>(seed))) {
            SCOPED_TRACE(testing::Message() << c.what << ' ' << seed);
            std::vector<std::uint32_t> some;
            for (std::uint32_t id = 0; id < c.scene.primitives.size(); id += 2) some.push_back(id);
            DepthImage image(small_size);
            draw_occluders(image, c.scene, c.view, some);
            const ImageJudge judge(c.scene, c.view, small_size);
            Random random(5);
            for (int y = 0; y < small_size.height; ++y)
                for (int x = 0; x < small_size.width; ++x) {
                    const float here = image.nearness[image.index(x, y)];
                    EXPECT_EQ(image.ids[image.index(x, y)], none);
                    if (here == 0) continue;
                    ++covered;
                    const double at_x = x + random.unit(), at_y = y + random.unit();
                    double nearest = 0;
                    for (const std::uint32_t id : some)
                        if (judge.covers(id, at_x, at_y)) nearest = std::max(nearest, judge.nearness(id, at_x, at_y));
                    EXPECT_GE(nearest * (1 + 1e-9), std::ldexp(here, 63)) << x << ' ' << y;
                }
        }
    EXPECT_GT(covered, 5000);
}

TEST(DepthImage, WhatIsSeenEdgeOnOrBehindTheEyeOrHasNoAreaIsNotThere) {
    Scene<3> scene;
    scene.primitives = {{Vec<3>(1, -1, 0), Vec<3>(3, 0, 0), Vec<3>(2, 1, 0)},       // edge-on
                        {Vec<3>(-1, -9, -9), Vec<3>(-1, 9, -9), Vec<3>(-1, 0, 9)},  // behind
                        {Vec<3>(2, 0, 0.1), Vec<3>(2, 1, 0.1), Vec<3>(2, 0.5, 0.1)},
                        {Vec<3>(2, 0, 1), Vec<3>(2, 0, 1), Vec<3>(2, 0, 1)},
                        {Vec<3>(-1, -1, 0), Vec<3>(1, 0, 0), Vec<3>(-1, 1, 0)}};  // through the eye
    scene.two_sided.assign(scene.primitives.size(), 1);
    EXPECT_EQ(whole_image({"", scene, raster_view({0, 0, 0}, {1, 0, 0}, 90)}), DepthImage(small_size));
    EXPECT_EQ(draw_layers(scene, raster_view({0, 0, 0}, {1, 0, 0}, 90), small_size, 4).size(), 1u);
}

TEST(DepthImage, AWallThatReachesBehindTheEyeFillsItsHalfOfTheImage) {
    Scene<3> scene;
    for (const double far : {1e6, 1e-3})
        for (const double height : {1.0, 1e-7}) {
            scene.primitives = {
                {Vec<3>(-far, -far, -height), Vec<3>(far * 100, -far, -height), Vec<3>(0, far * 99, -height)}};
            scene.two_sided = {1};
            const DepthImage image = whole_image({"", scene, raster_view({0, 0, 0}, {1, 0, 0}, 60)});
            const ImageJudge judge(scene, raster_view({0, 0, 0}, {1, 0, 0}, 60), small_size);
            int below = 0;
            for (int y = 0; y < small_size.height; ++y)
                for (int x = 0; x < small_size.width; ++x) {
                    const bool there = judge.covers(0, x + 0.5, y + 0.5);
                    if (judge.edge_distance(0, x + 0.5, y + 0.5) > 1.0 / 128) {
                        EXPECT_EQ(image.ids[image.index(x, y)] == 0, there) << x << ' ' << y << ' ' << far;
                    }
                    below += there;
                }
            EXPECT_EQ(below > 1000, far > 1 || height < 1e-3);
        }
}

TEST(DepthImage, AnImageOfAnySideIsDrawnAndOthersAreRefused) {
    const Scene<3> scene = soup(50, {0, 0, 0}, 1, 2);
    for (const ImageSize size : {ImageSize{1, 1}, ImageSize{1, 300}, ImageSize{700, 2}, ImageSize{33, 32}}) {
        DepthImage image(size);
        draw_depth(image, scene, raster_view({-2, 0, 0}, {0, 0, 0}, 60, size));
    }
    DepthImage image({20000, 1});
    EXPECT_THROW(draw_depth(image, scene, raster_view({-2, 0, 0}, {0, 0, 0}, 60)), WorkError);
}

TEST(Workers, DoEachPartOnceAndThrowOnWhatFails) {
    for (const int threads : {0, 1, 3}) {
        std::vector<std::atomic<int>> done(100);
        run_parts(100, threads, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
        for (const auto& d : done) EXPECT_EQ(d, 1);
        EXPECT_THROW(run_parts(100, threads,
                               [](int i) {
                                   if (i == 40) throw WorkError("part 40");
                               }),
                     WorkError);
        run_parts(0, threads, [](int) { FAIL(); });
    }
}

}  // namespace
}  // namespace sightline::test
