// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
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

}  // namespace
}  // namespace sightline
