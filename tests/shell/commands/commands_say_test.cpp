// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, explain) {
    run("explain");
    EXPECT_EQ(said.at(0).find("Step 10: "), 0u) << said[0];
    run("explain step 4");
    EXPECT_EQ(said.at(0).find("Step 4: "), 0u);
    run("explain cell 3");
    EXPECT_EQ(said.at(0).find("Cell 3: "), 0u);
    run("seek 0; explain");
    EXPECT_EQ(said.at(0).find("Step 0: "), 0u);
}

TEST_F(EachCommand, front) {
    run("front");
    EXPECT_EQ(said.size(), session().counters().front_size + 1);
    EXPECT_EQ(said[0], std::to_string(session().counters().front_size) + " cells in the front, first to last");
    // The first of the list is what the next step takes.
    const std::string first = said.at(1);
    run("step; explain");
    EXPECT_EQ(first.find("  1. cell " + std::to_string(session().timeline().steps[10].item.id) + "  key "), 0u)
        << first;
}

TEST_F(EachCommand, inversions) {
    run("inversions");
    EXPECT_EQ(said.size(), session().inversions().size() + 1);
    EXPECT_GT(said.size(), 1u);
}

TEST_F(EachCommand, markers) {
    run("bookmark the tenth step; markers");
    EXPECT_EQ(said.size(), session().markers().size() + 1);
    EXPECT_EQ(said.back(), "  step 10: bookmark 'the tenth step'");
}

TEST_F(EachCommand, panels) {
    run("panels " + file("p.txt"));
    EXPECT_NE(read_file(file("p.txt")).find("step 10 of"), std::string::npos);
}

}  // namespace
}  // namespace sightline
