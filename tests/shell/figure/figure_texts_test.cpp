// What stands over the pictures of figures, and whether it can be read on every figure that the documents show.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/draw/notes.h"
#include "core/session/state_file.h"
#include "shell/desk/compare.h"
#include "shell/desk/open.h"
#include "shell/export/export.h"
#include "shell/figure/lay_out.h"
#include "tests/shell/desk/bench_support.h"
#include "tests/shell/figure/figure_samples.h"
#include "tests/shell/figure/tidy.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

const fs::path source = SIGHTLINE_SOURCE_DIR;

FigureSize size_of(double width_mm, double font_pt) {
    FigureSize size;
    size.width_mm = width_mm;
    size.font_pt = font_pt;
    return size;
}

/// At the widths of one and two columns, in three sizes of text. Returns how many figures were looked at.
template <int D>
int expect_readable(const Workbench<D>& bench) {
    const Figure figure = shot_figure(bench);
    int looked_at = 0;
    for (const double width : {84.0, 178.0})
        for (const double font : {6.0, 8.0, 10.0}) {
            SCOPED_TRACE(std::to_string(width) + " mm, " + std::to_string(font) + " pt");
            try {
                FigureSize size = size_of(width, font);
                size.columns = bench.figure.columns;
                test::expect_tidy(figure, lay_out({&figure, 1}, size, test::figure_font()).front());
                ++looked_at;
            } catch (const InputError& error) {
                ADD_FAILURE() << error.what();
            }
        }
    return looked_at;
}

template <int D>
int expect_readable_state(const std::string& text, const std::string& name) {
    SCOPED_TRACE(name);
    OpenedState<D> opened = open_state<D>(text, name, method_table<D>());
    Workbench<D> bench{std::move(opened.session), opened.figure};
    bench.say = [](const std::string&) {};
    if (opened.other) compare_with(bench, std::move(*opened.other), "right", opened.align);
    return expect_readable(bench);
}

int expect_readable_state(const fs::path& file) {
    const std::string text = read_file(file.string());
    const bool solid = nlohmann::json::parse(text).value("dimension", 2) == 3;
    return solid ? expect_readable_state<3>(text, file.string()) : expect_readable_state<2>(text, file.string());
}

std::vector<fs::path> states_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TEST(FigureTexts, AllOfTheLessonsCanBeRead) {
    int looked_at = 0;
    for (const fs::path& file : states_in(source / "examples/lesson")) looked_at += expect_readable_state(file);
    EXPECT_GE(looked_at, 60);
}

TEST(FigureTexts, AllOfTheDocumentedFiguresCanBeRead) {
    const fs::path folder = fs::path(testing::TempDir()) / ("sightline-figures-" + std::to_string(getpid()));
    fs::create_directories(folder / "out");
    fs::create_directory_symlink(source / "examples", folder / "examples");
    std::string page = read_file((source / "docs/figures.md").string());
    const std::map<std::string, std::string> programs{{"./run viewer2d", SIGHTLINE_VIEWER2D},
                                                      {"./run viewer3d", SIGHTLINE_VIEWER3D}};
    std::size_t commands = 0;
    for (const auto& [words, program] : programs)
        for (std::size_t at = 0; (at = page.find("\n" + words, at)) != std::string::npos;) {
            std::size_t end = at + 1;
            while (page[page.find('\n', end) - 1] == '\\') end = page.find('\n', end) + 1;
            end = page.find('\n', end);
            const std::string command = program + page.substr(at + 1 + words.size(), end - at - 1 - words.size());
            EXPECT_EQ(std::system(("cd '" + folder.string() + "' && " + command + " > log 2>&1").c_str()), 0)
                << command << "\n"
                << read_file((folder / "log").string());
            at = end;
            ++commands;
        }
    EXPECT_GE(commands, 20u);
    std::vector<std::string> seen;  // a figure is there as SVG and as PNG
    int looked_at = 0;
    const fs::path here = fs::current_path();
    fs::current_path(folder);  // where the commands ran: scenes of files are named from there
    for (const fs::path& file : states_in(folder / "out")) {
        const std::string text = read_file(file.string());
        if (!file.stem().has_extension() || std::find(seen.begin(), seen.end(), text) != seen.end()) continue;
        seen.push_back(text);
        looked_at += expect_readable_state(file);
    }
    EXPECT_GE(looked_at, 120);
    fs::current_path(here);
    fs::remove_all(folder);
}

