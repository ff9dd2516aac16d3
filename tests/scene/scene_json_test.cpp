// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/base/random.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/read_geojson.h"
#include "core/scene/read/read_json.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

using test::expect_input_error;

std::string scene_text(const std::string& more) {
    return R"({"format": "sightline-scene", "version": 1, "dimension": 2, )" + more + "}";
}

void expect_json_error(const std::string& text, const std::string& line) {
    expect_input_error([&] { read_json(text, "s.json"); }, line);
}

void expect_geojson_error(const std::string& text, const std::string& line) {
    expect_input_error([&] { read_geojson(text, "g.json"); }, line);
}

void expect_same(const Scene<2>& a, const Scene<2>& b) {
    EXPECT_EQ(scene_hash(a), scene_hash(b));
    EXPECT_EQ(a.primitives, b.primitives);
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.start_view, b.start_view);
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.lesson, b.lesson);
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.rooms, b.rooms);
}

TEST(SceneJson, RoundTripsTheCatalogueBitForBit) {
    for (const CatalogueRow<2>& row : catalogue()) {
        const Scene<2> scene = make_scene(row);
        const Scene<2> again = read_json(write_json(scene), "again");
        expect_same(scene, again);
        EXPECT_EQ(again.source, "json");
        EXPECT_EQ(again.dropped.total(), 0u);
        EXPECT_TRUE(again.warnings.empty());
    }
}

TEST(SceneJson, RoundTripsAnyDoublesAndAnyText) {
    Random random(12);
    Scene<2> scene;
    for (int i = 0; i < 5000; ++i) {
        const auto number = [&] {
            return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(800)) - 400);
        };
        scene.primitives.push_back({Vec<2>(number(), number()), Vec<2>(number(), number())});
    }
    scene.primitives.push_back({Vec<2>(-0.0, 5e-324), Vec<2>(1, -1e150)});
    scene.id = "q\"uo\\te";
    scene.title = "línea\nnext\ttab ρ";
    scene.lesson = "";
    scene.seed = 0xffffffffffffffffull;
    scene.origin = {1.8e6, -0.1};
    scene.start_view = ViewSpec<2>{{0.1, -0.2}, {3, 4}, 359.0 / 3};
    expect_same(scene, read_json(write_json(scene), "x"));
}

TEST(SceneJson, FillsInWhatIsNotRequired) {
    const Scene<2> scene =
        read_json(scene_text(R"("segments": [[0,0,1,0],[0,1,1,1],[1,0,0,0]], "tilte": 1)"), "s.json");
    EXPECT_EQ(scene.id, "s.json");
    EXPECT_EQ(scene.primitives.size(), 2u);
    EXPECT_EQ(scene.dropped.duplicate, 1u);
    EXPECT_EQ(scene.warnings, std::vector<std::string>{"member \"tilte\" is not known and was ignored"});
    ASSERT_TRUE(scene.start_view);
    const Scene<2> empty = read_json(scene_text(R"("segments": [])"), "s.json");
    EXPECT_EQ(empty.primitives.size(), 0u);
    EXPECT_EQ(empty.warnings.size(), 1u);
    EXPECT_EQ(read_json(scene_text(R"("segments": [[0,0,1,0]], "view": {"eye": [0,1], "look_at": [0,0]})"), "s")
                  .start_view->fov,
              60);
}

