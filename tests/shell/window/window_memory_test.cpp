// What the window remembers: written and read again, damaged, gone, unwritable.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "shell/desk/recent.h"
#include "shell/panels/panel.h"
#include "shell/window/memory.h"
#include "tests/scene/mutation.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;
using namespace test;
using Json = nlohmann::json;

class WindowMemory : public ::testing::Test {
protected:
    WindowMemory() { fs::create_directories(folder); }
    ~WindowMemory() override {
        std::error_code error;
        fs::permissions(folder, fs::perms::owner_all, error);
        fs::remove_all(folder);
    }
    fs::path folder = fs::temp_directory_path() / ("sightline-memory-" + std::to_string(getpid()));
    fs::path file = folder / "config" / "sightline" / "viewer2d.json";
};

std::string random_panel(Random& random, Column side) {
    std::vector<std::string> ids{""};
    for (const Panel<2>& panel : panel_table<2>())
        if (panel.column == side) ids.emplace_back(panel.id);
    return ids[random.below(ids.size())];
}

Memory random_memory(Random& random) {
    Memory m;
    if (random.below(4) > 0) {
        m.placement.width = smallest_width + static_cast<int>(random.below(4000));
        m.placement.height = smallest_height + static_cast<int>(random.below(4000));
    }
    if (random.below(2))
        m.placement.at = {static_cast<int>(random.below(5000)) - 1000, -static_cast<int>(random.below(9))};
    m.placement.maximised = random.below(2);
    m.desk.left = random_panel(random, Column::left);
    m.desk.right = random_panel(random, Column::right);
    m.desk.left_width = random.uniform(100, 4000);
    m.desk.right_width = random.uniform(100, 4000);
    m.desk.timeline_height = random.uniform(100, 4000);
    m.desk.timeline = random.below(2);
    m.desk.animate = random.below(2);
    m.desk.legend = random.below(2);
    m.desk.scale = random.uniform(smallest_scale, largest_scale);
    m.desk.axis = static_cast<TimelineAxis>(random.below(2));
    for (std::size_t i = random.below(most_recent + 1); i > 0; --i)
        m.recent.push_back("/scenes/\"quoted\" \xc3\xa4 " + std::to_string(random.bits()));
    return m;
}

void expect_equal(const Memory& a, const Memory& b) {
    EXPECT_EQ(a.placement, b.placement);
    EXPECT_EQ(a.desk, b.desk);
    EXPECT_EQ(a.recent, b.recent);
}

TEST_F(WindowMemory, ComesBackAsItWas) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Memory memory = random_memory(random);
        keep<2>(file, memory, recall<2>(file).memory.recent);
        const Recalled recalled = recall<2>(file);
        EXPECT_EQ(recalled.word, "");
        expect_equal(recalled.memory, memory);
    }
}

TEST_F(WindowMemory, OnlyWhatLastsIsKept) {
    Desk desk;
    desk.projector = desk.fullscreen = desk.chooser = desk.help = desk.console = true;
    desk.console_text = "quit";
    desk.tool = Tool::ring;
    desk.timeline_from = 0.25;
    EXPECT_EQ(lasting(desk), Desk{});
    desk.left = "settings";
    desk.left_width = 1e9;
    desk.right_width = -5;
    const Desk kept = lasting(desk);
    EXPECT_EQ(kept.left, "settings");
    expect_equal(read_memory<2>(memory_json({{}, kept, {}}), "m"), {{}, kept, {}});
}

TEST_F(WindowMemory, WhatAnOlderVersionDidNotWriteKeepsItsDefault) {
    Memory memory;
    memory.desk.left_width = 500;
    memory.desk.animate = false;
    auto older = nlohmann::json::parse(memory_json(memory));
    older["desk"].erase("animate");
    Memory expected = memory;
    expected.desk.animate = Desk{}.animate;
    expect_equal(read_memory<2>(older.dump(), "m"), expected);
}

TEST_F(WindowMemory, TheFirstTimeThereIsNothingToSay) {
    for (const fs::path& nothing : {file, fs::path()}) {
        const Recalled recalled = recall<2>(nothing);
        EXPECT_EQ(recalled.word, "");
        expect_equal(recalled.memory, {});
    }
    EXPECT_NO_THROW(keep<2>({}, {}, {}));
}

