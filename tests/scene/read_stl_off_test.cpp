// STL and OFF files as people write them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_off.h"
#include "core/scene/read/read_stl.h"
#include "tests/scene/mesh_files.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

using test::expect_input_error;

std::string facet(const Primitive<3>& t, bool normal) {
    std::string text = normal ? " facet normal 0 0 0\n" : " facet\n";
    text += "  outer loop\n";
    for (const Vec<3>& p : t) text += "   vertex " + test::words(p) + "\n";
    return text + "  endloop\n endfacet\n";
}

std::string solid(const std::string& name, bool normal = true) {
    std::string text = "solid " + name + "\n";
    for (const Primitive<3>& t : test::triangles_of(test::pyramid_mesh())) text += facet(t, normal);
    return text + "endsolid " + name + "\n";
}

std::string in_capitals(std::string text) {
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c += 'A' - 'a';
    return text;
}

std::string on_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

TEST(ReadStl, TextInAnyForm) {
    const std::vector<Primitive<3>> pyramid = test::triangles_of(test::pyramid_mesh());
    std::string nan = solid("a");
    for (std::size_t at = 0; (at = nan.find("0 0 0\n", at)) != nan.npos && nan[at - 2] == 'l'; ++at)
        nan.replace(at, 5, "nan -nan(ind) 1.#QNAN");
    for (const std::string& text :
         {solid("a"), solid(""), in_capitals(solid("one")), solid("without normals", false), on_one_line(solid("a b")),
          on_one_line(solid("")), nan, "\xef\xbb\xbf" + solid("a")}) {
        SCOPED_TRACE(text);
        const ParsedMesh mesh = read_stl(text, {});
        EXPECT_EQ(mesh.triangles, pyramid);
        EXPECT_TRUE(mesh.warnings.empty());
        EXPECT_TRUE(mesh.objects.empty());
    }
    EXPECT_EQ(read_stl("solid x\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n"
                       "endfacet\nendsolid",
                       {})
                  .triangles.size(),
              2u);
    const ParsedMesh two = read_stl(solid("wall one") + solid("roof"), {});
    EXPECT_EQ(two.objects.names, (std::vector<std::string>{"wall one", "roof"}));
    EXPECT_EQ(two.objects.of, (std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}));
    EXPECT_EQ(read_stl("solid a\n" + facet(pyramid[0], true), {}).warnings,
              std::vector<std::string>{"ends before \"endsolid\": facets may be missing"});
}

TEST(ReadStl, BinaryThatIsLongerOrShorterThanItSays) {
    const std::string file = test::stl_of(test::pyramid_mesh(), true);
    const std::vector<Primitive<3>> pyramid = test::triangles_of(test::pyramid_mesh());
    EXPECT_EQ(read_stl(file, {}).triangles, pyramid);
    EXPECT_EQ(read_stl("solid" + file.substr(5), {}).triangles, pyramid);
    ParsedMesh mesh = read_stl(file + "trailing notes of the exporter", {});
    EXPECT_EQ(mesh.triangles, pyramid);
    EXPECT_TRUE(mesh.warnings.empty());
    EXPECT_EQ(read_stl("solid" + file.substr(5) + "notes", {}).triangles, pyramid);
    mesh = read_stl(file + file.substr(84, 50), {});
    EXPECT_EQ(mesh.triangles, pyramid);
    EXPECT_EQ(mesh.warnings, std::vector<std::string>{"50 bytes follow the 6 facets that it announces"});
    std::string nine = file;
    nine[80] = 9;
    expect_input_error([&] { read_stl(nine, {}); }, "ends before the 9 facets that it announces");
    nine[83] = 0x7f;
    expect_input_error([&] { read_stl(nine, {}); }, "ends before the 2130706441 facets that it announces");
}

