// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <functional>

#include "core/base/random.h"
#include "core/scene/read/read_mesh.h"
#include "tests/scene/mesh_files.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;
using test::expect_input_error;
using test::Folder;
using test::TemporaryFile;

Scene<3> read(const TemporaryFile& file, const MeshOptions& options = {}) {
    return read_mesh(file.path(), "x", options);
}

/// Six times the volume that the triangles enclose; positive when their fronts are outside.
double six_volumes(const Scene<3>& scene) {
    double sum = 0;
    for (const Primitive<3>& t : scene.primitives) sum += glm::dot(t[0], glm::cross(t[1], t[2]));
    return sum;
}

void expect_cube(const Scene<3>& scene, const Vec<3>& low, const Vec<3>& high) {
    EXPECT_EQ(scene.primitives.size(), 12u);
    EXPECT_EQ(scene.dropped, Dropped{});
    const Box<3> box = bounds<3>(scene.primitives);
    EXPECT_EQ(box.min, low);
    EXPECT_EQ(box.max, high);
    const Vec<3> size = high - low;
    EXPECT_NEAR(six_volumes(scene), 6 * size.x * size.y * size.z, 1e-9);
}

TEST(SceneMesh, ReadsACubeInEveryFormat) {
    struct Row {
        const char *name, *format;
        int up_axis;
        std::string bytes;
    };
    const test::Mesh cube = test::cube();
    for (const Row& row : {Row{"c.obj", "obj", 1, test::obj_of(cube)},
                           {"c.off", "off", 2, test::off_of(cube)},
                           {"ca.ply", "ply", 2, test::ply_of(cube, false)},
                           {"cb.ply", "ply", 2, test::ply_of(cube, true)},
                           {"ca.stl", "stl", 2, test::stl_of(cube, false)},
                           {"cb.stl", "stl", 2, test::stl_of(cube, true)},
                           {"c.gltf", "gltf", 1, test::gltf_of(cube)},
                           {"c.glb", "gltf", 1, test::glb_of(cube)}}) {
        SCOPED_TRACE(row.name);
        const TemporaryFile file(row.name, row.bytes);
        const Scene<3> scene = read(file);
        expect_cube(scene, Vec<3>(0), Vec<3>(1));
        EXPECT_EQ(scene.id, "x");
        EXPECT_EQ(scene.source, row.format);
        EXPECT_EQ(scene.up_axis, row.up_axis);
        EXPECT_EQ(scene.origin, Vec<3>(0));
        EXPECT_TRUE(scene.two_sided.empty());
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    }
}

TEST(SceneMesh, EndingsAreOfAnyCase) {
    for (const char* name : {"C.OBJ", "c.Off", "C.PLY", "c.STL"}) {
        const std::string kind = fs::path(name).extension().string();
        const TemporaryFile file(name, kind == ".OBJ"   ? test::obj_of(test::cube())
                                       : kind == ".Off" ? test::off_of(test::cube())
                                       : kind == ".PLY" ? test::ply_of(test::cube(), true)
                                                        : test::stl_of(test::cube(), true));
        EXPECT_EQ(read(file).primitives.size(), 12u) << name;
    }
}

TEST(SceneMesh, AFormatBehindAnotherEndingIsRefused) {
    const test::Mesh cube = test::cube();
    const std::pair<std::string, std::string> formats[] = {
        {"obj", test::obj_of(cube)},       {"off", test::off_of(cube)},        {"ply", test::ply_of(cube, false)},
        {"ply", test::ply_of(cube, true)}, {"stl", test::stl_of(cube, false)}, {"stl", test::stl_of(cube, true)},
        {"gltf", test::gltf_of(cube)},     {"glb", test::glb_of(cube)}};
    for (const auto& [format, bytes] : formats)
        for (const std::string ending :
             {"obj", "off", "ply", "stl", "gltf", "glb", "x3d", "ase", "ogex", "fbx", "dae"}) {
            SCOPED_TRACE(format + " as " + ending);
            const TemporaryFile file("x." + ending, bytes);
            if (ending == format)
                expect_cube(read(file), Vec<3>(0), Vec<3>(1));
            else
                expect_input_error([&, &file = file] { read(file); }, "x: *");
        }
    const TemporaryFile ply("ply.glb", test::ply_of(cube, true));
    expect_input_error([&] { read(ply); },
                       "x: is not glTF as its extension .glb says (it begins like PLY)");
}

