// How a session is shown; nothing here touches a traversal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/words.h"

namespace sightline {

/// A number that a picture shows on cells: one that every method has, or a field of the method's run (core/run/run.h).
struct CellNumber {
    enum Kind : std::uint8_t { none, solidity, count, order, zeta, share, id, field };
    Kind kind = none;
    std::string name{};  ///< of the field

    CellNumber() = default;
    CellNumber(Kind what) : kind(what) {}
    bool operator==(const CellNumber&) const = default;
};
enum class LabelWhere : std::uint8_t { front, all, selected };
enum class Palette : std::uint8_t { standard, paper, print };
enum class ZoomAt : std::uint8_t { view, last, selected, point };
enum class Legend : std::uint8_t { outside, inside, off, brief };
enum class DrawnAs : std::uint8_t { off, solid, wireframe, translucent };
enum class SliceAcross : std::uint8_t { off, x, y, z, view };
enum class OnlyCells : std::uint8_t { all, front, around };
/// missed: the rendered ones and, where the run has ended or the view is frozen, the visible ones that it misses.
enum class Triangles : std::uint8_t { off, rendered, missed, visible, all };
enum class Inset : std::uint8_t { off, image, missed, both, exact, depth, pyramid };
enum class Split : std::uint8_t { off, exact, missed };

/// Of the kinds but `field`, which is written by its name.
inline constexpr auto cell_number_words =
    std::to_array<std::string_view>({"none", "solidity", "count", "order", "zeta", "share", "id"});
template <>
inline constexpr auto words<LabelWhere> = std::to_array<std::string_view>({"front", "all", "selected"});
template <>
inline constexpr auto words<Palette> = std::to_array<std::string_view>({"default", "paper", "print"});
template <>
inline constexpr auto words<ZoomAt> = std::to_array<std::string_view>({"view", "last", "selected", "point"});
template <>
inline constexpr auto words<Legend> = std::to_array<std::string_view>({"outside", "inside", "off", "short"});
template <>
inline constexpr auto words<DrawnAs> = std::to_array<std::string_view>({"off", "solid", "wireframe", "translucent"});
template <>
inline constexpr auto words<SliceAcross> = std::to_array<std::string_view>({"off", "x", "y", "z", "view"});
template <>
inline constexpr auto words<OnlyCells> = std::to_array<std::string_view>({"all", "front", "around"});
template <>
inline constexpr auto words<Triangles> = std::to_array<std::string_view>({"off", "rendered", "missed", "visible",
                                                                          "all"});
template <>
inline constexpr auto words<Inset> = std::to_array<std::string_view>({"off", "image", "missed", "both", "exact",
                                                                      "depth", "pyramid"});
template <>
inline constexpr auto words<Split> = std::to_array<std::string_view>({"off", "exact", "missed"});

struct PictureSettings {
    Palette palette = Palette::standard;
    Switch show_tessellation = Switch::on;
    Switch show_states = Switch::on;
    Switch show_primitives = Switch::on;
    Switch show_visibility = Switch::on;
    Switch show_view = Switch::on;
    Switch show_normals = Switch::off;
    Switch show_penalties = Switch::off;
    Switch show_chain = Switch::off;
    Switch show_choice = Switch::on;
    Switch show_depth = Switch::off;
    Switch show_eye = Switch::off;
    Switch show_planes = Switch::on;
    Switch show_regions = Switch::on;
    CellNumber label = CellNumber::none;
    LabelWhere label_where = LabelWhere::front;
    CellNumber heat = CellNumber::none;
    Legend legend = Legend::outside;
    Switch caption = Switch::on;
    double zoom = 1;
    ZoomAt zoom_at = ZoomAt::view;
    double zoom_x = 0, zoom_y = 0;  ///< scene coordinates as the session has them

    // 3D
    DrawnAs clean_as = DrawnAs::off;
    DrawnAs projected_as = DrawnAs::solid;
    DrawnAs enqueued_as = DrawnAs::wireframe;
    DrawnAs unseen_as = DrawnAs::off;
    double shrink = 1;
    SliceAcross slice = SliceAcross::off;
    double slice_at = 0.5;
    OnlyCells only = OnlyCells::all;
    std::uint32_t around = 2;
    Triangles triangles = Triangles::missed;
    Inset inset = Inset::off;
    Split split = Split::off;

    bool operator==(const PictureSettings&) const = default;
};

}  // namespace sightline
