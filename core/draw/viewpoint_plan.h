// A choice by viewpoint in three dimensions, as a plan: what is chosen at the height of the eye, seen from above.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/draw/draw_list.h"
#include "core/session/session.h"

namespace sightline {

/// A small picture and its words.
struct ViewpointPlan {
    DrawList list;  ///< without labels; its world is the space that regions divide
    std::string title;
    double aspect() const { return list.world.extent().x / list.world.extent().y; }
};

/// Regions at the height of the culling eye by technique, with what the scene has there as lines: all triangles are
/// cut. Where they have nothing at that height, they are cut near the ground. Nothing: shown_viewpoint says so.
std::optional<ViewpointPlan> viewpoint_plan(const Session<3>& session);

}  // namespace sightline
