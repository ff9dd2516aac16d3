// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.h"
#include "core/methods/coorg_teller/visible_run.h"
#include "core/scene/scene_view.h"
#include "lab/measure/lab_scene.h"
#include "lab/object_space/object_space.h"

namespace sightline::lab {

namespace {

View<3> all_round(const ViewSpec<3>& spec) {
    View<3> view;
    view.eye = spec.eye;
    view.look_at = spec.look_at;
    view.fov = 360;
    view.all_round = true;
    return view;
}

std::vector<View<3>> all_round_views(const SeededScene& scene, const std::string& path) {
    std::vector<View<3>> views;
    for (const ViewSpec<3>& spec : find_path(*scene.scene, path).frames) views.push_back(all_round(spec));
    return views;
}

/// Those of so many that are held against the exact set, and drawn.
std::vector<std::size_t> frames_of(std::size_t count, const ObjectSpaceOptions& options) {
    return spread_frames(count, options.frames == 0 ? count : options.frames);
}

/// A method on its way along a path.
struct Walker {
    Walker(const MethodTables& tables, const std::string& text)
        : variant(make_variant<3>(tables.in_3d, text)), cells(std::make_unique<CellComplex<3>>()) {}

    Problem<3> problem(const SeededScene& scene, const View<3>& view) const {
        return make_problem(variant.method, variant.parameters, *scene.scene, *cells, view);
    }
    const VisibleRun<3>* visible_run() const { return dynamic_cast<const VisibleRun<3>*>(&*run); }
    double parameter(std::string_view name) const {
        const ParameterRow* const row = variant.method.parameter(name);
        return row ? variant.parameters.number(*row) : 0;
    }
    double most_occluders() const {
        return variant.method.parameter("shadows") ? parameter("shadows") : parameter("occluder_count");
    }

