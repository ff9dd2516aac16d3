// What the renderer of solids puts where, read back off screen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/trig.h"
#include "core/raster/image_plane.h"
#include "tests/draw/solid_samples.h"
#include "tests/shell/gl/gl_solid_support.h"

namespace sightline {
namespace {

using namespace test;

/// The middle of what is darker than white, in pixels from the lower left corner, and how much it is.
struct Spot {
    double x = 0, y = 0, ink = 0;
};
Spot spot_of(const Pixels& p) {
    Spot spot;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const double i = ink(p.at(x, y));
            spot.x += i * (x + 0.5);
            spot.y += i * (p.height - y - 0.5);
            spot.ink += i;
        }
    spot.x /= spot.ink;
    spot.y /= spot.ink;
    return spot;
}

TEST_F(GlSolid, WhatIsNearerLiesInFrontInAnyOrder) {
    for (const bool near_first : {false, true}) {
        SolidList list = list_of({plain(red), plain(blue)});
        if (near_first) square(list, 0, -20, 20, -5);
        square(list, 1, -40, 40, 5);
        if (!near_first) square(list, 0, -20, 20, -5);
        const Pixels p = drawn(list);
        EXPECT_EQ(p.at(50, 50), red);
        EXPECT_EQ(p.at(20, 50), blue);
        EXPECT_EQ(p.at(50, 79), blue);
        EXPECT_EQ(p.at(3, 50), white);
    }
}

TEST_F(GlSolid, ASceneAndFacesHideEachOther) {
    Scene<3> scene;
    scene.primitives = {
        {Vec<3>(-60, 0, -60), Vec<3>(60, 0, -60), Vec<3>(60, 0, 60)},
        {Vec<3>(-60, 0, -60), Vec<3>(60, 0, 60), Vec<3>(-60, 0, 60)}};  // the second ends at the diagonal
    SolidList list = list_of({plain(red), plain(blue), plain(green)});
    show_scene(list, 0, std::make_shared<const Scene<3>>(scene));
    square(list, 1, -40, 0, 5);
    square(list, 2, 10, 40, -5);
    Pixels p = drawn(list);
    EXPECT_EQ(p.at(30, 70), red);
    EXPECT_EQ(p.at(75, 25), green);
    // Runs choose triangles and their styles; those of no run are not there.
    list.triangles = {1, 0};
    list.runs = {{2, 1, 1}};
    p = drawn(list);
    EXPECT_EQ(p.at(70, 90), green);
    EXPECT_EQ(p.at(5, 20), white);
    EXPECT_EQ(p.at(25, 70), blue);  // in the hole
    const std::vector<SolidList::Run> both{{0, 0, 1}, {1, 1, 1}};
    renderer->set_triangles(both, list.triangles);
    const GlTarget target(100, 100, 1, true);
    target.bind();
    renderer->draw(list.camera, 0, 0, 100, 100, 1);
    p = target.read();
    EXPECT_EQ(p.at(5, 20), red);
    EXPECT_EQ(p.at(70, 90), blue);
    EXPECT_EQ(p.at(75, 25), green);  // faces stay
}

/// `over` with this share of `top` on it.
Colour blended(const Colour& over, const Colour& top, double share) {
    const auto mix = [&](int a, int b) { return static_cast<std::uint8_t>(std::lround(a + (b - a) * share)); };
    return {mix(over.r, top.r), mix(over.g, top.g), mix(over.b, top.b)};
}

void expect_near(const Colour& seen, const Colour& wanted, int slack = 2) {
    EXPECT_NEAR(seen.r, wanted.r, slack);
    EXPECT_NEAR(seen.g, wanted.g, slack);
    EXPECT_NEAR(seen.b, wanted.b, slack);
    EXPECT_EQ(seen.a, 255);
}

TEST_F(GlSolid, TranslucentFacesAndTrianglesBlendFromTheBackInAnyOrder) {
    const Colour thin_red{255, 0, 0, 128}, thin_blue{0, 0, 255, 128}, thin_green{0, 200, 0, 64};
    Scene<3> scene;
    scene.primitives = {{Vec<3>(-200, 0, -60), Vec<3>(200, 0, -60), Vec<3>(0, 0, 200)}};
    const auto shared = std::make_shared<const Scene<3>>(scene);
    const Colour wall = blended(white, black, 0);
    for (int order = 0; order < 6; ++order)
        for (const bool from_behind : {false, true}) {
            SolidList list = list_of({plain(thin_red), plain(thin_blue), plain(thin_green), plain(black)});
            show_scene(list, 2, shared);
            std::array<int, 3> which{0, 1, 2};
            for (int i = 0; i < order; ++i) std::next_permutation(which.begin(), which.end());
            for (const int i : which) {
                if (i == 0) square(list, 0, -20, 20, -5);
                if (i == 1) square(list, 1, -20, 20, 5);
                if (i == 2) square(list, 3, -10, 10, from_behind ? -30 : 30);
            }
            if (from_behind) {
                list.camera.eye.y = 1000;
                std::swap(list.camera.corners[0], list.camera.corners[1]);
                std::swap(list.camera.corners[2], list.camera.corners[3]);
            }
            const Pixels p = drawn(list);
            for (const auto& [x, ground] : {std::pair(50, black), std::pair(35, wall)}) {
                Colour wanted = blended(ground, from_behind ? thin_red : thin_blue, 128 / 255.0);
                wanted = blended(wanted, thin_green, 64 / 255.0);
                wanted = blended(wanted, from_behind ? thin_blue : thin_red, 128 / 255.0);
                expect_near(p.at(x, 50), wanted);
            }
        }
}

TEST_F(GlSolid, TranslucentFacesAreSortedAgainWhenTheEyeMovesAndHideNoEdges) {
    SolidList list = list_of({plain({255, 0, 0, 128}), plain({0, 0, 255, 128}), plain(black, 4)});
    square(list, 0, -20, 20, -5);
    square(list, 1, -20, 20, 5);
    add_edge(list, 2, {-60, 10, -10}, {60, 10, -10});
    const Pixels before = drawn(list);
    EXPECT_GT(before.at(50, 50).r, before.at(50, 50).b);
    EXPECT_EQ(before.at(50, 60), black);
    list.camera.eye.y = 1000;
    std::swap(list.camera.corners[0], list.camera.corners[1]);
    std::swap(list.camera.corners[2], list.camera.corners[3]);
    const GlTarget target(100, 100, 1, true);
    target.bind();
    renderer->draw(list.camera, 0, 0, 100, 100, 1);
    const Pixels behind = target.read();
    EXPECT_LT(behind.at(50, 50).r, behind.at(50, 50).b);
}

TEST_F(GlSolid, TranslucentTrianglesGoWhenTheyAreReplaced) {
    Scene<3> scene;
    scene.primitives = {{Vec<3>(-200, 0, -60), Vec<3>(200, 0, -60), Vec<3>(0, 0, 200)}};
    SolidList list = list_of({plain({255, 0, 0, 128})});
    show_scene(list, 0, std::make_shared<const Scene<3>>(scene));
    expect_near(drawn(list).at(50, 50), {255, 127, 127});
    const auto replaced = [&](std::span<const SolidList::Run> runs) {
        renderer->set_triangles(runs, list.triangles);
        const GlTarget target(100, 100, 1, true);
        target.bind();
        renderer->draw(list.camera, 0, 0, 100, 100, 1);
        return target.read().at(50, 50);
    };
    expect_near(replaced(list.runs), {255, 127, 127});  // not twice
    EXPECT_EQ(replaced({}), white);
}

TEST_F(GlSolid, EdgesAreAsWideAsTheySayAndHiddenByWhatLiesBeforeThem) {
    for (const double width : {0.5, 1.0, 3.0, 8.0}) {
        SolidList list = list_of({plain(black, width), plain(white)});
        add_edge(list, 0, {-60, 0, 0}, {60, 0, 0});
        add_face(list, 1, {{-45, -5, -40}, {-20, -5, -40}, {-20, -5, 40}, {-45, -5, 40}});  // before it
        add_face(list, 1, {{20, 5, -40}, {45, 5, -40}, {45, 5, 40}, {20, 5, 40}});          // behind it
        const Pixels p = drawn(list);
        const auto across = [&](int x) {
            double sum = 0;
            for (int y = 0; y < 100; ++y) sum += ink(p.at(x, y));
            return sum;
        };
        EXPECT_NEAR(across(50), width, 0.1) << width;
        EXPECT_NEAR(across(80), width, 0.1) << width;
        EXPECT_EQ(across(20), 0) << width;
    }
}

TEST_F(GlSolid, QuickEdgesAreLinesOfOnePixelThatFacesHideToo) {
    SolidList list = list_of({plain(black, 0.5), plain(white), plain(black, 4)});
    add_edge(list, 0, {-60, 0, 0.5}, {60, 0, 0.5});
    add_edge(list, 2, {-60, 0, 20.5}, {60, 0, 20.5});
    add_face(list, 1, {{-45, -5, -40}, {-20, -5, -40}, {-20, -5, 40}, {-45, -5, 40}});
    const Pixels p = drawn(list, 100, 100, true);
    for (int y = 0; y < 100; ++y) {
        EXPECT_NEAR(ink(p.at(70, y)), y == 49 ? 0.5 : y == 29 ? 1 : 0, 0.01) << y;
        EXPECT_EQ(p.at(20, y), white) << y;
    }
}

TEST_F(GlSolid, EdgesOfVisibleFacesShowAlongTheirWholeLengthFromEverySide) {
    // A box turned and tilted in many ways: each edge between two faces of which one is seen must show on the seen one.
    Random random(5);
    for (int round = 0; round < 120; ++round) {
        SolidList list = list_of({plain(white), plain(black, round % 3 + 0.5)});
        const Vec<3> high(random.uniform(4, 30), random.uniform(4, 30), random.uniform(4, 30));
        std::vector<Primitive<3>> triangles;
        add_box(triangles, -high, high);
        for (const Primitive<3>& t : triangles) add_face(list, 0, {t[0], t[1], t[2]});
        const Vec<3> eye = Vec<3>(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) *
                           (random.below(2) == 0 ? 80.0 : 3000.0);
        if (std::abs(eye.x) < high.x && std::abs(eye.y) < high.y && std::abs(eye.z) < high.z) continue;
        const double distance = std::sqrt(glm::dot(eye, eye));
        const double fov = distance > 1000 ? 2 : 60;
        list.camera = make_view({eye, {0, 0, 0}, fov}, 1);
        const ImagePlane plane = image_plane(list.camera);
        const auto pixel = [&](const Vec<3>& p) {
            const Vec<3> q = plane.project(p);
            return Vec<2>((q.x / q.z + 1) * 100, (q.y / q.z + 1) * 100);
        };
        std::vector<std::pair<Vec<3>, Vec<3>>> shown;
        for (int axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 4; ++corner) {
                const int b = (axis + 1) % 3, c = (axis + 2) % 3;
                Vec<3> from = high;
                from[axis] = -high[axis];
                if (corner & 1) from[b] = -high[b];
                if (corner & 2) from[c] = -high[c];
                Vec<3> to = from;
                to[axis] = high[axis];
                add_edge(list, 1, from, to);
                // By a clear angle, not a hair's breadth.
                const auto faces_eye = [&](int i) {
                    return from[i] > 0 ? eye[i] > 1.05 * high[i] : eye[i] < -1.05 * high[i];
                };
                if (faces_eye(b) || faces_eye(c)) shown.emplace_back(from, to);
            }
        const Pixels p = drawn(list, 200, 200, round % 2 == 1);
        for (const auto& [from, to] : shown)
            for (double t = 0.05; t < 1; t += 0.1) {
                const Vec<2> at = pixel(from + (to - from) * t);
                if (at.x < 2 || at.y < 2 || at.x > 198 || at.y > 198) continue;
                // Half of it may be on the far side of the outline, where faces behind it cannot hide it.
                double darkest = 0;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        darkest = std::max(darkest,
                                           ink(p.at(static_cast<int>(at.x) + dx, 199 - static_cast<int>(at.y) + dy)));
                EXPECT_GT(darkest, 0.2) << "round " << round << " at " << at.x << ' ' << at.y;
            }
    }
}

TEST_F(GlSolid, TheHiddenEdgesOfABoxAreHidden) {
    SolidList list = list_of({plain(white), plain(black)});
    std::vector<Primitive<3>> triangles;
    add_box(triangles, {-20, -20, -20}, {20, 20, 20});
    for (const Primitive<3>& t : triangles) add_face(list, 0, {t[0], t[1], t[2]});
    add_edge(list, 1, {20, 20, -20}, {20, 20, 20});
    add_edge(list, 1, {-20, 20, -20}, {20, 20, -20});
    list.camera = make_view({{-70, -90, 50}, {0, 0, 0}, 40}, 1);
    const Pixels p = drawn(list, 400, 400);
    // They end where the outline begins.
    EXPECT_LT(spot_of(p).ink, 6);
    list.camera = make_view({{70, 90, -50}, {0, 0, 0}, 40}, 1);
    EXPECT_GT(spot_of(drawn(list, 400, 400)).ink, 50);
}

TEST_F(GlSolid, AnEdgeThatPassesTheEyeIsCutBeforeIt) {
    SolidList list = list_of({plain(black, 2)});
    // Along the view, just beside the eye, from far behind it.
    add_edge(list, 0, {10, -5000, 0}, {10, 4000, 0});
    const Pixels p = drawn(list);
    EXPECT_GT(ink(p.at(52, 50)), 0.3);  // its far end at 50 + 10 / 5
    EXPECT_GT(ink(p.at(80, 50)), 0.3);
    for (int x = 0; x < 48; ++x) EXPECT_EQ(p.at(x, 50), white) << x;
}

TEST_F(GlSolid, TheSliceCutsTrianglesAndNotFaces) {
    for (const std::uint8_t alpha : {255, 128}) {
        Scene<3> scene;
        scene.primitives = {{Vec<3>(-300, 0, -100), Vec<3>(300, 0, -100), Vec<3>(0, 0, 300)}};
        SolidList list = list_of({plain({255, 0, 0, alpha}), plain({0, 0, 255, alpha}), plain(black, 4)});
        show_scene(list, 0, std::make_shared<const Scene<3>>(scene));
        square(list, 1, -40, 40, 10);
        add_edge(list, 2, {-60, 0, -48}, {60, 0, -48});
        list.slice = Slice{{2, 0, 0}, 20};
        Pixels p = drawn(list);
        EXPECT_EQ(p.at(55, 2), drawn(list).at(2, 2));
        EXPECT_GT(p.at(59, 2).r, p.at(59, 2).b);
        EXPECT_EQ(p.at(61, 2), white);
        EXPECT_EQ(p.at(80, 97), black);
        EXPECT_GT(p.at(61, 50).b, p.at(61, 50).r);
        list.slice.reset();
        EXPECT_NE(drawn(list).at(61, 2), white);
    }
}

TEST_F(GlSolid, LitFacesDifferByTheirDirectionAndLookAlikeFromBothSides) {
    SolidList list = list_of({{"lit", {200, 200, 200}}});
    std::vector<Primitive<3>> triangles;
    add_box(triangles, {-20, -20, -20}, {20, 20, 20});
    for (const Primitive<3>& t : triangles) add_face(list, 0, {t[0], t[1], t[2]});
    list.camera = make_view({{-70, -60, 50}, {0, 0, 0}, 40}, 1);
    const Pixels p = drawn(list);
    std::vector<Colour> seen;
    for (const Colour& c : p.colours)
        if (c != white && std::find(seen.begin(), seen.end(), c) == seen.end()) seen.push_back(c);
    ASSERT_EQ(seen.size(), 3u);  // two triangles of a side are alike
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(seen[i].r, 200);
        EXPECT_GT(seen[i].r, 50);
        for (std::size_t j = 0; j < i; ++j) EXPECT_GT(std::abs(seen[i].r - seen[j].r), 12);
    }
    // Turning all corners the other way round changes nothing.
    for (std::size_t i = 0; i + 2 < list.points.size(); i += 3) std::swap(list.points[i], list.points[i + 2]);
    EXPECT_EQ(drawn(list).colours, p.colours);
    // A triangle of the scene is lit like a face.
    SolidList same = list_of(list.styles);
    Scene<3> scene;
    scene.primitives = triangles;
    same.camera = list.camera;
    show_scene(same, 0, std::make_shared<const Scene<3>>(scene));
    EXPECT_EQ(drawn(same).colours, p.colours);
}

