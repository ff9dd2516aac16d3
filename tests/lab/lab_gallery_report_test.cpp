// The gallery's page: marks at the right places, nothing from outside, pictures of what is missed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/gallery/gallery_report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <limits>

#include "core/base/file.h"
#include "core/draw/insets.h"
#include "core/measure/metrics.h"
#include "core/measure/wrong_region.h"
#include "lab/command.h"
#include "lab/report/wrong_pictures.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;

std::size_t occurrences(const std::string& text, const std::string& of) {
    std::size_t found = 0;
    for (std::size_t at = text.find(of); at != std::string::npos; at = text.find(of, at + of.size())) ++found;
    return found;
}

/// From the first `from` to the next `to` after it.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t begin = text.find(from);
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find(to, begin) - begin);
}

/// The cells of the matrix's row of a scene, marks only: ✓ ✗ ○, ! for a surprise, a comma between cells, small marks in
/// brackets.
std::string marks(const std::string& html, const std::string& anchor) {
    std::string row = between(html, "href='#" + anchor, "</tr>"), result;
    row = row.substr(row.find("</td><td>"));     // the name is one cell,
    row = row.substr(row.find("</td>", 5) + 5);  // the dimension another
    for (std::size_t at = 0; at < row.size();) {
        const auto next = [&](const char* word) { return row.compare(at, std::string(word).size(), word) == 0; };
        if (next("</td>"))
            result += ',';
        else if (next("<small>"))
            result += '(';
        else if (next("</small>"))
            result += ')';
        if (next("<")) {
            at = row.find('>', at) + 1;
            continue;
        }
        result += row[at++];
    }
    return result;
}

constexpr Expectation coverage_passes{"published", Expect::pass, "coverage", Bound::at_least, 0.5, "most is drawn"};
constexpr Expectation wrong_fails{"published", Expect::fail, "wrong", Bound::at_most, 0.1, "a < b & c"};
constexpr Expectation varied{"published penalty=add", Expect::pass, "detour", Bound::at_most, 3, "no way round"};
constexpr Expectation layers_passes{"layers", Expect::pass, "coverage", Bound::at_least, 0.5, "most is drawn"};
constexpr Expectation cells_fail{"cells border=none", Expect::fail, "unassigned", Bound::at_most, 0, "none is lost"};
constexpr Expectation advisor{"advisor", Expect::pending, "coverage", Bound::at_least, 0.9, "all is drawn"};

std::vector<GalleryEntry> entries() {
    const double nan = std::numeric_limits<double>::quiet_NaN(), never = std::numeric_limits<double>::infinity();
    return {{"2d:first",
             2,
             1,
             "First",
             "It teaches.",
             "two < three",
             {judge(coverage_passes, true, 0.75), judge(wrong_fails, true, 0.25), judge(varied, true, 2),
              judge(advisor, false, nan)},
             {},
             "./run viewer2d --state first.json"},
            {"3d:second",
             3,
             30,
             "Second",
             "It teaches, too.",
             "look here",
             {judge(coverage_passes, true, 0.25), judge(varied, true, never), judge(layers_passes, true, 1),
              judge(cells_fail, true, 7)},
             {},
             ""}};
}

TEST(LabGalleryPage, MarksWhoSurvivesWhat) {
    const auto all = entries();
    const GalleryCounts counts = count(all);
    EXPECT_EQ(counts_text(counts), "2 scenes, 8 expectations, 1 pending, 2 surprises");
    const std::string html = gallery_page(all, "Measured at home.");
    EXPECT_NE(html.find("<b>2 scenes, 8 expectations, 1 pending, 2 surprises</b>"), std::string::npos);
    EXPECT_NE(html.find("Measured at home."), std::string::npos);
    // Columns: published, layers | cells | advisor. Nobody asks for the other methods here.
    const std::string heads = between(html, "<span class=up>", "</thead>");
    EXPECT_EQ(occurrences(heads, "class=up"), 4u) << heads;
    for (const char* pair : {"published layers", "layers cells", "cells advisor"}) {
        const std::string text = pair;
        const std::size_t space = text.find(' ');
        EXPECT_LT(heads.find(">" + text.substr(0, space) + "<"), heads.find(">" + text.substr(space + 1) + "<"));
    }
    EXPECT_EQ(marks(html, "2d-first"), "✓✗ (✓),,,○,");
    EXPECT_EQ(marks(html, "3d-second"), "✗! (✗!),✓, (✗),,") << "the two surprises say so";
    EXPECT_NE(between(html, "href='#2d-first", "</tr>").find("m some"), std::string::npos);
    EXPECT_NE(between(html, "href='#3d-second", "</tr>").find("m all"), std::string::npos) << "layers";
    EXPECT_NE(between(html, "href='#3d-second", "</tr>").find("m alarm"), std::string::npos);
    // Without the settings of their own: published passes one of three, layers its one.
    const std::string sums = between(html, "<tfoot>", "</tfoot>");
    EXPECT_NE(sums.find(">1/3<"), std::string::npos) << sums;
    EXPECT_NE(sums.find(">1/1<"), std::string::npos) << sums;
}

