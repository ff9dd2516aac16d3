// A frame as the 3D viewer flies it, traversal and drawing, on the street of a city of 500,000 triangles at 1024 x 768:
// what a budget saves against drawing everything and against drawing what the view holds. LIBGL_ALWAYS_SOFTWARE=1 asks
// for the software renderer.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <numeric>

#include "core/base/stopwatch.h"
#include "core/methods/method_table.h"
#include "core/scene/make/generators_3d.h"
#include "core/session/settings.h"
#include "core/space/builders.h"
#include "shell/gl/context.h"
#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"
#include "tests/run/run_support.h"

namespace sightline {
namespace {

constexpr int width = 1024, height = 768;
constexpr std::size_t triangles = 500'000;

struct Town {
    std::shared_ptr<const Scene<3>> scene;
    CellComplex<3> cells;
    std::array<std::vector<View<3>>, 2> views;  ///< on the street, in the air
};

Town make_town() {
    Generated made = generate::city(1, triangles);
    const auto scene = std::make_shared<Scene<3>>();
    scene->primitives = std::move(made.triangles);
    scene->two_sided = std::move(made.two_sided);
    Town town{scene, build_cells(*scene, Settings{}), {}};
    for (std::size_t path = 0; path < 2; ++path)
        for (std::size_t frame = 0; frame < made.paths[path].frames.size(); frame += 10)
            town.views[path].push_back(make_view(made.paths[path].frames[frame], static_cast<double>(width) / height));
    return town;
}

const Town& town() {
    static const Town made = make_town();
    return made;
}

constexpr std::array<const char*, 4> methods{"published", "layers", "view", "everything"};

/// Mean milliseconds of the rows that others are held against, per method and path; 0: not run yet.
using Held = std::array<std::array<double, 2>, methods.size()>;
Held& held() {
    static Held ms{};
    return ms;
}

/// Arguments: method, budget in per cent, path (0: street, 1: air). `everything` asks no method which triangles to
/// draw. Drawing the chosen triangles alone (the time less `traverse`) bounds what any method can save.
void BM_WholeFrame3(benchmark::State& run) {
    const Town& here = town();
    const char* id = methods[static_cast<std::size_t>(run.range(0))];
    const Method<3>& method = find_method<3>(method_table<3>(), id);
    const bool all = run.range(0) == 3;
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    run.SetLabel(std::string(id) + ", " + context.description());
    const GlTarget target(width, height, 1, true);
    SolidRenderer renderer;
    SolidList list;
    list.styles = {{"rendered", {190, 190, 195}}};
    list.scene = here.scene;
    if (all) {
        list.triangles.resize(here.scene->primitives.size());
        std::iota(list.triangles.begin(), list.triangles.end(), 0u);
        list.runs = {{0, 0, static_cast<std::uint32_t>(list.triangles.size())}};
    }
    renderer.set(list);
    OwnRun<3> traversed;
    std::vector<std::uint32_t> ids;
    const std::vector<View<3>>& views = here.views[static_cast<std::size_t>(run.range(2))];
    std::size_t next = 0;
    double drawn = 0, frames = 0, traverse = 0;
    const Stopwatch whole;
    for (auto _ : run) {
        const View<3>& view = views[next];
        next = (next + 1) % views.size();
        if (!all) {
            const Stopwatch traversal;
            Problem<3> problem = test::problem_of(*here.scene, here.cells, view, Settings{});
            problem.budget = static_cast<std::uint32_t>(triangles / 100 * static_cast<std::size_t>(run.range(1)));
            traversed.start(problem, method.start);
            benchmark::DoNotOptimize(traversed->run(none));
            traverse += traversal.milliseconds();
            ids.clear();
            for (const Met met : traversed->met())
                if (!met.culled()) ids.push_back(met.primitive());
            const SolidList::Run one{0, 0, static_cast<std::uint32_t>(ids.size())};
            renderer.set_triangles({&one, 1}, ids);
        }
        target.bind();
        renderer.draw(view, 0, 0, width, height, 4.0 / 3);
        target.resolve();
        glFinish();
        drawn += static_cast<double>(all ? list.triangles.size() : ids.size());
        ++frames;
    }
    const double ms = whole.milliseconds() / frames;
    const auto path = static_cast<std::size_t>(run.range(2));
    if (run.range(1) == 100) held()[static_cast<std::size_t>(run.range(0))][path] = ms;
    if (held()[2][path] > 0 && held()[3][path] > 0) {
        run.counters["view_x"] = held()[2][path] / ms;
        run.counters["everything_x"] = held()[3][path] / ms;
    }
    run.counters["traverse"] = traverse / frames;
    run.counters["drawn"] = drawn / frames;
    run.counters["cells"] = here.cells.cell_count();
}
BENCHMARK(BM_WholeFrame3)
    ->ArgsProduct({{3, 2}, {100}, {0, 1}})
    ->ArgsProduct({{0, 1}, {1, 2, 5, 10}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace sightline
