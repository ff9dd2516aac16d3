// Charts and the report: the Pareto points, what gnuplot makes of a chart, claims, and a page that needs no other file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/random.h"
#include "core/process/run_program.h"
#include "lab/measure/run_study.h"
#include "lab/report/chart_labels.h"
#include "lab/report/chart_layout.h"
#include "lab/report/claims.h"
#include "lab/report/markdown.h"
#include "lab/report/time_table.h"
#include "lab/report/winners.h"
#include "tests/lab/report_rows.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;
using M = Measure;
using test::report_row;
using test::results_of;

std::vector<const Row*> pointers(const std::vector<Row>& rows) {
    std::vector<const Row*> all;
    for (const Row& row : rows) all.push_back(&row);
    return all;
}

TEST(LabTradeOff, IsWhatNothingBeats) {
    Random random(71);
    for (int round = 0; round < 200; ++round) {
        std::vector<Row> rows;
        for (std::size_t i = random.below(12); i-- > 0;)
            rows.push_back(report_row("city", "layers", "1%", static_cast<double>(1 + random.below(6)),
                                      static_cast<double>(random.below(6)), static_cast<double>(random.below(6)), 1));
        for (const M measure : {M::wrong, M::coverage}) {
            const auto front = pareto_points(pointers(rows), measure);
            for (const Row& row : rows) {
                const double ms = row.values[0][M::total_ms], value = row.values[0][measure];
                const bool beaten = std::any_of(rows.begin(), rows.end(), [&](const Row& other) {
                    const double oms = other.values[0][M::total_ms], ovalue = other.values[0][measure];
                    const bool better = measure == M::wrong ? ovalue < value : ovalue > value;
                    return (oms <= ms && better) || (oms < ms && (better || ovalue == value));
                });
                const bool in = std::any_of(front.begin(), front.end(), [&](const auto& p) { return p.row == &row; });
                EXPECT_EQ(in, !beaten);
            }
            for (std::size_t i = 1; i < front.size(); ++i) EXPECT_LE(front[i - 1].cost, front[i].cost);
        }
    }
}

TEST(LabTradeOff, SaysWhatItsTimesAre) {
    Row row = report_row("2d:rooms", "layers", "5%", 1, 0.1, 0.9);
    const auto axis = [&] { return trade_off({row.scene, row.path, {&row}}, M::wrong).x; };
    EXPECT_NE(axis().find("drawing"), std::string::npos);
    for (Values& v : row.values) v[M::draw_ms] = v[M::upload_ms] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(axis().find("traversal alone"), std::string::npos) << axis();
}

TEST(LabTradeOff, HasAnAxisOfWhatIsDrawnAndOneOfWhatIsTested) {
    Row row = report_row("city", "cplp", "5%", 1, 0.1, 0.9), other = report_row("city", "view", "unlimited", 2, 0, 1);
    for (Values& v : row.values) {
        v[M::rendered] = 70;
        v[M::tested] = 30;
    }
    for (Values& v : other.values) v[M::rendered] = 500;
    const Group group{row.scene, row.path, {&row, &other}};
    const auto at = [&](M cost) { return trade_off(group, M::wrong, cost).series[1].points.at(0)[0]; };
    EXPECT_EQ(at(M::total_ms), 1);
    EXPECT_EQ(at(M::rendered), 70);
    EXPECT_EQ(at(M::tested), 30);
    EXPECT_NE(trade_off(group, M::wrong, M::tested).x.find("tested, tests"), std::string::npos);
    EXPECT_EQ(pareto_points(group.rows, M::wrong, M::rendered).front().cost, 70);
    const TextTable table = time_table(group);
    ASSERT_EQ(table.rows.size(), 2u);
    for (const auto& cells : table.rows) EXPECT_EQ(cells.size(), table.head.size());
    EXPECT_EQ(table.rows[1][9], "2") << "the total";
    EXPECT_EQ(table.rows[1][11], "500") << "frames per second";
}

