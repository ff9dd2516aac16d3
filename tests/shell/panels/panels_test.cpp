// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/number.h"
#include "core/base/random.h"
#include "core/session/explain.h"
#include "core/session/explain_primitive.h"
#include "shell/commands/command_table.h"
#include "shell/desk/open_scene.h"
#include "shell/panels/panel.h"
#include "shell/panels/panel_table.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

Workbench<2> bench_of(const char* scene) {
    Session<2> session = open_scene(scene, start_settings(scene), method_table<2>(), [](const std::string&) {});
    Workbench<2> bench{std::move(session), {}, Stop::none, false, [](const std::string&) {}};
    test::record_ahead(bench);
    return bench;
}

/// A bench in the middle of things: something selected, marked, noted, and perhaps inside a step.
Workbench<2> busy_bench(const char* scene, std::uint64_t seed) {
    Workbench<2> bench = bench_of(scene);
    Random random(seed);
    const auto run = [&](const std::string& text) { run_commands(bench, text); };
    run("step " + std::to_string(random.below(30)));
    if (seed % 3 != 0) run("select " + std::to_string(random.below(bench.session.cells().cell_count())));
    if (seed % 4 == 1) run("select primitive:" + std::to_string(random.below(bench.session.scene().primitives.size())));
    if (seed % 2 == 0) run("break step:9; break rho > 0.2; mark count > 3; note ring cell:0 x; bookmark here");
    if (seed % 5 == 2) run("into; into; into");
    return bench;
}

TEST(Panels, EveryLineCanBeClickedAndNamesACellThatExists) {
    for (const char* scene : {"bottleneck", "forget"})
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Workbench<2> bench = busy_bench(scene, seed);
            for (const Panel<2>& panel : panel_table<2>()) {
                const auto rows = panel.rows(bench);
                EXPECT_FALSE(rows.empty()) << panel.id;
                for (const Row& row : rows) {
                    SCOPED_TRACE(std::string(panel.id) + ": " + row.text);
                    EXPECT_FALSE(row.text.empty());
                    EXPECT_TRUE(row.cell == none || row.cell < bench.session.cells().cell_count());
                    Workbench<2> clicked = bench;
                    if (!row.command.empty()) {
                        EXPECT_NO_THROW(run_commands(clicked, row.command));
                    }
                }
            }
        }
}

TEST(Panels, WhySaysTheKeyOfTheSelectedCellAndItsWayThere) {
    Workbench<2> bench = bench_of("bottleneck");
    run_commands(bench, "step 6");
    for (std::uint32_t cell = 0; cell < bench.session.cells().cell_count(); ++cell) {
        run_commands(bench, "select " + std::to_string(cell));
        const Mark mark = bench.session.mark(cell);
        const std::string text = panels_text(bench);
        EXPECT_NE(text.find("Selected: cell " + std::to_string(cell) + ", " +
                            std::string(cell_state_words[static_cast<std::size_t>(mark.state)])),
                  std::string::npos);
        if (cell != last_cell(bench.session)) EXPECT_LT(text.find("Selected: cell"), text.find("Step 6 took"));
        const bool keyed = mark.state == CellState::enqueued || mark.state == CellState::projected;
        EXPECT_EQ(text.find(" (key) ") != std::string::npos, keyed);
        const CellExplanation e = explain_cell(bench.session, cell);
        if (keyed) {
            EXPECT_NE(text.find(" (key) " + short_number(mark.key, e.digits)), std::string::npos);
        }
        EXPECT_EQ(text.find("not in the front: ") != std::string::npos, !keyed);
    }
}

TEST(Panels, SettingsAreThoseThatTheMethodHasAUseFor) {
    Workbench<2> bench = bench_of("bottleneck");
    const auto names = [&](const std::string& method) {
        run_commands(bench, "method " + method);
        std::string text;
        for (const Row& row : settings_rows(bench)) text += row.text + "\n";
        return text;
    };
    EXPECT_NE(names("published").find("penalty = "), std::string::npos);
    EXPECT_EQ(names("layers").find("penalty = "), std::string::npos);
    EXPECT_NE(names("layers").find("outside_view = "), std::string::npos);
    EXPECT_EQ(names("everything").find("outside_view = "), std::string::npos);
    EXPECT_NE(names("everything").find("budget = "), std::string::npos);
    EXPECT_NE(names("formula").find("key = content"), std::string::npos);
}

TEST(Panels, APrimitiveIsFoundWhereTheRunMeetsIt) {
    Workbench<2> bench = bench_of("bottleneck");
    run_commands(bench, "run; seek 5");
    Session<2> walk = bench.session;
    walk.seek(0);
    std::vector<std::uint32_t> met(walk.scene().primitives.size(), 0);
    while (walk.step() == Stop::none)
        for (const Met entry : walk.met().subspan(walk.timeline().before(walk.position()).touched_count))
            met[entry.primitive()] = walk.position();
    for (std::uint32_t p = 0; p < met.size(); ++p) {
        const PrimitiveExplanation e = explain_primitive(bench.session, p);
        EXPECT_EQ(e.met_at, met[p]);
        EXPECT_EQ(e.visible, bench.session.reference().visible[p] != 0);
        for (std::uint32_t cell = 0; cell < walk.cells().cell_count(); ++cell) {
            const auto held = walk.cells().primitives_of(cell);
            EXPECT_EQ(std::count(held.begin(), held.end(), p), std::count(e.cells.begin(), e.cells.end(), cell));
        }
    }
}

}  // namespace
}  // namespace sightline
