// Orbiting 25,000 tetrahedra over a town at 1280 x 800; LIBGL_ALWAYS_SOFTWARE=1 asks for the software renderer.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "core/base/trig.h"
#include "shell/gl/context.h"
#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"
#include "tests/draw/solid_samples.h"

namespace sightline {
namespace {

constexpr int width = 1280, height = 800;

View<3> orbit(int degrees) {
    const SinCos way = sincos_degrees(degrees);
    return make_view({{50 + 110 * way.cos, 50 + 110 * way.sin, 70}, {50, 50, 5}, 50}, double(width) / height);
}

/// 24,576 tetrahedra whose projected ones are of this colour, and a town of so many triangles.
SolidList town(std::size_t triangles, Colour projected) {
    SolidList list;
    list.styles = {{"projected", projected},
                   {"front", {240, 150, 60}},
                   {"front edge", {60, 40, 20}},
                   {"rendered", {190, 190, 195}}};
    test::add_tetrahedra(list, 16, 0.18, {0, 0, 0}, {100, 100, 30});
    if (triangles > 0) test::show_scene(list, 3, test::box_town(triangles));
    return list;
}

void count(benchmark::State& run, const SolidList& list) {
    run.counters["faces"] = static_cast<double>(list.face_style.size());
    run.counters["edges"] = static_cast<double>(list.edge_style.size());
    run.counters["triangles"] = static_cast<double>(list.triangles.size());
}

/// Arguments: triangles of the town, samples a pixel, whether the projected cells are translucent, whether quick.
void BM_SolidOrbit(benchmark::State& run) {
    const SolidList list = town(static_cast<std::size_t>(run.range(0)),
                                {90, 140, 200, static_cast<std::uint8_t>(run.range(2) ? 120 : 255)});
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    run.SetLabel(context.description());
    const GlTarget target(width, height, static_cast<int>(run.range(1)), true);
    SolidRenderer renderer;
    renderer.set(list);
    int degrees = 0;
    for (auto _ : run) {
        target.bind();
        renderer.draw(orbit(degrees += 3), 0, 0, width, height, 4.0 / 3, run.range(3) == 1);
        target.resolve();
        glFinish();
    }
    count(run, list);
}
BENCHMARK(BM_SolidOrbit)
    ->ArgsProduct({{0, 25000, 100000}, {1}, {0}, {0, 1}})
    ->Args({100000, 4, 0, 0})
    ->Args({0, 1, 1, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// A new list at each step.
void BM_SolidSet(benchmark::State& run) {
    const SolidList list = town(100000, {90, 140, 200});
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    SolidRenderer renderer;
    for (auto _ : run) renderer.set(list);
    count(run, list);
}
BENCHMARK(BM_SolidSet)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Other triangles at each frame of a flight; argument: how many of 500,000.
void BM_SolidTriangles(benchmark::State& run) {
    SolidList list = town(500000, {90, 140, 200});
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    SolidRenderer renderer;
    renderer.set(list);
    Random random(3);
    std::vector<std::uint32_t> ids(static_cast<std::size_t>(run.range(0)));
    for (std::uint32_t& id : ids) id = static_cast<std::uint32_t>(random.below(500000));
    const SolidList::Run one{3, 0, static_cast<std::uint32_t>(ids.size())};
    for (auto _ : run) renderer.set_triangles({&one, 1}, ids);
}
BENCHMARK(BM_SolidTriangles)->Arg(5000)->Arg(25000)->Unit(benchmark::kMicrosecond)->UseRealTime();

}  // namespace
}  // namespace sightline
