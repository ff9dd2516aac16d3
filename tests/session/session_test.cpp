// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"
#include "core/session/settings_table.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/draw/picture.h"
#include "core/session/explain.h"
#include "core/session/headline.h"
#include "core/space/builders.h"
#include "tests/run/run_support.h"
#include "tests/scene/scene_support.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// The hash after every step of a traversal that knows neither recording nor session, and why it ended.
struct Forward {
    std::vector<std::uint64_t> hashes;
    Stop end = Stop::none;
};

Forward forward_only(const test::Start& start) {
    const CellComplex<2> cells = build_cells(*start.scene, start.settings);
    const Problem<2> problem = test::problem_of(*start.scene, cells, make_view(start.view), start.settings);
    const auto run = find_method<2>(method_table<2>(), start.settings.method).start(problem);
    Forward forward{{run->hash()}, Stop::none};
    while ((forward.end = run->run(1)) == Stop::steps) forward.hashes.push_back(run->hash());
    return forward;
}

TEST(Session, CoverageIsOneOnlyWhereNothingIsMissing) {
    EXPECT_EQ(coverage_text(3942.0 / 3943), "0.9997");
    EXPECT_EQ(coverage_text(1), "1");
    EXPECT_EQ(coverage_text(0.4545), "0.455");
    EXPECT_EQ(coverage_text(0), "0");
    EXPECT_EQ(coverage_text(std::nullopt), "none");
}

TEST(Session, AnyWalkFindsTheHashesOfAForwardRun) {
    Random random(21);
    std::size_t longest = 0;
    for (int i = 0; i < test::soak_count(400); ++i) {
        const test::Start start = test::random_start(random, 90);
        const Forward forward = forward_only(start);
        const auto last = static_cast<std::uint32_t>(forward.hashes.size() - 1);
        longest = std::max<std::size_t>(longest, last);
        Session<2> session = start.session();
        for (int move = 0; move < 40; ++move) {
            const std::uint32_t from = session.position();
            const auto any = static_cast<std::uint32_t>(random.below(last + 3));
            switch (random.below(6)) {
                case 0:
                    ASSERT_EQ(session.step(), from < last ? Stop::none : forward.end);
                    ASSERT_EQ(session.position(), std::min(from + 1, last));
                    break;
                case 1:
                    ASSERT_EQ(session.back(), from > 0);
                    ASSERT_EQ(session.position(), from - (from > 0));
                    break;
                case 2:
                    session.seek(any);
                    ASSERT_EQ(session.position(), std::min(any, last));
                    break;
                case 3:
                    ASSERT_EQ(session.run(any), any <= last - from ? Stop::steps : forward.end);
                    ASSERT_EQ(session.position(), std::min<std::uint64_t>(std::uint64_t{from} + any, last));
                    break;
                case 4: {
                    const Stop stop = session.run_until([&](const Session<2>& s) { return s.position() >= any; });
                    const std::uint32_t wanted = std::max(from + 1, any);  // at least one step
                    ASSERT_EQ(stop, wanted <= last ? Stop::breakpoint : forward.end);
                    ASSERT_EQ(session.position(), std::min(wanted, last));
                    break;
                }
                default: {
                    // A copy goes its own way and leaves the original alone.
                    Session<2> copy = session;
                    copy.run();
                    ASSERT_EQ(copy.hash(), forward.hashes.back());
                    if (random.below(2)) session = copy;
                    break;
                }
            }
            ASSERT_EQ(session.hash(), forward.hashes[session.position()]) << "scene " << i << " move " << move;
            ASSERT_GE(session.recorded(), session.position());
        }
    }
    EXPECT_GT(longest, 100u) << "the walks were all short";
}

