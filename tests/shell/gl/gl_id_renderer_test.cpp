// The item buffer, drawn by OpenGL and in software, against Embree's rays through the pixels' centres; and the two
// against each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/raster/depth_image.h"
#include "shell/gl/id_renderer.h"
#include "tests/scene/soup_scenes.h"
#include "tests/shell/gl/embree_caster.h"
#include "tests/shell/gl/gl_support.h"
#include "tests/truth/image_judge.h"

namespace sightline::test {
namespace {

constexpr ImageSize asked_size{320, 240};

struct Comparison {
    int covered = 0;  ///< pixels that show a triangle by the rays
    int differ = 0;
    int wrong = 0;  ///< of those the ones that are decided
};

Vec<3> through(const View<3>& view, int x, int y) {
    const double right = (x + 0.5) / asked_size.width, down = (y + 0.5) / asked_size.height;
    return view.corners[3] + (view.corners[2] - view.corners[3]) * right + (view.corners[0] - view.corners[3]) * down;
}

/// `ray` says which triangle is met first at column, row.
template <typename Ray>
Comparison compare(const IdImage& image, const ImageJudge& judge, const Ray& ray) {
    Comparison found;
    for (int y = 0; y < asked_size.height; ++y)
        for (int x = 0; x < asked_size.width; ++x) {
            const std::uint32_t seen = image.at(x, y), met = ray(x, y);
            found.covered += met != none;
            if (seen == met) continue;
            ++found.differ;
            if (judge.undecided(seen, met, x, y)) continue;
            if (++found.wrong <= 3)
                ADD_FAILURE() << "pixel " << x << ' ' << y << " shows " << static_cast<int>(seen) << ", the ray meets "
                              << static_cast<int>(met);
        }
    return found;
}

class GlIdRenderer : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (context) renderer.emplace();
    }
    void TearDown() override {
        renderer.reset();
        GlTest::TearDown();
    }
    /// At least this share of the pixels shows something, and at most that share is undecided.
    void check(const Scene<3>& scene, const View<3>& view, double covered, double undecided) {
        const auto images = renderer->draw(scene, view, asked_size, 1);
        ASSERT_EQ(images.size(), 1u);
        const EmbreeCaster rays(scene, view.eye);
        const ImageJudge judge(scene, view, asked_size);
        const auto ray = [&](int x, int y) { return rays.first(through(view, x, y)); };
        const IdImage software = in_software(scene, view);
        expect(compare(images[0], judge, ray), covered, undecided);
        expect(compare(software, judge, ray), covered, undecided);
        expect(compare(images[0], judge, [&](int x, int y) { return software.at(x, y); }), covered, undecided);
    }
    static IdImage in_software(const Scene<3>& scene, const View<3>& view) {
        DepthImage image(asked_size);
        draw_depth(image, scene, view);
        return {image.width, image.height, image.ids};
    }
    static void expect(const Comparison& found, double covered, double undecided) {
        constexpr double pixels = asked_size.width * asked_size.height;
        EXPECT_EQ(found.wrong, 0) << "of " << found.differ;
        EXPECT_GE(found.covered / pixels, covered);
        EXPECT_LE(found.differ / pixels, undecided);
    }
    View<3> view_of(const Vec<3>& eye, const Vec<3>& look_at, double fov) {
        return make_view({as_float(eye), look_at, fov}, static_cast<double>(asked_size.width) / asked_size.height);
    }

    std::optional<IdRenderer> renderer;
};

TEST_F(GlIdRenderer, SoupsOfAnySizeAndPlaceLookAsRaysSeeThem) {
    for (const double scale : {1.0, 1e-6, 1e7})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            SCOPED_TRACE(testing::Message() << "scale " << scale << " seed " << seed);
            const Scene<3> scene = soup(400, {0, 0, 0}, scale, seed);
            Random random(seed);
            check(scene, view_of(around(random, {0, 0, 0}, 2 * scale), {0, 0, 0}, 70), 0.3, 0.0005);
        }
    const Vec<3> far(5000, -3000, 800);
    check(soup(400, far, 1, 5), view_of(far + Vec<3>(-2, 0.3, 0.4), far, 50), 0.3, 0.0005);
    check(soup(400, {0, 0, 0}, 1, 6), view_of({0.1, 0, 0}, {1, 0.2, 0}, 170), 0.8, 0.0005);
}

TEST_F(GlIdRenderer, ThinTrianglesLookAsRaysSeeThem) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        check(slivers(1500, seed), view_of({-2, 0.3, 0.4}, {0, 0, 0}, 50), 0.3, 0.006);
}

TEST_F(GlIdRenderer, TrianglesWithinOnePlaneLookAsRaysSeeThem) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        check(coplanar(120, seed), view_of({-2, 0.3, 0.4}, {0, 0, 0}, 50), 0.3, 0.1);
}

TEST_F(GlIdRenderer, NothingVanishesHoweverNearTheEye) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const View<3> view = view_of({0, 0, 0}, around(random, {0, 0, 0}, 1), 90);
        check(boxes_around_the_eye(0.05, 10, seed), view, 0.1, 0.0005);
        // Too much for Embree's floats: triangles of 1000 that pass at 1e-5.
        const Scene<3> scene = boxes_around_the_eye(1e-5, 1000, seed);
        const ImageJudge judge(scene, view, asked_size);
        expect(compare(renderer->draw(scene, view, asked_size, 1)[0], judge,
                       [&](int x, int y) {
                           const auto hits = judge.along(x, y);
                           return hits.empty() ? none : hits[0];
                       }),
               0.1, 0.0005);
    }
}

TEST_F(GlIdRenderer, DenseShellsLookAsRaysSeeThem) {
    Scene<3> scene = shells(100, 4);
    EXPECT_GT(scene.primitives.size(), 1u << 16);
    check(scene, view_of({-2.2, 0.7, 0.9}, {0, 0, 0}, 50), 0.4, 0.001);
    scene.two_sided.assign(scene.primitives.size(), 1);
    check(scene, view_of({0.1, 0.2, -0.1}, {1, 0.3, 0.2}, 80), 0.9, 0.001);
}

TEST_F(GlIdRenderer, TheViewMayBeBesideTheLineOfSight) {
    View<3> view = view_of({-2.5, 0.3, 0.4}, {0, 0, 0}, 50);
    const Vec<3> aside = (view.corners[1] - view.corners[0]) * 0.3;
    for (Vec<3>& corner : view.corners) corner += aside;
    check(soup(400, {0, 0, 0}, 1, 9), view, 0.2, 0.0005);
}

}  // namespace
}  // namespace sightline::test
