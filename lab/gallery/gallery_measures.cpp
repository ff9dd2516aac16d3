// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/gallery/gallery_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/measure/frame_numbers.h"
#include "core/measure/wrong_region.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/scene/scene_view.h"
#include "core/session/condition.h"
#include "core/session/settings_table.h"
#include "core/space/cell_complex.h"
#include "core/truth/software_ids.h"
#include "lab/gallery/gallery_functions.h"

namespace sightline::lab {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

double ratio(double part, double whole) { return whole > 0 ? part / whole : no_value; }

template <int D>
Services services(const Probe<D>& p, const View<D>& view) {
    return exact_services(p.at.scene(), view, p.settings.reference_size,
                          drawing_of(p.settings.reference, p.at.draw_ids()));
}

template <int D>
MethodProblem<D> problem(const Probe<D>& p) {
    const View<D> view = p.at.view(p.view, p.settings);
    return problem_of(p.methods, p.at.scene(), p.at.cells(p.settings), view, p.settings, services(p, view));
}

template <int D>
Values values(const Probe<D>& p) {
    const Truth truth = p.at.truth(p.view, p.settings);
    auto [method, asked] = problem(p);
    const auto all = static_cast<std::uint32_t>(p.at.scene().primitives.size());
    const std::uint32_t k = asked.budget = std::min(all, asked.budget);
    const WholeRun run = whole_run<D>(method, asked, truth.reference, true);
    const auto rendered = rendered_by(run, cut_at(run, k).met, all);
    const auto best = method.orders_cells() ? cell_oracle<D>(truth.reference, asked) : std::nullopt;
    return frame_numbers(run, truth, k, rendered, wrong_by(run, truth.reference.image, rendered), best);
}

template <int D>
Probe<D> with(const Probe<D>& p, std::initializer_list<const char*> assignments) {
    Probe<D> other = p;
    for (const char* assignment : assignments) apply_setting(other.settings, assignment);
    return other;
}

template <int D>
double missed(const Probe<D>& p) {
    const Values v = values(p);
    return v[Measure::visible] > 0 ? v[Measure::visible] - std::round(v[Measure::coverage] * v[Measure::visible]) : 0;
}

template <int D>
double detour(const Probe<D>& p) {
    const Values v = values(p);
    if (std::isnan(v[Measure::k95]))
        return v[Measure::visible] > 0 ? std::numeric_limits<double>::infinity() : no_value;
    return v[Measure::k95] * static_cast<double>(p.at.scene().primitives.size()) / v[Measure::visible];
}

template <int D>
double of_oracle(const Probe<D>& p) {
    const Values v = values(p);
    return v[Measure::coverage] / v[Measure::oracle];
}

/// Of the cells that the method projects without a budget.
template <int D>
double coverage_before_hidden(const Probe<D>& p) {
    Probe<D> all = with(p, {"budget=unlimited"});
    const Reference reference = p.at.truth(p.view, p.settings).reference;
    const auto [method, asked] = problem(all);
    const std::unique_ptr<Run<D>> run = method.start(asked);
    Recording recording;
    Recorder recorder(recording);
    while (run->run(1, &recorder) == Stop::steps) {
        const std::uint32_t cell = id_of(recording.steps.back().item, Kind::cell);
        if (cell == none || reference.cell_share[cell] > 0 || asked.cells->count(cell) == 0) continue;
        return coverage(reference,
                        visible_rendered(reference, run->met().first(recording.before(recording.size()).touched_count)))
            .value_or(no_value);
    }
    return 1;
}

template <int D>
double ahead_of_centroid(const Probe<D>& p) {
    return values(p)[Measure::coverage] - values(with(p, {"method=centroid"}))[Measure::coverage];
}

/// Coverage of what is within a metre of the point that the view looks at.
template <int D>
double coverage_at_look(const Probe<D>& p) {
    const Reference reference = p.at.truth(p.view, p.settings).reference;
    const OneRun run = ran(p);
    double visible = 0, found = 0;
    for (std::size_t i = 0; i < run.rendered.size(); ++i) {
        const Vec<D> d = p.at.scene().primitives[i][0] - p.view.look_at;
        double flat = 0;  // 3D: over the ground
        for (int axis = 0; axis < 2; ++axis) flat += d[axis] * d[axis];
        if (!reference.visible[i] || flat > 1) continue;
        ++visible;
        found += run.rendered[i];
    }
    return ratio(found, visible);
}

template <int D>
double shown_count(const Probe<D>& p) {
    const Problem<D> asked = problem(p).problem;
    double count = 0;
    for (std::uint32_t i = 0; i < asked.primitives().size(); ++i) count += shows(asked, i);
    return count;
}

template <int D>
double visible_in_view(const Probe<D>& p) {
    return ratio(static_cast<double>(p.at.truth(p.view, p.settings).reference.count), shown_count(p));
}

/// Of the hidden primitives in the view.
template <int D>
double culled(const Probe<D>& p) {
    const Reference reference = p.at.truth(p.view, p.settings).reference;
    const double shown = shown_count(p), visible = static_cast<double>(reference.count);
    const OneRun run = ran(with(p, {"budget=unlimited"}));
    double hidden = 0;
    for (std::size_t i = 0; i < run.rendered.size(); ++i) hidden += run.rendered[i] && !reference.visible[i];
    return ratio(shown - visible - hidden, shown - visible);
}

template <int D>
double off_budget(const Probe<D>& p) {
    const auto all = static_cast<std::uint32_t>(p.at.scene().primitives.size());
    const std::uint32_t reachable = static_cast<std::uint32_t>(ran(with(p, {"budget=unlimited"})).order.size());
    double worst = 0;
    for (const std::uint32_t k : {0u, 1u, 2u, 3u, 5u, 17u, all / 2, all - 1, all, all + 1}) {
        Probe<D> at = p;
        at.settings.budget = {Budget::Kind::primitives, static_cast<double>(k)};
        const OneRun run = ran(at);
        worst = std::max(worst, std::abs(static_cast<double>(run.order.size()) - std::min(k, reachable)));
    }
    return worst;
}

template <int D>
double rendered_twice(const Probe<D>& p) {
    OneRun run = ran(with(p, {"budget=unlimited"}));
    const auto met = static_cast<double>(run.order.size());
    std::sort(run.order.begin(), run.order.end());
    run.order.erase(std::unique(run.order.begin(), run.order.end()), run.order.end());
    return met - static_cast<double>(run.order.size());
}

template <int D>
double unassigned(const Probe<D>& p) {
    return p.at.cells(p.settings).unassigned;
}

template <int D>
double references(const Probe<D>& p) {
    return ratio(static_cast<double>(p.at.cells(p.settings).cell_primitives.size()),
                 static_cast<double>(p.at.scene().primitives.size()));
}

template <int D>
double most_cells(const Probe<D>& p) {
    std::vector<std::uint32_t> cells_of(p.at.scene().primitives.size());
    for (const std::uint32_t primitive : p.at.cells(p.settings).cell_primitives) ++cells_of[primitive];
    return cells_of.empty() ? 0 : *std::max_element(cells_of.begin(), cells_of.end());
}

template <int D>
double cell_count(const Probe<D>& p) {
    return p.at.cells(p.settings).cell_count();
}

/// Below a twentieth of the scale a cell passes for empty.
template <int D>
double nearly_empty(const Probe<D>& p) {
    const CellComplex<D>& cells = p.at.cells(p.settings);
    const double scale =
        p.settings.parameters.template choice<SolidityScale>(solidity_scale_row()) == SolidityScale::max
            ? cells.rho_max
            : cells.rho_p95;
    double held = 0, few = 0;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        held += cells.count(cell) > 0;
        few += cells.count(cell) > 0 && cells.count(cell) < 0.05 * scale;
    }
    return ratio(few, held);
}

