// Options that contradict each other, repeat themselves or would do nothing; and output that cannot be written.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "core/base/file.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;

class LabOptions : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    /// Exit status of the lab in a folder of its own; `before` goes before it in the shell.
    int run(const std::string& arguments, const std::string& before = "", const std::string& out = "") {
        const std::string command = "cd " + folder_.string() + " && " + before + " " + SIGHTLINE_LAB + " " + arguments +
                                    " > " + (out.empty() ? (folder_ / "said").string() : out) + " 2> " +
                                    (folder_ / "complained").string();
        const int status = std::system(command.c_str());
        complaint_ = read_file(folder_ / "complained");
        // Without what was said of the progress before an error.
        if (const std::size_t at = complaint_.rfind("lab: "); at != std::string::npos && at > 0 &&
                                                              complaint_[at - 1] == '\n' &&
                                                              complaint_.find("warning") == std::string::npos)
            complaint_.erase(0, at);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string complaint_;
    const fs::path folder_ = fs::temp_directory_path() / ("sightline-options-" + std::to_string(getpid()));
};

TEST_F(LabOptions, WhatWouldDoNothingIsRefused) {
    const std::pair<const char*, const char*> wrong[]{
        {"measure 2d:rooms --frames 0", "--frames"},
        {"measure 2d:rooms --set budget=3%", "--budgets"},
        {"measure 2d:rooms --set method=layers", "--methods"},
        {"measure 2d:rooms --set tessellation=tree", "@tree"},
        {"measure 2d:rooms --set reference_size=64", "--size"},
        {"measure 2d:rooms --set auto=on", "lab cells"},
        {"measure 2d:rooms --set seeds=one --set seeds=hull", "given twice"},
        {"measure 2d:rooms --budgets 1%,1%", "--budgets 1%: is given twice"},
        {"measure 2d:rooms --methods layers,layers", "--methods layers: is given twice"},
        {"measure 2d:rooms 2d:rooms", "given twice"},
        {"measure 2d:rooms --path turn --path turn", "given twice"},
        {"measure 2d:rooms@turn --path start", "path of its own"},
        {"measure 2d:rooms --path ''", "--path: is empty"},
        {"measure 2d:rooms --settings ''", "--settings: is empty"},
        {"measure 2d:rooms --out ''", "--out: is empty"},
        {"measure ''", "is empty"},
        {"reduce 2d:rooms --until 'inversion == 1' --holds 'wrong > 1'", "either"},
        {"reduce 2d:rooms --until 'inversion == 1' --repeats 3", "--repeats"},
        {"reduce 2d:rooms --until 'inversion == 1' --limit 0", "--limit"},
        {"compare layers published 2d:rooms --methods view", "--methods does nothing"},
        {"compare nosuch/results.json layers", "no such file"},
        {"cells 2d:rooms --methods tri --within -1", "--within"},
        {"measure nosuch.obj --frames 1", "nosuch.obj"},
        {"measure 2d:rooms --chart-size 3", "--chart-size"},
    };
    for (const auto& [arguments, says] : wrong) {
        EXPECT_EQ(run(arguments), 2) << arguments;
        EXPECT_NE(complaint_.find(says), std::string::npos) << arguments << ": " << complaint_;
        EXPECT_EQ(std::count(complaint_.begin(), complaint_.end(), '\n'), 1) << arguments << ": " << complaint_;
        EXPECT_FALSE(fs::exists(folder_ / "out")) << arguments;
    }
    const std::string small = " --frames 1 --repeats 0 --methods 'published penalty=add star_shaped=off' --budgets 5%";
    EXPECT_EQ(run("measure 2d:rooms" + small), 0);
    EXPECT_NE(complaint_.find("warning: published penalty=add star_shaped=off: penalty=add does nothing"),
              std::string::npos)
        << complaint_;
    EXPECT_TRUE(fs::exists(folder_ / "out/lab-2d_rooms/report.html"));
    EXPECT_EQ(run("measure 2d:rooms --frames 1 --repeats 0 --methods layers --budgets 5%"), 0) << "another study";
    EXPECT_EQ(complaint_.find("warning"), std::string::npos) << complaint_;
    EXPECT_TRUE(fs::exists(folder_ / "out/lab-2d_rooms-2/report.html"));
}

TEST_F(LabOptions, WhatIsLeftOutIsSaid) {
    const auto says = [&](const std::string& words) {
        return complaint_.find("lab: warning: " + words + "\n") != std::string::npos;
    };
    const std::string small = " --frames 2 --repeats 0 --methods ";
    EXPECT_EQ(run("measure 2d:bottleneck --budgets 16ms" + small + "'tri; tri-z'"), 0);
    EXPECT_TRUE(says("2d:bottleneck: no method is measured with a budget in time: in 2D no drawing is timed"))
        << complaint_;
    EXPECT_EQ(run("measure 2d:bottleneck --budgets wrong:1%" + small + "'tri; tri-seen; view'"), 0);
    EXPECT_TRUE(
        says("tri-seen: is not measured with a budget in wrong pixels: its order depends on the budget or on "
             "the frames before"))
        << complaint_;
    EXPECT_EQ(complaint_.find("warning: tri:"), std::string::npos) << complaint_;
    EXPECT_EQ(complaint_.find("warning: view"), std::string::npos) << "it has no use for a budget: " << complaint_;
    const std::string cells = "cells 2d:bottleneck --error-bounds 0.4,0.2 --frames 1 --repeats 0 ";
    EXPECT_EQ(run(cells + "--methods 'layers; tri-z'"), 0);
    EXPECT_TRUE(says("tri-z: is left out: it orders no cells; --reach compares it")) << complaint_;
    EXPECT_EQ(run(cells + "--reach 0.01 --methods 'layers; tri-z'"), 0);
    EXPECT_EQ(complaint_.find("is left out"), std::string::npos) << complaint_;
    EXPECT_EQ(run(cells), 0);
    EXPECT_EQ(complaint_.find("is left out"), std::string::npos) << "nobody asked for one: " << complaint_;
}

TEST_F(LabOptions, ForeignWordsAreShortAndPlain) {
    const std::string long_word(4000, 'x');
    for (const std::string arguments :
         {"measure 2d:rooms --path " + long_word, "measure " + long_word, "measure 2d:rooms --budgets " + long_word,
          "measure 2d:rooms --methods " + long_word, "measure 2d:rooms --set seeds=" + long_word,
          "measure 2d:rooms --set " + long_word, "compare a b --fail-if " + long_word, long_word}) {
        EXPECT_EQ(run(arguments), 2) << arguments.substr(0, 40);
        EXPECT_LT(complaint_.size(), 420u) << complaint_;
    }
    EXPECT_EQ(run("measure 2d:rooms --path \"$(printf 'a\\033[31m\\2332J\\302\\233\\nb')\""), 2);
    for (const char c : complaint_) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << complaint_;
    EXPECT_EQ(complaint_.find('\x9b'), std::string::npos);
}

TEST_F(LabOptions, WhatCannotBeWrittenIsSaid) {
    EXPECT_EQ(run("--help", "", "/dev/full"), 1);
    EXPECT_NE(complaint_.find("standard output cannot be written"), std::string::npos) << complaint_;
    EXPECT_EQ(run("measure 2d:rooms --frames 1 --repeats 0 --methods layers", "ulimit -f 2;"), 1);
    EXPECT_NE(complaint_.find("File too large"), std::string::npos) << complaint_;
}

}  // namespace
}  // namespace sightline::lab
