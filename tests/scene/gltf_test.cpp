// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <cmath>

#include "core/base/random.h"
#include "core/scene/read/read_mesh.h"
#include "tests/scene/mesh_files.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using test::expect_input_error;
using test::Folder;
using test::little;
using test::TemporaryFile;

std::string floats(std::initializer_list<double> values) {
    std::string bytes;
    for (const double value : values) {
        const auto single = static_cast<float>(value);
        std::uint32_t bits;
        std::memcpy(&bits, &single, 4);
        bytes += little(bits, 4);
    }
    return bytes;
}

std::string shorts(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values) bytes += little(static_cast<std::uint32_t>(value), 2);
    return bytes;
}

/// A file of numbers: each array has a bufferView of its own.
struct Gltf {
    std::string buffer, views, accessors;
    std::string nodes = R"([{"mesh": 0}])", scenes = R"("scenes": [{"nodes": [0]}],)", more;
    std::string asset = R"({"version": "2.0"})";
    std::size_t count = 0;

    /// The number of the accessor. `format`: componentType, count and type as JSON.
    std::size_t add(const std::string& bytes, const std::string& format, const std::string& view = "") {
        views += (count ? ", " : "") + (R"({"buffer": 0, "byteOffset": )" + std::to_string(buffer.size())) +
                 R"(, "byteLength": )" + std::to_string(bytes.size()) + view + "}";
        accessors += (count ? ", " : "") + (R"({"bufferView": )" + std::to_string(count)) + ", " + format + "}";
        buffer += bytes + std::string((4 - bytes.size() % 4) % 4, '\0');
        return count++;
    }
    std::string text(const std::string& meshes, const std::string& uri = "") const {
        return R"({"asset": )" + asset + ", " + scenes + more + R"( "nodes": )" + nodes + R"(, "meshes": )" + meshes +
               R"(, "buffers": [{"byteLength": )" + std::to_string(buffer.size()) + R"(, "uri": ")" +
               (uri.empty() ? "data:application/octet-stream;base64," + test::base64(buffer) : uri) +
               R"("}], "bufferViews": [)" + views + R"(], "accessors": [)" + accessors + "]}";
    }
};

constexpr const char* vectors_5 = R"("componentType": 5126, "count": 5, "type": "VEC3")";
constexpr const char* one_mesh = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])";

std::string pyramid_points() { return floats({0, 0, 0, 2, 0, 0, 2, 0, 2, 0, 0, 2, 1, 3, 1}); }
std::string pyramid_indices() { return shorts({0, 1, 2, 0, 2, 3, 0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0}); }
constexpr const char* indices_18 = R"("componentType": 5123, "count": 18, "type": "SCALAR")";

/// 2 x 3 x 2, accessors 0 and 1.
Gltf pyramid() {
    Gltf gltf;
    gltf.add(pyramid_points(), vectors_5);
    gltf.add(pyramid_indices(), indices_18);
    return gltf;
}

Scene<3> read_text(const std::string& text) {
    // Tests run beside each other.
    const TemporaryFile file(std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".gltf",
                             text);
    return read_mesh(file.path(), "x");
}

void expect_extent(const Scene<3>& scene, std::size_t triangles, const Vec<3>& extent) {
    EXPECT_EQ(scene.primitives.size(), triangles);
    const Vec<3> found = bounds<3>(scene.primitives).extent();
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], extent[axis], 1e-6);
}

TEST(Gltf, ReadsWholeNumbersAsPositions) {
    Gltf gltf;
    gltf.more = R"("extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"],)";
    gltf.nodes = R"([{"mesh": 0, "scale": [0.001, 0.001, 0.001]}])";
    // Each vertex takes 8 bytes, of which 6 are used.
    std::string points;
    for (const std::array<int, 3>& p :
         {std::array{0, 0, 0}, {2000, 0, 0}, {2000, 0, 2000}, {0, 0, 2000}, {1000, 3000, 1000}})
        points += shorts({p[0], p[1], p[2], 77});
    gltf.add(points, R"("componentType": 5122, "count": 5, "type": "VEC3")", R"(, "byteStride": 8)");
    gltf.add(pyramid_indices(), indices_18);
    expect_extent(read_text(gltf.text(one_mesh)), 6, Vec<3>(2, 3, 2));

    // Whole numbers that stand for fractions: -32768 is -1.
    Gltf fractions;
    fractions.add(shorts({-32768, 0, 0, 32767, 0, 0, 0, 32767, 0}),
                  R"("componentType": 5122, "normalized": true, "count": 3, "type": "VEC3")");
    expect_extent(read_text(fractions.text(R"([{"primitives": [{"attributes": {"POSITION": 0}}]}])")), 1,
                  Vec<3>(2, 1, 0));
}

