// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/command_table.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/session/report.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::Commands;

TEST_F(Commands, EachHasAnIdOfItsOwnALineOfHelpAndATest) {
    std::set<std::string> known;
    for (const Command<2>& command : command_table<2>()) {
        EXPECT_TRUE(known.emplace(command.id).second) << command.id << " stands twice in the table";
        EXPECT_FALSE(command.text.empty()) << command.id;
    }
    EXPECT_EQ(test::tested_commands("EachCommand"), known);
}

TEST_F(Commands, SeparatorsAndQuotes) {
    run("  ;; step ;\n step\t;");
    EXPECT_EQ(session().position(), 2u);
    run("");
    run(";;;");
    run("\"step\"");
    EXPECT_EQ(session().position(), 3u);
    run("bookmark \"a;b\"; seek 0; seek \"@a;b\"");
    EXPECT_EQ(session().position(), 3u);
    run("step   2");
    EXPECT_EQ(session().position(), 5u);
    const std::uint32_t before = session().position();
    test::expect_input_error([&] { run("step; note text 0,0 \"open"); }, "commands: a quote is not closed");
    EXPECT_EQ(session().position(), before) << "nothing runs when the text is not understood";
}

TEST_F(Commands, AColonBeforeOneIsIgnored) {
    run(":step 3; :back");
    EXPECT_EQ(session().position(), 2u);
    EXPECT_EQ(slow_word<2>(":auto again"), slow_word<2>("auto again"));
    EXPECT_NE(slow_word<2>(":auto again"), "");
    EXPECT_THROW(run(":"), InputError);
}

