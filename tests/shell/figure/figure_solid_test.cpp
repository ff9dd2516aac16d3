// Solids in figures: images of the right size under labels that stay text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cairo/cairo.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "core/base/file.h"
#include "core/raster/image_plane.h"
#include "shell/figure/cover.h"
#include "shell/figure/figure.h"
#include "shell/figure/lay_out.h"
#include "shell/gl/solid_renderer.h"
#include "tests/draw/solid_samples.h"
#include "tests/shell/gl/gl_support.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

/// What a DrawSolid was asked for.
struct Asked {
    int width = 0, height = 0;
    double px_per_pt = 0;
};

/// Different at neighbouring pixels, and opaque in the file whatever its a.
Colour pattern(int x, int y) {
    return {static_cast<std::uint8_t>(37 * x + 11 * y), static_cast<std::uint8_t>(5 * x),
            static_cast<std::uint8_t>(91 * y), static_cast<std::uint8_t>(x + y)};
}

struct FakeRenderer {
    std::vector<Asked> asked;

    DrawSolid draw() {
        return [this](const SolidList&, int width, int height, double px_per_pt) {
            asked.push_back({width, height, px_per_pt});
            Pixels pixels{width, height, {}};
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) pixels.colours.push_back(pattern(x, y));
            return pixels;
        };
    }
};

/// One panel with a solid, a label and a line over it.
Figure solid_figure(double aspect = 1.5) {
    SolidList solid;
    solid.camera = make_view({{0, -10, 0}, {0, 0, 0}, 60}, aspect);
    Figure figure;
    Figure::Panel panel;
    panel.list.world = {{0, 0}, {aspect, 1}};
    panel.list.styles.resize(1);
    panel.list.styles[0].stroke = {255, 0, 0};
    panel.list.add(ShapeKind::polyline, 0, {{0.1, 0.1}, {0.2, 0.1}});
    panel.list.labels.emplace_back();
    panel.list.labels[0].at = {0.75, 0.5};
    panel.list.labels[0].text = "cell 12";
    panel.title = "a solid";
    panel.solid = std::make_shared<const SolidList>(solid);
    figure.panels.push_back(panel);
    return figure;
}

FigureSize solid_pixels(int width, int height) {
    FigureSize size;
    size.width_px = width;
    size.height_px = height;
    return size;
}

class FigureSolids : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::string written(const Figure& figure, const FigureSize& size, const std::string& name) {
        write_figure(figure, size, folder / name, renderer.draw());
        return read_file(folder / name);
    }
    Pixels load(const std::string& name) const {
        const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
            cairo_image_surface_create_from_png((folder / name).c_str()), cairo_surface_destroy);
        Pixels p{cairo_image_surface_get_width(image.get()), cairo_image_surface_get_height(image.get()), {}};
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const unsigned char* at =
                    cairo_image_surface_get_data(image.get()) + y * cairo_image_surface_get_stride(image.get()) + 4 * x;
                p.colours.push_back({at[2], at[1], at[0]});
            }
        return p;
    }
    std::string output(const std::string& command) const {
        EXPECT_EQ(std::system(("cd '" + folder.string() + "' && " + command + " > output.txt").c_str()), 0) << command;
        return read_file(folder / "output.txt");
    }
    std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder), {}); }
    static bool has(const std::string& program) {
        return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
    }

    fs::path folder = fs::temp_directory_path() / ("sightline-solids-" + std::to_string(getpid()));
    FakeRenderer renderer;
};

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

Layout layout_of(const Figure& figure, const FigureSize& size) {
    return lay_out({&figure, 1}, size, find_font()).front();
}

