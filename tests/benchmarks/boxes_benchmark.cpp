// Walks over the tree of boxes: view culling beside a test of every triangle, and `boxes` with one thread and two.
// Argument: 0 a street of the city, 1 the city from the air, 2 the cars, 3 the plant; six frames of its path each.
//
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "core/methods/method_table.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/scene_view.h"

namespace sightline {
namespace {

constexpr ImageSize walk_size{1024, 768};

struct Walked {
    Scene<3> scene;
    CellComplex<3> cells;  ///< empty: only the tree of boxes is asked for
    std::vector<View<3>> views;
};

Walked make_walked(Generated made, std::size_t path) {
    Walked walked;
    walked.scene.primitives = std::move(made.triangles);
    walked.scene.two_sided = std::move(made.two_sided);
    const auto& frames = made.paths[path].frames;
    for (const std::size_t frame : spread_frames(frames.size(), 6))
        walked.views.push_back(scene_view(frames[frame], walked.scene, walk_size));
    walked.cells.boxes->of(walked.scene);
    return walked;
}

const Walked& walked(std::int64_t which) {
    static const std::array<Walked, 4> all{
        make_walked(generate::city(1, 500'000), 0), make_walked(generate::city(1, 500'000), 1),
        make_walked(generate::cars(1, 800'000), 0), make_walked(generate::plant(1, 1'000'000), 0)};
    return all[static_cast<std::size_t>(which)];
}

void walk(benchmark::State& run, const char* method, int threads) {
    const Walked& in = walked(run.range(0));
    const Variant<3> variant = make_variant<3>(method_table<3>(), method);
    Services services;
    services.image = walk_size;
    services.threads = threads;
    OwnRun<3> reused;
    std::size_t rendered = 0;
    for (auto _ : run)
        for (const View<3>& view : in.views) {
            reused.start(make_problem(variant.method, variant.parameters, in.scene, in.cells, view, none, services),
                         variant.method.start);
            reused->run(none);
            rendered = reused->counters().rendered_count;
        }
    run.counters["rendered"] = static_cast<double>(rendered);
}

void BM_EveryTriangle(benchmark::State& run) {
    const Walked& in = walked(run.range(0));
    std::vector<std::uint32_t> shown;
    for (auto _ : run)
        for (const View<3>& view : in.views) {
            Problem<3> problem;
            problem.scene = &in.scene;
            problem.view = view;
            shown.clear();
            for (std::uint32_t i = 0; i < in.scene.primitives.size(); ++i)
                if (shows(problem, i)) shown.push_back(i);
            benchmark::DoNotOptimize(shown.data());
        }
    run.counters["rendered"] = static_cast<double>(shown.size());
}
BENCHMARK(BM_EveryTriangle)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void BM_View(benchmark::State& run) { walk(run, "view", 1); }
BENCHMARK(BM_View)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void BM_BoxesOneThread(benchmark::State& run) { walk(run, "boxes", 1); }
BENCHMARK(BM_BoxesOneThread)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void BM_BoxesAllThreads(benchmark::State& run) { walk(run, "boxes", 0); }
BENCHMARK(BM_BoxesAllThreads)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sightline
