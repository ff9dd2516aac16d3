// GeoJSON (RFC 7946): outlines and lines become segments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/scene/reading.h"
#include "core/scene/scene.h"

namespace sightline {

/// Reads FeatureCollection, Feature, GeometryCollection, Polygon, MultiPolygon, LineString and MultiLineString in any
/// nesting; a segment joins consecutive positions. Coordinates are taken as plane x, y whatever they mean; further
/// numbers of a position are ignored. Rings that do not end where they begin are closed. Points, features that are null
/// or have no geometry, and closed rings are counted in scene.warnings. Recentres (see clean()); `name` begins error
/// lines and is the id. Throws InputError "name: /features/3/geometry/…: reason".
///
/// Features are objects by their properties' "name", their "id", or "feature 3" as they come. Coordinates that fit into
/// degrees and would be stretched by more than a hundredth get a warning, or with Degrees::scaled x is multiplied by
/// the cosine of the middle latitude.
Scene<2> read_geojson(std::string_view text, const std::string& name, Degrees degrees = Degrees::as_is);

}  // namespace sightline