TEST(LabGalleryPage, TellsEachSceneInWords) {
    const std::string html = gallery_page(entries(), "");
    const std::string first = between(html, "<section id='2d-first'", "</section>");
    for (const char* text :
         {"1 · first, 2D", "two &lt; three.", "First: It teaches.", "a &lt; b &amp; c", "<td>75\u00a0%</td>",
          "<td>at\u00a0least\u00a050\u00a0%</td>", "<td>25\u00a0%</td>", "<td>at\u00a0most\u00a010\u00a0%</td>",
          "wrong\u00a0pixels", "published <code>penalty=add</code>", "<td>2</td>", "✓\u00a0passes", "✗\u00a0fails",
          "○\u00a0pending", "<code>./run viewer2d --state first.json</code>"})
        EXPECT_NE(first.find(text), std::string::npos) << text << "\n" << first;
    EXPECT_EQ(first.find("SURPRISE"), std::string::npos);
    const std::string second = between(html, "<section id='3d-second'", "</section>");
    EXPECT_EQ(occurrences(second, "SURPRISE: was expected to pass"), 2u);
    EXPECT_NE(second.find("<td>∞</td>"), std::string::npos);
    EXPECT_NE(second.find("<td>7\u00a0primitives</td>"), std::string::npos);
    const std::string meaning = between(html, "What the numbers mean", "</html>");
    EXPECT_EQ(occurrences(meaning, "<tr>"), 1 + 4u) << "a line for each measure that is used";
    EXPECT_NE(meaning.find("rendered until ε reaches 0.95"), std::string::npos);
}

TEST(LabGalleryPage, SaysWhenAPendingMethodHasCome) {
    std::vector<GalleryEntry> all = entries();
    all[0].verdicts = {judge(advisor, true, 0.95)};
    const std::string html = gallery_page(all, "");
    EXPECT_NE(html.find("SURPRISE: it exists now"), std::string::npos);
}

TEST(LabGalleryPictures, AreRedWhereSomethingIsMissed) {
    LabGraphics graphics;
    const auto rows = gallery<3>();
    const auto row = std::find_if(rows.begin(), rows.end(), [](const auto& r) { return std::string(r.id) == "gap"; });
    ASSERT_NE(row, rows.end());
    Session<3> session = gallery_session(*row, graphics.draw_ids());
    session.run();
    const Reference& reference = session.reference();
    const auto red = [&](const SolidList& list) {
        std::vector<std::uint8_t> drawn(session.scene().primitives.size());
        for (const std::uint32_t id : list.triangles) drawn[id] = 1;
        const Pixels pixels = wrong_in_red(list, reference.image, wrong_mask(reference.image, drawn), graphics);
        const auto count = std::count(pixels.colours.begin(), pixels.colours.end(), Colour{220, 30, 30});
        return static_cast<double>(count) / static_cast<double>(pixels.colours.size());
    };
    const double wrong = wrong_pixels(reference, session.met());
    EXPECT_GT(wrong, 0);
    EXPECT_DOUBLE_EQ(red(image_so_far(session)), wrong);
    EXPECT_EQ(red(exact_image(session)), 0);
}

TEST(LabGalleryCommand, WritesAPageThatNeedsNoOtherFile) {
    const fs::path folder = fs::temp_directory_path() / ("sightline-gallery-" + std::to_string(getpid()));
    const std::string out = folder.string();
    const char* const arguments[] = {"gallery",  "2d:hullgap", "2d:bottleneck", "3d:bottleneck",
                                     "3d:empty", "--out",      out.c_str()};
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_EQ(gallery_command(static_cast<int>(std::size(arguments)), arguments, {}), 0);
    const std::string said = testing::internal::GetCapturedStdout(), told = testing::internal::GetCapturedStderr();
    const std::string last = said.substr(said.rfind('\n', said.size() - 2) + 1);
    EXPECT_TRUE(last.starts_with("4 scenes, ") && last.ends_with(" pending, 0 surprises\n")) << last;
    EXPECT_NE(told.find("scene 1 of 4\n"), std::string::npos) << told;
    EXPECT_NE(told.find("scene 4 of 4, about "), std::string::npos) << told;
    EXPECT_EQ(occurrences(told, " s left\n"), 3u) << told;

    const std::string html = read_file(folder / "gallery.html");
    for (const char* outside : {"http", "src='pictures", "<script", "<link", "@import", "url("})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
    EXPECT_EQ(occurrences(html, "<section id="), 4u);
    EXPECT_EQ(occurrences(html, "<img "), occurrences(html, "src='data:image/"));
    // Two of a scene, but one where the step in 2D is the last.
    for (const auto& [scene, pictures] :
         {std::pair("2d-hullgap", 1u), {"2d-bottleneck", 2u}, {"3d-bottleneck", 2u}, {"3d-empty", 2u}}) {
        const std::string section = between(html, "<section id='" + std::string(scene) + "'", "</section>");
        EXPECT_EQ(occurrences(section, "<img "), pictures) << scene;
    }
    const std::string bottleneck = between(html, "<section id='3d-bottleneck'", "</section>");
    EXPECT_NE(bottleneck.find("Red: visible but missed"), std::string::npos);
    const std::string state = out + "/bottleneck-3d.json";
    EXPECT_NE(bottleneck.find("./run viewer3d --state " + state), std::string::npos);
    EXPECT_TRUE(fs::exists(state));
    fs::remove_all(folder);
}

TEST(LabGalleryCommand, ListingTakesNoTime) {
    const char* const arguments[] = {"gallery", "--list"};
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_EQ(gallery_command(2, arguments, {}), 0);
    EXPECT_FALSE(testing::internal::GetCapturedStdout().empty());
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "nothing to wait for";
}

}  // namespace
}  // namespace sightline::lab
