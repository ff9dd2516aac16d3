// A bench on the first scene that commands are run on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/scene/make/catalogue.h"
#include "shell/commands/command_table.h"

namespace sightline::test {

/// The commands that have a test of their own: the tests of this suite, wherever they stand.
inline std::set<std::string> tested_commands(const std::string& suite_name) {
    std::set<std::string> ids;
    const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
        const ::testing::TestSuite& suite = *all.GetTestSuite(i);
        if (suite.name() != suite_name) continue;
        for (int j = 0; j < suite.total_test_count(); ++j) {
            std::string id = suite.GetTestInfo(j)->name();
            std::replace(id.begin(), id.end(), '_', '-');
            ids.insert(id);
        }
    }
    return ids;
}

/// At step 0; nothing is recorded yet.
class Commands : public ::testing::Test {
protected:
    Commands() {
        const CatalogueRow<2>& row = *find_in_catalogue("bottleneck");
        Settings settings;
        settings.error_bound = row.error_bound;
        bench.reset(
            new Workbench<2>{Session<2>(std::make_shared<const Scene<2>>(make_scene(row)), row.view, settings)});
        bench->say = [this](const std::string& line) { said.push_back(line); };
        std::filesystem::create_directories(folder);
    }
    ~Commands() override { std::filesystem::remove_all(folder); }

    void run(const std::string& text) {
        said.clear();
        run_commands(*bench, text);
    }
    Session<2>& session() { return bench->session; }
    const Other<2>& other() { return bench->other.value(); }
    std::string file(const std::string& name) const { return (folder / name).string(); }

    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("sightline-commands-" + std::to_string(getpid()));
    std::vector<std::string> said;  ///< by the last run()
    std::unique_ptr<Workbench<2>> bench;
};

/// One test for each command, named after it with _ for -; commands_test.cpp counts them. At step 10 of a run that is
/// recorded as a whole.
class EachCommand : public Commands {
protected:
    EachCommand() { run("run; seek 10"); }

    /// The command switches the flag, and switches it back.
    void flips(const std::string& command, const bool& flag) {
        const bool before = flag;
        run(command);
        EXPECT_NE(flag, before);
        run(command);
        EXPECT_EQ(flag, before);
    }
};

}  // namespace sightline::test
