// Sessions of the catalogue's scenes, and what a draw list holds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/scene/make/catalogue.h"
#include "tests/session/session_support.h"

namespace sightline::test {

inline Session<2> session_of(const CatalogueRow<2>& row, const char* budget = "unlimited") {
    Settings settings;
    settings.error_bound = row.error_bound;
    settings.method = row.method;
    settings.budget = parse_budget(budget);
    for (const SettingOverride& s : row.settings) apply_setting(settings, std::string(s.field) + "=" + s.value);
    return {std::make_shared<const Scene<2>>(make_scene(row)), row.view, settings};
}

inline std::uint16_t style_of(Look look) { return static_cast<std::uint16_t>(look); }

inline std::set<std::vector<double>> polygons(const DrawList& list, Look look) {
    std::set<std::vector<double>> found;
    for (const Shape& shape : list.shapes)
        if (shape.kind == ShapeKind::polygon && shape.style == style_of(look)) {
            std::vector<double> corners;
            for (std::uint32_t i = 0; i < shape.point_count; ++i) {
                corners.push_back(list.points[shape.first_point + i].x);
                corners.push_back(list.points[shape.first_point + i].y);
            }
            EXPECT_TRUE(found.insert(corners).second) << "drawn twice";
        }
    return found;
}

inline std::size_t count(const DrawList& list, Look look) {
    return static_cast<std::size_t>(std::count_if(list.shapes.begin(), list.shapes.end(),
                                                  [&](const Shape& s) { return s.style == style_of(look); }));
}

}  // namespace sightline::test
