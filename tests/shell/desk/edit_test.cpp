// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/edit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <optional>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/clean.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/scene/read/read_json.h"
#include "core/session/state_file.h"
#include "shell/desk/change.h"
#include "shell/desk/open_scene.h"
#include "shell/desk/undo.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

Primitive<2> random_segment(Random& random) {
    return {Vec<2>(random.unit(), random.unit()), Vec<2>(random.unit(), random.unit())};
}

/// How many segments there are when those between the same points count once.
std::size_t without_twins(std::vector<Primitive<2>> segments) {
    Scene<2> scene;
    scene.primitives = std::move(segments);
    clean(scene, Recentre::no, "test");
    return scene.primitives.size();
}

TEST(Edit, SelectionAndNotesKeepMeaningTheSameSegments) {
    Random random(105);
    int deleted = 0;
    for (int i = 0; i < 60; ++i) {
        test::Bench on(test::random_start(random, 30).session());
        Session<2>& session = on.bench.session;
        // What is expected, told by geometry.
        std::vector<Primitive<2>> segments = session.scene().primitives;
        if (without_twins(segments) != segments.size()) continue;
        std::vector<std::pair<std::string, Primitive<2>>> notes;
        std::optional<Primitive<2>> selected;
        for (int k = 0; k < 30; ++k) {
            const std::size_t count = segments.size();
            const auto any = static_cast<std::uint32_t>(random.below(std::max<std::size_t>(1, count)));
            const Primitive<2> segment = random_segment(random);
            switch (random.below(5)) {
                case 0:
                    add_segment(on.bench, segment);
                    segments.push_back(segment);
                    selected = segment;
                    break;
                case 1:
                    if (count == 0) break;
                    move_segment(on.bench, any, segment);
                    for (auto& note : notes)
                        if (note.second == segments[any]) note.second = segment;
                    if (selected == segments[any]) selected = segment;
                    segments[any] = segment;
                    break;
                case 2:
                    if (count == 0) break;
                    delete_segment(on.bench, any);
                    std::erase_if(notes, [&](const auto& note) { return note.second == segments[any]; });
                    if (selected == segments[any]) selected.reset();
                    segments.erase(segments.begin() + any);
                    ++deleted;
                    break;
                case 3: {
                    if (count == 0) break;
                    Note<2> note;
                    note.anchor = Note<2>::Anchor::primitive;
                    note.index = any;
                    note.text = std::to_string(k);
                    session.notes.push_back(note);
                    notes.emplace_back(note.text, segments[any]);
                    break;
                }
                case 4:
                    if (count == 0) break;
                    session.selected_primitive = any;
                    selected = segments[any];
                    break;
            }
            ASSERT_EQ(session.scene().primitives, segments);
            ASSERT_EQ(session.notes.size(), notes.size());
            for (std::size_t n = 0; n < notes.size(); ++n) {
                ASSERT_EQ(session.notes[n].text, notes[n].first);
                ASSERT_EQ(segments[session.notes[n].index], notes[n].second);
            }
            ASSERT_EQ(session.selected_primitive != none, selected.has_value());
            if (selected) {
                ASSERT_EQ(segments[session.selected_primitive], *selected);
            }
        }
    }
    EXPECT_GT(deleted, 40);
}

TEST(Edit, RefusesWhatReadingWouldDrop) {
    Random random(106);
    test::Bench on(test::random_cell_start(random, 20).session());
    const auto scene = on.bench.session.shared_scene();
    const auto last = static_cast<std::uint32_t>(scene->primitives.size() - 1);
    ASSERT_GT(last, 0u);
    const Primitive<2> first = scene->primitives[0];
    const double infinite = std::numeric_limits<double>::infinity();
    for (const Primitive<2>& bad :
         {first, Primitive<2>{first[1], first[0]}, Primitive<2>{Vec<2>(1, 2), Vec<2>(1, 2)},
          Primitive<2>{Vec<2>(0.0, 1), Vec<2>(-0.0, 1)}, Primitive<2>{Vec<2>(1, 2), Vec<2>(1, infinite)},
          Primitive<2>{Vec<2>(std::nan(""), 2), Vec<2>(1, 1)}, Primitive<2>{Vec<2>(1, 2), Vec<2>(1e151, 1)}}) {
        EXPECT_THROW(add_segment(on.bench, bad), InputError);
        EXPECT_THROW(move_segment(on.bench, last, bad), InputError);
        EXPECT_EQ(on.bench.session.shared_scene(), scene);
        EXPECT_TRUE(on.bench.history.past.empty());
    }
    move_segment(on.bench, 0, {first[1], first[0]});
    EXPECT_EQ(on.bench.session.scene().primitives[0], (Primitive<2>{first[1], first[0]}));
}

TEST(Edit, ADragIsOneChange) {
    Random random(107);
    test::Bench on(open_scene("bottleneck", {}, method_table<2>(), [](const std::string&) {}));
    const auto scene = on.bench.session.shared_scene();
    for (int i = 0; i < 9; ++i) move_segment(on.bench, 0, random_segment(random), "drag segment 0");
    EXPECT_TRUE(undo(on.bench));
    EXPECT_EQ(on.bench.session.shared_scene(), scene);
}

