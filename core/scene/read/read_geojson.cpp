// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_geojson.h"

#include "core/base/text.h"
#include "core/scene/clean.h"
#include "core/scene/read/parsed_scene.h"

namespace sightline {

namespace {

struct Reader {
    const std::string& name;
    Scene<2> scene;
    std::size_t points = 0, no_geometry = 0, open_rings = 0;

    [[noreturn]] void fail(const JsonPlace& place, const std::string& reason) const {
        throw input_error(name, place.text(), reason);
    }
    const Json& array(const Json& value, const JsonPlace& place) const {
        if (!value.is_array()) fail(place, std::string("expected an array, found ") + json_kind(value));
        return value;
    }
    const Json& member(const Json& object, const char* key, const JsonPlace& place) const {
        const auto found = object.find(key);
        if (found == object.end()) fail(place, std::string("\"") + key + "\" is missing");
        return *found;
    }
    Vec<2> position(const Json& value, const JsonPlace& place) const {
        if (array(value, place).size() < 2) fail(place, "a position needs at least two numbers");
        return {json_number(value[0], place.element(0), name), json_number(value[1], place.element(1), name)};
    }
    void line(const Json& value, const JsonPlace& place, bool ring) {
        array(value, place);
        Vec<2> first{}, previous{};
        for (std::size_t i = 0; i < value.size(); ++i) {
            const Vec<2> p = position(value[i], place.element(i));
            if (i == 0)
                first = p;
            else
                scene.primitives.push_back({previous, p});
            previous = p;
        }
        if (ring && previous != first) {
            ++open_rings;
            scene.primitives.push_back({previous, first});
        }
    }
    void lines(const Json& value, const JsonPlace& place, bool rings) {
        array(value, place);
        for (std::size_t i = 0; i < value.size(); ++i) line(value[i], place.element(i), rings);
    }
    void all(const Json& object, const char* key, const JsonPlace& place) {
        const JsonPlace inner = place.member(key);
        const Json& values = array(member(object, key, place), inner);
        for (std::size_t i = 0; i < values.size(); ++i) read(values[i], inner.element(i));
    }
    /// A collection, a feature or a geometry: the depth of the parsed text bounds the recursion.
    void read(const Json& value, const JsonPlace& place) {
        if (!value.is_object()) fail(place, std::string("expected an object, found ") + json_kind(value));
        const Json& type = member(value, "type", place);
        if (!type.is_string()) fail(place.member("type"), std::string("expected a string, found ") + json_kind(type));
        const JsonPlace inner = place.member("coordinates");
        if (type == "FeatureCollection") {
            all(value, "features", place);
        } else if (type == "GeometryCollection") {
            all(value, "geometries", place);
        } else if (type == "Feature") {
            const Json& geometry = member(value, "geometry", place);
            if (geometry.is_null())
                ++no_geometry;
            else
                read(geometry, place.member("geometry"));
        } else if (type == "LineString") {
            line(member(value, "coordinates", place), inner, false);
        } else if (type == "MultiLineString") {
            lines(member(value, "coordinates", place), inner, false);
        } else if (type == "Polygon") {
            lines(member(value, "coordinates", place), inner, true);
        } else if (type == "MultiPolygon") {
            const Json& polygons = array(member(value, "coordinates", place), inner);
            for (std::size_t i = 0; i < polygons.size(); ++i) lines(polygons[i], inner.element(i), true);
        } else if (type == "Point" || type == "MultiPoint") {
            ++points;
        } else {
            fail(place.member("type"), "\"" + one_line(type.get<std::string>(), 40) + "\" is not a GeoJSON type");
        }
    }
    void warn(std::size_t count, const char* what) {
        if (count > 0) scene.warnings.push_back(std::to_string(count) + what);
    }
};

}  // namespace

Scene<2> scene_from_geojson(const Json& root, const std::string& name) {
    Reader reader{name, {}};
    reader.read(root, JsonPlace{});
    Scene<2>& scene = reader.scene;
    scene.id = scene.title = name;
    scene.source = "geojson";
    reader.warn(reader.points, " point geometries were ignored");
    reader.warn(reader.no_geometry, " features have no geometry");
    reader.warn(reader.open_rings, " open polygon rings were closed");
    clean(scene, Recentre::yes, name);
    scene.start_view = default_view(scene.primitives);
    return std::move(scene);
}

Scene<2> read_geojson(std::string_view text, const std::string& name) {
    return scene_from_geojson(parse_json(text, name), name);
}

}  // namespace sightline
