// PLY files of all kinds: what is read, and what is said of the rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_ply.h"

#include <algorithm>

#include "tests/scene/mesh_files.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

using test::expect_input_error;
using test::read_bytes;

ParsedMesh parse_ply(const std::string& text) { return read_ply(text, {}); }

std::string ply_header_of(const std::string& format, const std::string& lines) {
    return "ply\nformat " + format + " 1.0\n" + lines + "end_header\n";
}
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string faces_of_int = "property list uchar int vertex_indices\n";

template <typename T>
std::string bytes_of_number(T value, bool big) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

TEST(ReadPly, BothByteOrdersAllTypesAndPropertiesInAnyOrder) {
    const test::Mesh pyramid = test::pyramid_mesh();
    for (const bool big : {false, true}) {
        std::string file = ply_header_of(big ? "binary_big_endian" : "binary_little_endian",
                                         "comment element face 99\nobj_info x\nelement camera 1\nproperty double a\n"
                                         "property list ushort short b\nelement vertex 5\nproperty uchar red\n"
                                         "property double z\nproperty int16 x\nproperty list uint8 float64 extra\n"
                                         "property float32 y\nelement face 6\nproperty ushort material\n"
                                         "property list int uint vertex_index\nproperty list uchar float texcoord\n"
                                         "element edge 2\nproperty int8 vertex1\n");
        file += bytes_of_number(0.5, big) + bytes_of_number<std::uint16_t>(2, big) +
                bytes_of_number<std::int16_t>(-1, big) + bytes_of_number<std::int16_t>(7, big);
        for (const Vec<3>& p : pyramid.points)
            file += '\xff' + bytes_of_number(p.z, big) + bytes_of_number(static_cast<std::int16_t>(p.x), big) + '\1' +
                    bytes_of_number(4.0, big) + bytes_of_number(static_cast<float>(p.y), big);
        for (const auto& f : pyramid.faces) {
            file += bytes_of_number<std::uint16_t>(3, big) + bytes_of_number<std::int32_t>(3, big);
            for (const std::uint32_t k : f) file += bytes_of_number(k, big);
            file += '\1' + bytes_of_number(0.25f, big);
        }
        file += "ab";
        const ParsedMesh mesh = parse_ply(file);
        EXPECT_EQ(mesh.triangles, test::triangles_of(pyramid));
        EXPECT_TRUE(mesh.warnings.empty());
        EXPECT_FALSE(mesh.single_precision);
        expect_input_error([&] { parse_ply(file.substr(0, file.size() - 3)); },
                           "ends before the 5 vertices and 6 faces that it announces");
    }
}

TEST(ReadPly, TextInAnyForm) {
    const std::string wanted = ply_header_of("ascii", "element vertex 3\n" + xyz + "element face 1\n" + faces_of_int);
    const std::vector<Primitive<3>> one = {{Vec<3>(0), Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)}};
    for (std::string file : {wanted + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", wanted + "0 0 0\n\n1 0\n 0\n0 1 0\n3 0 1 2",
                             "\xef\xbb\xbf" + wanted + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"})
        for (const bool wide : {false, true}) {
            if (wide)
                for (std::size_t at = 0; (at = file.find('\n', at)) != file.npos; at += 2) file.replace(at, 1, "\r\n");
            SCOPED_TRACE(file);
            EXPECT_EQ(parse_ply(file).triangles, one);
            EXPECT_TRUE(parse_ply(file).warnings.empty());
        }
    const ParsedMesh more = parse_ply(wanted + "0 0 0 255\n1 0 0 255\n0 1 0 255\n3 0 1 2\n");
    EXPECT_EQ(more.triangles, one);
    EXPECT_EQ(more.warnings, std::vector<std::string>{"line 10: holds more values than the header announces"});
}

TEST(ReadPly, FacesBeforeVerticesAndPolygons) {
    const ParsedMesh mesh =
        parse_ply(ply_header_of("ascii", "element face 3\n" + faces_of_int + "element vertex 4\n" + xyz) +
                  "4 0 1 2 3\n2 0 1\n3 3 2 1\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n");
    EXPECT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.triangles[2][0], Vec<3>(0, 1, 0));
    EXPECT_EQ(mesh.warnings, std::vector<std::string>{"1 face of fewer than 3 corners is left out"});
}

TEST(ReadPly, TriangleStrips) {
    const std::string header =
        ply_header_of("ascii", "comment element face 99\nelement vertex 5\n" + xyz +
                                   "element tristrips 1\nproperty list int int vertex_indices\n") +
        "0 0 0\n2 0 0\n2 0 2\n0 0 2\n1 3 1\n";
    const Scene<3> scene = read_bytes("strips.ply", header + "20 0 1 3 2 -1 0 4 1 -1 1 4 2 -1 2 4 3 -1 3 4 0\n");
    ASSERT_EQ(scene.primitives.size(), 6u);
    EXPECT_EQ(scene.primitives[0], (Primitive<3>{Vec<3>(0), Vec<3>(2, 0, 0), Vec<3>(0, 0, 2)}));
    const Vec<3> inside(1, 1, 1);
    for (const Primitive<3>& t : scene.primitives)
        EXPECT_GT(glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), t[0] - inside), 0) << "its front is outside";
    expect_input_error([&] { parse_ply(header + "4 0 1 3 5\n"); }, "line 16: tristrips 0 refers to vertex 5 of 5");
    expect_input_error([&] { parse_ply(header + "20 0 1 3 2\n"); },
                       "ends before the 5 vertices and 1 triangle strips that it announces");
}