TEST(LabTradeOff, NamesTheBestWithinATime) {
    const std::vector<Row> rows{
        report_row("city", "published", "1%", 4, 0.3, 0), report_row("city", "layers", "1%", 6, 0.1, 0),
        report_row("city", "centroid", "1%", 5, 0.2, 0), report_row("city", "perfect", "unlimited", 1, 0, 1)};
    const Group group{"city", "test", pointers(rows)};
    EXPECT_EQ(best_within(group, 3), nullptr) << "exactly V is no method";
    EXPECT_EQ(trade_off(group, M::wrong).series[0].points.front()[0], 4) << "nor a Pareto point";
    EXPECT_EQ(best_within(group, 4)->method.id(), "published");
    EXPECT_EQ(best_within(group, 5.5)->method.id(), "centroid");
    EXPECT_EQ(best_within(group, 100)->method.id(), "layers");
}

TEST(LabTradeOff, SaysWhoWinsAtEachShareOfWrongPixels) {
    const std::vector<Row> rows{report_row("city", "layers", "1%", 2, 0.04, 0),
                                report_row("city", "layers@tree", "1%", 2.5, 0.04, 0),
                                report_row("city", "flux@tree", "2%", 3, 0.009, 0),
                                report_row("city", "tri-z", "5%", 4.5, 0.0005, 0),
                                report_row("city", "boxes", "unlimited", 4, 0, 1),
                                report_row("city", "two-pass", "unlimited", 5, 0, 1),
                                report_row("city", "perfect", "unlimited", 1, 0, 1),
                                report_row("city", "hom", "unlimited", std::nan(""), 0, 1)};
    const TextTable table = winners_table(results_of(rows));
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0],
              (std::vector<std::string>{"city, test", "layers 1%: 2; flux@tree 2%: 3", "flux@tree 2%: 3; boxes: 4",
                                        "boxes: 4; tri-z 5%: 4.5", "boxes: 4; tri-z 5%: 4.5", "boxes: 4; two-pass: 5",
                                        "boxes: 4; two-pass: 5"}));
    EXPECT_EQ(table.head.size(), table.rows[0].size());
    EXPECT_EQ(table.head[2], "at most 1 % wrong");
    const std::vector<Row> one{report_row("city", "layers", "1%", 2, 0.04, 0)};
    EXPECT_EQ(winners_table(results_of(one)).rows[0][1], "layers 1%: 2");
    EXPECT_EQ(winners_table(results_of(one)).rows[0][2], "–");
    EXPECT_TRUE(winners_table(results_of({report_row("city", "perfect", "unlimited", 1, 0, 1)})).rows.empty());
}

TEST(LabTradeOff, SaysOfWinnersWhatWasMeasured) {
    const auto says = [](const std::vector<Row>& rows, const std::string& words) {
        const std::string text = winners_text(results_of(rows));
        EXPECT_NE(text.find(words), std::string::npos) << text;
        for (const Method<3>& method : method_table<3>()) {
            const std::string id(method.id);
            const bool measured =
                std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.method.id() == id; });
            for (const char* const after : {" ", ",", ";", ")"})
                EXPECT_TRUE(measured || text.find(" " + id + after) == std::string::npos || id == "view" ||
                            id == "everything")
                    << id << " was not measured: " << text;
        }
    };
    const std::vector<Row> rows{
        report_row("city", "layers", "1%", 2, 0.04, 0), report_row("city", "boxes", "unlimited", 4, 0, 1),
        report_row("cars", "layers", "1%", 2, 0.04, 0), report_row("cars", "boxes", "unlimited", 4, 0.0001, 1),
        report_row("room", "tri", "5%", 2, 0.04, 0)};
    says(rows, "at most 5 % wrong: layers 2, tri 1; none wrong: boxes 1, nobody 2.");
    says(rows, "(traversal + upload + drawing; milliseconds");
    says(rows, "A budget wins only where a few pixels may be wrong");
    std::vector<Row> flat{report_row("2d:streets", "published", "1%", 2, 0.04, 0),
                          report_row("2d:streets", "view", "unlimited", 1, 0, 1)};
    for (Row& row : flat)
        for (Values& values : row.values) values[M::draw_ms] = values[M::upload_ms] = std::nan("");
    says(flat, "at most 5 % wrong: view 1; none wrong: view 1.");
    says(flat, "(traversal alone, since no drawing is timed; milliseconds");
    EXPECT_EQ(winners_text(results_of(flat)).find("A budget wins"), std::string::npos) << "it does not";
    flat.insert(flat.end(), rows.begin(), rows.end());
    says(flat, "(traversal + upload + drawing; where no drawing is timed, traversal alone; milliseconds");
}