TEST_F(FigureSolids, APngHasTheVeryPixelsWhereNothingLiesOnThem) {
    for (const FigureSize& size :
         {solid_pixels(300, 217), solid_pixels(640, 480), FigureSize{}, FigureSize{61, 0, 0, 8, 250}}) {
        renderer.asked.clear();
        const Figure figure = solid_figure();
        written(figure, size, "a.png");
        ASSERT_EQ(renderer.asked.size(), 1u);
        const auto [width, height, px_per_pt] = renderer.asked[0];
        const Layout layout = layout_of(figure, size);
        const Rect frame = layout.panels[0].frame;
        EXPECT_DOUBLE_EQ(px_per_pt, size.width_px > 0 ? 96 / 72.0 : size.dpi / 72);
        EXPECT_NEAR(width, frame.w * px_per_pt, 1);
        EXPECT_NEAR(height, frame.h * px_per_pt, 1);
        const Rect place =
            pixel_rect(world_on_page(figure.panels[0].list, layout.panels[0], layout.scale), px_per_pt).rect;
        const int left = static_cast<int>(std::lround(place.x * px_per_pt)),
                  top = static_cast<int>(std::lround(place.y * px_per_pt));
        EXPECT_NEAR(left, frame.x * px_per_pt, 0.501);
        EXPECT_NEAR(top, frame.y * px_per_pt, 0.501);
        const Pixels p = load("a.png");
        std::size_t same = 0, all = 0, border = 0;
        for (int y = 2; y < height - 2; ++y)
            for (int x = 2; x < width - 2; ++x) {
                Colour wanted = pattern(x, y);
                wanted.a = 255;
                const bool equal = p.at(left + x, top + y) == wanted;
                // The lower part of the panel, right of the line, is free.
                const bool free = y > 0.7 * height && x > 0.25 * width;
                EXPECT_TRUE(equal || !free) << x << ' ' << y;
                same += equal;
                ++all;
                border += !equal && (x < 3 || y < 3);
            }
        EXPECT_LT(same, all);  // the label and the line
        EXPECT_GT(static_cast<double>(same), 0.9 * static_cast<double>(all));
        EXPECT_EQ(border, 0u);
    }
}

/// The first bytes of what the text says in base 64.
std::string decoded(const std::string& text, std::size_t bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    unsigned bits = 0, have = 0;
    for (std::size_t i = 0; i < text.size() && out.size() < bytes; ++i) {
        bits = bits << 6 | static_cast<unsigned>(digits.find(text[i]));
        if ((have += 6) >= 8) out += static_cast<char>(bits >> (have -= 8) & 255);
    }
    return out;
}

TEST_F(FigureSolids, AnSvgHoldsOneImageUnderItsLabels) {
    for (const FigureSize& size : {FigureSize{}, solid_pixels(400, 300)}) {
        renderer.asked.clear();
        const Figure figure = solid_figure();
        const std::string svg = written(figure, size, "a.svg");
        EXPECT_EQ(occurrences(svg, "<image"), 1u);
        const std::size_t image = svg.find("<image"), label = svg.find(">cell 12</text>"),
                          line = svg.find("<path", image);
        ASSERT_NE(image, std::string::npos);
        ASSERT_NE(label, std::string::npos);
        EXPECT_LT(image, label);
        EXPECT_LT(line, label);
        EXPECT_NE(svg.find("xmlns:xlink"), std::string::npos);
        const Rect frame = layout_of(figure, size).panels[0].frame;
        const auto number = [&](const char* name) {
            return std::stod(
                svg.substr(svg.find(std::string(" ") + name + "=\"", image) + std::string(name).size() + 3));
        };
        const double px = 72.0 / 300;
        EXPECT_NEAR(number("x"), frame.x, px);
        EXPECT_NEAR(number("y"), frame.y, px);
        EXPECT_NEAR(number("width"), frame.w, px);
        EXPECT_NEAR(number("height"), frame.h, px);
        ASSERT_EQ(renderer.asked.size(), 1u);
        EXPECT_NEAR(renderer.asked[0].width, frame.w / px, 1);
        EXPECT_NEAR(renderer.asked[0].height, frame.h / px, 1);
        EXPECT_NEAR(renderer.asked[0].px_per_pt, 1 / px, 1e-9);
        const std::size_t data = svg.find("base64,", image) + 7;
        const std::string header = decoded(svg.substr(data, 100), 24);
        EXPECT_EQ(header.substr(1, 3), "PNG");
        const auto big_endian = [&](std::size_t at) {
            int value = 0;
            for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(header[i]);
            return value;
        };
        EXPECT_EQ(big_endian(16), renderer.asked[0].width);
        EXPECT_EQ(big_endian(20), renderer.asked[0].height);
    }
    Figure flat = solid_figure();
    flat.panels[0].solid = nullptr;
    const std::string svg = written(flat, {}, "b.svg");
    EXPECT_EQ(occurrences(svg, "<image") + occurrences(svg, "xlink"), 0u);
}