TEST(Gltf, RequirementsThatAreNotKnownAreRefusedByName) {
    Gltf gltf = pyramid();
    gltf.more = R"("extensionsUsed": ["EXT_made_up"], "extensionsRequired": ["EXT_made_up"],)";
    expect_input_error([&] { read_text(gltf.text(one_mesh)); },
                       "x: /extensionsRequired: needs the extension EXT_made_up, which is not supported");
    gltf.more = R"("extensionsUsed": ["EXT_made_up"],)";
    EXPECT_EQ(read_text(gltf.text(one_mesh)).primitives.size(), 6u);
    gltf.more = R"("extensionsRequired": ["KHR_materials_unlit", "KHR_texture_transform"],)";
    EXPECT_EQ(read_text(gltf.text(one_mesh)).primitives.size(), 6u);
    gltf.more = R"("extensionsRequired": ["KHR_draco_mesh_compression"],)";
    expect_input_error([&] { read_text(gltf.text(one_mesh)); },
                       "x: /extensionsRequired: needs the extension KHR_draco*");
    gltf.more = "";
    gltf.asset = R"({"version": "2.0", "minVersion": "2.1"})";
    expect_input_error([&] { read_text(gltf.text(one_mesh)); },
                       "x: /asset/minVersion: needs a reader of glTF 2.1; 2.0 is supported");
    gltf.asset = R"({"version": "2.1"})";
    EXPECT_EQ(read_text(gltf.text(one_mesh)).primitives.size(), 6u);
}

TEST(Gltf, SaysWhatItLeavesOut) {
    Gltf gltf;
    gltf.add(pyramid_points(), vectors_5);
    gltf.add(shorts({0, 1, 2, 0, 2, 3, 0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 77, 0}), indices_18);
    Scene<3> scene = read_text(gltf.text(R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1},
        {"attributes": {"POSITION": 0}, "mode": 0}, {"attributes": {}}]}])"));
    EXPECT_EQ(scene.primitives.size(), 5u);
    EXPECT_EQ(scene.warnings,
              (std::vector<std::string>{"1 triangle left out: the indices do not exist (vertex 77 of 5)",
                                        "1 primitive of points or lines left out",
                                        "1 primitive without positions left out"}));
    gltf = pyramid();
    gltf.scenes = "";
    EXPECT_EQ(read_text(gltf.text(one_mesh)).warnings,
              (std::vector<std::string>{"the file names no scene, so nothing of its 1 mesh is shown",
                                        "the scene is empty: 0 primitives"}));
    gltf.scenes = R"("scenes": [{"nodes": []}, {"nodes": [0]}], "scene": 1,)";
    scene = read_text(gltf.text(one_mesh));
    EXPECT_EQ(scene.primitives.size(), 6u);
    EXPECT_EQ(scene.warnings, std::vector<std::string>{"1 other scene of the file left out"});
    gltf.scenes = R"("scenes": [{"nodes": []}],)";
    EXPECT_EQ(read_text(gltf.text(one_mesh)).warnings.front(), "1 node with a mesh left out: no scene has them");
}

TEST(Gltf, FindsBuffersByNamesWithPercentSigns) {
    const Folder folder("gltf_uri");
    const Gltf gltf = pyramid();
    folder.write(
        "my b\xc3\xbc"
        "ffer.bin",
        gltf.buffer);
    folder.write("a.gltf", gltf.text(one_mesh, "my%20b%C3%BCffer.bin"));
    expect_extent(read_mesh(folder.path() + "/a.gltf", "x"), 6, Vec<3>(2, 3, 2));
    folder.write("100%25.bin", gltf.buffer);  // a name as it stands
    folder.write("b.gltf", gltf.text(one_mesh, "100%25.bin"));
    expect_extent(read_mesh(folder.path() + "/b.gltf", "x"), 6, Vec<3>(2, 3, 2));
    folder.write("c.gltf", gltf.text(one_mesh, "missing.bin"));
    expect_input_error([&] { read_mesh(folder.path() + "/c.gltf", "x"); },
                       "x: /buffers/0: " + folder.path() + "/missing.bin: no such file");
    // Waiting for what nobody writes would take for ever.
    ASSERT_EQ(mkfifo((folder.path() + "/pipe.bin").c_str(), 0600), 0);
    folder.write("d.gltf", gltf.text(one_mesh, "pipe.bin"));
    expect_input_error([&] { read_mesh(folder.path() + "/d.gltf", "x"); },
                       "x: /buffers/0: " + folder.path() + "/pipe.bin: is not a regular file");
    folder.write("e.gltf", gltf.text(one_mesh, "https://example.org/a.bin"));
    expect_input_error([&] { read_mesh(folder.path() + "/e.gltf", "x"); },
                       "x: /buffers/0: lies at https://example.org/a.bin: only files beside the model are read");
    folder.write("short.bin", gltf.buffer.substr(0, 90));
    folder.write("f.gltf", gltf.text(one_mesh, "short.bin"));
    expect_input_error([&] { read_mesh(folder.path() + "/f.gltf", "x"); },
                       "x: /buffers/0: has 90 of the 96 bytes that it announces");
}