double content(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Twice the area, or six times the volume, over the longest edge squared or cubed; simplices only.
template <int D>
double flattest(const Probe<D>& p) {
    const CellComplex<D>& cells = p.at.cells(p.settings);
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const auto corners = cells.corners_of(cell);
        double longest = 0, power = 1;
        for (const std::uint32_t a : corners)
            for (const std::uint32_t b : corners) {
                const Vec<D> d = cells.points[b] - cells.points[a];
                longest = std::max(longest, std::sqrt(glm::dot(d, d)));
            }
        for (int i = 0; i < D; ++i) power *= longest;
        const Vec<D>&a = cells.points[corners[0]], &b = cells.points[corners[1]], &c = cells.points[corners[2]];
        double size = 0;
        if constexpr (D == 2)
            size = content(a, b, c);
        else
            size = glm::dot(glm::cross(b - a, c - a), cells.points[corners[3]] - a);
        least = std::min(least, std::abs(size) / power);
    }
    return std::isfinite(least) ? least : no_value;
}

template <int D>
double dropped(const Probe<D>& p) {
    return static_cast<double>(p.at.scene().dropped.total());
}

template <int D>
double steps(const Probe<D>& p) {
    return ran(p).steps;
}

template <int D>
double rendered_count(const Probe<D>& p) {
    return static_cast<double>(ran(p).order.size());
}