class LabFiles : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_ = fs::temp_directory_path() / ("sightline-report-" + std::to_string(getpid()));
};

TEST_F(LabFiles, ChartsAreDrawnByGnuplot) {
    Chart chart;
    chart.title = "a \"title\" with \\ and ρ, _not_ {enhanced}";
    chart.x = "x";
    chart.y = "y";
    chart.log_x = true;
    chart.series.push_back({"one", {}, {}, 2, {{1, 2}, {10, NAN}, {100, 3}}, {"1%", "", "10 %"}});
    chart.series.push_back({"two", {}, {}, 2, {{0, 2}, {-1, 3}}, {}});
    write_chart(chart, folder_ / "chart");
    const std::string svg = read_file(folder_ / "chart.svg");
    EXPECT_NE(svg.find("a \"title\" with \\ and ρ, _not_ {enhanced}"), std::string::npos) << svg.substr(0, 3000);
    EXPECT_NE(svg.find(">one<"), std::string::npos);
    EXPECT_NE(svg.find(">10 %<"), std::string::npos) << "beside its point";
    EXPECT_EQ(svg.find(">two<"), std::string::npos) << "on a logarithmic axis it has no point";
    EXPECT_EQ(read_file(folder_ / "chart.png").substr(1, 3), "PNG");
    const fs::path elsewhere = folder_ / "elsewhere";
    fs::create_directories(elsewhere);
    fs::copy(folder_ / "chart.gp", elsewhere);
    run_program({"gnuplot", "chart.gp"}, "gnuplot-nox", elsewhere);
    EXPECT_EQ(read_file(elsewhere / "chart.svg"), svg) << "the script needs its folder only";
    EXPECT_EQ(read_file(folder_ / "chart.pdf").substr(0, 5), "%PDF-");
    // Nothing but the four files: gnuplot works elsewhere and its files are moved.
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) files += entry.is_regular_file();
    EXPECT_EQ(files, 4u);
    write_chart({}, folder_ / "empty");
    EXPECT_NE(read_file(folder_ / "empty.svg").find("nothing to show"), std::string::npos);
}

TEST_F(LabFiles, ChartsHaveTheSizeThatIsAskedFor) {
    Chart chart;
    chart.title = "the title";
    chart.x = "time per frame, ms (traversal + upload + drawing; median over frames)";
    chart.y = "y";
    for (const char* const name : {"one", "a variant with=a long name and=another"})
        chart.series.push_back({name, {}, {}, 2, {{1, 2}, {2, 4}, {3, 3}}, {"1%", "2%", "5%"}});
    ChartFormat format = read_chart_size("84mm");
    format.titles = false;
    write_chart(chart, folder_ / "small", format);
    const std::string svg = read_file(folder_ / "small.svg");
    EXPECT_NE(svg.find("width=\"317"), std::string::npos) << svg.substr(0, 300);
    EXPECT_EQ(svg.find("the title"), std::string::npos);
    for (const std::string text : {"one", "a variant with=a long name and=another", "5%", "median", "frames)"})
        EXPECT_NE(svg.find(text), std::string::npos) << text << " has vanished";
    const std::string png = read_file(folder_ / "small.png");
    const auto width = static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]);
    EXPECT_EQ(width, 992) << "84 mm at 300 dpi";
    format = read_chart_size("1200x600");
    EXPECT_EQ(format.width, 1200);
    EXPECT_EQ(format.height, 600);
    EXPECT_NEAR(read_chart_size("120x80mm").height, 80 / 25.4 * 96, 1e-9);
    for (const char* wrong : {"", "84", "mm", "84 cm", "3mm", "1200x", "1x1", "1200x600x3", "nanmm", "1e9mm"})
        EXPECT_THROW(read_chart_size(wrong), InputError) << wrong;
    // A folder for temporary files of any name.
    const fs::path odd = folder_ / "-%d %s", before = fs::temp_directory_path();
    fs::create_directories(odd);
    setenv("TMPDIR", odd.c_str(), 1);
    write_chart(chart, folder_ / "odd", format);
    setenv("TMPDIR", before.c_str(), 1);
    EXPECT_TRUE(fs::exists(folder_ / "odd.pdf"));
    EXPECT_TRUE(fs::is_empty(odd));
}

