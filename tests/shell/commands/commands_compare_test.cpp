// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/session/state_file.h"
#include "shell/desk/moves.h"
#include "shell/panels/panel.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

TEST_F(EachCommand, compare) {
    run("compare centroid");
    EXPECT_EQ(other().session.method().id, "centroid");
    EXPECT_EQ(other().session.position(), 10u);
    EXPECT_EQ(session().method().id, "published");
    run("compare distance");
    EXPECT_EQ(other().session.method().id, "centroid") << "an alias";
    // What a lecturer types, and what the menu has.
    for (const auto& [words, id] : {std::pair("oracle", "perfect"), std::pair("\"perfect order\"", "perfect"),
                                    std::pair("Perfect order", "perfect"), std::pair("view only", "view"),
                                    std::pair("view", "view"), std::pair("by distance", "centroid"),
                                    std::pair("centroid order", "centroid"), std::pair("plp", "published")}) {
        run(std::string("compare ") + words);
        EXPECT_EQ(other().session.method().id, id) << words;
    }
    run("compare penalty");
    EXPECT_EQ(other().session.settings().parameters.text(penalty_row()), "none");
    EXPECT_EQ(said.at(0).find("left: penalty, right: no penalty. Step "), 0u) << said.at(0);
    run("swap; compare penalty");
    EXPECT_EQ(session().settings().parameters.text(penalty_row()), "none");
    EXPECT_EQ(other().session.settings().parameters.text(penalty_row()), "multiply");
    run("set penalty=multiply; set star_shaped=off; compare penalty");
    EXPECT_EQ(other().session.settings().parameters.text(star_shaped_row()), "on") << "off is without a penalty, too";
    run("undo; undo");
    test::expect_input_error([&] { run("compare distanc"); },
                             "command 'compare distanc': 'distanc' cannot be compared with; did you mean distance?");
    try {
        run("compare zzzzzz");
        ADD_FAILURE() << "there is no zzzzzz";
    } catch (const InputError& error) {
        for (const char* word : {"penalty", "distance", "perfect order", "view only", "layers", "preset:ID"})
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
    run("method centroid");
    EXPECT_THROW(run("compare penalty"), InputError) << "centroid order knows none";
    run("undo");
    run("compare published on_reenqueue=min");
    EXPECT_EQ(other().session.settings().parameters.text(on_reenqueue_row()), "min");
    EXPECT_EQ(session().settings().parameters.text(on_reenqueue_row()), "replace");
    run("compare jitter=0.25,penalty=none");
    EXPECT_EQ(other().session.settings().jitter, 0.25);
    EXPECT_EQ(other().session.settings().parameters.text(penalty_row()), "none");
    run("compare preset:paper-3d");
    EXPECT_EQ(other().session.settings().parameters.text(view_vector_row()), "camera");
    EXPECT_EQ(difference(session().settings(), other().session.settings()), Invalidates::traversal) << "the same cells";
    run("compare streets");
    EXPECT_EQ(other().session.scene().id, "streets");
    run("set jitter=0.1; save " + file("right.json") + "; undo; compare " + file("right.json"));
    EXPECT_EQ(other().session.settings().jitter, 0.1);
    EXPECT_EQ(other().session.shared_scene(), session().shared_scene());
    run("compare same");
    EXPECT_EQ(other().session.settings(), session().settings());
    run("shot " + file("pair.svg") + "; compare off");
    EXPECT_FALSE(bench->other);
    EXPECT_TRUE(open_state(read_file(file("pair.svg.json")), "f").other.has_value());
}

TEST_F(EachCommand, align) {
    run("compare centroid; align rendered; seek 6");
    EXPECT_EQ(other().align, Align::rendered);
    EXPECT_GE(other().session.counters().rendered_count, session().counters().rendered_count);
    EXPECT_NE(other().session.position(), 6u);
    const auto aligned = [&] {  // the line of the panel that says so
        std::string lines;
        for (const Row& row : find_panel<2>("compare")->rows(*bench))
            if (row.text.starts_with("aligned")) lines += row.text;
        return lines;
    };
    EXPECT_EQ(aligned(), "aligned by drawn: " + std::to_string(session().counters().rendered_count) + " against " +
                             std::to_string(other().session.counters().rendered_count));
    run("compare layers; align step");
    EXPECT_EQ(aligned(), "aligned by step: both have made 6 steps");
    EXPECT_EQ(said.back(), aligned());
    EXPECT_EQ(other().session.position(), 6u);
    run("align drawn");
    EXPECT_EQ(other().align, Align::rendered);
}

TEST_F(EachCommand, difference) {
    run("compare centroid; difference");
    const auto step = first_difference(at_the_end(session()), at_the_end(other().session));
    ASSERT_TRUE(step);
    EXPECT_EQ(session().position(), *step);
    EXPECT_EQ(other().session.position(), *step);
    EXPECT_EQ(said.back().find("Step " + std::to_string(*step) + ": left projects"), 0u);
    EXPECT_NE(said.at(0).find(said.back()), std::string::npos) << "compare says so already: " << said.at(0);
    run("seek 10; compare same; difference");
    EXPECT_NE(said.at(0).find("Both agree in the first "), std::string::npos) << said.at(0);
    EXPECT_EQ(said.back().find("Both agree to the end"), 0u);
    EXPECT_EQ(session().position(), 10u);
}

TEST_F(EachCommand, swap) {
    run("compare centroid; swap");
    EXPECT_EQ(session().method().id, "centroid");
    EXPECT_EQ(other().session.method().id, "published");
    run("swap");
    EXPECT_EQ(session().method().id, "published");
}

}  // namespace
}  // namespace sightline