/// The print figure of a lecturer: three panels in a column's width, numbers, callouts and notes in one corner.
class PrintFigure : public testing::Test {
protected:
    PrintFigure() {
        Settings settings = on.bench.session.settings();
        settings.palette = Palette::print;
        settings.label = CellNumber::solidity;
        on.bench.session.change(settings);
        on.bench.figure.panels = {"step 7", "step 14", "end"};
        add(Note<2>::Kind::callout, 26, "taken first", {0, 0});
        add(Note<2>::Kind::callout, 13, "waits for its penalty", {10, 20});
        add(Note<2>::Kind::text, 27, "behind the gap", {0, 0});
    }
    void add(Note<2>::Kind kind, std::uint32_t cell, const std::string& text, const Vec<2>& offset) {
        Note<2> note;
        note.kind = kind;
        note.anchor = Note<2>::Anchor::cell;
        note.index = cell;
        note.text = text;
        note.offset_pt = offset;
        if (kind == Note<2>::Kind::callout) note.number = ++number;
        on.bench.session.notes.push_back(note);
    }
    Layout lay_out_at(const Figure& figure, double font = 8) const {
        return lay_out({&figure, 1}, size_of(84, font), test::figure_font()).front();
    }

    std::uint32_t number = 0;
    test::Bench on{open_scene("bottleneck", {}, method_table<2>(), [](const std::string&) {})};
};

TEST_F(PrintFigure, NotesAndCalloutsShowInEveryPanelAndNothingOverlaps) {
    const Figure figure = shot_figure(on.bench);
    for (const double font : {6.0, 8.0, 10.0}) {
        const Layout layout = lay_out_at(figure, font);
        test::expect_tidy(figure, layout);
        for (std::size_t i = 0; i < 3; ++i) {
            const PlacedTexts texts = place_texts(figure.panels[i], layout.panels[i], layout, test::figure_font());
            std::size_t notes = 0;
            for (const PlacedLabel& placed : texts.labels) {
                const Label& label = figure.panels[i].list.labels[placed.label];
                notes += label.note;
                if (label.text == "2") {
                    EXPECT_TRUE(placed.tip) << "an offset moves a callout, too";
                }
                if (label.text == "1" && font == 8) {
                    EXPECT_FALSE(placed.tip) << "nothing takes its place";
                }
            }
            EXPECT_EQ(notes, 3u) << font << " pt, panel " << i;
            EXPECT_GT(texts.labels.size(), notes) << "some numbers find room";
        }
    }
}

TEST_F(PrintFigure, TheLegendStandsInTheEmptyQuarter) {
    const Figure figure = shot_figure(on.bench);
    const Layout layout = lay_out_at(figure);
    const Rect &b = layout.panels[1].frame, &c = layout.panels[2].frame;
    EXPECT_GT(c.y, b.bottom()) << "two and one";
    ASSERT_FALSE(layout.legend.empty());
    for (const Layout::Row& row : layout.legend) {
        EXPECT_GT(row.box.x, c.right());
        EXPECT_GE(row.box.y, c.y - 1e-6);
    }
    Settings settings = on.bench.session.settings();
    settings.legend = Legend::brief;
    on.bench.session.change(settings);
    const Figure brief = shot_figure(on.bench);
    EXPECT_LT(brief.legend.size(), figure.legend.size());
    EXPECT_LE(lay_out_at(brief).height, layout.height - 8 * 8);
}

TEST_F(PrintFigure, PanelsStandInAsManyColumnsAsAreAskedFor) {
    on.bench.figure.columns = 3;
    EXPECT_EQ(figure_size(on.bench.figure).columns, 3u);
    const Figure figure = shot_figure(on.bench);
    const Layout layout = lay_out({&figure, 1}, figure_size(on.bench.figure), test::figure_font()).front();
    test::expect_tidy(figure, layout);
    EXPECT_DOUBLE_EQ(layout.panels[0].frame.y, layout.panels[2].frame.y);
}

TEST_F(PrintFigure, WithoutALegendCalloutsAreStillExplained) {
    Settings settings = on.bench.session.settings();
    settings.legend = Legend::off;
    on.bench.session.change(settings);
    const Figure figure = shot_figure(on.bench);
    std::vector<std::string> rows;
    for (const LegendRow& row : figure.legend) rows.push_back(row.text);
    EXPECT_EQ(rows, (std::vector<std::string>{"1: taken first", "2: waits for its penalty"}));
    const Layout layout = lay_out_at(figure);
    test::expect_tidy(figure, layout);
    ASSERT_EQ(layout.legend.size(), 2u);
    EXPECT_DOUBLE_EQ(layout.legend[0].text[0].left(), layout.legend[0].box.x) << "no room for swatches";
    on.bench.session.notes.clear();
    EXPECT_EQ(shot_figure(on.bench).legend_place, LegendPlace::off);
}