TEST_F(LabFiles, KeysNameEverySeries) {
    for (const auto& [count, letters] : {std::pair{6, 40}, {21, 44}, {50, 4}, {40, 110}, {12, 20}, {1, 300}}) {
        Chart chart;
        for (int i = 0; i < count; ++i) {
            std::string name = "s" + std::to_string(i) + "e";
            if (i == count / 2)  // words of eight letters
                for (int k = 0; k < letters; k += 8) name += " abcdefg";
            chart.series.push_back({name, {}, {}, 2, {{1, 2}, {2, 3.0 + i}}, {}});
        }
        write_chart(chart, folder_ / "chart");
        const std::string svg = read_file(folder_ / "chart.svg");
        for (int i = 0; i < count; ++i)
            EXPECT_NE(svg.find(">s" + std::to_string(i) + "e"), std::string::npos) << i << " of " << count;
        const ChartFormat format;
        const ChartLayout layout = layout_of(chart, format, {0, 1});
        ASSERT_EQ(layout.key.size(), chart.series.size());
        for (const KeyEntry& entry : layout.key) {
            EXPECT_GE(entry.x, 0);
            EXPECT_GE(entry.y - 0.6 * format.font * static_cast<double>(entry.lines.size()), 0) << count;
            EXPECT_LT(entry.y, layout.height);
            for (const std::string& line : entry.lines)
                EXPECT_LT(entry.x + 3.8 * format.font + 0.55 * format.font * static_cast<double>(line.size()),
                          format.width)
                    << line;
        }
    }
}

TEST(LabCharts, AxesFitWhatTheyShow) {
    const auto range = [](std::vector<double> values, bool share = false) { return axis_range(values, false, share); };
    EXPECT_GT(range({76, 100}, true).from, 70) << "0 is far";
    EXPECT_LT(range({76, 100}, true).from, 76) << "no point on the axis";
    EXPECT_GT(range({76, 100}, true).to, 100);
    EXPECT_LT(range({76, 100}, true).to, 102);
    EXPECT_LT(range({0, 10}).from, 0);
    EXPECT_GT(range({0, 10}).from, -1);
    EXPECT_LT(range({4, 10}).from, 0) << "0 is near enough to be shown";
    EXPECT_LT(range({5, 5}).from, 5);
    EXPECT_GT(range({5, 5}).to, 5);
    EXPECT_LT(range({0, 0}).from, range({0, 0}).to);
    const AxisRange log = axis_range({0.1, 10}, true);
    EXPECT_LT(log.from, 0.1);
    EXPECT_GT(log.from, 0);
    EXPECT_GT(log.to, 10);
}

TEST(LabCharts, TellSeriesApartInGrey) {
    std::vector<std::string> methods;
    for (const Method<3>& method : method_table<3>()) methods.emplace_back(method.id);
    std::vector<Series> series;
    const std::vector<VariantLook> looks = variant_looks(methods);
    for (std::size_t i = 0; i < methods.size(); ++i) series.push_back({methods[i], looks[i]});
    const std::vector<Series> apart = told_apart_in_grey(series);
    for (std::size_t i = 0; i < apart.size(); ++i) {
        EXPECT_EQ(apart[i].look.colour, series[i].look.colour) << "the colour is that of the window";
        for (std::size_t j = 0; j < i; ++j) {
            VariantLook a = apart[i].look, b = apart[j].look;
            a.colour = b.colour = {};
            EXPECT_FALSE(a == b) << methods[i] << " and " << methods[j] << " look alike in grey";
        }
    }
    EXPECT_TRUE(apart[0].look.dash.empty()) << "the first one keeps its line";
}

