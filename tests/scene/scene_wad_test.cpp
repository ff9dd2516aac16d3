// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/scene/read/read_json.h"
#include "core/scene/read/read_wad.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

using test::expect_input_error;
using test::room_map;
using test::wad_of;

std::vector<test::WadLump> two_maps() {
    std::vector<test::WadLump> lumps = {{"PLAYPAL", "abc"}};
    for (const char* name : {"E1M1", "MAP07"})
        for (const test::WadLump& lump : room_map(name)) lumps.push_back(lump);
    return lumps;
}

void expect_wad_error(const std::string& bytes, const std::string& line, const WadOptions& options = {}) {
    expect_input_error([&] { read_wad(bytes, "w", options); }, line);
}

TEST(SceneWad, ReadsWallsAndTheStartOfPlayerOne) {
    const Scene<2> scene = read_wad(wad_of(two_maps()), "w");
    EXPECT_EQ(scene.id, "w#E1M1");
    EXPECT_EQ(scene.source, "wad");
    ASSERT_EQ(scene.primitives.size(), 4u);
    EXPECT_EQ(scene.primitives[0], (Primitive<2>{Vec<2>(-50, 0), Vec<2>(50, 0)}));
    EXPECT_EQ(scene.start_view, (ViewSpec<2>{{-30, 40}, {-30, 296}, 90}));
    EXPECT_EQ(scene.warnings, std::vector<std::string>{"1 two-sided lines, which can be seen through, are left out"});
    EXPECT_EQ(read_wad(wad_of(two_maps(), "IWAD"), "w", {"map07", true}).primitives.size(), 5u);
    EXPECT_EQ(wad_maps(wad_of(two_maps()), "w"), (std::vector<std::string>{"E1M1", "MAP07"}));
}

TEST(SceneWad, WithoutAPlayerTheStartViewIsChosen) {
    std::vector<test::WadLump> map = room_map("MAP01");
    map[1].bytes = "";
    const Scene<2> scene = read_wad(wad_of(map), "w");
    EXPECT_EQ(scene.warnings.size(), 2u);
    EXPECT_TRUE(scene.start_view);
    map[2].bytes = map[4].bytes = "";
    EXPECT_EQ(read_wad(wad_of(map), "w").primitives.size(), 0u);
}

TEST(SceneWad, SaysWhatIsWrongAndWhere) {
    expect_wad_error("", "w: byte 0: only 0 bytes, a WAD header has 12");
    expect_wad_error("PWAD1234", "w: byte 0: only 8 bytes, a WAD header has 12");
    expect_wad_error("WADPxxxxxxxx", "w: byte 0: is not a WAD: expected IWAD or PWAD");
    expect_wad_error("PWAD" + test::little(2, 4) + test::little(12, 4),
                     "w: byte 4: the directory (2 lumps at byte 12) lies beyond the end of the file (12 bytes)");
    expect_wad_error("PWAD" + test::little(0xffffffff, 4) + test::little(0xffffffff, 4),
                     "w: byte 4: the directory (4294967295 lumps at byte 4294967295) lies beyond*");
    expect_wad_error(wad_of({}), "w: directory: holds no map (no lump followed by THINGS LINEDEFS SIDEDEFS VERTEXES)");
    expect_wad_error(wad_of(two_maps()), "w: directory: no map \"E9M9\"; it has E1M1 MAP07", {"E9M9", false});

    std::vector<test::WadLump> map = room_map("MAP01");
    map[2].bytes += "x";
    expect_wad_error(wad_of(map), "w: LINEDEFS: has 71 bytes, no multiple of 14");
    map = room_map("MAP01");
    map[4].bytes.resize(15);
    expect_wad_error(wad_of(map), "w: VERTEXES: has 15 bytes, no multiple of 4");
    map = room_map("MAP01");
    map[1].bytes += "abc";
    expect_wad_error(wad_of(map), "w: THINGS: has 23 bytes, no multiple of 10");
    map = room_map("MAP01");
    map[4].bytes.resize(12);
    expect_wad_error(wad_of(map), "w: LINEDEFS record 2: vertex 3 of 3");
    map = room_map("MAP01");
    map.push_back({"BEHAVIOR", ""});
    expect_wad_error(wad_of(map), "w: MAP01: is a map in Hexen's format, which is not supported");

    // A lump that lies about its size or place.
    std::string bytes = wad_of(room_map("MAP01"));
    const std::size_t entry = bytes.size() - 16;
    expect_wad_error(bytes.replace(entry + 4, 4, test::little(0x7fffffff, 4)),
                     "w: VERTEXES: 2147483647 bytes at byte *");
    bytes = wad_of(room_map("MAP01"));
    expect_wad_error(bytes.replace(entry, 4, test::little(0xfffffff0, 4)),
                     "w: VERTEXES: 16 bytes at byte 4294967280 lie beyond the end of the file (198 bytes)");
}

