// Pictures of a method that postpones what is covered: its boxes, and the small picture that decides.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/draw/depth_picture.h"
#include "core/draw/depth_strip.h"
#include "core/draw/legend.h"
#include "core/draw/picture_3d.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/solid_palette.h"
#include "tests/draw/picture_support.h"
#include "tests/session/session_3d_support.h"

namespace sightline {
namespace {

using namespace test;

template <int D>
std::map<CellState, std::size_t> boxes_by_state(const Session<D>& session) {
    std::map<CellState, std::size_t> count;
    for (const ShownBox<D>& box : shown_boxes(session)) ++count[box.state];
    return count;
}

/// Row by row, in one string.
template <int D>
std::string legend_text(const UsedStyles& used, const Session<D>& session) {
    std::string text;
    for (const LegendRow& row : legend_rows(used, session.settings(), std::span<const Note<D>>{}))
        text += row.text + "\n";
    return text;
}

Session<2> rooms_by(const char* method) {
    Session<2> session = session_of(*find_in_catalogue("rooms"));
    Settings settings = session.settings();
    settings.method = method;
    session.change(settings);
    return session;
}

TEST(FeedbackPictures, APostponedBoxIsNeitherOneThatWaitsNorOneThatIsDropped) {
    std::size_t with_both = 0;
    for (const auto& [method, postponed] : {std::pair{"tri-z", true}, {"boxes", false}}) {
        Session<2> session = rooms_by(method);
        session.run();
        for (std::uint32_t step = 0; step <= session.recorded(); ++step) {
            session.seek(step);
            auto states = boxes_by_state(session);
            const DrawList list = make_picture(session);
            const Look hidden = postponed ? Look::postponed : Look::hidden,
                       other = postponed ? Look::hidden : Look::postponed;
            ASSERT_EQ(count(list, hidden), states[CellState::hidden]) << method << " at " << step;
            ASSERT_EQ(count(list, other), 0u) << method << " at " << step;
            ASSERT_EQ(count(list, Look::enqueued), states[CellState::enqueued]) << method << " at " << step;
            if (states[CellState::hidden] == 0 || states[CellState::enqueued] == 0) continue;
            ++with_both;
            UsedStyles used;
            add_used(list, used);
            const std::string rows = legend_text(used, session);
            EXPECT_EQ(rows.find("covered: postponed") != std::string::npos, postponed) << rows;
            EXPECT_EQ(rows.find("tested: hidden") != std::string::npos, !postponed) << rows;
        }
    }
    EXPECT_GT(with_both, 10u);
}

TEST(FeedbackPictures, SolidBoxesArePostponedToo) {
    const CatalogueRow<3>& row = *find_in_catalogue<3>("bottleneck");
    const auto scene = std::make_shared<const Scene<3>>(make_scene(row, row.triangles));
    Settings settings;
    settings.error_bound = 0.1;
    settings.triangles = Triangles::off;
    settings.show_visibility = Switch::off;
    settings.enqueued_as = settings.projected_as = DrawnAs::solid;
    settings.method = "tri-z";
    Session<3> session(scene, *scene->start_view, settings, method_table<3>(), cast_rays);
    session.freeze();
    ViewSpec<3> afar = *scene->start_view;
    afar.eye -= (afar.look_at - afar.eye) * 3.0;
    session.set_view(afar);
    std::map<CellState, std::size_t> states;
    for (; states[CellState::hidden] < 3 && session.run(1) == Stop::steps; states = boxes_by_state(session)) {
    }
    ASSERT_GE(states[CellState::hidden], 3u);
    const SolidList list = make_solid(session);
    std::map<std::string, std::size_t> styles;
    for (const std::uint8_t style : list.face_style) ++styles[list.styles[style].name];
    EXPECT_EQ(styles["postponed"], 6 * states[CellState::hidden]);
    EXPECT_EQ(styles["hidden"], 0u);
    UsedStyles used;
    add_used(list, used);
    EXPECT_NE(legend_text(used, session).find("covered: postponed"), std::string::npos);
}

TEST(FeedbackPictures, ItsLooksStayApartFromTheStatesOfOtherBoxes) {
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        const auto& looks = colours(palette).looks;
        const Style& postponed = looks[style_of(Look::postponed)];
        EXPECT_EQ(postponed.fill.a, 255);
        for (const Look look : {Look::enqueued, Look::projected, Look::unseen, Look::hidden}) {
            EXPECT_NE(postponed.hatch, looks[style_of(look)].hatch) << looks[style_of(look)].name;
            EXPECT_GE(std::abs(lightness(postponed.fill) - lightness(looks[style_of(look)].fill)), 5)
                << looks[style_of(look)].name;
        }
    }
}

std::string strip_label(const Session<2>& session) {
    for (const Label& label : make_picture(session).labels)
        if (label.text.starts_with("depths")) return label.text;
    return "";
}

TEST(FeedbackPictures, TheDepthStripIsThePictureThatDecides) {
    for (const char* maximise : {"count", "pixels"}) {
        Session<2> session = rooms_by("tri-z");
        Settings settings = session.settings();
        settings.show_depth = Switch::on;
        apply_setting(settings, "detail=0.125");
        apply_setting(settings, std::string("maximise=") + maximise);
        session.change(settings);
        session.run();
        std::size_t ahead = 0, finer = 0;
        for (std::uint32_t step = 0; step <= session.recorded(); ++step) {
            session.seek(step);
            const PixelLine line = line_that_decides(session);
            ASSERT_EQ(line.width(), 1024) << "an eighth of 8192";
            ASSERT_EQ(line_so_far(session).width(), 8192) << "of what the eye sees";
            // What is drawn there is what is rendered, and what waits for its turn.
            std::set<std::uint32_t> drawn;
            for (const std::uint32_t id : rendered_ids(session.met())) drawn.insert(id);
            const auto early = session.traversal().drawn_ahead();
            ahead += early.size();
            drawn.insert(early.begin(), early.end());
            for (const std::uint32_t id : line.ids) ASSERT_TRUE(id == none || drawn.contains(id));
            finer += line_so_far(session).ids.size() > line.ids.size();
            const auto covered = line.width() - std::count(line.ids.begin(), line.ids.end(), none);
            ASSERT_EQ(strip_label(session),
                      "depths in the small picture: " + std::to_string(covered) + " of 1024 pixels covered");
        }
        EXPECT_GT(finer, 0u);
        EXPECT_EQ(ahead > 0, std::string(maximise) == "pixels");
    }
    Session<2> boxes = rooms_by("boxes");
    Settings settings = boxes.settings();
    settings.show_depth = Switch::on;
    boxes.change(settings);
    boxes.run();
    EXPECT_EQ(line_that_decides(boxes).ids, line_so_far(boxes).ids);
    EXPECT_TRUE(strip_label(boxes).starts_with("depths: ")) << strip_label(boxes);
}

TEST(FeedbackPictures, TheDepthInsetIsThePictureThatDecides) {
    Random random(392);
    Start3 start = random_start_3d(random);
    start.settings.method = "tri-z";
    start.settings.reference_size = {160, 120};
    apply_setting(start.settings, "detail=0.25");
    Session<3> session = start.session();
    session.run();
    session.selected_cell = session.selected_primitive = none;
    const DepthPicture picture = depth_picture(session, false);
    EXPECT_EQ(picture.pixels.width, 40);
    EXPECT_EQ(picture.pixels.height, 30);
    EXPECT_TRUE(picture.text.starts_with("small picture, ")) << picture.text;
    Settings settings = session.settings();
    settings.method = "boxes";
    session.change(settings);
    const DepthPicture other = depth_picture(session, false);
    EXPECT_EQ(other.pixels.width, 160);
    EXPECT_FALSE(other.text.starts_with("small picture")) << other.text;
}

}  // namespace
}  // namespace sightline
