// The traversal beside the papers' structure (tests/run/reference_traversal.h), tessellation, and seeking.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <chrono>

#include "core/base/random.h"
#include "core/methods/cells/seed_cells.h"
#include "core/scene/make/generators.h"
#include "core/session/explain.h"
#include "core/space/builders.h"
#include "tests/run/reference_traversal.h"
#include "tests/run/run_support.h"

namespace sightline {
namespace {

/// A town seen all round from a crossing near its middle: every cell is in view, so a full traversal pops them all.
struct Town {
    Scene<2> scene;
    CellComplex<2> cells;
    Settings settings;
    View<2> view;

    Town(std::size_t segments, double error_bound) {
        scene.primitives = city_blocks(segments, 1);
        settings.error_bound = error_bound;
        cells = build_cells(scene, settings);
        const Box<2> box = bounds<2>(scene.primitives);
        view = make_view(ViewSpec<2>{box.centre(), box.max, 360});
    }
    Problem<2> problem() const { return test::problem_of(scene, cells, view, settings); }
};

const Town& town() {
    static const Town made(80'000, 0.006);
    return made;
}

void count_cells(benchmark::State& run, std::size_t projected) {
    run.counters["cells"] = static_cast<double>(town().cells.cell_count());
    run.counters["projected"] = static_cast<double>(projected);
    run.SetItemsProcessed(static_cast<std::int64_t>(run.iterations() * projected));
}

/// Argument: budget in primitives; 0: none, the front empties.
void BM_TraversalFlat(benchmark::State& run) {
    Problem<2> problem = town().problem();
    if (run.range(0) > 0) problem.budget = static_cast<std::uint32_t>(run.range(0));
    const Method<2>& method = find_method<2>(method_table<2>(), "published");
    OwnRun<2> traversal;
    for (auto _ : run) {
        traversal.start(problem, method.start);
        benchmark::DoNotOptimize(traversal->run(none));
    }
    count_cells(run, traversal->steps());
}
BENCHMARK(BM_TraversalFlat)->Arg(0)->Arg(5000)->Unit(benchmark::kMillisecond);

void BM_TraversalPapersStructure(benchmark::State& run) {
    const Problem<2> problem = town().problem();
    test::PaperTraversal paper(town().scene, town().cells);
    const std::size_t budget = run.range(0) > 0 ? static_cast<std::size_t>(run.range(0)) : none;
    std::vector<std::uint32_t> projected, rendered;
    for (auto _ : run) {
        projected.clear();
        rendered.clear();
        paper.run(town().view, seed_cells(problem).front(), budget, projected, rendered);
    }
    count_cells(run, projected.size());
}
BENCHMARK(BM_TraversalPapersStructure)->Arg(0)->Arg(5000)->Unit(benchmark::kMillisecond);

void BM_TraversalRecorded(benchmark::State& run) {
    const Problem<2> problem = town().problem();
    const Method<2>& method = find_method<2>(method_table<2>(), "published");
    OwnRun<2> traversal;
    Timeline<2> timeline;
    for (auto _ : run) {
        traversal.start(problem, method.start);
        timeline = {};
        timeline.begin(*traversal);
        while (timeline.forward(traversal) == Stop::none) {
        }
    }
    count_cells(run, traversal->steps());
    run.counters["bytes_per_step"] = static_cast<double>(timeline.memory_bytes()) / traversal->steps();
}
BENCHMARK(BM_TraversalRecorded)->Unit(benchmark::kMillisecond);

/// 100,000 segments into about 300,000 cells.
const Town& large_town() {
    static const Town made(100'000, 0.003);
    return made;
}

void BM_Tessellate(benchmark::State& run) {
    CellComplex<2> cells;
    for (auto _ : run) cells = tessellation(large_town().scene, large_town().settings);
    run.counters["cells"] = cells.cell_count();
}
BENCHMARK(BM_Tessellate)->Unit(benchmark::kMillisecond);

void BM_Assign(benchmark::State& run) {
    CellComplex<2> cells = tessellation(large_town().scene, large_town().settings);
    for (auto _ : run) assign_primitives(cells, large_town().scene.primitives);
    run.counters["references_per_primitive"] =
        static_cast<double>(cells.cell_primitives.size()) / static_cast<double>(large_town().scene.primitives.size());
}
BENCHMARK(BM_Assign)->Unit(benchmark::kMillisecond);

/// A recorded session of more than 100,000 steps.
Session<2> long_session() {
    Settings settings = town().settings;
    settings.error_bound = 0.005;
    const Box<2> box = bounds<2>(town().scene.primitives);
    Session<2> session(std::make_shared<const Scene<2>>(town().scene), {box.centre(), box.max, 360}, settings);
    session.run();
    return session;
}

/// To random steps; the longest is reported.
void BM_Seek(benchmark::State& run) {
    Session<2> session = long_session();
    Random random(1);
    double longest = 0;
    for (auto _ : run) {
        const auto start = std::chrono::steady_clock::now();
        session.seek(static_cast<std::uint32_t>(random.below(session.recorded() + 1)));
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        longest = std::max(longest, took.count());
    }
    run.counters["steps"] = session.recorded();
    run.counters["longest_ms"] = longest;
}
BENCHMARK(BM_Seek)->Unit(benchmark::kMillisecond)->Iterations(200);

/// Where a cell of about 25,000 stands, and each single change for it: a fifth of a second is asked for.
void BM_ExplainCell(benchmark::State& run) {
    Settings settings = town().settings;
    settings.error_bound = 0.014;
    const Box<2> box = bounds<2>(town().scene.primitives);
    Session<2> session(std::make_shared<const Scene<2>>(town().scene), {box.centre(), box.max, 90}, settings);
    session.seek(session.cells().cell_count() / 20);
    session.reference();
    const std::uint32_t cell = session.traversal().front().back().first.id;
    for (auto _ : run) {
        benchmark::DoNotOptimize(rows(explain_cell(session, cell)).size());
        benchmark::DoNotOptimize(counterfactuals(session, cell_item(cell)).changes.size());
    }
    run.counters["cells"] = session.cells().cell_count();
}
BENCHMARK(BM_ExplainCell)->Unit(benchmark::kMillisecond);

/// From one end of the recording to the other.
void BM_SeekWholeRecording(benchmark::State& run) {
    Session<2> session = long_session();
    for (auto _ : run) session.seek(session.position() > 0 ? 0 : session.recorded());
    run.counters["steps"] = session.recorded();
}
BENCHMARK(BM_SeekWholeRecording)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