/// As if `session` had been made like this from the start.
void expect_like_new(const Session<2>& session, const test::Start& start, std::uint32_t step) {
    Session<2> fresh = start.session();
    fresh.seek(step);
    ASSERT_EQ(session.position(), fresh.position());
    ASSERT_EQ(session.hash(), fresh.hash());
    ASSERT_EQ(session.reference().count, fresh.reference().count);
    ASSERT_EQ(session.reference().cell_share, fresh.reference().cell_share);
    ASSERT_EQ(session.visible_rendered(), fresh.visible_rendered());
    Session<2> copy = session;
    ASSERT_EQ(copy.run(), fresh.run());
    ASSERT_EQ(copy.hash(), fresh.hash());
    while (copy.back()) {
    }
    fresh.seek(0);
    ASSERT_EQ(copy.hash(), fresh.hash());
}

TEST(Session, ChangedSettingsKeepTheStepAndGiveTheSessionOfANewOne) {
    Random random(22);
    std::array<int, 5> seen{};
    for (int i = 0; i < test::soak_count(300); ++i) {
        test::Start start = test::random_start(random);
        Session<2> session = start.session();
        for (int change = 0; change < 3; ++change) {
            session.seek(static_cast<std::uint32_t>(random.below(30)));
            if (random.below(2)) session.seek(static_cast<std::uint32_t>(random.below(session.position() + 1)));
            if (random.below(2)) session.reference();  // made before: must be made again where it depends
            const std::uint32_t step = session.position(), recorded = session.recorded();
            const Settings old = start.settings;
            if (random.below(3) == 0)
                start.settings.label = static_cast<CellNumber::Kind>(random.below(7));
            else if (random.below(4) == 0)
                start.settings.reference_size.width = 1 + static_cast<int>(random.below(5000));
            else
                start.settings = test::random_settings(random);
            if (random.below(2)) {  // the same cells
                start.settings.tessellation = old.tessellation;
                start.settings.error_bound = old.error_bound;
                start.settings.border = old.border;
                start.settings.jitter = old.jitter;
                start.settings.seed = old.seed;
            }
            const Invalidates what = session.change(start.settings);
            ++seen[static_cast<std::size_t>(what)];
            ASSERT_EQ(what, difference(old, start.settings));
            ASSERT_EQ(session.settings(), start.settings);
            if (what < Invalidates::traversal) {
                ASSERT_EQ(session.recorded(), recorded) << "nothing was run again";
                ASSERT_EQ(session.position(), step);
            }
            expect_like_new(session, start, step);
        }
    }
    for (const Invalidates what :
         {Invalidates::picture, Invalidates::reference, Invalidates::traversal, Invalidates::tessellation})
        EXPECT_GT(seen[static_cast<std::size_t>(what)], 5) << static_cast<int>(what);
}

TEST(Session, AMovedViewKeepsTheStepAndGivesTheSessionOfANewOne) {
    Random random(23);
    for (int i = 0; i < test::soak_count(300); ++i) {
        test::Start start = test::random_start(random);
        Session<2> session = start.session();
        for (int change = 0; change < 3; ++change) {
            session.seek(static_cast<std::uint32_t>(random.below(30)));
            if (random.below(2)) session.reference();
            const std::uint32_t step = session.position();
            start.view = test::random_view(random);
            session.set_view(start.view);
            ASSERT_EQ(session.culling_view(), start.view);
            ASSERT_EQ(session.display_view(), start.view);
            expect_like_new(session, start, step);
        }
    }
}

TEST(Session, WhatCannotBeLeavesItAsItWas) {
    Random random(24);
    const test::Start start = test::random_start(random);
    Session<2> session = start.session();
    session.seek(3);
    const std::uint64_t hash = session.hash();
    Settings unknown = start.settings;
    unknown.method = "publisht";
    unknown.tessellation = Tessellation::tree;
    EXPECT_THROW(session.change(unknown), InputError);
    EXPECT_EQ(session.settings(), start.settings);
    for (const bool frozen : {false, true}) {
        if (frozen) session.freeze();
        ViewSpec<2> view = start.view;
        view.look_at = view.eye;
        EXPECT_THROW(session.set_view(view), InputError);
        view = start.view;
        view.eye.x = std::numeric_limits<double>::quiet_NaN();
        EXPECT_THROW(session.set_view(view), InputError);
        view = start.view;
        view.fov = 180;
        EXPECT_THROW(session.set_view(view), InputError);
        EXPECT_EQ(session.culling_view(), start.view);
        EXPECT_EQ(session.display_view(), start.view);
        EXPECT_EQ(session.hash(), hash);
    }
    Settings settings = start.settings;
    settings.method = "nothing";
    test::expect_input_error([&] { Session<2>(start.scene, start.view, settings); },
                             "method 'nothing' does not exist; there are published, layers, centroid, view, "
                             "everything, formula, perfect, cplp, "
                             "boxes, hzb, hom, two-pass, coorg-teller, shadow-frusta, extinction, flux, tri, tri-seen, "
                             "tri-z, levels, portals, pvs, by-viewpoint, listed");
}