TEST_F(FigureSolids, OtherProgramsSeeTheImageInAnSvg) {
    if (!has("rsvg-convert")) GTEST_SKIP() << "no rsvg-convert";
    DrawSolid draw = [](const SolidList&, int width, int height, double) {
        Pixels p{width, height, {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                p.colours.push_back(2 * y < height ? Colour{200, 30, 10} : Colour{0, 90, 200});
        return p;
    };
    write_figure(solid_figure(), solid_pixels(300, 200), folder / "a.svg", draw);
    output("rsvg-convert a.svg -o b.png");
    const Pixels p = load("b.png");
    EXPECT_EQ(p.at(60, 60), (Colour{200, 30, 10}));
    EXPECT_EQ(p.at(240, 160), (Colour{0, 90, 200}));
}

TEST_F(FigureSolids, APdfHoldsAnOpaqueImageAndText) {
    if (!has("pdfimages") || !has("pdftotext")) GTEST_SKIP() << "no poppler-utils";
    const Figure figure = solid_figure();
    const std::array<Figure, 2> pages{figure, figure};
    written(figure, {}, "a.pdf");
    write_figure_pages(
        pages, [&](std::size_t i) { return pages[i]; }, {}, folder / "b.pdf", renderer.draw());
    ASSERT_EQ(renderer.asked.size(), 3u);
    const std::string size =
        " +" + std::to_string(renderer.asked[0].width) + " +" + std::to_string(renderer.asked[0].height) + " +rgb";
    for (const auto& [file, images] : {std::pair("a.pdf", "1"), std::pair("b.pdf", "2")}) {
        const std::string name = file;
        EXPECT_EQ(output("pdfimages -list " + name + " | grep -cE ' image" + size + "'"), std::string(images) + "\n");
        EXPECT_EQ(occurrences(output("pdfimages -list " + name), "mask"), 0u);
        EXPECT_NE(output("pdftotext " + name + " -").find("cell 12"), std::string::npos);
    }
}

TEST_F(FigureSolids, TheSameFigureIsTheSameBytes) {
    for (const std::string name : {"a.png", "a.svg", "a.pdf"})
        EXPECT_TRUE(written(solid_figure(), {}, name) == written(solid_figure(), {}, "b" + name)) << name;
}

TEST_F(FigureSolids, FilmsAskForEachFrame) {
    const std::array<Figure, 3> pages{solid_figure(), solid_figure(), solid_figure()};
    write_figure_frames(
        pages, [&](std::size_t i) { return pages[i]; }, solid_pixels(100, 80),
        [&](std::size_t i) { return folder / (std::to_string(i) + ".png"); }, renderer.draw());
    EXPECT_EQ(renderer.asked.size(), 3u);
    EXPECT_EQ(read_file(folder / "0.png"), read_file(folder / "2.png"));
}

TEST_F(FigureSolids, TheImageFillsTheListsWorldOnly) {
    // Beside a large panel a thin one shows more than its world.
    Figure figure = solid_figure();
    Figure::Panel thin;
    thin.list.world = {{0, 0}, {1.5, 0.01}};
    thin.solid = figure.panels[0].solid;
    figure.panels.push_back(thin);
    written(figure, solid_pixels(500, 500), "a.png");
    ASSERT_EQ(renderer.asked.size(), 2u);
    EXPECT_EQ(renderer.asked[0].width, renderer.asked[1].width);
    EXPECT_NEAR(renderer.asked[1].height, renderer.asked[1].width / 150.0, 1);
    // A world without area takes the frame.
    figure.panels[1].list.world = {{3, 3}, {3, 3}};
    written(figure, solid_pixels(500, 500), "a.png");
    EXPECT_GT(renderer.asked[3].height, 3);
}

TEST_F(FigureSolids, LargeFiguresAskForNoMoreThanCanBeDrawn) {
    Figure figure = solid_figure(40);
    FigureSize size;
    size.width_mm = 1500;
    written(figure, size, "a.png");
    ASSERT_EQ(renderer.asked.size(), 1u);
    EXPECT_EQ(renderer.asked[0].width, 8192);
    EXPECT_NEAR(renderer.asked[0].height, 8192 / 40, 1);
    EXPECT_NEAR(renderer.asked[0].px_per_pt, 8192 / (1500 * 72 / 25.4), 0.01);
}

TEST_F(FigureSolids, TinyFiguresHaveTinyImages) {
    Figure figure = solid_figure();
    figure.panels[0].title.clear();
    written(figure, solid_pixels(1, 1), "a.png");
    ASSERT_EQ(renderer.asked.size(), 1u);
    EXPECT_GE(renderer.asked[0].width, 1);
    EXPECT_LE(renderer.asked[0].width, 2);
}

TEST_F(FigureSolids, WithoutARendererNothingIsWritten) {
    write_file(folder / "a.png", "old");
    for (const std::string name : {"a.png", "a.svg", "a.pdf"})
        EXPECT_THROW(write_figure(solid_figure(), {}, folder / name), WorkError) << name;
    const DrawSolid broken = [](const SolidList&, int, int, double) -> Pixels { throw WorkError("no card"); };
    EXPECT_THROW(write_figure(solid_figure(), {}, folder / "a.png", broken), WorkError);
    const DrawSolid wrong = [](const SolidList&, int, int, double) { return Pixels{1, 1, {Colour{}}}; };
    EXPECT_THROW(write_figure(solid_figure(), {}, folder / "a.png", wrong), WorkError);
    EXPECT_EQ(read_file(folder / "a.png"), "old");
    EXPECT_EQ(files(), 1);
}

/// No file of this process may grow beyond a limit: as if the disk were full.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST_F(FigureSolids, AFullDiskLeavesTheOldFileAndNoHalfOne) {
    write_file(folder / "a.png", "old");
    for (const std::string name : {"a.png", "b.svg", "c.pdf"}) {
        const FullDisk full(4000);
        EXPECT_THROW(write_figure(solid_figure(), {}, folder / name, renderer.draw()), WorkError) << name;
    }
    EXPECT_THROW(write_figure(solid_figure(), {}, "/dev/full", renderer.draw()), InputError);  // it has no ending
    EXPECT_EQ(read_file(folder / "a.png"), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(FigureSolids, TheLegendStandsWhereTheSolidIsNot) {
    for (int corner = 0; corner < 4; ++corner)
        for (const bool triangles : {false, true}) {
            Figure figure = solid_figure();
            figure.panels[0].list.labels.clear();
            figure.panels[0].list.shapes.clear();
            figure.legend.resize(2);
            figure.legend[0].text = "one";
            figure.legend[1].text = "two";
            figure.legend_place = LegendPlace::inside;
            SolidList solid = *figure.panels[0].solid;
            solid.styles.resize(1);
            // Three of the corners are full; some of it lies behind the eye.
            std::vector<Primitive<3>> boxes;
            for (int other = 0; other < 4; ++other) {
                const double x = other & 1 ? 5.5 : -5.5, z = other & 2 ? 3.5 : -3.5;
                if (other != corner) test::add_box(boxes, {x - 3, -30, z - 2}, {x + 3, 0, z + 2});
            }
            if (triangles) {
                Scene<3> scene;
                scene.primitives = boxes;
                test::show_scene(solid, 0, std::make_shared<const Scene<3>>(scene));
            } else {
                for (const Primitive<3>& t : boxes) test::add_face(solid, 0, {t[0], t[1], t[2]});
            }
            figure.panels[0].solid = std::make_shared<const SolidList>(solid);
            const Layout layout = layout_of(figure, FigureSize{});
            ASSERT_TRUE(layout.legend_box);
            const Rect frame = layout.panels[0].frame, box = *layout.legend_box;
            EXPECT_EQ(box.x + box.w / 2 > frame.x + frame.w / 2, (corner & 1) != 0) << corner << triangles;
            EXPECT_EQ(box.y + box.h / 2 < frame.y + frame.h / 2, (corner & 2) != 0) << corner << triangles;
        }
}

TEST_F(FigureSolids, WhatLiesBehindTheEyeCoversNothing) {
    Figure figure = solid_figure();
    SolidList solid = *figure.panels[0].solid;  // its eye is at y = -10 and looks along y
    test::add_face(solid, 0, {{2, 0, 0}, {2, -40, 0}, {2, -40, 0.001}});
    test::add_face(solid, 0, {{-3, -40, 0}, {-3, -40, 1}, {-2, -40, 1}});
    Figure::Panel panel;
    panel.list.world = figure.panels[0].list.world;
    panel.solid = std::make_shared<const SolidList>(solid);
    const Layout layout = layout_of(figure, FigureSize{});
    const Rect frame = layout.panels[0].frame;
    const auto side = [&](double x) {
        const Rect box{frame.x + x, frame.y, frame.w / 2, frame.h};
        return covered(panel, layout.panels[0], layout, find_font(), box);
    };
    EXPECT_GT(side(frame.w / 2), 1);
    EXPECT_EQ(side(0), 0);
}

class FigureSolidsDrawn : public test::GlTest {};

TEST_F(FigureSolidsDrawn, WhatTheListSaysOfAPointLiesOnItAndBytesRepeat) {
    const fs::path folder = fs::temp_directory_path() / ("sightline-solids-gl-" + std::to_string(getpid()));
    fs::create_directories(folder);
    SolidRenderer renderer;
    const DrawSolid draw = [&](const SolidList& list, int width, int height, double px_per_pt) {
        return renderer.picture(list, width, height, px_per_pt);
    };
    Figure figure = solid_figure();
    SolidList solid;
    solid.camera = make_view({{5, -8, 3}, {0, 0, 0}, 50}, 1.5);
    solid.styles = {{"dot", {0, 0, 0}, false, 6}};
    const Vec<3> p(1.1, 0.4, -0.7);
    test::add_edge(solid, 0, p, p);
    Figure::Panel& panel = figure.panels[0];
    panel.solid = std::make_shared<const SolidList>(solid);
    const Vec<3> q = image_plane(solid.camera).project(p);
    const Vec<2> at((q.x / q.z + 1) / 2 * 1.5, (q.y / q.z + 1) / 2);
    panel.list.labels.clear();
    panel.list.shapes.clear();
    panel.list.styles[0].fill = {255, 255, 255};
    panel.list.styles[0].stroke = transparent;
    panel.list.add(ShapeKind::disc, 0, {at}, 2.6);  // hides the dot but for a thin ring
    FigureSize size;
    size.dpi = 144;
    write_figure(figure, size, folder / "a.png", draw);
    write_figure(figure, size, folder / "b.png", draw);
    EXPECT_TRUE(read_file(folder / "a.png") == read_file(folder / "b.png"));
    const Layout layout = lay_out({&figure, 1}, size, find_font()).front();
    const Vec<2> middle = to_page(layout.panels[0], layout.scale, at) * 2.0;  // pixels
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
        cairo_image_surface_create_from_png((folder / "a.png").c_str()), cairo_surface_destroy);
    // The ring of 6 pixels' radius is even all round.
    double ring = 0;
    Vec<2> pull(0);
    for (int y = -9; y <= 9; ++y)
        for (int x = -9; x <= 9; ++x) {
            const int px = static_cast<int>(middle.x) + x, py = static_cast<int>(middle.y) + y;
            const unsigned char* c =
                cairo_image_surface_get_data(image.get()) + py * cairo_image_surface_get_stride(image.get()) + 4 * px;
            const double dark = 1 - c[1] / 255.0;
            ring += dark;
            pull += dark * (Vec<2>(px + 0.5, py + 0.5) - middle);
        }
    EXPECT_NEAR(ring, 3.14159 * (36 - 5.2 * 5.2), 6);
    EXPECT_LT(std::abs(pull.x / ring), 2.5);  // half a pixel off would make it 3
    EXPECT_LT(std::abs(pull.y / ring), 2.5);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace sightline