TEST(LabCharts, LabelsNeverVanish) {
    std::vector<ChartLabel> labels;
    std::vector<std::array<double, 2>> points;
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        points.push_back({random.uniform(0, 300), random.uniform(0, 200)});
        labels.push_back({std::to_string(i) + "%", points.back()[0], points.back()[1]});
    }
    const std::vector<LabelPlace> places = place_labels(labels, points, {}, 8);
    ASSERT_EQ(places.size(), labels.size());
    std::size_t covered = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_FALSE(places[i].shared);
        EXPECT_LT(std::hypot(places[i].x - labels[i].x, places[i].y - labels[i].y), 25) << "beside its point";
        for (std::size_t j = 0; j < i; ++j)
            covered += places[i].side == places[j].side && std::abs(places[i].x - places[j].x) < 8 &&
                       std::abs(places[i].y - places[j].y) < 8;
    }
    EXPECT_LE(covered, 2u);
    const std::vector<LabelPlace> same = place_labels({{"5%", 10, 10}, {"5%", 12, 10}, {"6%", 12, 10}}, {}, {}, 8);
    EXPECT_TRUE(same[1].shared) << "the same words stand there";
    EXPECT_FALSE(same[2].shared);
}

TEST(LabTradeOff, HasBarsAndMarkersWhereThingsWereMeasured) {
    std::vector<Row> rows{report_row("city", "published", "1%", 4, 0.3, 0.5, 4),
                          report_row("city", "view", "unlimited", 6, 0, 1, 4)};
    for (Row& row : rows)
        for (std::size_t i = 0; i < 4; ++i) {
            row.frames[i] = static_cast<std::uint32_t>(40 * i);
            row.values[i][M::total_error] = 0.5;
        }
    const Group group{"city", "test", pointers(rows)};
    const Series published = trade_off(group, M::wrong).series[1];
    EXPECT_DOUBLE_EQ(published.errors.front()[0], std::sqrt(4 * 0.25) / 4);
    EXPECT_EQ(published.labels.front(), "1%");
    const Results results = results_of(rows);
    for (const NamedChart& chart : study_charts(results))
        if (chart.id.find("frames") != std::string::npos)
            for (const Series& s : chart.chart.series) EXPECT_TRUE(s.sampled) << chart.id;
    EXPECT_NE(gnuplot_script(trade_off(group, M::wrong)).find("xerrorbars"), std::string::npos);
}

TEST(StudyWords, ATessellationIsReadAsItIsWrittenAndNoOtherWordIs) {
    for (const Tessellation cells : {Tessellation::delaunay, Tessellation::tree})
        EXPECT_EQ(read_tessellation(tessellation_word({"published", cells})), cells);
    EXPECT_THROW(read_tessellation("leaves"), InputError);
    EXPECT_THROW(read_tessellation(""), InputError);
}

TEST(FileStem, StaysInItsFolder) {
    EXPECT_EQ(file_stem("2d:a/../b c-1.5"), "2d_a_.._b_c-1.5");
    const std::string a(1000, 'a'), b = a + "b";
    EXPECT_LE(file_stem(a).size(), 200u);
    EXPECT_NE(file_stem(a), file_stem(b));
    EXPECT_EQ(file_stem(std::string(200, 'a')), std::string(200, 'a'));
}

