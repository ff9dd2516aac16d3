// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduce/reduce.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/formula.h"
#include "core/session/condition.h"
#include "core/space/builders.h"

namespace sightline::lab {

std::vector<std::uint32_t> reduce(std::uint32_t count, const Holds& holds,
                                  const std::function<bool(std::size_t left)>& progress) {
    std::vector<std::uint32_t> kept(count);
    std::iota(kept.begin(), kept.end(), 0u);
    if (!holds(kept)) throw InputError("reduce: the condition does not hold in the whole scene");
    std::size_t parts = 2;
    std::vector<std::uint32_t> rest;
    while (kept.size() >= 2) {
        parts = std::min(parts, kept.size());
        bool smaller = false;
        for (std::size_t part = 0; part < parts && !smaller; ++part) {
            const std::size_t begin = kept.size() * part / parts, end = kept.size() * (part + 1) / parts;
            rest.assign(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(begin));
            rest.insert(rest.end(), kept.begin() + static_cast<std::ptrdiff_t>(end), kept.end());
            smaller = holds(rest);
        }
        if (smaller) {
            kept = rest;
            parts = std::max<std::size_t>(parts - 1, 2);
            if (progress && !progress(kept.size())) return kept;
        } else if (parts == kept.size()) {
            break;
        } else {
            parts *= 2;
        }
    }
    return kept;
}

template <int D>
Scene<D> subset(const Scene<D>& scene, std::span<const std::uint32_t> kept) {
    Scene<D> part = scene;
    resize_primitives(part, kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        part.primitives[i] = scene.primitives[kept[i]];
        copy_facts(scene, kept[i], part, i);
    }
    tidy(part.objects);
    part.source = "edited";
    return part;
}

template <int D>
Holds holds_in(const LabScene<D>& lab, const MethodChoice& method, const Budget& budget, const Wanted& wanted,
               const DrawIds& draw_ids) {
    if (wanted.condition.empty() == wanted.measures.empty())
        throw InputError("reduce: give either --until, a condition on a step, or --holds, a condition on measures");
    Settings settings = lab.settings_for(method);
    settings.budget = budget;
    if (!wanted.condition.empty()) {
        return [=, scene = lab.scene, view = lab.specs.back(),
                methods = lab.tables.template of<D>()](std::span<const std::uint32_t> kept) {
            Session<D> session(std::make_shared<const Scene<D>>(subset(*scene, kept)), view, settings, methods,
                               draw_ids);
            return run_until(session, condition_for(session, wanted.condition)) == Stop::breakpoint;
        };
    }
    std::vector<std::string_view> names;
    for (const MeasureRow& row : measure_table()) names.emplace_back(row.id);
    const Formula formula(wanted.measures, names, "condition");
    for (const std::size_t used : formula.used())
        if (measure_table()[used].is_time)
            throw InputError("reduce: " + std::string(measure_table()[used].id) + " differs from run to run");
    return [=](std::span<const std::uint32_t> kept) {
        LabScene<D> part = lab;
        part.scene = std::make_shared<const Scene<D>>(subset(*lab.scene, kept));
        const std::size_t first = lab.views.size() > 1 ? lab.views.size() - 2 : 0;
        part.views.erase(part.views.begin(), part.views.begin() + static_cast<std::ptrdiff_t>(first));
        part.specs.erase(part.specs.begin(), part.specs.begin() + static_cast<std::ptrdiff_t>(first));
        part.frames.erase(part.frames.begin(), part.frames.begin() + static_cast<std::ptrdiff_t>(first));
        part.cells = {};
        part.cells[static_cast<std::size_t>(method.tessellation)] = build_cells(*part.scene, settings);
        Study study;
        study.methods = {method};
        study.budgets = {budget};
        study.repeats = 0;
        Instruments instruments;
        instruments.draw_ids = draw_ids;
        const std::vector<Row> rows = measure_path<D>(part, study, instruments);
        return !rows.empty() && formula.holds(rows.front().values.back().all);
    };
}

#define SIGHTLINE_INSTANTIATE(D)                                                  \
    template Scene<D> subset<D>(const Scene<D>&, std::span<const std::uint32_t>); \
    template Holds holds_in<D>(const LabScene<D>&, const MethodChoice&, const Budget&, const Wanted&, const DrawIds&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
