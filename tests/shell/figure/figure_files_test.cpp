// Figures as files: formats, names, failures.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cairo/cairo.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <thread>

#include "core/base/error.h"
#include "shell/figure/figure.h"
#include "tests/shell/figure/figure_samples.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

/// A folder for one test, removed at its end.
class FigureFiles : public testing::Test {
protected:
    fs::path folder = fs::temp_directory_path() / ("sightline-figures-" + std::to_string(getpid()) + "-" +
                                                   testing::UnitTest::GetInstance()->current_test_info()->name());

    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::string written(const Figure& figure, const FigureSize& size, const std::string& name) const {
        write_figure(figure, size, folder / name);
        return read(folder / name);
    }
    static std::string read(const fs::path& path) {
        std::ifstream in(path, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
    std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {})); }
    static bool has(const std::string& program) {
        return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
    }
    std::string output(const std::string& command) const {
        const fs::path out = folder / "output.txt";
        EXPECT_EQ(std::system(("cd '" + folder.string() + "' && " + command + " > output.txt").c_str()), 0) << command;
        return read(out);
    }
};

FigureSize pixels(int width, int height) {
    FigureSize size;
    size.width_px = width;
    size.height_px = height;
    return size;
}

std::string message(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

unsigned big_endian(const std::string& data, std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(data[i]);
    return value;
}

using Image = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

Image load(const fs::path& path) {
    Image image(cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy);
    EXPECT_EQ(cairo_surface_status(image.get()), CAIRO_STATUS_SUCCESS);
    return image;
}

/// Mean difference of two images' channels, 0 to 255, where both have pixels.
double pixel_difference(const Image& a, const Image& b) {
    const int w = std::min(cairo_image_surface_get_width(a.get()), cairo_image_surface_get_width(b.get()));
    const int h = std::min(cairo_image_surface_get_height(a.get()), cairo_image_surface_get_height(b.get()));
    double sum = 0;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < 4 * w; ++x) {
            if (x % 4 == 3) continue;
            const auto at = [&](const Image& image) {
                return cairo_image_surface_get_data(image.get())[y * cairo_image_surface_get_stride(image.get()) + x];
            };
            sum += std::abs(at(a) - at(b));
        }
    return sum / (3.0 * w * h);
}

TEST_F(FigureFiles, PngHasTheAskedPixelsAndKnowsItsResolution) {
    const Figure figure = sample_figure(2, LegendPlace::outside);
    const std::string px = written(figure, pixels(640, 361), "a.png");
    EXPECT_EQ(big_endian(px, 16), 640u);
    EXPECT_EQ(big_endian(px, 20), 361u);
    const std::string mm = written(figure, {}, "b.PNG");
    EXPECT_EQ(big_endian(mm, 16), 992u);
    EXPECT_EQ(mm.substr(37, 4), "pHYs");
    EXPECT_EQ(big_endian(mm, 41), 11811u);
    EXPECT_NO_FATAL_FAILURE(load(folder / "b.PNG"));
    EXPECT_EQ(files(), 2u);
}

TEST_F(FigureFiles, WritingTwiceGivesTheSameBytes) {
    const Figure figure = sample_figure(3, LegendPlace::inside);
    for (const std::string ending : {".png", ".svg", ".pdf"}) {
        const std::string first = written(figure, {}, "a" + ending);
        EXPECT_FALSE(first.empty());
        EXPECT_EQ(first, written(figure, {}, "b" + ending)) << ending;
    }
    // Nor does the hour show, which cairo would write into a PDF.
    const std::string before = read(folder / "a.pdf");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    EXPECT_EQ(before, written(figure, {}, "a.pdf"));
}

TEST_F(FigureFiles, SvgKeepsItsTextAndEmbedsTheFont) {
    const std::string svg = written(sample_figure(2, LegendPlace::outside), {}, "a.svg");
    EXPECT_NE(svg.find("width=\"84mm\""), std::string::npos);
    EXPECT_NE(svg.find(">(b) step 12</text>"), std::string::npos);
    EXPECT_NE(svg.find(">\u03c1 = 0.37 &amp; &lt;\u03b6&gt;</text>"), std::string::npos);
    EXPECT_NE(svg.find("@font-face"), std::string::npos);
    EXPECT_NE(svg.find("base64,AAEAAAA"), std::string::npos);  // a TrueType file
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    for (std::size_t at = svg.find("stroke-width:"); at != std::string::npos; at = svg.find("stroke-width:", at + 1))
        EXPECT_GE(std::stod(svg.substr(at + 13)), 0.5);
    if (!has("xmllint")) GTEST_SKIP() << "xmllint (libxml2-utils) is not installed";
    output("xmllint --noout a.svg");
}