TEST(Session, CellsThatCannotBeMadeLeaveItAsItWas) {
    Random random(29);
    const auto large = std::make_shared<Scene<3>>(), small = std::make_shared<Scene<3>>();
    for (int i = 0; i < 400000; ++i)  // all as large as the scene
        large->primitives.push_back({Vec<3>(0), Vec<3>(1), test::random_point_3d(random, 0, 1)});
    small->primitives.assign(large->primitives.begin(), large->primitives.begin() + 20);
    const ViewSpec<3> view{{0.5, 0.5, 0.5}, {1, 0.5, 0.5}, 60};
    Settings coarse, fine;
    coarse.error_bound = 1;
    coarse.tessellation = Tessellation::tree;
    const auto expect_refused = [](Session<3>& session, const auto& change) {
        session.seek(3);
        const std::uint64_t hash = session.hash();
        const Settings settings = session.settings();
        const auto scene = session.shared_scene();
        const CellComplex<3>* const cells = &session.cells();
        EXPECT_THROW(change(), InputError);
        EXPECT_EQ(session.settings(), settings);
        EXPECT_EQ(session.shared_scene(), scene);
        EXPECT_EQ(&session.cells(), cells);
        EXPECT_EQ(session.hash(), hash);
        session.run(5);
        session.seek(3);
        EXPECT_EQ(session.hash(), hash);
    };
    Session<3> of_large(large, view, coarse);
    expect_refused(of_large, [&] { of_large.change(fine); });
    Session<3> of_small(small, view, fine);
    expect_refused(of_small, [&] { of_small.set_scene(large); });
}

TEST(Session, WhileFrozenOnlyTheDisplayViewMoves) {
    Random random(25);
    for (int i = 0; i < test::soak_count(100); ++i) {
        const test::Start start = test::random_start(random);
        Session<2> session = start.session(), never_frozen = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(20)));
        const std::uint64_t hash = session.hash();
        const std::size_t visible = session.reference().count;
        session.freeze();
        ASSERT_TRUE(session.frozen());
        ASSERT_EQ(session.display_view(), start.view);
        ViewSpec<2> shown;
        for (int move = 0; move < 5; ++move) {
            shown = test::random_view(random);
            session.set_view(shown);
            ASSERT_EQ(session.display_view(), shown);
            ASSERT_EQ(session.culling_view(), start.view);
            ASSERT_EQ(session.hash(), hash);
            ASSERT_EQ(session.reference().count, visible);
        }
        session.freeze();  // again: keeps the display view
        ASSERT_EQ(session.display_view(), shown);
        // It goes on stepping, and takes other settings, with the culling view.
        session.run();
        never_frozen.run();
        ASSERT_EQ(session.hash(), never_frozen.hash());
        Settings settings = test::random_settings(random);
        session.change(settings);
        never_frozen.change(settings);
        ASSERT_EQ(session.hash(), never_frozen.hash());
        ASSERT_EQ(session.display_view(), shown);
        session.unfreeze();
        ASSERT_EQ(session.display_view(), start.view);
        ASSERT_EQ(session.hash(), never_frozen.hash());
    }
}

