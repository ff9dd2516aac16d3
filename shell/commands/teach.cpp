// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/teach.h"

#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/session/explain.h"
#include "shell/commands/command_table.h"
#include "shell/desk/conceal.h"
#include "shell/desk/moved.h"
#include "shell/desk/open.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

template <int D>
Teaching& lesson_of(Workbench<D>& bench) {
    if (!bench.teaching) throw InputError("no lesson is being given: lesson lists them");
    return *bench.teaching;
}

/// What the commands say of a step that later ones among them leave is not said.
template <int D>
void run_act(Workbench<D>& bench, const std::string& commands) {
    struct Said {
        std::string text;
        std::uint64_t run;
        std::uint32_t position;
    };
    std::vector<Said> all;
    const auto say = std::exchange(bench.say, [&](const std::string& text) {
        all.push_back({text, bench.run, bench.session.position()});
    });
    const auto tell = [&] {
        bench.say = say;
        for (const Said& said : all)
            if (said.run == bench.run && said.position == bench.session.position()) say(said.text);
    };
    try {
        run_commands(bench, commands);
    } catch (...) {
        tell();
        throw;
    }
    tell();
}

template <int D>
void open_part(Workbench<D>& bench, std::size_t part) {
    Teaching& teaching = *bench.teaching;
    const LessonPart& opened = teaching.lesson.parts.at(part);
    const bool followed = bench.session.settings().automatic == Switch::on;
    open_as_it_is(bench, opens(teaching.lesson, opened));
    teaching.part = part;
    teaching.presses = 0;
    teaching.guessed.clear();
    teaching.answer.reset();
    run_act(bench, opened.act);
    if (opened.concealed) tell_truth(bench, false);
    bench.session.selected_cell = bench.session.selected_primitive = none;
    bench.session.selected_node = bench.session.selected_plane = none;
    bench.desk.projector_panel = opened.panel;
    if (const Panel<D>* panel = find_panel<D>(opened.panel))
        (panel->column == Column::left ? bench.desk.left : bench.desk.right) = opened.panel;
    if (followed) bench.say("auto is off: the lesson sets method, cells and budget");
}

template <int D>
void play_beat(Workbench<D>& bench) {
    const Beat beat = bench.teaching->now().beats[bench.teaching->presses];
    run_act(bench, beat.act);
    if (beat.reveal) tell_truth(bench, true);
    ++bench.teaching->presses;
}

template <int D>
void play_to(Workbench<D>& bench, std::size_t part, std::size_t presses) {
    open_part(bench, part);
    while (bench.teaching->presses < presses) play_beat(bench);
}

/// "You took cell 13, PLP took 26: 0.274 is less than 0.301."
template <int D>
void score(Workbench<D>& bench, std::uint32_t guess, const Mark& mark) {
    Teaching& teaching = *bench.teaching;
    const Session<D>& session = bench.session;
    const std::uint32_t taken = last_cell(session);
    if (taken == none) return;
    ++teaching.score.made;
    teaching.score.right += taken == guess;
    if (taken == guess) {
        teaching.guessed = "You took cell " + std::to_string(guess) + " too.";
        return;
    }
    const Step& step = session.timeline().steps[session.position() - 1];
    const int digits = digits_of(step);
    teaching.guessed = "You took cell " + std::to_string(guess) + ", the method cell " + std::to_string(taken) + ": " +
                       (mark.state == CellState::enqueued
                            ? short_number(step.key, digits) + " against " + short_number(mark.key, digits) + "."
                            : "yours is not in the front.");
}

constexpr double by_hand = 0.01;  // of the key: what two rounded figures may be off

/// "You said 0.95, and it is: ρ = 16/23 + 0.953 · 0.274 = 0.957."
template <int D>
void tell_key(Workbench<D>& bench, std::uint32_t cell) {
    Teaching& teaching = *bench.teaching;
    const double key = bench.session.mark(cell).key;
    const int digits = 3;
    std::string is = "the key of cell " + std::to_string(cell) + " is " + short_number(key, digits);
    const auto source = key_source(bench.session, cell, digits);
    if (source && source->update.key) {
        is += ": " + source->update.key->formula();
        if (source->update.key->penalised) is += ", " + source->update.key->penalty;
    }
    is += ".";
    if (!teaching.answer) {
        is[0] = 'T';
        teaching.guessed = is;
        return;
    }
    const bool right = std::abs(*teaching.answer - key) <= by_hand * std::abs(key);
    ++teaching.score.made;
    teaching.score.right += right;
    teaching.guessed = "You said " + short_number(*teaching.answer, 6) + (right ? ", right: " : ", but ") + is;
}

}  // namespace

template <int D>
void begin_lesson(Workbench<D>& bench, const Lesson& lesson, std::size_t part) {
    if (lesson.dimension != D)
        throw InputError("lesson '" + lesson.id + "' is in " + std::to_string(lesson.dimension) +
                         "D: the other viewer gives it");
    if (part >= lesson.parts.size())
        throw InputError("lesson '" + lesson.id + "' has parts 1 to " + std::to_string(lesson.parts.size()));
    auto before = std::exchange(bench.teaching, Teaching{lesson, 0, 0, {}, {}, {}, {}});
    try {
        open_part(bench, part);
    } catch (...) {
        bench.teaching = std::move(before);
        throw;
    }
}

