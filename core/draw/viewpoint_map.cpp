// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/viewpoint_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/trig.h"
#include "core/draw/box_palette.h"
#include "core/draw/palette.h"
#include "core/draw/variant_look.h"

namespace sightline {

namespace {

constexpr std::string_view technique_prefix = "technique ";

struct MapEntry {
    std::string_view name;
    ShapeKind swatch;
    const char* text;
};
constexpr std::array map_entries{
    MapEntry{"region_unknown", ShapeKind::polygon, "not worked out so far"},
    MapEntry{"region_here", ShapeKind::polyline, "region of the eye"},
    MapEntry{"looked_into", ShapeKind::polyline, "directions looked into"},
    MapEntry{"cut_scene", ShapeKind::polyline, "the scene, cut level"},
};

/// The first does the least, so that it has none.
constexpr std::array hatches{Hatch::none,  Hatch::diagonal,   Hatch::back_diagonal,
                             Hatch::cross, Hatch::horizontal, Hatch::dots};

/// Inner border of the rose, of its outer one.
constexpr double ring_share = 0.7;
/// Degrees between two corners of an arc.
constexpr double arc_step = 7.5;

std::vector<Style> map_styles(Palette palette) {
    const Colours& c = colours(palette);
    const auto stroke_of = [&](Look look) { return c.looks[static_cast<std::size_t>(look)].stroke; };
    Style unknown{"region_unknown"}, here{"region_here"}, into{"looked_into"}, scene{"cut_scene"};
    unknown.fill = c.background;
    unknown.stroke = stroke_of(Look::tessellation);
    unknown.dash = Dash::dotted;
    // Grey would be lost among greys.
    here.stroke = into.stroke = palette == Palette::print ? c.ink : stroke_of(Look::seed);
    here.width_pt = 2.6;
    here.dash = Dash::dashed;
    into.width_pt = 2.2;
    scene.stroke = c.ink;
    return {unknown, here, into, scene, box_looks(palette)[static_cast<std::size_t>(BoxLook::potential)]};
}

}  // namespace

template <int D>
std::optional<ViewpointFact<D>> shown_viewpoint(const Session<D>& session) {
    if (session.settings().show_regions == Switch::off) return std::nullopt;
    return session.traversal().viewpoint();
}

std::vector<Style> technique_styles(std::span<const TechniqueFact> techniques, Palette palette) {
    const Colours& c = colours(palette);
    std::vector<std::string> names;
    for (const TechniqueFact& technique : techniques) names.push_back(technique.name);
    const std::vector<VariantLook> looks = variant_looks(names);
    std::vector<Style> styles;
    const bool dark = lightness(c.background) < 50;
    for (std::size_t i = 0; i < names.size(); ++i) {
        // The colours of charts are made for white paper.
        Colour strong = dark ? between({looks[i].colour, {255, 255, 255}}, 0.45) : looks[i].colour;
        Style style{std::string(technique_prefix) + names[i]};
        style.fill = between({c.background, strong}, 0.36);
        if (palette == Palette::print) {  // greys alone, each darker than the one before it
            const auto grey = static_cast<std::uint8_t>(240 - 25 * std::min<std::size_t>(i, 5));
            style.fill = {grey, grey, grey};
            strong = {60, 60, 60};
        }
        style.hatch = hatches[i % hatches.size()];
        style.hatch_colour = between({style.fill, strong}, 0.6);  // what is drawn over it has to be seen
        style.stroke = between({style.fill, c.ink}, 0.3);
        style.width_pt = 0.4;
        styles.push_back(std::move(style));
    }
    return styles;
}

Style region_here_style(Palette palette) { return map_styles(palette)[static_cast<std::size_t>(MapLook::here)]; }

std::optional<LegendRow> region_row(const Style& style) {
    if (style.name.starts_with(technique_prefix))
        return LegendRow{ShapeKind::polygon, style, style.name.substr(technique_prefix.size())};
    for (const MapEntry& entry : map_entries)
        if (entry.name == style.name) return LegendRow{entry.swatch, style, entry.text};
    return std::nullopt;
}

template <int D>
RegionPainter<D>::RegionPainter(const ViewpointFact<D>& fact, const Scene<D>& scene, Palette palette, DrawList& list)
    : fact_(fact), rooms_(scene.rooms), list_(list), first_(list.styles.size()) {
    for (Style& style : technique_styles(fact.techniques, palette)) list.styles.push_back(std::move(style));
    for (Style& style : map_styles(palette)) list.styles.push_back(std::move(style));
    if (D == 2) return;
    const int up = scene.up_axis;
    axes_ = {up == 0 ? 1 : 0, up == 2 ? 1 : 2};
    flip_ = up == 1 ? -1 : 1;  // x and z from above: z comes down the picture
}

template <int D>
std::uint16_t RegionPainter<D>::of(std::uint32_t technique) const {
    return technique == none ? of(MapLook::unknown) : static_cast<std::uint16_t>(first_ + technique);
}

template <int D>
std::uint16_t RegionPainter<D>::of(MapLook look) const {
    return static_cast<std::uint16_t>(first_ + fact_.techniques.size() + static_cast<std::size_t>(look));
}

template <int D>
Vec<2> RegionPainter<D>::in_plan(const Vec<D>& point) const {
    return {point[axes_[0]], flip_ * point[axes_[1]]};
}

template <int D>
void RegionPainter<D>::region(std::uint32_t number, std::uint16_t style) {
    const RegionFact<D>& region = fact_.map[number];
    if constexpr (D == 2)
        if (region.room) {
            const std::size_t boxes = fact_.map.size() - rooms_.all.size();  // rooms come after them
            return list_.add(ShapeKind::polygon, style, rooms_.all[number - boxes].shape);
        }
    const Vec<2> a = in_plan(region.box.min), b = in_plan(region.box.max);
    list_.add(ShapeKind::polygon, style, {a, {b.x, a.y}, b, {a.x, b.y}});
}

template <int D>
void RegionPainter<D>::regions(double height) {
    const int up = 3 - axes_[0] - axes_[1];  // 3D
    for (std::uint32_t i = 0; i < fact_.map.size(); ++i) {
        const Box<D>& box = fact_.map[i].box;
        if (D == 2 || (box.min[up] <= height && height <= box.max[up])) region(i, of(fact_.map[i].technique));
    }
}

template <int D>
void RegionPainter<D>::outline() {
    region(fact_.region_here, of(MapLook::here));
}

template <int D>
void RegionPainter<D>::sector(const Vec<2>& eye, const std::array<double, 2>& azimuth, double radius,
                              std::uint16_t style) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((azimuth[1] - azimuth[0]) / arc_step)));
    std::vector<Vec<2>> corners;
    const auto arc = [&](double at_radius, bool back) {
        for (int i = 0; i <= pieces; ++i) {
            const double share = static_cast<double>(back ? pieces - i : i) / pieces;
            const SinCos at = sincos_degrees(azimuth[0] + (azimuth[1] - azimuth[0]) * share);
            corners.push_back(eye + Vec<2>(at.cos, flip_ * at.sin) * at_radius);
        }
    };
    arc(radius, false);
    arc(ring_share * radius, true);
    list_.add(ShapeKind::polygon, style, corners);
}

template <int D>
void RegionPainter<D>::rose(const Vec<D>& eye, double radius) {
    const DirectionFact& here = fact_.rose[fact_.interval_here];
    const Vec<2> at = in_plan(eye);
    for (const DirectionFact& direction : fact_.rose)
        if (direction.elevation == here.elevation) sector(at, direction.azimuth, radius, of(direction.technique));
    sector(at, here.azimuth, radius, of(MapLook::looked_into));
}

template <int D>
void RegionPainter<D>::candidate(const Vec<2>& a, const Vec<2>& b) {
    list_.add(ShapeKind::polyline, of(MapLook::candidate), {a, b});
}

template <int D>
void RegionPainter<D>::wall(const Vec<2>& a, const Vec<2>& b) {
    list_.add(ShapeKind::polyline, of(MapLook::scene), {a, b});
}

template std::optional<ViewpointFact<2>> shown_viewpoint<2>(const Session<2>&);
template std::optional<ViewpointFact<3>> shown_viewpoint<3>(const Session<3>&);
template class RegionPainter<2>;
template class RegionPainter<3>;

}  // namespace sightline
