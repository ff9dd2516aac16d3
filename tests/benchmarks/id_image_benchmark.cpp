// The exact image of a city of 500,000 triangles at 1024 x 768, and what is read off it; LIBGL_ALWAYS_SOFTWARE=1 asks
// for the software renderer. Argument: 0 looks along a street, 1 from the air.
//
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "core/base/stopwatch.h"
#include "core/raster/depth_image.h"
#include "core/scene/make/generators_3d.h"
#include "core/space/builders.h"
#include "core/truth/reference.h"
#include "shell/gl/context.h"
#include "shell/gl/id_renderer.h"
#include "shell/gl/scene_mesh.h"

namespace sightline {
namespace {

constexpr ImageSize size{1024, 768};

struct City {
    Scene<3> scene;
    std::array<View<3>, 2> views;
    CellComplex<3> cells;
};

City make_city() {
    Generated made = generate::city(1, 500'000);
    City city;
    city.scene.primitives = std::move(made.triangles);
    city.scene.two_sided = std::move(made.two_sided);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::vector<ViewSpec<3>>& frames = made.paths[i].frames;
        city.views[i] = make_view(frames[frames.size() / 4], static_cast<double>(size.width) / size.height);
    }
    city.cells = build_cells(city.scene, TessellationSettings{});
    return city;
}

const City& city() {
    static const City made = make_city();
    return made;
}

const View<3>& view(const benchmark::State& run) { return city().views[static_cast<std::size_t>(run.range(0))]; }

void count(benchmark::State& run) { run.counters["triangles"] = static_cast<double>(city().scene.primitives.size()); }

void BM_SceneMesh(benchmark::State& run) {
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    for (auto _ : run) {
        const SceneMesh mesh(city().scene);
        glFinish();
    }
    count(run);
}
BENCHMARK(BM_SceneMesh)->Unit(benchmark::kMillisecond);

/// Facing, culling and cutting: all that is not OpenGL's part.
void BM_ImageTriangles(benchmark::State& run) {
    std::vector<ImageCorner> corners;
    for (auto _ : run) {
        corners.clear();
        std::size_t next = 0;
        append_image_triangles(city().scene, view(run), size, next, city().scene.primitives.size() * 3, corners);
    }
    count(run);
    run.counters["drawn"] = static_cast<double>(corners.size()) / 3;
}
BENCHMARK(BM_ImageTriangles)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// Arguments: view, layers. With reading back.
void BM_IdImage(benchmark::State& run) {
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    run.SetLabel(context.description());
    IdRenderer renderer;
    for (auto _ : run)
        benchmark::DoNotOptimize(renderer.draw(city().scene, view(run), size, static_cast<int>(run.range(1))));
    count(run);
}
BENCHMARK(BM_IdImage)
    ->ArgsProduct({{0, 1}, {1, 8}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// By the rasteriser of core. Arguments: view, layers.
void BM_SoftwareImage(benchmark::State& run) {
    for (auto _ : run)
        benchmark::DoNotOptimize(draw_layers(city().scene, view(run), size, static_cast<int>(run.range(1))));
    count(run);
}
BENCHMARK(BM_SoftwareImage)
    ->ArgsProduct({{0, 1}, {1, 8}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// OpenGL's image and the software's in turn: `ratio` is the software's time by OpenGL's, `differ` how many pixels do.
void BM_SoftwareByOpenGl(benchmark::State& run) {
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    IdRenderer renderer;
    double gl = 0, software = 0, differ = 0;
    for (auto _ : run) {
        Stopwatch watch;
        const IdImage by_gl = renderer.draw(city().scene, view(run), size, 1)[0];
        gl += watch.milliseconds();
        watch = {};
        const DepthImage drawn = draw_layers(city().scene, view(run), size, 1)[0];
        software += watch.milliseconds();
        differ = 0;
        for (std::size_t i = 0; i < drawn.ids.size(); ++i) differ += by_gl.ids[i] != drawn.ids[i];
    }
    run.counters["ratio"] = software / gl;
    run.counters["differ"] = differ;
}
BENCHMARK(BM_SoftwareByOpenGl)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->Iterations(20);

void BM_ImageReference(benchmark::State& run) {
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    const IdImage image = IdRenderer().draw(city().scene, view(run), size, 1)[0];
    Reference reference;
    for (auto _ : run) reference = image_reference(image, city().scene, city().cells, view(run));
    count(run);
    run.counters["cells"] = city().cells.cell_count();
    run.counters["visible"] = static_cast<double>(reference.count);
}
BENCHMARK(BM_ImageReference)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
