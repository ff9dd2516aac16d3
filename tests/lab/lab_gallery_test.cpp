// The gallery: a table that hangs together, verdicts that cannot be fooled, states that open where they say, and
// measures with known answers. That no row surprises is a test of its own (ctest runs `lab gallery`).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/session/condition.h"
#include "core/session/settings_table.h"
#include "core/session/start_settings.h"
#include "core/session/state_file.h"
#include "examples/added_heuristic/methods.h"
#include "lab/command.h"
#include "lab/gallery/gallery.h"
#include "lab/gallery/gallery_measures.h"
#include "lab/lab_graphics.h"

namespace sightline::lab {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <int D>
void expect_sound_rows(std::set<int>& numbers, std::size_t& measured_rows) {
    std::set<std::string> ids;
    int before = 1;
    for (const GalleryRow<D>& row : gallery<D>()) {
        SCOPED_TRACE(std::to_string(D) + "d:" + row.id);
        EXPECT_TRUE(ids.insert(row.id).second);
        EXPECT_GE(row.number, before) << "rows are in the order of their numbers";
        before = row.number;
        numbers.insert(row.number);
        const std::string look = row.look;
        EXPECT_GT(look.size(), 15u);
        EXPECT_LE(look.size(), 110u) << "one line in a picture";
        const Scene<D> scene = load_scene<D>(row.scene);
        EXPECT_LE(scene.primitives.size(), 10'500u);
        EXPECT_EQ(scene.source, "generated");
        Settings settings = catalogue_settings<D>(row.scene);
        for (const char* assignment : row.settings) apply_setting(settings, assignment);
        if (*row.until != 0) {
            EXPECT_NO_THROW(Condition<D>{row.until});
        }
        bool measures = false;
        for (const Expectation& e : row.expectations) {
            measures = measures || e.expect != Expect::pending;
            EXPECT_GT(std::string(e.means).size(), 5u);
            EXPECT_FALSE(std::isnan(e.threshold));
            bool known = false;
            for (const GalleryMeasure<D>& m : gallery_measures<D>()) known = known || m.id == e.measure;
            for (const MeasureRow& m : measure_table()) known = known || m.id == e.measure;
            EXPECT_TRUE(known) << e.measure;
        }
        EXPECT_TRUE(measures);
        measured_rows += measures;
    }
}

TEST(LabGallery, RowsAreSound) {
    std::set<int> numbers;
    std::size_t measured_rows = 0;
    expect_sound_rows<2>(numbers, measured_rows);
    expect_sound_rows<3>(numbers, measured_rows);
    EXPECT_EQ(numbers.size(), static_cast<std::size_t>(gallery_numbers));
    EXPECT_EQ(*numbers.begin(), 1);
    EXPECT_EQ(*numbers.rbegin(), gallery_numbers);
    EXPECT_GE(measured_rows, 20u);
}

TEST(LabGallery, FindsBothKindsOfSurprise) {
    using Kind = Verdict::Kind;
    const Expectation passes{"published", Expect::pass, "coverage", Bound::at_least, 0.9, ""};
    EXPECT_EQ(judge(passes, true, 0.9).kind, Kind::expected);
    EXPECT_EQ(judge(passes, true, 0.89).kind, Kind::surprise) << "a pass that fails";
    EXPECT_EQ(judge(passes, true, nan).kind, Kind::surprise);
    EXPECT_EQ(judge(passes, false, nan).kind, Kind::surprise) << "a method that has gone";
    const Expectation fails{"published", Expect::fail, "wrong", Bound::at_most, 0.1, ""};
    EXPECT_EQ(judge(fails, true, 0.11).kind, Kind::expected);
    EXPECT_EQ(judge(fails, true, std::numeric_limits<double>::infinity()).kind, Kind::expected);
    EXPECT_EQ(judge(fails, true, 0.1).kind, Kind::surprise) << "a fail that passes";
    EXPECT_EQ(judge(fails, true, nan).kind, Kind::surprise) << "no number is no failure";
    const Expectation waits{"flux", Expect::pending, "coverage", Bound::at_least, 0.9, ""};
    EXPECT_EQ(judge(waits, false, nan).kind, Kind::pending);
    EXPECT_EQ(judge(waits, true, 0.95).kind, Kind::surprise) << "a pending method that has come";
}

/// The row with what it expects turned round.
GalleryRow<2> opposite(GalleryRow<2> row) {
    for (Expectation& e : row.expectations)
        if (e.expect != Expect::pending) e.expect = e.expect == Expect::pass ? Expect::fail : Expect::pass;
    return row;
}

TEST(LabGallery, MeasuredRowsSurpriseWhenTurnedRound) {
    for (const GalleryRow<2>& row : gallery<2>()) {
        if (std::string(row.id) != "bottleneck" && std::string(row.id) != "hullgap") continue;
        for (const Verdict& v : measure_row(row, {})) EXPECT_NE(v.kind, Verdict::Kind::surprise) << row.id;
        const GalleryRow<2> other = opposite(row);
        for (const Verdict& v : measure_row(other, {}))
            EXPECT_EQ(v.kind == Verdict::Kind::surprise, v.expectation->expect != Expect::pending) << row.id;
    }
    EXPECT_THROW(measure_row(
                     GalleryRow<2>{
                         "x", 1, "single", {}, "", "", {{"published", Expect::pass, "beauty", Bound::at_least, 1, ""}}},
                     {}),
                 InputError);
}

/// A coverage that no order can reach tells nothing about the orders that miss it.
template <int D>
void expect_fair_thresholds(const DrawIds& draw_ids) {
    for (const GalleryRow<D>& row : gallery<D>()) {
        GalleryRow<D> bound = row;
        std::erase_if(bound.expectations, [](const Expectation& e) {
            return e.expect == Expect::pending || std::string(e.measure) != "coverage";
        });
        for (Expectation& e : bound.expectations) {
            e.measure = "oracle";
            e.expect = Expect::pass;
        }
        for (const Verdict& v : measure_row(bound, draw_ids))
            EXPECT_TRUE(v.passed) << D << "d:" << row.id << " " << v.expectation->subject << ": the oracle has "
                                  << v.value;
    }
}

TEST(LabGallery, AsksForNoCoverageThatCannotBeHad) {
    LabGraphics graphics;
    expect_fair_thresholds<2>({});
    expect_fair_thresholds<3>(graphics.draw_ids());
}

template <int D>
void expect_states_reopen(const DrawIds& draw_ids, std::span<const std::string_view> ids) {
    for (const GalleryRow<D>& row : gallery<D>()) {
        if (std::find(ids.begin(), ids.end(), row.id) == ids.end()) continue;
        SCOPED_TRACE(std::to_string(D) + "d:" + row.id);
        const std::string text = state_json(gallery_session(row, draw_ids));
        const OpenedState<D> opened = open_state<D>(text, row.id, method_table<D>(), draw_ids);
        EXPECT_TRUE(opened.warnings.empty());
        ASSERT_EQ(opened.session.bookmarks.size(), 1u);
        EXPECT_EQ(opened.session.bookmarks.front().label, row.look);
        EXPECT_EQ(opened.session.bookmarks.front().step, opened.session.position());
        std::string caption;
        for (const Note<D>& note : opened.session.notes) {
            caption += (caption.empty() ? "" : " ") + note.text;
            EXPECT_LE(note.text.size(), 50u);
        }
        EXPECT_EQ(caption, row.look);
        if (*row.until == 0) {
            EXPECT_TRUE(opened.session.finished());
            continue;
        }
        const Condition<D> condition(row.until);
        EXPECT_TRUE(condition.holds(opened.session)) << row.until;
        const Session<D> before = copy_at(opened.session, opened.session.position() - 1);
        EXPECT_FALSE(condition.holds(before)) << "the first step at which it holds";
    }
}

TEST(LabGallery, StatesOpenAtTheStepTheyName) {
    LabGraphics graphics;
    std::vector<std::string_view> all, some{"bottleneck", "hullgap", "empty", "gap", "cplp-256"};
    for (const GalleryRow<2>& row : gallery<2>()) all.push_back(row.id);
    expect_states_reopen<2>({}, all);
    expect_states_reopen<3>(graphics.draw_ids(), some);
}

int run(std::vector<const char*> arguments, std::string& out) {
    arguments.insert(arguments.begin(), "gallery");
    testing::internal::CaptureStdout();
    const int status = gallery_command(static_cast<int>(arguments.size()), arguments.data(), {});
    out = testing::internal::GetCapturedStdout();
    return status;
}

TEST(LabGallery, CommandEndsWithItsCounts) {
    std::string out;
    EXPECT_EQ(run({"2d:hullgap", "tiny-budget"}, out), 0);
    EXPECT_NE(out.find("2d:hullgap (D 7)"), std::string::npos);
    EXPECT_EQ(out.find("3d:hullgap"), std::string::npos);
    EXPECT_NE(out.find("3d:tiny-budget"), std::string::npos);
    EXPECT_TRUE(out.ends_with("\n3 scenes, 14 expectations, 0 pending, 0 surprises\n")) << out;
    EXPECT_EQ(run({"--list"}, out), 0);
    EXPECT_EQ(static_cast<std::size_t>(std::count(out.begin(), out.end(), '\n')),
              gallery<2>().size() + gallery<3>().size());
    const char* const unknown[] = {"gallery", "no-such-scene"};
    EXPECT_THROW(gallery_command(2, unknown, {}), InputError);
}

TEST(LabGallery, TheManualShowsWhatItPrints) {
    std::istringstream page(read_file(SIGHTLINE_SOURCE_DIR "/docs/measuring.md"));
    std::string out, line;
    EXPECT_EQ(run({"3d:bottleneck"}, out), 0);
    bool shown = false;
    int lines = 0;
    while (std::getline(page, line)) {
        if (line.starts_with("```")) {
            shown = line == "```console";
        } else if (shown) {
            EXPECT_NE(out.find(line + "\n"), std::string::npos) << line;
            ++lines;
        }
    }
    EXPECT_GE(lines, 3);
}

TEST(LabGallery, HoldsAMethodOfOnesOwnToWhatIsAskedOfPublished) {
    const auto methods = methods_of_ones_own<2>();
    const std::array<std::string, 2> also{"crowd", "rings"};
    std::size_t asked = 0;
    for (const GalleryRow<2>& row : gallery<2>()) {
        if (row.number > 4) continue;
        const auto verdicts = measure_row<2>(row, {}, methods, also);
        for (std::size_t v = 0; v < verdicts.size(); ++v) {
            if (verdicts[v].subject != "published") continue;
            ASSERT_LT(v + 2, verdicts.size());
            for (std::size_t k = 0; k < also.size(); ++k) {
                const Verdict& beside = verdicts[v + 1 + k];
                EXPECT_EQ(beside.kind, Verdict::Kind::asked);
                EXPECT_EQ(beside.subject, also[k]);
                EXPECT_EQ(beside.passed, passes(*verdicts[v].expectation, beside.value));
                EXPECT_FALSE(std::isnan(beside.value)) << row.id;
                ++asked;
            }
        }
    }
    EXPECT_GT(asked, 4u);
}

/// One that needs the exact visible set is given it, wherever the scene and the eye are.
template <int D>
void expect_perfect_is_measured(const DrawIds& draw_ids, std::initializer_list<int> numbers) {
    const std::array<std::string, 1> also{"perfect"};
    std::size_t asked = 0, best = 0;
    for (const GalleryRow<D>& row : gallery<D>()) {
        if (std::find(numbers.begin(), numbers.end(), row.number) == numbers.end()) continue;
        for (const Verdict& verdict : measure_row<D>(row, draw_ids, method_table<D>(), also)) {
            if (verdict.kind != Verdict::Kind::asked) continue;
            ++asked;
            if (std::string(verdict.expectation->measure) != "coverage") continue;
            EXPECT_EQ(verdict.value, 1) << row.id << ": the visible ones fit the budgets of these scenes";
            ++best;
        }
    }
    EXPECT_GE(asked, numbers.size());
    EXPECT_GE(best, 1u);
}

TEST(LabGallery, GivesTheExactVisibleSetToAMethodThatNeedsIt) {
    expect_perfect_is_measured<2>({}, {1, 2, 3});
    std::string out;
    EXPECT_EQ(run({"--also", "perfect", "2d:forget"}, out), 0);
    EXPECT_NE(out.find("perfect: coverage 1,"), std::string::npos) << out;
    try {
        LabGraphics opengl;
        expect_perfect_is_measured<3>(opengl.draw_ids(), {1});
    } catch (const WorkError& error) {
        GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
}

// Known answers.

Probe<2> probe_of(GalleryScene<2>& at, std::initializer_list<const char*> settings = {}) {
    Probe<2> probe{at, method_table<2>(), {}, *at.scene().start_view, *at.scene().start_view};
    for (const char* assignment : settings) apply_setting(probe.settings, assignment);
    return probe;
}

std::shared_ptr<const Scene<2>> scene_of(std::vector<Primitive<2>> primitives, const ViewSpec<2>& view) {
    Scene<2> scene;
    scene.primitives = std::move(primitives);
    scene.start_view = view;
    return std::make_shared<const Scene<2>>(std::move(scene));
}

/// The eye at (0, 0) looks along +x at one wall, which hides three others; a fifth lies behind the eye.
std::shared_ptr<const Scene<2>> walls() {
    return scene_of({{Vec<2>(4, -1), Vec<2>(4, 1)},
                     {Vec<2>(2, -4), Vec<2>(2, 4)},
                     {Vec<2>(5, -1), Vec<2>(5, 1)},
                     {Vec<2>(6, -1), Vec<2>(6, 1)},
                     {Vec<2>(-3, -1), Vec<2>(-3, 1)}},
                    {{0, 0}, {1, 0}, 60});
}

TEST(LabGalleryMeasures, HaveTheirKnownAnswers) {
    GalleryScene<2> at(walls(), {});
    // The order of the scene draws the visible wall second of four that are in view.
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=view"}), "detour"), 2);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=everything"}), "visible_in_view"), 0.25);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=view", "budget=1"}), "missed"), 1);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=view", "budget=2"}), "missed"), 0);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=view", "budget=1"}), "ahead_of_centroid"), -1);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=centroid", "budget=1"}), "of_oracle"), 1);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=view"}), "culled"), 0);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=view", "budget=3"}), "rendered_count"), 3);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=centroid", "budget=1"}), "coverage"), 1);
    EXPECT_DOUBLE_EQ(measured(probe_of(at), "ray_wrong"), 0);
    EXPECT_DOUBLE_EQ(measured(probe_of(at), "lost_by_pixels"), 0);
    EXPECT_DOUBLE_EQ(measured(probe_of(at), "churn"), 0);
    EXPECT_DOUBLE_EQ(measured(probe_of(at), "power_of_two"), 0);
    EXPECT_DOUBLE_EQ(measured(probe_of(at), "bad_keys"), 0);
}