TEST_F(Commands, ErrorsNameTheCommandAndChangeNothing) {
    run("seek 10");
    const std::uint64_t hash = session().hash();
    const Settings before = session().settings();
    const ViewSpec<2> view = session().culling_view();
    for (const std::string command : {"step x",
                                      "step -1",
                                      "step 1.5",
                                      "step 1e10",
                                      "back x",
                                      "seek",
                                      "seek x",
                                      "seek -1",
                                      "seek @nowhere",
                                      "until",
                                      "until rho >",
                                      "until solidity > 1",
                                      "until step = 3",
                                      "eye",
                                      "eye 1",
                                      "eye 1,2,3",
                                      "eye nan,1",
                                      "eye 1,1e999",
                                      "eye 8,8",
                                      "look 8,2.05",
                                      "look x,y",
                                      "fov",
                                      "fov x",
                                      "fov 0",
                                      "fov 180",
                                      "fov -90",
                                      "fov 361",
                                      "set",
                                      "set jitter",
                                      "set jitter=2",
                                      "set colour=red",
                                      "set method=none",
                                      "preset",
                                      "preset nothing",
                                      "method",
                                      "method none",
                                      "budget",
                                      "budget -1",
                                      "budget five",
                                      "select",
                                      "select x",
                                      "select 999999",
                                      "select -1",
                                      "bookmark",
                                      "note",
                                      "note blob 0,0 x",
                                      "select note:1",
                                      "select note:0",
                                      "note-edit selected x",
                                      "zoom",
                                      "zoom 0",
                                      "zoom -1",
                                      "pan",
                                      "pan 1",
                                      "pan a,b",
                                      "note text",
                                      "note text 0 x",
                                      "note text cell:999999 x",
                                      "note text cell:x y",
                                      "note text primitive:999999 x",
                                      "note text 0,0 [1] x",
                                      "note text 0,0 [1,2 x",
                                      "note text 0,0 [a,b] x",
                                      "explain nothing",
                                      "explain step",
                                      "explain step 11",
                                      "explain step x",
                                      "explain cell",
                                      "explain cell 999999",
                                      "size",
                                      "size 84",
                                      "size 0mm",
                                      "size -84mm",
                                      "size 0x0",
                                      "size x",
                                      "size 84mm dpi",
                                      "size 1dpi",
                                      "size 0pt",
                                      "shot",
                                      "compare",
                                      "compare nothing-like-this",
                                      "compare preset:nothing",
                                      "compare jitter=2",
                                      "compare jitter=0.1,colour=red",
                                      "compare method=none",
                                      "compare two_sided=on",
                                      "align step",
                                      "align by ear",
                                      "difference",
                                      "swap",
                                      "segment",
                                      "segment add",
                                      "segment add 1,1",
                                      "segment add 1,1 1,1",
                                      "segment add 1,1 2",
                                      "segment add 1,1 1e200,1",
                                      "segment add 1,1 nan,1",
                                      "segment move 0",
                                      "segment move 0 1,1 1,1",
                                      "segment move 999999 1,1 2,2",
                                      "segment move selected 1,1 2,2",
                                      "segment delete",
                                      "segment delete x",
                                      "segment delete 999999",
                                      "segment delete 0 1",
                                      "scene",
                                      "scene old",
                                      "scene save",
                                      "film",
                                      "film 1-2",
                                      "film 2 a.png",
                                      "film 3-2 a.png",
                                      "film 999998-999999 a.png",
                                      "film x-end a.png",
                                      "film x-2 a.png",
                                      "film 1-2 a.svg",
                                      "film 1-2 a.gif 0fps",
                                      "film 1-2 a.gif xfps",
                                      "shot a.gif",
                                      "shot a",
                                      "save",
                                      "trace",
                                      "stats"}) {
        SCOPED_TRACE(command);
        test::expect_input_error([&] { run(command); }, "command '" + command + "': *");
        EXPECT_EQ(session().hash(), hash);
        EXPECT_FALSE(bench->other);
        EXPECT_EQ(session().settings(), before);
        EXPECT_EQ(session().culling_view(), view);
        EXPECT_TRUE(session().notes.empty());
        EXPECT_TRUE(session().bookmarks.empty());
        EXPECT_EQ(bench->figure.size, "84mm");
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    for (const Command<2>& command : command_table<2>())
        test::expect_input_error(
            [&] { run(std::string(command.id) + "x"); },
            "command '" + std::string(command.id) + "x' does not exist; did you mean " + std::string(command.id) + "?");
    test::expect_input_error([&] { run("qqqqqq"); }, "command 'qqqqqq' does not exist; there are step, back, *");
    // Those before the wrong one were carried out.
    EXPECT_THROW(run("step 2; nothing; step 2"), InputError);
    EXPECT_EQ(session().position(), 12u);
    // A place that cannot be written is no wrong usage.
    EXPECT_THROW(run("save " + file("missing/s.json")), WorkError);
}

TEST_F(Commands, WhatTakesLongIsToldBeforeWhereverItStands) {
    const std::string_view word = slow_word<2>("film 1-2 a.gif");
    EXPECT_NE(word, "");
    for (const char* text : {"run; film 1-2 a.gif", " film 1-2 a.gif", "step 3;film 1-2 \"a;b.gif\"; quit"})
        EXPECT_EQ(slow_word<2>(text), word) << text;
    EXPECT_EQ(slow_word<3>("fly; film path 0-3 a.gif"), word);
    for (const char* text : {"", ";", "run; step", "shot film.png", "note text 1,1 \"; film 1-2 a.gif\"",
                             "filmx 1-2 a.gif", "film 1-2 \"a.gif"})
        EXPECT_EQ(slow_word<2>(text), "") << text;
}

TEST_F(Commands, StatsTellWhyTheSessionStandsWhereItDoes) {
    const auto stop = [&](const std::string& commands) {
        run(commands);
        return nlohmann::json::parse(stats_json(session(), bench->last_stop))["stop"].get<std::string>();
    };
    EXPECT_EQ(stop("seek 5"), "steps");
    EXPECT_EQ(stop("until step:7"), "breakpoint");
    EXPECT_EQ(stop("back 2"), "steps");
    EXPECT_EQ(stop("run"), "front empty");
    EXPECT_EQ(stop("budget 10; run"), "budget");
    EXPECT_EQ(stop("seek 99999"), "budget");
}

}  // namespace
}  // namespace sightline