TEST(Gltf, MorphsByTheDefaultWeights) {
    Gltf gltf = pyramid();
    gltf.add(floats({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0}), vectors_5);
    const std::string primitive =
        R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "targets": [{"POSITION": 2}]}], )";
    expect_extent(read_text(gltf.text(primitive + R"("weights": [1]}])")), 6, Vec<3>(2, 9, 2));
    gltf.nodes = R"([{"mesh": 0, "weights": [0.5]}])";  // of the node first
    expect_extent(read_text(gltf.text(primitive + R"("weights": [1]}])")), 6, Vec<3>(2, 6, 2));
    gltf.nodes = R"([{"mesh": 0}])";
    expect_extent(read_text(gltf.text(primitive + R"("name": "none"}])")), 6, Vec<3>(2, 3, 2));
}

TEST(Gltf, CutsStripsAndFansAndReadsSparseNumbers) {
    // A square of four corners, seen from above as a strip and as a fan.
    Gltf gltf;
    gltf.add(floats({0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1}), R"("componentType": 5126, "count": 4, "type": "VEC3")");
    gltf.add(std::string("\0\1\3\2", 4), R"("componentType": 5121, "count": 4, "type": "SCALAR")");
    const auto facing_up = [](const Scene<3>& scene) {
        EXPECT_EQ(scene.primitives.size(), 2u);
        for (const Primitive<3>& t : scene.primitives) EXPECT_EQ(glm::cross(t[1] - t[0], t[2] - t[0]), Vec<3>(0, 1, 0));
    };
    facing_up(read_text(gltf.text(R"([{"primitives": [{"attributes": {"POSITION": 0}, "mode": 5}]}])")));
    facing_up(read_text(gltf.text(R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 6}]}])")));

    // The top of the pyramid moves from 3 to 7.
    Gltf sparse = pyramid();
    sparse.add(shorts({4}), R"("componentType": 5123, "count": 1, "type": "SCALAR")");
    sparse.add(floats({1, 7, 1}), R"("componentType": 5126, "count": 1, "type": "VEC3")");
    const std::size_t end = sparse.accessors.find('}');
    sparse.accessors.insert(end, R"(, "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5123},
                                               "values": {"bufferView": 3}})");
    expect_extent(read_text(sparse.text(one_mesh)), 6, Vec<3>(2, 7, 2));
}

TEST(Gltf, BendsSkinsToTheirJoints) {
    // All hangs on joint 1, which stands at (0, 10, 0); the node of the mesh does not count.
    Gltf gltf = pyramid();
    gltf.add(std::string("\1\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0", 20),
             R"("componentType": 5121, "count": 5, "type": "VEC4")");
    gltf.add(floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}),
             R"("componentType": 5126, "count": 5, "type": "VEC4")");
    gltf.nodes = R"([{"children": [1, 2, 3]}, {"mesh": 0, "skin": 0, "translation": [50, 0, 0]}, {"name": "a"},
                     {"name": "b", "translation": [0, 10, 0]}])";
    gltf.more = R"("skins": [{"joints": [2, 3]}],)";
    const Scene<3> scene = read_text(gltf.text(R"([{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 2,
        "WEIGHTS_0": 3}, "indices": 1}]}])"));
    expect_extent(scene, 6, Vec<3>(2, 3, 2));
    EXPECT_EQ(bounds<3>(scene.primitives).min + scene.origin, Vec<3>(0, 10, 0));
}

