// 3D: from a city to its cells, and one frame of each method on the street. Frame cost should follow what is seen, not
// what exists: the last rows compare the same street view in cities of different size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <benchmark/benchmark.h>

#include <assimp/Importer.hpp>
#include <map>
#include <tuple>

#include "core/base/random.h"
#include "core/base/stopwatch.h"
#include "core/methods/method_table.h"
#include "core/scene/make/generators_3d.h"
#include "core/session/settings.h"
#include "core/space/builders.h"
#include "tests/run/run_support.h"

namespace sightline {
namespace {

constexpr std::size_t usual = 500'000;

/// A city of so many triangles with leaves as large as those of the usual size, and the path along its street.
struct City {
    Scene<3> scene;
    Settings settings;
    CellComplex<3> cells;
    std::vector<View<3>> views;

    explicit City(std::size_t triangles, bool shuffled = false) {
        Generated made = generate::city(1, triangles);
        static const double leaf = 0.05 * bounds<3>(generate::city(1, usual).triangles).longest_side();
        settings.error_bound = leaf / bounds<3>(made.triangles).longest_side();
        scene.primitives = std::move(made.triangles);
        scene.two_sided = std::move(made.two_sided);
        if (shuffled) shuffle();
        cells = build_cells(scene, settings);
        for (const FlightPath<3>& path : made.paths)
            if (path.id == "street")
                for (std::size_t frame = 0; frame < path.frames.size(); ++frame)
                    views.push_back(make_view(path.frames[frame], 4.0 / 3));
    }

private:
    void shuffle() {
        Random random(1);
        for (std::size_t i = scene.primitives.size(); i > 1; --i) {
            const std::size_t other = random.below(i);
            std::swap(scene.primitives[i - 1], scene.primitives[other]);
            if (!scene.two_sided.empty()) std::swap(scene.two_sided[i - 1], scene.two_sided[other]);
        }
    }
};

const City& city(std::size_t triangles) {
    static std::map<std::size_t, City> made;
    return made.try_emplace(triangles, triangles).first->second;
}

/// Reads and writes more than the caches hold, as the drawing of a frame does.
void forget_caches() {
    static std::vector<char> memory(std::size_t{48} << 20);
    for (std::size_t i = 0; i < memory.size(); i += 64) ++memory[i];
    benchmark::ClobberMemory();
}

/// Each iteration is one frame; they go through the views in turn.
void frames(benchmark::State& run, const City& city, const char* method_id, std::uint32_t budget) {
    const Method<3>& method = find_method<3>(method_table<3>(), method_id);
    OwnRun<3> traversal;
    std::size_t next = 0, steps = 0, rendered = 0, met = 0, count = 0;
    for (auto _ : run) {
        Problem<3> problem = test::problem_of(city.scene, city.cells, city.views[next], city.settings);
        problem.budget = budget;
        traversal.start(problem, method.start);
        benchmark::DoNotOptimize(traversal->run(none));
        next = (next + 1) % city.views.size();
        ++count;
        steps += traversal->steps();
        rendered += traversal->counters().rendered_count;
        met += traversal->counters().touched_count;
    }
    run.counters["cells"] = city.cells.cell_count();
    run.counters["steps"] = static_cast<double>(steps) / static_cast<double>(count);
    run.counters["rendered"] = static_cast<double>(rendered) / static_cast<double>(count);
    run.counters["met"] = static_cast<double>(met) / static_cast<double>(count);
}

/// A frame as it comes between two drawings. Arguments: method, budget in per cent, 1: the soup is shuffled.
void BM_ColdFrame3(benchmark::State& run) {
    static const City ordered(usual), shuffled(usual, true);
    constexpr std::array<const char*, 3> methods{"published", "layers", "centroid"};
    const City& city = run.range(2) ? shuffled : ordered;
    const Method<3>& method = find_method<3>(method_table<3>(), methods[static_cast<std::size_t>(run.range(0))]);
    run.SetLabel(std::string(method.id) + (run.range(2) ? ", shuffled" : ""));
    OwnRun<3> traversal;
    std::size_t next = 0, steps = 0, rendered = 0;
    double seconds = 0;
    for (auto _ : run) {
        Problem<3> problem = test::problem_of(city.scene, city.cells, city.views[next], city.settings);
        problem.budget = static_cast<std::uint32_t>(usual / 100 * static_cast<std::size_t>(run.range(1)));
        forget_caches();
        Stopwatch watch;
        traversal.start(problem, method.start);
        benchmark::DoNotOptimize(traversal->run(none));
        const double took = watch.milliseconds() / 1e3;
        run.SetIterationTime(took);
        seconds += took;
        next = (next + 1) % city.views.size();
        steps += traversal->steps();
        rendered += traversal->counters().rendered_count;
    }
    run.counters["ns_per_step"] = seconds * 1e9 / static_cast<double>(steps);
    run.counters["ns_per_rendered"] = seconds * 1e9 / static_cast<double>(rendered);
}
BENCHMARK(BM_ColdFrame3)->ArgsProduct({{0, 1, 2}, {1, 5}, {0, 1}})->UseManualTime()->Unit(benchmark::kMillisecond);

constexpr std::array<const char*, 5> methods{"published", "layers", "centroid", "view", "everything"};

/// Arguments: method, budget in per cent.
void BM_Frame3(benchmark::State& run) {
    const char* method = methods[static_cast<std::size_t>(run.range(0))];
    run.SetLabel(method);
    frames(run, city(usual), method, static_cast<std::uint32_t>(usual / 100 * static_cast<std::size_t>(run.range(1))));
}
BENCHMARK(BM_Frame3)->ArgsProduct({{0, 1, 2, 3, 4}, {1, 5, 10}})->Unit(benchmark::kMillisecond);

/// Arguments: method, triangles of the city. The budget is 1 % of the usual city.
void BM_SameStreet3(benchmark::State& run) {
    const char* method = methods[static_cast<std::size_t>(run.range(0))];
    run.SetLabel(method);
    frames(run, city(static_cast<std::size_t>(run.range(1))), method, usual / 100);
}
BENCHMARK(BM_SameStreet3)->ArgsProduct({{0, 1}, {500'000, 2'000'000, 8'000'000}})->Unit(benchmark::kMillisecond);

void BM_Tessellate3(benchmark::State& run) {
    Scene<3> scene;
    scene.primitives = generate::city(1, usual).triangles;
    CellComplex<3> cells;
    for (auto _ : run) cells = tessellation(scene, Settings{});
    run.counters["cells"] = cells.cell_count();
    run.counters["bytes_per_cell"] = static_cast<double>(cells.memory_bytes()) / cells.cell_count();
}
BENCHMARK(BM_Tessellate3)->Unit(benchmark::kMillisecond);

void BM_Assign3(benchmark::State& run) {
    CellComplex<3> cells = city(usual).cells;
    const auto& triangles = city(usual).scene.primitives;
    for (auto _ : run) assign_primitives(cells, triangles);
    run.counters["bytes_per_triangle"] =
        static_cast<double>(cells.reference_memory_bytes()) / static_cast<double>(triangles.size());
}
BENCHMARK(BM_Assign3)->Unit(benchmark::kMillisecond);

/// The city as an OBJ file in memory with every corner once.
std::string city_as_obj() {
    std::string points, faces;
    std::map<std::tuple<double, double, double>, std::size_t> known;
    char line[120];
    for (const Primitive<3>& triangle : city(usual).scene.primitives) {
        faces += 'f';
        for (const Vec<3>& p : triangle) {
            const auto [at, is_new] = known.try_emplace({p.x, p.y, p.z}, known.size() + 1);
            if (is_new) {
                std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", p.x, p.y, p.z);
                points += line;
            }
            faces += ' ' + std::to_string(at->second);
        }
        faces += '\n';
    }
    return points + faces;
}

/// What tessellating and assigning is held against: Assimp reads the same city.
void BM_AssimpReads3(benchmark::State& run) {
    const std::string text = city_as_obj();
    for (auto _ : run) {
        Assimp::Importer importer;
        const aiScene* read = importer.ReadFileFromMemory(
            text.data(), text.size(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices, "obj");
        if (!read) run.SkipWithError(importer.GetErrorString());
    }
    run.counters["bytes"] = static_cast<double>(text.size());
}
BENCHMARK(BM_AssimpReads3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