TEST(LabGalleryMeasures, SplitByPart) {
    // The eye at (0, 0) looks along +x: a long wall to its right, a near and a far one to its left, and two hidden.
    const auto scene = scene_of({{Vec<2>(2, -4), Vec<2>(2, -0.5)},
                                 {Vec<2>(4, -3), Vec<2>(4, -2)},
                                 {Vec<2>(5, -3), Vec<2>(5, -2)},
                                 {Vec<2>(2, 0.5), Vec<2>(2, 1)},
                                 {Vec<2>(3, -0.2), Vec<2>(3, 0.2)}},
                                {{0, 0}, {1, 0}, 120});
    using enum CarPart;
    GalleryScene<2> at(scene, {}, {front, engine, engine, engine, back});
    const auto value = [&](GalleryScene<2>& of, const char* budget, const char* measure) {
        return measured(probe_of(of, {"method=view", budget}), measure);
    };
    EXPECT_DOUBLE_EQ(value(at, "budget=4", "coverage"), 2.0 / 3);
    EXPECT_DOUBLE_EQ(value(at, "budget=4", "front_coverage"), 1);
    EXPECT_DOUBLE_EQ(value(at, "budget=4", "back_coverage"), 0);
    EXPECT_DOUBLE_EQ(value(at, "budget=4", "hidden_engine"), 0.5) << "the engine that is seen does not count";
    EXPECT_DOUBLE_EQ(value(at, "budget=5", "back_coverage"), 1);
    EXPECT_DOUBLE_EQ(value(at, "budget=5", "hidden_engine"), 0.4);
    GalleryScene<2> turned_round(scene, {}, {back, engine, engine, engine, front});
    EXPECT_DOUBLE_EQ(value(turned_round, "budget=4", "front_coverage"), 0);
    EXPECT_DOUBLE_EQ(value(turned_round, "budget=4", "back_coverage"), 1);
    GalleryScene<2> others(scene, {}, {front, other, none, back, engine});
    EXPECT_DOUBLE_EQ(value(others, "budget=5", "hidden_engine"), 0);
    GalleryScene<2> without(scene, {});
    EXPECT_THROW(value(without, "budget=4", "back_coverage"), InputError);
}

