// Everything a person can choose, in one plain struct. It feeds the command line, JSON files, panels and reports; each
// field has one name, one default and one line of help (settings_table.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/settings/budget.h"

namespace sightline {

enum class Switch : std::uint8_t { off, on };
enum class YesNo : std::uint8_t { no, yes };
enum class Tessellation : std::uint8_t { delaunay, tree };
enum class Border : std::uint8_t { inflated, none };
enum class ViewVector : std::uint8_t { eye, camera };
enum class TransferSign : std::uint8_t { clamp, with_sign, abs };
enum class OnReenqueue : std::uint8_t { replace, min, max };
enum class Penalty : std::uint8_t { multiply, add, none };
enum class SolidityScale : std::uint8_t { max, p95 };
enum class OutsideView : std::uint8_t { unseen, enqueue };
enum class CulledCost : std::uint8_t { free, charged };
enum class Seeds : std::uint8_t { one, hull };
enum class CellNumber : std::uint8_t { none, solidity, count, order, zeta, share, id };
enum class LabelWhere : std::uint8_t { front, all, selected };
enum class Palette : std::uint8_t { standard, paper, print };
enum class ZoomAt : std::uint8_t { view, last, selected, point };
enum class Legend : std::uint8_t { outside, inside, off };
enum class DrawnAs : std::uint8_t { off, solid, wireframe, translucent };
enum class SliceAcross : std::uint8_t { off, x, y, z, view };
enum class OnlyCells : std::uint8_t { all, front, around };
enum class Triangles : std::uint8_t { off, rendered, visible, all };
enum class Inset : std::uint8_t { off, image, missed, both, exact };
enum class Split : std::uint8_t { off, exact, missed };

/// The words of each enum, in the order of its values.
template <typename E>
inline constexpr std::array<std::string_view, 0> words{};
template <>
inline constexpr auto words<Switch> = std::to_array<std::string_view>({"off", "on"});
template <>
inline constexpr auto words<YesNo> = std::to_array<std::string_view>({"no", "yes"});
template <>
inline constexpr auto words<Tessellation> = std::to_array<std::string_view>({"delaunay", "tree"});
template <>
inline constexpr auto words<Border> = std::to_array<std::string_view>({"inflated", "none"});
template <>
inline constexpr auto words<ViewVector> = std::to_array<std::string_view>({"eye", "camera"});
template <>
inline constexpr auto words<TransferSign> = std::to_array<std::string_view>({"clamp", "signed", "abs"});
template <>
inline constexpr auto words<OnReenqueue> = std::to_array<std::string_view>({"replace", "min", "max"});
template <>
inline constexpr auto words<Penalty> = std::to_array<std::string_view>({"multiply", "add", "none"});
template <>
inline constexpr auto words<SolidityScale> = std::to_array<std::string_view>({"max", "p95"});
template <>
inline constexpr auto words<OutsideView> = std::to_array<std::string_view>({"unseen", "enqueue"});
template <>
inline constexpr auto words<CulledCost> = std::to_array<std::string_view>({"free", "charged"});
template <>
inline constexpr auto words<Seeds> = std::to_array<std::string_view>({"one", "hull"});
template <>
inline constexpr auto words<CellNumber> = std::to_array<std::string_view>({"none", "solidity", "count", "order", "zeta",
                                                                           "share", "id"});
template <>
inline constexpr auto words<LabelWhere> = std::to_array<std::string_view>({"front", "all", "selected"});
template <>
inline constexpr auto words<Palette> = std::to_array<std::string_view>({"default", "paper", "print"});
template <>
inline constexpr auto words<ZoomAt> = std::to_array<std::string_view>({"view", "last", "selected", "point"});
template <>
inline constexpr auto words<Legend> = std::to_array<std::string_view>({"outside", "inside", "off"});
template <>
inline constexpr auto words<DrawnAs> = std::to_array<std::string_view>({"off", "solid", "wireframe", "translucent"});
template <>
inline constexpr auto words<SliceAcross> = std::to_array<std::string_view>({"off", "x", "y", "z", "view"});
template <>
inline constexpr auto words<OnlyCells> = std::to_array<std::string_view>({"all", "front", "around"});
template <>
inline constexpr auto words<Triangles> = std::to_array<std::string_view>({"off", "rendered", "visible", "all"});
template <>
inline constexpr auto words<Inset> = std::to_array<std::string_view>({"off", "image", "missed", "both", "exact"});
template <>
inline constexpr auto words<Split> = std::to_array<std::string_view>({"off", "exact", "missed"});

/// Pixels of a reference; 0: what the dimension asks for. 2D references have a width only.
struct ImageSize {
    int width = 0, height = 0;
    bool operator==(const ImageSize&) const = default;
};

struct Settings {
    // scene
    Switch two_sided = Switch::off;

    // tessellation
    Tessellation tessellation = Tessellation::delaunay;
    double error_bound = 0.05;
    Border border = Border::inflated;
    double jitter = 0.02;
    std::uint64_t seed = 1;

    // traversal
    std::string method = "published";
    Budget budget;
    ViewVector view_vector = ViewVector::eye;
    TransferSign transfer_sign = TransferSign::clamp;
    OnReenqueue on_reenqueue = OnReenqueue::replace;
    Switch star_shaped = Switch::on;
    Penalty penalty = Penalty::multiply;
    double penalty_amount = 2;
    SolidityScale solidity_scale = SolidityScale::max;
    OutsideView outside_view = OutsideView::unseen;
    CulledCost culled_cost = CulledCost::free;
    YesNo neighbours_before_break = YesNo::yes;
    Seeds seeds = Seeds::one;

    // reference
    ImageSize reference_size;

    // picture
    Palette palette = Palette::standard;
    Switch show_tessellation = Switch::on;
    Switch show_states = Switch::on;
    Switch show_primitives = Switch::on;
    Switch show_visibility = Switch::on;
    Switch show_view = Switch::on;
    Switch show_normals = Switch::off;
    Switch show_penalties = Switch::off;
    Switch show_chain = Switch::off;
    CellNumber label = CellNumber::none;
    LabelWhere label_where = LabelWhere::front;
    CellNumber heat = CellNumber::none;
    Legend legend = Legend::outside;
    Switch caption = Switch::on;
    double zoom = 1;
    ZoomAt zoom_at = ZoomAt::view;
    double zoom_x = 0, zoom_y = 0;  ///< scene coordinates as the session has them

    // picture, 3D
    DrawnAs clean_as = DrawnAs::off;
    DrawnAs projected_as = DrawnAs::solid;
    DrawnAs enqueued_as = DrawnAs::wireframe;
    DrawnAs unseen_as = DrawnAs::off;
    double shrink = 1;
    SliceAcross slice = SliceAcross::off;
    double slice_at = 0.5;
    OnlyCells only = OnlyCells::all;
    std::uint32_t around = 2;
    Triangles triangles = Triangles::rendered;
    Inset inset = Inset::off;
    Split split = Split::off;

    bool operator==(const Settings&) const = default;
};

}  // namespace sightline