TEST(Edit, AnEditedSceneIsNotTakenForTheOriginal) {
    test::Bench on(open_scene("bottleneck", {}, method_table<2>(), [](const std::string&) {}));
    Session<2>& session = on.bench.session;
    delete_segment(on.bench, 3);
    EXPECT_EQ(session.scene().id, "bottleneck");
    EXPECT_EQ(session.scene().source, "edited");
    add_bookmarks(session);
    EXPECT_TRUE(session.bookmarks.empty()) << "those of the catalogue are about another scene";
    EXPECT_EQ(reread(session.shared_scene(), {}), session.shared_scene());
    session.run(7);
    const OpenedState opened = open_state(state_json(session), "text");
    EXPECT_EQ(opened.session.scene().primitives, session.scene().primitives);
    EXPECT_EQ(opened.session.scene().source, "edited");
    EXPECT_EQ(opened.session.hash(), session.hash());
}

// Walls close rooms: where one is taken away, a method that goes from room to room sees through.
TEST(Edit, RoomsAreThoseOfTheWallsThatAreLeft) {
    Settings settings;
    settings.method = "portals";
    settings.budget = parse_budget("unlimited");
    test::Bench on(open_scene("rooms", settings, method_table<2>(), [](const std::string&) {}));
    Session<2>& session = on.bench.session;
    const Rooms<2> before = session.scene().rooms;
    ASSERT_FALSE(before.empty());
    // A chair may go: it closes nothing.
    std::uint32_t chair = 0;
    while (chair < session.scene().primitives.size()) {
        const Primitive<2>& segment = session.scene().primitives[chair];
        if (std::any_of(before.all.begin(), before.all.end(), [&](const Room<2>& room) {
                return holds_inside(room, segment[0]) && holds_inside(room, segment[1]);
            }))
            break;
        ++chair;
    }
    delete_segment(on.bench, chair);
    EXPECT_EQ(session.scene().rooms, before);
    for (int i = 0; i < 12; ++i) {
        session.run(none);
        const auto seen = session.reference().visible;
        // The longest one that is seen: a wall.
        std::uint32_t wall = none;
        double most = 0;
        for (std::uint32_t p = 0; p < seen.size(); ++p) {
            const Primitive<2>& segment = session.scene().primitives[p];
            const double length = seen[p] ? glm::length(segment[1] - segment[0]) : 0;
            if (length > most) most = length, wall = p;
        }
        ASSERT_NE(wall, none);
        delete_segment(on.bench, wall);
        session.run(none);
        const auto drawn = rendered_mask(session.met(), session.scene().primitives.size());
        const auto& now = session.reference().visible;
        for (std::size_t p = 0; p < now.size(); ++p) ASSERT_LE(now[p], drawn[p]) << p;
        EXPECT_LT(session.scene().rooms.all.size(), 2 * before.all.size()) << "furniture makes no rooms";
    }
    session.run(none);
    EXPECT_NE(session.scene().rooms, before);
    const OpenedState opened = open_state(state_json(session), "text");
    EXPECT_EQ(opened.session.scene().rooms, session.scene().rooms);
}

TEST(Edit, AStateFileHoldsAnEditedSceneHoweverLarge) {
    Random random(108);
    Scene<2> scene;
    scene.id = "bottleneck";
    scene.source = "generated";
    for (int i = 0; i < 15000; ++i) {
        const Vec<2> at(random.unit(), random.unit());
        scene.primitives.push_back({at, at + Vec<2>(random.unit(), random.unit()) * 0.01});
    }
    ASSERT_GT(write_json(scene).size(), embed_limit_bytes);
    test::Bench on(Session<2>(std::make_shared<const Scene<2>>(scene), {{0, 0}, {1, 1}, 90}, {}));
    EXPECT_EQ(state_json(on.bench.session).find("\"embedded\""), std::string::npos);
    delete_segment(on.bench, 0);
    EXPECT_NE(state_json(on.bench.session).find("\"embedded\""), std::string::npos);
}

TEST(Edit, ANewSceneIsDrawnFromNothing) {
    Random random(109);
    test::Bench on(test::random_cell_start(random, 20).session());
    Workbench<2>& bench = on.bench;
    const auto scene = bench.session.shared_scene();
    bench.session.notes.push_back({});
    bench.session.freeze();
    new_scene(bench);
    EXPECT_TRUE(bench.session.scene().primitives.empty());
    EXPECT_FALSE(bench.session.frozen());
    for (int i = 0; i < 12; ++i) {
        add_segment(bench, random_segment(random));
        bench.session.run();
    }
    EXPECT_GT(bench.session.counters().rendered_count, 0u);
    for (int i = 0; i < 13; ++i) EXPECT_TRUE(undo(bench));
    EXPECT_FALSE(undo(bench)) << "one entry for the new scene";
    EXPECT_EQ(bench.session.shared_scene(), scene);
    EXPECT_EQ(bench.session.notes.size(), 1u);
    EXPECT_TRUE(bench.session.frozen());
}

TEST(Edit, ASavedSceneReadsBackBitForBit) {
    Random random(110);
    const auto file = std::filesystem::temp_directory_path() / ("sightline-edit-" + std::to_string(getpid()) + ".json");
    for (const Vec<2> origin : {Vec<2>(0, 0), Vec<2>(1800256, 5200128)}) {
        Scene<2> scene = test::random_scene(random, 20);
        scene.id = "far";
        scene.origin = origin;
        test::Bench on(Session<2>(std::make_shared<const Scene<2>>(scene), test::random_view(random), {}));
        add_segment(on.bench, random_segment(random));
        change_view(on.bench, test::random_view(random));
        save_scene(on.bench, file.string());
        const Scene<2> read = load_scene(file.string());
        EXPECT_EQ(scene_hash(read), scene_hash(on.bench.session.scene()));
        EXPECT_EQ(read.origin, origin);
        EXPECT_EQ(read.start_view, on.bench.session.culling_view());
    }
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace sightline
