// A session in three dimensions as a picture: solids, and over them everything that stays sharp at any size. Nothing
// here moves a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/draw/draw_list.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/solid_list.h"
#include "core/session/comparison.h"
#include "core/session/session.h"

namespace sightline {

struct PictureOptions3 {
    /// What the lowest and the highest colour of the heat map stand for (number_range; panels of one figure share it).
    std::optional<std::array<double, 2>> heat_range{};
    /// Width / height of the picture; 0: that of the reference, which is the culling view's.
    double aspect = 0;
    /// Per cell, for two sessions beside each other (cell_differences): marked over the picture. Empty: none.
    std::span<const Differs> differences{};
    /// A facet to point out, by its place among those of the last cell: where a substep looks across.
    std::optional<std::uint32_t> facet{};
    /// Where a class has to find the number of this cell: its label is a question mark.
    std::optional<std::uint32_t> concealed{};
    bool choice = true;  ///< as PictureOptions::choice
};

/// The display view at this aspect (PictureOptions3::aspect).
View<3> picture_camera(const Session<3>& session, double aspect = 0);

/// The triangles and the cells that the session's picture settings ask for. Cells are drawn while the picture is seen
/// from outside (shown_cells.h); in a heat map those without a number only where they are wire. Asks for the reference
/// where it tells visible from hidden triangles (show_visibility, from outside or with triangles = visible or all), and
/// for what a heat map of share or zeta needs.
SolidList make_solid(const Session<3>& session, const PictureOptions3& options = {});

/// The cells that make_solid draws as wire, by number.
std::vector<std::uint32_t> wire_cells(const Session<3>& session);

/// Of a method that walks boxes, those that make_solid draws from outside.
std::vector<ShownBox<3>> drawn_boxes(const Session<3>& session);

/// What lies over them, in the plane of the picture (picture_plane): frustum and eye of the culling view while seen
/// from outside, else the border of its image where the picture has another shape; the last and the selected cell,
/// rays, the chain of updates, notes, numbers on cells. Notes in the picture have the first labels, in their order.
DrawList make_picture(const Session<3>& session, const PictureOptions3& options = {});

}  // namespace sightline
