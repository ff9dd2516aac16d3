// Maps of a choice by viewpoint: what is chosen where, and that techniques stay apart in every palette.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/viewpoint_map.h"

#include <gtest/gtest.h>

#include <map>

#include "core/draw/compose.h"
#include "core/draw/insets.h"
#include "core/draw/legend.h"
#include "core/draw/palette.h"
#include "core/draw/viewpoint_plan.h"
#include "core/methods/by_viewpoint/viewpoint_run.h"
#include "tests/draw/picture_support.h"
#include "tests/session/session_3d_support.h"

namespace sightline {
namespace {

void set_small_table(Settings& settings) {
    settings.method = "by-viewpoint";
    for (const char* assignment : {"grid=3", "azimuths=4", "elevations=1", "samples=1"})
        apply_setting(settings, assignment);
}

Session<2> chooses_in(const char* scene) {
    const CatalogueRow<2>& row = *find_in_catalogue(scene);
    Settings settings;
    settings.error_bound = row.error_bound;
    set_small_table(settings);
    return {std::make_shared<const Scene<2>>(make_scene(row)), row.view, settings};
}

template <int D>
const ViewpointTable<D>& table_of(const Session<D>& session) {
    return dynamic_cast<const ViewpointRun<D>&>(session.traversal()).table();
}

/// Shapes of a kind by the name of their style.
std::map<std::string, std::size_t> shapes_by_style(const DrawList& list, ShapeKind kind) {
    std::map<std::string, std::size_t> counts;
    for (const Shape& shape : list.shapes) counts[list.styles[shape.style].name] += shape.kind == kind;
    return counts;
}

/// Of the regions and of the rose: how many have each style.
template <int D>
std::map<std::string, std::size_t> expected_polygons(const ViewpointFact<D>& fact, double height) {
    std::map<std::string, std::size_t> counts;
    const auto add = [&](std::uint32_t technique) {
        ++counts[technique == none ? "region_unknown" : "technique " + fact.techniques[technique].name];
    };
    for (const RegionFact<D>& region : fact.map)
        if (D == 2 || (region.box.min[D - 1] <= height && height <= region.box.max[D - 1])) add(region.technique);
    for (const DirectionFact& direction : fact.rose)
        if (direction.elevation == fact.rose[fact.interval_here].elevation) add(direction.technique);
    counts["region_here"] = counts["looked_into"] = 1;
    return counts;
}

void expect_polygons(const DrawList& list, const std::map<std::string, std::size_t>& expected) {
    std::map<std::string, std::size_t> found = shapes_by_style(list, ShapeKind::polygon);
    std::erase_if(found, [](const auto& entry) {
        return !entry.first.starts_with("technique ") && !entry.first.starts_with("region_") &&
               entry.first != "looked_into";
    });
    EXPECT_EQ(found, expected);
}

TEST(ViewpointMap, HasEachRegionAndDirectionInTheColourOfItsTechnique) {
    for (const char* scene : {"bottleneck", "rooms"}) {
        const Session<2> session = chooses_in(scene);
        const auto drawn = [&] { return make_picture(session); };
        expect_polygons(drawn(), expected_polygons(*session.traversal().viewpoint(), 0));
        table_of(session).fill(1, [&](std::size_t known) { return known < 20; });
        expect_polygons(drawn(), expected_polygons(*session.traversal().viewpoint(), 0));
        table_of(session).fill(1, {});
        const DrawList all = drawn();
        expect_polygons(all, expected_polygons(*session.traversal().viewpoint(), 0));
        EXPECT_EQ(shapes_by_style(all, ShapeKind::polygon)["region_unknown"], 0u);
        EXPECT_EQ(shapes_by_style(all, ShapeKind::polygon)["projected"], 0u) << "in place of the cells' states";
    }
}

TEST(ViewpointMap, DrawsRoomsOverTheBoxesAndOutlinesTheOneOfTheEye) {
    const CatalogueRow<2>& row = *find_in_catalogue("bottleneck");
    Scene<2> scene = make_scene(row);
    const Vec<2> eye = row.view.eye;
    const std::vector<Vec<2>> shape{eye + Vec<2>(-1, -1), eye + Vec<2>(1, -1), eye + Vec<2>(0, 2)};
    scene.rooms.all.push_back({"tent", shape});
    Settings settings;
    settings.error_bound = row.error_bound;
    set_small_table(settings);
    const Session<2> session(std::make_shared<const Scene<2>>(std::move(scene)), row.view, settings);
    ASSERT_EQ(session.traversal().viewpoint()->region, "room tent");
    const DrawList list = make_picture(session);
    std::size_t as_technique = 0, outlined = 0;
    for (const Shape& drawn : list.shapes) {
        const auto first = list.points.begin() + drawn.first_point;
        if (!std::equal(first, first + drawn.point_count, shape.begin(), shape.end())) continue;
        as_technique += list.styles[drawn.style].name.starts_with("technique ");
        outlined += list.styles[drawn.style].name == "region_here";
    }
    EXPECT_EQ(as_technique, 1u);
    EXPECT_EQ(outlined, 1u);
}

TEST(ViewpointMap, IsThereOnlyWhereAMethodChoosesByViewpointAndTheSettingIsOn) {
    Session<2> session = chooses_in("bottleneck");
    EXPECT_TRUE(shown_viewpoint(session));
    Settings settings = session.settings();
    settings.show_regions = Switch::off;
    session.change(settings);
    EXPECT_FALSE(shown_viewpoint(session));
    for (const Style& style : make_picture(session).styles) EXPECT_FALSE(region_row(style)) << style.name;
    settings.show_regions = Switch::on;
    settings.method = "published";
    session.change(settings);
    for (const Style& style : make_picture(session).styles) EXPECT_FALSE(region_row(style)) << style.name;
}

TEST(ViewpointMap, TheLegendNamesTheTechniquesOfThePictureInTheirOrder) {
    const Session<2> session = chooses_in("bottleneck");
    table_of(session).fill(1, {});
    const PanelSource<2> source{session, ""};
    const Figure figure = make_figure(std::span(&source, 1));
    const auto used = shapes_by_style(figure.panels[0].list, ShapeKind::polygon);
    std::vector<std::string> expected, found;
    const auto fact = session.traversal().viewpoint();
    for (const TechniqueFact& technique : fact->techniques)
        if (used.contains("technique " + technique.name)) expected.push_back(technique.name);
    for (const LegendRow& row : figure.legend)
        if (row.style.name.starts_with("technique ")) found.push_back(row.text);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(found, expected);
}

TEST(ViewpointMap, TechniquesStayApartInEveryPalette) {
    std::vector<TechniqueFact> techniques;
    for (const char* name : {"view", "shadow-frusta", "hom", "boxes", "published", "coorg-teller"})
        techniques.push_back({name});
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        const std::vector<Style> styles = technique_styles(techniques, palette);
        const Colours& c = colours(palette);
        for (std::size_t i = 0; i < styles.size(); ++i) {
            EXPECT_GE(contrast(styles[i].fill, c.looks[static_cast<std::size_t>(Look::rendered)].stroke), 2.5)
                << "what is drawn on it is lost: " << styles[i].name;
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_NE(styles[i].fill, styles[j].fill) << styles[i].name << " and " << styles[j].name;
                EXPECT_NE(styles[i].hatch, styles[j].hatch) << styles[i].name << " and " << styles[j].name;
            }
            if (styles[i].hatch != Hatch::none) {
                EXPECT_GE(std::abs(lightness(styles[i].fill) - lightness(styles[i].hatch_colour)), 8)
                    << "no hatch can be seen on " << styles[i].name;
            }
        }
    }
}

