// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/session/state_file.h"
#include "core/space/cells_file.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, open) {
    run("save " + file("o.json"));
    const std::uint64_t hash = session().hash();
    run("zoom-timeline 2-20; open streets");
    EXPECT_EQ(session().scene().id, "streets");
    EXPECT_EQ(bench->desk.timeline_from, 0) << "another run is shown as a whole";
    EXPECT_EQ(bench->desk.timeline_to, 1);
    run("open " + file("o.json"));
    EXPECT_EQ(session().hash(), hash);
    EXPECT_EQ(session().position(), 10u);
}

TEST_F(EachCommand, size) {
    run("size 400x300");
    EXPECT_EQ(bench->figure.size, "400x300");
    run("size 84mm 600dpi 7pt");
    EXPECT_EQ(bench->figure.size, "84mm");
    EXPECT_EQ(bench->figure.dpi, 600);
    EXPECT_EQ(bench->figure.font_pt, 7);
    run("size 400x300 8pt 300dpi");
}

TEST_F(EachCommand, shot) {
    const std::uint64_t hash = session().hash();
    run("shot " + file("a.svg") + "; shot \"" + file("b c;d.png") + "\"");
    EXPECT_EQ(session().hash(), hash);
    EXPECT_EQ(session().position(), 10u);
    for (const char* name : {"a.svg", "a.svg.json", "b c;d.png", "b c;d.png.json"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    EXPECT_EQ(open_state(read_file(file("a.svg.json")), "f").session.hash(), hash);
}

/// tests/shell/export/handout_test.cpp says what is in it.
TEST_F(EachCommand, page) {
    write_file(file("built.html"), "<script type=\"application/json\" id=\"handout\"></script>");
    bench->page = file("built.html");
    run("page " + file("h.html"));
    EXPECT_NE(read_file(file("h.html")).find("\"sightline-state\""), std::string::npos);
    EXPECT_THROW(run("page " + file("h.txt")), InputError);
    EXPECT_THROW(run("page"), InputError);
}

TEST_F(EachCommand, film) {
    const std::uint64_t hash = session().hash();
    run("size 200x150; film 2-4 " + file("f.png") + "; film 0-1 " + file("f.pdf"));
    for (const char* name : {"f-0001.png", "f-0002.png", "f-0003.png", "f.png.json", "f.pdf", "f.pdf.json"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    EXPECT_FALSE(std::filesystem::exists(folder / "f-0004.png"));
    run("film " + std::to_string(session().recorded() - 1) + "-end " + file("e.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "e-0002.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "e-0003.png"));
    EXPECT_EQ(session().hash(), hash);
    EXPECT_EQ(open_state(read_file(file("f.png.json")), "f").session.position(), 2u);
}

TEST_F(EachCommand, save) {
    run("save " + file("s.json"));
    EXPECT_EQ(open_state(read_file(file("s.json")), "f").session.hash(), session().hash());
}

TEST_F(EachCommand, cells) {
    run("cells " + file("c.cells"));
    EXPECT_EQ(read_cells<2>(file("c.cells"), session().scene(), session().settings()).cell_primitives,
              session().cells().cell_primitives);
}

TEST_F(EachCommand, trace) {
    run("trace " + file("t.json"));
    EXPECT_EQ(nlohmann::json::parse(read_file(file("t.json")))["steps"].size(), 10u);
}

TEST_F(EachCommand, stats) {
    run("stats " + file("q.json"));
    EXPECT_EQ(nlohmann::json::parse(read_file(file("q.json")))["steps"], 10);
}

TEST_F(EachCommand, copy) {
    std::string clip;
    bench->clipboard.set = [&](const std::string& text) { clip = text; };
    run("copy");
    EXPECT_EQ(open_state(clip, "clip").session.hash(), session().hash());
}

TEST_F(EachCommand, paste) {
    const std::string clip = state_json(session());
    bench->clipboard.get = [&] { return clip; };
    run("seek 3; paste");
    EXPECT_EQ(session().position(), 10u);
}

TEST_F(EachCommand, viewer3d) {
    // The tests' own folder has no viewer to start.
    EXPECT_THROW(run("viewer3d city:10k"), InputError);
}

TEST_F(EachCommand, quit) {
    run("quit; seek 3");
    EXPECT_TRUE(bench->quit);
    EXPECT_EQ(session().position(), 10u) << "nothing runs after quit";
}

}  // namespace
}  // namespace sightline