TEST(ReadStl, SaysWhatIsWrong) {
    const std::string begin = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
    const std::string end = "endloop\nendfacet\nendsolid x\n";
    for (const auto& [text, line] : std::initializer_list<std::pair<std::string, std::string>>{
             {"nonsense", "is no STL file: neither \"solid\" nor a binary header begins it"},
             {std::string(3000, '\0'), "2916 bytes follow the 0 facets that it announces"},
             {begin + end, "line 7: a facet has 2 corners"},
             {begin + "vertex 0 1 x\n" + end, "line 6: \"x\" is no number"},
             {begin + "vertex 0 1\n" + end, "line 7: \"endloop\" is no number"},
             {begin + "corner 0 1 0\n" + end, "line 6: \"corner\" is out of place in an STL file"},
             {begin, "ends in the middle of a facet"},
             {"solid x\nfacet normal 0 0 1 2 3\nouter loop\n", "line 2: \"2\" is out of place in an STL file"},
             {"solid x\nendsolid\nfacet\n", "line 3: \"facet\" is out of place in an STL file"}}) {
        SCOPED_TRACE(text);
        expect_input_error([&, &text = text] { read_stl(text, {}); }, line);
    }
}

std::string off_faces() {
    std::string text;
    for (const auto& f : test::pyramid_mesh().faces) text += "3 " + test::words(f, 0) + "\n";
    return text;
}

std::string off_points(const std::string& more = "") {
    std::string text;
    for (const Vec<3>& p : test::pyramid_mesh().points) text += test::words(p) + more + "\n";
    return text;
}

TEST(ReadOff, TextInAnyForm) {
    for (const std::string& text :
         {"OFF\n5 6 0\n" + off_points() + off_faces(), "off\n5 6 0\n" + off_points() + off_faces(),
          "OFF 5 6 0\n" + off_points() + off_faces(), "5 6 0\n" + off_points() + off_faces(),
          "OFF # a\n    # indented\n\n5 6 # no edges\n" + off_points(" # here") + "\n  # there\n" + off_faces(),
          "OFF\n5\n6\n0\n" + off_points() + off_faces(), on_one_line("OFF 5 6 0 " + off_points() + off_faces()),
          on_one_line("NOFF 5 6 0 " + off_points(" 0 0 1") + off_faces()),
          on_one_line("STCOFF 5 6 0 " + off_points(" 1 0 0 1 .5 .5") + off_faces()),
          "COFF\n5 6 0\n" + off_points(" 255 0 0") + off_faces(), "OFF\n5 6 0\n" + off_points(" 9") + off_faces(),
          "\xef\xbb\xbfOFF\r\n5 6 0\r\n" + off_points() + off_faces()}) {
        SCOPED_TRACE(text);
        const ParsedMesh mesh = read_off(text, {});
        EXPECT_EQ(mesh.triangles, test::triangles_of(test::pyramid_mesh()));
        EXPECT_TRUE(mesh.warnings.empty());
    }
    const ParsedMesh coloured = read_off("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n2 0 1 7\n", {});
    EXPECT_EQ(coloured.triangles.size(), 2u);
    EXPECT_EQ(coloured.warnings, std::vector<std::string>{"1 face of fewer than 3 corners is left out"});
}

TEST(ReadOff, SaysWhatIsWrong) {
    const std::string three = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    for (const auto& [text, line] : std::initializer_list<std::pair<std::string, std::string>>{
             {"Dear all", "line 1: begins with neither OFF nor a number of vertices"},
             {"4OFF\n1 1 1\n", "line 1: OFF with other than three coordinates a vertex is not read"},
             {"OFF BINARY\n", "line 1: binary OFF is not read"},
             {"OFF\n3 x 0\n", "line 2: \"x\" is no number of vertices, faces or corners"},
             {"OFF\n3 -1 0\n", "line 2: \"-1\" is no number of vertices, faces or corners"},
             {"OFF\n3", "line 2: \"\" is no number of vertices, faces or corners"},
             {three + "3 0 1 3\n", "line 6: face 0 refers to vertex 3 of 3"},
             {three + "3 0 1 -1\n", "line 6: face 0 refers to vertex -1 of 3"},
             {three + "3 0 1\n", "ends before the 3 vertices and 1 faces that it announces"},
             {three + "3000000000 0 1 2\n", "ends before the 3 vertices and 1 faces that it announces"},
             {"OFF\n3 1 0\n0 0 0\n1 y 0\n", "ends before the 3 vertices and 1 faces that it announces"},
             {"OFF\n3 1 0\n0 0 0\n1 y 0\n0 0 0\n3 0 1 2\n", "line 4: \"y\" is no number"},
             {"OFF\n400000000 1 0\n0 0 0\n", "ends before the 400000000 vertices and 1 faces that it announces"}}) {
        SCOPED_TRACE(text);
        expect_input_error([&, &text = text] { read_off(text, {}); }, line);
    }
}

}  // namespace
}  // namespace sightline