template <int D>
void next_beat(Workbench<D>& bench) {
    Teaching& teaching = lesson_of(bench);
    if (const Beat* const beat = teaching.next()) {
        const std::uint32_t guess = beat->guess ? bench.session.selected_cell : none;
        const Mark mark = guess == none ? Mark{} : bench.session.mark(guess);
        const std::uint32_t exercise = concealed_cell(bench);
        teaching.guessed.clear();
        if (exercise != none) tell_key(bench, exercise);
        teaching.answer.reset();
        play_beat(bench);
        if (guess != none) {
            score(bench, guess, mark);
            bench.session.selected_cell = none;
        }
        return;
    }
    if (teaching.part + 1 < teaching.lesson.parts.size()) return open_part(bench, teaching.part + 1);
    bench.say("this was the last part of " + teaching.lesson.title);
}

template <int D>
void answer_exercise(Workbench<D>& bench, double key) {
    Teaching& teaching = lesson_of(bench);
    if (concealed_cell(bench) == none) throw InputError("no key is asked for here");
    teaching.answer = key;
    next_beat(bench);
}

template <int D>
void previous_beat(Workbench<D>& bench) {
    Teaching& teaching = lesson_of(bench);
    if (teaching.presses > 0) return play_to(bench, teaching.part, teaching.presses - 1);
    if (teaching.part > 0)
        return play_to(bench, teaching.part - 1, teaching.lesson.parts[teaching.part - 1].beats.size());
    bench.say("the lesson begins here");
}

template <int D>
void tell_truth(Workbench<D>& bench, bool tell) {
    const auto change = [&](Session<D>& session) {
        Settings settings = session.settings();
        settings.show_visibility = tell ? Switch::on : Switch::off;
        session.change(settings);
    };
    change(bench.session);
    if (bench.other) change(bench.other->session);
}

template <int D>
std::vector<Row> lesson_lines(const Workbench<D>& bench) {
    if (!bench.teaching) return {};
    const Teaching& teaching = *bench.teaching;
    std::vector<Row> lines{{std::to_string(teaching.part + 1) + " of " + std::to_string(teaching.lesson.parts.size()) +
                                ": " + teaching.now().title,
                            Tone::faint}};
    if (const Beat* const done = teaching.done(); done && !done->say.empty()) lines.push_back({done->say});
    if (!teaching.guessed.empty())
        lines.push_back({teaching.guessed + (teaching.score.made == 0
                                                 ? ""
                                                 : " " + std::to_string(teaching.score.right) + " of " +
                                                       std::to_string(teaching.score.made) + " guesses right.")});
    if (const Beat* const next = teaching.next(); next && !next->ask.empty())
        lines.push_back({next->ask + (next->guess    ? " Click it, then PageDown."
                                      : next->key_of ? " Type :answer and the number, or PageDown."
                                                     : ""),
                         Tone::lit});
    return lines;
}

template <int D>
std::vector<Row> speaker_rows(const Workbench<D>& bench) {
    if (!bench.teaching) return {{"no lesson"}, {"F2 lists the lessons.", Tone::faint}};
    const Teaching& teaching = *bench.teaching;
    const auto& parts = teaching.lesson.parts;
    int until = 0;
    for (std::size_t i = 0; i <= teaching.part; ++i) until += parts[i].minutes;
    const auto seconds = static_cast<int>(teaching.since.milliseconds() / 1000);
    const std::string rest = std::to_string(seconds % 60);
    std::vector<Row> rows{
        {std::to_string(seconds / 60) + ":" + (rest.size() < 2 ? "0" : "") + rest},
        {std::to_string(teaching.part + 1) + " of " + std::to_string(parts.size()) + ": " + teaching.now().title +
             ", until minute " + std::to_string(until) + " of " + std::to_string(teaching.lesson.minutes()),
         Tone::faint}};
    if (!teaching.now().notes.empty()) rows.push_back({teaching.now().notes});
    if (const Beat* const next = teaching.next()) {
        if (!next->ask.empty()) rows.push_back({"Asked: " + next->ask});
        rows.push_back({"Next press: " + (next->say.empty() ? next->act : next->say)});
    } else if (teaching.part + 1 < parts.size()) {
        rows.push_back(
            {"Next press: part " + std::to_string(teaching.part + 2) + ", " + parts[teaching.part + 1].title});
    } else {
        rows.push_back({"This is the end."});
    }
    return rows;
}

#define SIGHTLINE_INSTANTIATE(D)                                              \
    template void begin_lesson<D>(Workbench<D>&, const Lesson&, std::size_t); \
    template void next_beat<D>(Workbench<D>&);                                \
    template void answer_exercise<D>(Workbench<D>&, double);                  \
    template void previous_beat<D>(Workbench<D>&);                            \
    template void tell_truth<D>(Workbench<D>&, bool);                         \
    template std::vector<Row> lesson_lines<D>(const Workbench<D>&);           \
    template std::vector<Row> speaker_rows<D>(const Workbench<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
