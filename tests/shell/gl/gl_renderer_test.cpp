// What the renderer puts where, read back off screen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/draw/picture.h"
#include "tests/session/session_support.h"
#include "tests/shell/gl/gl_support.h"

namespace sightline {
namespace {

using namespace test;

class GlRenderer : public GlTest {};

DrawList styled_list(const std::vector<Style>& styles) {
    DrawList list;
    list.world = {{0, 0}, {100, 100}};
    list.styles = styles;
    return list;
}

void flat_square(DrawList& list, std::uint16_t style, double from, double to) {
    list.add(ShapeKind::polygon, style, {{from, from}, {to, from}, {to, to}, {from, to}});
}

TEST_F(GlRenderer, FillsLieInTheirOrderAndNowhereElse) {
    DrawList list = styled_list({filled(red), filled(blue)});
    flat_square(list, 0, 10, 50);
    flat_square(list, 1, 40, 80);
    flat_square(list, 0, 60, 70);
    const Pixels p = drawn(list, plain_view(100, 100), 100, 100);
    EXPECT_EQ(p.at(20, 79), red);  // rows from the top
    EXPECT_EQ(p.at(45, 54), blue);
    EXPECT_EQ(p.at(65, 34), red);
    EXPECT_EQ(p.at(75, 24), blue);
    EXPECT_EQ(p.at(9, 79), white);
    EXPECT_EQ(p.at(10, 79), red);
    EXPECT_EQ(p.at(20, 20), white);
}

TEST_F(GlRenderer, LaterShapesCoverEarlierOnesAcrossKindsAndRuns) {
    Style both = filled(blue);
    both.stroke = black;
    both.width_pt = 4;
    DrawList list = styled_list({filled(red), stroked(black, 6), both});
    for (int i = 0; i < 600; ++i) flat_square(list, 0, 10, 90);
    for (int i = 0; i < 600; ++i) list.add(ShapeKind::polyline, 1, {{0, 50}, {100, 50}});
    flat_square(list, 2, 40, 60);
    list.add(ShapeKind::disc, 0, {{50, 50}}, 5);
    const Pixels p = drawn(list, plain_view(100, 100), 100, 100);
    EXPECT_EQ(p.at(20, 20), red);
    EXPECT_EQ(p.at(20, 50), black);  // a line over a fill
    EXPECT_EQ(p.at(44, 50), blue);   // a fill over a line
    EXPECT_EQ(p.at(40, 44), black);  // its own stroke over it
    EXPECT_EQ(p.at(50, 50), red);    // a mark over all
}

TEST_F(GlRenderer, NothingIsDrawnOutsideTheViewsRectangle) {
    DrawList list = styled_list({filled(red), stroked(black, 9)});
    flat_square(list, 0, -1000, 1000);
    list.add(ShapeKind::polyline, 1, {{-500, 50}, {500, 50}});
    ListView view = plain_view(40, 30);
    view.x = 20;
    view.y = 10;
    const Pixels p = drawn(list, view, 100, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const bool inside = x >= 20 && x < 60 && y >= 60 && y < 90;
            EXPECT_EQ(p.at(x, y) != white, inside) << x << ' ' << y;
        }
}

/// The ink of a cut across the lines' middles, in pixels.
double width_across(const Pixels& p, int x, int y, int reach, bool down) {
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) sum += ink(down ? p.at(x, y + i) : p.at(x + i, y));
    return sum;
}

TEST_F(GlRenderer, LinesAreAsWideAsTheirPointsSayAtEveryZoom) {
    for (const double width : {0.5, 0.7, 1.0, 1.6, 3.0, 7.5})
        for (const double zoom : {1.0, 37.0, 1e4, 1e6})
            for (const double px_per_pt : {1.0, 2.0}) {
                DrawList list = styled_list({stroked(black, width)});
                list.add(ShapeKind::polyline, 0, {{-300, 50.3}, {400, 50.3}});
                list.add(ShapeKind::polyline, 0, {{50, 50}, {250, 250}});
                const Vec<2> half(50 / zoom, 50 / zoom), middle(50, 50.3);
                const Pixels p = drawn(list, {{middle - half, middle + half}, 0, 0, 100, 100, px_per_pt, 1}, 100, 100);
                EXPECT_NEAR(width_across(p, 20, 50, 25, true), width * px_per_pt, 0.1 + 0.02 * width)
                    << "width " << width << " zoom " << zoom << " pixels per point " << px_per_pt;
                if (zoom == 1) {
                    EXPECT_NEAR(width_across(p, 80, 20, 15, false), width * px_per_pt * std::sqrt(2.0),
                                0.3);  // pixels meet a slanting line where they do
                }
            }
}

TEST_F(GlRenderer, AProjectorsLinesAreWider) {
    DrawList list = styled_list({stroked(black, 2)});
    list.add(ShapeKind::polyline, 0, {{0, 50}, {100, 50}});
    ListView view = plain_view(100, 100);
    view.line_scale = 2;
    EXPECT_NEAR(width_across(drawn(list, view, 100, 100), 50, 50, 20, true), 4, 0.1);
}

TEST_F(GlRenderer, DashesAndDotsAreThoseOfFigures) {
    DrawList list = styled_list({stroked(black, 4, Dash::dashed), stroked(black, 4, Dash::dotted)});
    list.add(ShapeKind::polyline, 0, {{2, 70}, {30, 70}, {98, 70}});  // dashes of 14, gaps of 10
    list.add(ShapeKind::polyline, 1, {{10, 30}, {90, 30}});           // dots 10 apart
    const Pixels p = drawn(list, plain_view(100, 100), 100, 100);
    for (int x = 0; x < 100; ++x) {
        const double at = x + 0.5 - 2, along = std::fmod(at, 24.0);
        if (at < 0 || std::abs(along - 14) < 1 || along < 1 || along > 23 || at > 95) continue;
        EXPECT_EQ(p.at(x, 29), along < 14 ? black : white) << x;
    }
    EXPECT_EQ(p.at(0, 29), white);
    for (int dot = 0; dot < 8; ++dot) {
        EXPECT_LT(p.at(10 + 10 * dot, 70).r, 10) << dot;
        EXPECT_EQ(p.at(15 + 10 * dot, 70), white) << dot;
    }
}

TEST_F(GlRenderer, AHatchHasBothColoursInItsShare) {
    const double pitch = 3.2 * 4, line = 0.5 * 4, half_dot = pitch / 6;
    const std::vector<std::pair<Hatch, double>> shares{
        {Hatch::none, 0},
        {Hatch::diagonal, line / pitch},
        {Hatch::back_diagonal, line / pitch},
        {Hatch::cross, 1 - (1 - line / pitch) * (1 - line / pitch)},
        {Hatch::horizontal, line / pitch},
        {Hatch::dots, 3.14159265 * half_dot * half_dot / (pitch * pitch * 0.8660254)}};
    for (const auto& [hatch, share] : shares) {
        Style style = filled(white);
        style.hatch = hatch;
        style.hatch_colour = black;
        DrawList list = styled_list({style});
        flat_square(list, 0, 0, 200);
        ListView view = plain_view(200, 200);
        view.px_per_pt = 4;
        const Pixels p = drawn(list, view, 200, 200);
        double sum = 0;
        for (const Colour& c : p.colours) sum += ink(c);
        EXPECT_NEAR(sum / 40000, share, 0.03 * share + 0.003) << static_cast<int>(hatch);
        // Rising lines stay on one another a pitch up and right, falling ones do not.
        if (hatch == Hatch::diagonal || hatch == Hatch::back_diagonal) {
            double same = 0;
            for (int i = 0; i < 100; ++i) {
                const bool rising = hatch == Hatch::diagonal;
                same += std::abs(ink(p.at(60, 100)) - ink(p.at(rising ? 60 + i : 60 - i, 100 - i)));
            }
            EXPECT_NEAR(same, 0, 0.5);
        }
    }
}

TEST_F(GlRenderer, AHatchMovesWithTheScene) {
    Style style = filled(white);
    style.hatch = Hatch::dots;
    style.hatch_colour = black;
    DrawList list = styled_list({style});
    flat_square(list, 0, -500, 500);
    ListView view = plain_view(100, 100);
    const Pixels before = drawn(list, view, 100, 100);
    view.world = {{7, 4}, {107, 104}};
    const Pixels after = drawn(list, view, 100, 100);
    for (int y = 10; y < 90; ++y)
        for (int x = 10; x < 90; ++x) ASSERT_NEAR(after.at(x, y).r, before.at(x + 7, y - 4).r, 3) << x << ' ' << y;
}

TEST_F(GlRenderer, MarksHaveTheirSizes) {
    Style mark = filled(red);
    mark.stroke = black;
    mark.width_pt = 2;
    DrawList list = styled_list({mark});
    list.add(ShapeKind::disc, 0, {{20, 20}}, 10);
    list.add(ShapeKind::ring, 0, {{60, 20}}, 10);
    list.add(ShapeKind::cross, 0, {{20, 60}}, 10);
    list.add(ShapeKind::arrow, 0, {{50, 60}, {90, 60}}, 12);
    const Pixels p = drawn(list, plain_view(100, 100), 100, 100);
    const auto at = [&](int x, int y) { return p.at(x, 99 - y); };
    EXPECT_EQ(at(20, 20), red);
    EXPECT_LT(at(30, 20).r, 30);
    EXPECT_EQ(at(32, 20), white);
    EXPECT_EQ(at(60, 20), white);
    EXPECT_LT(at(70, 20).r, 30);
    EXPECT_EQ(at(20, 60).r, 0);
    EXPECT_LT(at(27, 67).r, 60);
    EXPECT_LT(at(27, 52).r, 60);
    EXPECT_EQ(at(27, 60), white);
    EXPECT_EQ(at(34, 74), white);
    EXPECT_EQ(at(60, 60).r, 0);
    EXPECT_LT(at(79, 63).r, 30);  // the head is 9.1 wide at its foot
    EXPECT_EQ(at(79, 66), white);
    EXPECT_EQ(at(76, 63), white);  // before its foot
    EXPECT_EQ(at(91, 60), white);  // nothing blunt beyond the tip
    EXPECT_LT(at(86, 60).r, 60);
}

TEST_F(GlRenderer, TransparencyLetsWhatLiesBelowThrough) {
    DrawList list = styled_list({filled(black), filled({255, 255, 255, 128})});
    flat_square(list, 0, 0, 100);
    flat_square(list, 1, 0, 50);
    const Pixels p = drawn(list, plain_view(100, 100), 100, 100);
    EXPECT_NEAR(p.at(20, 80).r, 128, 2);
    EXPECT_EQ(p.at(20, 80).a, 255);
}

TEST_F(GlRenderer, SeveralSamplesSmoothTheEdgesOfFills) {
    DrawList list = styled_list({filled(black)});
    list.add(ShapeKind::polygon, 0, {{10, 10}, {90, 30}, {20, 90}});
    const auto greys = [&](int samples) {
        const Pixels p = drawn(list, plain_view(100, 100), 100, 100, samples);
        return std::count_if(p.colours.begin(), p.colours.end(), [](const Colour& c) { return c.r > 0 && c.r < 255; });
    };
    EXPECT_EQ(greys(1), 0);
    EXPECT_GT(greys(4), 50);
}

TEST_F(GlRenderer, LeavesTheStateThatItSays) {
    DrawList list = styled_list({filled(red), stroked(black, 2, Dash::dotted)});
    flat_square(list, 0, 10, 60);
    list.add(ShapeKind::polyline, 1, {{0, 0}, {100, 100}});
    ListRenderer renderer;
    renderer.set(list);
    const GlTarget target(100, 100);
    target.bind();
    clear(white);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);  // as others may leave it
    glScissor(0, 0, 1, 1);
    renderer.draw(plain_view(100, 100));
    for (const GLenum off : {GL_BLEND, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE})
        EXPECT_FALSE(glIsEnabled(off)) << off;
    for (const GLenum bound : {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING}) {
        GLint name = -1;
        glGetIntegerv(bound, &name);
        EXPECT_EQ(name, 0) << bound;
    }
    EXPECT_EQ(target.read().at(30, 60), red);
}

