// Hand-outs: the page that is written opens at what was on the bench.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/export/handout.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/session/headline.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

constexpr const char* stand_in =
    "<!doctype html>\n<title>Sightline</title>\n<script type=\"application/json\" id=\"handout\"></script>\n<script>"
    "\x01\xc4\x80</script>\n";

class Handouts : public test::Commands {
protected:
    Handouts() {
        write_file(file("built.html"), stand_in);
        bench->page = file("built.html");
    }
    /// What the page holds.
    std::string handout_of(const std::string& page) const {
        const std::string begin = "id=\"handout\">";
        const std::size_t at = page.find(begin) + begin.size();
        return page.substr(at, page.find("</script>", at) - at);
    }
    /// Another bench, after the page has been opened there.
    Workbench<2> opened(const std::string& name) {
        Workbench<2> fresh{.session = bench->session};
        fresh.say = [](const std::string& line) { EXPECT_FALSE(line.starts_with("warning")) << line; };
        run_commands(fresh, "open streets");
        open_handout(fresh, handout_of(read_file(file(name))), name);
        return fresh;
    }
};

TEST_F(Handouts, APageOpensAtExactlyWhatWasShown) {
    run("set penalty=none; step 7; note text 1,1 \"a </script> of <b>\"; select 12; bookmark here; show code; page " +
        file("a.html"));
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said.back().find("any browser opens it"), std::string::npos) << said.back();
    const std::string page = read_file(file("a.html"));
    EXPECT_EQ(page.substr(0, 40), std::string(stand_in).substr(0, 40));
    EXPECT_EQ(page.substr(page.find("</script>")),
              std::string(stand_in).substr(std::string(stand_in).find("</script>")))
        << "nothing in the text ends the script, and the rest of the page is as it was, byte for byte";
    const Workbench<2> there = opened("a.html");
    EXPECT_EQ(there.session.hash(), session().hash());
    EXPECT_EQ(there.session.position(), 7u);
    EXPECT_EQ(there.session.settings(), session().settings());
    EXPECT_EQ(there.session.selected_cell, 12u);
    ASSERT_EQ(there.session.notes.size(), 1u);
    EXPECT_EQ(there.session.notes[0].text, "a </script> of <b>");
    EXPECT_EQ(there.session.bookmarks, session().bookmarks);
    EXPECT_EQ(there.desk.right, "code");
    EXPECT_FALSE(there.teaching);
}

TEST_F(Handouts, BothRunsOfAComparisonGoAlong) {
    run("compare penalty=none; step 5; page " + file("c.html"));
    const Workbench<2> there = opened("c.html");
    ASSERT_TRUE(there.other);
    EXPECT_EQ(there.session.hash(), session().hash());
    EXPECT_EQ(there.other->session.hash(), other().session.hash());
    EXPECT_EQ(there.other->align, other().align);
}

TEST_F(Handouts, ALessonGoesOnWhereItStood) {
    run("lesson plp 2; next; next; page " + file("l.html"));
    Workbench<2> there = opened("l.html");
    ASSERT_TRUE(there.teaching);
    EXPECT_EQ(there.teaching->lesson.id, "plp");
    EXPECT_EQ(there.teaching->part, 1u);
    EXPECT_EQ(there.teaching->presses, 2u);
    EXPECT_EQ(there.session.hash(), session().hash());
    EXPECT_EQ(tells_truth(there.session), tells_truth(session())) << "what the class is to guess stays hidden";
    run("next");
    run_commands(there, "next");
    EXPECT_EQ(there.session.hash(), session().hash());
    EXPECT_EQ(there.teaching->presses, bench->teaching->presses);
}

TEST_F(Handouts, ALessonOfOnesOwnIsSaidToStayBehind) {
    run("lesson plp 1");
    bench->teaching->lesson.folder = folder;
    run("page " + file("o.html"));
    ASSERT_EQ(said.size(), 2u);
    EXPECT_NE(said[1].find("not the lesson"), std::string::npos) << said[1];
    EXPECT_FALSE(opened("o.html").teaching);
}

TEST_F(Handouts, SubstepsStand) {
    run("step 3; into; into; page " + file("s.html"));
    ASSERT_TRUE(bench->substep);
    EXPECT_EQ(opened("s.html").substep, bench->substep);
}

TEST_F(Handouts, ScenesThatNoGeneratorMakesTravelInside) {
    write_file(file("own.json"), R"({"format": "sightline-scene", "version": 1, "dimension": 2, "id": "own",
        "segments": [[0, 0, 4, 0], [4, 0, 4, 3], [1, 1, 2, 2.5]], "view": {"eye": [2, 1], "look_at": [4, 2], "fov": 90}})");
    run("open " + file("own.json") + "; step 2; page " + file("f.html"));
    std::filesystem::remove(file("own.json"));
    EXPECT_EQ(opened("f.html").session.hash(), session().hash());
    run("open streets; step 20; page " + file("g.html"));
    EXPECT_LT(std::filesystem::file_size(file("g.html")), 10'000u) << "a generated scene does not";
    EXPECT_EQ(opened("g.html").session.hash(), session().hash());
}

TEST_F(Handouts, APageOfAPageHasTheNewSession) {
    run("step 3; page " + file("a.html"));
    bench->page = file("a.html");
    run("step 4; page " + file("b.html"));
    EXPECT_EQ(opened("b.html").session.position(), 7u);
}

TEST_F(Handouts, WithoutAPageALineSaysWhatMakesOne) {
    bench->page = file("nowhere.html");
    test::expect_input_error([&] { run("page " + file("a.html")); },
                             "command *nowhere.html: there is no such page: ./run web makes one");
    bench->page = file("built.html");
    write_file(file("built.html"), "<!doctype html><title>Another page</title>");
    test::expect_input_error([&] { run("page " + file("a.html")); },
                             "command *is no page of Sightline that takes a session: ./run web makes one");
    EXPECT_FALSE(std::filesystem::exists(file("a.html")));
    EXPECT_EQ(page_of_the_project().filename(), "sightline.html");
}

TEST_F(Handouts, NonsenseChangesNothing) {
    run("step 3");
    const std::uint64_t hash = session().hash();
    auto json = nlohmann::ordered_json::parse(handout_text(*bench));
    for (const char* handout : {"7", "[]", R"({"lesson": 3})", R"({"lesson": "plp", "part": "x"})"}) {
        json["handout"] = nlohmann::ordered_json::parse(handout);
        try {
            open_handout(*bench, json.dump(), "h");
        } catch (const InputError&) {
        }
        EXPECT_EQ(session().hash(), hash) << handout;
    }
    for (const char* text : {"", "{", "[]", "3", R"({"handout": {}})"})
        EXPECT_THROW(open_handout(*bench, text, "h"), InputError) << text;
    json["handout"] = {{"lesson", "plp"}, {"part", 999}, {"presses", 999}, {"substep", 999}, {"panel", 7}};
    open_handout(*bench, json.dump(), "h");
    EXPECT_LT(bench->teaching->part, bench->teaching->lesson.parts.size());
}

}  // namespace
}  // namespace sightline
