// Seeded mutations of valid files: whatever comes, a reader gives a usable scene or throws InputError with one line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/catalogue.h"
#include "tests/fuzz/mesh_readers.h"
#include "tests/fuzz/readers.h"
#include "tests/scene/mesh_files.h"
#include "tests/scene/mutation.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

void run(int (*reader)(const std::uint8_t*, std::size_t), const std::vector<std::string>& seeds, bool binary) {
    for (const std::string& seed : seeds)
        ASSERT_EQ(reader(reinterpret_cast<const std::uint8_t*>(seed.data()), seed.size()), 1) << "a seed is not valid";
    std::size_t read = 0, refused = 0;
    Random random(2026);
    for (std::size_t i = 0; i < test::input_count(); ++i) {
        std::string bytes = seeds[random.below(seeds.size())];
        const std::uint64_t rounds = 1 + random.below(3);
        for (std::uint64_t k = 0; k < rounds; ++k)
            test::mutate(random, bytes, seeds[random.below(seeds.size())], binary);
        try {
            ++(reader(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()) ? read : refused);
        } catch (const std::exception& error) {
            FAIL() << "input " << i << " lets escape: " << error.what();
        }
    }
    ::testing::Test::RecordProperty("read", std::to_string(read));
    std::printf("%zu inputs: %zu read, %zu refused\n", read + refused, read, refused);
    // Both ends are reached, else the mutations test nothing.
    EXPECT_GT(read, test::input_count() / 50);
    EXPECT_GT(refused, test::input_count() / 50);
}

std::string short_scene(const char* id, std::size_t segments) {
    Scene<2> scene = make_scene(*find_in_catalogue(id));
    scene.primitives.resize(segments);
    return write_json(scene);
}

TEST(SceneFuzz, Json) { run(fuzz::fuzz_json, {short_scene("bottleneck", 12), short_scene("terrain", 3)}, false); }

TEST(SceneFuzz, GeoJson) {
    run(fuzz::fuzz_geojson,
        {R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"a": "b"}, "geometry":
            {"type": "Polygon", "coordinates": [[[1800000.5,5200000.25,9],[1800004,5200000],[1800004,5200004],
            [1800000.5,5200000.25]], [[1,1],[2,1],[2,2],[1,1]]]}}]})",
         R"({"type": "GeometryCollection", "geometries": [{"type": "LineString", "coordinates": [[0,5],[1,5],[2,6]]},
            {"type": "MultiLineString", "coordinates": [[[0,7],[1,7]],[[0,8],[1,8]],[]]},
            {"type": "Point", "coordinates": [1,2]},
            {"type": "MultiPolygon", "coordinates": [[[[5,0],[6,0],[6,1],[5,0]]]]}]})"},
        false);
}

TEST(SceneFuzz, Wad) {
    std::vector<test::WadLump> two = test::room_map("E1M1");
    for (const test::WadLump& lump : test::room_map("MAP02")) two.push_back(lump);
    run(fuzz::fuzz_wad, {test::wad_of(test::room_map("MAP01")), test::wad_of(two, "IWAD")}, true);
}

TEST(SceneFuzz, Obj) {
    run(fuzz::fuzz_obj,
        {"# all\nmtllib a.mtl\no house\nv 0 0 0\nv 4 0 0 # corner\nv 4 4 0\nv 2 1 0\nv 0 4 0 1\nvt 0 0\nvn 0 0 1\n"
         "f 1 2 3 4 5\n  f 1/1 2/1 3/1\no tree\nf -1//1 -2//1 \\\n-3//1\n",
         "\xef\xbb\xbfv 1800216.1 5200112.2 0 2\r\nv 1 1 1 .5 .5 .5\r\nv 0 1 1\r\nv 3 3 3\r\ng a b\r\nf 1 2 3\r\n"
         "g\r\nf 4 3 2 1\r\nl 1 2\r\ncurv 0 1 1 2\r\nf 1 2 3 4 1 3 2 4\r\n"},
        false);
}

std::string ply_with_strips() {
    return "ply\nformat ascii 1.0\ncomment x\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
           "property uchar red\nelement tristrips 1\nproperty list int int vertex_indices\nelement face 2\n"
           "property list uchar int vertex_indices\nend_header\n0 0 0 1\n2 0 0 1\n2 0 2 1\n0 0 2 1\n1 3 1 1\n"
           "8 0 1 3 2 -1 0 4 1\n3 0 1 2\n4 0 1 2 3\n";
}

TEST(SceneFuzz, Ply) { run(fuzz::fuzz_ply, {ply_with_strips(), test::ply_of(test::cube(), false)}, false); }

TEST(SceneFuzz, BinaryPly) {
    std::string big = test::ply_of(test::cube(), true);
    big.replace(big.find("little"), 6, "big");
    big.replace(big.find("face 12"), 7, "face 0 ");
    run(fuzz::fuzz_ply, {test::ply_of(test::cube(), true), test::ply_of(test::pyramid_mesh(), true), big}, true);
}

TEST(SceneFuzz, Stl) { run(fuzz::fuzz_stl, {test::stl_of(test::pyramid_mesh(), false)}, false); }

TEST(SceneFuzz, BinaryStl) {
    run(fuzz::fuzz_stl,
        {test::stl_of(test::pyramid_mesh(), true), "solid" + test::stl_of(test::cube(), true).substr(5)}, true);
}

TEST(SceneFuzz, Off) {
    run(fuzz::fuzz_off,
        {test::off_of(test::pyramid_mesh()),
         "COFF # x\n4 2\n0 0 0 1 1 1 1\n4 0 0 1 1 1 1\n1 1 0 0 0 0 1\n0 4 0 0 0 0 1\n"
         "4 0 1 2 3 255 0 0\n3 0 1 2\n"},
        false);
}

/// Through a process of its own: whatever happens there ends in a scene or in one line.
TEST(SceneFuzz, Assimp) {
    const std::string seeds[] = {test::dae_of(test::cube()), test::dae_of(test::pyramid_mesh())};
    Random random(2026);
    std::size_t read = 0;
    const auto count = static_cast<std::size_t>(test::soak_count(100));
    for (std::size_t i = 0; i < count; ++i) {
        std::string bytes = seeds[i % 2];
        for (std::uint64_t rounds = random.below(4); rounds > 0; --rounds)
            test::mutate(random, bytes, seeds[1 - i % 2], false);
        const test::TemporaryFile file("mutated.dae", bytes);
        try {
            read += read_mesh(file.path(), "input").start_view.has_value();
        } catch (const InputError& error) {
            EXPECT_TRUE(fuzz::is_one_line(error.what())) << error.what();
        }
    }
    EXPECT_GT(read, count / 50);
    EXPECT_LT(read, count);
}

}  // namespace
}  // namespace sightline
