// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/state_file.h"
#include "core/session/settings_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/scene/read/read_json.h"
#include "tests/scene/mutation.h"
#include "tests/scene/scene_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using Json = nlohmann::ordered_json;

std::string random_text(Random& random) {
    constexpr const char* pieces[] = {"a", "ρ", "\"", "\\", "\n", "; ", "</b>", "\x01", "7", ""};
    std::string text;
    for (std::uint64_t k = random.below(6); k > 0; --k) text += pieces[random.below(std::size(pieces))];
    return text;
}

std::vector<Note<2>> random_notes(Random& random, const Session<2>& session) {
    std::vector<Note<2>> notes(random.below(4));
    for (Note<2>& note : notes) {
        note.kind = static_cast<Note<2>::Kind>(random.below(4));
        note.anchor = static_cast<Note<2>::Anchor>(random.below(3));
        if (note.anchor == Note<2>::Anchor::cell && session.cells().cell_count() > 0)
            note.index = static_cast<std::uint32_t>(random.below(session.cells().cell_count()));
        else if (note.anchor == Note<2>::Anchor::primitive && !session.scene().primitives.empty())
            note.index = static_cast<std::uint32_t>(random.below(session.scene().primitives.size()));
        else
            note.anchor = Note<2>::Anchor::point;
        if (note.anchor == Note<2>::Anchor::point) note.point = {random.uniform(-9, 9), random.uniform(-9, 9)};
        note.offset_pt = {random.uniform(-30, 30), random.uniform(-30, 30)};
        note.text = random_text(random);
        if (note.kind == Note<2>::Kind::callout) note.number = static_cast<std::uint32_t>(random.below(20));
        if (random.below(2)) note.first_step = static_cast<std::uint32_t>(random.below(20));
        if (random.below(2)) note.last_step = static_cast<std::uint32_t>(random.below(20));
    }
    return notes;
}

void expect_same_notes(const std::vector<Note<2>>& a, const std::vector<Note<2>>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].kind, b[i].kind);
        ASSERT_EQ(a[i].anchor, b[i].anchor);
        ASSERT_EQ(a[i].point, b[i].point);
        ASSERT_EQ(a[i].index, b[i].index);
        ASSERT_EQ(a[i].offset_pt, b[i].offset_pt);
        ASSERT_EQ(a[i].text, b[i].text);
        ASSERT_EQ(a[i].number, b[i].number);
        ASSERT_EQ(a[i].first_step, b[i].first_step);
        ASSERT_EQ(a[i].last_step, b[i].last_step);
    }
}

void expect_same(const Session<2>& a, const Session<2>& b) {
    ASSERT_EQ(scene_hash(a.scene()), scene_hash(b.scene()));
    ASSERT_EQ(a.scene().id, b.scene().id);
    ASSERT_EQ(a.scene().title, b.scene().title);
    ASSERT_EQ(a.scene().source, b.scene().source);
    ASSERT_EQ(a.scene().seed, b.scene().seed);
    ASSERT_EQ(a.scene().dropped, b.scene().dropped);
    ASSERT_EQ(a.settings(), b.settings());
    ASSERT_EQ(a.position(), b.position());
    ASSERT_EQ(a.hash(), b.hash());
    ASSERT_EQ(a.time_stop(), b.time_stop());
    ASSERT_EQ(a.culling_view(), b.culling_view());
    ASSERT_EQ(a.frozen(), b.frozen());
    ASSERT_EQ(a.display_view(), b.display_view());
    ASSERT_EQ(a.selected_cell, b.selected_cell);
    ASSERT_EQ(a.selected_primitive, b.selected_primitive);
    ASSERT_EQ(a.bookmarks, b.bookmarks);
    ASSERT_EQ(a.breakpoints, b.breakpoints);
    expect_same_notes(a.notes, b.notes);
}