TEST(SceneMesh, EndingsOfNoMeshAreRefused) {
    const std::string read_are = "; supported: .3d, .3ds, *";
    for (const std::string ending : {"csm", "bvh", "md5anim", "md5camera", "mot", "vta", "txt"}) {
        const TemporaryFile text("x." + ending, "Dear all,\nhere are 12 numbers.\n");
        expect_input_error([&] { read(text); }, "x: ." + ending + " is not the extension of a 3D format" + read_are);
    }
    const TemporaryFile large("x.CSM", "Dear all,\n");
    expect_input_error([&] { read(large); }, "x: .csm is not the extension of a 3D format*");
    const TemporaryFile named("x.txt", test::ply_of(test::cube(), false));
    expect_input_error([&] { read(named); },
                       "x: .txt is not the extension of a 3D format (it begins like PLY)" + read_are);
    const TemporaryFile level("x.wad", "IWAD and so on");
    expect_input_error(
        [&] { read(level); },
        "x: .wad is not the extension of a 3D format (it begins like a Doom WAD, which viewer2d reads)" + read_are);
    const TemporaryFile none("cube", test::obj_of(test::cube()));
    expect_input_error([&] { read(none); }, "x: its name has no extension*");
    std::string line;
    try {
        read(none);
    } catch (const InputError& error) {
        line = error.what();
    }
    for (const char* ending : {".obj", ".ply", ".stl", ".off", ".gltf", ".glb", ".fbx", ".dae"})
        EXPECT_NE(line.find(std::string(ending) + ","), std::string::npos) << ending;
    EXPECT_EQ(line.find(".csm"), std::string::npos);
}

/// Readers that take any text, find nothing in it and say nothing, or make up bones.
TEST(SceneMesh, WhatAReaderMakesNothingOfIsRefused) {
    for (const std::string ending : {"ase", "ask", "ogex", "x3d", "x3db", "irr", "smd", "sib", "ac", "lwo", "ms3d"})
        for (const std::string& bytes : {std::string("Dear all,\nhere are 12 numbers.\n"), std::string(3000, '\0'),
                                         std::string("<?xml version=\"1.0\"?>\n<root><a b=\"1\"/></root>\n")}) {
            SCOPED_TRACE(ending);
            const TemporaryFile file("x." + ending, bytes);
            expect_input_error([&] { read(file); }, "x: *");
        }
    const TemporaryFile text("x.ogex", "Dear all\n");
    expect_input_error([&] { read(text); }, "x: no triangle is found in it, read as .ogex");
}

TEST(SceneMesh, CutsPolygonsAndLeavesOutPointsAndLines) {
    const TemporaryFile file("polygons.obj",
                             "mtllib no_such.mtl\nusemtl red\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 3 0\n"
                             "f 1 2 3 5 4\np 1\nl 1 2 3\n");
    const Scene<3> scene = read(file);
    EXPECT_EQ(scene.primitives.size(), 3u);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
}

TEST(SceneMesh, AppliesTransformsInDoublesAndTurnsMirroredTriangles) {
    const test::Mesh cube = test::cube();
    // Twice as large in x, at 5 in y; a child mirrored in z.
    const std::string nodes =
        R"([{"children": [1], "translation": [0, 5, 0], "scale": [2, 1, 1]}, {"mesh": 0, "scale": [1, 1, -3]}])";
    const TemporaryFile mirrored("mirrored.gltf", test::gltf_of(cube, nodes));
    expect_cube(read(mirrored), Vec<3>(0, 5, -3), Vec<3>(2, 6, 0));

    // One mesh used twice is two cubes; used twice in one place it repeats itself.
    const TemporaryFile twice("twice.gltf", test::gltf_of(cube, R"([{"mesh": 0, "children": [1, 2]},
        {"mesh": 0, "matrix": [0,0,-1,0, 0,1,0,0, 1,0,0,0, 9,0,0,1]}, {"mesh": 0, "translation": [0,0,0]}])"));
    const Scene<3> scene = read(twice);
    EXPECT_EQ(scene.primitives.size(), 24u);
    EXPECT_EQ(scene.dropped, (Dropped{0, 12, 0}));
    EXPECT_NEAR(six_volumes(scene), 12, 1e-9);
    EXPECT_EQ(bounds<3>(scene.primitives).max, Vec<3>(10, 1, 1));

    // 0.1 is no float: what a float matrix product would round differs from the product in doubles.
    const TemporaryFile deep("deep.gltf", test::gltf_of(cube, R"([{"children": [1], "translation": [1000000, 0, 0]},
        {"children": [2], "translation": [0.0625, 0, 0]}, {"mesh": 0, "translation": [-1000000, 0, 0]}])"));
    expect_cube(read(deep), Vec<3>(0.0625, 0, 0), Vec<3>(1.0625, 1, 1));
}

