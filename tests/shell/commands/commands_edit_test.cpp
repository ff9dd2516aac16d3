// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/read/read_json.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

class EditedScene : public EachCommand {};

TEST_F(EachCommand, segment) {
    const auto before = session().shared_scene();
    const auto count = static_cast<std::uint32_t>(before->primitives.size());
    run("segment add 1,1 2,1.5");
    ASSERT_EQ(session().scene().primitives.size(), count + 1);
    EXPECT_EQ(session().scene().primitives.back(), (Primitive<2>{Vec<2>(1, 1), Vec<2>(2, 1.5)}));
    EXPECT_EQ(session().selected_primitive, count);
    EXPECT_EQ(session().scene().source, "edited");
    run("segment move selected 1,1 2,1; segment delete 0");
    EXPECT_EQ(session().scene().primitives.back(), (Primitive<2>{Vec<2>(1, 1), Vec<2>(2, 1)}));
    EXPECT_EQ(session().selected_primitive, count - 1);
    run("segment delete");
    EXPECT_EQ(session().scene().primitives.size(), count - 1);
    EXPECT_EQ(session().selected_primitive, none);
    run("undo; undo; undo; undo");
    EXPECT_EQ(session().shared_scene(), before);
}

TEST_F(EachCommand, edit) {
    flips("edit", bench->desk.edit);
    run("edit on; edit on");
    EXPECT_TRUE(bench->desk.edit);
    run("tool gap; edit off");
    EXPECT_FALSE(bench->desk.edit);
    EXPECT_EQ(bench->desk.tool, Tool::select) << "a tool that edits is left with the edit mode";
    run("tool segment");
    EXPECT_TRUE(bench->desk.edit) << "and it comes with it";
    test::expect_input_error([&] { run("edit maybe"); }, "command 'edit maybe': 'maybe' is not one of off, on");
}

/// A gap in a wall of the bottleneck: the two parts keep the ends, the run is made again at the same step.
TEST_F(EditedScene, AGapLeavesTheEndsAndTheStep) {
    const auto before = session().shared_scene();
    const std::size_t count = before->primitives.size();
    run("segment add 2,2 10,2; seek 10");
    const auto wall = session().shared_scene();
    const std::string id = std::to_string(count);
    run("segment cut " + id + " 4,3 6,1");
    EXPECT_EQ(session().position(), 10u);
    ASSERT_EQ(session().scene().primitives.size(), count + 2);
    EXPECT_EQ(session().scene().primitives[count], (Primitive<2>{Vec<2>(2, 2), Vec<2>(4, 2)}));
    EXPECT_EQ(session().scene().primitives[count + 1], (Primitive<2>{Vec<2>(6, 2), Vec<2>(10, 2)}));
    EXPECT_EQ(session().selected_primitive, count);
    EXPECT_EQ(session().scene().source, "edited");
    run("undo");
    EXPECT_EQ(session().shared_scene(), wall);
    // From either side, and off an end.
    run("segment cut " + id + " 6,2 4,2");
    EXPECT_EQ(session().scene().primitives[count + 1], (Primitive<2>{Vec<2>(6, 2), Vec<2>(10, 2)}));
    run("undo; segment cut " + id + " 8,2 99,2");
    ASSERT_EQ(session().scene().primitives.size(), count + 1);
    EXPECT_EQ(session().scene().primitives[count], (Primitive<2>{Vec<2>(2, 2), Vec<2>(8, 2)}));
    const auto now = session().shared_scene();
    for (const char* wrong : {" 3,1 3,5", " -9,2 99,2"})
        EXPECT_THROW(run("segment cut " + id + wrong), InputError) << wrong;
    EXPECT_EQ(session().shared_scene(), now);
}

TEST_F(EachCommand, delete) {
    const std::size_t notes = session().notes.size(), segments = session().scene().primitives.size();
    run("note text 1,1 gone soon; select 3; select primitive:2; select note:" + std::to_string(notes + 1));
    EXPECT_EQ(session().selected_cell, 3u);  // is still being explained
    EXPECT_EQ(session().selected_primitive, none);
    run("delete");
    EXPECT_EQ(session().notes.size(), notes);
    run("select primitive:2");
    EXPECT_EQ(session().selected_cell, 3u);
    run("delete");
    EXPECT_EQ(session().scene().primitives.size(), segments - 1);
    run("undo; undo; undo; select 4");
    EXPECT_EQ(session().scene().primitives.size(), segments);
    EXPECT_EQ(session().selected_primitive, none);
    test::expect_input_error([&] { run("delete"); }, "command 'delete': no primitive is selected");
}

TEST_F(EachCommand, scene) {
    const auto before = session().shared_scene();
    run("note text 1,1 here; scene save " + file("scene.json") + "; scene new");
    EXPECT_TRUE(session().scene().primitives.empty());
    EXPECT_TRUE(session().notes.empty());
    run("undo");
    EXPECT_EQ(session().shared_scene(), before);
    EXPECT_EQ(session().notes.size(), 1u);
    EXPECT_EQ(scene_hash(read_json(read_file(file("scene.json")), "f")), scene_hash(*before));
}

}  // namespace
}  // namespace sightline
