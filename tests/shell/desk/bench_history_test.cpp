// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/scene/make/catalogue.h"
#include "shell/commands/command_table.h"
#include "shell/desk/change.h"
#include "shell/desk/moves.h"
#include "shell/desk/undo.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

/// All that undo brings back, as text.
std::string text_of(const Workbench<2>& bench) {
    const Session<2>& s = bench.session;
    std::string text = hash_text(scene_hash(s.scene())) + " " + s.scene().source + (s.frozen() ? " frozen" : "") + "\n";
    for (const ViewSpec<2>& view : {s.culling_view(), s.display_view()})
        for (const double number : {view.eye.x, view.eye.y, view.look_at.x, view.look_at.y, view.fov})
            text += number_text(number) + " ";
    for (const SettingRow& row : settings_table()) text += std::string(row.name) + "=" + row.get(s.settings()) + "\n";
    for (const Note<2>& note : s.notes)
        text += std::to_string(static_cast<int>(note.kind)) + std::to_string(static_cast<int>(note.anchor)) + " " +
                number_text(note.point.x) + "," + number_text(note.point.y) + " " + std::to_string(note.index) + " " +
                note.text + " " + std::to_string(note.number) + " " + std::to_string(note.last_step) + "\n";
    for (const Bookmark& bookmark : s.bookmarks) text += std::to_string(bookmark.step) + bookmark.label + "\n";
    return text;
}

std::string random_command(Random& random, const Session<2>& session) {
    const Box<2> box = bounds<2>(session.scene().primitives);
    const auto point = [&] {
        const double x = random.unit(), y = random.unit();
        if (box.empty()) return number_text(x) + "," + number_text(y);
        return number_text(box.min.x + x * box.extent().x) + "," + number_text(box.min.y + y * box.extent().y);
    };
    const auto segment = [&] { return std::to_string(random.below(session.scene().primitives.size() + 1)); };
    switch (random.below(22)) {
        case 0:
            return "eye " + point();
        case 1:
            return "look " + point();
        case 2:
            return "fov " + std::to_string(20 + random.below(150));
        case 3:
            return "freeze";
        case 4:
            return "unfreeze";
        case 5:
            return "set jitter=" + number_text(0.25 * static_cast<double>(random.below(3)));
        case 6:
            return "set penalty=" + std::string(random.below(2) ? "none" : "add");
        case 7:
            return "set zoom=" + std::to_string(1 + random.below(5));
        case 8:
            return "set zoom_x=" + number_text(random.unit());
        case 9:
            return "set error_bound=0." + std::to_string(1 + random.below(5));
        case 10:
            return "cycle label";
        case 11:
            return "method " + std::string(random.below(2) ? "centroid" : "published");
        case 12:
            return "budget " + std::string(random.below(2) ? "unlimited" : "12");
        case 13:
            return "note text " + point() + " words";
        case 14:
            return "note callout primitive:" + segment() + " here";
        case 15:
            return "note ring cell:" + std::to_string(random.below(30));
        case 16:
            return "note-edit 1 " + std::string(random.below(2) ? "delete" : "other words");
        case 17:
            return "segment add " + point() + " " + point();
        case 18:
            return "segment move " + segment() + " " + point() + " " + point();
        case 19:
            return "segment delete " + segment();
        case 20:
            return random.below(10) == 0 ? "scene new" : "bookmark b";
        default:
            return "preset " + std::string(random.below(2) ? "paper-3d" : "default");
    }
}