TEST(SceneMesh, RespectsTwoSidedMaterials) {
    const test::Mesh cube = test::cube();
    const TemporaryFile file("sides.gltf",
                             test::gltf_of(cube, R"([{"mesh": 0}, {"mesh": 1, "translation": [3, 0, 0]}])"));
    const Scene<3> scene = read(file);
    ASSERT_EQ(scene.two_sided.size(), 24u);
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(scene.two_sided[i], i >= 12) << i;

    const TemporaryFile plain("plain.obj", test::obj_of(cube));
    EXPECT_EQ(read(plain, {true, {}}).two_sided, std::vector<std::uint8_t>(12, 1));
}

TEST(SceneMesh, StartsAtTheFilesCamera) {
    const TemporaryFile file("camera.gltf", test::gltf_of(test::cube(), R"([{"mesh": 0},
        {"camera": 0, "translation": [0.5, 0.5, 7]}])"));
    const Scene<3> scene = read(file);
    ASSERT_TRUE(scene.start_view);
    EXPECT_EQ(scene.start_view->eye, Vec<3>(0.5, 0.5, 7));
    const Vec<3> ahead = scene.start_view->look_at - scene.start_view->eye;
    EXPECT_NEAR(ahead.x, 0, 1e-6);
    EXPECT_NEAR(ahead.y, 0, 1e-6);
    EXPECT_LT(ahead.z, 0);
    EXPECT_NEAR(scene.start_view->fov, 45, 8);  // versions of Assimp differ

    // One that looks away is not taken.
    const TemporaryFile away("away.gltf", test::gltf_of(test::cube(), R"([{"mesh": 0},
        {"camera": 0, "translation": [0.5, 0.5, -7]}])"));
    EXPECT_NE(read(away).start_view->eye, Vec<3>(0.5, 0.5, -7));
}

using Writer = std::string (*)(const test::Mesh&);

TEST(SceneMesh, LargeCoordinatesKeepTheirDetail) {
    // Numbers with three decimals, of a scene of 400 units far away: floats at 450,000 are 0.03 apart.
    const std::pair<const char*, Writer> formats[] = {
        {"far.obj", test::obj_of},
        {"far.off", test::off_of},
        {"far.stl", [](const test::Mesh& mesh) { return test::stl_of(mesh, false); }},
        {"far.ply", [](const test::Mesh& mesh) { return test::ply_of(mesh, false); }}};
    for (const auto& format : formats)
        for (const Vec<3> place : {Vec<3>(85000, 450000, 0), Vec<3>(1e6, -1e6, 1e6), Vec<3>(300, 0, 0)}) {
            SCOPED_TRACE(std::string(format.first) + " at " + std::to_string(place.x));
            Random random(7);
            test::Mesh mesh;
            for (std::uint32_t i = 0; i < 600; ++i) {
                Vec<3> p = place;
                for (int axis = 0; axis < 3; ++axis)
                    p[axis] += (static_cast<double>(random.below(400001)) - 2e5) / 1000;
                mesh.points.push_back(p);
                if (i % 3 == 0) mesh.faces.push_back({i, i + 1, i + 2});
            }
            if (format.first == std::string("far.obj")) mesh.points.push_back(Vec<3>(0));  // stray, in no face
            const TemporaryFile file(format.first, format.second(mesh));
            const Scene<3> scene = read(file);
            ASSERT_EQ(scene.primitives.size(), mesh.faces.size());
            const Box<3> box = bounds<3>(scene.primitives);
            for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::max(-box.min[axis], box.max[axis]), 2000);
            for (std::size_t i = 0; i < mesh.faces.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    for (int axis = 0; axis < 3; ++axis)
                        ASSERT_NEAR(scene.primitives[i][c][axis] + scene.origin[axis],
                                    mesh.points[mesh.faces[i][c]][axis], 1e-4);
        }
}