TEST(LabGalleryMeasures, SeeWhoIsFirstWhereTwoLieInOnePlace) {
    // A short wall that lies in a long one: whichever comes first hides the other there.
    GalleryScene<2> at(scene_of({{Vec<2>(4, -3), Vec<2>(4, 3)}, {Vec<2>(4, -1), Vec<2>(4, 1)}}, {{0, 0}, {1, 0}, 60}),
                       {});
    EXPECT_DOUBLE_EQ(measured(probe_of(at), "reverse_churn"), 0.5) << "{long} against {long, short}";
    EXPECT_DOUBLE_EQ(measured(probe_of(at), "reverse_wrong"), 0);
    // Where one lies behind the other no order matters.
    GalleryScene<2> apart(
        scene_of({{Vec<2>(4, -3), Vec<2>(4, 3)}, {Vec<2>(5, -1), Vec<2>(5, 1)}}, {{0, 0}, {1, 0}, 60}), {});
    EXPECT_DOUBLE_EQ(measured(probe_of(apart), "reverse_churn"), 0);
}

TEST(LabGalleryMeasures, LoseWhatIsThinnerThanAPixel) {
    // 64 slats of a tenth of a pixel each in an image of 64 pixels, in the first half of the pixels they are in.
    std::vector<Primitive<2>> slats;
    for (int i = 0; i < 64; ++i) {
        const double y = -1 + (i + (i < 16 ? 0.48 : 0.2)) / 32.0;
        slats.push_back({Vec<2>(1, y), Vec<2>(1, y + 0.1 / 32)});
    }
    GalleryScene<2> at(scene_of(slats, {{0, 0}, {1, 0}, 90}), {});
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"reference_size=64"}), "lost_by_pixels"), 0.75);
    EXPECT_GT(measured(probe_of(at, {"reference_size=64"}), "churn"), 0.5);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"reference_size=4096"}), "lost_by_pixels"), 0);
}

