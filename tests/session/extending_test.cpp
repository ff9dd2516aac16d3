// docs/extending.md shows lines of the source as diffs: each hunk stands in its file as it is.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

#include "core/base/file.h"

namespace sightline {
namespace {

const std::filesystem::path source = SIGHTLINE_SOURCE_DIR;

/// The added lines of a file; `+++` begins one, `@@` the next hunk of it.
struct Hunk {
    std::string file, text;
};

std::vector<Hunk> hunks_in(const std::string& page) {
    std::vector<Hunk> hunks;
    std::istringstream lines(page);
    bool diff = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            diff = line == "```diff";
        } else if (diff && line.starts_with("+++ b/")) {
            hunks.push_back({line.substr(6), ""});
        } else if (diff && line == "@@") {
            hunks.push_back({hunks.back().file, ""});
        } else if (diff) {
            EXPECT_TRUE(line.starts_with("+")) << line;
            hunks.back().text += line.substr(1) + "\n";
        }
    }
    return hunks;
}

TEST(Extending, TheLinesShownAreThoseOfTheSource) {
    const auto hunks = hunks_in(read_file((source / "docs/extending.md").string()));
    std::map<std::string, int> files;
    for (const Hunk& hunk : hunks) {
        ++files[hunk.file];
        EXPECT_GT(hunk.text.size(), 20u) << hunk.file;
        const std::filesystem::path file = source / hunk.file;
        ASSERT_TRUE(std::filesystem::exists(file)) << hunk.file;
        // The end of the line before, so that a shown line is a whole one.
        EXPECT_NE(("\n" + read_file(file.string())).find("\n" + hunk.text), std::string::npos)
            << hunk.file << " has no longer:\n"
            << hunk.text;
    }
    EXPECT_GE(files.size(), 9u);
}

/// Tests that the page sends a reader to exist.
TEST(Extending, TheTestsNamedExist) {
    const std::string page = read_file((source / "docs/extending.md").string());
    std::string tests;
    for (const char* file : {"shell/panels/panels", "shell/commands/commands", "session/settings", "shell/window/keys"})
        tests += read_file((source / ("tests/" + std::string(file) + "_test.cpp")).string());
    int named = 0;
    for (const char* suite : {"Panels", "Commands", "Settings", "Keys"}) {
        const std::string start = "`" + std::string(suite) + ".";
        for (std::size_t at = page.find(start); at != std::string::npos; at = page.find(start, at + 1), ++named) {
            const std::size_t name = at + start.size();
            const std::string test = page.substr(name, page.find('`', name) - name);
            EXPECT_NE(tests.find("(" + std::string(suite) + ", " + test + ")"), std::string::npos) << test;
        }
    }
    EXPECT_GE(named, 5);
}

}  // namespace
}  // namespace sightline