    Variant<3> variant;
    std::unique_ptr<CellComplex<3>> cells;  ///< empty: what the method makes of the scene stands here
    OwnRun<3> run;
};

/// One frame; `started` and `ran` get its times.
void step(Walker& walker, const SeededScene& scene, const View<3>& view, double& started, double& ran) {
    const Problem<3> problem = walker.problem(scene, view);
    Stopwatch clock;
    walker.run.start(problem, walker.variant.method.start);
    started = clock.milliseconds();
    clock = {};
    walker.run->run(none);
    ran = clock.milliseconds();
}

/// Medians over the passes of what each frame costs, each method after the other in every frame. The first frame pays
/// for all that is not known yet, and is left out where there are others. After the last pass' frame `look(walker,
/// frame)`.
std::vector<WalkCost> walk(std::vector<Walker>& walkers, const SeededScene& scene, const std::vector<View<3>>& views,
                           int passes, const std::function<void(std::size_t walker, std::size_t frame)>& look = {}) {
    struct Samples {
        std::vector<double> started, ran;
    };
    std::vector<std::vector<Samples>> samples(walkers.size(), std::vector<Samples>(views.size()));
    std::vector<WalkCost> costs(walkers.size());
    const std::size_t begin = views.size() > 1 ? 1 : 0;
    for (int pass = 0; pass < passes; ++pass) {
        for (Walker& walker : walkers) walker.run = {};
        for (std::size_t frame = 0; frame < views.size(); ++frame) {
            for (std::size_t i = 0; i < walkers.size(); ++i) {
                double started, ran;
                step(walkers[i], scene, views[frame], started, ran);
                samples[i][frame].started.push_back(started);
                samples[i][frame].ran.push_back(ran);
                if (pass + 1 < passes) continue;
                if (frame >= begin) {
                    WalkCost& cost = costs[i];
                    cost.drawn += walkers[i].run->counters().rendered_count;
                    if (const VisibleRun<3>* const run = walkers[i].visible_run()) {
                        const Effort& effort = run->effort();
                        cost.boxes += static_cast<double>(effort.boxes);
                        cost.kept += static_cast<double>(effort.kept);
                        cost.tested += static_cast<double>(effort.tested);
                        cost.products += static_cast<double>(effort.products);
                        cost.changed += static_cast<double>(effort.changed);
                        const auto shadows = run->states().shadows();
                        cost.occluders +=
                            static_cast<double>(std::count_if(shadows.begin(), shadows.end(), [](const auto& shadow) {
                                return !shadow.polygons.empty();
                            }));
                    }
                }
            }
            if (look && pass + 1 == passes)
                for (std::size_t i = 0; i < walkers.size(); ++i) look(i, frame);
        }
    }
    const auto count = static_cast<double>(views.size() - begin);
    for (std::size_t i = 0; i < walkers.size(); ++i) {
        WalkCost& cost = costs[i];
        cost.frames = views.size() - begin;
        for (std::size_t frame = begin; frame < views.size(); ++frame) {
            cost.occluders_ms += median(samples[i][frame].started);
            cost.visible_ms += median(samples[i][frame].ran);
        }
        for (double* const sum : {&cost.occluders_ms, &cost.visible_ms, &cost.occluders, &cost.boxes, &cost.kept,
                                  &cost.tested, &cost.products, &cost.changed, &cost.drawn})
            *sum /= count;
    }
    return costs;
}

/// Pixels of the six faces of a cube round the eye, per primitive.
std::vector<std::uint32_t> pixels_all_round(const Scene<3>& scene, const Vec<3>& eye, const DrawIds& draw_ids,
                                            const ImageSize& face) {
    std::vector<std::uint32_t> pixels(scene.primitives.size());
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            ViewSpec<3> spec{eye, eye, 90};
            spec.look_at[axis] += sign;
            const std::vector<IdImage> images = draw_ids(scene, make_view(spec, 1, scene.up_axis), face, 1);
            for (const std::uint32_t id : images.front().ids)
                if (id != none) ++pixels[id];
        }
    return pixels;
}

Culled culled_by(const VisibleRun<3>& run, const Polygons<3>& polygons, const std::vector<std::uint32_t>& pixels) {
    const Problem<3>& problem = run.problem();
    const BoxTree<3>& tree = *run.boxes();
    const std::vector<std::uint8_t> drawn = rendered_mask(run.met(), pixels.size());
    std::vector<std::uint8_t> in_drawn_box(pixels.size());
    for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
        if (run.mark({node, Kind::node}).state != CellState::projected) continue;
        const auto rule = static_cast<VisibleRule>(run.mark({node, Kind::node}).stamp);
        if (rule != VisibleRule::leaf && rule != VisibleRule::gathered) continue;
        for (const std::uint32_t primitive : tree.primitives_of(node)) in_drawn_box[primitive] = 1;
    }
    struct OfPolygon {
        bool seen = false, drawn = false, boxed = false, faces = false;
    };
    std::vector<OfPolygon> all(polygons.size());
    Culled found;
    for (std::uint32_t i = 0; i < pixels.size(); ++i) {
        OfPolygon& polygon = all[polygons.polygon_of[i]];
        const bool seen = pixels[i] > 0;
        polygon.seen |= seen;
        polygon.drawn |= drawn[i] != 0;
        polygon.boxed |= in_drawn_box[i] != 0;
        polygon.faces |= turns_a_seen_side(problem, i);
        found.invisible_primitives += !seen;
        found.culled_primitives += !seen && (!in_drawn_box[i] || (!drawn[i] && turns_a_seen_side(problem, i)));
        found.missed += seen && !drawn[i];
        found.missed_pixels += seen && !drawn[i] ? pixels[i] : 0;
    }
    for (const OfPolygon& polygon : all) {
        if (polygon.seen) continue;
        ++found.invisible;
        // What turns its front to an eye that looks all round and is not drawn was hidden by occluders.
        found.culled += !polygon.boxed || (polygon.faces && !polygon.drawn);
        found.not_drawn += !polygon.drawn;
        found.facing += polygon.faces;
        found.culled_facing += polygon.faces && !polygon.drawn;
    }
    return found;
}

}  // namespace

void Culled::operator+=(const Culled& other) {
    invisible += other.invisible;
    culled += other.culled;
    not_drawn += other.not_drawn;
    facing += other.facing;
    culled_facing += other.culled_facing;
    invisible_primitives += other.invisible_primitives;
    culled_primitives += other.culled_primitives;
    missed += other.missed;
    missed_pixels += other.missed_pixels;
}

double Culled::share_of(std::size_t part, std::size_t all) {
    return all == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(part) / static_cast<double>(all);
}

Construction measure_construction(const SeededScene& scene, const std::string& tree,
                                  const ObjectSpaceOptions& options) {
    Construction made{.tree = tree};
    const View<3> first = all_round(find_path(*scene.scene, options.walk).frames.front());
    std::vector<double> polygons, tree_ms, regions, frame;
    for (int i = 0; i < std::max(1, options.repeats); ++i) {
        Walker walker(options.tables, "coorg-teller tree=" + tree);
        const std::shared_ptr<const Prepared<3>> all = prepared(walker.problem(scene, first));
        double started, ran;
        step(walker, scene, first, started, ran);
        made.primitives = scene.scene->primitives.size();
        made.polygons = all->polygons.size();
        made.references = all->polygon_references();
        made.boxes = all->tree.boxes.nodes.size();
        polygons.push_back(all->milliseconds_polygons);
        tree_ms.push_back(all->milliseconds_tree);
        regions.push_back(all->milliseconds_regions);
        frame.push_back(started + ran);
    }
    made.polygons_ms = median(polygons);
    made.tree_ms = median(tree_ms);
    made.regions_ms = median(regions);
    made.first_frame_ms = median(frame);
    return made;
}

