// Seeded mutations of valid files: whatever comes, a reader gives a usable scene or throws InputError with one line.
// SIGHTLINE_FUZZ_INPUTS sets the number of inputs per reader.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include "core/geometry/random.h"
#include "core/scene/catalogue.h"
#include "tests/fuzz/readers.h"
#include "tests/scene_support.h"

namespace sightline {
namespace {

std::size_t input_count() {
    const char* text = std::getenv("SIGHTLINE_FUZZ_INPUTS");
    return text ? std::strtoull(text, nullptr, 10) : 2000;
}

constexpr const char* tokens[] = {
    "1e999", "-1e308", "1e151", "NaN", "-Infinity", "0x10", "1e-320", "-0.0",
    "null",  "true",   "\"a\"", "[]",  "{}",        "[[",   "]]",     "99999999999999999999",
    "1e",    "-",      "1.5.2", "\\u", "\xff",      "2",    "360",    "{\"type\":0}",
    "[[[[[1"};
constexpr std::uint32_t words[] = {0, 1, 0x7f, 0x80, 0xff, 0x7fff, 0x8000, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff};

std::size_t place(Random& random, const std::string& bytes) { return random.below(bytes.size() + 1); }

/// Replaces a run that looks like a number (any length, may be empty) by a token.
void replace_number(Random& random, std::string& bytes) {
    std::size_t from = bytes.find_first_of("-0123456789", place(random, bytes));
    if (from == std::string::npos) return;
    std::size_t to = bytes.find_first_not_of("+-.0123456789eE", from);
    if (to == std::string::npos) to = bytes.size();
    bytes.replace(from, to - from, tokens[random.below(std::size(tokens))]);
}

void mutate(Random& random, std::string& bytes, const std::string& other, bool binary) {
    switch (random.below(14)) {  // mostly single values, so that many inputs get past the parser
        case 0:                  // flip a bit
            if (!bytes.empty()) bytes[random.below(bytes.size())] ^= static_cast<char>(1 << random.below(8));
            break;
        case 1:
            bytes.resize(place(random, bytes));
            break;
        case 2: {  // splice
            const std::size_t from = place(random, other);
            bytes.replace(place(random, bytes), random.below(40), other, from, random.below(60));
            break;
        }
        case 3:
            bytes.erase(place(random, bytes), random.below(16));
            break;
        case 4:  // repeat a piece
            if (bytes.size() < 20000) bytes.insert(place(random, bytes), bytes, place(random, bytes), random.below(80));
            break;
        default:
            if (!binary) {
                replace_number(random, bytes);
            } else {
                const int size = random.below(2) ? 4 : 2;
                const std::size_t at = place(random, bytes);
                if (at + 4 <= bytes.size())
                    bytes.replace(at, static_cast<std::size_t>(size),
                                  test::little(words[random.below(std::size(words))], size));
            }
    }
}

void run(int (*reader)(const std::uint8_t*, std::size_t), const std::vector<std::string>& seeds, bool binary) {
    for (const std::string& seed : seeds)
        ASSERT_EQ(reader(reinterpret_cast<const std::uint8_t*>(seed.data()), seed.size()), 1) << "a seed is not valid";
    std::size_t read = 0, refused = 0;
    Random random(2026);
    for (std::size_t i = 0; i < input_count(); ++i) {
        std::string bytes = seeds[random.below(seeds.size())];
        const std::uint64_t rounds = 1 + random.below(3);
        for (std::uint64_t k = 0; k < rounds; ++k) mutate(random, bytes, seeds[random.below(seeds.size())], binary);
        try {
            ++(reader(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()) ? read : refused);
        } catch (const std::exception& error) {
            FAIL() << "input " << i << " lets escape: " << error.what();
        }
    }
    ::testing::Test::RecordProperty("read", std::to_string(read));
    std::printf("%zu inputs: %zu read, %zu refused\n", read + refused, read, refused);
    // Both ends are reached, else the mutations test nothing.
    EXPECT_GT(read, input_count() / 50);
    EXPECT_GT(refused, input_count() / 50);
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