TEST(SceneJson, SaysWhatIsWrongAndWhere) {
    expect_json_error("", "s.json: line 1, column 1: *");
    expect_json_error("{\n  \"format\" 3", "s.json: line 2, column 12: syntax error*");
    expect_json_error("[1]", "s.json: expected an object, found an array");
    expect_json_error("{}", "s.json: \"format\" is missing");
    expect_json_error(R"({"format": 5})", "s.json: /format: expected \"sightline-scene\"");
    expect_json_error(R"({"format": "sightline-scene", "version": 2})",
                      "s.json: /version: expected 1; this program reads no other version");
    expect_json_error(R"({"format": "sightline-scene", "version": 1, "dimension": 3})",
                      "s.json: /dimension: expected 2");
    expect_json_error(scene_text(R"("id": "x")"), "s.json: \"segments\" is missing");
    expect_json_error(scene_text(R"("segments": 4)"), "s.json: /segments: expected an array, found a number");
    expect_json_error(scene_text(R"("segments": [[0,0,1,0],[0,0,1]])"),
                      "s.json: /segments/1: expected an array of 4 numbers, found one of 3");
    expect_json_error(scene_text(R"("segments": [{}])"),
                      "s.json: /segments/0: expected an array of 4 numbers, found an object");
    expect_json_error(scene_text(R"("segments": [[0,0,"1",0]])"),
                      "s.json: /segments/0/2: expected a number, found a string");
    expect_json_error(scene_text(R"("segments": [[0,0,null,0]])"),
                      "s.json: /segments/0/2: expected a number, found null");
    expect_json_error(scene_text(R"("segments": [[0,0,1e160,0]])"),
                      "s.json: segment 0: coordinate 1e+160 is too large (limit 1e150)");
    expect_json_error(scene_text(R"("segments": [[0,0,NaN,0]])"),
                      "s.json: line 1, column 79: syntax error while parsing value - invalid literal*");
    expect_json_error(scene_text(R"("segments": [[0,0,1e999,0]])"),
                      "s.json: line 1, column 79: number overflow parsing '1e999'");
    expect_json_error(scene_text(R"("segments": [], "id": 7)"), "s.json: /id: expected a string, found a number");
    expect_json_error(scene_text(R"("segments": [], "seed": -1)"), "s.json: /seed: expected a whole number from 0");
    expect_json_error(scene_text(R"("segments": [], "view": 1)"), "s.json: /view: expected an object, found a number");
    expect_json_error(scene_text(R"("segments": [], "view": {"eye": [0, 0]})"),
                      "s.json: /view: \"look_at\" is missing");
    expect_json_error(scene_text(R"("segments": [], "view": {"eye": [0, 0], "look_at": [0, 0]})"),
                      "s.json: /view: look_at is the same point as eye");
    expect_json_error(scene_text(R"("segments": [], "view": {"eye": [0, 0], "look_at": [1, 0], "fov": 200})"),
                      "s.json: /view: fov 200 is not between 0 and 180, nor 360");
    expect_json_error(scene_text(R"("segments": [], "origin": [1])"),
                      "s.json: /origin: expected an array of 2 numbers, found one of 1");
}

TEST(SceneJson, RefusesTruncationAtEveryByte) {
    const std::string text = write_json(make_scene(*find_in_catalogue("bottleneck"))).substr(0, 3000);
    for (std::size_t size = 0; size < text.size(); ++size)
        expect_input_error([&] { read_json(std::string_view(text).substr(0, size), "s"); }, "s: line *");
}

TEST(SceneJson, DeepNestingIsRefusedBeforeParsing) {
    expect_json_error(std::string(1000000, '['), "s.json: line 1, column 65: nested deeper than 64 levels");
    std::string deep;
    for (int i = 0; i < 40; ++i) deep += R"({"type": "GeometryCollection", "geometries": [)";
    expect_geojson_error(deep, "g.json: line 1, column *");
    // Brackets inside strings do not count.
    EXPECT_NO_THROW(read_json(scene_text(R"("segments": [], "title": "\"[[[[)" + std::string(200, '[') + "\""), "s"));
}

TEST(SceneJson, ErrorLinesStayOnOneLine) {
    expect_input_error([] { read_json("{\"a\n\x01", "bad\nname"); }, "bad?name: line *");
}

TEST(SceneGeoJson, ReadsEveryKindOfLine) {
    const Scene<2> scene = read_geojson(R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": null, "geometry":
            {"type": "Polygon", "coordinates": [[[0,0,9],[4,0,9],[4,4,9],[0,0,9]], [[1,1],[2,1],[2,2],[1,1]]]}},
        {"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": [[[[5,0],[6,0],[6,1],[5,0]]]]}},
        {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
            {"type": "LineString", "coordinates": [[0,5],[1,5],[2,6]]},
            {"type": "MultiLineString", "coordinates": [[[0,7],[1,7]],[[0,8],[1,8]],[]]},
            {"type": "Point", "coordinates": [1,2]}]}},
        {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[7,7],[8,7],[8,8]]]}},
        {"type": "Feature", "geometry": null},
        {"type": "MultiPoint", "coordinates": []}]})",
                                        "g.json");
    EXPECT_EQ(scene.primitives.size(), 3u + 3 + 3 + 2 + 2 + 3);
    EXPECT_EQ(scene.primitives[0][1], Vec<2>(4, 0));
    EXPECT_EQ(scene.source, "geojson");
    EXPECT_EQ(scene.dropped.total(), 0u);
    EXPECT_EQ(scene.warnings, (std::vector<std::string>{"2 points left out", "1 feature without geometry: left out",
                                                        "1 open polygon ring closed"}));
    EXPECT_TRUE(scene.start_view);
}

