// OBJ files as people write them: what is read, and what is said of the rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include "core/scene/read/read_obj.h"
#include "tests/scene/mesh_files.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

using test::expect_input_error;
using test::read_bytes;
using Triangles = std::vector<Primitive<3>>;

ParsedMesh parse_obj(const std::string& text) { return read_obj(text, {}); }

const Vec<3> zero(0), x1(1, 0, 0), y1(0, 1, 0), z1(0, 0, 1);

TEST(ReadObj, VerticesAndFacesInAnyForm) {
    const std::string four = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const Triangles both = {{zero, x1, y1}, {zero, x1, z1}};
    const Triangles one = {{zero, x1, y1}};
    for (const auto& [text, triangles] : std::initializer_list<std::pair<std::string, Triangles>>{
             {four + "f 1 2 3\nf 1 2 4\n", both},
             {four + "  f 1 2 3\nf 1 2 4\n", both},               // indented
             {"\xef\xbb\xbf" + four + "f 1 2 3\nf 1 2 4", both},  // a mark, no end of the last line
             {four + "f 1 2 3 # a face\n# f 1 2 3\n\t# f 1 2 3\nf 1 2 4#another\n", both},
             {"v 0 0 0 # corner 1\nv 1 0 0# corner 2\nv 0 1 0 # corner 4\nf 1 2 3\n", one},
             {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", one},
             {"v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", one},
             {"v 0 0 \\\n0\nv 1 \\\r\n 0 0\nv 0 1 0\nf 1 2 \\\n\\\n3\n", one},
             {"v 0 0 0\nv 1 0 0\nv 0 1 0\n# no end \\\nf 1 2 3\n", one},
             {"v 0 0 0\nv 1 0 0\nv 0 1 0 # no end \\\nf 1 2 3\n", one},
             {"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", one},  // vertices later
             {four + "f -4 -3 -2\nv 9 9 9\nf -5//7 -4/ -2\n", both},
             {four + "f 1/1 2/2 3/3\nf 1/1/1 2/9/2 4//3\n", both},  // textures and normals that are not there
             {"v\t+0 -0. .0\nv 1e0 0E5 0\nv 0 10.0e-1 0\nfo 1 2 3\n", one},
             {"v 0 0 0 2\nv 2 0 0 2\nv 0 3 0 3\nf 1 2 3\n", one},                 // divided
             {"v 0 0 0 1 0 0\nv 1 0 0 .5 .5 .5\nv 0 1 0 0 0 1\nf 1 2 3\n", one},  // coloured
             {"mtllib no_such.mtl\nusemtl red\ns off\nvt 0 0\nvn 0 0 1\np 1\nl 1 2\n" + four + "f 1 2 3\n", one}}) {
        SCOPED_TRACE(text);
        const ParsedMesh mesh = parse_obj(text);
        EXPECT_EQ(mesh.triangles, triangles);
        EXPECT_TRUE(mesh.objects.empty());
        EXPECT_TRUE(mesh.warnings.empty()) << mesh.warnings[0];
    }
    EXPECT_EQ(parse_obj("v 0 0 0\nv 1 0 0\nv .5 1 0\nv 0 0 1\nv 9 9 9\nf 1 2 3\nf 1 2 4\n").triangles,
              (Triangles{{zero, x1, Vec<3>(0.5, 1, 0)}, {zero, x1, z1}}));
}

TEST(ReadObj, NumbersAreDoubles) {
    const ParsedMesh mesh = parse_obj("v 1800216.1 5200112.2 1e-400\nv 0.1 1e999 nan\nv 1.#QNAN -1.#IND 0\nf 1 2 3\n");
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.triangles[0][0], Vec<3>(1800216.1, 5200112.2, 0));
    EXPECT_EQ(mesh.triangles[0][1].x, 0.1);
    EXPECT_EQ(mesh.triangles[0][1].y, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(mesh.triangles[0][1].z));
    EXPECT_TRUE(std::isnan(mesh.triangles[0][2].x) && std::isnan(mesh.triangles[0][2].y));
}

TEST(ReadObj, FarModelsKeepTheirDetail) {
    const Scene<3> scene = read_bytes("far.obj",
                                      "v 1800216.1 5200112.2 900000\nv 1800216.3 5200112.2 900000\n"
                                      "v 1800216.2 5200112.5 900000.1\nf 1 2 3\n");
    EXPECT_TRUE(scene.warnings.empty());
    const Vec<3> size = bounds<3>(scene.primitives).extent();
    EXPECT_NEAR(size.x, 0.2, 1e-6);
    EXPECT_NEAR(size.y, 0.3, 1e-6);
    EXPECT_NEAR(size.z, 0.1, 1e-6);
}