TEST(SceneWad, RefusesTruncationAtEveryByte) {
    const std::string bytes = wad_of(room_map("MAP01"));
    for (std::size_t size = 0; size < bytes.size(); ++size)
        expect_input_error([&] { read_wad(std::string_view(bytes).substr(0, size), "w"); }, "w: *");
}

TEST(SceneLoad, FindsCatalogueRowsAndFilesByContent) {
    EXPECT_EQ(scene_hash(load_scene("cars")), scene_hash(make_scene(*find_in_catalogue("cars"))));

    const test::TemporaryFile json("a.wad", write_json(make_scene(*find_in_catalogue("wall2"))));
    EXPECT_EQ(load_scene(json.path()).source, "json");
    EXPECT_EQ(load_scene(json.path()).id, "wall2");
    const test::TemporaryFile geojson("a.txt",
                                      "\xef\xbb\xbf  {\"type\": \"LineString\", \"coordinates\": [[0,0],[1,1]]}");
    EXPECT_EQ(load_scene(geojson.path()).source, "geojson");
    const test::TemporaryFile wad("a#b.json", wad_of(two_maps()));
    EXPECT_EQ(load_scene(wad.path()).id, wad.path() + "#E1M1");
    EXPECT_EQ(load_scene(wad.path() + "#MAP07").id, wad.path() + "#MAP07");
    EXPECT_EQ(load_scene(wad.path() + "#MAP07", {true}).primitives.size(), 5u);
    EXPECT_EQ(list_wad_maps(wad.path()), (std::vector<std::string>{"E1M1", "MAP07"}));
}

TEST(SceneWad, TheLastStartAndTheLastMapOfANameCount) {
    std::vector<test::WadLump> lumps = room_map("MAP01"), again = room_map("MAP01");
    again[1].bytes = test::thing(900, 900, 0, 1) + test::thing(100, 100, 90, 1);
    again[2].bytes.resize(2 * 14);
    lumps.insert(lumps.end(), again.begin(), again.end());
    const std::string bytes = wad_of(lumps);
    EXPECT_EQ(wad_maps(bytes, "w"), std::vector<std::string>{"MAP01"});
    for (const char* map : {"", "map01"}) {
        const Scene<2> scene = read_wad(bytes, "w", {map});
        EXPECT_EQ(scene.primitives.size(), 2u);
        EXPECT_EQ(scene.start_view->eye, Vec<2>(100, 100));
        EXPECT_EQ(scene.start_view->look_at, Vec<2>(100, 356));
    }
}

TEST(SceneWad, SectorsAreObjects) {
    std::vector<test::WadLump> lumps = room_map("MAP01");
    const auto side = [](std::uint32_t sector) { return std::string(28, '-') + test::little(sector, 2); };
    const auto line = [](std::uint32_t a, std::uint32_t b, std::uint32_t right) {
        return test::little(a, 2) + test::little(b, 2) + test::little(1, 2) + test::little(0, 4) +
               test::little(right, 2) + test::little(0xffff, 2);
    };
    lumps[2].bytes = line(0, 1, 1) + line(1, 2, 0) + line(2, 3, 1) + line(3, 0, 9);
    lumps[3].bytes = side(3) + side(12);
    const Scene<2> scene = read_wad(wad_of(lumps), "w");
    EXPECT_EQ(scene.objects.names, (std::vector<std::string>{"sector 3", "sector 12", "no sector"}));
    EXPECT_EQ(scene.objects.of, (std::vector<std::uint32_t>{1, 0, 1, 2}));
    EXPECT_TRUE(read_wad(wad_of(room_map("MAP01")), "w").objects.empty());
}