TEST(ViewpointPlan, IsASliceAtTheHeightOfTheEye) {
    Random random(5);
    for (int i = 0; i < 6; ++i) {
        Session<3> session = test::random_frozen_session(random, test::random_start_3d(random));
        EXPECT_FALSE(viewpoint_plan(session)) << "another method";
        Settings settings = session.settings();
        set_small_table(settings);
        session.change(settings);
        if (i % 2 == 0) table_of(session).fill(1, [](std::size_t known) { return known < 40; });
        const auto plan = viewpoint_plan(session);
        ASSERT_TRUE(plan);
        const ViewpointFact<3> fact = *session.traversal().viewpoint();
        const int up = session.scene().up_axis;
        if (up != 2) continue;  // expected_polygons counts along z
        double low = fact.map[0].box.min.z, high = low;
        for (const RegionFact<3>& region : fact.map) {
            low = std::min(low, region.box.min.z);
            high = std::max(high, region.box.max.z);
        }
        expect_polygons(plan->list, expected_polygons(fact, std::clamp(session.culling_view().eye.z, low, high)));
        const std::vector<Figure::Inset> insets = make_insets(session);
        ASSERT_FALSE(insets.empty());
        ASSERT_TRUE(insets.back().list);
        EXPECT_EQ(to_text(*insets.back().list), to_text(plan->list));
        EXPECT_NEAR(insets.back().aspect, plan->list.world.extent().x / plan->list.world.extent().y, 1e-12);
    }
}

}  // namespace
}  // namespace sightline
