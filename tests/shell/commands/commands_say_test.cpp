// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/glossary.h"
#include "core/session/explain.h"
#include "core/session/explain_primitive.h"
#include "shell/desk/faults.h"
#include "shell/desk/what_if.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;
using Explained = EachCommand;

TEST_F(EachCommand, explain) {
    run("explain");
    EXPECT_EQ(said.at(0).find("Step 10: "), 0u) << said[0];
    run("explain step 4");
    EXPECT_EQ(said.at(0).find("Step 4: "), 0u);
    run("explain cell 3");
    EXPECT_EQ(said.at(0).find("Cell 3: "), 0u);
    run("seek 0; explain");
    EXPECT_EQ(said.at(0).find("Step 0: "), 0u);
    run("explain primitive 10");
    EXPECT_EQ(said.at(0), "Segment 10 is hidden by segment 0 (100 %).");
    EXPECT_EQ(std::count_if(said.begin(), said.end(), [](const auto& s) { return s.find("seed=") != s.npos; }), 0);
    run("explain primitive 10 seeds");
    EXPECT_GT(std::count_if(said.begin(), said.end(), [](const auto& s) { return s.find("seed=") != s.npos; }), 0);
    for (const char* wrong : {"explain cell", "explain primitive 10 seed", "explain step 4 5", "explain why.json"})
        EXPECT_THROW(run(wrong), InputError) << wrong;
}

TEST_F(EachCommand, what_if) {
    EXPECT_THROW(run("what-if"), InputError) << "nothing is selected";
    run("select 3; what-if");
    const std::vector<std::string> wanted = rows(counterfactuals(session(), cell_item(3)));
    EXPECT_EQ(said, wanted);
    ASSERT_TRUE(bench->what_if);
    // The selection counts, and the traversal.
    run("select primitive:10");
    EXPECT_EQ(what_if(*bench), nullptr);
    run("what-if");
    ASSERT_NE(what_if(*bench), nullptr);
    run("step");
    EXPECT_NE(what_if(*bench), nullptr) << "the position does not matter";
    run("set on_reenqueue=min");
    EXPECT_EQ(what_if(*bench), nullptr);
    run("select none; method everything; select 3; what-if");
    EXPECT_EQ(said.back(), "this method orders no cells: select a primitive");
    run("method coorg-teller; select primitive:10; what-if");
    const auto tells = [&](const std::string& change) {
        return std::any_of(said.begin(), said.end(), [&](const auto& s) { return s.find(change) != s.npos; });
    };
    EXPECT_TRUE(tells("workers=2"));
    EXPECT_FALSE(tells("workers=0.5")) << "there is no half of a worker";
}

TEST_F(EachCommand, missed) {
    run("set budget=5; seek 0");
    run("missed");
    EXPECT_EQ(said.at(0), "Missed at the end of the run");
    const Faults* const found = faults(*bench);
    ASSERT_NE(found, nullptr);
    ASSERT_FALSE(found->missed.regions.empty());
    EXPECT_EQ(session().position(), 0u) << "looking moves nothing";
    const std::uint32_t worst = found->missed.regions[0].primitives[0].primitive;
    run("missed 1");
    EXPECT_TRUE(session().finished());
    EXPECT_EQ(session().selected_primitive, worst);
    EXPECT_EQ(bench->desk.right, "why");
    const PrimitiveExplanation why = explain_primitive(session(), worst);
    EXPECT_EQ(said.at(0), sight_sentence(session(), why));
    EXPECT_EQ(said.at(1), put_off_sentence(session(), why));
    EXPECT_NE(said.at(1).find(" in the front"), std::string::npos) << said[1];
    EXPECT_THROW(run("missed 0"), InputError);
    EXPECT_THROW(run("missed 4000"), InputError);
    run("set budget=unlimited");
    run("missed");
    EXPECT_EQ(said.at(0), "Nothing is missed");
    EXPECT_THROW(run("missed 1"), InputError);
}

TEST_F(EachCommand, objects) {
    run("objects");
    EXPECT_EQ(said.at(0), std::to_string(session().objects().names.size()) + " parts at the end of the run");
    ASSERT_TRUE(faults(*bench)->objects);
    EXPECT_EQ(faults(*bench)->objects->size(), session().objects().names.size());
}

TEST_F(EachCommand, glossary) {
    run("glossary");
    EXPECT_EQ(said.size(), glossary().size());
    run("glossary Penalty");
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].find("penalty: "), 0u);
    EXPECT_THROW(run("glossary frontier"), InputError);
}

TEST_F(EachCommand, techniques) {
    run("techniques");
    EXPECT_EQ(said.at(0).find("Suits: "), 0u);
    EXPECT_NE(std::find(said.begin(), said.end(), "  Hierarchical z-buffer: hzb"), said.end());
    run("techniques portals");
    EXPECT_NE(
        std::find(said.begin(), said.end(), "This scene: does not suit; it needs rooms, and the scene marks none."),
        said.end());
    run("techniques hom");
    EXPECT_EQ(said.at(0), "HOMs: method hom");
    EXPECT_EQ(said.at(1), "DAS, table 1: Visibility / Point Visibility / Image Space Techniques");
    EXPECT_EQ(said.back().find("Note: section 2.1.2"), 0u);
    EXPECT_THROW(run("techniques frontier"), InputError);
}

/// What is written as JSON is what is said.
TEST_F(Explained, AsJson) {
    run("run; explain cell 26 " + file("cell.json") + "; explain primitive 10 " + file("primitive.json"));
    const auto cell = nlohmann::json::parse(read_file(file("cell.json")));
    const CellExplanation e = explain_cell(session(), 26);
    EXPECT_EQ(cell["cell"], 26);
    EXPECT_EQ(cell["chain"].size(), e.chain.size());
    EXPECT_EQ(cell["reached"].size(), e.reached.size());
    const Counterfactuals all = counterfactuals(session(), cell_item(26));
    ASSERT_EQ(cell["changes"].size(), all.changes.size());
    for (std::size_t i = 0; i < all.changes.size(); ++i) {
        const auto& row = cell["changes"][i];
        EXPECT_EQ(row["change"], all.changes[i].change);
        EXPECT_EQ(row["step"].is_null() ? 0u : row["step"].get<std::uint32_t>(), all.changes[i].outcome.step);
    }
    const auto primitive = nlohmann::json::parse(read_file(file("primitive.json")));
    EXPECT_EQ(primitive["visible"], false);
    ASSERT_EQ(primitive["hidden_by"].size(), 1u);
    EXPECT_EQ(primitive["hidden_by"][0]["primitive"], 0);
    EXPECT_EQ(primitive["hidden_by"][0]["share"], 1);
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