/// 1 where a method by viewpoint does no more than its first technique, view culling unless another is asked for.
template <int D>
double does_no_more(const Probe<D>& p) {
    const auto [method, asked] = problem(p);
    const auto fact = method.start(asked)->viewpoint();
    return fact ? fact->done == 0 : no_value;
}

bool of_a_frame(const MeasureRow& row) {
    using M = Measure;
    return !row.is_time && row.measure != M::pop && row.measure != M::flip && row.measure != M::visible_change;
}

}  // namespace

template <int D>
OneRun ran(const Probe<D>& p, const ViewSpec<D>& spec) {
    const View<D> view = p.at.view(spec, p.settings);
    return one_run(p.methods, p.at.scene(), p.at.cells(p.settings), view, p.settings, services(p, view));
}
template OneRun ran<2>(const Probe<2>&, const ViewSpec<2>&);
template OneRun ran<3>(const Probe<3>&, const ViewSpec<3>&);

template <int D>
GalleryScene<D>::GalleryScene(std::shared_ptr<const Scene<D>> scene, DrawIds draw_ids, std::vector<CarPart> parts)
    : scene_(std::move(scene)), draw_ids_(std::move(draw_ids)), parts_(std::move(parts)) {}

template <int D>
const CellComplex<D>& GalleryScene<D>::cells(const Settings& settings) {
    for (const Built& built : built_)
        if (difference(built.settings, settings) < Invalidates::tessellation) return built.cells;
    built_.push_back({settings, build_cells(*scene_, settings)});
    return built_.back().cells;
}

template <int D>
View<D> GalleryScene<D>::view(const ViewSpec<D>& spec, const Settings& settings) const {
    return scene_view(spec, *scene_, settings.reference_size);
}

template <int D>
Truth GalleryScene<D>::truth(const ViewSpec<D>& spec, const Settings& settings) {
    const CellComplex<D>* of[] = {&cells(settings)};
    return make_truths<D>(*scene_, of, view(spec, settings), settings.reference_size,
                          drawing_of(settings.reference, draw_ids_))
        .front();
}