TEST(Session, CopiesAreIndependent) {
    Random random(26);
    for (int i = 0; i < test::soak_count(100); ++i) {
        const test::Start start = test::random_start(random);
        Session<2> a = start.session();
        a.seek(5);
        a.notes.push_back({});
        Session<2> b = a;
        const std::uint64_t hash = a.hash();
        b.notes.clear();
        b.bookmarks.push_back({1, "b"});
        b.set_view(test::random_view(random));
        b.change(test::random_settings(random));
        b.run();
        ASSERT_EQ(a.hash(), hash);
        ASSERT_EQ(a.settings(), start.settings);
        ASSERT_EQ(a.culling_view(), start.view);
        ASSERT_EQ(a.notes.size(), 1u);
        ASSERT_TRUE(a.bookmarks.empty());
        expect_like_new(a, start, 5);
    }
}

TEST(Session, ATimeBudgetRecordsWhereItStopped) {
    Random random(27);
    int stopped = 0;
    for (int i = 0; i < test::soak_count(50); ++i) {
        test::Start start = test::random_cell_start(random);
        start.settings.budget = {Budget::Kind::unlimited, 0};
        Session<2> whole = start.session();
        const Stop end = whole.run();
        if (whole.position() < 4) continue;
        ++stopped;

        start.settings.budget = parse_budget("0ms");  // no time: the first step uses it up
        Session<2> session = start.session();
        ASSERT_EQ(session.time_stop(), none);
        ASSERT_EQ(session.run(), Stop::budget);
        ASSERT_EQ(session.time_stop(), 1u);
        ASSERT_EQ(session.position(), 1u);
        session.seek(1000);
        ASSERT_EQ(session.position(), 1u);
        ASSERT_EQ(session.step(), Stop::budget);
        ASSERT_TRUE(session.back());
        ASSERT_EQ(session.run(), Stop::budget);
        ASSERT_EQ(session.position(), 1u);

        // A replay of steps: a stop that comes from a file.
        Session<2> replay = start.session();
        replay.seek(4);
        replay.set_time_stop(3);
        replay.seek(0);
        replay.seek(100);
        ASSERT_EQ(replay.position(), 3u);
        ASSERT_EQ(replay.run(), Stop::budget);
        whole.seek(3);
        ASSERT_EQ(replay.hash(), whole.hash()) << "time chooses the end, never the order";

        // Another traversal has not used up any time yet.
        replay.set_view(test::random_view(random));
        ASSERT_EQ(replay.time_stop(), none);

        start.settings.budget = parse_budget("1e9ms");
        Session<2> ample = start.session();
        ASSERT_EQ(ample.run(), end);
        ASSERT_EQ(ample.time_stop(), none);
    }
    EXPECT_GT(stopped, 20);
}

TEST(Session, MarkersNamePenaltiesInversionsAndShares) {
    Random random(28);
    std::array<int, marker_words.size()> seen{};
    for (int i = 0; i < test::soak_count(100); ++i) {
        const test::Start start = test::random_start(random, 120);
        Session<2> session = start.session();
        // Written down by stepping, from explanations and counters.
        std::vector<std::array<std::uint32_t, 2>> penalties;
        const std::size_t total = start.scene->primitives.size();
        std::map<std::string, std::uint32_t> ticks;
        while (session.step() == Stop::none) {
            std::uint32_t penalised = 0;
            for (const Considered& facet : explain_step(session, session.position()).looked_at)
                penalised += Rule{facet.rule} != Rule::kept && facet.key && facet.key->penalised;
            if (penalised > 0) penalties.push_back({session.position(), penalised});
            for (const auto& [label, percent] : {std::pair{"1 %", 1}, {"2 %", 2}, {"5 %", 5}, {"10 %", 10}}) {
                const double wanted = std::max(1.0, std::nearbyint(static_cast<double>(total) * percent / 100));
                if (session.counters().spent >= wanted) ticks.try_emplace(label, session.position());
            }
        }
        // Wherever the session stands, the markers are those of the whole recording.
        session.seek(static_cast<std::uint32_t>(random.below(session.position() + 1)));
        const auto markers = session.markers();
        std::vector<std::array<std::uint32_t, 2>> found;
        std::map<std::string, std::uint32_t> found_ticks;
        std::size_t inversions = 0;
        for (std::size_t m = 0; m < markers.size(); ++m) {
            if (m > 0) {
                ASSERT_LE(markers[m - 1].step, markers[m].step);
            }
            ++seen[static_cast<std::size_t>(markers[m].kind)];
            if (markers[m].kind == Marker::Kind::penalty)
                found.push_back({markers[m].step, static_cast<std::uint32_t>(std::stoul(markers[m].label))});
            else if (markers[m].kind == Marker::Kind::budget)
                found_ticks[markers[m].label] = markers[m].step;
            else if (markers[m].kind != Marker::Kind::first_wrong)
                ++inversions;
        }
        ASSERT_EQ(found, penalties);
        ASSERT_EQ(inversions, session.inversions().size());
        if (total > 0) {
            ASSERT_EQ(found_ticks, ticks);
        }
    }
    const auto pop = static_cast<std::size_t>(Marker::Kind::pop);
    EXPECT_EQ(seen[pop], 0) << "that takes another frame";
    for (std::size_t kind = 0; kind < pop; ++kind) EXPECT_GT(seen[kind], 0) << marker_words[kind];
}