TEST(SceneLoad, SaysWhatAFileIsThatItCannotRead) {
    const auto expect_end = [](const std::string& bytes, const std::string& end) {
        const test::TemporaryFile file("not_read.pk3", bytes);
        expect_input_error([&] { load_scene(file.path()); }, file.path() + ": " + end);
    };
    const std::string no = "byte 0: is not a WAD, GeoJSON or Sightline JSON file (it begins like ";
    expect_end("PK\x03\x04 and so on", no + "a ZIP archive)");
    expect_end("\x1f\x8b and so on", no + "a gzip archive)");
    expect_end(std::string("\xff\xfe{\0", 4), no + "text in UTF-16: save it as UTF-8)");
    expect_end(wad_of({{"MAP01", ""}, {"TEXTMAP", "namespace = \"doom\";"}, {"ENDMAP", ""}}),
               "MAP01: is a map in UDMF, which is not supported");
}

TEST(SceneLoad, SaysWhatIsWrong) {
    const auto expect_load_error = [](const std::string& name, const std::string& line) {
        expect_input_error([&] { load_scene(name); }, line);
    };
    expect_load_error("no/such.wad", "no/such.wad: no such file, and no scene of the catalogue has this id");
    expect_load_error("no/such.wad#E1M1", "no/such.wad#E1M1: no such file, and no scene of the catalogue has this id");
    expect_load_error("", ": no such file, and no scene of the catalogue has this id");
    expect_load_error("/", "/: is a directory, not a file");
    expect_load_error("/dev/null", "/dev/null: is not a regular file");
    const test::TemporaryFile empty("empty", ""), text("text", "hello"), list("list", "[1]"), other("other", "{}"),
        large("large", std::string(100, ' '));
    expect_load_error(empty.path(), empty.path() + ": the file is empty");
    expect_load_error(text.path(), text.path() + ": byte 0: is not a WAD, GeoJSON or Sightline JSON file");
    expect_load_error(list.path(), list.path() + ": is JSON, but neither GeoJSON (\"type\") nor a scene (\"format\")");
    expect_load_error(other.path() + "#E1M1", other.path() + ": is not a WAD file, so #E1M1 has no meaning");
    expect_input_error([&] { read_file(large.path(), 99); }, large.path() + ": has 100 bytes; the limit is 99");
    const test::TemporaryFile wad("maps.wad", wad_of(two_maps()));
    expect_load_error(wad.path() + "#E2M1", wad.path() + ": directory: no map \"E2M1\"; it has E1M1 MAP07");
}

TEST(SceneLoad, NamesThePackageWhenFreedoomIsMissing) {
    EXPECT_TRUE(installed_maps("/no/such/folder").empty());
    expect_input_error(
        [] {
            load_scene("freedoom1#E1M2", {false, "/no/such/folder"});
        },
        "freedoom1#E1M2: /no/such/folder/freedoom1.wad is missing: install Debian's package freedoom "
        "(apt install freedoom)");
}

TEST(SceneLoad, ReadsARealMap) {
    const std::string path = SIGHTLINE_SOURCE_DIR "/../shared/scenes/e1m2.wad";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    const Scene<2> all = load_scene(path, {true}), walls = load_scene(path);
    EXPECT_EQ(all.primitives.size() + all.dropped.total(), 2290u);
    EXPECT_LT(walls.primitives.size(), all.primitives.size());
    EXPECT_GT(walls.primitives.size(), 1000u);
    EXPECT_EQ(walls.id, path + "#E1M2");
}

TEST(SceneLoad, ReadsEveryInstalledFreedoomMap) {
    const std::vector<std::string> maps = installed_maps();
    if (maps.empty()) GTEST_SKIP() << "freedoom is not installed";
    for (const std::string& map : maps) {
        const Scene<2> scene = load_scene(map);
        EXPECT_EQ(scene.id, map);
        EXPECT_GT(scene.primitives.size(), 100u) << map;
    }
    EXPECT_EQ(load_scene("freedoom1").id, maps.front());
}

}  // namespace
}  // namespace sightline
