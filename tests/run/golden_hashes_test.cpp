// Scenes, cells and runs of the catalogue stay what they are, bit for bit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "tests/run/golden_hashes.h"

namespace sightline {
namespace {

TEST(GoldenHashes, OfTheWholeCatalogueAreThoseOfTheList) {
    const std::string held = read_file(SIGHTLINE_SOURCE_DIR "/tests/files/golden_hashes.txt");
    std::string report;
    for (const std::string& line : test::changed_lines(held, test::golden_hashes())) report += line + "\n";
    EXPECT_TRUE(report.empty()) << "tests/files/golden_hashes.txt should read:\n" << report;
}

TEST(GoldenHashes, AComparisonTellsWhatChangedCameAndWent) {
    const std::string held = "# why\n\na: 1\nb c: 2\nd: 3\n";
    EXPECT_TRUE(test::changed_lines(held, {"d: 3", "a: 1", "b c: 2"}).empty());
    EXPECT_EQ(test::changed_lines(held, {"a: 1", "b c: 4", "e: 5"}),
              (std::vector<std::string>{"b c: 4", "e: 5", "no longer: d"}));
}

}  // namespace
}  // namespace sightline
