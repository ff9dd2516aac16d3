// Start views of 3D files: what is seen of them, which way up, and how long it takes to choose.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/base/stopwatch.h"
#include "core/scene/clean.h"
#include "core/scene/ray_tree.h"
#include "core/scene/read/load.h"
#include "core/scene/up_axis.h"
#include "core/scene/view.h"
#include "tests/scene/mesh_files.h"

namespace sightline {
namespace {

using test::TemporaryFile;

/// A box from low to high, fronts outside, or inside.
void add_box(test::Mesh& mesh, const Vec<3>& low, const Vec<3>& high, bool inside = false) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Vec<3>& p : test::cube().points) mesh.points.push_back(low + p * (high - low));
    for (auto face : test::cube().faces) {
        if (inside) std::swap(face[1], face[2]);
        mesh.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
    }
}

Scene<3> as_obj(const test::Mesh& mesh, Up up = Up::automatic) {
    // Tests run beside each other.
    const TemporaryFile file(std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".obj",
                             test::obj_of(mesh));
    return load_scene<3>(file.path(), {.up = up});
}

void expect_all_in_sight(const Scene<3>& scene) {
    ASSERT_TRUE(scene.start_view);
    const View<3> view = make_view(*scene.start_view, 4.0 / 3, scene.up_axis);
    const Box<3> box = bounds<3>(scene.primitives);
    for (int corner = 0; corner < 8; ++corner) {
        Vec<3> p;
        for (int i = 0; i < 3; ++i) p[i] = (corner >> i & 1 ? box.max : box.min)[i];
        EXPECT_TRUE(all_in_view(view, std::span<const Vec<3>>(&p, 1))) << "corner " << corner;
    }
}

TEST(StartView, ShowsTheWholeOfABoxOfAnyShape) {
    for (const Vec<3> size :
         {Vec<3>(1, 1, 1), Vec<3>(1, 20, 1), Vec<3>(20, 1, 1), Vec<3>(30, 0.5, 20), Vec<3>(1, 1, 9)})
        for (const Up up : {Up::x, Up::y, Up::z}) {
            SCOPED_TRACE(testing::Message() << size.x << " " << size.y << " " << size.z << " up " << int(up));
            test::Mesh mesh;
            add_box(mesh, Vec<3>(0), size);
            expect_all_in_sight(as_obj(mesh, up));
        }
}

TEST(StartView, StandsOutsideASolidWithAGroove) {
    // A block of 20 with a groove of 2, as solids that touch.
    test::Mesh mesh;
    add_box(mesh, Vec<3>(0, 0, 0), Vec<3>(20, 18, 20));
    add_box(mesh, Vec<3>(0, 18, 0), Vec<3>(9, 20, 20));
    add_box(mesh, Vec<3>(11, 18, 0), Vec<3>(20, 20, 20));
    expect_all_in_sight(as_obj(mesh));
}

TEST(StartView, StandsInsideARoomOfSolidWallsAndOneOfFronts) {
    test::Mesh solid;
    add_box(solid, Vec<3>(-1, -1, -1), Vec<3>(21, 0, 21));
    add_box(solid, Vec<3>(-1, 5, -1), Vec<3>(21, 6, 21));
    add_box(solid, Vec<3>(-1, 0, -1), Vec<3>(0, 5, 21));
    add_box(solid, Vec<3>(20, 0, -1), Vec<3>(21, 5, 21));
    add_box(solid, Vec<3>(0, 0, -1), Vec<3>(20, 5, 0));
    add_box(solid, Vec<3>(0, 0, 20), Vec<3>(20, 5, 21));
    add_box(solid, Vec<3>(8, 0, 8), Vec<3>(9, 2, 9));
    test::Mesh shell;
    add_box(shell, Vec<3>(0, 0, 0), Vec<3>(20, 5, 20), true);
    for (const test::Mesh& mesh : {solid, shell}) {
        const Vec<3> eye = as_obj(mesh).start_view->eye;
        EXPECT_TRUE(eye.x > 0 && eye.x < 20 && eye.y > 0 && eye.y < 5 && eye.z > 0 && eye.z < 20)
            << eye.x << " " << eye.y << " " << eye.z;
    }
}