TEST(ReadObj, GroupsAreObjectsUnlessThereAreObjects) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const std::string groups = "f 1 2 3\ng wall\nf 1 2 3 4\ng roof top # 2\nf 1 2 4\ng\nf 1 3 4\ng wall\nf 2 3 4\n";
    ParsedMesh mesh = parse_obj(vertices + groups);
    EXPECT_EQ(mesh.objects.names, (std::vector<std::string>{"default", "wall", "roof top # 2"}));
    EXPECT_EQ(mesh.objects.of, (std::vector<std::uint32_t>{0, 1, 1, 2, 0, 1}));

    mesh = parse_obj(vertices + "f 1 2 3\no  house \\\n one\ng wall\nf 1 2 4\no tree\ng wall\nf 1 3 4\n");
    EXPECT_EQ(mesh.objects.names, (std::vector<std::string>{"", "house   one", "tree"}));
    EXPECT_EQ(mesh.objects.of, (std::vector<std::uint32_t>{0, 1, 2}));

    const Scene<3> scene =
        read_bytes("objects.obj", vertices + "o\nf 1 2 3\no a\nf 1 2 4\no none of these\no b\nf 1 3 4\n");
    EXPECT_EQ(scene.objects.names, (std::vector<std::string>{"unnamed", "a", "b"}));
}

TEST(ReadObj, ObjectsOfSeveralFilesBearTheirNames) {
    const test::Folder folder("obj_objects");
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng wall\nf 1 2 3\ng roof\nf 3 2 1\n");
    folder.write("b.obj", "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\n");
    folder.write("c.obj", "v 9 0 0\nv 8 0 0\nv 9 1 0\ng wall\nf 1 2 3\n");
    const Scene<3> scene = read_mesh(folder.path(), "x");
    EXPECT_EQ(scene.objects.names, (std::vector<std::string>{"a.obj: wall", "a.obj: roof", "b.obj", "c.obj: wall"}));
    EXPECT_EQ(scene.objects.of, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(ReadObj, SaysWhatIsWrongAndWhere) {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const auto& [text, line] : std::initializer_list<std::pair<std::string, std::string>>{
             {"f 1 2 3", "line 1: a face refers to vertex 1 of 0"},
             {three + "f 1 2 4\n", "line 4: a face refers to vertex 4 of 3"},
             {three + "f 0 1 2\n", "line 4: a face refers to vertex 0 of 3"},
             {three + "\nf -4 1 2\nv 0 0 1\n", "line 5: a face refers to vertex -4 of 3"},
             {three + "f 1 2 99999999999999999999\n", "line 4: a face refers to vertex 99999999999999999999 of 3"},
             {three + "f 1 2 x\n", "line 4: \"x\" is no corner of a face"},
             {three + "f 1 2 3.5\n", "line 4: \"3.5\" is no corner of a face"},
             {three + "f 1 2 3/a\n", "line 4: \"3/a\" is no corner of a face"},
             {three + "f /1 2 3\n", "line 4: \"/1\" is no corner of a face"},
             {"v 0 0 0\nv 1 0 \\\n# x\nv 0 1 0\n", "line 2: a vertex needs three numbers"},
             {"v 0 0 0\r\nv 1 0 0x\r\n", "line 2: \"0x\" is no number"},
             {"v 0 0 0\rv 1 0 0x\r", "line 2: \"0x\" is no number"},
             {"v 1 2 3 v 4 5 6\n", "line 1: \"v\" is no number"},
             {"v 1,5 2 3\n", "line 1: \"1,5\" is no number"},
             {"Dear all\n", "line 1: \"Dear\" begins no line of an OBJ file"},
             {"v 0 0 0\n\ncstype bezier\ncurv 0 1 1\n",
              "line 3: free-form curves and surfaces (cstype) are not read, and it holds no faces"}}) {
        SCOPED_TRACE(text);
        expect_input_error([&, &text = text] { parse_obj(text); }, line);
    }
}

TEST(ReadObj, RefusesWhatTheMachineCannotHold) {
    expect_input_error([] { check_memory(std::uint64_t{1} << 50, 0); },
                       "holds 1125899906842624 triangles, which need 1.08e+08 GB of memory; this machine has *");
    check_memory(1000, 1000);
}

TEST(ReadObj, WarnsOfWhatItLeavesOut) {
    const ParsedMesh mesh =
        parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\nf 1\ncurv2 1 2\ncall other.obj\nfoo\nf 1 3 2\n");
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.warnings,
              (std::vector<std::string>{"line 7: free-form curves and surfaces (curv2) are not read",
                                        "line 8: \"call\" begins no line of an OBJ file; 2 such lines are left out",
                                        "line 4: a face has fewer than 3 corners; 2 such lines are left out"}));
}

TEST(ReadObj, OpensNoFileThatAModelNames) {
    const test::Folder folder("obj_fifo");
    ASSERT_EQ(mkfifo((folder.path() + "/a.mtl").c_str(), 0600), 0);
    folder.write("a.obj", "mtllib a.mtl\nusemtl red\n" + test::obj_of(test::cube()));
    EXPECT_EQ(read_mesh(folder.path() + "/a.obj", "x").primitives.size(), 12u);
    ASSERT_EQ(mkfifo((folder.path() + "/b.obj").c_str(), 0600), 0);
    expect_input_error([&] { read_mesh(folder.path() + "/b.obj", "x"); }, "x: is not a regular file");
}

}  // namespace
}  // namespace sightline