TEST(SceneMesh, ForeignLinesOfLargeFilesStayAsTheyAre) {
    // Colours behind coordinates, a comment, Windows line ends, no line end at the end.
    const TemporaryFile colours("colours.obj",
                                "# v 1 2 3\r\nv 1000000 2000000 0 1 0 0\r\nv 1000001.5 2000000 0 1 0 0\r\n"
                                "v 1000000 2000001.25 0 1 0 0\r\nvn 0 0 1\r\nf 1//1 2//1 3//1");
    Scene<3> scene = read(colours);
    ASSERT_EQ(scene.primitives.size(), 1u);
    EXPECT_EQ(scene.primitives[0][2] + scene.origin, Vec<3>(1000000, 2000001.25, 0));

    // A fourth number divides the others: not moved, as accurate as a float.
    const TemporaryFile divided("divided.obj", "v 2000000 0 0 2\nv 2000002 0 0 2\nv 2000000 2 0 2\nf 1 2 3\n");
    scene = read(divided);
    ASSERT_EQ(scene.primitives.size(), 1u);
    EXPECT_EQ(scene.primitives[0][1] + scene.origin, Vec<3>(1000001, 0, 0));
}

TEST(SceneMesh, AFolderIsOneSoup) {
    const Folder folder("soup");
    test::Mesh cube = test::cube();
    folder.write("b.obj", test::obj_of(cube));
    for (Vec<3>& p : cube.points) p += Vec<3>(10, 0, 0);
    folder.write("a/deeper/c.ply", test::ply_of(cube, true));
    for (Vec<3>& p : cube.points) p += Vec<3>(10, 0, 0);
    folder.write("z.gltf", test::gltf_of(cube, R"([{"mesh": 1}])"));
    folder.write("b copy.obj", test::obj_of(test::cube()));
    for (const char* other : {"b.mtl", "picture.png", "z.bin", "README.md", "no ending"}) folder.write(other, "x");
    folder.write("broken.stl", "nonsense");
    folder.write("empty.off", "");

    std::vector<std::string> steps;
    const MeshOptions options{false, [&](std::string_view what, double share) {
                                  if (steps.empty() || steps.back() != what) steps.emplace_back(what);
                                  EXPECT_TRUE(share >= 0 && share <= 1);
                              }};
    const Scene<3> scene = read_mesh(folder.path(), "soup", options);
    EXPECT_EQ(scene.primitives.size(), 36u);
    EXPECT_EQ(scene.dropped, (Dropped{0, 12, 0}));
    EXPECT_EQ(scene.primitives[0][0].x, 10) << "files are sorted by path";
    ASSERT_EQ(scene.two_sided.size(), 36u);
    EXPECT_EQ(scene.two_sided[23], 0);
    EXPECT_EQ(scene.two_sided[24], 1);
    ASSERT_EQ(scene.warnings.size(), 3u);
    EXPECT_EQ(scene.warnings[0].substr(0, 22), "left out: broken.stl: ");
    EXPECT_EQ(scene.warnings[1], "left out: empty.off: the file is empty");
    EXPECT_EQ(scene.warnings[2], "the files disagree on which axis points up; that of the first file is used");
    EXPECT_EQ(scene.up_axis, 2);
    EXPECT_GE(steps.size(), 6u);
    EXPECT_EQ(steps[0], "reading c.ply");

    const std::string both[] = {folder.path() + "/b.obj", folder.path() + "/a"};
    EXPECT_EQ(read_meshes(both, "both").primitives.size(), 24u);
    const std::string named[] = {folder.path() + "/b.obj", folder.path() + "/broken.stl"};
    expect_input_error([&] { read_meshes(named, "named"); }, "named: " + named[1] + ": *");
}

/// Ends what this process started; the number of processes that were there.
int kill_children() {
    int killed = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
        std::ifstream in(entry.path() / "stat");
        int process = 0, parent = 0;
        std::string name;
        char state;
        if (in >> process >> name >> state >> parent && parent == getpid()) killed += kill(process, SIGKILL) == 0;
    }
    return killed;
}

