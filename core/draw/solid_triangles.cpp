// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/solid_triangles.h"

#include <array>
#include <utility>

#include "core/draw/box_palette.h"
#include "core/draw/palette.h"
#include "core/draw/shown_cells.h"
#include "core/draw/shown_planes.h"
#include "core/draw/solid_palette.h"
#include "core/run/drawn_levels.h"

namespace sightline {

namespace {

/// The levels that stand in for objects; the one of the last step apart.
template <typename ByLook>
void add_levels(const Session<3>& session, bool recorded, ByLook& by_look) {
    const Run<3>& run = session.traversal();
    const auto stand_ins = run.stand_ins();
    if (stand_ins.empty()) return;
    const std::shared_ptr<const Levels<3>> levels = run.levels();
    const auto behind = static_cast<std::uint32_t>(session.scene().primitives.size());
    const std::uint32_t last =
        recorded ? id_of(session.timeline().steps[session.position() - 1].item, Kind::object) : none;
    for (const StandIn& stand_in : stand_ins) {
        const SolidLook look =
            stand_in.object == last ? SolidLook::fresh : level_look(SolidLook::level_1, stand_in.level);
        const Level& level = levels->at(stand_in.object, stand_in.level);
        auto& triangles = by_look[static_cast<std::size_t>(look)];
        for (std::uint32_t i = level.begin; i < level.end; ++i) triangles.push_back(behind + i);
    }
}

}  // namespace

void add_triangles(const Session<3>& session, bool tell_visible, SolidList& list) {
    const Triangles wanted = session.settings().triangles;
    if (wanted == Triangles::off) return;
    const std::span<const Met> met = session.met();
    const bool adds_missed = wanted == Triangles::missed && session.settings().show_visibility == Switch::on &&
                             !session.flying() && (session.frozen() || session.finished());
    const bool needs_reference = tell_visible || adds_missed || wanted == Triangles::visible;
    const std::uint8_t* visible = needs_reference ? session.reference().visible.data() : nullptr;
    // Flying leaves no record of steps.
    const bool recorded = session.position() > 0 && session.position() <= session.recorded();
    const std::uint32_t before_last =
        recorded ? session.timeline().before(session.position()).touched_count : session.counters().touched_count;

    const std::uint32_t before_completing = session.traversal().met_before_completing();

    // Of the looks, then those of occluders, which are what they are whether they are drawn or not.
    constexpr auto looks = static_cast<std::size_t>(SolidLook::count);
    std::array<std::vector<std::uint32_t>, looks + static_cast<std::size_t>(SolidBoxLook::count)> by_look;
    std::vector<std::uint8_t> is_occluder;
    const std::vector<OccluderFact> occluders =
        seen_from_outside(session) ? marked_occluders(session) : std::vector<OccluderFact>{};
    if (!occluders.empty()) {
        is_occluder.resize(session.scene().primitives.size());
        for (const OccluderFact& occluder : occluders)
            for (const std::uint32_t triangle : occluder.primitives) {
                if (std::exchange(is_occluder[triangle], 1)) continue;
                // From behind it hides nothing, and would hide the picture: a ceiling seen from above.
                if (!shows_both_sides(session.scene(), triangle) &&
                    !faces(list.camera, session.scene().primitives[triangle]))
                    continue;
                const SolidBoxLook look = occluder.actual ? SolidBoxLook::actual : SolidBoxLook::potential;
                by_look[looks + static_cast<std::size_t>(look)].push_back(triangle);
            }
    }
    const auto add = [&](std::uint32_t triangle, SolidLook look) {
        if (is_occluder.empty() || !is_occluder[triangle]) by_look[static_cast<std::size_t>(look)].push_back(triangle);
    };
    std::vector<std::uint8_t> is_rendered;
    if (adds_missed || wanted > Triangles::missed) is_rendered.resize(session.scene().primitives.size());
    for (std::uint32_t i = 0; i < met.size(); ++i) {
        if (met[i].culled()) continue;
        const std::uint32_t triangle = met[i].primitive();
        if (!is_rendered.empty()) is_rendered[triangle] = 1;
        if (wanted == Triangles::visible && !visible[triangle]) continue;
        SolidLook look = SolidLook::plain;
        if (tell_visible) look = visible[triangle] ? SolidLook::rendered : SolidLook::wasted;
        if (i >= before_completing && look != SolidLook::wasted) look = SolidLook::added;
        add(triangle, i < before_last ? look : SolidLook::fresh);
    }
    if (!is_rendered.empty())
        for_stood_in(session.traversal(), [&](std::uint32_t triangle) { is_rendered[triangle] = 1; });
    add_levels(session, recorded, by_look);
    for (std::uint32_t triangle = 0; triangle < is_rendered.size(); ++triangle) {
        if (is_rendered[triangle] || (wanted != Triangles::all && !visible[triangle])) continue;
        SolidLook look = SolidLook::rest;
        if (tell_visible || adds_missed) look = visible[triangle] ? SolidLook::missed : SolidLook::other;
        add(triangle, look);
    }
    for (std::size_t look = 0; look < by_look.size(); ++look) {
        const auto& triangles = by_look[look];
        if (triangles.empty()) continue;
        list.runs.push_back({static_cast<std::uint8_t>(look), static_cast<std::uint32_t>(list.triangles.size()),
                             static_cast<std::uint32_t>(triangles.size())});
        list.triangles.insert(list.triangles.end(), triangles.begin(), triangles.end());
    }
}

}  // namespace sightline
