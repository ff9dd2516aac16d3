// The picture of the 2D viewer without a window: camera, picking, handles, drags, snapping, labels, legend.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "core/draw/shown_world.h"
#include "core/scene/make/catalogue.h"
#include "shell/commands/command_table.h"
#include "shell/desk/change.h"
#include "shell/desk/gesture.h"
#include "shell/desk/moves.h"
#include "shell/desk/undo.h"
#include "shell/pane/click_cycle.h"
#include "shell/pane/legend.h"
#include "tests/shell/desk/bench_support.h"
#include "viewer2d/drag2d.h"

namespace sightline {
namespace {

constexpr Area area{40, 60, 800, 600};

class Canvas : public ::testing::Test {
protected:
    Canvas() : made(start()), bench(made.bench) { test::record_ahead(bench); }
    static Session<2> start() {
        const CatalogueRow<2>& row = *find_in_catalogue("bottleneck");
        Settings settings;
        settings.error_bound = row.error_bound;
        return {std::make_shared<const Scene<2>>(make_scene(row)), row.view, settings};
    }

    Camera camera() const { return {widened(shown_world(bench.session), area.w / area.h), area}; }
    Drag begin(Handle handle, const ImVec2& at, DragKind kind = DragKind::handle) {
        return {kind,
                handle,
                none,
                camera().to_scene(at),
                camera(),
                begin_gesture(bench),
                bench.session.selected_primitive};
    }
    Pick pick_at(const ImVec2& at) const {
        return pick(bench.session, camera(), handle_points(bench.session, camera(), 1, edit), at, 1, edit.on);
    }
    ImVec2 handle(Handle what) const {
        for (const HandlePoint& point : handle_points(bench.session, camera(), 1, edit))
            if (point.handle == what) return point.at;
        ADD_FAILURE() << handle_name(what);
        return {};
    }