TEST(Gltf, LargeNumbersOfNodesKeepTheirDetail) {
    Gltf gltf = pyramid();
    gltf.nodes = R"([{"children": [1], "translation": [1800216.25, 5200112.5, 0]},
                     {"mesh": 0, "scale": [0.1, 0.1, 0.1], "translation": [0.0625, 0, 0]}])";
    const Scene<3> scene = read_text(gltf.text(one_mesh));
    expect_extent(scene, 6, Vec<3>(0.2, 0.3, 0.2));
    EXPECT_NEAR((bounds<3>(scene.primitives).min + scene.origin).x, 1800216.3125, 1e-6);
}

TEST(Gltf, NodesWithMeshesAreObjects) {
    Gltf gltf = pyramid();
    gltf.scenes = R"("scenes": [{"nodes": [0, 1, 2, 3]}],)";
    gltf.nodes = R"([{"mesh": 0, "name": "left tower"}, {"mesh": 0, "translation": [5, 0, 0]}, {"name": "nothing"},
        {"mesh": 0, "name": "hidden", "extensions": {"KHR_node_visibility": {"visible": false}}}])";
    Scene<3> scene =
        read_text(gltf.text(R"([{"name": "tower", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])"));
    EXPECT_EQ(scene.objects.names, (std::vector<std::string>{"left tower", "tower"}));
    ASSERT_EQ(scene.objects.of.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(scene.objects.of[i], i / 6);
    EXPECT_EQ(read_text(pyramid().text(one_mesh)).objects.names, std::vector<std::string>{"node 0"});

    // Of several files: with the file's name; a file without names is an object.
    const Folder folder("objects");
    folder.write("a.gltf", gltf.text(one_mesh));
    folder.write("b.stl", test::stl_of(test::cube(), true));
    scene = read_mesh(folder.path(), "x");
    EXPECT_EQ(scene.objects.names, (std::vector<std::string>{"a.gltf: left tower", "a.gltf: node 1", "b.stl"}));
    EXPECT_EQ(scene.objects.of.size(), scene.primitives.size());
    EXPECT_EQ(scene.objects.of.back(), 2u);
}

constexpr const char* cameras = R"("cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}},
    {"type": "orthographic", "orthographic": {"xmag": 4, "ymag": 4, "znear": 0.1, "zfar": 100}}],)";

TEST(Gltf, TheVerticalAngleOfACameraIsExactAndOneWithoutIsNoView) {
    Gltf gltf = pyramid();
    gltf.more = cameras;
    gltf.scenes = R"("scenes": [{"nodes": [0, 1]}],)";
    gltf.nodes = R"([{"mesh": 0}, {"camera": 0, "translation": [1, 1, 12]}])";
    Scene<3> scene = read_text(gltf.text(one_mesh));
    EXPECT_EQ(scene.start_view->eye, Vec<3>(1, 1, 12));
    EXPECT_DOUBLE_EQ(scene.start_view->fov, 0.5 * 180 / 3.14159265358979323846);
    EXPECT_TRUE(scene.paths.empty());
    gltf.nodes = R"([{"mesh": 0}, {"camera": 1, "translation": [1, 1, 12]}])";
    scene = read_text(gltf.text(one_mesh));
    EXPECT_NE(scene.start_view->eye, Vec<3>(1, 1, 12));
    EXPECT_EQ(scene.warnings,
              std::vector<std::string>{"1 camera without perspective (orthographic): not used as a view"});
}

TEST(Gltf, AnimatedCamerasArePaths) {
    Gltf gltf = pyramid();
    gltf.more = std::string(cameras) + R"("animations": [{"channels": [
        {"sampler": 0, "target": {"node": 1, "path": "translation"}},
        {"sampler": 1, "target": {"node": 2, "path": "rotation"}}],
        "samplers": [{"input": 2, "output": 3}, {"input": 2, "output": 4}]}],)";
    gltf.scenes = R"("scenes": [{"nodes": [0, 1, 3]}],)";
    gltf.nodes = R"([{"mesh": 0}, {"children": [2]}, {"camera": 0, "name": "tracking shot"},
                     {"camera": 0, "name": "fixed", "translation": [0, 0, 9]}])";
    // In two seconds 10 to the right, turning a quarter to the left.
    gltf.add(floats({0, 2}), R"("componentType": 5126, "count": 2, "type": "SCALAR")");
    gltf.add(floats({0, 0, 5, 10, 0, 5}), R"("componentType": 5126, "count": 2, "type": "VEC3")");
    gltf.add(floats({0, 0, 0, 1, 0, std::sqrt(0.5), 0, std::sqrt(0.5)}),
             R"("componentType": 5126, "count": 2, "type": "VEC4")");
    const Scene<3> scene = read_text(gltf.text(one_mesh));
    ASSERT_EQ(scene.paths.size(), 2u);
    EXPECT_EQ(scene.paths[0].id, "cameras");
    EXPECT_EQ(scene.paths[0].frames.size(), 2u);
    const FlightPath<3>& path = scene.paths[1];
    EXPECT_EQ(path.id, "tracking shot");
    ASSERT_EQ(path.frames.size(), 51u);
    const auto ahead = [&](std::size_t i) { return glm::normalize(path.frames[i].look_at - path.frames[i].eye); };
    EXPECT_EQ(path.frames[0].eye, Vec<3>(0, 0, 5));
    EXPECT_NEAR(path.frames[25].eye.x, 5, 1e-12);
    EXPECT_NEAR(path.frames[50].eye.x, 10, 1e-12);
    EXPECT_NEAR(ahead(0).z, -1, 1e-12);
    EXPECT_NEAR(ahead(50).x, -1, 1e-6);
    // A third of the time is a third of the angle: not so on the chord.
    const std::size_t third = 17;
    const double angle = 90 * (third / 25.0 / 2) * 3.14159265358979323846 / 180;
    EXPECT_NEAR(ahead(third).x, -std::sin(angle), 1e-6);
    EXPECT_NEAR(ahead(third).z, -std::cos(angle), 1e-6);
}

