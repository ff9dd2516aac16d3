// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/output_file.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("sightline-output-" + std::to_string(getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    fs::path folder;
};

TEST_F(OutputFiles, WithoutCommitNothingChanges) {
    write_file(folder / "a", "old");
    {
        OutputFile file(folder / "a");
        file.write("new");
    }
    EXPECT_EQ(read_file(folder / "a"), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(OutputFiles, ALinkStaysALink) {
    write_file(folder / "a", "old");
    fs::create_symlink(folder / "a", folder / "link");
    write_file(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(read_file(folder / "a"), "new");
}

TEST_F(OutputFiles, ADeviceIsWrittenToAndNotReplaced) {
    write_file("/dev/null", "bytes");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_THROW(write_file("/dev/full", "bytes"), WorkError);
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(OutputFiles, AMissingFolderIsNamed) {
    try {
        write_file(folder / "no" / "a", "x");
        FAIL();
    } catch (const WorkError& error) {
        EXPECT_NE(std::string(error.what()).find((folder / "no").string()), std::string::npos);
    }
}

TEST_F(OutputFiles, WhatAKilledProcessLeftIsRemovedAtTheNextWrite) {
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        OutputFile file(folder / "a");
        file.write("half");
        const ssize_t told = write(ready[1], "x", 1);
        ::pause();
        _exit(told == 1);
    }
    char c = 0;
    ASSERT_EQ(read(ready[0], &c, 1), 1);
    close(ready[0]);
    close(ready[1]);
    const auto hidden = [&] {
        std::ptrdiff_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder)) count += entry.path().extension() == ".tmp";
        return count;
    };
    write_file(folder / "b", "whole");
    EXPECT_EQ(hidden(), 1) << "that of a process that still writes stays";
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_EQ(hidden(), 1);
    write_file(folder / "b", "whole");
    EXPECT_EQ(hidden(), 0);
    EXPECT_EQ(read_file(folder / "b"), "whole");
    EXPECT_FALSE(fs::exists(folder / "a"));
}

TEST_F(OutputFiles, TwoAreWrittenBesideEachOther) {
    OutputFile one(folder / "one"), two(folder / "two");
    one.write("1");
    two.write("2");
    one.commit();
    two.commit();
    EXPECT_EQ(read_file(folder / "one"), "1");
    EXPECT_EQ(read_file(folder / "two"), "2");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

TEST_F(OutputFiles, ANameThatIsTooLongIsRefusedAtOnce) {
    EXPECT_THROW(OutputFile(folder / std::string(256, 'n')), WorkError);
    EXPECT_NO_THROW(OutputFile(folder / std::string(255, 'n')));
    EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace sightline
