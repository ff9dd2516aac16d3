// What a 3D picture shows under its lines and labels, as plain data: lit triangles of the scene and faces of cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/draw/pixels.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace sightline {

/// How a face, an edge or a triangle looks: `colour` with a < 255 is translucent.
struct SolidStyle {
    std::string name;  ///< what it means; legends and tests refer to it
    Colour colour;
    bool lit = true;        ///< shaded by its angle to the eye's light
    double width_pt = 0.5;  ///< of edges, at the final size
};

/// A plane that cuts triangles off: the side where dot(normal, p) > offset is not drawn.
struct Slice {
    Vec<3> normal{};
    double offset = 0;
};

struct SolidList {
    View<3> camera;  ///< the display view; its cone fills the picture
    std::vector<SolidStyle> styles;

    /// Triangles of the scene: each run is `count` ids of `triangles` from `first` on, in one style.
    struct Run {
        std::uint8_t style = 0;
        std::uint32_t first = 0, count = 0;
        bool operator==(const Run&) const = default;
    };
    std::shared_ptr<const Scene<3>> scene;
    std::uint32_t levels_from = none;  ///< from here on its triangles are those of levels that stand in for objects
    std::vector<std::uint32_t> triangles;
    std::vector<Run> runs;
    std::optional<Slice> slice;

    /// Convex faces, seen from both sides: face i has points [face_begin[i], face_begin[i + 1]) and style
    /// face_style[i]; face_cell[i] is the cell it belongs to, for picking.
    std::vector<Vec<3>> points;
    std::vector<std::uint32_t> face_begin{0};
    std::vector<std::uint8_t> face_style;
    std::vector<std::uint32_t> face_cell;

    /// Edges, two points each, drawn where nothing lies before them.
    std::vector<Vec<3>> edge_points;
    std::vector<std::uint8_t> edge_style;

    Colour background{255, 255, 255};  ///< opaque, whatever its a
};

/// The most pixels a side that a DrawSolid is asked for.
inline constexpr int largest_solid_picture = 8192;

/// Puts a list into this many opaque pixels, of which `px_per_pt` make a point of the edges' widths; OpenGL does
/// (shell/gl). Throws WorkError when it cannot.
using DrawSolid = std::function<Pixels(const SolidList& list, int width, int height, double px_per_pt)>;

/// The list as text, a line per style, run of triangles, face and edge: for goldens.
std::string to_text(const SolidList& list);

}  // namespace sightline
