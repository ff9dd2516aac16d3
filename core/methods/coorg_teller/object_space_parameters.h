// The parameters of methods that cull in object space.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/parameters.h"
#include "core/space/reference_tree.h"

namespace sightline {

/// Which occluders may hide a box together. off: none; on: those that meet at edges, all of them at once, as printed;
/// grow: one after the other across the planes that the box crosses; fused: 2D, any, by their shadows' angles.
enum class Connected : std::uint8_t { off, on, grow, fused };
template <>
inline constexpr auto words<Connected> = std::to_array<std::string_view>({"off", "on", "grow", "fused"});

template <>
inline constexpr auto words<TreeKind> = std::to_array<std::string_view>({"kd", "octree"});

/// What is drawn of a leaf that is PARTIAL: all of it, as printed, or its polygons that are not INVISIBLE themselves.
enum class Leaves : std::uint8_t { whole, polygons };
template <>
inline constexpr auto words<Leaves> = std::to_array<std::string_view>({"whole", "polygons"});

/// Whether what was found out for one eye is kept for the next.
enum class Coherence : std::uint8_t { off, on };
template <>
inline constexpr auto words<Coherence> = std::to_array<std::string_view>({"off", "on"});

/// What a step is: a box, or all boxes up to the next one whose state is another than in the frame before.
enum class StepIs : std::uint8_t { node, change };
template <>
inline constexpr auto words<StepIs> = std::to_array<std::string_view>({"node", "change"});

const ParameterRow& connected_row();
const ParameterRow& occluder_count_row();
const ParameterRow& shadow_count_row();
const ParameterRow& threshold_row();
const ParameterRow& tree_row();
const ParameterRow& leaf_row();
const ParameterRow& leaves_row();
const ParameterRow& coherence_row();
const ParameterRow& step_is_row();
const ParameterRow& workers_row();

}  // namespace sightline