TEST_F(WindowMemory, WrongTypesAndAbsurdNumbersAreDamage) {
    Random random(2);
    Memory whole = random_memory(random);
    whole.placement = {800, 600, {{1, 2}}, false};
    whole.recent = {"rooms"};
    const Json good = Json::parse(memory_json(whole));
    ASSERT_NO_THROW(read_memory<2>(good.dump(), "m"));
    int tried = 0;
    const Json flat = good.flatten();
    for (const auto& [pointer, value] : flat.items())
        for (const char* bad : {"null", "true", "-1", "1e300", "1e999", "0.001", "\"no such panel\"", "\"\"", "[]",
                                "{}", "[[[[", "\"", "99999999999999999999"}) {
            Json broken = good;
            const Json::json_pointer at(pointer);
            broken[at] = "PLACE";
            std::string text = broken.dump();
            text.replace(text.find("\"PLACE\""), 7, bad);
            const Json parsed = Json::parse(text, nullptr, false);
            if (!parsed.is_discarded() && parsed[at].type() == value.type()) continue;  // may well be good
            // A whole number is a number.
            if (!parsed.is_discarded() && parsed[at].is_number() && value.is_number_float()) continue;
            if (!parsed.is_discarded() && parsed[at].is_number_integer() && value.is_number_integer()) continue;
            EXPECT_THROW(read_memory<2>(text, "m"), InputError) << pointer << " = " << bad;
            ++tried;
        }
    EXPECT_GT(tried, 100);
    const auto with = [&](const char* pointer, const Json& value) {
        Json broken = good;
        broken[Json::json_pointer(pointer)] = value;
        return broken.dump();
    };
    for (const auto& [pointer, value] : {std::pair{"/window/width", Json(3)},
                                         {"/window/width", Json(1 << 30)},
                                         {"/window/height", Json(-600)},
                                         {"/window/x", Json(1e9)},
                                         {"/window/x", Json(99999999999)},
                                         {"/desk/left_width", Json(1)},
                                         {"/desk/right_width", Json(1e9)},
                                         {"/desk/timeline_height", Json(-1)},
                                         {"/desk/scale", Json(0)},
                                         {"/desk/scale", Json(100)},
                                         {"/desk/left", Json("nowhere")},
                                         {"/desk/axis", Json("metres")},
                                         {"/format", Json("sightline-state")},
                                         {"/recent/0", Json("")},
                                         {"/recent", Json(std::vector<std::string>(most_recent + 1, "rooms"))}})
        EXPECT_THROW(read_memory<2>(with(pointer, value), "m"), InputError) << pointer << " " << value;
    // A panel that stood on the other side in an earlier version is hidden, and nothing is lost.
    EXPECT_EQ(read_memory<2>(with("/desk/left", Json("why")), "m").desk.left, "");
    EXPECT_EQ(read_memory<2>(with("/desk/right", Json("settings")), "m").desk.right, "");
}

