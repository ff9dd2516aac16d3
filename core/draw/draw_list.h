// What to show, as plain data: shapes, labels and styles, built without a window and tested as text. Screen, PNG, SVG
// and PDF are ways to put it down.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/vec.h"

namespace sightline {

struct SolidList;  // core/draw/solid_list.h
struct Pixels;     // core/draw/pixels.h

struct Colour {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    bool operator==(const Colour&) const = default;
};
inline constexpr Colour transparent{0, 0, 0, 0};

/// A pattern over a fill, so that areas stay apart in greyscale.
enum class Hatch : std::uint8_t { none, diagonal, back_diagonal, cross, horizontal, dots };
inline constexpr std::size_t hatch_count = 6;
enum class Dash : std::uint8_t { solid, dashed, dotted };

/// How a shape looks. Widths are in points of the final size. A fill or stroke with a = 0 is not drawn.
struct Style {
    std::string name;  ///< what it means, e.g. "projected"; legends and tests refer to it
    Colour fill = transparent;
    Hatch hatch = Hatch::none;
    Colour hatch_colour = transparent;
    Colour stroke = transparent;
    double width_pt = 0.5;
    Dash dash = Dash::solid;
};

enum class ShapeKind : std::uint8_t {
    polygon,   ///< closed, filled and stroked; 3 points or more
    polyline,  ///< open, stroked; 2 points or more
    disc,      ///< filled circle of radius size_pt at 1 point
    ring,      ///< stroked circle of radius size_pt at 1 point
    cross,     ///< an x of half-width size_pt at 1 point
    arrow,     ///< a polyline whose last point carries a head of length size_pt
};

/// points[first_point, first_point + point_count) of the list, in scene units.
struct Shape {
    ShapeKind kind = ShapeKind::polygon;
    std::uint16_t style = 0;  ///< index into DrawList::styles
    std::uint32_t first_point = 0;
    std::uint32_t point_count = 0;
    double size_pt = 0;
};

enum class TextAlign : std::uint8_t { left, centre, right };

/// A text at a scene point. The baseline box is aligned horizontally and centred vertically on at + offset.
struct Label {
    Vec<2> at{};         ///< scene units
    Vec<2> offset_pt{};  ///< from `at`, x right, y up, in points of the final size
    std::string text;    ///< UTF-8, one line
    TextAlign align = TextAlign::centre;
    double scale = 1;  ///< times the figure's font size
    Colour colour{0, 0, 0};
    Colour halo = transparent;   ///< drawn 1 pt around the glyphs, for contrast
    std::optional<Colour> disc;  ///< numbered callouts: a filled circle behind the text
    bool leader = false;         ///< an arrow from the text to `at`, in the text's colour
    bool note = false;           ///< what an author wrote
    bool fixed = false;          ///< part of a drawing: stands where it is, and others keep off
    bool yields = false;         ///< left out where it would overlap an earlier label
    double room = 0;             ///< scene units by which it may leave `at` rather than be left out
    Vec<2> fits{};  ///< of a fixed one: scene units to fit into, 0: any; figures set it smaller, down to half
};

/// Shapes are drawn in order, then the labels.
struct DrawList {
    Box<2> world;  ///< the part of the scene that the picture shows; shapes are clipped to it
    std::vector<Style> styles;
    std::vector<Vec<2>> points;
    std::vector<Shape> shapes;
    std::vector<Label> labels;

    void add(ShapeKind kind, std::uint16_t style, std::span<const Vec<2>> at, double size_pt = 0) {
        shapes.push_back(
            {kind, style, static_cast<std::uint32_t>(points.size()), static_cast<std::uint32_t>(at.size()), size_pt});
        points.insert(points.end(), at.begin(), at.end());
    }
    void add(ShapeKind kind, std::uint16_t style, std::initializer_list<Vec<2>> at, double size_pt = 0) {
        add(kind, style, std::span(at.begin(), at.size()), size_pt);
    }
};

/// One row of the legend: a swatch drawn with a style, and what it means.
struct LegendRow {
    ShapeKind swatch = ShapeKind::polygon;
    Style style;
    std::string text;
};

/// The scale of a heat map: stops evenly spread from low to high, the first is low.
struct ColourBar {
    std::string title;
    std::string low, high;  ///< the numbers at its ends, already written out
    std::vector<Colour> stops;
};

/// Where legend and colour bar go; off shows neither.
enum class LegendPlace : std::uint8_t {
    inside,   ///< a box in the corner of a panel that hides least; outside when no panel has room for it
    outside,  ///< right of the panels or below them
    off,
};

/// A whole figure: one panel or several with one legend and one scale.
struct Figure {
    /// A small picture in the upper right corner of a panel, over all else; several stand below each other. One of
    /// `solid`, `pixels` and `list` is what it shows; the list's world has the aspect, and its labels are left out.
    struct Inset {
        std::string title;
        double aspect = 1;  ///< width / height, > 0
        std::shared_ptr<const SolidList> solid{};
        std::shared_ptr<const Pixels> pixels{};
        std::shared_ptr<const DrawList> list{};
    };
    struct Panel {
        DrawList list;
        std::string title;                         ///< e.g. "(a) step 12"; may be empty
        std::shared_ptr<const SolidList> solid{};  ///< 3D: lies under the list and fills its world
        std::vector<Inset> insets{};
        std::vector<std::string> notes_outside{};  ///< texts of notes of this moment that lie beside the picture
    };
    std::vector<Panel> panels;
    std::vector<LegendRow> legend;
    std::optional<ColourBar> bar;
    LegendPlace legend_place = LegendPlace::outside;
    std::string caption;  ///< wrapped under the panels; may be empty
    Colour background{255, 255, 255};
    Colour ink{0, 0, 0};  ///< legend, titles and caption
};

/// The list as text, a line per style, shape and label, with numbers that read back to the same double: for goldens.
std::string to_text(const DrawList& list);

}  // namespace sightline