TEST(Session, KeepsBookmarksNotesAndTheSelectionThroughChanges) {
    Random random(29);
    test::Start start = test::random_cell_start(random);
    start.scene = std::make_shared<const Scene<2>>(test::random_scene(random, 50));
    start.settings.tessellation = Tessellation::tree;
    start.settings.error_bound = 0.05;
    Session<2> session = start.session();
    session.seek(4);
    session.bookmarks = {{4, "here"}};
    session.selected_cell = session.cells().cell_count() - 1;
    Settings other = start.settings;
    apply_setting(other, "penalty=add");
    session.change(other);
    EXPECT_EQ(session.selected_cell, session.cells().cell_count() - 1);
    EXPECT_EQ(session.bookmarks, (std::vector<Bookmark>{{4, "here"}}));
    // A coarser tessellation has no such cell.
    other.error_bound = 1;
    session.change(other);
    EXPECT_EQ(session.selected_cell, none);
    EXPECT_EQ(session.bookmarks.size(), 1u);
}

TEST(Session, WithoutPrimitivesItStillSteps) {
    for (const char* tessellation : {"delaunay", "tree"})
        for (const char* border : {"inflated", "none"}) {
            Settings settings;
            apply_setting(settings, std::string("tessellation=") + tessellation);
            apply_setting(settings, std::string("border=") + border);
            Session<2> session(std::make_shared<const Scene<2>>(), {{0, 0}, {1, 0}, 60}, settings);
            EXPECT_EQ(session.run(), Stop::front_empty);
            EXPECT_EQ(session.counters().rendered_count, 0u);
            EXPECT_FALSE(coverage(session.reference(), session.visible_rendered()));
            EXPECT_TRUE(session.inversions().empty());
            session.seek(0);
            EXPECT_EQ(session.position(), 0u);
        }
}

TEST(Session, MarkersDoNotDependOnWhereARunMustStop) {
    Random random(28);
    std::size_t penalties = 0;
    for (int i = 0; i < test::soak_count(60); ++i) {
        Session<2> session = test::random_cell_start(random).session();
        session.run();
        const auto all = session.markers();
        session.seek(static_cast<std::uint32_t>(random.below(session.position() + 1)));
        session.set_time_stop(session.position());
        const auto again = session.markers();
        ASSERT_EQ(again.size(), all.size());
        for (std::size_t m = 0; m < all.size(); ++m) {
            ASSERT_EQ(again[m].step, all[m].step);
            ASSERT_EQ(again[m].label, all[m].label);
            penalties += all[m].kind == Marker::Kind::penalty;
        }
    }
    EXPECT_GT(penalties, 100u);
}

}  // namespace
}  // namespace sightline