TEST_F(WindowMemory, NothingThatIsReadIsOutOfBounds) {
    Random random(3);
    const std::string other = memory_json(random_memory(random));
    std::size_t read = 0;
    for (std::size_t i = 0; i < input_count(); ++i) {
        std::string text = memory_json(random_memory(random));
        for (std::size_t n = 1 + random.below(3); n > 0; --n) mutate(random, text, other, false);
        try {
            const Memory m = read_memory<2>(text, "m");
            ++read;
            EXPECT_LE(m.recent.size(), most_recent);
            EXPECT_TRUE(m.desk.left.empty() || find_panel<2>(m.desk.left));
            EXPECT_TRUE(m.desk.right.empty() || find_panel<2>(m.desk.right));
            expect_equal(read_memory<2>(memory_json(m), "m"), m);
            EXPECT_EQ(lasting(m.desk), m.desk);
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
    EXPECT_GT(read, 0u);
}

TEST_F(WindowMemory, ADamagedFileIsSetAsideWithAWord) {
    fs::create_directories(file.parent_path());
    for (const char* aside : {".damaged", ".damaged2", ".damaged3"}) {
        std::ofstream(file) << "{ broken " << aside;
        const Recalled recalled = recall<2>(file);
        EXPECT_NE(recalled.word.find("damaged"), std::string::npos);
        EXPECT_NE(recalled.word.find(file.string() + aside), std::string::npos) << recalled.word;
        EXPECT_EQ(recalled.word.find('\n'), std::string::npos);
        expect_equal(recalled.memory, {});
        EXPECT_FALSE(fs::exists(file));
        EXPECT_EQ(read_file(file.string() + aside), std::string("{ broken ") + aside);
    }
    EXPECT_EQ(recall<2>(file).word, "");
}

TEST_F(WindowMemory, AFolderInItsPlaceIsAWordAndAnError) {
    fs::create_directories(file);
    EXPECT_NE(recall<2>(file).word, "");
    EXPECT_TRUE(fs::is_directory(file));
    EXPECT_THROW(keep<2>(file, {}, {}), WorkError);
}

TEST_F(WindowMemory, WhereNoFolderCanBeIsAnError) {
    std::ofstream(folder / "config") << "a file";
    EXPECT_THROW(keep<2>(file, {}, {}), WorkError);
    EXPECT_EQ(recall<2>(file).word, "");
}

TEST_F(WindowMemory, IsPerUser) {
    const char* const home = std::getenv("HOME");
    const std::string kept = home ? home : "";
    const auto with = [](const char* xdg, const char* home) {
        setenv("XDG_CONFIG_HOME", xdg, 1);
        setenv("HOME", home, 1);
        return memory_file("viewer2d");
    };
    EXPECT_EQ(with("/x", "/h"), "/x/sightline/viewer2d.json");
    EXPECT_EQ(with("", "/h"), "/h/.config/sightline/viewer2d.json");
    EXPECT_EQ(with("relative", "/h"), "/h/.config/sightline/viewer2d.json");
    EXPECT_EQ(with("", ""), "");
    unsetenv("XDG_CONFIG_HOME");
    setenv("HOME", kept.c_str(), 1);
}

TEST_F(WindowMemory, TwoWindowsKeepEachOthersNames) {
    using Names = std::vector<std::string>;
    Memory one, two;
    one.recent = two.recent = {"a", "b"};
    Names known_one = keep<2>(file, one, {}), known_two = known_one;
    one.recent = {"c", "a", "b"};
    known_one = keep<2>(file, one, known_one);
    two.recent = {"d", "a", "b"};
    known_two = keep<2>(file, two, known_two);
    EXPECT_EQ(known_two, (Names{"d", "c", "a", "b"}));
    EXPECT_EQ(recall<2>(file).memory.recent, known_two);
    // One that only ends brings nothing new, and one that opens again what it had does.
    one.recent = known_one;
    EXPECT_EQ(keep<2>(file, one, known_one), (Names{"d", "c", "a", "b"}));
    EXPECT_EQ(merge_recent({"b", "a"}, {"c", "a", "b"}, {"a", "b"}), (Names{"b", "c", "a"}));
    EXPECT_EQ(merge_recent({"a"}, {"c", "a", "b"}, {"a", "b"}), (Names{"c", "a"})) << "b was dropped here";
    EXPECT_EQ(merge_recent({}, {"c"}, {}), Names{"c"});
    Names many;
    for (std::size_t i = 0; i < most_recent; ++i) many.push_back(std::to_string(i));
    EXPECT_EQ(merge_recent(many, {"x"}, many).size(), most_recent);
}

/// As many processes as there are windows, each with a scene of its own.
TEST_F(WindowMemory, NoNameIsLostWhereManyWindowsWriteAtOnce) {
    for (int round = 0; round < 20; ++round) {
        fs::remove(file);
        std::vector<pid_t> windows;
        for (int i = 0; i < 6; ++i) {
            windows.push_back(fork());
            if (windows.back() != 0) continue;
            Memory mine;
            mine.recent = {"scene " + std::to_string(i)};
            keep<2>(file, mine, {});
            _exit(0);
        }
        for (const pid_t window : windows) waitpid(window, nullptr, 0);
        ASSERT_EQ(recall<2>(file).memory.recent.size(), 6u) << "round " << round;
    }
}

TEST_F(WindowMemory, TheNewestNameIsFirstAndOnlyOnce) {
    std::vector<std::string> recent;
    note_opened<2>(recent, "rooms");
    note_opened<2>(recent, "cars");
    note_opened<2>(recent, "rooms");
    EXPECT_EQ(recent, (std::vector<std::string>{"rooms", "cars"}));
    const fs::path before = fs::current_path();
    std::ofstream(folder / "map.wad") << "?";
    fs::current_path(folder);
    note_opened<2>(recent, "map.wad#E1M1");
    note_opened<2>(recent, "map.wad");
    fs::current_path(before);
    EXPECT_EQ(recent[0], (folder / "map.wad").string());
    EXPECT_EQ(recent[1], (folder / "map.wad").string() + "#E1M1");
    for (int i = 0; i < 20; ++i) note_opened<2>(recent, "freedoom1#E1M" + std::to_string(i));
    EXPECT_EQ(recent.size(), most_recent);
    EXPECT_EQ(recent[0], "freedoom1#E1M19");
}

TEST_F(WindowMemory, AnIdOfTheOtherViewersCatalogueIsAFileHere) {
    const fs::path before = fs::current_path();
    std::vector<std::string> recent;
    std::ofstream(folder / "city") << "?";  // a scene in 3D only
    fs::current_path(folder);
    note_opened<2>(recent, "city");
    note_opened<3>(recent, "city");
    fs::current_path(before);
    EXPECT_EQ(recent, (std::vector<std::string>{"city", (folder / "city").string()}));
}

}  // namespace
}  // namespace sightline
