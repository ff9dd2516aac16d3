// Hundreds of frames of the real 3D window off screen: flying, circling, freezing, slicing, every command and key,
// resizing down to nothing, in an order that a seed decides. Nothing may fail, and the driver may not complain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/number.h"
#include "shell/commands/command_table.h"
#include "shell/desk/open_scene.h"
#include "shell/panels/panel.h"
#include "tests/scene/random_scene.h"
#include "tests/session/session_3d_support.h"
#include "tests/shell/window/window_driver.h"
#include "viewer3d/stage3d.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;
using namespace test;

constexpr int width = 800, height = 560;

class Window3OffScreen : public ::testing::Test {
protected:
    Window3OffScreen() {
        fs::create_directories(folder);
        fs::current_path(folder);  // some keys write files here
    }
    ~Window3OffScreen() override {
        driver.reset();
        bench.reset();
        fs::current_path(before);
        fs::remove_all(folder);
    }
    void SetUp() override {
        const auto renderers = std::make_shared<Renderers>();
        const Graphics graphics = graphics_of(renderers);
        Settings settings = start_settings<3>("bottleneck");
        settings.reference_size = {160, 120};
        try {
            bench.reset(new Workbench<3>{open_scene<3>(
                "bottleneck", settings, method_table<3>(), [](const std::string&) {}, graphics)});
            bench->graphics = graphics;
            driver = std::make_unique<WindowDriver<3>>(*bench, width, height,
                                                       [&](Workbench<3>& on) { return stage3d(on, renderers); });
        } catch (const WorkError& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
    }

    std::uint32_t random_cell() {
        return static_cast<std::uint32_t>(random.below(bench->session.cells().cell_count()));
    }
    template <typename List>
    std::string one_of(const List& list) {
        return std::string(list[random.below(std::size(list))]);
    }
    std::string numbers(int count, double most) {
        std::string text;
        for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + number_text(random.uniform(-most, most));
        return text;
    }
    std::string setting();
    std::string argument(std::string_view id);

    void act(const std::string& commands) {
        last = commands;
        driver->window().ui().act(commands);
        driver->frames(1 + static_cast<int>(random.below(2)));
    }
    void press_a_key();
    void click_something();
    void use_the_picture();
    void arrange();
    void fly();
    void anything();
    void check();

    Random random{409};
    std::string last;  ///< what was done, for the reader of a failure
    fs::path before = fs::current_path();
    fs::path folder = fs::temp_directory_path() / ("sightline-frames3-" + std::to_string(getpid()));
    std::unique_ptr<Workbench<3>> bench;
    std::unique_ptr<WindowDriver<3>> driver;
};

/// A valid FIELD=VALUE.
std::string Window3OffScreen::setting() {
    for (;;) {
        const SettingRow& row = settings_table()[random.below(settings_table().size())];
        if (row.dimension == 2) continue;
        Settings other = random_settings(random);
        randomise_picture(other, random);
        std::string value = row.words.empty() ? row.get(other) : one_of(row.words);
        if (row.name == "error_bound") value = number_text(random.uniform(0.1, 0.4));
        if (row.name == "jitter") value = "0.02";  // else cells without a volume
        if (row.name == "reference_size") value = one_of(std::array{"64x48", "1x1", "4x200", "300x2"});
        if (row.name == "two_sided" || row.name == "up") continue;  // decides how files are read
        return std::string(row.name) + "=" + value;
    }
}

/// Something that the command takes; nothing for commands that this test does not know, which then may refuse.
std::string Window3OffScreen::argument(std::string_view id) {
    if (id == "step" || id == "back") return std::to_string(random.below(12));
    if (id == "seek") return std::to_string(random.below(bench->session.recorded() + 2));
    if (id == "until" || id == "break" || id == "mark")
        return one_of(std::array{"rho > 0.5", "step:20", "coverage > 0.4"});
    if (id == "break-switch") return "1";
    if (id == "reach") return std::to_string(random_cell());
    if (id == "select") return random.below(2) ? std::to_string(random_cell()) : "primitive:1";
    if (id == "speed") return one_of(std::array{"half", "double", "30"});
    if (id == "eye" || id == "look") return numbers(3, 20);
    if (id == "fov") return number_text(random.uniform(5, 170));
    if (id == "zoom") return number_text(random.uniform(0.2, 4));
    if (id == "pan") return numbers(2, 1);
    if (id == "orbit" || id == "turn") return numbers(2, 200);
    if (id == "walk") return numbers(3, 5);
    if (id == "freeze") return one_of(std::array{"all", "eye", "direction"});
    if (id == "fly-speed") return one_of(std::array{"3", "x2", "x0.5"});
    if (id == "path") return one_of(std::array{"test", "record", "stop", "play", "save p.json", "frame 2"});
    if (id == "set") return setting();
    if (id == "cycle")
        return one_of(std::array{"heat", "label", "penalty", "palette", "projected_as", "inset", "slice"});
    if (id == "preset") return std::string(presets()[random.below(presets().size())].id);
    if (id == "method") return one_of(std::array{"published", "layers", "centroid", "view", "everything"});
    if (id == "budget") return one_of(std::array{"5%", "40", "unlimited"});
    if (id == "bookmark") return "here";
    if (id == "note")
        return "text " + (random.below(2) ? numbers(3, 10) : "cell:" + std::to_string(random_cell())) + " x";
    if (id == "note-edit") return "1 other words";
    if (id == "explain") return random.below(2) ? "" : "cell " + std::to_string(random_cell());
    if (id == "panels" || id == "trace" || id == "stats" || id == "save") return "written.txt";
    if (id == "open") return "bottleneck";
    if (id == "compare") return one_of(std::array{"layers", "centroid", "off"});
    if (id == "size") return "120x90";
    if (id == "shot") return one_of(std::array{"shot.pdf", "shot.svg", "shot.png"});
    if (id == "show") return std::string(panel_table<3>()[random.below(panel_table<3>().size())].id);
    if (id == "tool") return one_of(std::array{"select", "text", "ring"});
    if (id == "axis") return one_of(timeline_axis_words);
    if (id == "trade-off") return one_of(std::array{"go", "stop", "restart", "coverage", "centroid 10%"});
    if (id == "scale") return one_of(std::array{"up", "down", "1"});
    return "";
}

bool leaves_the_program(std::string_view id) { return id == "quit" || id == "film" || id == "viewer2d"; }

void Window3OffScreen::press_a_key() {
    static const std::array keys{SDLK_RIGHT, SDLK_LEFT, SDLK_UP,     SDLK_DOWN,   SDLK_HOME, SDLK_END, SDLK_SPACE,
                                 SDLK_TAB,   SDLK_F1,   SDLK_ESCAPE, SDLK_ESCAPE, SDLK_F12,  SDLK_F11, SDLK_DELETE};
    static const std::array modifiers{KMOD_NONE, KMOD_NONE, KMOD_NONE, KMOD_LSHIFT, KMOD_LCTRL};
    const int code = random.below(2) ? SDLK_a + static_cast<int>(random.below(26)) : keys[random.below(keys.size())];
    const int with = modifiers[random.below(modifiers.size())];
    last = "key " + std::to_string(code) + " with " + std::to_string(with);
    driver->key(code, with);
    if (random.below(4) == 0) driver->type(one_of(std::array{"[", "]", "{", "}", "+", "-"}));
    driver->frames(2);
    bench->quit = false;  // Ctrl+Q
}

void Window3OffScreen::click_something() {
    if (bench->places.empty()) return;
    const Place place = bench->places[random.below(bench->places.size())];
    if (place.name.starts_with("menu ")) return;
    last = "click " + place.name;
    driver->click(place.x + place.w / 2, place.y + place.h / 2);
    bench->quit = false;
}

void Window3OffScreen::use_the_picture() {
    const Place* const picture = driver->place("picture");
    if (!picture) return;
    const Place area = *picture;
    const auto x = [&] { return area.x + random.uniform(0.02, 0.98) * area.w; };
    const auto y = [&] { return area.y + random.uniform(0.02, 0.98) * area.h; };
    const Uint8 button = std::array<Uint8, 3>{SDL_BUTTON_LEFT, SDL_BUTTON_RIGHT, SDL_BUTTON_MIDDLE}[random.below(3)];
    switch (random.below(4)) {
        case 0:
            last = "click on the picture";
            driver->click(x(), y());
            break;
        case 1:
            last = "wheel";
            driver->move(x(), y());
            driver->wheel(random.below(2) ? 1 : -1);
            driver->frames(2);
            break;
        case 2:
            last = "drag";
            if (const Place* const eye = driver->place("frozen eye"); eye && random.below(2)) {
                const Place held = *eye;
                driver->drag(held.x, held.y, x(), y());
                driver->drop();
                break;
            }
            driver->drag(x(), y(), x(), y(), 3, button);
            driver->drop(button);
            break;
        default:
            last = "cancel a drag";
            driver->drag(x(), y(), x(), y());
            driver->key(SDLK_ESCAPE);
            driver->frames(1);
            driver->drop();
    }
}

void Window3OffScreen::arrange() {
    last = "arrange";
    if (random.below(3) == 0) {
        bench->desk = {};
        driver->resize(width, height);
    } else {
        driver->resize(1 + static_cast<int>(random.below(1000)), 1 + static_cast<int>(random.below(600)));
    }
    driver->frames(2);
}

void Window3OffScreen::fly() {
    last = "flying";
    act("fly on; path test; path play");
    driver->frames(4);
    if (random.below(2)) act("path stop");
    if (random.below(2)) act("freeze");
    if (random.below(2)) act("fly off");
}

void Window3OffScreen::anything() {
    const std::uint64_t kind = random.below(20);
    if (kind < 4) return press_a_key();
    if (kind < 6) return click_something();
    if (kind < 11) return use_the_picture();
    if (kind < 12) return arrange();
    if (kind < 13) return fly();
    if (kind < 16) return act(quote_command("set " + setting()));
    const auto table = command_table<3>();
    const Command<3>& command = table[random.below(table.size())];
    if (!leaves_the_program(command.id)) act(std::string(command.id) + " " + argument(command.id));
}

/// What holds after anything that a person does.
void Window3OffScreen::check() {
    const Session<3>& s = bench->session;
    EXPECT_LE(s.position(), s.recorded());
    EXPECT_EQ(s.position(), s.flying() ? 0 : s.traversal().steps());
    EXPECT_TRUE(s.selected_cell == none || s.selected_cell < s.cells().cell_count());
    EXPECT_TRUE(s.selected_primitive == none || s.selected_primitive < s.scene().primitives.size());
    EXPECT_NO_THROW(s.check(s.culling_view()));
    EXPECT_NO_THROW(s.check(s.display_view()));
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
        EXPECT_EQ(message.text.find("does not exist;"), std::string::npos) << message.text;
    }
    driver->window().ui().messages.clear();
}

