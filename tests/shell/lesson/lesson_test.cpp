// Lessons: what is no index is refused with its place, and those of the project say what is true.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/lesson/lesson.h"

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/draw/picture.h"
#include "core/session/headline.h"
#include "shell/commands/teach.h"
#include "shell/desk/auto_choice.h"
#include "shell/desk/conceal.h"
#include "shell/desk/faults.h"
#include "shell/pane/cell_words.h"
#include "shell/pane/side_by_side.h"
#include "shell/panels/panel.h"
#include "shell/window/parts.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::Commands;

class Lessons : public Commands {
protected:
    std::vector<Lesson> read(const std::string& text) {
        write_file(folder / "lessons.json", text);
        return read_lessons(folder / "lessons.json");
    }
    /// All that a class may read now, but for the words of the lesson itself.
    std::string on_the_screen() const {
        std::string text = headline(bench->session) + "\n";
        for (const Row& row : banner_lines(*bench)) text += row.text + "\n";
        if (bench->teaching) text += bench->teaching->guessed + "\n";
        return text + panels_text(*bench);
    }
};

TEST_F(Lessons, WhatIsNoIndexIsRefusedWithItsPlace) {
    const std::string part = R"({"title": "t", "open": "rooms"})";
    const auto index = [&](const std::string& lessons) {
        return R"({"format": "sightline-lessons", "lessons": [)" + lessons + "]}";
    };
    const std::string good = R"({"id": "a", "title": "A", "parts": [)" + part + "]}";
    EXPECT_EQ(read(index(good)).at(0).parts.at(0).open, "rooms");
    const std::string file = (folder / "lessons.json").string();
    const auto refused = [&](const std::string& text, const std::string& reason) {
        test::expect_input_error([&] { read(text); }, file + ": " + reason);
    };
    const auto with_part = [&](const std::string& members) {
        return index(R"({"id": "a", "title": "A", "parts": [{"title": "t", )" + members + "}]}");
    };
    refused("{}", "'format' is not sightline-lessons");
    refused(index(R"({"id": "a", "title": "A"})"), "/lessons/0: a lesson without a part");
    refused(with_part(R"("minutes": 3)"), "/lessons/0/parts/0: 'open' is missing");
    refused(with_part(R"("open": "x", "beets": [])"), "/lessons/0/parts/0: unknown member 'beets'");
    refused(with_part(R"("open": "x", "beats": [{"do": 3}])"),
            "/lessons/0/parts/0/beats/0/do: expected a string, found a number");
    refused(with_part(R"("open": "x", "beats": [{"times": 0}])"),
            "/lessons/0/parts/0/beats/0/times: expected a whole number from 1 to 1000");
    const std::string nowhere = (folder / "nowhere.json").string();
    test::expect_input_error([&] { read_lessons(nowhere); }, nowhere + ": no such file");
}

TEST_F(Lessons, ARowOfBeatsIsWrittenOnce) {
    const auto lessons = read(R"({"format": "sightline-lessons", "lessons": [{"id": "a", "title": "A", "parts":
        [{"title": "t", "minutes": 4, "open": "rooms", "beats": [{"do": "step", "times": 7}, {"ask": "?"}]}]}]})");
    EXPECT_EQ(lessons.at(0).parts.at(0).beats.size(), 8u);
    EXPECT_EQ(lessons.at(0).minutes(), 4);
}

TEST_F(Lessons, OfTheProjectShowTheNumbersThatTheySpeakOf) {
    std::size_t shown = 0, asked = 0;
    for (const Lesson& lesson : read_lessons(lessons_of_the_project())) {
        if (lesson.dimension != 2) continue;
        begin_lesson(*bench, lesson);
        for (std::size_t part = 0; part < lesson.parts.size(); ++part) {
            ASSERT_EQ(bench->teaching->part, part) << "the last beat opens the next part";
            EXPECT_EQ(tells_truth(bench->session), !lesson.parts[part].concealed);
            if (lesson.parts[part].concealed) {
                const std::string all = on_the_screen();
                for (const char* const telling : {"visible found", "of them visible", "what is visible lies",
                                                  " visible, coverage", "Inversions in the"})
                    EXPECT_EQ(all.find(telling), std::string::npos) << telling << " in\n" << all;
            }
            for (const Beat& beat : lesson.parts[part].beats) {
                asked += !beat.ask.empty();
                EXPECT_EQ(bench->teaching->next()->ask, beat.ask);
                next_beat(*bench);
                update_faults(*bench);  // as the window does when nothing moves
                for (const std::string& words : beat.shows) {
                    ++shown;
                    EXPECT_NE(on_the_screen().find(words), std::string::npos)
                        << lesson.id << ", " << lesson.parts[part].title << ": '" << words << "' is not in\n"
                        << on_the_screen();
                }
            }
            EXPECT_TRUE(tells_truth(bench->session)) << lesson.parts[part].title << " never reveals the truth";
            next_beat(*bench);
        }
    }
    EXPECT_GT(shown, 20u);
    EXPECT_GT(asked, 10u);
}

