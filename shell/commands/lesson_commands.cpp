// Commands of a lecturer: lessons, the beats of a clicker, the truth hidden and told.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/session/headline.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/commands/teach.h"
#include "shell/desk/moves.h"

namespace sightline {

namespace {

/// The list, over the picture.
template <int D>
void list_lessons(Workbench<D>& bench) {
    bench.lessons = read_lessons(lessons_of_the_project());
    bench.desk.lessons = !bench.desk.lessons;
    if (!bench.desk.lessons) return;
    for (const Lesson& lesson : bench.lessons)
        if (lesson.dimension == D)
            bench.say(lesson.id + ": " + lesson.title + ", " + std::to_string(lesson.parts.size()) + " parts, " +
                      std::to_string(lesson.minutes()) + " minutes");
}

const Lesson& find_lesson(const std::vector<Lesson>& lessons, std::string_view id) {
    const auto found =
        std::find_if(lessons.begin(), lessons.end(), [&](const Lesson& lesson) { return lesson.id == id; });
    if (found != lessons.end()) return *found;
    std::vector<std::string_view> known;
    for (const Lesson& lesson : lessons) known.push_back(lesson.id);
    throw unknown_word("lesson", id, known);
}

/// "plp", "plp 3", "end", or an index of one's own with the lesson's id.
template <int D>
void give_lesson(Workbench<D>& bench, Text text) {
    if (text.empty()) return list_lessons(bench);
    auto [word, rest] = split_word(text);
    if (word == "end") {
        bench.teaching.reset();
        bench.desk.projector_panel.clear();
        return tell_truth(bench, true);
    }
    std::vector<Lesson> lessons;
    if (word.ends_with(".json")) {
        lessons = read_lessons(word);
        const auto further = split_word(rest);
        word = further[0];
        rest = further[1];
        if (word.empty() && lessons.size() == 1) word = lessons[0].id;
    } else {
        lessons = read_lessons(lessons_of_the_project());
    }
    const std::size_t part = rest.empty() ? 1 : whole_argument(rest, "a part of the lesson, from 1");
    begin_lesson(bench, find_lesson(lessons, word), part - 1);
    bench.desk.lessons = false;
}

/// What a clicker does: beats in a lesson, else steps.
template <int D>
void forward(Workbench<D>& bench, Text) {
    bench.teaching ? next_beat(bench) : step_forward(bench, 1);
}
template <int D>
void backward(Workbench<D>& bench, Text) {
    bench.teaching ? previous_beat(bench) : step_back(bench, 1);
}

template <int D>
void truth(Workbench<D>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"hide", "tell"});
    const bool tell = text.empty() ? !tells_truth(bench.session) : word_argument(text, words) == 1;
    tell_truth(bench, tell);
    bench.say(tell ? "what is visible is told" : "what is visible is hidden, in the picture and in words");
}

constexpr std::array lesson_end{NamedArgument{"End lesson", "end"}};

}  // namespace

template <int D>
std::span<const Command<D>> lesson_commands() {
    static constexpr std::array table{
        Command<D>{"lesson", "Lessons", "[ID [PART] | FILE.json [ID [PART]] | end]",
                   "list the lessons, give one from a part on, or end it", "F2", give_lesson<D>, "", lesson_end},
        Command<D>{"next", "Next beat", "", "the next beat of a lesson; without one, a step", "PageDown", forward<D>},
        Command<D>{"previous", "Previous beat", "", "one beat of a lesson back; without one, a step", "PageUp",
                   backward<D>},
        Command<D>{"answer", "Answer", "NUMBER",
                   "the key that an exercise of a lesson asks for; PageDown tells it without an answer", "",
                   [](Workbench<D>& bench, Text text) {
                       answer_exercise(bench, number_argument(text, "a number, as the key of a cell is"));
                       bench.say(bench.teaching->guessed);
                   }},
        Command<D>{"speaker", "Speaker notes", "",
                   "open or close a second window with your notes, what comes next, and the time", "F3",
                   [](Workbench<D>& bench, Text) { bench.desk.speaker = !bench.desk.speaker; }},
        Command<D>{"truth", "Tell or hide", "[tell | hide]",
                   "tell what is visible, in the picture and in words, or hide it until the class has guessed",
                   "Shift+H", truth<D>},
    };
    return table;
}

template std::span<const Command<2>> lesson_commands<2>();
template std::span<const Command<3>> lesson_commands<3>();

}  // namespace sightline