TEST_F(GlSolid, TheCameraPutsPointsWhereTheImagePlaneSays) {
    Random random(7);
    for (int round = 0; round < 200; ++round) {
        const auto within = [&](double r) {
            return Vec<3>(random.uniform(-r, r), random.uniform(-r, r), random.uniform(-r, r));
        };
        const double size = std::pow(10.0, static_cast<double>(random.below(7)) - 3);
        const Vec<3> shift = within(random.below(2) == 0 ? 0 : 100 * size);
        SolidList list = list_of({plain(black), plain(black, 3)});
        list.camera = make_view({shift + within(size), shift + within(size), random.uniform(5, 100)}, 1.5);
        const ImagePlane plane = image_plane(list.camera);
        const Vec<3> p = shift + within(2 * size);
        const Vec<3> q = plane.project(p);
        const Vec<2> wanted((q.x / q.z + 1) * 150, (q.y / q.z + 1) * 100);
        if (!(q.z > 0) || wanted.x < 10 || wanted.x > 290 || wanted.y < 10 || wanted.y > 190) continue;
        const bool edge = round % 2 == 0;
        if (edge) {
            add_edge(list, 1, p, p);  // a dot
        } else {
            // A small square around the point, parallel to the image.
            const auto& c = list.camera.corners;
            const Vec<3> right = (c[1] - c[0]) * (q.z * 4 / 300), up = (c[3] - c[0]) * (q.z * 4 / 200);
            add_face(list, 0, {p - right - up, p + right - up, p + right + up, p - right + up});
        }
        const Spot spot = spot_of(drawn(list, 300, 200));
        EXPECT_NEAR(spot.x, wanted.x, 0.5) << round;
        EXPECT_NEAR(spot.y, wanted.y, 0.5) << round;
        EXPECT_NEAR(spot.ink, edge ? 7.07 : 64, edge ? 1 : 1e-9) << round;
    }
}