TEST(StateFile, OpensWhatWasSaved) {
    Random random(61);
    for (int i = 0; i < test::soak_count(300); ++i) {
        test::Start start = test::random_start(random);
        Scene<2> scene = *start.scene;
        scene.id = "scene " + std::to_string(i);
        scene.title = random_text(random);
        scene.seed = random.bits();
        scene.source = random.below(2) ? "generated" : "json";
        if (random.below(2)) scene.origin = {1.8e6, -5.2e6};
        scene.dropped.degenerate = random.below(3);
        // A scene as readers make it: without duplicates.
        scene = read_json(write_json(scene), "made");
        start.scene = std::make_shared<const Scene<2>>(scene);
        start.settings.palette = static_cast<Palette>(random.below(3));
        start.settings.zoom = random.uniform(0.5, 20);
        start.settings.zoom_at = static_cast<ZoomAt>(random.below(4));
        start.settings.zoom_x = random.uniform(-1e7, 1e7);
        start.settings.zoom_y = -start.settings.zoom_x / 3;
        if (random.below(4) == 0)
            start.settings.budget = {Budget::Kind::share, static_cast<double>(random.below(100)) / 100};
        if (random.below(4) == 0) start.settings.budget = parse_budget("0ms");
        Session<2> session = start.session();
        random.below(2) ? session.seek(static_cast<std::uint32_t>(random.below(40))) : session.run();
        if (random.below(2)) session.seek(static_cast<std::uint32_t>(random.below(session.position() + 1)));
        session.notes = random_notes(random, session);
        for (std::uint64_t k = random.below(3); k > 0; --k)
            session.bookmarks.push_back({static_cast<std::uint32_t>(random.below(50)), random_text(random)});
        if (random.below(2) && session.cells().cell_count() > 0)
            session.selected_cell = static_cast<std::uint32_t>(random.below(session.cells().cell_count()));
        if (random.below(2) && !scene.primitives.empty())
            session.selected_primitive = static_cast<std::uint32_t>(random.below(scene.primitives.size()));
        for (const char* condition : {"rho > 0.8 && visible_share == 0", "step:7", "cell:3"})
            if (random.below(3) == 0) session.breakpoints.push_back({condition, random.below(2) == 0});
        if (random.below(2)) {
            session.freeze();
            if (random.below(2)) session.set_view(test::random_view(random));
        }
        FigureSpec figure;
        figure.size = random.below(2) ? "120mm" : "640x480";
        figure.font_pt = random.uniform(4, 12);
        figure.dpi = random.uniform(72, 1200);
        figure.columns = static_cast<std::uint32_t>(random.below(5));
        for (std::uint64_t k = random.below(3); k > 0; --k) figure.panels.push_back(random_text(random));

        const std::string text = state_json(session, figure);
        const OpenedState opened = open_state(text, "file.json");
        ASSERT_TRUE(opened.warnings.empty()) << opened.warnings.front();
        expect_same(opened.session, session);
        if (HasFatalFailure()) FAIL() << "session " << i;
        ASSERT_EQ(opened.figure.size, figure.size);
        ASSERT_EQ(opened.figure.font_pt, figure.font_pt);
        ASSERT_EQ(opened.figure.panels, figure.panels);
        ASSERT_EQ(opened.figure.dpi, figure.dpi);
        ASSERT_EQ(opened.figure.columns, figure.columns);
        // Saving it again gives the same file.
        ASSERT_EQ(state_json(opened.session, opened.figure), text);
        ASSERT_FALSE(opened.other);
    }
}

TEST(StateFile, OpensTwoSessionsBesideEachOther) {
    Random random(64);
    for (int i = 0; i < test::soak_count(100); ++i) {
        const test::Start start = test::random_start(random);
        test::Start beside = random.below(2) ? start : test::random_start(random);
        beside.settings = test::random_settings(random);
        // As readers make them: without duplicates.
        const auto cleaned = [](const test::Start& s) {
            Session<2> session = s.session();
            session.set_scene(std::make_shared<const Scene<2>>(read_json(write_json(session.scene()), "made")));
            return session;
        };
        Session<2> session = cleaned(start), other = cleaned(beside);
        session.seek(static_cast<std::uint32_t>(random.below(30)));
        other.seek(static_cast<std::uint32_t>(random.below(30)));
        other.breakpoints.push_back({"step:3", false});
        if (random.below(2)) other.selected_cell = 0;
        if (other.cells().cell_count() == 0) other.selected_cell = none;
        const Align align = random.below(2) ? Align::step : Align::rendered;
        const std::string text = state_json(session, {}, &other, align);
        const OpenedState opened = open_state(text, "file.json");
        ASSERT_TRUE(opened.warnings.empty()) << opened.warnings.front();
        ASSERT_TRUE(opened.other);
        expect_same(opened.session, session);
        expect_same(*opened.other, other);
        if (HasFatalFailure()) FAIL() << "session " << i;
        ASSERT_EQ(opened.align, align);
        const bool same = scene_hash(session.scene()) == scene_hash(other.scene());
        ASSERT_EQ(Json::parse(text)["other"].contains("scene"), !same);
        ASSERT_EQ(opened.session.shared_scene() == opened.other->shared_scene(), same);
        ASSERT_EQ(state_json(opened.session, opened.figure, &*opened.other, opened.align), text);
    }
}