TEST_F(Window3OffScreen, NothingFails) {
    for (const Command<3>& command : command_table<3>()) {
        if (leaves_the_program(command.id)) continue;
        act(std::string(command.id) + " " + argument(command.id));
        check();
        ASSERT_FALSE(HasFailure()) << "after: " << last;
    }
    bench->desk = {};
    while (driver->drawn() < 300) {
        anything();
        bench->desk.console = false;
        check();
        ASSERT_FALSE(HasFailure()) << "after: " << last;
    }
    // The same views and settings give the same run to somebody who comes by another way.
    bench->session.land();
    Session<3> fresh(bench->session.shared_scene(), bench->session.culling_view(), bench->session.settings(),
                     method_table<3>(), bench->graphics.draw_ids);
    fresh.seek(bench->session.position());
    EXPECT_EQ(fresh.hash(), bench->session.hash());
}

TEST_F(Window3OffScreen, ReferencesOfAlmostNoWidthAreNoFailure) {
    act("run; set inset=both; set split=exact");
    for (const char* const size : {"1x8192", "8192x1", "1x1"}) {
        act(std::string("set reference_size=") + size);
        driver->frames(2);
        check();
        act("set inset=exact; set split=missed; step; set inset=both; set split=exact");
        check();
    }
}

TEST_F(Window3OffScreen, WindowsOfAlmostNoSizeAreNoFailure) {
    act("run; freeze; orbit 40,30; zoom 0.4; set inset=both; compare layers");
    for (const auto& [w, h] : {std::pair(1, 1), std::pair(1, 600), std::pair(900, 1), std::pair(9, 9),
                               std::pair(60, 40), std::pair(width, height)}) {
        SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
        SDL_SetWindowMinimumSize(driver->window().context().window(), 1, 1);
        driver->resize(w, h);
        driver->frames(2);
        driver->click(w / 2, h / 2);
        driver->drag(w / 2, h / 2, w, h);
        driver->drop();
        driver->wheel(1);
        act("orbit 5,5; step; back");
        check();
    }
    EXPECT_NE(driver->place("picture"), nullptr);

    SDL_Window* const window = driver->window().context().window();
    SDL_MinimizeWindow(window);
    driver->frames(2);
    act("orbit 5,5; step");
    check();
    SDL_RestoreWindow(window);
    driver->frames(2);
    EXPECT_NE(driver->place("picture"), nullptr);
    check();
}

}  // namespace
}  // namespace sightline
