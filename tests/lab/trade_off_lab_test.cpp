// The trade-off panel's numbers are those of lab measure: same scene, path, frames, methods, budgets, reference size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "lab/lab_graphics.h"
#include "lab/measure/lab_scene.h"
#include "lab/measure/measure_path.h"
#include "lab/report/method_looks.h"
#include "shell/commands/command_table.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/desk/open_scene.h"

namespace sightline {
namespace {

using M = Measure;

/// What the panel does without: it takes long, or compares with another frame.
bool is_made(const MeasureRow& row) {
    for (const M m :
         {M::cell_oracle, M::mis_ranked, M::unreached, M::zeta, M::fused, M::pop, M::flip, M::visible_change})
        if (row.measure == m) return false;
    return !row.is_time;
}

template <int D>
void expect_numbers_of_the_lab(const std::string& name, const ImageSize& size) {
    lab::LabGraphics opengl;
    lab::Study study;
    study.frames = trade_off_frames;
    study.size = size;
    study.repeats = 0;
    study.methods.clear();
    for (const Method<D>& method : method_table<D>())
        if (method.compared && !method.needs.history)
            study.methods.push_back(lab::parse_method(std::string(method.id)));
    const lab::LabScene<D> scene = lab::load_lab_scene<D>(name, "", study);
    lab::Instruments instruments;
    instruments.draw_ids = opengl.draw_ids();
    const std::vector<lab::Row> rows = lab::measure_path<D>(scene, study, instruments);

    Graphics graphics;
    graphics.draw_ids = opengl.draw_ids();
    Settings settings = start_settings<D>(name);
    settings.reference_size = size;
    Workbench<D> bench{open_scene<D>(
        name, settings, method_table<D>(), [](const std::string&) {}, graphics)};
    bench.graphics = graphics;
    bench.say = [](const std::string&) {};
    bench.flight.path = lab::find_path<D>(bench.session.scene(), "");
    ASSERT_GT(bench.flight.path.frames.size(), 2u);
    run_commands(bench, "trade-off finish");
    const TradeOffStudy<D>& panel = bench.trade_off.study;
    std::size_t usual = 0;
    for (const TradeOffDot& dot : panel.dots()) usual += !dot.asked;
    ASSERT_EQ(usual, rows.size());

    std::size_t partly = 0;
    for (const lab::Row& row : rows) {
        const std::string where = name + " " + row.method.variant + " " + row.budget;
        const auto dot = std::find_if(panel.dots().begin(), panel.dots().end(), [&](const TradeOffDot& d) {
            return panel.task().variants[d.variant].text == row.method.variant && budget_text(d.budget) == row.budget;
        });
        ASSERT_NE(dot, panel.dots().end()) << where;
        ASSERT_EQ(dot->frames.size(), row.values.size()) << where;
        for (const MeasureRow& m : measure_table()) {
            if (m.is_time) continue;
            for (std::size_t f = 0; f < row.values.size(); ++f) {
                const double ours = dot->frames[f][m.measure], theirs = row.values[f][m.measure];
                if (is_made(m))
                    EXPECT_TRUE(ours == theirs || (std::isnan(ours) && std::isnan(theirs)))
                        << where << " frame " << f << " " << m.id << ": " << ours << " and " << theirs;
                else
                    EXPECT_TRUE(std::isnan(ours)) << m.id << " is made: compare it";
            }
            if (!is_made(m)) continue;
            const double ours = panel.value(*dot, m.measure), theirs = summary(row, m.measure);
            EXPECT_TRUE(ours == theirs || (std::isnan(ours) && std::isnan(theirs))) << where << " " << m.id;
        }
        const double coverage = summary(row, M::coverage), wrong = summary(row, M::wrong);
        partly += coverage > 0 && coverage < 1 && wrong > 0;
    }
    EXPECT_GT(partly, 3u) << "numbers that are all 0 or 1 compare nothing";
}

TEST(TradeOffAndLab, GiveTheSameNumbersIn2D) {
    for (const char* name : {"rooms", "streets"}) expect_numbers_of_the_lab<2>(name, {512, 1});
}

TEST(TradeOffAndLab, GiveTheSameNumbersIn3D) {
    try {
        for (const char* name : {"bottleneck", "city:10k"}) expect_numbers_of_the_lab<3>(name, {160, 120});
    } catch (const WorkError& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
}

TEST(TradeOffAndLab, VariantsLookTheSame) {
    Workbench<2> bench{
        open_scene<2>("rooms", start_settings<2>("rooms"), method_table<2>(), [](const std::string&) {})};
    bench.say = [](const std::string&) {};
    run_commands(bench, "trade-off add published on_reenqueue=min; trade-off add published penalty=add");
    for (const char* tessellation : {"delaunay", "tree"}) {
        run_commands(bench, std::string("set tessellation=") + tessellation + "; trade-off restart");
        const auto& variants = bench.trade_off.study.task().variants;
        ASSERT_GE(variants.size(), 7u);
        const std::vector<VariantLook> panel = trade_off_looks(bench);
        // The lab lists others too, in another order.
        std::vector<lab::MethodChoice> methods{lab::parse_method("published outside_view=enqueue"),
                                               lab::parse_method("layers@tree")};
        for (std::size_t i = variants.size(); i-- > 0;)
            methods.push_back({variants[i].text, variants[i].method.orders_cells()
                                                     ? bench.session.settings().tessellation
                                                     : Tessellation::delaunay});
        const lab::MethodLooks looks(methods);
        for (std::size_t i = 0; i < variants.size(); ++i) {
            const lab::Series series = looks.series(methods[methods.size() - 1 - i]);
            EXPECT_TRUE(series.look == panel[i]) << series.name;
            EXPECT_EQ(series.name.find("@tree") == std::string::npos, series.look.filled) << series.name;
            lab::Chart chart;
            chart.series.push_back(series);
            chart.series.back().points = {{1, 2}, {2, 3}};
            EXPECT_NE(lab::gnuplot_script(chart).find(hex_colour(panel[i].colour)), std::string::npos) << series.name;
            EXPECT_EQ(lab::gnuplot_script(chart).find(" dt 1 ") == std::string::npos, !panel[i].dash.empty());
        }
    }
}

}  // namespace
}  // namespace sightline
