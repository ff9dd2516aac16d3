// The scene of a state file, in a file of its own as large and 3D ones are: moved, renamed, changed, replaced.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/base/file.h"
#include "core/scene/read/load.h"
#include "core/session/state_file.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

TEST(StateScene, IsFoundWhereverItLies) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("sightline-state-" + std::to_string(getpid()));
    fs::create_directories(folder / "models");
    fs::create_directories(folder / "elsewhere");
    const auto model = [](double x) {
        return "v " + std::to_string(x) + " 0 0\nv 1 0 0\nv 0 1 5\nv 0 2 7\nf 1 2 3\nf 1 2 4\n";
    };
    const std::string file = (folder / "models/a.obj").string();
    write_file(file, model(9));
    auto scene = std::make_shared<const Scene<3>>(load_scene<3>(file));
    Session<3> session(scene, *scene->start_view, Settings{});
    session.run(2);
    session.selected_primitive = 1;
    const std::string text = state_json<3>(session);
    const std::string state = (folder / "elsewhere/state.json").string();
    const auto opens = [&] {
        const OpenedState<3> opened = open_state<3>(text, state);
        return opened.warnings.empty() && opened.session.hash() == session.hash();
    };
    EXPECT_TRUE(opens()) << "as written";
    fs::rename(file, folder / "elsewhere/a.obj");
    EXPECT_TRUE(opens()) << "beside";
    write_file(file, model(8));
    EXPECT_TRUE(opens()) << "beside, though another one lies where it was";
    fs::rename(folder / "elsewhere/a.obj", folder / "elsewhere/renamed.obj");
    write_file(folder / "elsewhere/b.obj", model(7));
    EXPECT_TRUE(opens()) << "by its hash";
    fs::remove(folder / "elsewhere/renamed.obj");
    test::expect_input_error(
        [&] { opens(); }, state + ": scene '" + file + "' is not the one the state was made with (its hash differs)");
    fs::remove(file);
    test::expect_input_error([&] { opens(); },
                             state + ": " + file + ": no such file, and no scene of the catalogue has this id");

    // Another one in its place: what refers to the first one is left out.
    const std::string other = (folder / "elsewhere/b.obj").string();
    const OpenedState<3> replaced = open_state<3>(text, state, method_table<3>(), {}, {}, other);
    EXPECT_EQ(replaced.session.scene().name, other);
    EXPECT_EQ(replaced.session.position(), 0u);
    EXPECT_EQ(replaced.session.selected_primitive, none);
    EXPECT_EQ(replaced.session.culling_view(), session.culling_view());
    ASSERT_EQ(replaced.warnings.size(), 1u);
    write_file(other, model(9));
    const OpenedState<3> moved = open_state<3>(text, state, method_table<3>(), {}, {}, other);
    EXPECT_TRUE(moved.warnings.empty());
    EXPECT_EQ(moved.session.hash(), session.hash());
    EXPECT_EQ(moved.session.selected_primitive, 1u);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace sightline