TEST_F(FigureFiles, StrangeTextsGiveValidFiles) {
    Figure figure = sample_figure(1, LegendPlace::outside);
    figure.caption = "]]> & \"quotes\" '\x01\x02' \xff\xfe <svg> \U0001F600 \u05d0\u05d1 e\u0301 \u65e5\u672c";
    figure.panels[0].title = "   ";
    figure.panels[0].list.labels[0].text = "a\nb\t\xc3";
    for (const std::string ending : {".png", ".svg", ".pdf"}) EXPECT_FALSE(written(figure, {}, "a" + ending).empty());
    if (!has("xmllint")) GTEST_SKIP() << "xmllint (libxml2-utils) is not installed";
    output("xmllint --noout a.svg");
}

TEST_F(FigureFiles, PdfHasSelectableTextAndEmbeddedFonts) {
    write_figure(sample_figure(2, LegendPlace::outside), {}, folder / "a.pdf");
    if (!has("pdffonts") || !has("pdftotext")) GTEST_SKIP() << "poppler-utils is not installed";
    std::istringstream fonts(output("pdffonts a.pdf"));
    std::string line;
    std::getline(fonts, line);
    const std::size_t emb = line.find("emb"), uni = line.find("uni");
    std::getline(fonts, line);
    int listed = 0;
    while (std::getline(fonts, line)) {
        ++listed;
        EXPECT_NE(line.find("DejaVuSans"), std::string::npos);
        EXPECT_EQ(line.substr(emb, 3), "yes");
        EXPECT_EQ(line.substr(uni, 3), "yes");
    }
    EXPECT_GT(listed, 0);
    const std::string text = output("pdftotext a.pdf -");
    for (const std::string part :
         {"\u03b5\u2085\u2080\u2080 = |V\u2229T| / |V|", "0.41 \u2192 0.93", "visible, \u03b6 = 1"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(count(text, "accumulated solidity \u03c1"), 1u);
}

TEST_F(FigureFiles, TheFormatsLookAlike) {
    const Figure figure = sample_figure(2, LegendPlace::outside);
    write_figure(figure, pixels(640, 480), folder / "a.png");
    write_figure(figure, pixels(640, 480), folder / "a.svg");
    write_figure(figure, pixels(640, 480), folder / "a.pdf");
    if (!has("rsvg-convert") || !has("pdftoppm")) GTEST_SKIP() << "librsvg2-bin or poppler-utils is not installed";
    output("rsvg-convert a.svg -o svg.png");
    output("pdftoppm -r 96 -png -singlefile a.pdf pdf");
    const Image png = load(folder / "a.png"), svg = load(folder / "svg.png"), pdf = load(folder / "pdf.png");
    EXPECT_EQ(cairo_image_surface_get_width(svg.get()), 640);
    EXPECT_LT(pixel_difference(png, svg), 2);
    EXPECT_LT(pixel_difference(png, pdf), 6);  // poppler moves thin lines to whole pixels
    // The measure tells figures apart.
    write_figure(sample_figure(1, LegendPlace::outside), pixels(640, 480), folder / "other.png");
    EXPECT_GT(pixel_difference(png, load(folder / "other.png")), 10);
}

TEST_F(FigureFiles, SeveralPagesGoIntoOnePdf) {
    std::vector<Figure> pages(3, sample_figure(1, LegendPlace::outside));
    const MakePage page = [&](std::size_t i) { return pages[i]; };
    write_figure_pages(pages, page, {}, folder / "film.pdf");
    EXPECT_THROW(write_figure_pages(pages, page, {}, folder / "film.svg"), InputError);
    EXPECT_THROW(write_figure_pages({}, page, {}, folder / "none.pdf"), InputError);
    EXPECT_EQ(files(), 1u);
    if (!has("pdfinfo")) GTEST_SKIP() << "poppler-utils is not installed";
    const std::string info = output("pdfinfo film.pdf");
    EXPECT_NE(info.find("Pages:"), std::string::npos);
    EXPECT_EQ(info.substr(info.find_first_not_of(' ', info.find("Pages:") + 6), 2), "3\n");
}

TEST_F(FigureFiles, OtherEndingsAreRefusedWithTheSupportedOnes) {
    const Figure figure = sample_figure(1, LegendPlace::off);
    for (const std::string name : {"a.gif", "a", "a.png.txt", ".svg"}) {
        EXPECT_THROW(write_figure(figure, {}, folder / name), InputError);
        const std::string what = message([&] { write_figure(figure, {}, folder / name); });
        EXPECT_NE(what.find(".png, .svg or .pdf"), std::string::npos) << what;
    }
    EXPECT_EQ(files(), 0u);
}

TEST_F(FigureFiles, UnwritableTargetsSayWhereAndWhyAndLeaveNothing) {
    const Figure figure = sample_figure(1, LegendPlace::off);
    std::ofstream(folder / "file") << "x";
    fs::create_directory(folder / "folder.png");
    for (const fs::path& path : {folder / "missing/a.png", folder / "file/a.svg", folder / "folder.png"}) {
        EXPECT_THROW(write_figure(figure, {}, path), WorkError);
        const std::string what = message([&] { write_figure(figure, {}, path); });
        EXPECT_NE(what.find(path.string()), std::string::npos) << what;
        EXPECT_NE(what.find("folder"), std::string::npos) << what;
    }
    EXPECT_EQ(files(), 2u);
    // A name longer than the file system takes fails only at the rename.
    EXPECT_THROW(write_figure(figure, {}, folder / (std::string(300, 'a') + ".pdf")), WorkError);
    EXPECT_EQ(files(), 2u);
}

TEST_F(FigureFiles, AFailureLeavesTheOldFile) {
    const Figure figure = sample_figure(1, LegendPlace::off);
    const std::string before = written(figure, {}, "a.png");
    FigureSize size;
    size.width_mm = 1999;
    EXPECT_THROW(write_figure(figure, size, folder / "a.png"), InputError);  // more than 20000 px
    EXPECT_EQ(read(folder / "a.png"), before);
    EXPECT_NO_THROW(write_figure(figure, size, folder / "a.svg"));
}

TEST_F(FigureFiles, PixelsShowTheShapes) {
    Figure figure;
    DrawList list;
    list.world = {Vec<2>(0), Vec<2>(1)};
    list.styles = {{"fill", {10, 200, 30}, Hatch::none, transparent, transparent, 0.5, Dash::solid}};
    list.add(ShapeKind::polygon, 0, {{0, 0.5}, {5, 0.5}, {5, 5}, {0, 5}});
    figure.panels.push_back({list, ""});
    write_figure(figure, pixels(200, 200), folder / "a.png");
    const Image image = load(folder / "a.png");
    const auto pixel = [&](int x, int y) {
        const unsigned char* p =
            cairo_image_surface_get_data(image.get()) + y * cairo_image_surface_get_stride(image.get()) + 4 * x;
        return Colour{p[2], p[1], p[0]};
    };
    EXPECT_EQ(pixel(100, 50), (Colour{10, 200, 30}));  // y points up
    EXPECT_EQ(pixel(100, 150), (Colour{255, 255, 255}));
    EXPECT_EQ(pixel(198, 50), (Colour{255, 255, 255}));  // clipped to the panel
}

TEST_F(FigureFiles, FiftyThousandShapesAreQuickAndCompact) {
    DrawList list;
    list.world = {Vec<2>(0), Vec<2>(1)};
    list.styles = {{"a", {200, 220, 240}, Hatch::none, transparent, {90, 90, 90}, 0.5, Dash::solid},
                   {"b", transparent, Hatch::none, transparent, {200, 0, 0}, 0.5, Dash::solid}};
    for (int i = 0; i < 50000; ++i) {
        const Vec<2> a((i % 250) / 250.0, (i / 250) / 200.0);
        if (i % 2 == 0)
            list.add(ShapeKind::polygon, 0, {a, a + Vec<2>(0.004, 0), a + Vec<2>(0.004, 0.005)});
        else
            list.add(ShapeKind::polyline, 1, {a, a + Vec<2>(0.004, 0.005)});
    }
    Figure figure;
    figure.panels.push_back({list, ""});
    const auto start = std::chrono::steady_clock::now();
    const std::string svg = written(figure, {}, "a.svg");
    written(figure, {}, "a.png");
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(svg.size(), 60u * 50000u);
    // 0.4 s when optimised on an idle machine; loose, for sanitizers and busy ones.
    EXPECT_LT(took.count(), 20);
}

}  // namespace
}  // namespace sightline
