// What a method that chooses by viewpoint would do where, as a map: regions and directions by technique (DAS figure 2).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/session/session.h"

namespace sightline {

/// What the session's picture shows of a choice by viewpoint; nothing: its method makes none, or show_regions is off.
template <int D>
std::optional<ViewpointFact<D>> shown_viewpoint(const Session<D>& session);

/// A style for each technique, in their order, named "technique NAME": the colour that its method has in every chart,
/// paler under a scene, with a hatch by its place, so that the first six stay apart in greyscale.
std::vector<Style> technique_styles(std::span<const TechniqueFact> techniques, Palette palette);

/// Of the outline of the region that holds the eye.
Style region_here_style(Palette palette);

/// The row of a legend for a style of this file; nothing: it is none that a legend names.
std::optional<LegendRow> region_row(const Style& style);

/// Styles of a map behind those of the techniques.
enum class MapLook : std::uint8_t { unknown, here, looked_into, scene, candidate, count };

/// Puts a map into a list, part by part: adds its styles, then what it is asked for. All three must live longer.
template <int D>
class RegionPainter {
public:
    RegionPainter(const ViewpointFact<D>& fact, const Scene<D>& scene, Palette palette, DrawList& list);

    /// Where a point of the scene stands in the plan, which is seen from above. 2D: where it is.
    Vec<2> in_plan(const Vec<D>& point) const;
    /// All regions by technique, those not worked out blank. 3D: those that reach this height.
    void regions(double height = 0);
    /// The region of the eye, outlined.
    void outline();
    /// About the eye, a ring of the directions by technique, with the ones looked into outlined. 3D: of the elevations
    /// looked into; round as a whole where that is a cap. `radius`: of its outer border.
    void rose(const Vec<D>& eye, double radius);
    /// A line of the picture as potential occluders have it.
    void candidate(const Vec<2>& a, const Vec<2>& b);
    /// A line of a plan where a level plane cuts the scene.
    void wall(const Vec<2>& a, const Vec<2>& b);

private:
    std::uint16_t of(std::uint32_t technique) const;
    std::uint16_t of(MapLook look) const;
    void region(std::uint32_t number, std::uint16_t style);
    void sector(const Vec<2>& eye, const std::array<double, 2>& azimuth, double radius, std::uint16_t style);

    const ViewpointFact<D>& fact_;
    const Rooms<D>& rooms_;
    DrawList& list_;
    std::size_t first_;              ///< of its styles: the techniques, then the others
    std::array<int, 2> axes_{0, 1};  ///< of the scene that the plan shows
    double flip_ = 1;                ///< of the second one
};

extern template class RegionPainter<2>;
extern template class RegionPainter<3>;

}  // namespace sightline
