// The charts of a sweep over cells: each line can be told from the others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cells/cells_report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "core/base/file.h"
#include "lab/cells/cells.h"
#include "tests/lab/report_rows.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;

class LabCellsReport : public testing::Test {
protected:
    ~LabCellsReport() override { fs::remove_all(folder_); }
    static CellsCurve curve_of(const std::string& method, const std::string& also) {
        CellsCurve curve{"city", "test", parse_method(method), "5%", {}, also};
        for (const double bound : {0.4, 0.2})
            curve.points.push_back({bound, test::report_row("city", method, "5%", 5, bound, 1)});
        curve.points.back().row.cells = 99;
        return curve;
    }
    fs::path folder_ = fs::temp_directory_path() / ("sightline-cells-" + std::to_string(getpid()));
};

TEST_F(LabCellsReport, HasAChartForEachMethodWhoseKindsDiffer) {
    std::vector<CellsCurve> curves;
    for (const std::string method : {"flux", "tri"})
        for (const char* on : {"", "@tree", "@kd"})
            for (const char* also : {"", "split_for=opacity"}) curves.push_back(curve_of(method + on, also));
    write_cells_report(curves, Measure::wrong, 0.01, folder_, {});
    for (const char* method : {"flux", "tri"}) {
        const std::string script =
            read_file(folder_ / ("charts/cells-city-test-5_-" + std::string(method) + "-wrong.gp"));
        // Of each line its colour, as the key has it.
        std::set<std::string> looks;
        std::size_t lines = 0;
        for (std::size_t at = script.find("set arrow"); at < script.find("unset output");
             at = script.find("set arrow", at + 1)) {
            const std::size_t look = script.find(" lc rgb", at);
            looks.insert(script.substr(look, script.find('\n', look) - look));
            ++lines;
        }
        EXPECT_EQ(lines, 6u);
        EXPECT_EQ(looks.size(), 6u) << method;
        EXPECT_NE(script.find("tree, split_for=opacity"), std::string::npos);
    }
    fs::remove_all(folder_);
    write_cells_report({curve_of("flux", ""), curve_of("tri@tree", "")}, Measure::wrong, 0.01, folder_, {});
    EXPECT_TRUE(fs::exists(folder_ / "charts/cells-city-test-5_-wrong.svg")) << "each on one kind: all in one chart";
}

}  // namespace
}  // namespace sightline::lab
