// The mouse on walls: nothing moves by accident, and in the edit mode all of it can be.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/draw/choice.h"
#include "core/draw/shown_world.h"
#include "shell/desk/open_scene.h"
#include "shell/desk/undo.h"
#include "tests/shell/desk/bench_support.h"
#include "tests/shell/window/window_driver.h"
#include "viewer2d/camera.h"
#include "viewer2d/stage2d.h"

namespace sightline {
namespace {

using namespace test;

/// The wall of two segments; the first one is long, and nothing lies close to it.
class WindowEdit : public ::testing::Test {
protected:
    WindowEdit() : kept(open_scene("wall2", start_settings("wall2"), method_table<2>(), [](const auto&) {})) {}
    void SetUp() override {
        try {
            driver = std::make_unique<WindowDriver<2>>(kept.bench, 960, 600, stage2d);
        } catch (const WorkError& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
        act("seek 20");
    }
    void act(const std::string& commands) {
        driver->window().ui().act(commands);
        driver->frames(3);
    }
    Session<2>& session() { return kept.bench.session; }
    const Primitive<2>& wall(std::size_t i = 0) { return session().scene().primitives[i]; }
    ImVec2 in_window(const Vec<2>& point) {
        const Place at = *driver->place("picture");
        const Area area{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.w),
                        static_cast<float>(at.h)};
        return Camera{widened(shown_world(session()), area.w / area.h), area}.to_window(point);
    }
    /// That share of the way along the wall.
    ImVec2 on_wall(double share) { return in_window(wall()[0] + (wall()[1] - wall()[0]) * share); }