TEST_F(GlSolid, FillsItsRectangleAndNothingElse) {
    SolidList list = list_of({plain(red), plain(black, 30)});
    list.background = blue;
    square(list, 0, -20, 2000, 0);
    add_edge(list, 1, {-500, -5, -50}, {500, -5, -50});
    renderer->set(list);
    const GlTarget target(100, 100, 1, true);
    target.bind();
    clear(white);
    glEnable(GL_SCISSOR_TEST);  // as others may leave it
    glScissor(0, 0, 1, 1);
    renderer->draw(list.camera, 20, 10, 40, 30, 1);
    for (const GLenum off : {GL_BLEND, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE,
                             GL_POLYGON_OFFSET_FILL, GL_CLIP_DISTANCE0})
        EXPECT_FALSE(glIsEnabled(off)) << off;
    for (const GLenum bound : {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING}) {
        GLint name = -1;
        glGetIntegerv(bound, &name);
        EXPECT_EQ(name, 0) << bound;
    }
    const Pixels p = target.read();
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const bool inside = x >= 20 && x < 60 && y >= 60 && y < 90;
            EXPECT_EQ(p.at(x, y) != white, inside) << x << ' ' << y;
        }
    EXPECT_EQ(p.at(21, 61), blue);
    EXPECT_EQ(p.at(50, 65), red);
    EXPECT_EQ(p.at(50, 88), black);
}

