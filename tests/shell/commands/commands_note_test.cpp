// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, note) {
    run("note text 1,2 \"a; b\"; note callout cell:3 [4,-5.5] first; note callout primitive:2 second; "
        "note ring 0,0");
    const auto& notes = session().notes;
    ASSERT_EQ(notes.size(), 4u);
    EXPECT_EQ(notes[0].text, "a; b");
    EXPECT_EQ(notes[0].point, Vec<2>(1, 2));
    EXPECT_EQ(notes[1].anchor, Note<2>::Anchor::cell);
    EXPECT_EQ(notes[1].index, 3u);
    EXPECT_EQ(notes[1].offset_pt, Vec<2>(4, -5.5));
    EXPECT_EQ(notes[1].text, "first");
    EXPECT_EQ(notes[1].number, 1u);
    EXPECT_EQ(notes[2].anchor, Note<2>::Anchor::primitive);
    EXPECT_EQ(notes[2].number, 2u);
    EXPECT_EQ(notes[3].kind, Note<2>::Kind::ring);
}

TEST_F(EachCommand, note_edit) {
    const std::size_t before = session().notes.size();
    run("note text 1,1 {3-20} first; note-edit " + std::to_string(before + 1) + " other words");
    EXPECT_EQ(session().notes.back().text, "other words");
    EXPECT_EQ(session().notes.back().first_step, 3u);
    EXPECT_EQ(session().notes.back().last_step, 20u);
    const std::string n = std::to_string(before + 1);
    run("note-edit " + n + " [3,-4]; note-edit " + n + " {5-}; note-edit " + n + " at cell:6");
    EXPECT_EQ(session().notes.back().offset_pt, Vec<2>(3, -4));
    EXPECT_EQ(session().notes.back().last_step, none);
    EXPECT_EQ(session().notes.back().anchor, Note<2>::Anchor::cell);
    EXPECT_EQ(session().notes.back().index, 6u);
    EXPECT_EQ(session().notes.back().text, "other words");
    run(quote_command("note-edit " + n + " {0-} say \"delete; me\""));
    EXPECT_EQ(session().notes.back().text, "say \"delete; me\"");
    run("select note:" + n + "; note-edit selected {0-} delete");
    EXPECT_EQ(session().notes.back().text, "delete");
    run("note-edit " + n + " delete");
    EXPECT_EQ(session().notes.size(), before);
}

}  // namespace
}  // namespace sightline
