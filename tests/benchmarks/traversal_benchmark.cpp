// The traversal beside the papers' structure (tests/run/reference_traversal.h), tessellation, and seeking.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <chrono>

#include "core/base/random.h"
#include "core/scene/make/generators.h"
#include "core/session/session.h"
#include "core/space/builders.h"
#include "tests/run/reference_traversal.h"

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
    Frame<2> frame() const { return make_frame<2>(scene.primitives, cells, view, settings); }
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
    Frame<2> frame = town().frame();
    if (run.range(0) > 0) frame.budget = static_cast<std::uint32_t>(run.range(0));
    const Method<2>& method = find_method<2>(method_table<2>(), "published");
    State<2> state;
    for (auto _ : run) {
        method.start(frame, state);
        benchmark::DoNotOptimize(method.run(frame, state, none));
    }
    count_cells(run, state.step);
}
BENCHMARK(BM_TraversalFlat)->Arg(0)->Arg(5000)->Unit(benchmark::kMillisecond);

void BM_TraversalPapersStructure(benchmark::State& run) {
    const Frame<2> frame = town().frame();
    test::PaperTraversal paper(town().scene, town().cells);
    const std::size_t budget = run.range(0) > 0 ? static_cast<std::size_t>(run.range(0)) : none;
    std::vector<std::uint32_t> projected, rendered;
    for (auto _ : run) {
        projected.clear();
        rendered.clear();
        paper.run(town().view, seed_cells(frame).front(), budget, projected, rendered);
    }
    count_cells(run, projected.size());
}
BENCHMARK(BM_TraversalPapersStructure)->Arg(0)->Arg(5000)->Unit(benchmark::kMillisecond);

void BM_TraversalRecorded(benchmark::State& run) {
    const Frame<2> frame = town().frame();
    const Method<2>& method = find_method<2>(method_table<2>(), "published");
    State<2> state;
    Timeline timeline;
    for (auto _ : run) {
        timeline = {};
        method.start(frame, state);
        timeline.seed_count = state.front_size;
        while (method.record(frame, state, timeline) == Stop::none) {
        }
    }
    count_cells(run, state.step);
    run.counters["bytes_per_step"] = static_cast<double>(timeline.memory_bytes()) / state.step;
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

/// From one end of the recording to the other.
void BM_SeekWholeRecording(benchmark::State& run) {
    Session<2> session = long_session();
    for (auto _ : run) session.seek(session.position() > 0 ? 0 : session.recorded());
    run.counters["steps"] = session.recorded();
}
BENCHMARK(BM_SeekWholeRecording)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