TEST_F(GlSolid, NothingAndTinyAndEmptyPictures) {
    SolidList list = list_of({plain(red), plain(black)});
    list.background = green;
    EXPECT_EQ(drawn(list).at(50, 50), green);
    square(list, 0, -200, 200, 0);
    const Pixels one = renderer->picture(list, 1, 1, 1);
    ASSERT_EQ(one.colours.size(), 1u);
    EXPECT_EQ(one.colours[0], red);
    for (const auto& [w, h] : {std::pair(0, 0), std::pair(0, 7), std::pair(7, 0), std::pair(-1, 3)}) {
        EXPECT_TRUE(renderer->picture(list, w, h, 1).colours.empty());
        const GlTarget target(4, 4, 1, true);
        target.bind();
        clear(white);
        renderer->draw(list.camera, 0, 0, w, h, 1);
        EXPECT_EQ(target.read().at(0, 3), white);
    }
    EXPECT_THROW(renderer->picture(list, 8193, 1, 1), WorkError);
    const Pixels wide = renderer->picture(list, 8192, 1, 1);
    EXPECT_EQ(wide.width, 8192);
    EXPECT_EQ(wide.at(8191, 0), red);
}

TEST_F(GlSolid, WhatAListNamesInVainIsLeftOut) {
    SolidList list = list_of({plain(red)});
    square(list, 7, -40, 40, 0);
    add_face(list, 0, {{0, 0, 0}, {1, 0, 0}});
    const double infinite = std::numeric_limits<double>::infinity();
    add_face(list, 0, {{-40, 0, 0}, {infinite, 0, 0}, {0, 0, 40}});
    add_face(list, 0, {{-40, 0, 0}, {std::nan(""), 0, 0}, {0, 0, 40}});
    list.face_begin.push_back(100);
    list.face_style.push_back(0);
    add_edge(list, 3, {-40, 0, 0}, {40, 0, 0});
    list.edge_points.push_back({0, 0, 0});
    list.triangles = {0, 1, 2};
    list.runs = {{0, 0, 3}};
    EXPECT_EQ(spot_of(drawn(list)).ink, 0);
    Scene<3> scene;
    scene.primitives = {{Vec<3>(-300, 0, -100), Vec<3>(300, 0, -100), Vec<3>(0, 0, 300)}};
    list.scene = std::make_shared<const Scene<3>>(scene);
    EXPECT_EQ(spot_of(drawn(list)).ink, 0);  // there is but one triangle
    list.runs = {{0, 0, 4}, {5, 0, 1}, {0, 0, 1}};
    EXPECT_EQ(drawn(list).at(50, 50), red);
}

