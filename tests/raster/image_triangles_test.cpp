// Triangles as an image shows them: cut alike along shared edges, in order, in parts of any size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/image_triangles.h"

#include <gtest/gtest.h>

#include "tests/scene/soup_scenes.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

constexpr ImageSize some_size{640, 480};

View<3> view_of(const Vec<3>& eye) { return make_view({eye, {0, 0, 0}, 70}, 4.0 / 3); }

std::vector<ImageCorner> all_of(const Scene<3>& scene, const View<3>& view, std::size_t limit = 1u << 30) {
    std::vector<ImageCorner> all, part;
    for (std::size_t next = 0; next < scene.primitives.size();) {
        part.clear();
        append_image_triangles(scene, view, some_size, next, limit, part);
        EXPECT_LE(part.size(), limit + 15);
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

bool same(const ImageCorner& a, const ImageCorner& b) { return a.x == b.x && a.y == b.y && a.nearness == b.nearness; }

TEST(ImageTriangles, PartsOfAnySizeAreTheWhole) {
    const Scene<3> scene = soup(500, {0, 0, 0}, 1, 1);
    const View<3> view = view_of({0.3, -0.2, 0.1});
    const std::vector<ImageCorner> whole = all_of(scene, view);
    EXPECT_GT(whole.size(), 300u);
    for (const std::size_t limit : {1u, 17u, 300u}) {
        const std::vector<ImageCorner> parts = all_of(scene, view, limit);
        ASSERT_EQ(parts.size(), whole.size());
        for (std::size_t i = 0; i < whole.size(); ++i)
            EXPECT_TRUE(same(parts[i], whole[i]) && parts[i].id == whole[i].id) << i;
    }
}

TEST(ImageTriangles, AreSortedByIdAndLieNearTheImageAndInFrontOfTheEye) {
    const Scene<3> scene = boxes_around_the_eye(1e-5, 1000, 2);
    const std::vector<ImageCorner> corners = all_of(scene, view_of({1e-6, 0, 0}));
    ASSERT_GT(corners.size(), 30u);
    ASSERT_EQ(corners.size() % 3, 0u);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        EXPECT_EQ(corners[i].id, corners[i / 3 * 3].id);
        EXPECT_GE(corners[i].id, corners[i == 0 ? 0 : i - 1].id);
        EXPECT_LE(std::max(std::abs(corners[i].x), std::abs(corners[i].y)), 2.00001f);
        EXPECT_GT(corners[i].nearness, 0);
        EXPECT_LE(corners[i].nearness, 1);
    }
}

TEST(ImageTriangles, NeighboursShareTheCornersOfTheirEdgeAlsoWhereItIsCut) {
    Random random(5);
    const View<3> view = view_of({0.1, 0.2, 0.3});
    int cut = 0;
    for (int i = 0; i < test::soak_count(3000); ++i) {
        const Vec<3> a = around(random, {0, 0, 0}, 3), b = around(random, {0, 0, 0}, 3);
        Scene<3> scene;
        scene.primitives = {{a, b, around(random, {0, 0, 0}, 3)}, {b, a, around(random, {0, 0, 0}, 3)}};
        scene.two_sided = {1, 1};
        const ImagePlane plane = image_plane(view);
        const Vec<3> edge = glm::cross(plane.project(a), plane.project(b));  // 0 times (x, y, 1) on its line
        const std::vector<ImageCorner> corners = all_of(scene, view);
        std::array<std::vector<ImageCorner>, 2> on_edge;
        for (const ImageCorner& c : corners) {
            const double off = glm::dot(edge, Vec<3>(c.x, -c.y, 1)) / std::hypot(edge.x, edge.y);
            if (std::abs(off) < 1e-6) on_edge[c.id].push_back(c);
        }
        if (on_edge[0].empty() || on_edge[1].empty()) continue;  // the other may cover no pixel
        cut += corners.size() > 6;
        for (const int side : {0, 1})
            for (const ImageCorner& c : on_edge[side])
                EXPECT_TRUE(std::any_of(on_edge[1 - side].begin(), on_edge[1 - side].end(),
                                        [&](const ImageCorner& other) { return same(c, other); }))
                    << "edge " << i;
    }
    EXPECT_GT(cut, 100);
}

TEST(ImageTriangles, SmallOnesBetweenTheCentresOfPixelsAreLeftOut) {
    // At distance 1 with a view of 90 degrees a pixel of 10 x 10 is 0.2 wide; centres lie at -0.9, -0.7, …
    const View<3> view = make_view({{-1, 0, 0}, {0, 0, 0}, 90}, 1);
    const auto drawn = [&](double y, double z, double half) {
        Scene<3> scene;
        scene.primitives = {{Vec<3>(0, y - half, z - half), Vec<3>(0, y + half, z - half), Vec<3>(0, y, z + half)}};
        scene.two_sided = {1};
        std::vector<ImageCorner> corners;
        std::size_t next = 0;
        append_image_triangles(scene, view, {10, 10}, next, 100, corners);
        return !corners.empty();
    };
    EXPECT_TRUE(drawn(0.1, 0.1, 0.01));
    EXPECT_FALSE(drawn(0.2, 0.1, 0.09));
    EXPECT_FALSE(drawn(0.1, 0.2, 0.09));
    EXPECT_TRUE(drawn(0.2, 0.2, 0.11));
    EXPECT_TRUE(drawn(0.9, -0.9, 0.01));
    EXPECT_FALSE(drawn(0.1, 0.113, 0.01));
    EXPECT_TRUE(drawn(0.1, 0.1105, 0.01));  // a rasteriser may move it by a 256th of a pixel
}

}  // namespace
}  // namespace sightline::test