    test::Bench kept;
    std::unique_ptr<WindowDriver<2>> driver;
};

TEST_F(WindowEdit, WithoutItAWallIsSelectedAndADragPans) {
    const auto scene = session().shared_scene();
    const ViewSpec<2> view = session().culling_view();
    const ImVec2 at = on_wall(0.4);
    driver->click(at.x, at.y);
    driver->frames(2);
    EXPECT_EQ(session().selected_primitive, 0u);
    EXPECT_EQ(driver->place("handle segment start"), nullptr);
    EXPECT_EQ(driver->place("handle look"), nullptr);
    ASSERT_NE(driver->place("handle eye"), nullptr);
    const ImVec2 end = in_window(wall()[1]);
    for (const ImVec2& from : {on_wall(0.7), end}) {  // not where a second click would be a double one
        driver->drag(from.x, from.y, from.x + 60, from.y + 40);
        driver->drop();
    }
    EXPECT_EQ(session().shared_scene(), scene) << "nothing was edited";
    EXPECT_EQ(session().culling_view(), view);
    EXPECT_NEAR(in_window(wall()[1]).x, end.x + 120, 3) << "it was panned";
    act("undo; undo");
    const Place eye = *driver->place("handle eye");
    driver->drag(eye.x, eye.y, eye.x + 30, eye.y);
    driver->drop();
    EXPECT_NE(session().culling_view(), view) << "the eye can always be dragged";
    EXPECT_EQ(session().position(), 20u);
}

/// The cell in question is full of crates: a click on one of their lines is a guess too.
TEST_F(WindowEdit, WhereALessonAsksForACellALineInItSelectsTheCell) {
    act("lesson plp 2");
    for (int i = 0; i < 6; ++i) act("next");
    const std::uint32_t cell = first_in_front(session());
    const CellComplex<2>& cells = session().cells();
    std::optional<ImVec2> at;
    for (const std::uint32_t crate : cells.primitives_of(cell)) {
        const Primitive<2>& line = session().scene().primitives[crate];
        const Vec<2> middle = (line[0] + line[1]) * 0.5;
        if (locate(cells, middle) == cell) at = in_window(middle);
    }
    ASSERT_TRUE(at);
    driver->click(at->x, at->y);
    driver->frames(2);
    EXPECT_EQ(session().selected_cell, cell);
    EXPECT_EQ(session().selected_primitive, none);
    act("next");
    EXPECT_EQ(kept.bench.teaching->score.right, 1u);
}

TEST_F(WindowEdit, InItAWallThatTheMouseIsOnHasHandles) {
    act("edit on");
    EXPECT_NE(driver->place("handle look"), nullptr);
    EXPECT_EQ(driver->place("handle segment start"), nullptr);
    const Primitive<2> before = wall();
    const ImVec2 middle = on_wall(0.5), end = in_window(wall()[1]);
    driver->move(middle.x, middle.y);
    driver->frames(2);
    EXPECT_NE(driver->place("handle segment start"), nullptr);
    driver->drag(end.x, end.y, end.x - 80, end.y + 30);
    driver->drop();
    EXPECT_EQ(wall()[0], before[0]);
    EXPECT_NE(wall()[1], before[1]);
    EXPECT_EQ(session().position(), 20u);
    EXPECT_EQ(session().selected_primitive, 0u);
    act("undo");
    EXPECT_EQ(wall(), before);
    driver->drag(middle.x, middle.y, middle.x, middle.y - 50);
    driver->drop();
    EXPECT_NE(wall()[0], before[0]) << "the whole wall moves";
    EXPECT_NEAR(glm::length(wall()[1] - wall()[0]), glm::length(before[1] - before[0]), 1e-9);
}

TEST_F(WindowEdit, AGapIsCutByTwoClicksOrByADrag) {
    const auto scene = session().shared_scene();
    const std::size_t count = scene->primitives.size();
    const Primitive<2> whole = wall();
    act("tool gap");
    EXPECT_TRUE(kept.bench.desk.edit);
    const ImVec2 from = on_wall(0.4), to = on_wall(0.6);
    const auto expect_gap = [&](const char* how) {
        ASSERT_EQ(session().scene().primitives.size(), count + 1) << how;
        EXPECT_EQ(wall()[0], whole[0]) << how;
        EXPECT_EQ(wall(count)[1], whole[1]) << how;
        const double length = glm::length(whole[1] - whole[0]);
        EXPECT_NEAR(glm::length(wall()[1] - whole[0]), 0.4 * length, 0.02 * length) << how;
        EXPECT_NEAR(glm::length(wall(count)[0] - whole[0]), 0.6 * length, 0.02 * length) << how;
        EXPECT_EQ(session().position(), 20u) << how;
    };
    driver->click(from.x, from.y);
    driver->frames(2);
    EXPECT_EQ(session().shared_scene(), scene);
    driver->click(to.x, to.y);
    driver->frames(2);
    expect_gap("two clicks");
    act("undo");
    EXPECT_EQ(session().shared_scene(), scene);
    driver->drag(to.x, to.y, from.x, from.y);
    driver->drop();
    expect_gap("a drag");
    act("undo");
    EXPECT_EQ(session().shared_scene(), scene) << "one entry of the history";
    // Escape forgets the first click, and then the tool.
    driver->click(from.x, from.y);
    driver->frames(2);
    driver->key(SDLK_ESCAPE);
    driver->frames(3);
    EXPECT_EQ(kept.bench.desk.tool, Tool::gap);
    driver->click(to.x, to.y);
    driver->frames(2);
    EXPECT_EQ(session().shared_scene(), scene) << "that was a first click";
}

TEST_F(WindowEdit, EscapeClosesAListThatHasDroppedDownAndNothingElse) {
    kept.bench.desk.left = "settings";
    driver->frames(3);
    act("select primitive:3");
    const Place method = *driver->place("setting method");
    const auto dropped = [] { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); };
    for (const Place& at : {method, *driver->place("menu View")}) {
        driver->click(at.x + at.w / 2, at.y + at.h / 2);
        driver->frames(2);
        ASSERT_TRUE(dropped()) << at.name;
        driver->key(SDLK_ESCAPE);
        driver->frames(3);
        EXPECT_FALSE(dropped()) << at.name;
        EXPECT_EQ(session().selected_primitive, 3u) << at.name;
    }
    driver->key(SDLK_ESCAPE);
    driver->frames(3);
    EXPECT_EQ(session().selected_primitive, none) << "now it was meant for the picture";
    EXPECT_FALSE(kept.bench.quit);
}

}  // namespace
}  // namespace sightline
