// What a 2D picture of a method that decides by planes shows: boxes by state, occluders, and figure 4a of one box.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/box_palette.h"
#include "core/session/session.h"

namespace sightline {

/// Adds its styles to a list, then what it is asked for. Session and list must live longer.
class PlanePainter {
public:
    PlanePainter(const Session<2>& session, DrawList& list);

    /// Boxes by their state, and the leaf that holds the eye.
    void boxes();
    /// Thick, for the primitives to be drawn over.
    void occluders();
    /// Between the box and the occluder at hand: lines through the whole picture, the regions of eyes that they part,
    /// with their numbers; from where the selected occluder is one.
    void planes();
    /// Of the box that was tested last and of the selected one.
    void outlines();

private:
    std::uint16_t index(BoxLook look) const;
    void polygon(std::span<const Vec<2>> points, BoxLook look);
    void box(const Box<2>& box, BoxLook look);
    void number(const std::vector<Vec<2>>& where, const char* text);

    const Session<2>& session_;
    DrawList& list_;
    std::size_t first_;
};

}  // namespace sightline