    test::Bench made;
    Workbench<2>& bench;
    EditMode edit{true};
};

float distance(const ImVec2& a, const ImVec2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST_F(Canvas, CameraGoesThereAndBack) {
    const Camera c = camera();
    EXPECT_NEAR(distance(c.to_window(c.world.min), {area.x, area.y + area.h}), 0, 1e-3);
    EXPECT_NEAR(distance(c.to_window(c.world.max), {area.x + area.w, area.y}), 0, 1e-3);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> x(area.x, area.x + area.w), y(area.y, area.y + area.h);
    for (int i = 0; i < 100; ++i) {
        const ImVec2 p{x(random), y(random)};
        EXPECT_LT(distance(c.to_window(c.to_scene(p)), p), 0.01f);
    }
}

TEST_F(Canvas, PicksTheNearestPrimitiveWithinSixPixelsAndTheCellAnywhere) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> x(area.x, area.x + area.w), y(area.y, area.y + area.h);
    const Camera c = camera();
    int hit = 0;
    for (int i = 0; i < 500; ++i) {
        const ImVec2 at{x(random), y(random)};
        const Pick found = pick_at(at);
        EXPECT_EQ(found.cell, locate(bench.session.cells(), c.to_scene(at)));
        // By many points on each segment.
        double nearest = 1e9;
        for (const Primitive<2>& s : bench.session.scene().primitives)
            for (int k = 0; k <= 400; ++k) {
                const double t = k / 400.0;
                nearest = std::min<double>(nearest, distance(c.to_window(s[0] * (1 - t) + s[1] * t), at));
            }
        if (nearest < 5.5) {
            EXPECT_NE(found.primitive, none);
        } else if (nearest > 6.6) {
            EXPECT_EQ(found.primitive, none);
        }
        hit += found.primitive != none;
    }
    EXPECT_GT(hit, 20);
}

TEST_F(Canvas, HandlesComeFirstAndTheNearestWins) {
    for (const Handle what : {Handle::eye, Handle::look, Handle::opening}) {
        const ImVec2 at = handle(what);
        EXPECT_EQ(pick_at(at).handle, what);
        EXPECT_EQ(pick_at({at.x + 5, at.y + 5}).handle, what);
        EXPECT_EQ(pick_at({at.x + 12, at.y}).handle == what, false);
    }
    bench.session.selected_primitive = 3;
    EXPECT_EQ(pick_at(handle(Handle::segment_end)).handle, Handle::segment_end);
    const Primitive<2>& s = bench.session.scene().primitives[3];
    const Pick middle = pick_at(camera().to_window((s[0] + s[1]) * 0.5));
    ASSERT_GT(distance(camera().to_window(s[0]), camera().to_window(s[1])), 30);
    EXPECT_EQ(middle.handle, Handle::segment);
    Settings settings = bench.session.settings();
    settings.show_view = Switch::off;
    change_settings(bench, settings);
    EXPECT_EQ(handle_points(bench.session, camera(), 1, edit).size(), 2u);  // what is not shown is not hit
}

TEST_F(Canvas, ClicksAtOnePlaceGoThroughWhatLiesThere) {
    ClickCycle cycle;
    const Pick both{Handle::none, 5, 9}, cell{Handle::none, none, 9}, nothing{};
    EXPECT_EQ(cycle.next(choices(both), {10, 10}, 4), "primitive:5");
    EXPECT_EQ(cycle.next(choices(both), {11, 10}, 4), "9");
    EXPECT_EQ(cycle.next(choices(both), {10, 11}, 4), "primitive:5");
    EXPECT_EQ(cycle.next(choices(both), {30, 10}, 4), "primitive:5");
    cycle.forget();
    EXPECT_EQ(cycle.next(choices(both), {30, 10}, 4), "primitive:5");
    EXPECT_EQ(cycle.next(choices(cell), {50, 10}, 4), "9");
    EXPECT_EQ(cycle.next(choices(cell), {50, 10}, 4), "9");
    EXPECT_EQ(cycle.next(choices(nothing), {70, 10}, 4), "none");
}

TEST_F(Canvas, DraggingTheEyeMovesTheWholeViewInOneEntryOfTheHistory) {
    go_to_step(bench, 5);
    const ViewSpec<2> before = bench.session.culling_view();
    const std::uint64_t hash = bench.session.hash();
    const ImVec2 eye = handle(Handle::eye);
    const Drag drag = begin(Handle::eye, eye);
    const Vec<2> by = camera().to_scene({eye.x + 50, eye.y - 20}) - camera().to_scene(eye);
    drag_to(bench, drag, {eye.x + 9, eye.y + 9}, 1);
    drag_to(bench, drag, {eye.x + 50, eye.y - 20}, 1);
    EXPECT_NEAR(glm::length(bench.session.culling_view().eye - before.eye - by), 0, 1e-6);
    EXPECT_NEAR(glm::length(bench.session.culling_view().look_at - before.look_at - by), 0, 1e-6);
    EXPECT_EQ(bench.history.past.size(), 1u);
    undo(bench);
    EXPECT_EQ(bench.session.culling_view(), before);
    EXPECT_EQ(bench.session.hash(), hash);
    EXPECT_EQ(bench.session.position(), 5u);
}

TEST_F(Canvas, ACancelledDragLeavesNoTrace) {
    for (const bool with_past : {false, true}) {
        if (with_past) {
            ViewSpec<2> view = bench.session.culling_view();
            view.fov = 71;
            change_view(bench, view);
            view.fov = 72;
            change_view(bench, view);
            undo(bench);
        }
        go_to_step(bench, 7);
        bench.session.selected_cell = 4;
        bench.marked = {2, 3};
        const std::uint64_t hash = bench.session.hash();
        const ViewSpec<2> view = bench.session.culling_view();
        const std::size_t past = bench.history.past.size(), future = bench.history.future.size();
        for (const bool moves : {false, true}) {
            Drag drag = begin(Handle::look, handle(Handle::look));
            if (moves) drag_to(bench, drag, {area.x + 5, area.y + 5}, 1);
            EXPECT_EQ(bench.session.culling_view() == view, !moves);
            cancel_gesture(bench, std::move(drag.before));
            EXPECT_EQ(bench.session.culling_view(), view);
            EXPECT_EQ(bench.session.hash(), hash);
            EXPECT_EQ(bench.session.position(), 7u);
            EXPECT_EQ(bench.session.selected_cell, 4u);
            EXPECT_EQ(bench.history.past.size(), past);
            EXPECT_EQ(bench.history.future.size(), future);
            EXPECT_EQ(bench.marked, (std::vector<std::uint32_t>{2, 3}));
        }
    }
}

TEST_F(Canvas, FrozenEyesHaveHandlesOfTheirOwn) {
    bench.session.freeze();
    const ViewSpec<2> culling = bench.session.culling_view();
    const std::uint64_t run = bench.run;
    const ImVec2 eye = handle(Handle::eye);
    drag_to(bench, begin(Handle::eye, eye), {eye.x + 80, eye.y}, 1);
    EXPECT_EQ(bench.session.culling_view(), culling);
    EXPECT_NE(bench.session.display_view(), culling);
    EXPECT_EQ(bench.run, run);
    const ViewSpec<2> display = bench.session.display_view();
    const ImVec2 frozen = handle(Handle::frozen_eye);
    EXPECT_LT(distance(frozen, camera().to_window(culling.eye)), 0.1f);
    drag_to(bench, begin(Handle::frozen_eye, frozen), {frozen.x - 60, frozen.y}, 1);
    EXPECT_NE(bench.session.culling_view(), culling);
    EXPECT_EQ(bench.session.display_view(), display);
    EXPECT_TRUE(bench.session.frozen());
    EXPECT_GT(bench.run, run);
    undo(bench);
    EXPECT_EQ(bench.session.culling_view(), culling);
    EXPECT_EQ(bench.session.display_view(), display);
}

TEST_F(Canvas, AnEdgeOfTheConeOpensItAndTheLookHandleOnlyTurns) {
    const ViewSpec<2> view{{0, 0}, {2, 0}, 60};
    EXPECT_NEAR(dragged_view(view, Handle::opening, {}, {1, 1}).fov, 90, 1);
    EXPECT_NEAR(dragged_view(view, Handle::opening, {}, {1, -1}).fov, 90, 1);
    EXPECT_EQ(dragged_view(view, Handle::opening, {}, {-5, 1}).fov, 360);
    EXPECT_LT(dragged_view(view, Handle::opening, {}, {-1, 8}).fov, 180);
    EXPECT_GT(dragged_view(view, Handle::opening, {}, {5, 0}).fov, 0);
    EXPECT_EQ(dragged_view(view, Handle::opening, {}, {0, 0}), view);
    const ViewSpec<2> turned = dragged_view(view, Handle::look, {}, {0, 7});
    EXPECT_EQ(turned.eye, view.eye);
    EXPECT_NEAR(glm::length(turned.look_at - Vec<2>(0, 2)), 0, 1e-12);
    EXPECT_EQ(dragged_view(view, Handle::look, {}, {0, 0}), view);
    for (double angle = 0; angle < 6.3; angle += 0.01) {
        const ViewSpec<2> any = dragged_view(view, Handle::opening, {}, {std::cos(angle), std::sin(angle)});
        EXPECT_NO_THROW(make_view(any)) << angle;
    }
}

TEST_F(Canvas, PanningKeepsThePointUnderTheMouse) {
    const ImVec2 from{300, 300}, to{370, 250};
    const Vec<2> held = camera().to_scene(from);
    const Drag drag = begin(Handle::none, from, DragKind::pan);
    drag_to(bench, drag, {320, 310}, 1);
    drag_to(bench, drag, to, 1);
    EXPECT_LT(distance(camera().to_window(held), to), 0.05f);
    EXPECT_EQ(bench.history.past.size(), 1u);
}

TEST_F(Canvas, DrawnSegmentsSnapToEndsAndFollowLive) {
    const std::size_t count = bench.session.scene().primitives.size();
    const Vec<2> end = bench.session.scene().primitives[10][0];
    const ImVec2 near = [&] {
        ImVec2 p = camera().to_window(end);
        return ImVec2{p.x + 3, p.y - 2};
    }();
    const Drag drag = begin(Handle::none, near, DragKind::draw_segment);
    drag_to(bench, drag, near, 1);  // no length yet
    EXPECT_EQ(bench.session.scene().primitives.size(), count);
    drag_to(bench, drag, {near.x + 90, near.y + 45}, 1);
    drag_to(bench, drag, {near.x + 60, near.y + 45}, 1);
    ASSERT_EQ(bench.session.scene().primitives.size(), count + 1);
    EXPECT_EQ(bench.session.scene().primitives.back()[0], end);
    EXPECT_EQ(bench.session.selected_primitive, count);
    EXPECT_EQ(bench.history.past.size(), 1u);

    const Primitive<2> drawn = bench.session.scene().primitives.back();
    const ImVec2 tail = camera().to_window(drawn[1]);
    drag_to(bench, begin(Handle::segment_end, tail), {tail.x + 20, tail.y + 1}, 1);
    EXPECT_EQ(bench.session.scene().primitives.back()[0], drawn[0]);
    EXPECT_NE(bench.session.scene().primitives.back()[1], drawn[1]);
    undo(bench);
    undo(bench);
    EXPECT_EQ(bench.session.scene().primitives.size(), count);
}

TEST_F(Canvas, ThePictureStaysWhereItIsUnderADrawnSegment) {
    run_commands(bench, "scene new");
    for (const auto& [from, to] :
         {std::array{ImVec2{100, 100}, ImVec2{300, 130}}, {ImVec2{700, 640}, ImVec2{60, 400}}}) {
        const Camera before = camera();
        drag_to(bench, begin(Handle::none, from, DragKind::draw_segment), to, 1);
        const Primitive<2>& drawn = bench.session.scene().primitives.back();
        EXPECT_LT(distance(camera().to_window(drawn[0]), from), 0.1f);
        EXPECT_LT(distance(camera().to_window(drawn[1]), to), 0.1f);
        undo(bench);
        EXPECT_LT(distance(camera().to_window(before.world.max), before.to_window(before.world.max)), 0.1f);
        redo(bench);
    }
}

TEST_F(Canvas, NotesMoveTheirTextOrTheirAnchor) {
    run_commands(bench, "note arrow cell:3 [30,20] here");
    Drag drag = begin(Handle::note_text, {400, 300});
    drag.note = 0;
    drag_to(bench, drag, {440, 290}, 1);
    EXPECT_NEAR(glm::length(bench.session.notes[0].offset_pt - Vec<2>(60, 27.5)), 0, 1e-6);
    EXPECT_EQ(bench.session.notes[0].index, 3u);
    const auto centre = [&](std::uint32_t cell) { return camera().to_window(bench.session.cells().centre(cell)); };
    drag = begin(Handle::note_anchor, centre(3));
    drag.note = 0;
    drag_to(bench, drag, {centre(20).x + 2, centre(20).y + 2}, 1);
    EXPECT_EQ(bench.session.notes[0].anchor, Note<2>::Anchor::cell);
    EXPECT_EQ(bench.session.notes[0].index, 20u);
    EXPECT_EQ(bench.history.past.size(), 3u);
}

// Labels.

LabelPaper plain_paper() {
    return {area,
            1,
            1,
            false,
            [](const Vec<2>& p) { return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y)); },
            [](const std::string& text) { return ImVec2(7.0f * static_cast<float>(text.size()), 12.0f); }};
}