TEST_F(Lessons, TheGuideListsThemAll) {
    const std::string guide = read_file(std::string(SIGHTLINE_SOURCE_DIR) + "/docs/teaching.md", 1 << 20);
    for (const Lesson& lesson : read_lessons(lessons_of_the_project())) {
        const std::string row = "| `" + lesson.id + "` | " + lesson.title + " | " + std::to_string(lesson.dimension) +
                                "D | " + std::to_string(lesson.parts.size()) + " | " +
                                std::to_string(lesson.minutes()) + " | ";
        EXPECT_NE(guide.find(row), std::string::npos) << row;
    }
}

TEST_F(Lessons, APartIsWhatItSetsWhateverIsRecommended) {
    const std::vector<Lesson> lessons = read_lessons(lessons_of_the_project());
    const auto light =
        std::find_if(lessons.begin(), lessons.end(), [](const Lesson& one) { return one.id == "light"; });
    ASSERT_NE(light, lessons.end());
    for (std::size_t part = 0; part < light->parts.size(); ++part) {
        begin_lesson(*bench, *light, part);
        const Settings as_it_is = session().settings();
        bench->auto_file = folder / "auto.json";
        keep_auto(bench->auto_file, auto_key(*bench), {"perfect", "kd", "7", 1, 0, 1, 0, "", "", "2001-02-03"});
        Settings automatic = as_it_is;
        automatic.automatic = Switch::on;
        session().change(automatic);
        said.clear();
        begin_lesson(*bench, *light, part);
        EXPECT_TRUE(session().settings() == as_it_is) << light->parts[part].title;
        EXPECT_EQ(said.back(), "auto is off: the lesson sets method, cells and budget");
        bench->other.reset();
    }
}

TEST_F(Lessons, GoingBackComesToTheSameStates) {
    const std::vector<Lesson> lessons = read_lessons(lessons_of_the_project());
    begin_lesson(*bench, lessons.at(0), 1);
    struct At {
        std::size_t part, presses;
        std::uint64_t hash;
        bool operator==(const At&) const = default;
    };
    std::vector<At> places;
    const auto here = [&] { return At{bench->teaching->part, bench->teaching->presses, bench->session.hash()}; };
    for (int press = 0; press < 20; ++press) {
        places.push_back(here());
        next_beat(*bench);
    }
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
        previous_beat(*bench);
        ASSERT_EQ(here(), *place) << "part " << place->part << ", press " << place->presses;
    }
}

TEST_F(Lessons, AnExerciseHidesItsKeyUntilItIsTold) {
    const auto labels = [&] {
        SideBySide<2> panes(*bench);
        panes.update(1);
        std::vector<std::string> texts;
        for (const Label& label : make_picture(session(), panes.options<PictureOptions>(0)).labels)
            texts.push_back(label.text);
        return texts;
    };
    const auto ends_a_label = [&](const std::string& number) {
        const auto texts = labels();
        return std::any_of(texts.begin(), texts.end(), [&](const std::string& t) { return t.ends_with(number); });
    };
    std::size_t exercises = 0;
    for (const Lesson& lesson : read_lessons(lessons_of_the_project())) {
        if (lesson.dimension != 2) continue;
        for (std::size_t part = 0; part < lesson.parts.size(); ++part) {
            begin_lesson(*bench, lesson, part);
            for (const Beat& beat : lesson.parts[part].beats) {
                if (beat.key_of) {
                    SCOPED_TRACE(beat.ask);
                    ++exercises;
                    const std::uint32_t cell = *beat.key_of;
                    ASSERT_EQ(concealed_cell(*bench), cell) << "it must wait in the front";
                    session().selected_cell = cell;
                    const std::string key = short_number(session().mark(cell).key);
                    const std::string told = cell_words(session(), cell);
                    const std::string name(key_title(session()));
                    EXPECT_NE(told.find(name + " = " + key), std::string::npos) << told;
                    EXPECT_NE(conceal(*bench, told).find(name + " = ?"), std::string::npos) << conceal(*bench, told);
                    const bool whole = key.find('.') == std::string::npos;
                    for (const std::string& before : {"= ", "key ", "→ ", "now "})
                        EXPECT_EQ(on_the_screen().find(whole ? before + key + "\n" : key), std::string::npos)
                            << key << " in\n"
                            << on_the_screen();
                    EXPECT_TRUE(ends_a_label("?"));
                    if (!whole) EXPECT_FALSE(ends_a_label(key));
                }
                next_beat(*bench);
                if (!beat.key_of) continue;
                EXPECT_FALSE(ends_a_label("?"));
                EXPECT_EQ(bench->teaching->guessed.find("The key of cell "), 0u) << bench->teaching->guessed;
                EXPECT_EQ(bench->teaching->score.made, 0u) << "nobody answered";
            }
        }
    }
    EXPECT_GE(exercises, 3u);
}