TEST(SceneGeoJson, RecentresNationalGridsAndKeepsTheirNumbers) {
    const Scene<2> scene = read_geojson(
        R"({"type": "LineString", "coordinates": [[1800000.1, 5200000.3], [1800100.7, 5200050.9]]})", "g.json");
    EXPECT_NE(scene.origin, Vec<2>(0, 0));
    EXPECT_EQ(scene.origin + scene.primitives[0][0], Vec<2>(1800000.1, 5200000.3));
    EXPECT_EQ(scene.origin + scene.primitives[0][1], Vec<2>(1800100.7, 5200050.9));
    EXPECT_LT(bounds<2>(scene.primitives).max.x, 200);
}

TEST(SceneGeoJson, DropsSharedEdgesAndEmptyCollectionsAreFine) {
    const Scene<2> scene = read_geojson(R"({"type": "MultiPolygon", "coordinates":
        [[[[0,0],[1,0],[1,1],[0,0]]], [[[1,0],[2,0],[1,1],[1,0]]]]})",
                                        "g");
    EXPECT_EQ(scene.dropped.duplicate, 1u);
    EXPECT_EQ(scene.primitives.size(), 5u);
    EXPECT_EQ(read_geojson(R"({"type": "FeatureCollection", "features": []})", "g").primitives.size(), 0u);
    EXPECT_EQ(read_geojson(R"({"type": "Polygon", "coordinates": [[]]})", "g").primitives.size(), 0u);
}

TEST(SceneGeoJson, OneBadFeatureAmongManyIsAWord) {
    const std::string square =
        R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]]]}})";
    const Scene<2> scene =
        read_geojson(R"({"type": "FeatureCollection", "features": [null, {"type": "Feature"}, )" + square + "]}", "g");
    EXPECT_EQ(scene.primitives.size(), 4u);
    EXPECT_EQ(scene.warnings,
              (std::vector<std::string>{"1 feature without geometry: left out", "1 feature null: left out"}));
}

TEST(SceneGeoJson, FeaturesAreObjectsByNameIdAndNumber) {
    const auto line = [](const std::string& more, int y) {
        return R"({"type": "Feature", )" + more + R"("geometry": {"type": "LineString", "coordinates": [[0,)" +
               std::to_string(y) + R"(], [1,)" + std::to_string(y) + "]]}}";
    };
    Scene<2> scene = read_geojson(
        R"({"type": "FeatureCollection", "features": [{"type": "LineString", "coordinates": [[5,5],[6,5]]}, )" +
            line(R"("properties": {"name": "town hall"}, "id": 7, )", 1) + ", " + line(R"("id": 8, )", 2) + ", " +
            line(R"("properties": null, )", 3) + "]}",
        "g");
    EXPECT_EQ(scene.objects.names, (std::vector<std::string>{"town hall", "8", "feature 2", "no feature"}));
    EXPECT_EQ(scene.objects.of, (std::vector<std::uint32_t>{3, 0, 1, 2}));
    EXPECT_TRUE(read_geojson(line("", 1), "g").objects.empty());
}

TEST(SceneGeoJson, SaysThatDegreesAreSquashedAndScalesThem) {
    // 111 m by 111 m in Helsinki.
    const std::string square =
        R"({"type": "Polygon", "coordinates": [[[25,60],[25.002,60],[25.002,60.001],[25,60.001],[25,60]]]})";
    Scene<2> scene = read_geojson(square, "g");
    EXPECT_EQ(scene.warnings,
              std::vector<std::string>{"the coordinates look like degrees: x is stretched by 2 at latitude 60; "
                                       "--set degrees=scaled corrects it"});
    scene = read_geojson(square, "g", Degrees::scaled);
    EXPECT_TRUE(scene.warnings.empty());
    const Vec<2> extent = bounds<2>(scene.primitives).extent();
    EXPECT_NEAR(extent.x / extent.y, 1, 1e-4);
    // A plan near zero is none of it, nor are metres.
    EXPECT_TRUE(read_geojson(R"({"type": "LineString", "coordinates": [[0,0],[4,3]]})", "g").warnings.empty());
    EXPECT_EQ(read_geojson(R"({"type": "LineString", "coordinates": [[0,0],[400,60]]})", "g", Degrees::scaled).warnings,
              std::vector<std::string>{"the coordinates are no degrees: degrees=scaled leaves them as they are"});
    EXPECT_EQ(
        read_geojson(R"({"type": "LineString", "coordinates": [[179,0],[-179,1]]})", "g").warnings,
        std::vector<std::string>{"1 lines step over more than 180 degrees of longitude: cut them at the date line "
                                 "(RFC 7946, 3.1.9)"});
}