Label yielding(double x, double y, const char* text) {
    Label label;
    label.at = {x, y};
    label.text = text;
    label.yields = true;
    return label;
}

bool overlap(const Area& a, const Area& b) {
    return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

TEST(Labels, NeverOverlapAndAreLeftOutOnlyWhereTheyWould) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(0, 900), y(0, 700);
    std::vector<Label> labels;
    for (int i = 0; i < 3000; ++i) labels.push_back(yielding(x(random), y(random), i % 3 ? "0.123" : "12"));
    LabelMemory memory;
    const std::array<Area, 1> taken{Area{50, 500, 200, 150}};
    const auto spots = place_labels(labels, plain_paper(), taken, memory);
    EXPECT_GT(spots.size(), 200u);
    std::vector<std::uint8_t> shown(labels.size());
    for (std::size_t i = 0; i < spots.size(); ++i) {
        shown[spots[i].label] = 1;
        EXPECT_FALSE(overlap(spots[i].box, taken[0]));
        EXPECT_GE(spots[i].box.x, area.x);
        EXPECT_LE(spots[i].box.y + spots[i].box.h, area.y + area.h);
        for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(spots[i].box, spots[k].box));
    }
    LabelMemory one;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (shown[i]) continue;
        one.clear();
        const auto alone = place_labels({&labels[i], 1}, plain_paper(), {}, one);
        if (alone.empty()) continue;  // its point lies outside
        EXPECT_TRUE(overlap(alone[0].box, taken[0]) || std::any_of(spots.begin(), spots.end(), [&](const LabelSpot& s) {
                        return overlap(s.box, alone[0].box);
                    }));
    }
}