TEST(StateFile, EmbedsSmallScenesAndNamesLargeOnes) {
    Session<2> small(std::make_shared<const Scene<2>>(make_scene(*find_in_catalogue("bottleneck"))),
                     find_in_catalogue("bottleneck")->view, {});
    const Json with = Json::parse(state_json(small));
    EXPECT_TRUE(with["scene"].contains("embedded"));

    // A file whose own id is not its name, which is no text: it must still be found again.
    Random random(62);
    Scene<2> large;
    large.id = "large";
    large.seed = 9;
    while (large.primitives.size() < 20000) {
        const Vec<2> at(random.unit() * 100, random.unit() * 100);
        large.primitives.push_back({at, at + Vec<2>(random.unit(), random.unit())});
    }
    const std::string bytes = write_json(large);
    ASSERT_GT(bytes.size(), embed_limit_bytes);
    test::TemporaryFile file("sightline_large_\xff.json", bytes);
    auto scene = std::make_shared<const Scene<2>>(load_scene(file.path()));
    Settings settings;
    settings.error_bound = 0.2;
    Session<2> session(scene, {{50, 50}, {60, 50}, 90}, settings);
    session.seek(7);
    const std::string text = state_json(session);
    EXPECT_LT(text.size(), 10000u);
    const Json json = Json::parse(text);
    EXPECT_FALSE(json["scene"].contains("embedded"));
    EXPECT_EQ(json["scene"]["id"], "large");
    EXPECT_EQ(json["scene"]["seed"], 9);
    EXPECT_EQ(json["scene"]["hash"], hash_text(scene_hash(*scene)));
    expect_same(open_state(text, "file.json").session, session);

    // The file has changed since: not the same scene.
    large.primitives[123][1].x += 1;
    test::TemporaryFile changed("sightline_large_\xff.json", write_json(large));
    test::expect_input_error([&] { open_state(text, "file.json"); },
                             "file.json: scene 'large' is not the one the state was made with (its hash differs)");
    std::filesystem::remove(file.path());
    test::expect_input_error([&] { open_state(text, "file.json"); }, "file.json: *");
}

Json good_state() {
    const CatalogueRow<2>& row = *find_in_catalogue("bottleneck");
    Settings settings;
    settings.error_bound = row.error_bound;
    Session<2> session(std::make_shared<const Scene<2>>(make_scene(row)), row.view, settings);
    session.seek(9);
    session.notes.push_back({});
    session.notes.back().text = "here";
    session.bookmarks.push_back({4, "a place"});
    session.breakpoints.push_back({"rho > 0.5", true});
    session.selected_cell = 3;
    session.selected_primitive = 5;
    session.freeze();
    session.set_view({{1, 2}, {3, 4}, 50});
    Session<2> other = session;
    apply_setting(settings, "penalty=none");
    other.change(settings);
    return Json::parse(state_json(session, {"84mm", 8, {"step 1", "end"}}, &other, Align::rendered));
}

TEST(StateFile, AChangedSceneIsRefused) {
    for (const bool embedded : {true, false}) {
        Json json = good_state();
        if (!embedded) json["scene"].erase("embedded");
        EXPECT_NO_THROW(open_state(json.dump(), "f"));
        Json other = json;
        other["scene"]["hash"] = "0123456789abcdef";
        test::expect_input_error([&] { open_state(other.dump(), "f"); },
                                 "f: scene 'bottleneck' is not the one the state was made with (its hash differs)");
        if (!embedded) continue;
        other = json;
        auto& x = other["scene"]["embedded"]["segments"][0][0];
        x = x.get<double>() + 0.5;
        test::expect_input_error([&] { open_state(other.dump(), "f"); },
                                 "f: scene 'bottleneck' is not the one the state was made with (its hash differs)");
    }
}

