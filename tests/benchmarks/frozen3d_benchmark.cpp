// A frozen traversal of a city of 500,000 triangles in 25,468 cells, in the default style at 1280 x 800: circling about
// it, stepping it and seeking in it. LIBGL_ALWAYS_SOFTWARE=1 asks for the software renderer.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "core/draw/picture_3d.h"
#include "core/scene/make/catalogue.h"
#include "shell/desk/camera.h"
#include "shell/gl/context.h"
#include "shell/gl/id_renderer.h"
#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"

namespace sightline {
namespace {

constexpr int width = 1280, height = 800;
constexpr double px_per_pt = 4.0 / 3, aspect = static_cast<double>(width) / height;

/// Draws a frozen session off screen as the viewer does. One context while it lives.
struct Desk {
    GlContext context{GlContext::Place::off_screen, "benchmark", 64, 64};
    IdRenderer ids;
    SolidRenderer renderer;
    GlTarget target{width, height, 1, true};
    Session<3> session;
    SolidList solid;

    /// Run to a budget in per cent, seen from outside.
    explicit Desk(std::int64_t percent) : session(run_to(percent)) {
        const Scene<3>& scene = session.scene();
        session.freeze();
        session.set_view(orbited(outside(session.display_view(), bounds<3>(scene.primitives), scene.up_axis, aspect),
                                 scene.up_axis, 40, 30));
        show();
    }

    Session<3> run_to(std::int64_t percent) {
        static const auto scene = std::make_shared<const Scene<3>>(*generated_scene("city:500k"));
        Settings settings;
        settings.budget = {Budget::Kind::share, static_cast<double>(percent) / 100};
        const DrawIds draw_ids = [this](const Scene<3>& s, const View<3>& view, const ImageSize& size, int layers) {
            return ids.draw(s, view, size, layers);
        };
        Session<3> made(scene, scene->paths.front().frames.front(), settings, method_table<3>(), draw_ids);
        made.run();
        return made;
    }

    /// After a step: what is shown is another list.
    void show() {
        solid = make_solid(session, {{}, aspect, {}, {}});
        renderer.set(solid);
    }

    void draw(bool quick) {
        target.bind();
        renderer.draw(picture_camera(session, aspect), 0, 0, width, height, px_per_pt, quick);
        target.resolve();
        glFinish();
    }

    void count(benchmark::State& run) const {
        run.SetLabel(context.description());
        run.counters["cells"] = session.cells().cell_count();
        run.counters["steps"] = session.recorded();
        run.counters["faces"] = static_cast<double>(solid.face_style.size());
        run.counters["edges"] = static_cast<double>(solid.edge_style.size());
        run.counters["triangles"] = static_cast<double>(solid.triangles.size());
    }
};

/// Arguments: budget in per cent, whether quick as while the mouse drags.
void BM_FrozenOrbit3(benchmark::State& run) {
    Desk desk(run.range(0));
    for (auto _ : run) {
        desk.session.set_view(orbited(desk.session.display_view(), desk.session.scene().up_axis, 3, 0));
        desk.draw(run.range(1) == 1);
    }
    desk.count(run);
}
BENCHMARK(BM_FrozenOrbit3)->ArgsProduct({{1, 5, 10, 100}, {0, 1}})->Unit(benchmark::kMillisecond)->UseRealTime();

/// A step back and one forward again, each shown.
void BM_FrozenStep3(benchmark::State& run) {
    Desk desk(run.range(0));
    bool forward = false;
    for (auto _ : run) {
        forward ? static_cast<void>(desk.session.step()) : static_cast<void>(desk.session.back());
        forward = !forward;
        desk.show();
        desk.draw(false);
    }
    desk.count(run);
}
BENCHMARK(BM_FrozenStep3)->Arg(1)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

/// From the end to the start and back again, each shown.
void BM_FrozenSeek3(benchmark::State& run) {
    Desk desk(run.range(0));
    const std::uint32_t end = desk.session.recorded();
    bool forward = false;
    for (auto _ : run) {
        desk.session.seek(forward ? end : 0);
        forward = !forward;
        desk.show();
        desk.draw(false);
    }
    desk.count(run);
}
BENCHMARK(BM_FrozenSeek3)->Arg(1)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace sightline