TEST(Labels, ThoseThatAreShownStayWhileOthersComeAndGo) {
    std::vector<Label> labels{yielding(300, 300, "0.5")};
    LabelMemory memory;
    EXPECT_EQ(place_labels(labels, plain_paper(), {}, memory).size(), 1u);
    // One that comes first in the list, and would take the place.
    labels.insert(labels.begin(), yielding(310, 300, "0.25"));
    auto spots = place_labels(labels, plain_paper(), {}, memory);
    ASSERT_EQ(spots.size(), 1u);
    EXPECT_EQ(spots[0].label, 1u);
    // Another number does not move it far, nor take its place.
    labels[1].text = "0.75";
    spots = place_labels(labels, plain_paper(), {}, memory);
    ASSERT_EQ(spots.size(), 1u);
    EXPECT_EQ(spots[0].label, 1u);
    // One that must show does.
    labels[0].yields = false;
    spots = place_labels(labels, plain_paper(), {}, memory);
    ASSERT_EQ(spots.size(), 1u);
    EXPECT_EQ(spots[0].label, 0u);
    labels[0].yields = true;
    spots = place_labels(labels, plain_paper(), {}, memory);
    ASSERT_EQ(spots.size(), 1u);
    EXPECT_EQ(spots[0].label, 0u);
}

