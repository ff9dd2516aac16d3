// A viewer on a display of its own, and a person before it who reads the accessible text that F12 writes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "core/base/file.h"
#include "tests/shell/window/xvfb.h"

namespace sightline::test {

namespace fs = std::filesystem;

struct Rect {
    double x = 0, y = 0, w = 0, h = 0;
};

/// The text of all panels, taken apart.
struct Dump {
    std::map<std::string, std::string> panels;  ///< by title
    std::map<std::string, Rect> screen;

    bool has(const std::string& panel, const std::string& words) const {
        const auto found = panels.find(panel);
        return found != panels.end() && found->second.find(words) != std::string::npos;
    }
    /// The rest of the first line of a panel that begins with these words, after them.
    std::string after(const std::string& panel, const std::string& words) const {
        const auto found = panels.find(panel);
        if (found == panels.end()) return "";
        std::istringstream lines(found->second);
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with(words)) return line.substr(words.size());
        return "";
    }
    std::uint32_t step() const { return static_cast<std::uint32_t>(std::stoul("0" + after("Run", "step "))); }
    std::string hash() const { return after("Run", "state "); }
};

inline Dump parse(const std::string& text) {
    Dump dump;
    std::istringstream lines(text);
    std::string title;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("== ") && line.ends_with(" ==")) {
            title = line.substr(3, line.size() - 6);
        } else if (title == "Screen") {
            const std::size_t colon = line.rfind(": ");
            if (colon == std::string::npos) continue;
            Rect r;
            std::istringstream(line.substr(colon + 2)) >> r.x >> r.y >> r.w >> r.h;
            dump.screen[line.substr(0, colon)] = r;
        } else {
            dump.panels[title] += line + "\n";
        }
    }
    return dump;
}

class WindowSession : public ::testing::Test {
protected:
    WindowSession() { fs::create_directories(folder / "home"); }
    ~WindowSession() override {
        program.reset();
        fs::remove_all(folder);
    }

    /// A display; false and skipped where there can be none.
    void show_display(const std::string& size = "1280x800", int dpi = 96) {
        for (const char* needed : {"Xvfb", "xdotool"})
            if (!installed(needed)) GTEST_SKIP() << needed << " is not installed: nobody can press keys";
        xvfb = std::make_unique<Xvfb>(size, dpi);
        ASSERT_NE(xvfb->display(), "") << "Xvfb did not start";
        hands = std::make_unique<Hands>(xvfb->display(), folder);
    }
    void start(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), viewer);
        program.reset();
        program = std::make_unique<Process>(
            arguments,
            Process::Setup{{"DISPLAY=" + xvfb->display(), "WAYLAND_DISPLAY", "SDL_VIDEODRIVER=x11",
                            "HOME=" + (folder / "home").string(), "XDG_CONFIG_HOME=" + (folder / "config").string()},
                           folder,
                           folder / "program.txt",
                           -1});
        ASSERT_TRUE(hands->take_window("Sightline")) << said();
        // The first keys may come before the window has the keyboard.
        ASSERT_TRUE(await([&] {
            hands->key("F12");
            return await([&] { return fs::exists(folder / "panels.txt"); }, 0.5);
        })) << said();
        hands->move(3, 3);  // away from everything
        now = dump();
    }
    /// What it printed, for the reader of a failure.
    std::string said() { return fs::exists(folder / "program.txt") ? read_file(folder / "program.txt") : ""; }

    static std::string text_of(const Dump& dump) {
        std::string all;
        for (const auto& [title, text] : dump.panels) all += "== " + title + " ==\n" + text;
        return all;
    }
    Dump dump() {
        const fs::path file = folder / "panels.txt";
        // One that was asked for earlier may still come: only a second one is surely of now.
        for (int i = 0; i < 2; ++i) {
            fs::remove(file);
            hands->key("F12");
            EXPECT_TRUE(await([&] { return fs::exists(file); })) << "F12 writes nothing; before:\n"
                                                                 << text_of(now) << said();
        }
        return parse(fs::exists(file) ? read_file(file) : "");
    }
    /// Reads the panels until this holds.
    ::testing::AssertionResult becomes(const std::function<bool(const Dump&)>& holds) {
        const bool good = await([&] { return !program->running() || holds(now = dump()); });
        if (good && program->running()) return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure() << "never; at the end:\n" << text_of(now) << said();
    }
    ::testing::AssertionResult is_at(std::uint32_t step) {
        return becomes([&](const Dump& d) { return d.step() == step; });
    }
    /// Through the console, as a person types.
    void command(const std::string& text) {
        hands->type(":" + text);
        hands->key("Return");
    }
    void leave() {
        hands->key("ctrl+q");
        ASSERT_TRUE(await([&] { return !program->running(); })) << "Ctrl+Q does not end it";
        EXPECT_EQ(program->wait(), 0) << said();
    }

    std::string viewer = SIGHTLINE_VIEWER2D;
    fs::path folder = fs::temp_directory_path() / ("sightline-window-" + std::to_string(getpid()));
    std::unique_ptr<Xvfb> xvfb;
    std::unique_ptr<Hands> hands;
    std::unique_ptr<Process> program;
    Dump now;
};

}  // namespace sightline::test

#define SHOW_DISPLAY(...)      \
    show_display(__VA_ARGS__); \
    if (IsSkipped() || HasFatalFailure()) return