TEST(History, UndoAllGivesTheStartAndRedoAllTheEnd) {
    Random random(96);
    int refused = 0, shorter = 0;
    for (int i = 0; i < 120; ++i) {
        test::Bench on(test::random_start(random, 30).session());
        Workbench<2>& bench = on.bench;
        if (random.below(2)) test::record_ahead(bench);
        go_to_step(bench, static_cast<std::uint32_t>(random.below(25)));
        const auto scene = bench.session.shared_scene();
        const std::string start = text_of(bench);
        const std::uint64_t start_hash = bench.session.hash();
        const std::uint32_t from = bench.session.position();
        std::uint32_t lowest = from;
        for (int k = 0; k < 40; ++k) {
            const std::string before = text_of(bench);
            const std::size_t entries = bench.history.past.size();
            try {
                run_commands(bench, random_command(random, bench.session));
            } catch (const InputError&) {
                EXPECT_EQ(text_of(bench), before);
                EXPECT_EQ(bench.history.past.size(), entries) << "nothing to undo";
                ++refused;
            }
            EXPECT_LE(bench.session.position(), lowest) << "a change does not move on";
            lowest = std::min(lowest, bench.session.position());
        }
        const std::string end = text_of(bench);
        const auto end_scene = bench.session.shared_scene();
        const std::uint32_t end_at = bench.session.position();
        const std::uint64_t end_hash = bench.session.hash();
        while (undo(bench)) lowest = std::min(lowest, bench.session.position());
        EXPECT_EQ(text_of(bench), start);
        EXPECT_EQ(bench.session.shared_scene(), scene);
        EXPECT_EQ(bench.session.position(), lowest);
        if (lowest == from)
            EXPECT_EQ(bench.session.hash(), start_hash);
        else
            ++shorter;
        while (redo(bench)) {
        }
        EXPECT_EQ(text_of(bench), end);
        EXPECT_EQ(bench.session.shared_scene(), end_scene);
        EXPECT_LE(bench.session.position(), end_at);
        if (bench.session.position() == end_at) {
            EXPECT_EQ(bench.session.hash(), end_hash);
        }
    }
    EXPECT_GT(refused, 20);
    EXPECT_GT(shorter, 5);
    EXPECT_LT(shorter, 115);
}

TEST(History, EachStepBackIsOneChange) {
    Random random(97);
    test::Bench on(test::random_cell_start(random, 30).session());
    Workbench<2>& bench = on.bench;
    std::vector<std::string> states{text_of(bench)};
    while (states.size() < 60) {
        const std::size_t entries = bench.history.past.size();
        try {
            run_commands(bench, random_command(random, bench.session));
        } catch (const InputError&) {
        }
        ASSERT_LE(bench.history.past.size(), entries + 1);
        if (bench.history.past.size() > entries) states.push_back(text_of(bench));
    }
    for (std::size_t k = states.size() - 1; k-- > 0;) {
        EXPECT_TRUE(undo(bench));
        ASSERT_EQ(text_of(bench), states[k]);
    }
    EXPECT_FALSE(undo(bench));
    for (std::size_t k = 1; k < states.size(); ++k) {
        EXPECT_TRUE(redo(bench));
        ASSERT_EQ(text_of(bench), states[k]);
    }
    EXPECT_FALSE(redo(bench));
    // A change in between ends what could be done again.
    undo(bench);
    run_commands(bench, "fov 33");
    EXPECT_FALSE(redo(bench));
}

TEST(History, GesturesJoin) {
    Random random(98);
    test::Bench on(test::random_cell_start(random).session());
    Workbench<2>& bench = on.bench;
    const std::string start = text_of(bench);
    const auto drag = [&] {
        for (int i = 0; i < 5; ++i) change_view(bench, test::random_view(random), "drag eye");
    };
    drag();
    const std::string between = text_of(bench);
    drag();
    EXPECT_EQ(bench.history.past.size(), 1u);
    undo(bench);
    EXPECT_EQ(text_of(bench), start);
    redo(bench);
    drag();
    EXPECT_EQ(bench.history.past.size(), 2u) << "a gesture does not go on after undo and redo";
    end_gesture(bench);
    drag();
    EXPECT_EQ(bench.history.past.size(), 3u);
    change_view(bench, test::random_view(random), "drag look");
    EXPECT_EQ(bench.history.past.size(), 4u);
    drag();
    change_view(bench, test::random_view(random));
    change_view(bench, test::random_view(random));
    EXPECT_EQ(bench.history.past.size(), 7u);
    while (undo(bench)) {
    }
    EXPECT_EQ(text_of(bench), start);
}

TEST(History, HasALimit) {
    Random random(99);
    test::Bench on(test::random_cell_start(random, 5).session());
    for (std::size_t i = 0; i < history_limit + 10; ++i) change_view(on.bench, test::random_view(random));
    EXPECT_EQ(on.bench.history.past.size(), history_limit);
}

}  // namespace
}  // namespace sightline