TEST(StateFile, BadContentIsOneLineThatNamesTheFile) {
    const Json good = good_state();
    ASSERT_NO_THROW(open_state(good.dump(), "f"));
    // Every value replaced by one that cannot be meant.
    struct Damage {
        const char* place;
        Json value;
    };
    const Damage damages[] = {
        {"/format", "sightline-scene"},
        {"/version", 2},
        {"/scene", 7},
        {"/scene/embedded", "x"},
        {"/scene/embedded", Json::array()},
        {"/scene/embedded/segments", 7},
        {"/scene/embedded/segments/0/0", "x"},
        {"/scene/hash", 7},
        {"/settings", "x"},
        {"/settings", 7},
        {"/settings/method", "nothing"},
        {"/settings/jitter", 0.02},
        {"/settings/jitter", "0.6"},
        {"/settings/jiter", "0.1"},
        {"/settings/palette", "blue\nred"},
        {"/settings/budget", "-1"},
        {"/view", Json::array()},
        {"/view/eye", 7},
        {"/view/eye", Json::array({1})},
        {"/view/eye", Json::array({"1", "2"})},
        {"/view/eye", Json::array({nullptr, nullptr})},
        {"/view/eye", Json::array({1, 2, 3})},
        {"/view/look_at", good["view"]["eye"]},
        {"/view/fov", 0},
        {"/view/fov", "60"},
        {"/step", -1},
        {"/step", 1.5},
        {"/step", 4294967296},
        {"/step", 1e300},
        {"/step", 18446744073709551615u},
        {"/step", "9"},
        {"/step", nullptr},
        {"/step", true},
        {"/time_stop", -1},
        {"/time_stop", 1e300},
        {"/state_hash", 7},
        {"/display_view/eye", good["display_view"]["look_at"]},
        {"/bookmarks", 7},
        {"/bookmarks", "x"},
        {"/bookmarks/0", 7},
        {"/bookmarks/0/step", -1},
        {"/bookmarks/0/step", 1e12},
        {"/bookmarks/0/label", 7},
        {"/notes", 7},
        {"/notes/0", "x"},
        {"/notes/0/kind", "blob"},
        {"/notes/0/kind", 2},
        {"/notes/0/anchor", "moon"},
        {"/notes/0/text", 7},
        {"/notes/0/offset_pt", Json::array({1})},
        {"/notes/0/point", Json::array({1})},
        {"/notes/0/first_step", -1},
        {"/notes/0/last_step", "x"},
        {"/notes/0/number", -5},
        {"/notes/0/number", "x"},
        {"/selected_cell", 99999999},
        {"/selected_cell", -1},
        {"/selected_cell", "x"},
        {"/selected_primitive", 99999999},
        {"/selected_primitive", -1},
        {"/breakpoints", 7},
        {"/breakpoints/0", "x"},
        {"/breakpoints/0/condition", 7},
        {"/breakpoints/0/condition", "rho >"},
        {"/breakpoints/0/condition", "nothing > 2"},
        {"/breakpoints/0/on", "yes"},
        {"/align", "sideways"},
        {"/align", 1},
        {"/other", 7},
        {"/other", Json::array()},
        {"/other", nullptr},
        {"/other/format", "sightline-scene"},
        {"/other/version", 2},
        {"/other/scene", 7},
        {"/other/scene", Json::object()},
        {"/other/settings/jitter", "0.6"},
        {"/other/settings/method", "nothing"},
        {"/other/view/eye", 7},
        {"/other/step", -1},
        {"/other/selected_primitive", 99999999},
        {"/other/breakpoints/0/condition", "rho >"},
        {"/other/notes/0/kind", "blob"},
        {"/figure", 7},
        {"/figure/size", 84},
        {"/figure/font_pt", "8"},
        {"/figure/panels", "step 1"},
        {"/figure/panels", Json::array({1})},
    };
    for (const Damage& damage : damages) {
        Json json = good;
        json[Json::json_pointer(damage.place)] = damage.value;
        SCOPED_TRACE(std::string(damage.place) + " = " + damage.value.dump());
        const bool in_other = std::string_view(damage.place).starts_with("/other");
        test::expect_input_error([&] { open_state(json.dump(), "file.json"); },
                                 in_other ? "file.json: other: *" : "file.json: *");
    }
    for (const char* place : {"/format",
                              "/version",
                              "/scene",
                              "/scene/id",
                              "/settings",
                              "/view",
                              "/view/eye",
                              "/view/look_at",
                              "/view/fov",
                              "/step",
                              "/notes/0/kind",
                              "/notes/0/anchor",
                              "/notes/0/text",
                              "/notes/0/offset_pt",
                              "/notes/0/point",
                              "/bookmarks/0/step",
                              "/bookmarks/0/label",
                              "/display_view/eye",
                              "/figure/size",
                              "/breakpoints/0/condition",
                              "/breakpoints/0/on",
                              "/other/format",
                              "/other/settings",
                              "/other/view",
                              "/other/step"}) {
        Json json = good;
        const Json::json_pointer at(place);
        if (std::string_view(place) == "/scene/id") json["scene"].erase("embedded");
        json[at.parent_pointer()].erase(at.back());
        SCOPED_TRACE(place);
        test::expect_input_error([&] { open_state(json.dump(), "file.json"); }, "file.json: *");
    }
    Json anchored = good;
    anchored["notes"][0] = {
        {"kind", "text"}, {"anchor", "cell"}, {"text", ""}, {"offset_pt", {0, 0}}, {"index", 1000000}};
    test::expect_input_error([&] { open_state(anchored.dump(), "f"); },
                             "f: a note is anchored to something that does not exist");
    for (const std::string text :
         {"", "{", "[]", "7", "null", "\"x\"", "{}", "\xff\xfe", "{\"format\":\"sightline-state\"}", "not json"})
        test::expect_input_error([&] { open_state(text, "file.json"); }, "file.json: *");
    const std::string whole = good.dump(1);
    for (std::size_t size = 0; size < whole.size(); size += 97)
        test::expect_input_error([&] { open_state(whole.substr(0, size), "file.json"); }, "file.json: *");
    // Deep nesting must not use up the stack.
    for (const char* place : {"/scene/embedded", "/notes", "/bookmarks", "/figure/panels", "/unknown"}) {
        Json json = good;
        json[Json::json_pointer(place)] = "HERE";
        std::string text = json.dump();
        text.replace(text.find("\"HERE\""), 6, std::string(300000, '[') + std::string(300000, ']'));
        test::expect_input_error([&] { open_state(text, "file.json"); }, "file.json: *");
    }
}