TEST_F(Lessons, AnAnswerIsHeldAgainstTheRecordOfTheRun) {
    const std::vector<Lesson> lessons = read_lessons(lessons_of_the_project());
    begin_lesson(*bench, lessons.at(0), 2);
    EXPECT_THROW(answer_exercise(*bench, 1), InputError) << "nothing is asked";
    while (!bench->teaching->next()->key_of) next_beat(*bench);
    run("answer 0.6");
    EXPECT_EQ(bench->teaching->guessed,
              "You said 0.6, but the key of cell 31 is 0.591: ρ = 0.217 + 1 · 0.374 = 0.591.");
    EXPECT_EQ(bench->teaching->score.right, 0u);
    previous_beat(*bench);
    run("answer 0.59");
    EXPECT_EQ(bench->teaching->guessed,
              "You said 0.59, right: the key of cell 31 is 0.591: ρ = 0.217 + 1 · 0.374 = 0.591.");
    EXPECT_EQ(bench->teaching->score.made, 2u);
    EXPECT_EQ(bench->teaching->score.right, 1u);
    begin_lesson(*bench, lessons.at(0), 3);
    run("answer 0.548");
    EXPECT_NE(bench->teaching->guessed.find("× 2"), std::string::npos) << bench->teaching->guessed;
}

TEST_F(Lessons, AGuessIsScoredByTheCellThatIsTaken) {
    const std::vector<Lesson> lessons = read_lessons(lessons_of_the_project());
    begin_lesson(*bench, lessons.at(0), 1);
    while (!bench->teaching->next()->guess) next_beat(*bench);
    bench->session.selected_cell = 13;
    next_beat(*bench);
    EXPECT_EQ(bench->teaching->guessed, "You took cell 13, the method cell 26: 0.274 against 0.301.");
    previous_beat(*bench);
    EXPECT_EQ(bench->teaching->score.made, 1u) << "going back takes no guess back";
    bench->session.selected_cell = 26;
    next_beat(*bench);
    EXPECT_EQ(bench->teaching->guessed, "You took cell 26 too.");
    EXPECT_EQ(bench->teaching->score.made, 2u);
    EXPECT_EQ(bench->teaching->score.right, 1u);
    previous_beat(*bench);
    next_beat(*bench);
    EXPECT_EQ(bench->teaching->score.made, 2u) << "nobody guessed";
}

TEST_F(Lessons, TheSpeakerReadsWhatComesNext) {
    EXPECT_EQ(speaker_rows(*bench).at(0).text, "no lesson");
    const std::vector<Lesson> lessons = read_lessons(lessons_of_the_project());
    begin_lesson(*bench, lessons.at(0));
    const auto reads = [&](const std::string& words) {
        const std::vector<Row> rows = speaker_rows(*bench);
        return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.text == words; });
    };
    EXPECT_TRUE(reads("1 of 11: What culling is for, until minute 5 of " + std::to_string(lessons[0].minutes())));
    EXPECT_TRUE(reads("Next press: " + lessons[0].parts[0].beats[0].say));
    next_beat(*bench);
    EXPECT_TRUE(reads("Asked: " + lessons[0].parts[0].beats[1].ask));
    next_beat(*bench);
    EXPECT_TRUE(reads("Next press: part 2, Cells, front, solidity"));
    begin_lesson(*bench, lessons.at(0), 10);
    next_beat(*bench);
    next_beat(*bench);
    EXPECT_TRUE(reads("This is the end."));
}

TEST_F(Lessons, OneOfTheOtherDimensionLeavesAllAsItWas) {
    const std::vector<Lesson> lessons = read_lessons(lessons_of_the_project());
    begin_lesson(*bench, lessons.at(0), 2);
    const std::uint64_t hash = session().hash();
    for (const Lesson& lesson : lessons)
        if (lesson.dimension == 3) {
            EXPECT_THROW(begin_lesson(*bench, lesson), InputError);
        }
    EXPECT_THROW(begin_lesson(*bench, lessons.at(0), 99), InputError);
    EXPECT_EQ(bench->teaching->part, 2u);
    EXPECT_EQ(session().hash(), hash);
}

}  // namespace
}  // namespace sightline