TEST_F(GlRenderer, AnotherListReplacesTheOldOneAndAnEmptyOneDrawsNothing) {
    DrawList list = styled_list({filled(red)});
    flat_square(list, 0, 0, 100);
    ListRenderer renderer;
    const GlTarget target(100, 100);
    const auto middle = [&] {
        target.bind();
        clear(white);
        renderer.draw(plain_view(100, 100));
        return target.read().at(50, 50);
    };
    EXPECT_EQ(middle(), white);
    renderer.set(list);
    EXPECT_EQ(middle(), red);
    list.styles[0].fill = blue;
    renderer.set(list);
    EXPECT_EQ(middle(), blue);
    renderer.set(DrawList{});
    EXPECT_EQ(middle(), white);
}

TEST_F(GlRenderer, PicturesOfRandomSessionsCauseNoMessage) {
    Random random(9);
    ListRenderer renderer;
    const GlTarget target(160, 120);
    target.bind();
    for (int round = 0; round < 60; ++round) {
        Session<2> session = random_start(random).session();
        session.run(static_cast<std::uint32_t>(random.below(30)));
        const DrawList list = make_picture(session);
        renderer.set(list);
        renderer.draw({list.world, 0, 0, 160, 120, 1.5, 1});
        EXPECT_TRUE(context->messages().empty()) << context->messages().front();
    }
}

}  // namespace
}  // namespace sightline
