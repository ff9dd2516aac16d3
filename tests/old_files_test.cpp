// Files of earlier versions open, and say what they said: a fixture each, written by the commit that its name goes with
// (1: 6bcb33f).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/scene/flight_path.h"
#include "core/scene/make/catalogue.h"
#include "core/session/report.h"
#include "core/session/state_file.h"
#include "core/space/cells_file.h"
#include "lab/measure/results.h"

namespace sightline {
namespace {

const std::string fixtures = SIGHTLINE_SOURCE_DIR "/tests/files/";

TEST(OldFiles, AStateOpensAtItsStepWithItsHash) {
    const OpenedState<2> opened = open_state<2>(read_file(fixtures + "state_1.json"), "state_1.json");
    EXPECT_TRUE(opened.warnings.empty()) << opened.warnings.front();
    EXPECT_EQ(opened.session.position(), 12u);
    EXPECT_EQ(hash_text(opened.session.hash()), "00fc4ed0669b21c0");
    EXPECT_EQ(opened.session.selected_cell, 13u);
    const Parameters& parameters = opened.session.settings().parameters;
    EXPECT_EQ(parameters.text(on_reenqueue_row()), "min");
    EXPECT_EQ(parameters.text(penalty_row()), "add");
    // What is written now opens to the same.
    const OpenedState<2> again = open_state<2>(state_json(opened.session), "again");
    EXPECT_EQ(again.session.hash(), opened.session.hash());
    EXPECT_TRUE(again.session.settings() == opened.session.settings());
}

TEST(OldFiles, TheTraceOfThatStateIsAsItWas) {
    const OpenedState<2> opened = open_state<2>(read_file(fixtures + "state_1.json"), "state_1.json");
    EXPECT_EQ(trace_json(opened.session), read_file(fixtures + "trace_1.json"));
}

TEST(OldFiles, CellsArePutUnderTheirScene) {
    const Scene<3> scene = make_scene(*find_in_catalogue<3>("bottleneck"), 0);
    TessellationSettings settings;
    settings.error_bound = 0.8;
    const CellComplex<3> cells = read_cells<3>(fixtures + "bottleneck_1.cells", scene, settings);
    const CellComplex<3> made = build_cells(scene, settings);
    EXPECT_EQ(cells.points, made.points);
    EXPECT_EQ(cells.cell_primitives, made.cell_primitives);
}

TEST(OldFiles, APathHasItsFrames) {
    const FlightPath<2> path = read_path<2>(read_file(fixtures + "path_1.json"), "path_1.json");
    ASSERT_EQ(path.frames.size(), 2u);
    EXPECT_EQ(path.frames[1].eye, Vec<2>(55, 5));
}

TEST(OldFiles, ResultsHaveTheirRows) {
    const lab::Results results = lab::load_results(fixtures + "results_1.json");
    ASSERT_EQ(results.rows.size(), 3u);
    EXPECT_EQ(method_text(results.rows[0].method), "published");
    EXPECT_TRUE(results.rows[0].approximate);
    EXPECT_EQ(results.rows[0].frames.size(), 2u);
    EXPECT_EQ(method_text(results.rows[2].method), "view");
    EXPECT_EQ(lab::merge({results}).rows.size(), 3u);
}

}  // namespace
}  // namespace sightline