TEST(SceneMesh, AFileWhoseReaderEndsInTheMiddleLeavesNoTriangle) {
    const Folder folder("half");
    folder.write("a.obj", test::obj_of(test::cube()));
    folder.write("c.gltf", test::gltf_of(test::cube(), R"([{"mesh": 1, "translation": [3, 0, 0]}])"));
    test::Mesh large;
    for (std::uint32_t i = 0; i < 300000; ++i) {
        large.points.push_back(Vec<3>(i % 100, i / 100, i % 7));
        if (i >= 2) large.faces.push_back({i - 2, i - 1, i});
    }
    folder.write("b.dae", test::dae_of(large));
    int killed = 0;
    double last = 0;
    const MeshOptions options{false, [&](std::string_view what, double share) {
                                  // The first of three parts has come, and its sender waits to send more.
                                  if (what == "reading b.dae" && share - last > 0.2) killed += kill_children();
                                  last = share;
                              }};
    const Scene<3> scene = read_mesh(folder.path(), "half", options);
    EXPECT_EQ(killed, 1);
    ASSERT_EQ(scene.primitives.size(), 24u);
    ASSERT_EQ(scene.two_sided.size(), 24u);
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(scene.two_sided[i], i >= 12) << i;
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "left out: b.dae: the reader (Assimp) was killed (too little memory?)");
}

TEST(SceneMesh, AFolderWithoutScenesSaysSo) {
    const Folder folder("nothing");
    folder.write("readme.txt", "hello");
    expect_input_error([&] { read_mesh(folder.path(), "n"); }, "n: holds no file of a 3D format");
    folder.write("a.obj", "");
    folder.write("b.stl", "nonsense");
    expect_input_error([&] { read_mesh(folder.path(), "n"); },
                       "n: none of its files can be read; the first error is a.obj: the file is empty");
}