template <int D>
std::span<const GalleryMeasure<D>> gallery_measures() {
    static const GalleryMeasure<D> table[] = {
        {"missed", "primitives", "|V| - |V∩T_k|", missed},
        {"detour", "", "primitives rendered until ε reaches 0.95, over |V|; infinite when it never does", detour},
        {"of_oracle", "share", "ε over the best possible, min(1, k / |V|)", of_oracle},
        {"before_hidden", "share", "ε when the first hidden cell that holds something is projected; 1 when none is",
         coverage_before_hidden},
        {"ahead_of_centroid", "share", "ε minus that of centroid order at the same budget", ahead_of_centroid},
        {"coverage_at_look", "share", "ε of what lies within 1 m of the point looked at, over the ground",
         coverage_at_look},
        {"front_coverage", "share", "ε of the front halves of the shells of cars alone", front_coverage},
        {"back_coverage", "share", "ε of the back halves of the shells of cars alone", back_coverage},
        {"hidden_engine", "share", "primitives of engines in T_k that cannot be seen, over |T_k|", hidden_engine},
        {"visible_in_view", "share", "|V| over the primitives that the view can show", visible_in_view},
        {"culled", "share",
         "hidden primitives in the view that the method never renders, over all hidden ones in the view", culled},
        {"off_budget", "primitives",
         "largest | |T_k| - min(k, |T|) | for k = 0, 1, 2, 3, 5, 17, |S|/2, |S|-1, |S|, |S|+1", off_budget},
        {"rendered_twice", "primitives", "primitives rendered more than once in a run without a budget",
         rendered_twice},
        {"unassigned", "primitives", "those that lie in no cell: never rendered", unassigned},
        {"references", "", "pointers cell -> primitive, over |S|", references},
        {"most_cells", "cells", "the most cells that hold one primitive", most_cells},
        {"cells", "cells", "cells of the tessellation", cell_count},
        {"nearly_empty", "share", "cells with |A| below 5 % of the solidity scale, over all non-empty cells",
         nearly_empty},
        {"flattest", "", "least D! · content of a cell over its longest edge to the power D", flattest},
        {"dropped", "primitives", "what the loader left out", dropped},
        {"traversal_steps", "steps", "steps of the run", steps},
        {"rendered_count", "primitives", "|T_k|", rendered_count},
        {"does_no_more", "", "1 where the choice by viewpoint falls on its first technique, else 0", does_no_more},
        {"shift_overlap", "share", "least Jaccard(T_k, T_k') when the eye moves by 1e-12 of the scene's size",
         least_overlap_under_shifts},
        {"shift_steps", "steps", "fewest steps of a run among those shifts", fewest_steps_under_shifts},
        {"power_of_two", "share", "positions in the order that differ when scene and view are scaled by 2^20 or 2^-20",
         change_by_powers_of_two},
        {"scale_overlap", "share", "least Jaccard(T_k, T_k') when scene and view are scaled by 1e6 or 1e-6",
         overlap_scaled},
        {"move_overlap", "share", "Jaccard(T_k, T_k') when scene and view move by 1e6 as they are (3D: in floats)",
         overlap_moved},
        {"move_read_overlap", "share", "the same when the scene is read as a file: centred first",
         overlap_moved_and_read},
        {"seed_spread", "share", "standard deviation of ε over 8 seeds of the jitter", spread_over_seeds},
        {"bad_keys", "cells", "keys that are not finite while the view turns by 0.1° in 21 frames", bad_keys_in_sweep},
        {"sweep_jump", "share", "largest change of ε between neighbouring frames of that sweep", largest_jump_in_sweep},
        {"walk_pop", "share", "largest pop between neighbouring frames of a walk of 24", largest_pop},
        {"walk_visible", "share", "largest 1 - Jaccard(V, V') between neighbouring frames of that walk",
         largest_visible_change},
        {"lost_by_pixels", "share",
         "visible primitives that own no pixel, over |V|; V is exact in 2D, that of four times the size in 3D",
         lost_by_pixels},
        {"churn", "share", "1 - Jaccard(V, V') by pixels when the eye moves sideways by 0.3 pixels at look_at", churn},
        {"reverse_churn", "share", "1 - Jaccard(V, V') when the primitives come in reverse order", churn_in_reverse},
        {"reverse_wrong", "share", "pixels that then differ and show two primitives that do not lie at one distance",
         unexplained_in_reverse},
        {"ray_wrong", "share",
         "pixels, every 11th, that show another primitive than the ray through them meets first, at another distance",
         wrong_against_rays},
    };
    return table;
}

template <int D>
double measured(const Probe<D>& probe, std::string_view id) {
    for (const GalleryMeasure<D>& measure : gallery_measures<D>())
        if (measure.id == id) return measure.of(probe);
    for (const MeasureRow& row : measure_table())
        if (row.id == id && of_a_frame(row)) return values(probe)[row.measure];
    throw InputError("there is no measure '" + std::string(id) + "' of one scene and view");
}

#define SIGHTLINE_INSTANTIATE(D)                                       \
    template class GalleryScene<D>;                                    \
    template std::span<const GalleryMeasure<D>> gallery_measures<D>(); \
    template double measured<D>(const Probe<D>&, std::string_view);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
