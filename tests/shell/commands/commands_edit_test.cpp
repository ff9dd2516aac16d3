// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"
#include "core/scene/read/read_json.h"
#include "tests/scene/scene_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using test::EachCommand;

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
