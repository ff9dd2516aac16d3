// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduce/reduce.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/formula.h"
#include "core/session/condition.h"
#include "core/session/session.h"
#include "lab/reduce/probe.h"

namespace sightline::lab {

std::vector<std::uint32_t> reduce(std::uint32_t count, const Holds& holds, const ReduceWatch& watch) {
    std::vector<std::uint32_t> kept(count);
    std::iota(kept.begin(), kept.end(), 0u);
    std::size_t parts = 2, probes = 0;
    bool go_on = true;
    const auto probe = [&](std::span<const std::uint32_t> set) {
        const bool found = holds(set);
        ++probes;
        // If nothing more can be taken: the rest of this round, and rounds of twice as many parts down to single ones.
        const std::size_t left = found ? set.size() : kept.size();
        std::size_t most = 0;
        for (std::size_t round = std::min(parts, left); left >= 2; round = std::min(2 * round, left)) {
            most += round;
            if (round == left) break;
        }
        if (watch) go_on = watch({left, probes, most});
        return found;
    };
    if (!probe(kept)) throw InputError("reduce: the condition does not hold in the whole scene");
    std::vector<std::uint32_t> rest;
    while (kept.size() >= 2 && go_on) {
        parts = std::min(parts, kept.size());
        bool smaller = false;
        for (std::size_t part = 0; part < parts && !smaller && go_on; ++part) {
            const std::size_t begin = kept.size() * part / parts, end = kept.size() * (part + 1) / parts;
            rest.assign(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(begin));
            rest.insert(rest.end(), kept.begin() + static_cast<std::ptrdiff_t>(end), kept.end());
            smaller = probe(rest);
        }
        if (smaller) {
            kept = rest;
            parts = std::max<std::size_t>(parts - 1, 2);
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
    part.rooms = {};  // what closes them may be gone
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
    std::vector<Measure> used;
    for (const std::size_t index : formula.used()) used.push_back(measure_table()[index].measure);
    const auto measures = std::make_shared<PartMeasures<D>>(lab, method, budget, std::move(used), draw_ids);
    return [=, scene = lab.scene](std::span<const std::uint32_t> kept) {
        const bool holds = formula.holds(measures->measure(kept, subset(*scene, kept)).all);
        if (holds) measures->take();
        return holds;
    };
}

#define SIGHTLINE_INSTANTIATE(D)                                                  \
    template Scene<D> subset<D>(const Scene<D>&, std::span<const std::uint32_t>); \
    template Holds holds_in<D>(const LabScene<D>&, const MethodChoice&, const Budget&, const Wanted&, const DrawIds&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
