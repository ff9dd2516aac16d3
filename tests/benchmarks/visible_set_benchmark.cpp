// The exact visible set of boxes beside CGAL's arrangement with triangular expansion, all round, scene to answer.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>
#include <benchmark/benchmark.h>

#include "core/base/random.h"
#include "core/base/trig.h"
#include "core/truth/item_buffer.h"
#include "core/truth/visible_set.h"

namespace sightline {
namespace {

const Vec<2> eye(0.50001, 0.50002);
const View<2> all_round{eye, eye + Vec<2>(1, 0), 360, true, {}};

/// rows^2 small turned boxes, one at random in each field of a grid over the unit square, and an outer box. The four
/// fields around the eye stay empty, so that it is outside the boxes.
std::vector<Primitive<2>> boxes(int rows) {
    Random random(1);
    std::vector<Primitive<2>> scene;
    const auto add_box = [&](const Vec<2>& centre, const Vec<2>& arm) {
        const Vec<2> side(-arm.y, arm.x);
        const std::array<Vec<2>, 4> corners{centre + arm, centre + side, centre - arm, centre - side};
        for (int i = 0; i < 4; ++i) scene.push_back({corners[i], corners[(i + 1) % 4]});
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < rows; ++column) {
            const Vec<2> field(column, row),
                centre = field + Vec<2>(random.uniform(0.3, 0.7), random.uniform(0.3, 0.7));
            const SinCos turn = sincos_degrees(random.uniform(0, 90));
            const Vec<2> arm = random.uniform(0.05, 0.29) * Vec<2>(turn.cos, turn.sin);
            if (glm::length(centre / double(rows) - eye) < 1.5 / rows) continue;
            add_box(centre / double(rows), arm / double(rows));
        }
    add_box({0.5, 0.5}, {0.7, 0.7});
    return scene;
}

/// Long segments that all cross one another often.
std::vector<Primitive<2>> crossing_segments(int count) {
    Random random(2);
    std::vector<Primitive<2>> scene;
    for (int i = 0; i < count; ++i)
        scene.push_back({Vec<2>(random.unit(), random.unit()), Vec<2>(random.unit(), random.unit())});
    return scene;
}

/// Boxes of two units, four units apart, and the eye on one line with the sides of many: the exact path's worst day.
void visible_set_lattice(benchmark::State& state) {
    const int rows = static_cast<int>(state.range(0));
    std::vector<Primitive<2>> scene;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < rows; ++column) {
            const Vec<2> low(0.1 * (4 * column), 0.1 * (4 * row)), high(0.1 * (4 * column + 2), 0.1 * (4 * row + 2));
            const std::array<Vec<2>, 4> corners{low, Vec<2>(high.x, low.y), high, Vec<2>(low.x, high.y)};
            for (int i = 0; i < 4; ++i) scene.push_back({corners[i], corners[(i + 1) % 4]});
        }
    const Vec<2> between(0.1 * (4 * (rows / 2) + 3), 0.1 * (4 * (rows / 2) + 2));
    const View<2> view{between, between + Vec<2>(1, 0), 360, true, {}};
    for (auto _ : state) benchmark::DoNotOptimize(exact_visible_set(scene, view));
    state.counters["segments"] = static_cast<double>(scene.size());
    state.counters["visible"] = static_cast<double>(exact_visible_set(scene, view).count);
}
BENCHMARK(visible_set_lattice)->Arg(50)->Unit(benchmark::kMillisecond);

void report(benchmark::State& state, const std::vector<Primitive<2>>& scene) {
    state.counters["segments"] = static_cast<double>(scene.size());
    state.counters["visible"] = static_cast<double>(exact_visible_set(scene, all_round).count);
}

void visible_set_boxes(benchmark::State& state) {
    const auto scene = boxes(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(exact_visible_set(scene, all_round));
    report(state, scene);
}
BENCHMARK(visible_set_boxes)->Arg(16)->Arg(50)->Arg(158)->Unit(benchmark::kMillisecond);

void visible_set_crossing(benchmark::State& state) {
    const auto scene = crossing_segments(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(exact_visible_set(scene, all_round));
    report(state, scene);
}
BENCHMARK(visible_set_crossing)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

void layering_boxes(benchmark::State& state) {
    const auto scene = boxes(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(layering_numbers(scene, all_round));
    report(state, scene);
}
BENCHMARK(layering_boxes)->Arg(16)->Arg(50)->Unit(benchmark::kMillisecond);

void layering_crossing(benchmark::State& state) {
    const auto scene = crossing_segments(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(layering_numbers(scene, all_round));
    report(state, scene);
}
BENCHMARK(layering_crossing)->Arg(250)->Arg(1000)->Unit(benchmark::kMillisecond);

void item_buffer_boxes(benchmark::State& state) {
    const auto scene = boxes(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(item_buffer(scene, all_round, 8192));
    report(state, scene);
}
BENCHMARK(item_buffer_boxes)->Arg(50)->Arg(158)->Unit(benchmark::kMillisecond);

void cgal_triangular_expansion_boxes(benchmark::State& state) {
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Exact>>;
    const auto scene = boxes(static_cast<int>(state.range(0)));
    std::size_t edges = 0;
    for (auto _ : state) {
        std::vector<Exact::Segment_2> segments;
        for (const auto& [a, b] : scene) segments.push_back({{a.x, a.y}, {b.x, b.y}});
        Arrangement arrangement, seen;
        CGAL::insert(arrangement, segments.begin(), segments.end());
        const CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true> visibility(arrangement);
        const Exact::Point_2 from(eye.x, eye.y);
        const CGAL::Arr_naive_point_location<Arrangement> location(arrangement);
        const auto found = location.locate(from);
        const auto* face = boost::get<Arrangement::Face_const_handle>(&found);
        visibility.compute_visibility(from, *face, seen);
        edges = seen.number_of_edges();
    }
    report(state, scene);
    state.counters["edges"] = static_cast<double>(edges);
}
BENCHMARK(cgal_triangular_expansion_boxes)->Arg(16)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
