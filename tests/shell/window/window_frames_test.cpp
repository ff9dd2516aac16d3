// 300 frames of the real window on every scene of the catalogue: every command, keys, clicks, drags, typing, resizing,
// in an order that a seed decides. Nothing may fail, and the driver may not complain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>
#include <map>
#include <numeric>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/scene/make/catalogue.h"
#include "shell/commands/command_table.h"
#include "shell/desk/moves.h"
#include "shell/desk/open_scene.h"
#include "shell/desk/undo.h"
#include "shell/panels/panel.h"
#include "tests/shell/desk/bench_support.h"
#include "tests/shell/window/window_driver.h"
#include "viewer2d/stage2d.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;
using namespace test;

constexpr int width = 960, height = 600, wanted_frames = 300;

/// On each scene something else happens.
std::uint64_t seed_of(const std::string& scene) {
    return std::accumulate(scene.begin(), scene.end(), std::uint64_t{147});
}

/// The window on a scene, and everything that a person can do to it.
class WindowOffScreen : public ::testing::Test {
protected:
    explicit WindowOffScreen(std::string name) : scene(std::move(name)) {
        fs::create_directories(folder);
        fs::current_path(folder);  // some keys write files here
        Session<2> session = open_scene(scene, start_settings(scene), method_table<2>(), [](const auto&) {});
        add_bookmarks(session);
        kept = std::make_unique<Bench>(std::move(session));
        bench = &kept->bench;
    }
    ~WindowOffScreen() override {
        driver.reset();
        fs::current_path(before);
        fs::remove_all(folder);
    }
    void SetUp() override {
        try {
            driver = std::make_unique<WindowDriver<2>>(*bench, width, height, stage2d);
        } catch (const WorkError& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
    }

    std::uint32_t random_cell() {
        return static_cast<std::uint32_t>(random.below(std::max(1u, bench->session.cells().cell_count())));
    }
    std::string point() {
        const Box<2> box = bounds<2>(bench->session.scene().primitives);
        return number_text(random.uniform(box.min.x, box.max.x)) + "," +
               number_text(random.uniform(box.min.y, box.max.y));
    }
    template <typename List>
    std::string one_of(const List& list) {
        return std::string(list[random.below(std::size(list))]);
    }
    std::string step() { return std::to_string(random.below(bench->session.recorded() + 2)); }
    std::string condition() {
        return one_of(std::array{"rho > 0.5", "visible_share == 0", "step:20", "cell:3", "inversion != 0 && front > 4",
                                 "coverage > 0.4", "penalties > 0"});
    }
    std::string setting();
    std::string argument(std::string_view id);

    /// Runs it as the console, the menus and the keys do.
    void act(const std::string& commands) {
        last = commands;
        driver->window().ui().act(commands);
        driver->frames(1 + static_cast<int>(random.below(2)));
    }
    void press_a_key();
    void click_something();
    void use_the_picture();
    void type_something();
    void arrange();
    void check(bool typed);
    void anything();

    std::string scene;
    Random random{seed_of(scene)};
    std::string last;  ///< what was done, for the reader of a failure
    fs::path before = fs::current_path();
    fs::path folder = fs::temp_directory_path() / ("sightline-frames-" + std::to_string(getpid()));
    std::unique_ptr<Bench> kept;
    Workbench<2>* bench = nullptr;
    std::unique_ptr<WindowDriver<2>> driver;
};

/// A valid FIELD=VALUE.
std::string WindowOffScreen::setting() {
    const SettingRow& row = settings_table()[random.below(settings_table().size())];
    const Settings other = random_settings(random);
    std::string value = row.words.empty() ? row.get(other) : one_of(row.words);
    if (row.name == "zoom") value = number_text(random.uniform(0.3, 5));
    if (row.name == "error_bound") value = number_text(random.uniform(0.05, 0.3));  // smaller cells take their time
    return quote_command(std::string(row.name) + "=" + value);  // lists of methods have semicolons
}

/// Something that the command takes; nothing for commands that this test does not know, which then may refuse.
std::string WindowOffScreen::argument(std::string_view id) {
    const Settings other = random_settings(random);
    if (id == "step" || id == "back") return std::to_string(random.below(12));
    if (id == "seek") return random.below(2) ? "start" : step();
    if (id == "until" || id == "break" || id == "mark") return condition();
    if (id == "break-switch") return "1";
    if (id == "reach" || id == "select") return std::to_string(random_cell());
    if (id == "play") return random.below(2) ? "20s" : "";
    if (id == "speed") return one_of(std::array{"half", "double", "30"});
    if (id == "eye" || id == "look") return point();
    if (id == "fov") return number_text(random.uniform(20, 360));
    if (id == "set") return setting();
    if (id == "cycle") return one_of(std::array{"heat", "label", "penalty", "palette", "show_chain", "legend"});
    if (id == "preset") return std::string(presets()[random.below(presets().size())].id);
    if (id == "method") return one_of(std::array{"published", "layers", "centroid", "view"});
    if (id == "budget") return one_of(std::array{"5%", "40", "unlimited"});
    if (id == "bookmark") return "here";
    if (id == "note")
        return one_of(note_kind_words) + " " + (random.below(2) ? point() : "cell:" + std::to_string(random_cell())) +
               " words";
    if (id == "note-edit") return "1 other words";
    if (id == "explain") return random.below(2) ? "" : "cell " + std::to_string(random_cell());
    if (id == "panels" || id == "trace" || id == "stats" || id == "save") return "written.txt";
    if (id == "open") return scene;
    if (id == "compare") return one_of(std::array{"layers", "published", "centroid"});
    if (id == "size") return "84mm";
    if (id == "shot") return one_of(std::array{"shot.pdf", "shot.svg", "shot.png"});
    if (id == "show") return std::string(panel_table<2>()[random.below(panel_table<2>().size())].id);
    if (id == "tool") return one_of(tool_words);
    if (id == "axis") return one_of(timeline_axis_words);
    if (id == "trade-off") return one_of(std::array{"go", "stop", "restart", "coverage", "published 5%"});
    if (id == "scale") return one_of(std::array{"up", "down", "1", "2", "0.5"});
    return "";
}

bool leaves_the_program(std::string_view id) { return id == "quit" || id == "film"; }

void WindowOffScreen::press_a_key() {
    static const std::array keys{SDLK_RIGHT, SDLK_LEFT,   SDLK_PAGEDOWN, SDLK_PAGEUP, SDLK_HOME,   SDLK_END,
                                 SDLK_SPACE, SDLK_RETURN, SDLK_TAB,      SDLK_F1,     SDLK_F5,     SDLK_F9,
                                 SDLK_F11,   SDLK_F12,    SDLK_ESCAPE,   SDLK_ESCAPE, SDLK_DELETE, SDLK_PLUS};
    static const std::array modifiers{KMOD_NONE, KMOD_NONE, KMOD_NONE, KMOD_LSHIFT, KMOD_LCTRL};
    const bool letter = random.below(2);
    const int code = letter ? SDLK_a + static_cast<int>(random.below(26)) : keys[random.below(keys.size())];
    const int with = modifiers[random.below(modifiers.size())];
    last = "key " + std::to_string(code) + " with " + std::to_string(with);
    driver->key(code, with);
    if (random.below(4) == 0) driver->type(one_of(std::array{":", "[", "]", "+"}));
    driver->frames(2);
    bench->quit = false;  // Ctrl+Q
}

void WindowOffScreen::click_something() {
    if (bench->places.empty()) return;
    const Place place = bench->places[random.below(bench->places.size())];
    last = "click " + place.name;
    driver->click(place.x + place.w / 2, place.y + place.h / 2);
    if (!place.name.starts_with("menu ")) return;
    // A row of the menu that opened, unless it is the one that quits.
    driver->move(place.x + 20, place.y + place.h + 8 + random.uniform(0, 200));
    driver->frames(1);
    driver->button(true);
    driver->frames(1);
    driver->button(false);
    driver->frames(1);
    bench->quit = false;
}

void WindowOffScreen::use_the_picture() {
    const Place* const picture = driver->place("picture");
    const Place* const handle = driver->place(random.below(2) ? "handle eye" : "handle look");
    if (!picture || !handle) return;
    const Place area = *picture, held = *handle;
    const auto x = [&] { return area.x + random.uniform(0.05, 0.95) * area.w; };
    const auto y = [&] { return area.y + random.uniform(0.05, 0.95) * area.h; };
    switch (random.below(5)) {
        case 0:
            last = "click on the picture";
            driver->click(x(), y());
            if (random.below(2)) driver->click(x(), y());
            break;
        case 1:
            last = "wheel";
            driver->move(x(), y());
            driver->wheel(random.below(2) ? 1 : -1);
            driver->frames(2);
            break;
        case 2:
            last = "pan";
            driver->drag(x(), y(), x(), y());
            driver->drop();
            break;
        case 3:
            last = "drag a handle";
            driver->drag(held.x, held.y, x(), y());
            driver->drop();
            break;
        default:
            last = "cancel a drag";
            driver->drag(held.x, held.y, x(), y());
            driver->key(SDLK_ESCAPE);
            driver->frames(1);
            driver->drop();
    }
}

void WindowOffScreen::type_something() {
    last = "typing";
    if (!bench->desk.console) act("console");
    driver->frames(2);
    driver->type(one_of(std::array{"step 3", "select last", "explain", "no such command", "set palette=", "\"", ";;",
                                   "until nonsense(", "back 2", "open nowhere"}));
    driver->frames(2);
    driver->key(random.below(3) ? SDLK_RETURN : SDLK_ESCAPE);
    driver->frames(2);
}

void WindowOffScreen::arrange() {
    last = "arrange";
    switch (random.below(4)) {
        case 0:
            driver->resize(640 + static_cast<int>(random.below(500)), 400 + static_cast<int>(random.below(300)));
            driver->frames(2);
            return;
        case 1:
            return act("scale " + number_text(random.uniform(smallest_scale, 2)));
        case 2:
            return act(one_of(std::array{"projector", "help", "scenes", "fullscreen"}));
        default:
            bench->desk = {};
            driver->resize(width, height);
            driver->frames(1);
    }
}

/// What holds after anything that a person does.
void WindowOffScreen::check(bool typed) {
    const Session<2>& s = bench->session;
    EXPECT_LE(s.position(), s.recorded());
    EXPECT_EQ(s.position(), s.traversal().steps());
    EXPECT_TRUE(s.selected_cell == none || s.selected_cell < s.cells().cell_count());
    EXPECT_TRUE(s.selected_primitive == none || s.selected_primitive < s.scene().primitives.size());
    EXPECT_FALSE(bench->places.empty());
    for (const Place& place : bench->places) {
        EXPECT_TRUE(std::isfinite(place.x) && std::isfinite(place.y)) << place.name;
        EXPECT_TRUE(place.w >= 0 && place.h >= 0) << place.name;
    }
    const auto& complaints = driver->window().context().messages();
    EXPECT_TRUE(complaints.empty()) << complaints.front();
    for (const Message& message : driver->window().ui().messages) {
        if (!message.bad) continue;
        // A command may refuse what it cannot do here; anything else is an error of the program.
        EXPECT_TRUE(message.text.starts_with("command")) << message.text;
        EXPECT_TRUE(typed || message.text.find("does not exist;") == std::string::npos) << message.text;
    }
    driver->window().ui().messages.clear();
}

void WindowOffScreen::anything() {
    const std::uint64_t kind = random.below(20);
    if (kind < 6) return press_a_key();
    if (kind < 10) return click_something();
    if (kind < 14) return use_the_picture();
    if (kind < 15) return type_something();
    if (kind < 16) return arrange();
    const auto table = command_table<2>();
    const Command<2>& command = table[random.below(table.size())];
    if (!leaves_the_program(command.id)) act(std::string(command.id) + " " + argument(command.id));
}

class WindowFrames : public WindowOffScreen, public ::testing::WithParamInterface<std::string> {
protected:
    WindowFrames() : WindowOffScreen(GetParam()) {}
};

class WindowMouse : public WindowOffScreen {
protected:
    WindowMouse() : WindowOffScreen("bottleneck") {}
};

TEST_F(WindowMouse, ADragWithinOneFrameIsADrag) {
    const Place eye = *driver->place("handle eye");
    const ViewSpec<2> start = bench->session.culling_view();
    driver->move(eye.x, eye.y);
    driver->button(true);
    for (int i = 1; i <= 5; ++i) driver->move(eye.x + 10 * i, eye.y);
    driver->button(false);
    driver->frames(4);
    EXPECT_EQ(bench->session.selected_cell, none);
    EXPECT_NE(bench->session.culling_view(), start);
    EXPECT_NEAR(driver->place("handle eye")->x, eye.x + 50, 2);
    driver->window().ui().act("undo");
    EXPECT_EQ(bench->session.culling_view(), start);
}

TEST_F(WindowMouse, AModifierThatIsLetGoWithTheKeyStillCountsForIt) {
    driver->window().ui().act("console");
    driver->frames(4);
    driver->type("nothing");
    driver->frames(3);
    // Ctrl comes a frame before the key and goes in the same frame, as fast hands and slow frames have it.
    driver->press(SDLK_LCTRL, KMOD_LCTRL);
    driver->frames(1);
    driver->press(SDLK_a, KMOD_LCTRL);
    driver->release(SDLK_LCTRL);
    driver->release(SDLK_a);
    driver->type("step");
    driver->frames(6);
    EXPECT_EQ(bench->desk.console_text, "step") << "Ctrl+A marks all, which is replaced";
}

TEST_F(WindowMouse, TheFieldOfANoteTakesTheMouseFromThePictureForGood) {
    driver->window().ui().act("seek 6; note text cell:last [0,60] seen; seek 2");
    driver->frames(2);
    ASSERT_NE(driver->place("note 1"), nullptr);
    const Place text = *driver->place("note 1");
    const double x = text.x + text.w / 2, y = text.y + text.h / 2;
    driver->click(x, y);
    driver->click(x, y);
    driver->frames(2);
    driver->type("now");
    driver->frames(2);
    // Tab goes on to the steps.
    for (const char* steps : {"1", "9"}) {
        driver->key(SDLK_TAB);
        driver->frames(2);
        driver->type(steps);
        driver->frames(2);
    }
    driver->key(SDLK_RETURN);
    driver->frames(4);
    EXPECT_EQ(bench->session.notes[0].text, "now");
    EXPECT_EQ(bench->session.notes[0].first_step, 1u);
    EXPECT_EQ(bench->session.notes[0].last_step, 9u);
    // Escape has no drag to take back, and the next click counts.
    driver->key(SDLK_RIGHT);
    driver->frames(2);
    EXPECT_EQ(bench->session.position(), 3u);
    driver->key(SDLK_ESCAPE);
    driver->frames(2);
    EXPECT_EQ(bench->session.position(), 3u);
    EXPECT_EQ(bench->session.notes[0].text, "now");
    driver->click(x + text.w, y);
    driver->frames(2);
    EXPECT_NE(bench->session.selected_cell, none);
}

TEST_P(WindowFrames, NothingFails) {
    for (const Command<2>& command : command_table<2>()) {
        if (leaves_the_program(command.id)) continue;
        act(std::string(command.id) + " " + argument(command.id));
        check(false);
    }
    for (const char* field : {"palette", "heat", "label"})
        for (const std::string_view word : setting_row(field).words) {
            act("set " + std::string(field) + "=" + std::string(word));
            check(false);
        }
    bench->desk = {};
    while (driver->drawn() < wanted_frames && !HasFailure()) {
        const bool typing = bench->desk.console;
        anything();
        check(typing || bench->desk.console || last == "typing");
        ASSERT_FALSE(HasFailure()) << "after: " << last;
    }
    // The same views and settings give the same run to somebody who comes by another way.
    Session<2> fresh(bench->session.shared_scene(), bench->session.culling_view(), bench->session.settings());
    fresh.seek(bench->session.position());
    EXPECT_EQ(fresh.hash(), bench->session.hash());
    // Undo to the beginning and redo to the end: the same again.
    driver->window().ui().act("freeze; unfreeze; seek 5");
    const std::uint64_t hash = bench->session.hash();
    int undone = 0, redone = 0;
    while (undo(*bench)) ++undone;
    driver->frames(1);
    while (redo(*bench)) ++redone;
    EXPECT_EQ(undone, redone);
    go_to_step(*bench, 5);
    driver->frames(1);
    EXPECT_EQ(bench->session.hash(), hash);
    check(false);
}

std::vector<std::string> scenes() {
    std::vector<std::string> ids;
    for (const CatalogueRow<2>& row : catalogue()) ids.emplace_back(row.id);
    return ids;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WindowFrames, ::testing::ValuesIn(scenes()), [](const auto& i) { return i.param; });

}  // namespace
}  // namespace sightline