TEST(LabGalleryMeasures, ShiftsAndPlacesThatMatterAreSeen) {
    // Two walls side by side at equal distance: a budget of one takes the nearer centroid, which a shift decides.
    GalleryScene<2> at(scene_of({{Vec<2>(4, 1), Vec<2>(4, 2)}, {Vec<2>(4, -1), Vec<2>(4, -2)}}, {{0, 0}, {1, 0}, 90}),
                       {});
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=centroid", "budget=1"}), "shift_overlap"), 0);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=centroid", "budget=2"}), "shift_overlap"), 1);
    EXPECT_DOUBLE_EQ(measured(probe_of(at, {"method=centroid", "budget=2"}), "off_budget"), 0);
    Probe<2> walk = probe_of(at, {"method=centroid", "budget=1"});
    walk.view.eye = {0, -1};
    walk.view.look_at = {4, -1};
    walk.to.eye = {0, 1};
    walk.to.look_at = {4, 1};
    EXPECT_DOUBLE_EQ(measured(walk, "walk_pop"), 1) << "on the middle line the two change places";
    EXPECT_DOUBLE_EQ(measured(walk, "walk_visible"), 0);
}

TEST(FailureScenes, AreSoundAndRepeat) {
    std::set<std::string> ids;
    for (const CatalogueRow<2>& row : failure_scenes<2>()) {
        SCOPED_TRACE(row.id);
        EXPECT_TRUE(ids.insert(row.id).second);
        EXPECT_EQ(find_in_catalogue<2>(row.id), &row);
        EXPECT_EQ(scene_hash(make_scene(row)), scene_hash(make_scene(row)));
        const std::string lesson = row.lesson;
        EXPECT_GT(lesson.size(), 60u);
        EXPECT_EQ(lesson.back(), '.');
        EXPECT_EQ(lesson.find(". "), std::string::npos) << "one sentence";
        for (const CatalogueBookmark& bookmark : row.bookmarks) EXPECT_NO_THROW(Condition<2>{bookmark.condition});
        EXPECT_TRUE(std::string(row.id) == "broken" || make_scene(row).dropped.total() == 0);
    }
    for (const CatalogueRow<2>& row : catalogue<2>()) EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    ids.clear();
    for (const CatalogueRow<3>& row : failure_scenes<3>()) {
        SCOPED_TRACE(row.id);
        EXPECT_TRUE(ids.insert(row.id).second);
        EXPECT_EQ(find_in_catalogue<3>(row.id), &row);
        const Scene<3> scene = make_scene(row, 0);
        EXPECT_EQ(scene_hash(scene), scene_hash(make_scene(row, 0)));
        EXPECT_LE(scene.primitives.size(), 10'000u);
        EXPECT_TRUE(scene.two_sided.empty() || scene.two_sided.size() == scene.primitives.size());
    }
    for (const CatalogueRow<3>& row : catalogue<3>()) EXPECT_TRUE(ids.insert(row.id).second) << row.id;
}

}  // namespace
}  // namespace sightline::lab
