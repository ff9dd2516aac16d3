// GeoJSON (RFC 7946): outlines and lines become segments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace sightline {

/// Reads FeatureCollection, Feature, GeometryCollection, Polygon, MultiPolygon, LineString and MultiLineString in any
/// nesting; a segment joins consecutive positions. Coordinates are taken as plane x, y whatever they mean; further
/// numbers of a position are ignored. Rings that do not end where they begin are closed. Points, null geometries and
/// closed rings are counted in scene.warnings. Recentres (see clean()); `name` begins error lines and is the id.
/// Throws InputError "name: /features/3/geometry/…: reason".
Scene<2> read_geojson(std::string_view text, const std::string& name);

}  // namespace sightline