/// Boxes on a ground that is seen from above only. Up is z.
test::Mesh town(const Vec<3>& place) {
    test::Mesh mesh;
    mesh.points = {Vec<3>(0, 0, 0), Vec<3>(120, 0, 0), Vec<3>(120, 100, 0), Vec<3>(0, 100, 0)};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}};
    for (int i = 0; i < 3; ++i) add_box(mesh, Vec<3>(15 + 35 * i, 20, 0), Vec<3>(35 + 35 * i, 40 + 10 * i, 8 + 3 * i));
    for (Vec<3>& p : mesh.points) p += place;
    return mesh;
}

TEST(Up, IsGuessedWhereTheFormatDoesNotSay) {
    Scene<3> scene = as_obj(town(Vec<3>(84000, 447000, 0)));
    EXPECT_EQ(scene.up_axis, 2);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "up is taken as z: the model lies far from zero in x and y only; --up y changes it");
    scene = as_obj(town(Vec<3>(0)));
    EXPECT_EQ(scene.up_axis, 2);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0],
              "up is taken as z: flat ground across it covers 100 % of the model; --up y changes it");
    EXPECT_LT(scene.start_view->eye.z, 11.1 * 4) << "near the ground";

    // The same with y up, as OBJ has it by custom: no word.
    test::Mesh turned = town(Vec<3>(0));
    for (Vec<3>& p : turned.points) p = Vec<3>(p.y, p.z, p.x);
    scene = as_obj(turned);
    EXPECT_EQ(scene.up_axis, 1);
    EXPECT_TRUE(scene.warnings.empty());
    // A tower: its extent is longest upwards.
    test::Mesh tower;
    add_box(tower, Vec<3>(0), Vec<3>(205, 169, 153));
    EXPECT_EQ(as_obj(tower).up_axis, 1);
}

TEST(Up, IsWhatAPersonAsksFor) {
    for (const auto& [up, axis] : {std::pair{Up::x, 0}, {Up::y, 1}, {Up::z, 2}, {Up::format, 1}}) {
        const Scene<3> scene = as_obj(town(Vec<3>(0)), up);
        EXPECT_EQ(scene.up_axis, axis);
        EXPECT_TRUE(scene.warnings.empty());
    }
    // glTF has a rule.
    const TemporaryFile gltf("asked.gltf", test::gltf_of(town(Vec<3>(84000, 447000, 0))));
    EXPECT_EQ(load_scene<3>(gltf.path()).up_axis, 1);
    EXPECT_EQ(load_scene<3>(gltf.path(), {.up = Up::z}).up_axis, 2);
}

TEST(Up, AViewAlongAnAxisThatPointsUpHasAnotherOne) {
    for (int up = 0; up < 3; ++up)
        for (int along = 0; along < 3; ++along) {
            Vec<3> eye(0);
            eye[along] = 5;
            const View<3> view = make_view(ViewSpec<3>{eye, Vec<3>(0), 60}, 1, up);
            Vec<3> top(0);
            top[along == up ? other_axis(up) : up] = 1;
            EXPECT_GT(glm::dot(view.corners[3] - view.corners[0], top), 5) << up << along;
        }
}

TEST(RayTree, WhatHasNoTrianglesIsNotEntered) {
    // One more than fills the tree: most leaves are empty, and each ray walked through all of them.
    std::vector<Primitive<3>> triangles;
    Random random(3);
    const auto point = [&] { return Vec<3>(random.unit(), random.unit(), random.unit()); };
    for (std::size_t i = 0; i < (std::size_t{4} << 16) + 1; ++i) {
        const Vec<3> p = point() * 512.0;
        triangles.push_back({p, p + point(), p + point()});
    }
    const Stopwatch watch;
    default_view(triangles, 1);
    EXPECT_LT(watch.milliseconds(), 1000);  // 30 where nothing else runs; it was 2,100 and more
    const RayTree tree(triangles);
    const RayTree::Hit hit = tree.cast(Vec<3>(-1, 256, 256), Vec<3>(1, 0, 0));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Primitive<3>& t : triangles) {
        const std::vector<Primitive<3>> one{t};
        nearest = std::min(nearest, RayTree(one).cast(Vec<3>(-1, 256, 256), Vec<3>(1, 0, 0)).distance);
    }
    EXPECT_EQ(hit.distance, nearest);
}

TEST(StartView, IsNotChosenWhereNobodyNeedsIt) {
    const TemporaryFile file("not_chosen.obj", test::obj_of(test::cube()));
    EXPECT_FALSE(load_scene<3>(file.path(), {.choose_view = false}).start_view);
}

}  // namespace
}  // namespace sightline