TEST(Labels, MoveWithinTheirRoomAndThenStayThere) {
    std::vector<Label> labels{yielding(300, 300, "0.25"), yielding(320, 302, "0.5")};
    LabelMemory memory;
    EXPECT_EQ(place_labels(labels, plain_paper(), {}, memory).size(), 1u);
    for (Label& label : labels) label.room = 20;
    const auto spots = place_labels(labels, plain_paper(), {}, memory);
    ASSERT_EQ(spots.size(), 2u);
    EXPECT_FALSE(overlap(spots[0].box, spots[1].box));
    EXPECT_EQ(spots[0].anchor.x, 300);
    const LabelSpot moved = spots[1];
    EXPECT_LE(std::hypot(moved.box.x + moved.box.w / 2 - 320, moved.box.y + moved.box.h / 2 - 302), 20.01);
    // Its neighbour goes, another number comes.
    labels.erase(labels.begin());
    labels[0].text = "0.7";
    EXPECT_EQ(place_labels(labels, plain_paper(), {}, memory)[0].box.y, moved.box.y);
}

TEST(Legend, HasARowForEachAndStaysOffTheEye) {
    const Colours& standard = colours(Palette::standard);
    std::vector<LegendRow> rows(3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].style = standard.looks[i + 1];
        rows[i].text = "row " + std::to_string(i);
    }
    const ColourBar bar{"solidity", "0", "1.5", standard.heat};
    const LegendBox with = make_legend(rows, bar, standard, plain_paper().measure, 1);
    const LegendBox without = make_legend(rows, std::nullopt, standard, plain_paper().measure, 1);
    EXPECT_EQ(with.list.labels.size(), 6u);
    EXPECT_EQ(without.list.labels.size(), 3u);
    EXPECT_GT(with.h, without.h);
    for (const LegendBox& box : {with, without}) {
        for (const Vec<2>& p : box.list.points) EXPECT_TRUE(box.list.world.contains(p));
        for (std::size_t i = 1; i < box.list.labels.size() && i < 3; ++i)
            EXPECT_LT(box.list.labels[i].at.y, box.list.labels[i - 1].at.y);
    }
    EXPECT_EQ(make_legend({}, std::nullopt, standard, plain_paper().measure, 1).w, 0);

    EXPECT_GT(legend_place(with, area, 10, {}).y, area.y + area.h / 2);
    EXPECT_LT(legend_place(with, area, 10, {}).x, area.x + area.w / 2);
    const std::array<ImVec2, 1> corner{ImVec2(area.x + 20, area.y + area.h - 20)};
    const Area moved = legend_place(with, area, 10, corner);
    EXPECT_FALSE(moved.contains(corner[0]));
    EXPECT_LE(moved.x + moved.w, area.x + area.w);
}

}  // namespace
}  // namespace sightline