TEST_F(GlSolid, ALargePictureHasNoSeams) {
    // Tiles begin at multiples of 2048: the picture must look there as the same picture moved by a few pixels.
    SolidList list =
        list_of({{"face", {200, 180, 160}}, {"layer", {220, 120, 60, 160}}, {"edge", {0, 0, 0}, true, 1.5}});
    add_tetrahedra(list, 5, 0.1, {-45, -45, -45}, {45, 45, 45});
    list.camera = make_view({{90, 100, 80}, {0, 0, 0}, 50}, 2304.0 / 96);
    const Pixels all = renderer->picture(list, 2304, 96, 1);
    const Pixels again = renderer->picture(list, 2304, 96, 1);
    EXPECT_EQ(all.colours, again.colours);
    // The right end of it alone.
    View<3> part = list.camera;
    const Vec<3> right = (part.corners[1] - part.corners[0]) / 2304.0;
    for (const std::size_t i : {0u, 3u}) part.corners[i] = part.corners[i] + right * 1792.0;
    SolidList end = list;
    end.camera = part;
    const Pixels moved = renderer->picture(end, 512, 96, 1);
    double different = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 512; ++x) different += std::abs(moved.at(x, y).r - all.at(1792 + x, y).r) > 24;
    EXPECT_LT(different, 20);
}

