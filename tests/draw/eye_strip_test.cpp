// The strip of what the eye sees: against rays cast one by one, in the picture, and under the mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/eye_strip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/draw/depth_strip.h"
#include "core/draw/picture.h"
#include "core/draw/shown_world.h"
#include "core/raster/pixel_line.h"
#include "tests/draw/picture_support.h"
#include "viewer2d/strip_picking.h"

namespace sightline {
namespace {

Session<2> random_strip_session(Random& random, const char* reference_size = "256") {
    test::Start start = test::random_start(random);
    apply_setting(start.settings, std::string("reference_size=") + reference_size);
    apply_setting(start.settings, "show_eye=on");
    Session<2> session = start.session();
    session.run(static_cast<std::uint32_t>(random.below(30)));
    return session;
}

/// From the eye through the centre of a pixel, as the head of pixel_line.h has it.
Vec<2> towards(const View<2>& view, int pixels, int pixel) {
    const int from_right = pixels - 1 - pixel;
    if (!view.all_round) {
        const double s = (from_right + 0.5) / pixels;
        return view.corners[0] + s * (view.corners[1] - view.corners[0]) - view.eye;
    }
    const int side = pixels / 4;
    const double s = (from_right % side + 0.5) / side;
    const std::array<Vec<2>, 4> corners{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
    const auto k = static_cast<std::size_t>(from_right / side);
    return corners[k] + s * (corners[(k + 1) % 4] - corners[k]);
}

/// The first segment that a ray meets; nothing where it passes an end, or two are met at one place.
std::optional<std::uint32_t> first_hit(std::span<const Primitive<2>> segments, std::span<const std::uint8_t> drawn,
                                       const Vec<2>& eye, const Vec<2>& direction) {
    constexpr double close = 1e-7;  // of the segment's length and of the distance: far above rounding
    double nearest = std::numeric_limits<double>::infinity(), second = nearest;
    std::uint32_t found = none;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        if (!drawn[i]) continue;
        const Vec<2> along = segments[i][1] - segments[i][0], to = segments[i][0] - eye;
        const double turn = cross(direction, along);
        if (std::abs(turn) <= close * glm::length(direction) * glm::length(along)) {
            if (std::abs(cross(direction, to)) <= close * glm::length(direction)) return std::nullopt;
            continue;
        }
        const double t = cross(to, along) / turn, s = cross(to, direction) / turn;
        if (s < -close || s > 1 + close || t < -close) continue;
        if (s < close || s > 1 - close || t < close) return std::nullopt;
        if (t < nearest) {
            second = nearest;
            nearest = t;
            found = i;
        } else {
            second = std::min(second, t);
        }
    }
    if (found != none && second < nearest * (1 + close)) return std::nullopt;
    return found;
}

TEST(EyeStrip, HasAtEachPixelWhatARayMeets) {
    Random random(201);
    int right = 0, wrong = 0, unclear = 0;
    for (int i = 0; i < 60; ++i) {
        const Session<2> session = random_strip_session(random);
        const EyeStrip strip = eye_strip(session);
        const View<2>& view = session.problem().view;
        ASSERT_EQ(strip.pixels, 256);
        const auto& segments = session.scene().primitives;
        const std::vector<std::uint8_t> all(segments.size(), 1), drawn = rendered_mask(session.met(), segments.size());
        int counted = 0, told_wrong = 0, here_unclear = 0;
        for (int pixel = 0; pixel < strip.pixels; ++pixel) {
            const EyeStrip::Piece& piece = strip.at(pixel);
            ASSERT_LE(piece.begin, pixel);
            ASSERT_GT(piece.end, pixel);
            told_wrong += strip.is_wrong(piece);
            const Vec<2> direction = towards(view, strip.pixels, pixel);
            const auto exact = first_hit(segments, all, view.eye, direction),
                       so_far = first_hit(segments, drawn, view.eye, direction);
            if (!exact || !so_far) {
                ++here_unclear;
                continue;
            }
            ASSERT_EQ(piece.exact, *exact) << "scene " << i << ", pixel " << pixel;
            ASSERT_EQ(piece.drawn, *so_far) << "scene " << i << ", pixel " << pixel;
            counted += *exact != *so_far;
            ++(*exact == *so_far ? right : wrong);
        }
        EXPECT_EQ(strip.wrong, told_wrong);
        EXPECT_GE(strip.wrong, counted);
        EXPECT_LE(strip.wrong, counted + here_unclear);
        unclear += here_unclear;
    }
    EXPECT_GT(right, 1000);
    EXPECT_GT(wrong, 1000);
    EXPECT_LT(unclear, right + wrong);
}

TEST(EyeStrip, IsRightOnceAllThatIsVisibleIsRendered) {
    Random random(202);
    for (int i = 0; i < 20; ++i) {
        test::Start start = test::random_start(random);
        start.settings.method = "everything";
        start.settings.budget = {};
        Session<2> session = start.session();
        const EyeStrip before = eye_strip(session);
        EXPECT_EQ(before.wrong > 0, std::any_of(before.pieces.begin(), before.pieces.end(),
                                                [](const EyeStrip::Piece& piece) { return piece.exact != none; }));
        session.run();
        const EyeStrip after = eye_strip(session);
        EXPECT_EQ(after.wrong, 0);
        EXPECT_TRUE(wrong_stretches(after).empty());
    }
}

struct StripShapes {
    std::map<std::string, int> shapes;  ///< by the name of their style
    std::string words;
};
StripShapes strip_shapes(const Session<2>& session) {
    StripShapes found;
    const DrawList list = make_picture(session);
    for (const Shape& shape : list.shapes) ++found.shapes[list.styles[shape.style].name];
    for (const Label& label : list.labels) found.words += label.text + "\n";
    return found;
}

TEST(EyeStrip, ThePictureHasARedMarkForEachStretchOfWrongPixels) {
    Random random(203);
    std::size_t marks = 0;
    for (int i = 0; i < 60; ++i) {
        Session<2> session = random_strip_session(random);
        const EyeStrip strip = eye_strip(session);
        const auto stretches = wrong_stretches(strip);
        int pixels = 0;
        for (std::size_t k = 0; k < stretches.size(); ++k) {
            pixels += stretches[k][1] - stretches[k][0];
            if (k > 0) {
                EXPECT_GT(stretches[k][0], stretches[k - 1][1]) << "one stretch in two";
            }
        }
        EXPECT_EQ(pixels, strip.wrong);
        StripShapes now = strip_shapes(session);
        EXPECT_EQ(now.shapes["eye_wrong"], static_cast<int>(stretches.size()));
        marks += stretches.size();
        int seen = 0;
        for (const EyeStrip::Piece& piece : strip.pieces) seen += (piece.exact != none) + (piece.drawn != none);
        EXPECT_EQ(now.shapes["eye_sees"], seen);
        const std::string count =
            strip.wrong == 0 ? "all 256 pixels right" : std::to_string(strip.wrong) + " of 256 pixels wrong";
        EXPECT_NE(now.words.find(count), std::string::npos) << now.words;

        Settings settings = session.settings();
        settings.show_eye = Switch::off;
        session.change(settings);
        for (const auto& [name, times] : strip_shapes(session).shapes) EXPECT_FALSE(name.starts_with("eye_")) << name;
    }
    EXPECT_GT(marks, 30u);
}

TEST(EyeStrip, NothingIsToldWhereWhatIsVisibleIsConcealed) {
    Random random(204);
    for (int i = 0; i < 30; ++i) {
        Session<2> session = random_strip_session(random);
        Settings settings = session.settings();
        settings.show_visibility = Switch::off;
        session.change(settings);
        const EyeStrip strip = eye_strip(session);
        EXPECT_EQ(strip.wrong, 0);
        std::set<std::uint32_t> seen;
        for (const EyeStrip::Piece& piece : strip.pieces) {
            EXPECT_EQ(piece.exact, none);
            if (piece.drawn != none) seen.insert(piece.drawn);
        }
        const std::vector<std::uint8_t> rendered = rendered_mask(session.met(), session.scene().primitives.size());
        for (const std::uint32_t id : seen) EXPECT_TRUE(rendered[id]);
        StripShapes now = strip_shapes(session);
        EXPECT_EQ(now.shapes["eye_wrong"], 0);
        EXPECT_EQ(now.shapes["eye_concealed"], 1);
        EXPECT_EQ(now.words.find("pixels"), std::string::npos) << now.words;
    }
}

TEST(EyeStrip, TheSelectedSegmentIsOutlinedWhereItIsSeen) {
    test::Start start;
    Scene<2> scene;  // a small wall before a long one
    scene.primitives = {{Vec<2>(1, -0.5), Vec<2>(1, 0.5)}, {Vec<2>(4, -9), Vec<2>(4, 9)}};
    start.scene = std::make_shared<const Scene<2>>(scene);
    start.view = {{0, 0}, {1, 0}, 90};
    start.settings.method = "everything";
    start.settings.budget = {};
    apply_setting(start.settings, "show_eye=on");
    Session<2> session = start.session();
    session.selected_primitive = 1;
    EXPECT_EQ(strip_shapes(session).shapes["eye_selected"], 2) << "on both sides of the small one";
    session.run();
    EXPECT_EQ(strip_shapes(session).shapes["eye_selected"], 4) << "and as it is drawn";
    session.selected_primitive = 0;
    EXPECT_EQ(strip_shapes(session).shapes["eye_selected"], 2);
    const EyeStrip strip = eye_strip(session);
    ASSERT_EQ(strip.pieces.size(), 3u);
    EXPECT_EQ(strip.pieces[0], (EyeStrip::Piece{0, strip.pixels / 4, 1, 1}));
    EXPECT_EQ(strip.pieces[1], (EyeStrip::Piece{strip.pixels / 4, 3 * strip.pixels / 4, 0, 0}));
}

TEST(EyeStrip, LiesInThePictureAndOverTheStripOfDepths) {
    Random random(205);
    for (int i = 0; i < 40; ++i) {
        Session<2> session = random_strip_session(random);
        for (const Switch depths : {Switch::off, Switch::on}) {
            Settings settings = session.settings();
            settings.show_depth = depths;
            session.change(settings);
            const Box<2> world = figure_world(session);
            const EyeStripPlace place = eye_strip_place(world, depths == Switch::on);
            EXPECT_LT(world.min.x, place.left);
            EXPECT_LT(place.right, world.max.x);
            EXPECT_LT(place.drawn_low, place.drawn_high);
            EXPECT_LT(place.drawn_high, place.exact_low);
            EXPECT_LT(place.exact_high, place.top);
            EXPECT_LT(place.top, world.max.y);
            double depth_top = world.min.y;
            const DrawList list = make_picture(session);
            for (const Shape& shape : list.shapes)
                if (list.styles[shape.style].name.starts_with("depth"))
                    for (std::uint32_t k = 0; k < shape.point_count; ++k)
                        depth_top = std::max(depth_top, list.points[shape.first_point + k].y);
            EXPECT_EQ(depth_top > world.min.y, depths == Switch::on);
            EXPECT_LT(depth_top, place.drawn_low);
            // It hides nothing of the scene.
            if (settings.zoom == 1) {
                EXPECT_LE(place.top, bounds<2>(session.scene().primitives).min.y);
            }
        }
    }
}

TEST(EyeStrip, NumbersOfCellsUnderItsPaperAreLeftOut) {
    Random random(207);
    std::size_t above = 0, under = 0;
    for (int i = 0; i < 40; ++i) {
        Session<2> session = random_strip_session(random);
        Settings settings = session.settings();
        for (const char* assignment : {"label=id", "label_where=all", "zoom=2"}) apply_setting(settings, assignment);
        session.change(settings);
        const double top = eye_strip_place(figure_world(session), false).top;
        const DrawList list = make_picture(session);
        for (const Label& label : list.labels) {
            if (label.room == 0) continue;  // not a cell's
            EXPECT_GE(label.at.y, top);
            ++above;
        }
        for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell)
            under += list.world.contains(session.cells().centre(cell)) && session.cells().centre(cell).y < top;
    }
    EXPECT_GT(above, 20u);
    EXPECT_GT(under, 20u);
}

TEST(EyeStrip, APlaceOnABandIsThePixelThatIsDrawnThere) {
    Random random(206);
    for (int i = 0; i < 30; ++i) {
        const Session<2> session = random_strip_session(random, i % 2 ? "640" : "8192");
        const EyeStrip strip = eye_strip(session);
        const EyeStripPlace place = eye_strip_place(figure_world(session), false);
        for (int k = 0; k < 100; ++k) {
            const int pixel = static_cast<int>(random.below(static_cast<std::uint64_t>(strip.pixels)));
            const double x = place.x_of(pixel, strip.pixels) + (place.right - place.left) * 0.5 / strip.pixels;
            const auto upper = pick_strip(strip, place, {x, (place.exact_low + place.exact_high) / 2}),
                       lower = pick_strip(strip, place, {x, (place.drawn_low + place.drawn_high) / 2});
            ASSERT_TRUE(upper && lower);
            EXPECT_EQ(upper->pixel, pixel);
            EXPECT_EQ(lower->pixel, pixel);
            EXPECT_EQ(upper->primitive(), strip.at(pixel).exact);
            EXPECT_EQ(lower->primitive(), strip.at(pixel).drawn);
        }
        for (const EyeStrip::Piece& piece : strip.pieces) {
            const StripPick pick{(piece.begin + piece.end) / 2, false, piece};
            const auto [eye, end] = line_of_sight(session, strip, pick, 1);
            EXPECT_EQ(eye, session.culling_view().eye);
            if (piece.exact == none) {
                EXPECT_NEAR(glm::length(end - eye), 1, 1e-9);
                continue;
            }
            const auto& [a, b] = session.scene().primitives[piece.exact];
            EXPECT_NEAR(glm::length(end - a) + glm::length(end - b), glm::length(b - a), 1e-6) << "not on the segment";
        }
        for (const auto& stretch : wrong_stretches(strip)) {
            const auto [from, to] = place.mark_of(stretch, strip.pixels);
            EXPECT_GT(to - from, (place.right - place.left) / 1000) << "too narrow to be seen";
            const auto mark = pick_strip(strip, place, {(from + to) / 2, (place.drawn_high + place.exact_low) / 2});
            ASSERT_TRUE(mark);
            EXPECT_TRUE(strip.is_wrong(mark->piece));
            EXPECT_EQ(mark->primitive(), mark->piece.exact);
        }
        EXPECT_FALSE(pick_strip(strip, place, {place.left - 1e-6, place.exact_low}));
        EXPECT_FALSE(pick_strip(strip, place, {place.left, place.top}));
    }
}

TEST(EyeStrip, TooltipsSayWhatIsThereAndWhatIsDrawnInstead) {
    EyeStrip strip;
    strip.pixels = 5;
    strip.pieces = {{0, 1, 17, 30}, {1, 2, 17, 17}, {2, 3, 17, none}, {3, 5, none, none}};
    Scene<2> scene;
    const auto words = [&](int pixel) { return strip_words(scene, strip, {pixel, false, strip.at(pixel)}); };
    EXPECT_EQ(words(0), "pixel 1: segment 17, missing: segment 30 is drawn instead");
    EXPECT_EQ(words(1), "pixel 2: segment 17, drawn");
    EXPECT_EQ(words(2), "pixel 3: segment 17, missing: nothing is drawn yet");
    EXPECT_EQ(words(4), "pixel 5: nothing is there");
    scene.objects = {{"wall", "door"}, std::vector<std::uint32_t>(31, 1)};
    EXPECT_EQ(words(1), "pixel 2: segment 17 (door), drawn");
    scene.objects = {};
    strip.concealed = true;
    strip.pieces = {{0, 1, none, 30}, {1, 5, none, none}};
    EXPECT_EQ(words(0), "pixel 1: segment 30 is drawn");
    EXPECT_EQ(words(1), "pixel 2: nothing is drawn yet");
}

}  // namespace
}  // namespace sightline
