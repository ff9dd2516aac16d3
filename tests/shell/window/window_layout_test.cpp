// No text of the window is cut or lies over another: all panels, bars and lesson parts, at the sizes of a laptop, a
// projector and a large screen, and at four sizes of the interface.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/scene/make/catalogue.h"
#include "shell/desk/open_scene.h"
#include "shell/panels/panel.h"
#include "tests/shell/desk/bench_support.h"
#include "tests/shell/window/text_audit.h"
#include "tests/shell/window/window_driver.h"
#include "viewer2d/stage2d.h"

namespace sightline {
namespace {

using namespace test;

struct Screen {
    int width, height;
};
constexpr Screen laptop{1280, 720}, projector{1920, 1080}, large{2560, 1440};

class WindowLayout : public ::testing::TestWithParam<Screen> {
protected:
    void SetUp() override {
        kept = std::make_unique<Bench>(
            open_scene("bottleneck", start_settings("bottleneck"), method_table<2>(), [](const auto&) {}));
        kept->bench.lessons = read_lessons(lessons_of_the_project());
        try {
            driver = std::make_unique<WindowDriver<2>>(kept->bench, GetParam().width, GetParam().height, stage2d);
        } catch (const WorkError& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
        driver->resize(GetParam().width, GetParam().height);  // also beyond the screen
        driver->frames(2);
        ASSERT_EQ(ImGui::GetIO().DisplaySize.x, GetParam().width);
    }
    void act(const std::string& commands) {
        driver->window().ui().act(commands);
        driver->frames(2);
    }
    void expect_readable(const std::string& where) {
        for (const std::string& fault : unreadable_texts()) ADD_FAILURE() << where << ": " << fault;
    }
    std::string at_scale(double scale) {
        act("scale " + std::to_string(scale));
        return std::to_string(GetParam().width) + "x" + std::to_string(GetParam().height) + ", scale " +
               std::to_string(scale).substr(0, 3);
    }

    std::unique_ptr<Bench> kept;
    std::unique_ptr<WindowDriver<2>> driver;
};

constexpr std::array scales{1.0, 1.4, 1.8, 2.2};

TEST_P(WindowLayout, EveryPanelCanBeRead) {
    act("step 7");
    for (const double scale : scales) {
        const std::string where = at_scale(scale);
        for (const Panel<2>& panel : panel_table<2>()) {
            const bool left = panel.column == Column::left;
            std::string& shown = left ? kept->bench.desk.left : kept->bench.desk.right;
            shown = panel.id;
            ++driver->window().ui().revision;
            driver->frames(2);
            expect_readable(where + ", panel " + std::string(panel.id));
            if (left) shown.clear();
        }
    }
}

TEST_P(WindowLayout, EveryPartOfALessonCanBeReadOnAProjector) {
    act("projector");
    for (const Lesson& lesson : kept->bench.lessons) {
        if (lesson.dimension != 2) continue;
        for (std::size_t p = 0; p < lesson.parts.size(); ++p) {
            act("lesson " + lesson.id + " " + std::to_string(p + 1));
            const std::string where = lesson.id + ", part " + std::to_string(p + 1);
            expect_readable(where);
            for (std::size_t b = 0; b < lesson.parts[p].beats.size(); ++b) {
                act("next");
                expect_readable(where + ", beat " + std::to_string(b + 1));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, WindowLayout, ::testing::Values(laptop, projector, large), [](const auto& info) {
    return std::to_string(info.param.width) + "x" + std::to_string(info.param.height);
});

}  // namespace
}  // namespace sightline
