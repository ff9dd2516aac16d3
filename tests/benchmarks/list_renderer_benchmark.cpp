// Drawing a session of 20,000 cells with OpenGL at 1280 x 800; LIBGL_ALWAYS_SOFTWARE=1 asks for the software renderer.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "core/draw/picture.h"
#include "core/scene/make/generators.h"
#include "shell/gl/context.h"
#include "shell/gl/list_renderer.h"
#include "shell/gl/target.h"

namespace sightline {
namespace {

constexpr int width = 1280, height = 800;

/// After half of the traversal, seen from the middle of a town, so that cells of all states are there.
Session<2> town_session() {
    Scene<2> scene;
    scene.primitives = city_blocks(6200, 1);
    Settings settings;
    settings.error_bound = 0.0125;
    const Box<2> box = bounds<2>(scene.primitives);
    Session<2> session(std::make_shared<const Scene<2>>(std::move(scene)), {box.centre(), box.max, 120}, settings);
    session.run();
    session.seek(session.recorded() / 2);
    return session;
}

struct Town {
    Session<2> session = town_session();
    DrawList list = make_picture(session);
};

const Town& town() {
    static const Town made;
    return made;
}

ListView whole(const DrawList& list) {
    const Vec<2> extent = list.world.extent();
    const double unit = std::max(extent.x / width, extent.y / height);
    const Vec<2> half(unit * width / 2, unit * height / 2);
    return {{list.world.centre() - half, list.world.centre() + half}, 0, 0, width, height};
}

void count(benchmark::State& run) {
    run.counters["cells"] = town().session.cells().cell_count();
    run.counters["facets"] = town().session.cells().facet_count();
    run.counters["shapes"] = static_cast<double>(town().list.shapes.size());
}

void BM_ListMesh(benchmark::State& run) {
    const DrawList& list = town().list;
    ListMesh mesh;
    for (auto _ : run) make_mesh(list, mesh);
    count(run);
    run.counters["triangles"] = static_cast<double>(mesh.indices.size()) / 3;
    run.counters["runs"] = static_cast<double>(mesh.runs.size());
}
BENCHMARK(BM_ListMesh)->Unit(benchmark::kMillisecond);

/// Argument: 1 uploads the list in each frame, 0 only draws.
void BM_ListDraw(benchmark::State& run) {
    const DrawList& list = town().list;
    const GlContext context(GlContext::Place::off_screen, "benchmark", 64, 64);
    run.SetLabel(context.description());
    const GlTarget target(width, height);
    ListRenderer renderer;
    renderer.set(list);
    target.bind();
    for (auto _ : run) {
        if (run.range(0)) renderer.set(list);
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        renderer.draw(whole(list));
        glFinish();
    }
    count(run);
}
BENCHMARK(BM_ListDraw)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sightline