TEST(SceneMesh, ScenesWithoutTrianglesAreValid) {
    for (const auto& [name, bytes] : std::initializer_list<std::pair<const char*, std::string>>{
             {"comment.obj", "# a scene of nothing at all\n"},
             {"short.obj", "# none\n"},
             {"vertex.obj", "v 0 0 0\n"},
             {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n"},
             {"none.off", "OFF\n0 0 0\n"},
             {"points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"},
             {"none.ply", test::ply_of({}, false)},
             {"points.ply", test::ply_of({{Vec<3>(0), Vec<3>(1)}, {}}, true)},
             {"none.stl", test::stl_of({}, true)},
             {"none_ascii.stl", "solid x\nendsolid x\n"},
             {"none.gltf", R"({"asset": {"version": "2.0"}})"},
             {"coincident.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"}}) {
        SCOPED_TRACE(name);
        const TemporaryFile file(name, bytes);
        const Scene<3> scene = read(file);
        EXPECT_TRUE(scene.primitives.empty());
        EXPECT_EQ(scene.warnings, std::vector<std::string>{"the scene is empty: 0 primitives"});
        EXPECT_TRUE(scene.start_view);
    }
}

TEST(SceneMesh, SaysWhatIsWrong) {
    const test::Mesh cube = test::cube();
    const std::string obj = test::obj_of(cube), ply = test::ply_of(cube, true), stl = test::stl_of(cube, true);
    const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    const std::string announces = "x: ends before the 8 vertices and 12 faces that it announces";
    for (const auto& [name, bytes, line] : std::initializer_list<std::tuple<const char*, std::string, std::string>>{
             {"empty.obj", "", "x: the file is empty"},
             // Another format behind a known ending.
             {"text.obj", "Dear all, here is the text.\n", "x: line 1: \"Dear\" begins no line of an OBJ file"},
             {"short.obj", "hello\n", "x: line 1: \"hello\" begins no line of an OBJ file"},
             {"stl.obj", stl, "x: line 1: *"},
             {"obj.stl", obj, "x: *(it begins like OBJ)"},
             {"obj.ply", obj, "x: line 1: is not \"ply\", so this is no PLY file (it begins like OBJ)"},
             {"obj.off", obj, "x: line 2: begins with neither OFF nor a number of vertices (it begins like OBJ)"},
             {"png.ply", "\x89PNG\r\n\x1a\n and so on", "x: *(it begins like a PNG picture)"},
             {"lfs.glb", "version https://git-lfs.github.com/spec/v1\n",
              "x: *(it begins like a stand-in of Git LFS, not the file itself)"},
             {"text.gltf", "Dear all,\n", "x: line 1, column 1: *"},
             // Counts that lie.
             {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "x: line 4: a face refers to vertex 9 of 3"},
             {"short.ply", ply.substr(0, 300), announces},
             {"header.ply", ply.substr(0, 100), "x: its header does not end"},
             {"short.off", test::off_of(cube).substr(0, 60), announces},
             {"vertices.ply", replaced(ply, "vertex 8", "vertex 4000000000"),
              "x: ends before the 4000000000 vertices *"},
             {"faces.ply", replaced(ply, "face 12", "face 2000000000"),
              "x: ends before the 8 vertices and 2000000000 *"},
             {"vertices.off", replaced(test::off_of(cube), "8 12", "400000000 12"), "x: ends before the 400000000 *"},
             {"short.stl", stl.substr(0, 600), "x: *"},
             {"json.glb", R"({"asset": {"version": "2.0"}})", "x: *(it begins like JSON, as glTF of text)"},
             {"glb.gltf", test::glb_of(cube), "x: *(it begins like binary glTF)"},
             {"faces.stl", stl.substr(0, 80) + test::little(0x7fffffff, 4) + stl.substr(84), "x: *"},
             {"buffer.gltf", replaced(test::gltf_of(cube), "data:application", "missing"), "x: *"},
             // Numbers beyond what floats can square.
             {"large.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1e30 0\nf 1 2 3\nf 1 2 4\n",
              "x: triangle 1: coordinate 1e+30*"},
             {"tiny.obj", "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n", "x: the scene is 1.0000000*"}}) {
        SCOPED_TRACE(name);
        const TemporaryFile file(name, bytes);
        expect_input_error([&, &file = file] { read(file); }, line);
    }
    expect_input_error([] { read_mesh("/no/such.obj", "/no/such.obj"); }, "/no/such.obj: no such file");
    expect_input_error([] { read_mesh("/dev/null", "x"); }, "x: is not a regular file");
}

TEST(SceneMesh, SaysWhereFloatsAreTooCoarse) {
    test::Mesh mesh = test::pyramid_mesh();
    EXPECT_TRUE(test::read_bytes("near.dae", test::dae_of(mesh)).warnings.empty());
    for (Vec<3>& p : mesh.points) p = Vec<3>(1800216.1 + p.x / 10, 5200112.2 + p.y / 10, p.z / 10);
    EXPECT_EQ(
        test::read_bytes("far.dae", test::dae_of(mesh)).warnings,
        std::vector<std::string>{"lies so far from zero that its coordinates, read as floats, are in steps of 0.5"});
}

TEST(SceneMesh, PipesThatAModelNamesAreNotWaitedFor) {
    const Folder folder("pipes");
    std::string gltf = test::gltf_of(test::cube());
    const std::size_t uri = gltf.find("data:application");
    gltf.replace(uri, gltf.find('"', uri) - uri, "pipe.bin");
    folder.write("a.gltf", gltf);
    ASSERT_EQ(mkfifo((folder.path() + "/pipe.bin").c_str(), 0600), 0);
    expect_input_error([&] { read_mesh(folder.path() + "/a.gltf", "x"); }, "x: *");
}

TEST(SceneMesh, CountsWhatItDrops) {
    const TemporaryFile file("drops.obj",
                             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 2 0 0\nf 1 2 3\nf 2 3 1\nf 3 2 1\nf 1 2 4\n"
                             "f 1 2 5\n");
    const Scene<3> scene = read(file);
    EXPECT_EQ(scene.primitives.size(), 2u);
    EXPECT_EQ(scene.dropped, (Dropped{1, 1, 1}));
}

TEST(SceneMesh, ReadsRealFiles) {
    struct Row {
        const char *path, *format;
        std::size_t triangles;
        Vec<3> min, max;
    };
    const std::string folder = SIGHTLINE_SOURCE_DIR "/../shared/scenes/";
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is absent";
    for (const Row& row : {Row{"dungeon.obj", "obj", 10133, Vec<3>(-26, -1, -91), Vec<3>(50, 41, 9)},
                           {"dutch_ship", "gltf", 69162, Vec<3>(-11, -2, -3.5), Vec<3>(14, 23, 3.5)},
                           {"room.glb", "gltf", 63720, Vec<3>(-5, 0, -5), Vec<3>(5, 5, 5)}}) {
        SCOPED_TRACE(row.path);
        const Scene<3> scene = read_mesh(folder + row.path, row.path);
        EXPECT_EQ(scene.primitives.size() + scene.dropped.total(), row.triangles);
        EXPECT_GT(scene.primitives.size(), row.triangles * 99 / 100);
        EXPECT_EQ(scene.source, row.format);
        EXPECT_EQ(scene.up_axis, 1);
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
        EXPECT_TRUE(scene.start_view);
        const Box<3> box = bounds<3>(scene.primitives);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(box.min[axis], row.min[axis]);
            EXPECT_LE(box.max[axis], row.max[axis]);
        }
    }
}

}  // namespace
}  // namespace sightline
