// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/trig.h"
#include "core/measure/frame_change.h"
#include "core/scene/clean.h"
#include "core/scene/scene_view.h"
#include "core/truth/software_ids.h"
#include "lab/gallery/gallery_functions.h"

namespace sightline::lab {

namespace {

/// The runs after the eye and what it looks at moved along every axis, both ways, and along the diagonals.
template <int D, typename See>
void for_each_shift(const Probe<D>& p, See see) {
    const double size = bounds<D>(p.at.scene().primitives).longest_side() * 1e-12;
    for (int code = 0; code < (D == 2 ? 9 : 27); ++code) {
        Vec<D> by(0);
        for (int axis = 0, rest = code; axis < D; ++axis, rest /= 3) by[axis] = (rest % 3 - 1) * size;
        ViewSpec<D> view = p.view;
        view.eye += by;
        view.look_at += by;
        see(ran(p, view));
    }
}

/// The scene and the view in other coordinates: c -> c * scale + offset.
template <int D>
OneRun ran_elsewhere(const Probe<D>& p, double scale, const Vec<D>& offset, bool as_read) {
    Scene<D> scene = p.at.scene();
    for (Primitive<D>& primitive : scene.primitives)
        for (Vec<D>& corner : primitive) corner = corner * scale + offset;
    ViewSpec<D> view{p.view.eye * scale + offset, p.view.look_at * scale + offset, p.view.fov};
    // 3D coordinates are floats; only a file's are brought near zero before they are rounded.
    if (as_read || D == 3) clean(scene, as_read ? Recentre::yes : Recentre::no, scene.id);
    view.eye -= scene.origin;
    view.look_at -= scene.origin;
    const CellComplex<D> cells = build_cells(scene, p.settings);
    const View<D> seen = scene_view(view, scene, p.settings.reference_size);
    return one_run(
        p.methods, scene, cells, seen, p.settings,
        exact_services(scene, seen, p.settings.reference_size, drawing_of(p.settings.reference, p.at.draw_ids())));
}

/// 0 where the other run has lost primitives: two of them fell together.
double overlap(const OneRun& a, const OneRun& b) {
    return a.rendered.size() == b.rendered.size() ? jaccard(a.rendered, b.rendered) : 0;
}

constexpr int sweep_frames = 21;
constexpr double sweep_degrees = 0.1;

/// The view turned about the first two axes' plane: 3D scenes of the gallery have z up.
template <int D>
ViewSpec<D> turned_view(const ViewSpec<D>& view, double degrees) {
    const SinCos by = sincos_degrees(degrees);
    ViewSpec<D> result = view;
    const Vec<D> d = view.look_at - view.eye;
    result.look_at.x = view.eye.x + by.cos * d.x - by.sin * d.y;
    result.look_at.y = view.eye.y + by.sin * d.x + by.cos * d.y;
    return result;
}

double coverage_of(const Reference& reference, const OneRun& run) {
    double found = 0;
    for (std::size_t i = 0; i < run.rendered.size(); ++i) found += run.rendered[i] && reference.visible[i];
    return found / static_cast<double>(reference.count);
}

constexpr int walk_frames = 24;

template <int D>
ViewSpec<D> on_walk(const Probe<D>& p, int frame) {
    const double t = static_cast<double>(frame) / (walk_frames - 1);
    return {p.view.eye + (p.to.eye - p.view.eye) * t, p.view.look_at + (p.to.look_at - p.view.look_at) * t, p.view.fov};
}

}  // namespace

template <int D>
double least_overlap_under_shifts(const Probe<D>& p) {
    const OneRun here = ran(p);
    double least = 1;
    for_each_shift(p, [&](const OneRun& there) { least = std::min(least, overlap(here, there)); });
    return least;
}

template <int D>
double fewest_steps_under_shifts(const Probe<D>& p) {
    double fewest = std::numeric_limits<double>::infinity();
    for_each_shift(p, [&](const OneRun& there) { fewest = std::min<double>(fewest, there.steps); });
    return fewest;
}

template <int D>
double change_by_powers_of_two(const Probe<D>& p) {
    const OneRun here = ran(p);
    double worst = 0;
    for (const double scale : {0x1p20, 0x1p-20}) {
        const OneRun there = ran_elsewhere(p, scale, Vec<D>(0), false);
        if (there.order.size() != here.order.size()) return 1;
        double differ = 0;
        for (std::size_t i = 0; i < here.order.size(); ++i) differ += here.order[i] != there.order[i];
        if (!here.order.empty()) worst = std::max(worst, differ / static_cast<double>(here.order.size()));
    }
    return worst;
}

template <int D>
double overlap_scaled(const Probe<D>& p) {
    const OneRun here = ran(p);
    return std::min(overlap(here, ran_elsewhere(p, 1e6, Vec<D>(0), false)),
                    overlap(here, ran_elsewhere(p, 1e-6, Vec<D>(0), false)));
}

template <int D>
double overlap_moved(const Probe<D>& p) {
    return overlap(ran(p), ran_elsewhere(p, 1, Vec<D>(1e6), false));
}

template <int D>
double overlap_moved_and_read(const Probe<D>& p) {
    return overlap(ran(p), ran_elsewhere(p, 1, Vec<D>(1e6), true));
}

template <int D>
double spread_over_seeds(const Probe<D>& p) {
    constexpr int seeds = 8;
    const Reference reference = p.at.truth(p.view, p.settings).reference;
    std::vector<double> coverages;
    for (int seed = 1; seed <= seeds; ++seed) {
        Probe<D> other = p;
        other.settings.seed = static_cast<std::uint64_t>(seed);
        coverages.push_back(coverage_of(reference, ran(other)));
    }
    double mean = 0, variance = 0;
    for (const double coverage : coverages) mean += coverage / seeds;
    for (const double coverage : coverages) variance += (coverage - mean) * (coverage - mean) / seeds;
    return std::sqrt(variance);
}

template <int D>
double bad_keys_in_sweep(const Probe<D>& p) {
    double bad = 0;
    for (int i = 0; i < sweep_frames; ++i)
        bad += ran(p, turned_view(p.view, sweep_degrees * (i / (sweep_frames - 1.0) - 0.5))).not_finite;
    return bad;
}

template <int D>
double largest_jump_in_sweep(const Probe<D>& p) {
    double largest = 0;
    std::optional<double> before;
    for (int i = 0; i < sweep_frames; ++i) {
        const ViewSpec<D> view = turned_view(p.view, sweep_degrees * (i / (sweep_frames - 1.0) - 0.5));
        const double now = coverage_of(p.at.truth(view, p.settings).reference, ran(p, view));
        if (before) largest = std::max(largest, std::abs(now - *before));
        before = now;
    }
    return largest;
}

template <int D>
double largest_pop(const Probe<D>& p) {
    double largest = 0;
    std::vector<std::uint8_t> visible, rendered;
    for (int i = 0; i < walk_frames; ++i) {
        const ViewSpec<D> view = on_walk(p, i);
        std::vector<std::uint8_t> now = p.at.truth(view, p.settings).reference.visible;
        OneRun run = ran(p, view);
        if (i > 0) largest = std::max(largest, pop(visible, rendered, now, run.rendered).value_or(0));
        visible = std::move(now);
        rendered = std::move(run.rendered);
    }
    return largest;
}

template <int D>
double largest_visible_change(const Probe<D>& p) {
    double largest = 0;
    std::vector<std::uint8_t> visible;
    for (int i = 0; i < walk_frames; ++i) {
        std::vector<std::uint8_t> now = p.at.truth(on_walk(p, i), p.settings).reference.visible;
        if (i > 0) largest = std::max(largest, 1 - jaccard(visible, now));
        visible = std::move(now);
    }
    return largest;
}

#define SIGHTLINE_INSTANTIATE(D)                                    \
    template double least_overlap_under_shifts<D>(const Probe<D>&); \
    template double fewest_steps_under_shifts<D>(const Probe<D>&);  \
    template double change_by_powers_of_two<D>(const Probe<D>&);    \
    template double overlap_scaled<D>(const Probe<D>&);             \
    template double overlap_moved<D>(const Probe<D>&);              \
    template double overlap_moved_and_read<D>(const Probe<D>&);     \
    template double spread_over_seeds<D>(const Probe<D>&);          \
    template double bad_keys_in_sweep<D>(const Probe<D>&);          \
    template double largest_jump_in_sweep<D>(const Probe<D>&);      \
    template double largest_pop<D>(const Probe<D>&);                \
    template double largest_visible_change<D>(const Probe<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
