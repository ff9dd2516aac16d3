// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/into.h"

#include <gtest/gtest.h>

#include "core/session/explain.h"
#include "core/session/settings_table.h"
#include "core/session/substep.h"
#include "shell/desk/change.h"
#include "shell/desk/moves.h"
#include "shell/desk/play.h"
#include "shell/desk/undo.h"
#include "shell/panels/panel_table.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

using Place = std::pair<std::uint32_t, std::optional<std::uint32_t>>;

Place place(const Workbench<2>& bench) { return {bench.session.position(), bench.substep}; }

TEST(Into, VisitsEverySubstepOfEveryStepAndGoesBackTheSameWay) {
    Random random(91);
    for (int i = 0; i < 60; ++i) {
        test::Bench on(test::random_start(random).session());
        Workbench<2>& bench = on.bench;
        if (random.below(2)) test::record_ahead(bench);
        const Session<2> end = at_the_end(bench.session);
        std::vector<Place> places;
        for (std::uint32_t step = 1; step <= end.recorded(); ++step)
            for (std::uint32_t substep = 0; substep < substep_count(end, step); ++substep) {
                step_into(bench);
                ASSERT_EQ(place(bench), Place(step, substep));
                const ShownSession<2> shown(bench);
                ASSERT_EQ(shown->hash(), bench.session.in_the_middle(substep).hash());
                places.push_back(place(bench));
            }
        on.said.clear();
        step_into(bench);
        EXPECT_EQ(on.said.size(), 1u);
        EXPECT_EQ(place(bench), places.empty() ? Place(0, std::nullopt) : places.back()) << "it stays at the end";
        if (places.empty()) continue;
        // The last substep is where the step is done: no copy is needed to stand behind it.
        step_forward(bench, 1);
        EXPECT_EQ(place(bench), Place(end.recorded(), std::nullopt));
        const ShownSession<2> shown(bench);
        EXPECT_EQ(&*shown, &bench.session);
        for (std::size_t k = places.size(); k-- > 0;) {
            const bool first = places[k].second == 0u;
            step_out(bench);
            ASSERT_EQ(place(bench), first ? Place(places[k].first - 1, std::nullopt) : places[k - 1]);
        }
        step_out(bench);
        EXPECT_EQ(place(bench), Place(0, std::nullopt));
    }
}

/// As often out as into: what is shown is what was shown, also where a step is a single substep.
TEST(Into, OutUndoesIntoAcrossSteps) {
    Random random(94);
    for (int i = 0; i < 40; ++i) {
        test::Start start = test::random_start(random);
        start.settings.method = i % 2 == 0 ? "tri-z" : "published";
        test::Bench on(start.session());
        Workbench<2>& bench = on.bench;
        step_forward(bench, static_cast<std::uint32_t>(random.below(10)));
        std::vector<std::uint64_t> hashes{bench.session.hash()};
        for (int k = 0; k < 12 && !bench.session.finished(); ++k) {
            step_into(bench);
            hashes.push_back(ShownSession<2>(bench)->hash());
        }
        for (std::size_t k = hashes.size() - 1; k-- > 0;) {
            step_out(bench);
            ASSERT_EQ(ShownSession<2>(bench)->hash(), hashes[k]) << k << " of " << hashes.size();
        }
    }
}

TEST(Into, EveryOtherMoveAndChangeLeavesTheStep) {
    Random random(92);
    int inside = 0;
    for (int i = 0; i < 30; ++i) {
        test::Bench on(test::random_cell_start(random).session());
        Workbench<2>& bench = on.bench;
        const Settings settings = bench.session.settings();
        const auto leaves = [&](const char* name, auto move) {
            go_to_step(bench, 3);
            step_out(bench);
            if (!bench.substep) return;
            ++inside;
            move();
            EXPECT_EQ(bench.substep, std::nullopt) << name;
        };
        leaves("forward", [&] { step_forward(bench, 1); });
        leaves("back", [&] { step_back(bench, 1); });
        leaves("go", [&] { go_to_step(bench, 1); });
        leaves("end", [&] { run_to_end(bench); });
        leaves("until", [&] { run_until(bench, Condition<2>("step > 1")); });
        leaves("breakpoint", [&] { run_to_breakpoint(bench); });
        leaves("clock", [&] {
            play(bench);
            advance_clock(bench, 0.25);
            advance_clock(bench, 0.25);
        });
        leaves("view", [&] { change_view(bench, test::random_view(random)); });
        leaves("undo", [&] { undo(bench); });
        leaves("redo", [&] { redo(bench); });
        leaves("settings", [&] {
            Settings changed = settings;
            changed.jitter = settings.jitter > 0 ? 0 : 0.125;
            change_settings(bench, changed);
        });
        leaves("picture", [&] {
            Settings changed = bench.session.settings();
            apply_setting(changed, changed.palette == Palette::print ? "palette=default" : "palette=print");
            change_settings(bench, changed);
        });
        leaves("scene", [&] { change_scene(bench, test::random_start(random).scene); });
        leaves("session", [&] { replace_session(bench, test::random_start(random).session()); });
    }
    EXPECT_GT(inside, 200);
}

TEST(Into, PanelsTellNoMoreThanIsDone) {
    Random random(93);
    int told = 0;
    for (int i = 0; i < 40; ++i) {
        test::Bench on(test::random_cell_start(random).session());
        Workbench<2>& bench = on.bench;
        for (int k = 0; k < 60; ++k) {
            step_into(bench);
            if (!bench.substep) break;
            const auto lit = [&] {
                std::string text;
                for (const Row& row : code_rows(bench))
                    if (row.tone == Tone::lit) text += row.text + "\n";
                return text;
            }();
            EXPECT_FALSE(lit.empty());
            const Session<2> middle = bench.session.in_the_middle(*bench.substep);
            EXPECT_EQ(front_rows(bench).size(), middle.counters().front_size + 1);
            if (*bench.substep == 1 && substep_count(bench.session, bench.session.position()) > 2) {
                const auto part = why_rows(bench);
                const auto where = bench.substep;
                bench.substep.reset();
                EXPECT_LT(part.size(), why_rows(bench).size()) << "the facets come later";
                bench.substep = where;
                ++told;
            }
        }
    }
    EXPECT_GT(told, 50);
}

TEST(FrontPanel, TellsNeighboursApart) {
    Random random(94);
    int equal = 0, close = 0;
    for (int i = 0; i < 150; ++i) {
        test::Bench on(test::random_cell_start(random).session());
        on.bench.session.run(random.below(20));
        const auto entries = on.bench.session.traversal().front();
        const auto rows = front_rows(on.bench);
        ASSERT_EQ(rows.size(), entries.size() + 1);
        const auto key = [&](std::size_t k) {
            const std::string& text = rows[k + 1].text;
            const std::size_t begin = text.find("key ") + 4;
            return text.substr(begin, text.find("  stamp") - begin);
        };
        for (std::size_t k = 1; k < entries.size(); ++k) {
            const bool tie = entries[k].second.key == entries[k - 1].second.key;
            EXPECT_EQ(key(k) == key(k - 1), tie);
            EXPECT_EQ(rows[k + 1].text.ends_with("(tie, older stamp wins)"), tie);
            equal += tie;
            close += key(k).size() > 5;
        }
    }
    EXPECT_GT(equal, 5);
    EXPECT_GT(close, 5);
}

}  // namespace
}  // namespace sightline
