// The whole window at 1280 x 800 over 20,000 cells and about 1,000 labels; LIBGL_ALWAYS_SOFTWARE=1 asks for the
// software renderer. And a change of settings on 5,000 segments, until the picture's lists are there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "core/draw/cell_number.h"
#include "core/draw/picture.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/scene/make/generators.h"
#include "shell/desk/change.h"
#include "shell/desk/moved.h"
#include "shell/desk/moves.h"
#include "shell/window/window.h"
#include "viewer2d/picture2d.h"

namespace sightline {
namespace {

Workbench<2> city(std::size_t segments, double error_bound) {
    Scene<2> scene;
    scene.primitives = city_blocks(segments, 1);
    Settings settings;
    settings.error_bound = error_bound;
    const Box<2> box = bounds<2>(scene.primitives);
    Workbench<2> bench{
        Session<2>(std::make_shared<const Scene<2>>(std::move(scene)), {box.centre(), box.max, 120}, settings)};
    bench.say = [](const std::string&) {};
    return bench;
}

/// The window with its picture, after half of the run.
struct CityWindow {
    explicit CityWindow(bool panels) : bench(city(8100, 0.0125)) {
        Settings settings = bench.session.settings();
        settings.label = CellNumber::count;  // short enough that a thousand of them have room
        settings.label_where = LabelWhere::all;
        change_settings(bench, settings);
        if (!panels) {
            bench.desk.right.clear();
            bench.desk.timeline = false;
        }
        window.stage.interact = [this](Ui& ui, const Area& area) {
            // Where the mouse would put it; off screen there is none.
            if (mouse) ui.hovering = *mouse;
            picture.interact(ui, area);
        };
        window.stage.draw = [this](Ui& ui, const Area& area) { picture.draw(ui, area); };
        go_to_step(bench, whole_run(bench) / 2);
        ++window.ui().revision;
        window.frame(0);
        window.frame(0);
    }
    void frame() {
        window.frame(0);
        glFinish();
    }

    Workbench<2> bench;
    std::optional<std::uint32_t> mouse;
    Window<2> window{bench, {.place = GlContext::Place::off_screen, .placement = {1280, 800, {}, false}, .scale = 1}};
    Picture2d picture{bench};
};

void report(benchmark::State& run, const CityWindow& city) {
    run.SetLabel(city.window.context().description());
    run.counters["cells"] = city.bench.session.cells().cell_count();
    run.counters["labels"] = static_cast<double>(city.picture.label_count());
}

/// A step in each frame. Argument: 1 with panels and timeline, 0 with the picture alone.
void BM_WindowPlaying(benchmark::State& run) {
    CityWindow city(run.range(0) != 0);
    for (auto _ : run) {
        step_forward(city.bench, 1);
        ++city.window.ui().revision;
        city.frame();
    }
    report(run, city);
}
BENCHMARK(BM_WindowPlaying)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// Standing still, another cell under the mouse in each frame.
void BM_WindowMouseMoves(benchmark::State& run) {
    CityWindow city(false);
    std::uint32_t cell = 0;
    for (auto _ : run) {
        city.mouse = cell++ % city.bench.session.cells().cell_count();
        city.frame();
    }
    report(run, city);
}
BENCHMARK(BM_WindowMouseMoves)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// Pans by a little in each frame: everything is drawn again.
void BM_WindowPans(benchmark::State& run) {
    CityWindow city(false);
    double x = 0;
    for (auto _ : run) {
        Settings settings = city.bench.session.settings();
        settings.zoom_at = ZoomAt::point;
        const Vec<2> middle = city.bench.session.culling_view().eye;
        settings.zoom_x = middle.x + (x += 0.1);
        settings.zoom_y = middle.y;
        change_settings(city.bench, settings, "pan");
        ++city.window.ui().revision;
        city.frame();
    }
    report(run, city);
}
BENCHMARK(BM_WindowPans)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// 5,000 segments, whole: cells, assignment, traversal to its end and back, reference, picture. Argument: 1 changes
/// the cells, 0 only the penalty.
void BM_SettingsChange(benchmark::State& run) {
    Workbench<2> bench = city(5000, 0.05);
    bench.record_ahead = true;
    traversal_changed(bench);
    bool flip = false;
    for (auto _ : run) {
        flip = !flip;
        Settings settings = bench.session.settings();
        if (run.range(0))
            settings.error_bound = flip ? 0.045 : 0.05;
        else
            settings.parameters.set(penalty_row(), flip ? "none" : "multiply");
        change_settings(bench, settings);
        benchmark::DoNotOptimize(bench.session.reference().count);
        benchmark::DoNotOptimize(make_picture(bench.session).shapes.size());
    }
    run.counters["cells"] = bench.session.cells().cell_count();
}
BENCHMARK(BM_SettingsChange)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace sightline
