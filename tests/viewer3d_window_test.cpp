// A session with the real 3D viewer on a real display, by real keys and mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/window_session_support.h"

namespace sightline {
namespace {

using namespace test;

class Window3Session : public WindowSession {
protected:
    Window3Session() { viewer = SIGHTLINE_VIEWER3D; }
};

TEST_F(Window3Session, FlyFreezeOrbitStepPickNoteExportReopen) {
    SHOW_DISPLAY();
    start({"city:10k", "--budget", "5%", "--set", "reference_size=320x240"});
    if (HasFatalFailure()) return;
    const std::uint32_t end = now.step();
    ASSERT_GT(end, 0u) << "starts at the end of the run, where there is a picture";
    const std::string at_the_end = now.hash();

    // Fly forward: another place, another run; landing records it.
    hands->key("g");
    hands->down("w");
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.hash() != at_the_end; }));
    hands->up("w");
    hands->key("g");
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.step() > 0 && d.hash() != at_the_end; }));
    const std::string landed = now.hash();
    const std::uint32_t last = now.step();

    // Freeze and circle: the traversal stays.
    hands->key("f");
    const Rect picture = now.screen.at("picture");
    const double x = picture.x + picture.w / 2, y = picture.y + picture.h / 2;
    hands->drag(x, y, x - 90, y + 60);
    command("zoom 0.3");  // far enough to see the frozen eye
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("frozen eye"); }));
    EXPECT_EQ(now.hash(), landed);

    // Back and forward.
    hands->key("Left");
    hands->key("Left");
    ASSERT_TRUE(is_at(last - 2));
    EXPECT_NE(now.hash(), landed);
    hands->key("Right");
    hands->key("Right");
    ASSERT_TRUE(is_at(last));
    EXPECT_EQ(now.hash(), landed);

    // Pick what lies in the middle, write a note, export, open again.
    hands->click(x, y);
    command("select last");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("selected cell"); }));
    command("note text cell:last the last one");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Notes", "the last one"); }));
    command("shot out.png");
    ASSERT_TRUE(await([&] { return fs::exists(folder / "out.png.json"); })) << said();
    leave();
    Process reopened({SIGHTLINE_VIEWER3D, "--headless", "--state", "out.png.json", "--stats", "s.json"},
                     {{}, folder, folder / "program.txt", -1});
    ASSERT_EQ(reopened.wait(), 0) << said();
    EXPECT_EQ(nlohmann::json::parse(read_file(folder / "s.json"))["state_hash"], landed);
}

TEST_F(Window3Session, WindowsOfAlmostNoSizeAndHiddenOnesGoOn) {
    SHOW_DISPLAY();
    start({"bottleneck", "--set", "reference_size=320x240", "--set", "inset=both"});
    if (HasFatalFailure()) return;
    std::uint32_t last = now.step();
    for (const auto& [w, h] : {std::pair(1, 1), std::pair(900, 1), std::pair(1, 700)}) {
        ASSERT_TRUE(hands->resize(w, h));
        hands->key("Left");
        ASSERT_TRUE(is_at(--last)) << w << "x" << h;
    }
    ASSERT_TRUE(hands->resize(1000, 700));
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("picture") && d.screen.at("picture").w > 300; }));
    ASSERT_TRUE(hands->hide());
    ASSERT_TRUE(hands->show());
    hands->key("Left");
    ASSERT_TRUE(is_at(last - 1));
    leave();
}

TEST_F(Window3Session, ADriverThatIsTooOldIsNamedWithWhatToInstall) {
    SHOW_DISPLAY();
    Process old({SIGHTLINE_VIEWER3D, "bottleneck"},
                {{"DISPLAY=" + xvfb->display(), "WAYLAND_DISPLAY", "SDL_VIDEODRIVER=x11",
                  "HOME=" + (folder / "home").string(), "XDG_CONFIG_HOME=" + (folder / "config").string(),
                  "MESA_GL_VERSION_OVERRIDE=2.1", "MESA_GLSL_VERSION_OVERRIDE=120"},
                 folder,
                 folder / "program.txt",
                 -1});
    if (!await([&] { return !old.running(); }, 20)) GTEST_SKIP() << "OpenGL is not Mesa's here";
    EXPECT_EQ(old.wait(), 1);
    EXPECT_EQ(said().find("viewer3d: OpenGL 3.3 is needed; found: OpenGL 2.1"), 0u) << said();
    EXPECT_NE(said().find("libgl1-mesa-dri"), std::string::npos) << said();

    // Without any driver Mesa has its say first; X11's own last words are not the last.
    Process none(
        {SIGHTLINE_VIEWER3D, "bottleneck"},
        {{"DISPLAY=" + xvfb->display(), "WAYLAND_DISPLAY", "SDL_VIDEODRIVER=x11", "HOME=" + (folder / "home").string(),
          "XDG_CONFIG_HOME=" + (folder / "config").string(), "LIBGL_DRIVERS_PATH=/nonexistent"},
         folder,
         folder / "program.txt",
         -1});
    if (!await([&] { return !none.running(); }, 20)) GTEST_SKIP() << "OpenGL is not Mesa's here";
    EXPECT_EQ(none.wait(), 1);
    EXPECT_NE(said().find("\nviewer3d: OpenGL 3.3 is needed; found: no OpenGL at all"), std::string::npos) << said();
    EXPECT_NE(said().find("libgl1-mesa-dri"), std::string::npos) << said();
}

}  // namespace
}  // namespace sightline