TEST_F(PrintFigure, SaysWhatWasDroppedOrLiesOutside) {
    Note<2> far;
    far.text = "nowhere";
    far.point = {1e6, 1e6};
    on.bench.session.notes.push_back(far);
    const fs::path file = fs::path(testing::TempDir()) / ("sightline-left-out-" + std::to_string(getpid()) + ".svg");
    write_shot(on.bench, file.string());
    const std::string said = on.said.back();
    EXPECT_NE(said.find("; (a) note 'nowhere' lies outside the picture"), std::string::npos) << said;
    EXPECT_NE(said.find(" labels dropped: no room"), std::string::npos) << said;
    const auto sidecar = nlohmann::json::parse(read_file(file.string() + ".json"));
    const auto remarks = sidecar.at("figure").at("left_out").get<std::vector<std::string>>();
    EXPECT_FALSE(remarks.empty());
    for (const std::string& remark : remarks) EXPECT_NE(said.find(remark), std::string::npos) << remark;
    // What is said is what is so.
    const Figure figure = shot_figure(on.bench);
    const Layout layout = lay_out_at(figure);
    const PlacedTexts texts = place_texts(figure.panels[0], layout.panels[0], layout, test::figure_font());
    EXPECT_NE(said.find("(a) " + std::to_string(texts.no_room.size()) + " label"), std::string::npos) << said;
    Settings settings = on.bench.session.settings();
    settings.label = CellNumber::none;
    on.bench.session.change(settings);
    on.bench.session.notes.pop_back();
    write_shot(on.bench, file.string());
    EXPECT_TRUE(on.said.back().ends_with(".json")) << on.said.back();
    EXPECT_EQ(read_file(file.string() + ".json").find("left_out"), std::string::npos);
    fs::remove(file);
    fs::remove(file.string() + ".json");
}

TEST(FigureTexts, ANoteWiderThanItsPanelIsBrokenIntoLines) {
    Figure figure = sample_figure(1, LegendPlace::off);
    Label note;
    note.at = {0.5, 0.2};
    note.text = "a note that says so much that no column of a journal has room for it in a single line of text";
    note.note = true;
    figure.panels[0].list.labels = {note};
    const Layout layout = lay_out({&figure, 1}, size_of(84, 10), test::figure_font()).front();
    test::expect_tidy(figure, layout);
    const PlacedTexts texts = place_texts(figure.panels[0], layout.panels[0], layout, test::figure_font());
    ASSERT_EQ(texts.labels.size(), 1u);
    EXPECT_GT(texts.labels[0].runs.size(), 1u);
    figure.panels[0].list.labels[0].note = false;
    const PlacedTexts smaller = place_texts(figure.panels[0], layout.panels[0], layout, test::figure_font());
    ASSERT_EQ(smaller.labels.size(), 1u);
    EXPECT_LT(smaller.labels[0].runs.at(0).size, 10) << "what the picture says itself is set smaller";
    test::expect_tidy(figure, layout);
}

TEST_F(PrintFigure, ARunNamesNormalsAfterItsNotes) {
    EXPECT_EQ(cell_letter(on.bench.session.notes, 27), "27") << "a sentence is no letter";
    add(Note<2>::Kind::text, 27, "B", {0, 0});
    EXPECT_EQ(cell_letter(on.bench.session.notes, 27), "B");
    EXPECT_EQ(cell_letter(on.bench.session.notes, 28), "28");
}

TEST_F(PrintFigure, LinesFollowTheTextAndAPngTheResolution) {
    const Figure figure = shot_figure(on.bench);
    EXPECT_DOUBLE_EQ(line_scale(lay_out_at(figure, 16)), 2 * line_scale(lay_out_at(figure, 8)));
    on.bench.figure.panels = {};
    const fs::path file = fs::path(testing::TempDir()) / ("sightline-dpi-" + std::to_string(getpid()) + ".png");
    for (const double dpi : {150.0, 600.0}) {
        on.bench.figure.dpi = dpi;
        write_shot(on.bench, file.string());
        const std::string png = read_file(file.string());
        const int width = static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]);
        EXPECT_NEAR(width, 84 / 25.4 * dpi, 1);
    }
    fs::remove(file);
    fs::remove(file.string() + ".json");
}

}  // namespace
}  // namespace sightline
