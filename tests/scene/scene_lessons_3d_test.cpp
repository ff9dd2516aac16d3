// Each 3D scene of the catalogue shows what its lesson says, measured with the real traversal; Embree's rays are the
// reference.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "core/methods/plp/plp_parameters.h"
#include "core/scene/make/catalogue.h"
#include "core/session/condition.h"
#include "core/session/session.h"
#include "core/session/settings_table.h"
#include "tests/shell/gl/embree_caster.h"

namespace sightline {
namespace {

std::vector<IdImage> cast_ids(const Scene<3>& scene, const View<3>& view, const ImageSize& size, int) {
    const test::EmbreeCaster rays(scene, view.eye);
    IdImage image{size.width, size.height, {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) image.ids.push_back(rays.first(pixel_centre(view, size, x, y)));
    return {image};
}

Session<3> open(const char* id, std::initializer_list<const char*> assignments = {}) {
    const CatalogueRow<3>& row = *find_in_catalogue<3>(id);
    Settings settings;
    settings.error_bound = row.error_bound;
    settings.method = row.method;
    settings.budget = parse_budget(row.budget);
    apply_setting(settings, "reference_size=400x300");
    for (const SettingOverride& s : row.settings) apply_setting(settings, std::string(s.field) + "=" + s.value);
    for (const char* assignment : assignments) apply_setting(settings, assignment);
    return Session<3>(std::make_shared<const Scene<3>>(make_scene(row, row.triangles)), row.view, settings,
                      method_table<3>(), cast_ids);
}

Session<3> ran(const char* id, std::initializer_list<const char*> assignments = {}) {
    Session<3> session = open(id, assignments);
    session.run();
    return session;
}

double covered(const Session<3>& s) { return coverage(s.reference(), s.visible_rendered()).value(); }

double visible_part(const Session<3>& s) {
    return static_cast<double>(s.reference().count) / static_cast<double>(s.scene().primitives.size());
}

double wrong(const Session<3>& s) { return wrong_pixels(s.reference(), s.met()); }

std::size_t hidden_rendered(const Session<3>& s) { return s.counters().rendered_count - s.visible_rendered(); }

void expect_bookmarks(Session<3>& session) {
    for (const CatalogueBookmark& bookmark : find_in_catalogue<3>(session.scene().id)->bookmarks) {
        const Condition<3> holds(bookmark.condition);
        session.seek(0);
        EXPECT_EQ(session.run_until([&](const Session<3>& s) { return holds.holds(s); }), Stop::breakpoint)
            << bookmark.label;
    }
}

TEST(SceneLessons3, BottleneckNeedsTheStarShapePenalty) {
    for (const char* seed : {"seed=1", "seed=2", "seed=3"}) {
        SCOPED_TRACE(seed);
        Session<3> without = ran("bottleneck", {seed});
        EXPECT_EQ(without.settings().parameters.text(penalty_row()), "none");
        EXPECT_LT(covered(without), 0.9);
        EXPECT_EQ(covered(ran("bottleneck", {seed, "penalty=add"})), 1);
        expect_bookmarks(without);

        const auto crates_before_walls = [](const Session<3>& s) {
            const std::vector<Inversion> found = s.inversions();
            return std::count_if(found.begin(), found.end(), [&](const Inversion& inversion) {
                return inversion.wasted > 0 && s.cells().centre(inversion.cell).y > 9;
            });
        };
        const Session<3> all_without = ran("bottleneck", {seed, "budget=unlimited"});
        const Session<3> all_with = ran("bottleneck", {seed, "budget=unlimited", "penalty=add"});
        EXPECT_GT(crates_before_walls(all_without), 10);
        EXPECT_EQ(crates_before_walls(all_with), 0);
        EXPECT_LT(2 * all_with.inversions().size(), all_without.inversions().size());
    }
}

TEST(SceneLessons3, WallOfTwoTrianglesHidesAStoreAndCountsForNothing) {
    Session<3> session = ran("wall2");
    std::size_t behind = 0;
    for (const std::uint32_t triangle : rendered_ids(session.met()))
        behind += session.scene().primitives[triangle][0].y > 15;
    EXPECT_GT(static_cast<double>(behind), 0.7 * static_cast<double>(session.counters().rendered_count));
    expect_bookmarks(session);
    const Vec<3> centre = session.cells().centre(last_cell(session));
    EXPECT_GT(centre.y, 15) << "the last bookmark is behind the wall";
}

TEST(SceneLessons3, CityShowsAFewPercentAndDrawsHiddenRooms) {
    Session<3> session = ran("city");
    EXPECT_LT(visible_part(session), 0.03);
    EXPECT_GT(session.reference().count, 500u);
    EXPECT_GT(hidden_rendered(session), 5 * session.visible_rendered());
    expect_bookmarks(session);
}

TEST(SceneLessons3, CarsDrawEnginesWhileTheBodyWaits) {
    Session<3> session = ran("cars");
    EXPECT_LT(visible_part(session), 0.05);
    EXPECT_GT(hidden_rendered(session), 2 * session.visible_rendered());
    EXPECT_LT(covered(session), 0.8);
    expect_bookmarks(session);
}

TEST(SceneLessons3, RoomJudgesByCountAndByPixelsDifferently) {
    Session<3> session = ran("room");
    const Session<3> nearest_first = ran("room", {"method=centroid"});
    EXPECT_GT(visible_part(session), 0.05);
    EXPECT_GT(covered(nearest_first), covered(session) - 0.05);
    EXPECT_GT(wrong(nearest_first), 0.5);
    EXPECT_GT(wrong(nearest_first), 2 * wrong(session));
    expect_bookmarks(session);
}

TEST(SceneLessons3, JungleHidesMuchWithLittle) {
    Session<3> session = ran("jungle");
    EXPECT_LT(visible_part(session), 0.1);
    EXPECT_LT(covered(session), 0.7);
    expect_bookmarks(session);
}

}  // namespace
}  // namespace sightline
