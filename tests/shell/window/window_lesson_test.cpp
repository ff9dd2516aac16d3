// A lesson given on a projector, with the keys of a clicker: what it speaks of stands on the screen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/lesson/lesson.h"
#include "shell/panels/panel.h"
#include "tests/shell/window/window_session_support.h"

namespace sightline {
namespace {

using namespace test;

/// The words for the class: what they say, and where.
std::vector<std::pair<std::string, Rect>> words_of(const Dump& dump) {
    std::vector<std::pair<std::string, Rect>> words;
    for (const auto& [name, rect] : dump.screen)
        if (name.starts_with("lesson: ") || name.starts_with("banner: ")) words.emplace_back(name, rect);
    return words;
}

bool overlap(const Rect& a, const Rect& b) {
    return a.x + a.w > b.x + 0.5 && b.x + b.w > a.x + 0.5 && a.y + a.h > b.y + 0.5 && b.y + b.h > a.y + 0.5;
}

void expect_readable(const Dump& dump, double width, double height, const std::string& where) {
    const auto words = words_of(dump);
    const auto picture = dump.screen.find("picture");
    ASSERT_NE(picture, dump.screen.end()) << where;
    EXPECT_GT(picture->second.w * picture->second.h, 0.4 * width * height) << where << ": the picture is small";
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto& [text, at] = words[i];
        EXPECT_TRUE(at.x >= 0 && at.y >= 0 && at.x + at.w <= width + 0.5 && at.y + at.h <= height + 0.5)
            << where << ": outside the window: " << text << " (" << at.x << ", " << at.y << ", " << at.w << ", " << at.h
            << ")";
        EXPECT_FALSE(overlap(at, picture->second)) << where << ": over the picture: " << text;
        EXPECT_GE(at.h, 0.03 * height) << where << ": too small: " << text;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(overlap(at, words[j].second)) << where << ": " << text << "\nand " << words[j].first;
    }
}

class LessonOnProjector : public WindowSession {
protected:
    void give(const std::string& id, const std::string& size) {
        const int width = std::stoi(size), height = std::stoi(size.substr(size.find('x') + 1));
        show_display(size);
        if (IsSkipped() || HasFatalFailure()) return;
        start({"--window", size});
        if (HasFatalFailure()) return;
        std::optional<Lesson> lesson;
        for (const Lesson& each : read_lessons(lessons_of_the_project()))
            if (each.id == id) lesson = each;
        ASSERT_TRUE(lesson);
        hands->key("F2");
        const std::string first = "lesson " + id + " 1";
        ASSERT_TRUE(becomes([&](const Dump& d) { return d.screen.contains(first); }));
        const Rect at = now.screen.at(first);
        if (at.y + at.h <= height) {
            hands->click(at.x + 20, at.y + at.h / 2);
        } else {  // further down than the list reaches
            for (int i = 0; i < 100 && !now.screen.contains("lit " + first); ++i) {
                const auto lit = [](const Dump& d) {
                    std::string found;
                    for (const auto& [name, rect] : d.screen)
                        if (name.starts_with("lit lesson ")) found = name;
                    return found;
                };
                const std::string before = lit(now);
                hands->key("Down");
                ASSERT_TRUE(becomes([&](const Dump& d) { return lit(d) != before; }));
            }
            hands->key("Return");
        }
        hands->move(3, 3);
        hands->key("p");
        for (std::size_t p = 0; p < lesson->parts.size(); ++p) {
            const LessonPart& part = lesson->parts[p];
            const std::string title =
                "lesson: " + std::to_string(p + 1) + " of " + std::to_string(lesson->parts.size()) + ": " + part.title;
            ASSERT_TRUE(becomes([&](const Dump& d) { return d.screen.contains(title); })) << title;
            expect_readable(now, width, height, title);
            for (const Beat& beat : part.beats) {
                hands->key("Next");
                const std::string said = "lesson: " + beat.say;
                ASSERT_TRUE(becomes([&](const Dump& d) {
                    return d.screen.contains(title) && (beat.say.empty() || d.screen.contains(said));
                })) << title
                    << "\n"
                    << said;
                const Panel<2>* const panel = find_panel<2>(part.panel);
                for (const std::string& words : beat.shows)
                    EXPECT_TRUE(becomes([&](const Dump& d) {  // a panel may measure first
                        const auto on_screen = words_of(d);
                        return (panel && d.has(std::string(panel->title), words)) ||
                               std::any_of(on_screen.begin(), on_screen.end(), [&](const auto& each) {
                                   return each.first.find(words) != std::string::npos;
                               });
                    })) << title
                        << ": nobody can read '" << words << "'";
                expect_readable(now, width, height, title + ", " + beat.ask + beat.act);
            }
            hands->key("Next");
        }
        hands->key("p");
        leave();
    }
};

TEST_F(LessonOnProjector, PlpSaysItsNumbersOnTheScreen) { give("plp", "1280x720"); }
TEST_F(LessonOnProjector, OrdersSayTheirNumbersOnTheScreen) { give("orders", "1280x720"); }
TEST_F(LessonOnProjector, PyramidsSayTheirNumbersOnTheScreen) { give("pyramids", "1280x720"); }
TEST_F(LessonOnProjector, LightSaysItsNumbersOnTheScreen) { give("light", "1280x720"); }
TEST_F(LessonOnProjector, EnginesSayTheirNumbersOnTheScreen) { give("conservative", "1920x1080"); }

TEST_F(WindowSession, ArrowsAndEnterChooseALesson) {
    SHOW_DISPLAY();
    start({"bottleneck"});
    if (HasFatalFailure()) return;
    hands->key("F2");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("lit lesson plp 1"); }));
    for (const char* const key : {"Up", "Down", "Down"}) hands->key(key);
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("lit lesson plp 3"); }));
    EXPECT_EQ(now.step(), 0u) << "they do nothing else";
    hands->key("Return");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("lesson: 3 of 11: Inside one step"); }));
    hands->key("F2");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("lit lesson plp 3"); })) << "where it stands";
    hands->key("Escape");
    leave();
}

TEST_F(WindowSession, AClickerCanBlankTheScreenAndTheSpeakerHasAWindow) {
    SHOW_DISPLAY();
    start({"bottleneck"});
    if (HasFatalFailure()) return;
    command("lesson plp 2");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("lesson: 2 of 11: Cells, front, solidity"); }));
    hands->key("F3");
    ASSERT_TRUE(hands->has_window("for the speaker")) << said();
    hands->key("p");
    hands->key("b");
    ASSERT_TRUE(becomes([](const Dump& d) { return !d.screen.contains("picture"); })) << "B blanks the screen";
    hands->key("b");
    hands->key("F5");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("picture"); }));
    EXPECT_EQ(now.step(), 0u) << "F5 starts no show";
    hands->key("Next");
    ASSERT_TRUE(is_at(1));
    hands->key("F3");
    ASSERT_TRUE(hands->lost_window("for the speaker"));
    hands->key("p");
    leave();
}

TEST_F(WindowSession, TheCommandLineCompletesAndRecalls) {
    SHOW_DISPLAY();
    start({"bottleneck"});
    if (HasFatalFailure()) return;
    hands->type(":meth");
    hands->key("Tab");
    hands->type("lay");
    hands->key("Tab");
    hands->key("Return");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Run", "(layers)"); }));
    command("method centroid");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Run", "(centroid)"); }));
    hands->type(":");
    hands->key("Up");
    hands->key("Up");
    hands->key("Return");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Run", "(layers)"); }));
    leave();
}

}  // namespace
}  // namespace sightline
