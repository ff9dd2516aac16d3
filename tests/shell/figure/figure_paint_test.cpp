// What painting asks of a canvas, noted down.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shell/figure/lay_out.h"
#include "shell/figure/paint.h"
#include "tests/shell/figure/figure_samples.h"

namespace sightline {
namespace {

struct Entry {
    enum { path, circle, gradient, image, text } kind;
    Path outline;
    Vec<2> centre{};
    double radius = 0;
    Pen pen;
    TextRun run;
    bool clipped = false;
};

class Notebook final : public Canvas {
public:
    std::vector<Entry> notes;
    std::vector<Rect> clips;

    void clip(const Rect& rect) override { clips.push_back(rect), clipped_ = true; }
    void unclip() override { clipped_ = false; }
    void draw(const Path& path, const Pen& pen) override {
        notes.push_back({Entry::path, path, {}, 0, pen, {}, clipped_});
    }
    void circle(const Vec<2>& c, double r, const Pen& pen) override {
        notes.push_back({Entry::circle, {}, c, r, pen, {}, clipped_});
    }
    void gradient(const Rect&, std::span<const Colour>) override {
        notes.push_back({Entry::gradient, {}, {}, 0, {}, {}, clipped_});
    }
    void image(const Rect&, const DrawImage&) override { notes.push_back({Entry::image, {}, {}, 0, {}, {}, clipped_}); }
    void text(const TextRun& run, const Colour& colour, const Colour&) override {
        notes.push_back({Entry::text, {}, {}, 0, {colour}, run, clipped_});
    }

private:
    bool clipped_ = false;
};

struct Painted {
    Layout layout;
    Notebook book;

