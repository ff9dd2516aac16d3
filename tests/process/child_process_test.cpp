// Work in a process of its own: how it ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

namespace sightline {
namespace {

/// What end() says after a read that fails.
std::string end_of(const std::function<void(const ChildProcess::Send&)>& work, double seconds) {
    ChildProcess child(work, seconds, 1e9);
    char byte = 0;
    EXPECT_FALSE(child.read(&byte, 1, [] {}));
    return child.end();
}

TEST(ChildProcess, SendsWhatItMakes) {
    ChildProcess child([](const ChildProcess::Send& send) { send("abc", 3); }, 10, 1e9);
    char text[4] = {};
    EXPECT_TRUE(child.read(text, 3, [] {}));
    EXPECT_EQ(std::string(text), "abc");
    EXPECT_EQ(child.end(), "");
}

TEST(ChildProcess, SaysHowItEnded) {
    EXPECT_EQ(end_of([](const ChildProcess::Send&) {}, 10), "");
    EXPECT_EQ(end_of([](const ChildProcess::Send&) { throw 1; }, 10), "failed");
    EXPECT_EQ(end_of([](const ChildProcess::Send&) { std::abort(); }, 10), "crashed (Aborted)");
    EXPECT_EQ(end_of([](const ChildProcess::Send&) { throw std::bad_alloc(); }, 10), "ran out of memory");
}

TEST(ChildProcess, OneThatWaitsIsEndedByTheClock) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(end_of([](const ChildProcess::Send&) { pause(); }, 0.1), "did not finish in time");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(ChildProcess, OneThatComputesIsEndedToo) {
    EXPECT_EQ(end_of(
                  [](const ChildProcess::Send&) {
                      for (volatile int i = 0;;) i = i + 1;
                  },
                  1),
              "did not finish in time");
}

}  // namespace
}  // namespace sightline
