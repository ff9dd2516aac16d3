// Layers of ids against all triangles along the rays, triangles that coincide, sizes, and what is left behind.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/id_renderer.h"
#include "tests/scene/soup_scenes.h"
#include "tests/shell/gl/gl_support.h"
#include "tests/truth/image_judge.h"

namespace sightline::test {
namespace {

constexpr ImageSize size{120, 90};

View<3> view_of(const Vec<3>& eye, double fov) { return make_view({eye, {0, 0, 0}, fov}, 4.0 / 3); }

class GlIdLayers : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (context) renderer.emplace();
    }
    void TearDown() override {
        renderer.reset();
        GlTest::TearDown();
    }
    std::optional<IdRenderer> renderer;
};

/// Whether nothing about the pixel is a matter of rounding.
bool decided(const ImageJudge& judge, const Scene<3>& scene, std::span<const std::uint32_t> along, int x, int y) {
    for (std::uint32_t id = 0; id < scene.primitives.size(); ++id)
        if (judge.edge_distance(id, x + 0.5, y + 0.5) <= 1.0 / 128) return false;
    for (std::size_t i = 1; i < along.size(); ++i)
        if (judge.same_depth(along[i - 1], along[i], x + 0.5, y + 0.5)) return false;
    return true;
}

TEST_F(GlIdLayers, TheLayersAreTheTrianglesAlongEachRayFromFrontToBack) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Scene<3> scene = soup(400, {0, 0, 0}, 1, seed);
        const View<3> view = view_of({-2, 0.5, 0.3}, 60);
        const auto images = renderer->draw(scene, view, size, 8);
        const ImageJudge judge(scene, view, size);
        int checked = 0;
        std::size_t deepest = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                std::vector<std::uint32_t> along = judge.along(x, y);
                if (!decided(judge, scene, along, x, y)) continue;
                ++checked;
                deepest = std::max(deepest, along.size());
                along.resize(8, none);
                for (std::size_t i = 0; i < 8; ++i)
                    ASSERT_EQ(i < images.size() ? images[i].at(x, y) : none, along[i])
                        << "layer " << i << " of pixel " << x << ' ' << y;
            }
        EXPECT_GT(checked, size.width * size.height * 7 / 10);
        EXPECT_GT(deepest, 8u);
    }
}