TEST_F(LabFiles, ABudgetInTimeIsPlottedFrameByFrame) {
    Results results = results_of({report_row("city", "published", "5%", 5, 0.2, 0.8)});
    const auto chart_ids = [&] {
        std::vector<std::string> ids;
        for (const NamedChart& chart : study_charts(results)) ids.push_back(chart.id);
        return ids;
    };
    const std::string id = "city-test-frames-budget";
    auto ids = chart_ids();
    EXPECT_EQ(std::count(ids.begin(), ids.end(), id), 0) << "there are none";
    // Three repeats of three frames.
    TimedFlight flight{"city", "test", {"published"}, "8ms", 8, {}};
    for (const std::uint32_t rendered : {10, 20, 30, 16, 20, 90, 12, 26, 33}) flight.frames.push_back({rendered});
    results.flights = {flight, {"city", "air", {"published"}, "8ms", 8, {}}};
    ids = chart_ids();
    ASSERT_EQ(std::count(ids.begin(), ids.end(), id), 1);
    for (const NamedChart& chart : study_charts(results)) {
        if (chart.id != id) continue;
        ASSERT_EQ(chart.chart.series.size(), 1u);
        EXPECT_EQ(chart.chart.series[0].name, "published 8ms");
        const std::vector<std::array<double, 2>> medians{{0, 12}, {1, 20}, {2, 33}};
        EXPECT_EQ(chart.chart.series[0].points, medians);
    }
}

TEST_F(LabFiles, TheReportNeedsNoOtherFile) {
    const Results results = results_of(
        {report_row("city", "published", "5%", 5, 0.2, 0.8), report_row("city", "layers", "5%", 4, 0.1, 0.9),
         report_row("city", "everything", "unlimited", 50, 0, 1), report_row("city", "view", "unlimited", 40, 0, 1)});
    write_report(results, judge_claims(results), {}, folder_);
    const std::string html = read_file(folder_ / "report.html");
    for (const char* outside : {"src='http", "href=", "url(", "<script", "src=\""})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
    const auto charts = study_charts(results);
    EXPECT_GE(charts.size(), 5u);
    std::size_t inlined = 0;
    for (std::size_t at = html.find("data:image/svg"); at != std::string::npos;
         at = html.find("data:image/svg", at + 1))
        ++inlined;
    EXPECT_EQ(inlined, charts.size());
    for (const NamedChart& chart : charts)
        for (const char* ending : {".gp", ".svg", ".png"})
            EXPECT_TRUE(fs::exists(folder_ / "charts" / (chart.id + ending))) << chart.id << ending;
    EXPECT_NE(html.find("layers 5%: 10 %"), std::string::npos) << "the best within 5 ms";
    EXPECT_NE(html.find("8 times as fast as view culling (10 times as drawing everything)"), std::string::npos);
    for (const MeasureRow& m : measure_table())
        EXPECT_NE(html.find(std::string(m.title)), std::string::npos) << m.title << " is not explained";
}

TEST_F(LabFiles, TheDocumentationExplainsEveryMeasure) {
    const std::string docs = read_file(fs::path(SIGHTLINE_SOURCE_DIR) / "docs/measuring.md");
    for (const MeasureRow& m : measure_table()) {
        std::string formula;  // as a table of Markdown writes it
        for (const char c : m.formula) formula += c == '|' ? std::string("\\|") : std::string(1, c);
        const std::string row = "| " + std::string(m.id) + " | " + std::string(m.unit) + " | " + formula + " | ";
        EXPECT_NE(docs.find(row), std::string::npos) << row;
    }
    write_markdown(results_of({report_row("city", "published", "5%", 5, 0.2, 0.8)}), "./run lab measure city",
                   folder_ / "results.md");
    const std::string page = read_file(folder_ / "results.md");
    EXPECT_NE(page.find("| published | 50 | 5% | 80 | 80 |"), std::string::npos) << page;
    EXPECT_NE(page.find("](images/results-city-test-wrong.svg)"), std::string::npos);
    EXPECT_TRUE(fs::exists(folder_ / "images/results-city-test-wrong.svg"));
}

