// The start script, beside a project of one file that CMake configures at once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/file.h"

namespace sightline {
namespace {

/// A folder of checkouts. The real `run` starts a "viewer2d" there that says what was built into it, and where.
class RunScript : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) / ("sightline_run_" + std::to_string(getpid()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_ / "bin");
        write("bin/dpkg-query", "#!/bin/sh\necho install ok installed\n");  // so that nothing is installed
        std::filesystem::permissions(folder_ / "bin/dpkg-query", std::filesystem::perms::owner_all);
        std::filesystem::create_directories(folder_ / "here");
        std::filesystem::copy_file(std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "run", folder_ / "here/run");
        write("here/word", "one");
        write("here/CMakeLists.txt", R"(cmake_minimum_required(VERSION 3.25)
project(fake NONE)
message(STATUS "configuring")
add_custom_command(OUTPUT viewer2d DEPENDS ${CMAKE_SOURCE_DIR}/word VERBATIM
                   COMMAND sh -c "echo echo `cat ${CMAKE_SOURCE_DIR}/word` of ${CMAKE_SOURCE_DIR} >viewer2d"
                   COMMAND chmod +x viewer2d)
add_custom_target(program ALL DEPENDS viewer2d)
)");
        write("here/CMakePresets.json", R"({"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja",
            "binaryDir": "${sourceDir}/build/${presetName}"}]})");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& file, const std::string& text) { std::ofstream(folder_ / file) << text; }

    /// What a command, run in the folder, says to its user.
    std::string shell(const std::string& command) {
        const std::string log = (folder_ / "log").string();
        const int status = std::system(
            ("cd '" + folder_.string() + "' && { PATH=\"$PWD/bin:$PATH\" " + command + "\n} >'" + log + "' 2>&1")
                .c_str());
        status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return read_file(log);
    }
    bool says(const std::string& checkout, const std::string& word, const std::string& said) const {
        return said.ends_with("\n" + word + " of " + (folder_ / checkout).string() + "\n");
    }

    std::filesystem::path folder_;
    int status_ = 0;
};

TEST_F(RunScript, ACopiedOrMovedCheckoutIsConfiguredAnew) {
    std::string said = shell("here/run viewer2d");
    ASSERT_TRUE(status_ == 0 && says("here", "one", said)) << said;

    shell("cp -a here copy");
    write("copy/word", "two");
    said = shell("copy/run viewer2d");
    EXPECT_TRUE(status_ == 0 && says("copy", "two", said)) << said;
    EXPECT_NE(said.find("was made for " + (folder_ / "here").string()), std::string::npos) << said;

    shell("mv copy moved");
    said = shell("moved/run viewer2d");
    EXPECT_TRUE(status_ == 0 && says("moved", "two", said)) << said;

    shell("ln -s moved link");
    for (const std::string checkout : {"here", "moved", "link"}) {
        said = shell(checkout + "/run viewer2d");
        EXPECT_EQ(status_, 0);
        EXPECT_EQ(said.find("was made for"), std::string::npos) << checkout << " knows its place: " << said;
    }
}

TEST_F(RunScript, WhatCannotBeConfiguredIsSaidAndNothingOldIsStarted) {
    shell("here/run viewer2d");
    ASSERT_EQ(status_, 0);
    shell("cp -a here copy");
    write("copy/CMakeLists.txt", R"(cmake_minimum_required(VERSION 3.25)
project(fake NONE)
message(STATUS "looked in vain")
message(FATAL_ERROR "a package is missing")
)");
    for (int time = 0; time < 2; ++time) {
        const std::string said = shell("copy/run viewer2d");
        EXPECT_NE(status_, 0);
        for (const char* part : {"looked in vain", "a package is missing", "could not configure build/release"})
            EXPECT_NE(said.find(part), std::string::npos) << said;
        EXPECT_EQ(said.find("one of "), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace sightline
