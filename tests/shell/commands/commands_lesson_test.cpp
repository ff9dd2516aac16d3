// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/session/headline.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, lesson) {
    run("lesson");
    EXPECT_TRUE(bench->desk.lessons);
    ASSERT_FALSE(said.empty());
    EXPECT_EQ(said[0].find("plp: "), 0u) << said[0];
    run("lesson plp 3");
    EXPECT_FALSE(bench->desk.lessons);
    EXPECT_EQ(bench->teaching->part, 2u);
    EXPECT_EQ(bench->desk.projector_panel, "code");
    EXPECT_TRUE(bench->desk.left == "code" || bench->desk.right == "code");
    run("previous; lesson plp 3");
    EXPECT_TRUE(bench->desk.left == "code" || bench->desk.right == "code") << "not shown and hidden in turn";
    EXPECT_THROW(run("lesson plp 0"), InputError);
    EXPECT_THROW(run("lesson pl"), InputError);
    EXPECT_EQ(bench->teaching->part, 2u);
    run("lesson \"" + std::string(SIGHTLINE_SOURCE_DIR) + "/examples/lessons.json\" conservative 2");
    EXPECT_EQ(session().method().id, "boxes");
    run("truth hide; lesson end");
    EXPECT_FALSE(bench->teaching);
    EXPECT_TRUE(tells_truth(session()));
    EXPECT_EQ(bench->desk.projector_panel, "");
}

TEST_F(EachCommand, next) {
    run("next");
    EXPECT_EQ(session().position(), 11u) << "without a lesson, a step";
    run("lesson plp 2; next; next");
    EXPECT_EQ(session().position(), 2u);
    EXPECT_EQ(bench->teaching->presses, 2u);
}

/// At step 10 of a run, as EachCommand.
class LessonCommands : public test::Commands {};

TEST_F(LessonCommands, NextSaysNoStepThatIsLeft) {
    int beats = 0;
    for (const Lesson& lesson : read_lessons(lessons_of_the_project())) {
        if (lesson.dimension != 2) continue;
        const auto check = [&](const std::string& command) {
            run(command);
            ++beats;
            for (const std::string& line : said)
                if (line.starts_with("step ")) {
                    EXPECT_TRUE(line.starts_with("step " + std::to_string(session().position()) + " of "))
                        << lesson.id << " at step " << session().position() << ": " << line;
                }
        };
        check("lesson " + lesson.id);
        for (const LessonPart& part : lesson.parts)
            for (std::size_t i = 0; i < part.beats.size() + 1; ++i) check("next");
    }
    EXPECT_GT(beats, 60);
    run("lesson end");
}

TEST_F(EachCommand, previous) {
    run("previous");
    EXPECT_EQ(session().position(), 9u);
    run("lesson plp 2; next; next; previous");
    EXPECT_EQ(session().position(), 1u);
    run("previous; previous");
    EXPECT_EQ(bench->teaching->part, 0u) << "back into the part before, at its end";
    EXPECT_EQ(bench->teaching->presses, 2u);
}

TEST_F(EachCommand, answer) {
    EXPECT_THROW(run("answer 1"), InputError) << "no lesson is given";
    run("lesson plp 4");
    test::expect_input_error([&] { run("answer much"); },
                             "command 'answer much': 'much' is not a number, as the key of a cell is");
    run("answer 0.549");
    EXPECT_TRUE(said.back().starts_with("You said 0.549, right: ")) << said.back();
    EXPECT_EQ(bench->teaching->presses, 1u);
    EXPECT_EQ(bench->teaching->score.right, 1u);
}

TEST_F(EachCommand, speaker) { flips("speaker", bench->desk.speaker); }

TEST_F(EachCommand, truth) {
    const std::string told = headline(session());
    EXPECT_NE(told.find("22 of 337 segments visible"), std::string::npos) << told;
    EXPECT_NE(result_line(session()).find("of 22 visible found"), std::string::npos);
    run("truth");
    EXPECT_EQ(session().settings().show_visibility, Switch::off);
    EXPECT_EQ(headline(session()).find("visible"), std::string::npos);
    EXPECT_EQ(result_line(session()), std::to_string(session().counters().rendered_count) + " drawn");
    run("truth tell");
    EXPECT_EQ(headline(session()), told);
}

}  // namespace
}  // namespace sightline