    /// What was drawn in the panels.
    std::vector<Entry> inside() const {
        std::vector<Entry> found;
        for (const Entry& note : book.notes)
            if (note.clipped) found.push_back(note);
        return found;
    }
};

Painted painted(const Figure& figure, double width_mm = 84) {
    static const Font font = find_font();
    FigureSize size;
    size.width_mm = width_mm;
    Painted p{lay_out({&figure, 1}, size, font).front(), {}};
    paint(p.book, figure, p.layout, font);
    return p;
}

Figure figure_of(const DrawList& list) {
    Figure figure;
    figure.panels.push_back({list, ""});
    return figure;
}

TEST(FigurePaint, EveryStrokeIsHalfAPointOrMore) {
    const Painted p = painted(sample_figure(3, LegendPlace::inside), 174);
    int strokes = 0;
    for (const Entry& note : p.book.notes) {
        if (note.pen.stroke.a == 0) continue;
        ++strokes;
        EXPECT_GE(note.pen.width, 0.5);
    }
    EXPECT_GT(strokes, 30);
    EXPECT_EQ(p.book.clips.size(), 3u);
    EXPECT_EQ(p.book.clips[1].x, p.layout.panels[1].frame.x);
}

TEST(FigurePaint, FarPointsAreCutAndShapesOutsideSkipped) {
    DrawList list;
    list.world = {Vec<2>(0), Vec<2>(1)};
    list.styles = {{"s", {1, 2, 3}, Hatch::diagonal, {0, 0, 0}, {9, 9, 9}, 0.5, Dash::solid}};
    list.add(ShapeKind::polygon, 0, {{-1e9, -1e9}, {1e9, -1e9}, {0, 1e9}});
    list.add(ShapeKind::polyline, 0, {{0.5, 0.5}, {1e15, 1e14}});
    list.add(ShapeKind::arrow, 0, {{-1e12, 0.5}, {0.5, 0.5}}, 5);
    const std::size_t drawn = painted(figure_of(list)).inside().size();
    EXPECT_EQ(drawn, 3u + 1u + 2u);  // fill, hatch, outline; line; line and head

    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    list.add(ShapeKind::polygon, 0, {{2, 2}, {3, 2}, {3, 3}});
    list.add(ShapeKind::polyline, 0, {{-1, -1}, {-2, 5}});
    list.add(ShapeKind::disc, 0, {{1.5, 0.5}}, 3);
    list.add(ShapeKind::polygon, 0, {{0, 0}, {inf, 0}, {0, 1}});
    list.add(ShapeKind::polyline, 0, {{0, nan}, {1, 1}});
    list.add(ShapeKind::polygon, 0, {{0, 0}, {1, 1}});   // too few points
    list.add(ShapeKind::polyline, 7, {{0, 0}, {1, 1}});  // no such style
    list.shapes.push_back({ShapeKind::polygon, 0, 1000000, 3, 0});
    list.labels.push_back({{5, 5}, {0, 0}, "outside", TextAlign::centre, 1, {0, 0, 0}, transparent, {}});
    const Painted p = painted(figure_of(list));
    EXPECT_EQ(p.inside().size(), drawn);
    for (const Entry& note : p.inside())
        for (const Vec<2>& at : note.outline.points) EXPECT_TRUE(p.layout.panels[0].frame.grown(21).contains(at));
}

TEST(FigurePaint, ArrowsEndAtTheirTip) {
    DrawList list;
    list.world = {Vec<2>(0), Vec<2>(1)};
    list.styles = {{"s", transparent, Hatch::none, transparent, {9, 9, 9}, 1, Dash::solid}};
    list.add(ShapeKind::arrow, 0, {{0.2, 0.5}, {0.6, 0.5}, {0.6, 0.5}}, 6);
    const Painted p = painted(figure_of(list));
    const std::vector<Entry> notes = p.inside();
    ASSERT_EQ(notes.size(), 2u);
    const Vec<2> tip = to_page(p.layout.panels[0], p.layout.scale, {0.6, 0.5});
    EXPECT_NEAR(notes[1].outline.points[0].x, tip.x, 1e-9);
    EXPECT_NEAR(notes[1].outline.points[1].x, tip.x - 6, 1e-9);
    EXPECT_LT(notes[0].outline.points.back().x, tip.x - 1);
    EXPECT_GT(notes[0].outline.points.back().x, tip.x - 6);
    EXPECT_EQ(notes[1].pen.fill, (Colour{9, 9, 9}));
}

TEST(FigurePaint, LabelsStayInsideTheirPanelAndCalloutsHoldTheirNumber) {
    DrawList list;
    list.world = {Vec<2>(0), Vec<2>(1)};
    for (const double x : {0.0, 0.5, 1.0})
        for (const double y : {0.0, 0.5, 1.0})
            for (const TextAlign align : {TextAlign::left, TextAlign::centre, TextAlign::right})
                for (const bool disc : {false, true}) {
                    Label label{{x, y}, {3, -2}, "ρ 128", align, 1, {0, 0, 0}, transparent, {}};
                    if (disc) label.disc = Colour{200, 0, 0};
                    list.labels.push_back(label);
                }
    int texts = 0;
    for (const Label& label : std::vector<Label>(list.labels)) {
        list.labels = {label};  // each alone: several would make room for each other
        const Painted p = painted(figure_of(list));
        const Rect frame = p.layout.panels[0].frame;
        const std::vector<Entry> notes = p.inside();
        for (std::size_t i = 0; i < notes.size(); ++i) {
            if (notes[i].kind == Entry::circle) {
                EXPECT_TRUE(
                    frame.contains(Rect{notes[i].centre.x, notes[i].centre.y, 0, 0}.grown(notes[i].radius), 1e-9));
                EXPECT_GT(2 * notes[i].radius, notes[i + 1].run.width);
                EXPECT_NEAR(notes[i + 1].run.left() + notes[i + 1].run.width / 2, notes[i].centre.x, 1e-9);
                continue;
            }
            const TextRun& run = notes[i].run;
            ++texts;
            EXPECT_TRUE(
                frame.contains(Rect{run.left(), run.baseline - 0.75 * run.size, run.width, 0.9 * run.size}, 1e-9));
        }
    }
    EXPECT_EQ(texts, 54);
    // In the middle nothing has to move: x right, y up.
    list.labels = {{{0.5, 0.5}, {3, -2}, "x", TextAlign::left, 1, {0, 0, 0}, transparent, {}}};
    const Painted q = painted(figure_of(list));
    const Vec<2> at = to_page(q.layout.panels[0], q.layout.scale, {0.5, 0.5});
    EXPECT_NEAR(q.inside()[0].run.left(), at.x + 3, 1e-9);
    EXPECT_GT(q.inside()[0].run.baseline, at.y + 2);
}

TEST(FigurePaint, ShapesKeepTheirOrderAndLabelsComeLast) {
    DrawList list = sample_list();
    const Painted p = painted(figure_of(list));
    bool text = false;
    for (const Entry& note : p.inside()) {
        text |= note.kind == Entry::text;
        if (text) {
            EXPECT_NE(note.kind, Entry::path);
        }
    }
    EXPECT_TRUE(text);
}

}  // namespace
}  // namespace sightline