TEST(Gltf, WhatDoesNotFitIsRefused) {
    const Gltf good = pyramid();
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = good.text(one_mesh);
        return text.replace(text.find(from), from.size(), to);
    };
    for (const auto& [from, to, line] : std::initializer_list<std::array<const char*, 3>>{
             {R"("count": 18)", R"("count": 19)",
              "x: /accessors/1: its 19 elements do not fit into the 36 bytes of its bufferView"},
             {R"("count": 18)", R"("count": 9007199254740991)",
              "x: /accessors/1: its 9007199254740991 elements do not fit*"},
             {R"("count": 5,)", R"("count": -5,)", "x: /accessors/0/count: expected a whole number from 0"},
             {R"("byteLength": 60)", R"("byteLength": 6000)",
              "x: /bufferViews/0: its 6000 bytes at 0 lie beyond the end of its buffer (96 bytes)"},
             {R"("componentType": 5126)", R"("componentType": 5130)",
              "x: /accessors/0: componentType 5130 is none of glTF"},
             {R"("VEC3")", R"("VEC2")", "x: /meshes/0/primitives/0: /accessors/0 has 2 numbers an element, 3 expected"},
             {R"("POSITION": 0)", R"("POSITION": 5)", "x: /accessors/5: /accessors/5 does not exist: there are 2"},
             {R"({"mesh": 0})", R"({"mesh": 3})", "x: /nodes/0: /meshes/3 does not exist: there are 1"},
             {R"({"mesh": 0})", R"({"mesh": 0, "children": [0]})", "x: /nodes: some nodes are their own ancestors"},
             {R"("version": "2.0")", R"("version": "3.0")", "x: /asset/version: is glTF 3.0; 2 is supported"},
             {R"("nodes": [0])", R"("nodes": [1])", "x: /scenes/0: /nodes/1 does not exist: there are 1"}}) {
        SCOPED_TRACE(to);
        expect_input_error([&, &from = from, &to = to] { read_text(changed(from, to)); }, line);
    }
}

TEST(Gltf, DamagedFilesNeverDoMoreThanFail) {
    Gltf gltf = pyramid();
    gltf.add(floats({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0}), vectors_5);
    gltf.more = cameras;
    gltf.nodes = R"([{"mesh": 0, "children": [1], "scale": [2, 1, 1]}, {"camera": 0, "rotation": [0, 0, 0, 1]}])";
    const std::string text = gltf.text(
        R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "targets": [{"POSITION": 2}]}], "weights": [1]}])");
    Random random(5);
    std::size_t read = 0, refused = 0;
    for (int i = 0; i < test::soak_count(3000); ++i) {
        std::string damaged = text;
        for (std::size_t k = 0; k <= random.below(3); ++k) {
            const std::size_t at = random.below(damaged.size());
            if (random.below(2))
                damaged[at] = "0123456789-{}[],:\"e"[random.below(19)];
            else
                damaged.erase(at, 1 + random.below(8));
        }
        try {
            read_text(damaged);
            ++read;
        } catch (const InputError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("x: "));
            ++refused;
        }
    }
    EXPECT_GT(read, 100u);
    EXPECT_GT(refused, 500u);
}

}  // namespace
}  // namespace sightline