TEST(SceneGeoJson, ReadsAFeatureALine) {
    const std::string one = R"({"type": "LineString", "coordinates": [[0,0],[1,0]]})",
                      other = R"({"type": "LineString", "coordinates": [[0,1],[1,1]]})";
    EXPECT_EQ(read_geojson(one + "\n" + other + "\n", "g").primitives.size(), 2u);
    EXPECT_EQ(read_geojson("\x1e" + one + "\n\x1e" + other + "\n", "g").primitives.size(), 2u);
    expect_geojson_error(one + "\n" + other.substr(0, 20) + "\n", "g.json: line 2: line 1, column 21: *");
}

TEST(SceneJson, KeepsObjects) {
    const std::string text = R"({"format": "sightline-scene", "version": 1, "dimension": 2,
        "segments": [[0,0,1,0],[0,1,1,1],[0,2,1,2]], "objects": {"names": ["a", "b"], "of": [0, 1, 1]}})";
    const Scene<2> scene = read_json(text, "s");
    EXPECT_EQ(scene.objects.names, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(scene.objects.of, (std::vector<std::uint32_t>{0, 1, 1}));
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(read_json(write_json(scene), "s").objects, scene.objects);
    const auto with = [&](const std::string& of) {
        std::string other = text;
        return other.replace(other.find("[0, 1, 1]"), 9, of);
    };
    const std::string numbers = "s: /objects/of: expected numbers of names, from 0";
    expect_input_error([&] { read_json(with("[0, 1, 2]"), "s"); }, numbers);
    expect_input_error([&] { read_json(with("[0, 1, -1]"), "s"); }, numbers);
    expect_input_error([&] { read_json(with("[0, 1]"), "s"); }, "s: /objects: expected an array of names*");
    expect_input_error([] { read_json(R"({"format": "sightline-state", "version": 1})", "s"); },
                       "s: /format: is a state file: open it with --state");
}

TEST(SceneGeoJson, SaysWhatIsWrongAndWhere) {
    expect_geojson_error("[]", "g.json: expected an object, found an array");
    expect_geojson_error("{}", "g.json: \"type\" is missing");
    expect_geojson_error(R"({"type": 3})", "g.json: /type: expected a string, found a number");
    expect_geojson_error(R"({"type": "Polgon"})", "g.json: /type: \"Polgon\" is not a GeoJSON type");
    expect_geojson_error(R"({"type": "Polygon"})", "g.json: \"coordinates\" is missing");
    expect_geojson_error(R"({"type": "FeatureCollection"})", "g.json: \"features\" is missing");
    expect_geojson_error(R"({"type": "FeatureCollection", "features": [1]})",
                         "g.json: /features/0: expected an object, found a number");
    const auto line = [](const std::string& position) {
        return R"({"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0,0],)" + position + "]}}";
    };
    expect_geojson_error(line("[1]"), "g.json: /geometry/coordinates/1: a position needs at least two numbers");
    expect_geojson_error(line("7"), "g.json: /geometry/coordinates/1: expected an array, found a number");
    expect_geojson_error(line("[1,true]"), "g.json: /geometry/coordinates/1/1: expected a number, found true or false");
    expect_geojson_error(line("[1,-2e200]"), "g.json: segment 0: coordinate -2e+200 is too large (limit 1e150)");
    expect_geojson_error(line("[1,1e400]"), "g.json: line 1, column 81: number overflow parsing '1e400'");
    expect_geojson_error(line("[1,Infinity]"), "g.json: line 1, column *");
    expect_geojson_error(line("[1,2]").substr(0, 60), "g.json: line 1, column 61: *");
}

}  // namespace
}  // namespace sightline