std::vector<AllRound> measure_all_round(const SeededScene& scene, const std::vector<std::string>& methods,
                                        const DrawIds& draw_ids, const ObjectSpaceOptions& options) {
    const std::vector<View<3>> views = all_round_views(scene, options.walk);
    std::vector<Walker> walkers;
    std::vector<AllRound> rows;
    for (const std::string& text : methods) {
        walkers.emplace_back(options.tables, text);
        rows.push_back({walkers.back().variant.text, {}, {}});
    }
    std::vector<std::uint8_t> is_exact(views.size());
    for (const std::size_t frame : frames_of(views.size(), options)) is_exact[frame] = 1;
    std::vector<std::uint32_t> pixels;
    const std::vector<WalkCost> costs =
        walk(walkers, scene, views, std::max(1, options.repeats), [&](std::size_t i, std::size_t frame) {
            if (!is_exact[frame]) return;
            if (i == 0) pixels = pixels_all_round(*scene.scene, views[frame].eye, draw_ids, options.face);
            const VisibleRun<3>* const run = walkers[i].visible_run();
            if (!run) throw InputError("'" + rows[i].method + "' does not cull in object space");
            rows[i].culled += culled_by(*run, prepared(run->problem())->polygons, pixels);
        });
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].cost = costs[i];
    return rows;
}

std::vector<AtSpeed> measure_speeds(const SeededScene& scene, const std::string& method,
                                    const ObjectSpaceOptions& options) {
    const std::vector<View<3>> views = all_round_views(scene, options.line);
    std::vector<Walker> walkers;
    for (const char* const coherence : {" coherence=on", " coherence=off"})
        walkers.emplace_back(options.tables, method + coherence);
    std::vector<AtSpeed> rows;
    for (const std::uint32_t speed : options.speeds) {
        std::vector<View<3>> taken;
        for (std::size_t i = 0; i < views.size(); i += speed) taken.push_back(views[i]);
        const auto costs = walk(walkers, scene, taken, std::max(1, options.repeats));
        rows.push_back({speed, costs[0], costs[1]});
    }
    return rows;
}

std::vector<WithWorkers> measure_workers(const SeededScene& scene, const ObjectSpaceOptions& options) {
    std::vector<View<3>> views = all_round_views(scene, options.walk);
    std::vector<View<3>> taken;
    for (const std::size_t frame : frames_of(views.size(), options)) taken.push_back(views[frame]);
    std::vector<Walker> walkers;
    for (const int workers : options.workers)
        walkers.emplace_back(options.tables, options.parallel + " workers=" + std::to_string(workers));
    const auto costs = walk(walkers, scene, taken, std::max(1, options.repeats));
    std::vector<WithWorkers> rows;
    for (std::size_t i = 0; i < costs.size(); ++i) rows.push_back({options.workers[i], costs[i]});
    return rows;
}

std::vector<InView> measure_in_view(const SeededScene& scene, const std::vector<std::string>& methods,
                                    const TimeDrawing& time_drawing, const ObjectSpaceOptions& options) {
    const FlightPath<3> path = find_path(*scene.scene, options.walk);
    std::vector<View<3>> views, round;
    for (const ViewSpec<3>& spec : path.frames) {
        views.push_back(scene_view(spec, *scene.scene, options.image));
        round.push_back(all_round(spec));
    }
    std::vector<std::uint8_t> is_drawn(views.size());
    std::size_t drawn_frames = 0;
    for (const std::size_t frame : frames_of(views.size(), options)) {
        is_drawn[frame] = 1;
        ++drawn_frames;
    }
    std::vector<Walker> walkers;
    for (const std::string& text : methods) walkers.emplace_back(options.tables, text);
    std::vector<InView> rows(methods.size());
    std::vector<std::vector<std::uint32_t>> drawn(methods.size());
    // All methods' lists of a frame after one another, once to warm up.
    const auto draw = [&](std::size_t i, std::size_t frame) {
        if (!time_drawing || !is_drawn[frame]) return;
        drawn[i] = rendered_ids(walkers[i].run->met());
        if (i + 1 < methods.size()) return;
        std::vector<std::vector<double>> times(methods.size());
        for (int repeat = 0; repeat <= std::max(1, options.repeats); ++repeat)
            for (std::size_t m = 0; m < methods.size(); ++m) {
                const DrawTimes t = time_drawing(scene.scene, views[frame], drawn[m]);
                if (repeat > 0) times[m].push_back(t.upload + t.draw);
            }
        for (std::size_t m = 0; m < methods.size(); ++m)
            rows[m].draw_ms += median(times[m]) / static_cast<double>(drawn_frames);
    };
    const auto costs = walk(walkers, scene, views, std::max(1, options.repeats), draw);
    const auto unswitched = walk(walkers, scene, round, std::max(1, options.repeats));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].method = walkers[i].variant.text;
        rows[i].cost = costs[i];
        rows[i].all_round = unswitched[i];
    }
    return rows;
}

}  // namespace sightline::lab
