// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/read_geojson.h"

#include <algorithm>
#include <cmath>

#include "core/base/index.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/base/trig.h"
#include "core/base/utf8_mark.h"
#include "core/scene/clean.h"
#include "core/scene/read/parsed_scene.h"

namespace sightline {

namespace {

struct Reader {
    const std::string& name;
    Scene<2> scene;
    std::size_t points = 0, no_geometry = 0, open_rings = 0, null_features = 0, features = 0;

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
        for (std::size_t i = 0; i < values.size(); ++i)
            if (values[i].is_null())
                ++null_features;
            else
                read(values[i], inner.element(i));
    }
    /// What is read inside belongs to it.
    void feature(const Json& value, const JsonPlace& place) {
        const std::size_t number = features++;
        const auto geometry = value.find("geometry");
        if (geometry == value.end() || geometry->is_null()) {
            ++no_geometry;
            return;
        }
        Objects& objects = scene.objects;
        const auto object = static_cast<std::uint32_t>(objects.names.size());
        objects.names.push_back(name_of(value, number));
        objects.of.resize(scene.primitives.size(), none);  // what stands before it in no feature
        read(*geometry, place.member("geometry"));
        objects.of.resize(scene.primitives.size(), object);
    }
    static std::string name_of(const Json& value, std::size_t number) {
        const auto text = [](const Json& of, const char* key) -> std::string {
            const auto found = of.find(key);
            if (found == of.end()) return "";
            return found->is_string() ? found->get<std::string>() : found->is_number() ? found->dump() : "";
        };
        const auto properties = value.find("properties");
        std::string found = properties == value.end() || !properties->is_object() ? "" : text(*properties, "name");
        if (found.empty()) found = text(value, "id");
        return found.empty() ? "feature " + std::to_string(number) : found;
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
            feature(value, place);
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
    /// What stands in no feature is an object, too; a single feature without a name is no object.
    void finish_objects() {
        Objects& objects = scene.objects;
        if (objects.names.empty()) return;
        objects.of.resize(scene.primitives.size(), none);
        const auto outside = static_cast<std::uint32_t>(objects.names.size());
        if (std::count(objects.of.begin(), objects.of.end(), none) > 0) objects.names.emplace_back("no feature");
        std::replace(objects.of.begin(), objects.of.end(), none, outside);
        if (objects.names == std::vector<std::string>{"feature 0"}) objects = {};
    }
    void warn(std::size_t count, const char* what, const char* done) {
        if (count > 0) scene.warnings.push_back(counted(count, what) + " " + done);
    }
};

/// Lines that step over half the globe: most likely they cross the date line and were drawn the other way round.
void warn_of_date_line(Scene<2>& scene) {
    const auto far = std::count_if(scene.primitives.begin(), scene.primitives.end(),
                                   [](const Primitive<2>& s) { return std::abs(s[1].x - s[0].x) > 180; });
    if (far > 0)
        scene.warnings.push_back(std::to_string(far) +
                                 " lines step over more than 180 degrees of longitude: cut them at the date line "
                                 "(RFC 7946, 3.1.9)");
}

/// RFC 7946 has degrees, where one of longitude is shorter than one of latitude; a plane has not.
void treat_degrees(Scene<2>& scene, Degrees degrees) {
    const Box<2> box = bounds<2>(scene.primitives);
    const bool fit =
        !scene.primitives.empty() && box.min.x >= -180 && box.max.x <= 180 && box.min.y >= -90 && box.max.y <= 90;
    if (!fit) {
        if (degrees == Degrees::scaled && !scene.primitives.empty())
            scene.warnings.push_back("the coordinates are no degrees: degrees=scaled leaves them as they are");
        return;
    }
    warn_of_date_line(scene);
    const double latitude = (box.min.y + box.max.y) / 2, shorter = sincos_degrees(latitude).cos;
    if (degrees == Degrees::scaled && shorter > 0) {
        for (Primitive<2>& s : scene.primitives)
            for (Vec<2>& p : s) p.x *= shorter;
    } else if (shorter > 0 && shorter < 0.99) {
        scene.warnings.push_back("the coordinates look like degrees: x is stretched by " +
                                 short_number(std::round(100 / shorter) / 100) + " at latitude " +
                                 short_number(std::round(latitude)) + "; --set degrees=scaled corrects it");
    }
}

/// What begins each record of RFC 8142.
constexpr char record_separator = '\x1e';

}  // namespace

std::optional<Json> geojson_sequence(std::string_view text, const std::string& name) {
    text = without_mark(text);
    const auto line_end = [](std::string_view of) { return std::min(of.find('\n'), of.size()); };
    const auto is_blank = [](std::string_view of) { return of.find_first_not_of(" \t\r\n") == std::string_view::npos; };
    const char between = text.starts_with(record_separator) ? record_separator : '\n';
    if (between == '\n') {
        // One object a line: the first is whole and another one follows.
        const std::string_view first = text.substr(0, line_end(text));
        const std::size_t next = text.find_first_not_of(" \t\r\n", first.size());
        if (next == std::string_view::npos || text[next] != '{' || !Json::accept(first)) return std::nullopt;
    }
    Json features = Json::array();
    for (std::size_t record = 0; !text.empty();) {
        const std::string_view one = text.substr(0, text.find(between));
        text.remove_prefix(std::min(one.size() + 1, text.size()));
        ++record;
        if (!is_blank(one))
            features.push_back(parse_json(
                one, name + (between == '\n' ? ": line " : ": record ") + std::to_string(record - (between != '\n'))));
    }
    return Json{{"type", "FeatureCollection"}, {"features", std::move(features)}};
}

Scene<2> scene_from_geojson(const Json& root, const std::string& name, Degrees degrees) {
    Reader reader{name, {}};
    reader.read(root, JsonPlace{});
    Scene<2>& scene = reader.scene;
    scene.id = scene.title = name;
    scene.source = "geojson";
    reader.warn(reader.points, "point", "left out");
    reader.warn(reader.no_geometry, "feature", "without geometry: left out");
    reader.warn(reader.null_features, "feature", "null: left out");
    reader.warn(reader.open_rings, "open polygon ring", "closed");
    reader.finish_objects();
    treat_degrees(scene, degrees);
    clean(scene, Recentre::yes, name);
    scene.start_view = default_view(scene.primitives);
    return std::move(scene);
}

Scene<2> read_geojson(std::string_view text, const std::string& name, Degrees degrees) {
    const std::optional<Json> sequence = geojson_sequence(text, name);
    return scene_from_geojson(sequence ? *sequence : parse_json(text, name), name, degrees);
}

}  // namespace sightline