/// Draws the worst frame of each method and opens it with the command beside it: it has to be that frame.
template <int D>
void expect_commands_open_the_frames(const std::string& scene, const std::string& viewer, const fs::path& folder) {
    Study study;
    study.scenes = {scene};
    study.frames = 3;
    study.methods = {parse_method("published"), parse_method("layers@tree")};
    study.budgets = {parse_budget("7%")};
    study.size = {160, 120};
    study.repeats = 0;
    study.settings = {"penalty=none"};
    LabGraphics graphics;
    const Results results = run_study(study, folder / "study", graphics);
    const ReportPictures pictures = draw_report_pictures(results, {}, study, folder / "a picture", graphics);
    ASSERT_EQ(pictures.worst.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const FramePicture& shown = pictures.worst[i];
        EXPECT_EQ(read_file(shown.file).substr(1, 3), "PNG");
        const std::string start = "./run viewer" + std::to_string(D) + "d ";
        ASSERT_TRUE(shown.command.starts_with(start)) << shown.command;
        const fs::path stats = folder / "stats.json";
        const std::string line = viewer + " " + shown.command.substr(start.size()) + " --headless --stats " +
                                 stats.string() + " > /dev/null 2>&1";
        ASSERT_EQ(std::system(line.c_str()), 0) << line;
        const auto json = nlohmann::json::parse(read_file(stats));
        const Values& frame = results.rows[i].values[worst_frame(results.rows[i], M::wrong)];
        EXPECT_DOUBLE_EQ(json.at("coverage").get<double>(), frame[M::coverage]) << line;
        EXPECT_EQ(json.at("rendered").get<double>(), frame[M::rendered]) << line;
        EXPECT_EQ(json.at("steps").get<double>(), frame[M::steps]) << line;
        EXPECT_EQ(shown.wrong, frame[M::wrong]);
    }
}

TEST_F(LabFiles, CommandsOpenTheWorstFrames) {
    expect_commands_open_the_frames<2>("2d:rooms", SIGHTLINE_VIEWER2D, folder_ / "2");
    expect_commands_open_the_frames<3>("3d:bottleneck", SIGHTLINE_VIEWER3D, folder_ / "3");
    const fs::path odd = folder_ / "an odd 'name'.json";
    write_file(odd, R"({"format":"sightline-scene","version":1,"dimension":2,"view":{"eye":[-5,1],"look_at":[0,0]},)"
                    R"("segments":[[0,0,1,0],[0,1,1,1],[0,2,1,2],[-1,3,0,-3],[-2,-2,-2,2]]})");
    expect_commands_open_the_frames<2>(odd.string(), SIGHTLINE_VIEWER2D, folder_ / "odd");
}

TEST_F(LabFiles, PicturesOfClaimsAreThoseThatDoNotHold) {
    Study study;
    study.scenes = {"room:10k"};
    study.frames = 2;
    study.methods = {parse_method("published"), parse_method("published@tree"), parse_method("centroid")};
    study.budgets = {parse_budget("10%")};
    study.size = {64, 48};
    study.repeats = 0;
    LabGraphics graphics;
    const Results results = run_study(study, folder_ / "study", graphics);
    std::vector<Claim> claims(3);
    claims[0].regimes = {{"room:10k", "test", "", true, &results.rows[1]}};
    claims[1].regimes = {{"room:10k", "test", "", true, &results.rows[0]},
                         {"room:10k", "test", "", false, &results.rows[1]}};
    claims[2].regimes = {{"room:10k", "test", "", false, nullptr}};
    const ReportPictures pictures = draw_report_pictures(results, claims, study, folder_ / "pictures", graphics);
    ASSERT_EQ(pictures.claims.size(), 1u);
    EXPECT_EQ(pictures.claims.at(1).method, "published@tree");
    claims[1].text = "They say so";
    write_report(results, claims, pictures, folder_);
    const std::string html = read_file(folder_ / "report.html");
    EXPECT_NE(html.find("“They say so”"), std::string::npos);
}

TEST(RunProgram, SaysWhyItFailed) {
    EXPECT_NO_THROW(run_program({"true"}, "coreutils"));
    try {
        run_program({"sh", "-c", "echo first complaint >&2; echo second >&2; exit 3"}, "dash");
        FAIL();
    } catch (const WorkError& error) {
        EXPECT_STREQ(error.what(), "sh failed: first complaint");
    }
    try {
        run_program({"sightline-has-no-such-program"}, "some-package");
        FAIL();
    } catch (const WorkError& error) {
        EXPECT_NE(std::string(error.what()).find("install the package some-package"), std::string::npos);
    }
}

}  // namespace
}  // namespace sightline::lab
