// Seeded mutations of valid files: whatever comes, a reader gives a usable scene or throws InputError with one line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/catalogue.h"
#include "tests/fuzz/readers.h"
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

}  // namespace
}  // namespace sightline