TEST(ReadPly, FarDoublesKeepTheirDetailAndFarFloatsSaySo) {
    test::Mesh mesh = test::pyramid_mesh();
    for (Vec<3>& p : mesh.points) p = Vec<3>(1800216.1 + p.x / 10, 5200112.2 + p.y / 10, p.z / 10);
    std::string file = ply_header_of("binary_little_endian",
                                     "element vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
                                     "element face 6\n" +
                                         faces_of_int);
    for (const Vec<3>& p : mesh.points)
        for (int axis = 0; axis < 3; ++axis) file += bytes_of_number(p[axis], false);
    for (const auto& f : mesh.faces) {
        file += '\3';
        for (const std::uint32_t k : f) file += bytes_of_number(k, false);
    }
    const Scene<3> scene = read_bytes("far.ply", file);
    EXPECT_TRUE(scene.warnings.empty());
    const Vec<3> size = bounds<3>(scene.primitives).extent();
    EXPECT_NEAR(size.x, 0.2, 1e-6);
    EXPECT_NEAR(size.y, 0.3, 1e-6);
    EXPECT_NEAR(size.z, 0.2, 1e-6);
    EXPECT_EQ(
        read_bytes("far.ply", test::ply_of(mesh, true)).warnings,
        std::vector<std::string>{"lies so far from zero that its coordinates, read as floats, are in steps of 0.5"});
}

TEST(ReadPly, SaysWhatIsWrong) {
    const std::string vertices = "element vertex 3\n" + xyz, three = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string good = ply_header_of("ascii", vertices + "element face 2\n" + faces_of_int);
    for (const auto& [file, line] : std::initializer_list<std::pair<std::string, std::string>>{
             {"plyx\n", "line 1: is not \"ply\", so this is no PLY file"},
             {"ply", "its header does not end"},
             {"ply\nformat ascii 1.0\nelement vertex 3\n", "its header does not end"},
             {"ply\nelement vertex 0\nend_header\n", "its header does not say whether it is text or binary"},
             {"ply\nformat zip 1.0\nend_header\n", "line 2: \"zip\" is no format of PLY"},
             {ply_header_of("ascii", "element vertex -3\n"), "line 3: \"-3\" is no number of elements"},
             {ply_header_of("ascii", "element vertex\n"), "line 3: \"\" is no number of elements"},
             {ply_header_of("ascii", "property int x\n"), "line 3: a property stands before the first element"},
             {ply_header_of("ascii", vertices + "property long w\n"), "line 7: \"long\" is no type of PLY"},
             {ply_header_of("ascii", vertices + vertices), "line 7: the element vertex stands twice"},
             {ply_header_of("ascii", "vertices 3\n"), "line 3: \"vertices\" begins no line of a PLY header"},
             {good + three + "3 0 1 2\n3 0 1 3\n", "line 14: face 1 refers to vertex 3 of 3"},
             {good + three + "3 0 1 2\n3 0 -1 2\n", "line 14: face 1 refers to vertex -1 of 3"},
             {good + three + "3 0 1 2\n3 0 1.5 2\n", "line 14: face 1 refers to vertex 1.5 of 3"},
             {good + three + "3 0 1 2\n-3 0 1 2\n", "line 14: face 1 has a list of -3 values"},
             {good + three + "3 0 1 2\n3 0 1\n", "ends before the 3 vertices and 2 faces that it announces"},
             {good + three + "3 0 1 2\n4000000000 0 1\n", "ends before the 3 vertices and 2 faces that it announces"},
             {good + "0 0 0\n1 zero 0\n", "line 11: \"zero\" is no number"},
             {ply_header_of("ascii",
                            "element vertex 3\nproperty int x\nproperty int y\nelement face 1\n" + faces_of_int) +
                  "0 0\n1 0\n0 1\n3 0 1 2\n",
              "its vertices have no z"},
             {ply_header_of("ascii", vertices + "element face 1\nproperty list int int corners\n") + three +
                  "3 0 1 2\n",
              "its element face has no list vertex_indices"},
             {ply_header_of("ascii", "element face 1\n" + faces_of_int) + "3 0 1 2\n", "has faces and no vertices"},
             {ply_header_of("ascii", vertices + "element quads 1\n" + faces_of_int) + three + "4 0 1 2 0\n",
              "its element quads holds indices of vertices and is not read"},
             {ply_header_of("binary_little_endian",
                            "element vertex 999999999999\n" + xyz + "element face 1\n" + faces_of_int),
              "ends before the 999999999999 vertices and 1 faces that it announces"},
             {ply_header_of("ascii", vertices + "element face 999999999999\n" + faces_of_int) + three,
              "ends before the 3 vertices and 999999999999 faces that it announces"}}) {
        SCOPED_TRACE(file);
        expect_input_error([&, &file = file] { parse_ply(file); }, line);
    }
    const ParsedMesh both = parse_ply(
        ply_header_of("ascii", vertices + "element quads 1\n" + faces_of_int + "element face 1\n" + faces_of_int) +
        three + "4 0 1 2 0\n3 0 1 2\n");
    EXPECT_EQ(both.triangles.size(), 1u);
    EXPECT_EQ(both.warnings, std::vector<std::string>{"its element quads holds indices of vertices and is not read"});
}

}  // namespace
}  // namespace sightline
