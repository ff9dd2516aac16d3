// What a run draws where levels of detail stand in for objects: primitives of the scene and of levels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/run/run.h"

namespace sightline {

/// What drawn_ids() are numbers of: the scene itself (shared with `scene`), or scene_with_levels() for runs that have
/// levels.
template <int D>
std::shared_ptr<const Scene<D>> drawn_scene(const Run<D>& run, const std::shared_ptr<const Scene<D>>& scene) {
    if (!run.levels()) return scene;
    return scene_with_levels(*run.problem().cells, *run.problem().scene);
}

/// The primitives of levels that stand in, as numbers of drawn_scene(): behind those of the scene.
template <int D>
void append_stand_ins(const Run<D>& run, std::vector<std::uint32_t>& ids) {
    const auto stand_ins = run.stand_ins();
    if (stand_ins.empty()) return;
    const std::shared_ptr<const Levels<D>> levels = run.levels();
    const auto behind = static_cast<std::uint32_t>(run.problem().primitives().size());
    for (const StandIn& stand_in : stand_ins) {
        const Level& level = levels->at(stand_in.object, stand_in.level);
        for (std::uint32_t i = level.begin; i < level.end; ++i) ids.push_back(behind + i);
    }
}

/// All that is drawn so far, as numbers of drawn_scene(): rendered_ids(), then what stands in.
template <int D>
void drawn_ids(const Run<D>& run, std::vector<std::uint32_t>& ids) {
    rendered_ids(run.met(), ids);
    append_stand_ins(run, ids);
}

/// Calls `each(primitive)` for the primitives of objects that levels stand in for: they are not rendered, but seen in
/// another shape.
template <int D, typename Each>
void for_stood_in(const Run<D>& run, Each each) {
    const auto stand_ins = run.stand_ins();
    if (stand_ins.empty()) return;
    const std::shared_ptr<const Levels<D>> levels = run.levels();
    for (const StandIn& stand_in : stand_ins)
        for (const std::uint32_t primitive : levels->primitives_of(stand_in.object)) each(primitive);
}

/// Per primitive of the scene, 1 where it is rendered, or its object drawn at a level.
template <int D>
std::vector<std::uint8_t> found_mask(const Run<D>& run) {
    std::vector<std::uint8_t> mask = rendered_mask(run.met(), run.problem().primitives().size());
    for_stood_in(run, [&](std::uint32_t primitive) { mask[primitive] = 1; });
    return mask;
}

}  // namespace sightline