TEST_F(GlIdLayers, FewerLayersThanAskedAreAPrefixAndEmptyOnesAreLeftOut) {
    const Scene<3> scene = soup(70, {0, 0, 0}, 1, 5);
    const View<3> view = view_of({-2, 0.5, 0.3}, 60);
    const auto all = renderer->draw(scene, view, size, 8);
    const auto some = renderer->draw(scene, view, size, 3);
    ASSERT_EQ(some.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(some[i].ids, all[i].ids);
    EXPECT_EQ(renderer->draw(scene, view, size, 1).size(), 1u);

    Scene<3> walls;
    for (const double x : {0.0, 1.0, 2.0})
        walls.primitives.push_back({Vec<3>(x, -1, -1), Vec<3>(x, 0, 1), Vec<3>(x, 1, -1)});
    const auto three = renderer->draw(walls, view_of({-2, 0, 0}, 60), size, 8);
    ASSERT_EQ(three.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(three[i].at(size.width / 2, size.height / 2), i);
}

TEST_F(GlIdLayers, OfTrianglesThatCoincideTheLowestIdIsSeenAndTheOthersFollow) {
    Random random(4);
    Scene<3> scene;
    for (int i = 0; i < 40; ++i) {
        const Vec<3> a = around(random, {0, 0, 0}, 1), b = around(random, {0, 0, 0}, 1),
                     c = around(random, {0, 0, 0}, 1);
        scene.primitives.push_back({a, b, c});
    }
    const std::vector<Primitive<3>> once = scene.primitives;
    for (int copies = 0; copies < 2; ++copies)
        scene.primitives.insert(scene.primitives.end(), once.begin(), once.end());
    scene.two_sided.assign(scene.primitives.size(), 1);
    const auto images = renderer->draw(scene, view_of({-2, 0.5, 0.3}, 60), size, 3);
    ASSERT_EQ(images.size(), 3u);
    for (std::size_t i = 0; i < images[0].ids.size(); ++i) {
        const std::uint32_t first = images[0].ids[i];
        if (first == none) continue;
        ASSERT_LT(first, 40u);
        ASSERT_EQ(images[1].ids[i], first + 40);
        ASSERT_EQ(images[2].ids[i], first + 80);
    }
}

TEST_F(GlIdLayers, WhatTurnsItsBackIsNotThereUnlessItIsTwoSided) {
    Scene<3> scene;
    scene.primitives.push_back({Vec<3>(0, -1, -1), Vec<3>(0, 1, -1), Vec<3>(0, 0, 1)});  // front towards +x
    const auto seen = [&](const Vec<3>& eye) {
        return renderer->draw(scene, view_of(eye, 60), size, 1)[0].at(size.width / 2, size.height / 2);
    };
    EXPECT_EQ(seen({2, 0, 0}), 0u);
    EXPECT_EQ(seen({-2, 0, 0}), none);
    scene.two_sided = {1};
    EXPECT_EQ(seen({-2, 0, 0}), 0u);
}

TEST_F(GlIdLayers, TheFirstRowIsTheTopAndTheFirstColumnTheLeft) {
    Scene<3> scene;  // seen from -x, y points to the left and z up
    scene.primitives.push_back({Vec<3>(0, 1, 1), Vec<3>(0, 0.6, 1), Vec<3>(0, 1, 0.6)});
    scene.two_sided = {1};
    const View<3> view = make_view({{-1, 0, 0}, {0, 0, 0}, 90}, 1);
    const IdImage image = renderer->draw(scene, view, {20, 20}, 1)[0];
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) EXPECT_EQ(image.at(x, y) == 0, x + y < 3) << x << ' ' << y;
}

TEST_F(GlIdLayers, AClosedRoomHasNoCracks) {
    Random random(6);
    for (int i = 0; i < 60; ++i) {
        Scene<3> scene;
        add_box(scene.primitives, Vec<3>(-1), Vec<3>(1), true);
        // Pulled askew, so that edges run everywhere.
        const Vec<3> u = around(random, {1, 0, 0}, 0.4), v = around(random, {0, 1, 0}, 0.4),
                     w = around(random, {0, 0, 1}, 0.4);
        for (Primitive<3>& triangle : scene.primitives)
            for (Vec<3>& p : triangle) p = as_float(u * p.x + v * p.y + w * p.z);
        const View<3> view = make_view({around(random, {0, 0, 0}, 0.3), around(random, {0, 0, 0}, 1), 100}, 4.0 / 3);
        const IdImage image = renderer->draw(scene, view, {640, 480}, 1)[0];
        EXPECT_EQ(std::count(image.ids.begin(), image.ids.end(), none), 0) << "room " << i;
    }
}

TEST_F(GlIdLayers, SizesMayChangeAndImpossibleOnesAreRefusedInWords) {
    const Scene<3> scene = soup(70, {0, 0, 0}, 1, 2);
    const View<3> view = view_of({-2, 0.5, 0.3}, 60);
    const auto before = renderer->draw(scene, view, size, 2);
    const IdImage large = renderer->draw(scene, view, {size.width * 9, size.height * 9}, 1)[0];
    int differ = 0;
    for (int y = 0; y < size.height; ++y)  // the centres of every ninth pixel are those of the small image
        for (int x = 0; x < size.width; ++x) differ += large.at(x * 9 + 4, y * 9 + 4) != before[0].at(x, y);
    EXPECT_LE(differ, size.width * size.height / 1000);
    for (const ImageSize bad : {ImageSize{0, 5}, ImageSize{5, -1}, ImageSize{1 << 20, 5}})
        EXPECT_THROW(renderer->draw(scene, view, bad, 1), WorkError);
    const auto after = renderer->draw(scene, view, size, 2);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].ids, before[i].ids);
    EXPECT_EQ(renderer->draw(scene, view, {1, 1}, 1)[0].ids.size(), 1u);
}

TEST_F(GlIdLayers, AnEmptySceneIsAnEmptyImage) {
    const auto images = renderer->draw(Scene<3>{}, view_of({-2, 0, 0}, 60), size, 8);
    ASSERT_EQ(images.size(), 1u);
    EXPECT_TRUE(std::all_of(images[0].ids.begin(), images[0].ids.end(), [](auto id) { return id == none; }));
}

TEST_F(GlIdLayers, AnyStateIsTakenAndTheOneThatIsPromisedIsLeft) {
    const Scene<3> scene = soup(70, {0, 0, 0}, 1, 2);
    const View<3> view = view_of({-2, 0.5, 0.3}, 60);
    const auto before = renderer->draw(scene, view, size, 2);
    for (const GLenum on : {GL_BLEND, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_DITHER}) glEnable(on);
    glScissor(3, 3, 5, 5);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    const auto after = renderer->draw(scene, view, size, 2);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(after[i].ids, before[i].ids);
    for (const GLenum off : {GL_BLEND, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_DEPTH_TEST})
        EXPECT_FALSE(glIsEnabled(off));
    for (const GLenum binding : {GL_FRAMEBUFFER_BINDING, GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING,
                                 GL_TEXTURE_BINDING_2D, GL_ARRAY_BUFFER_BINDING}) {
        GLint bound = -1;
        glGetIntegerv(binding, &bound);
        EXPECT_EQ(bound, 0);
    }
}

}  // namespace
}  // namespace sightline::test
