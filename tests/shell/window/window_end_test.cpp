// How a window ends: at once, and with what it remembers written, whoever ends it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/shell/window/window_session_support.h"

namespace sightline {
namespace {

using namespace test;

class WindowEnd : public WindowSession {
protected:
    /// Changes something that is remembered.
    void change() {
        hands->key("shift+s");  // the settings
        ASSERT_TRUE(becomes([](const Dump& d) { return d.screen.contains("tab settings"); }));
    }
    void expect_remembered() {
        const fs::path memory = folder / "config" / "sightline" / "viewer2d.json";
        ASSERT_TRUE(fs::exists(memory));
        EXPECT_EQ(nlohmann::json::parse(read_file(memory))["desk"]["left"], "settings");
    }
};

TEST_F(WindowEnd, ASignalEndsItWhileKeysWait) {
    SHOW_DISPLAY("4000x3000");
    start({"rooms", "--window", "4000x3000"});
    if (HasFatalFailure()) return;
    change();
    const std::string many(100, 'f');  // each freezes, or not
    for (int i = 0; i < 3; ++i) hands->type(many);
    program->send(SIGTERM);
    EXPECT_TRUE(await([&] { return !program->running(); }, 5)) << "the keys come first";
    EXPECT_EQ(program->wait(), 0);
    expect_remembered();
}

TEST_F(WindowEnd, AHangUpSavesToo) {
    SHOW_DISPLAY();
    start({"rooms"});
    if (HasFatalFailure()) return;
    change();
    program->send(SIGHUP);
    ASSERT_TRUE(await([&] { return !program->running(); }, 20));
    EXPECT_EQ(program->wait(), 0);
    expect_remembered();
}

TEST_F(WindowEnd, ALostServerSavesToo) {
    SHOW_DISPLAY();
    start({"rooms"});
    if (HasFatalFailure()) return;
    change();
    xvfb.reset();
    ASSERT_TRUE(await([&] { return !program->running(); }, 20));
    EXPECT_LT(program->wait(), 1000) << "no crash: " << said();
    expect_remembered();
}

}  // namespace
}  // namespace sightline
