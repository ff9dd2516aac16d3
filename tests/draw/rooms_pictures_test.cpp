// Pictures of rooms and portals, by whichever method goes there, and of levels that stand in for objects.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/draw/paint_rooms.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/draw/picture_3d.h"
#include "core/draw/solid_palette.h"
#include "core/scene/read/load.h"
#include "core/session/settings_table.h"

namespace sightline {
namespace {

template <int D>
Session<D> session_with(const char* scene, std::initializer_list<const char*> settings) {
    Settings set;
    for (const char* one : settings) apply_setting(set, one);
    const auto read = std::make_shared<const Scene<D>>(load_scene<D>(scene));
    return Session<D>(read, *read->start_view, set);
}

std::size_t shapes_of(const DrawList& list, Look look, ShapeKind kind) {
    return static_cast<std::size_t>(std::count_if(list.shapes.begin(), list.shapes.end(), [&](const Shape& shape) {
        return shape.style == static_cast<std::uint16_t>(look) && shape.kind == kind;
    }));
}

TEST(RoomsPictures, WindowsAreDrawnForTheTechniqueThatAChoiceFallsOn) {
    Session<2> portals = session_with<2>("rooms", {"method=portals", "budget=unlimited"});
    Session<2> choice =
        session_with<2>("rooms", {"method=by-viewpoint samples=1 techniques=portals", "budget=unlimited"});
    EXPECT_TRUE(walks_rooms(portals));
    EXPECT_TRUE(walks_rooms(choice));
    EXPECT_FALSE(walks_rooms(session_with<2>("rooms", {"method=view"})));
    for (const std::uint32_t step : {0u, 3u, 9u}) {
        portals.seek(step);
        choice.seek(step + 1);  // the look-up comes first
        const DrawList alone = make_picture(portals), chosen = make_picture(choice);
        for (const Look look : {Look::projected, Look::enqueued})
            EXPECT_EQ(shapes_of(chosen, look, ShapeKind::polygon), shapes_of(alone, look, ShapeKind::polygon)) << step;
        EXPECT_GE(shapes_of(alone, Look::projected, ShapeKind::polygon), step);
    }
}

TEST(RoomsPictures, InSpaceRoomsAreBoxesByWhatHasBecomeOfThem) {
    Session<3> session = session_with<3>("soda", {"method=portals", "budget=unlimited", "clean_as=off", "triangles=off",
                                                  "projected_as=solid", "enqueued_as=wireframe"});
    session.seek(4);
    session.freeze();
    session.set_view({{0, -60, 40}, {0, 0, 0}, 60});
    const std::vector<CellState> states = states_of_rooms(session);
    EXPECT_GE(std::count(states.begin(), states.end(), CellState::projected), 1);
    const SolidList list = make_solid(session);
    const auto projected = std::count(states.begin(), states.end(), CellState::projected),
               waiting = std::count(states.begin(), states.end(), CellState::enqueued);
    EXPECT_GE(waiting, 1);
    EXPECT_EQ(std::ssize(list.face_style), 6 * projected);
    const auto style = [](SolidLook look) { return static_cast<std::uint8_t>(look); };
    const auto edges = [&](SolidLook look) {
        return std::count(list.edge_style.begin(), list.edge_style.end(), style(look));
    };
    EXPECT_EQ(edges(SolidLook::border), 4 * std::ssize(session.scene().rooms.portals));
    EXPECT_EQ(edges(SolidLook::enqueued), 12 * waiting);
}

TEST(LevelsPictures, ALevelHasAColourOfItsOwn) {
    Session<3> session =
        session_with<3>("city:10k", {"method=levels pixel_error=8", "budget=unlimited", "reference_size=320x240"});
    session.run();
    const auto stand_ins = session.traversal().stand_ins();
    ASSERT_FALSE(stand_ins.empty());
    std::set<SolidLook> wanted, found;
    for (const StandIn& stand_in : stand_ins) wanted.insert(level_look(SolidLook::level_1, stand_in.level));
    const SolidList list = make_solid(session);
    for (const SolidList::Run& run : list.runs)
        if (run.style >= static_cast<std::uint8_t>(SolidLook::level_1)) found.insert(SolidLook{run.style});
    wanted.insert(found.begin(), found.end());
    EXPECT_EQ(found, wanted);
    EXPECT_EQ(level_look(Look::level_1, 1), Look::level_1);
    EXPECT_EQ(level_look(Look::level_1, 7), Look::level_3);
}

}  // namespace
}  // namespace sightline