TEST_F(GlSolid, PicturesAreSmoothAndOpaque) {
    SolidList list = list_of({plain(black)});
    add_face(list, 0, {{-30, 0, -30}, {40, 0, 0}, {-20, 0, 45}});
    const Pixels p = renderer->picture(list, 100, 100, 1);
    int greys = 0;
    for (const Colour& c : p.colours) {
        greys += c.r > 0 && c.r < 255;
        ASSERT_EQ(c.a, 255);
    }
    EXPECT_GT(greys, 50);
}

TEST_F(GlSolid, SteepFacesStepBackByNoMoreThanTwoPixels) {
    // A wall under the ground, which is seen at a small angle: only where they all but meet may it shine through.
    SolidList list = list_of({plain(red), plain(blue), plain(black, 1)});
    add_face(list, 0, {{-50, -900, -20}, {50, -900, -20}, {50, 4000, -20}, {-50, 4000, -20}});
    add_face(list, 1, {{-50, 3000, -26}, {50, 3000, -26}, {50, 3000, -20}, {-50, 3000, -20}});
    add_edge(list, 2, {-50, 2000, 5}, {50, 2000, 5});
    const Pixels p = drawn(list, 400, 400);
    const double meet = 200 + 4.0 * 20 / 4;  // rows from the top
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 400; ++x) EXPECT_TRUE(p.at(x, y) != blue || y < meet + 2) << x << ' ' << y;
}

}  // namespace
}  // namespace sightline
