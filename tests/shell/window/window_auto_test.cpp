// The setting `auto` in the real window: the status line says it as long as it is on.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/session/state_file.h"
#include "shell/desk/open_scene.h"
#include "tests/shell/window/window_session_support.h"

namespace sightline {
namespace {

using namespace test;

TEST_F(WindowSession, TheStatusLineSaysThatAutoIsOn) {
    SHOW_DISPLAY();
    Session<2> session =
        open_scene<2>("bottleneck", start_settings<2>("bottleneck"), method_table<2>(), [](const std::string&) {});
    Settings settings = session.settings();
    settings.automatic = Switch::on;
    session.change(settings);
    write_file(folder / "kept.json", state_json(session));
    start({"--state", "kept.json"});
    if (HasFatalFailure()) return;
    EXPECT_TRUE(now.screen.contains("mode auto: published"));
    command("set label=order");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("mode auto: published"); }))
        << "a picture's matter";
    command("budget 40");
    ASSERT_TRUE(becomes([](const Dump& d) { return !d.screen.contains("mode auto: published"); }));
    leave();
}

}  // namespace
}  // namespace sightline
