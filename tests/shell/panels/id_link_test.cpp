// Which numbers in a text are links, and where they go.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/panels/id_link.h"

#include <gtest/gtest.h>

#include <vector>

namespace sightline {
namespace {

/// Every link of a text, from left to right.
std::vector<std::string> links(const std::string& text) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const IdLink link = id_link_at(text, at);
        if (!link.command.empty() && link.first == at) all.push_back(link.command);
    }
    return all;
}

using Links = std::vector<std::string>;

TEST(IdLink, NumbersBehindAWordThatNamesThemAreLinks) {
    EXPECT_EQ(links("No step meets it; it lies in cell 14212."), Links{"select 14212"});
    EXPECT_EQ(links("Triangle 566 (wall41) is hidden by triangles 7 (60 %), 9 (30 %) and 12 (10 %)."),
              (Links{"select primitive:566", "select primitive:7", "select primitive:9", "select primitive:12"}));
    EXPECT_EQ(links("step 36: cell 582 -> cell 584, enqueued, ρ = 0.0417"),
              (Links{"seek 36", "select 582", "select 584"}));
    EXPECT_EQ(links("in node 12, steps 3 to 90"), (Links{"select node:12", "seek 3", "seek 90"}));
    EXPECT_EQ(links("Cell\n7"), Links{"select 7"}) << "where the line was broken";
}

TEST(IdLink, OtherNumbersAreNone) {
    EXPECT_EQ(links("19 cells, key 0.25, 5 % of step, column 8, 812 pixels"), Links{});
    EXPECT_EQ(links("cells: 19; step = 3; cell 0.5"), Links{});
    EXPECT_EQ(links(""), Links{});
}

}  // namespace
}  // namespace sightline