TEST(StateFile, WarnsWhenTheTraversalIsAnother) {
    Json json = good_state();
    json["state_hash"] = "0000000000000000";
    auto opened = open_state(json.dump(), "f");
    ASSERT_EQ(opened.warnings, std::vector<std::string>{"f: step 9 differs from what was saved"});
    json["other"]["state_hash"] = "0000000000000000";
    ASSERT_EQ(open_state(json.dump(), "f").warnings.back(), "f: other: step 9 differs from what was saved");
    json.erase("other");
    json["step"] = 4000000000u;
    opened = open_state(json.dump(), "f");
    ASSERT_EQ(opened.warnings.size(), 1u);
    EXPECT_EQ(opened.warnings[0].find("f: the traversal ends at step "), 0u) << opened.warnings[0];
}

TEST(StateFile, WhateverComesOnlyInputErrorsEscape) {
    Json named = good_state();
    named["scene"].erase("embedded");
    Json embedded = good_state();
    auto& segments = embedded["scene"]["embedded"]["segments"];
    segments.erase(segments.begin() + 12, segments.end());
    embedded["scene"].erase("hash");
    const std::vector<std::string> seeds{named.dump(), embedded.dump()};
    for (const std::string& seed : seeds) ASSERT_NO_THROW(open_state(seed, "seed"));
    Random random(63);
    std::size_t read = 0, refused = 0;
    for (std::size_t i = 0; i < test::input_count(); ++i) {
        std::string bytes = seeds[random.below(seeds.size())];
        for (std::uint64_t k = 1 + random.below(3); k > 0; --k)
            test::mutate(random, bytes, seeds[random.below(seeds.size())], false);
        try {
            const OpenedState opened = open_state(bytes, "file.json");
            state_json(opened.session, opened.figure, opened.other ? &*opened.other : nullptr, opened.align);
            ++read;
        } catch (const InputError& error) {
            ++refused;
            const std::string what = error.what();
            ASSERT_EQ(what.find("file.json: "), 0u) << what;
            ASSERT_EQ(what.find_first_of("\n\r"), std::string::npos) << what;
        } catch (const std::exception& error) {
            FAIL() << "input " << i << " lets escape: " << error.what();
        }
    }
    EXPECT_GT(read, test::input_count() / 50);
    EXPECT_GT(refused, test::input_count() / 50);
}

}  // namespace
}  // namespace sightline
