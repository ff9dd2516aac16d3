// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/pixel_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/geometry/predicates.h"

namespace sightline {

namespace {

/// An image line: the points right + s (left - right) from the eye, 0 <= s <= 1.
struct Camera {
    Vec<2> right, left;
};

/// A point in homogeneous image coordinates: it lies at s = sw / w, and w is its depth, in units of the line's depth.
struct Projected {
    double sw, w;
};

Projected project(const Camera& camera, const Vec<2>& p) {
    const double whole = cross(camera.right, camera.left);
    return {cross(camera.right, p) / whole, cross(p, camera.left - camera.right) / whole};
}

/// One over the depth as a function of s: at + slope (s - origin).
struct InverseDepth {
    double origin, at, slope;
    double operator()(double s) const { return at + slope * (s - origin); }
};

/// What a segment covers of an image line, from `begin` to `end` in s.
struct Footprint {
    double begin, end;
    InverseDepth inverse_depth;
};

/// The footprint of a segment that turns counter-clockwise about the eye from a to b; empty when behind the eye.
Footprint footprint(const Projected& a, const Projected& b) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (a.w > 0 && b.w > 0) {
        const double begin = a.sw / a.w, end = b.sw / b.w;
        return {begin, end, {begin, 1 / a.w, (1 / b.w - 1 / a.w) / (end - begin)}};
    }
    if (!(a.w > 0 || b.w > 0)) return {0, 0, {}};
    // Cut at the eye plane, where s goes to infinity. Divided by the size, products neither underflow nor overflow.
    const double size = std::max({std::abs(a.w), std::abs(b.w), std::abs(a.sw), std::abs(b.sw)});
    const double turn = (a.w / size) * (b.sw / size) - (a.sw / size) * (b.w / size);
    if (!(turn > 0)) return {0, 0, {}};  // through the eye but for rounding
    const double slope = (a.w / size - b.w / size) / turn / size;
    if (a.w > 0) return {a.sw / a.w, infinity, {a.sw / a.w, 1 / a.w, slope}};
    return {-infinity, b.sw / b.w, {b.sw / b.w, 1 / b.w, slope}};
}

/// The first of `width` pixels whose centre is at s or beyond.
int first_pixel(double s, int width) {
    return static_cast<int>(std::clamp(std::ceil(s * width - 0.5), 0.0, static_cast<double>(width)));
}

/// An image line and its pixels.
struct Part {
    Camera camera;
    int first, width;
};

std::vector<Part> parts_of(const View<2>& view, int width) {
    if (!view.all_round) {
        // Brought to unit size, so that products of small distances do not vanish.
        const Vec<2> right = view.corners[0] - view.eye, left = view.corners[1] - view.eye;
        const double size = std::max({std::abs(right.x), std::abs(right.y), std::abs(left.x), std::abs(left.y)});
        return {{{right / size, left / size}, 0, width}};
    }
    const std::array<Vec<2>, 4> corners{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
    std::vector<Part> parts;
    for (int side = 0; side < 4; ++side)
        parts.push_back({{corners[static_cast<std::size_t>(side)], corners[static_cast<std::size_t>((side + 1) % 4)]},
                         side * (width / 4),
                         width / 4});
    return parts;
}

/// What the line shows of a segment; empty where it is seen edge-on.
Footprint footprint_of(const Part& part, const Vec<2>& eye, const Primitive<2>& segment) {
    const int side = orient(eye, segment[0], segment[1]);
    if (side == 0) return {0, 0, {}};
    return footprint(project(part.camera, segment[side > 0 ? 0 : 1] - eye),
                     project(part.camera, segment[side > 0 ? 1 : 0] - eye));
}

/// Whether it is seen at any pixel.
bool draw_segment(PixelLine& line, const Part& part, const Footprint& seen, std::uint32_t id) {
    if (!(seen.begin < seen.end)) return false;  // also when not a number
    bool won = false;
    const int end = first_pixel(seen.end, part.width);
    for (int i = first_pixel(seen.begin, part.width); i < end; ++i) {
        const double nearness = seen.inverse_depth((i + 0.5) / part.width);
        const auto at = static_cast<std::size_t>(part.first + i);
        if (nearness > line.nearness[at] || (nearness == line.nearness[at] && id < line.ids[at])) {
            line.nearness[at] = nearness;
            line.ids[at] = id;
            won = true;
        }
    }
    return won;
}

/// In pixels, as in 3D: far more than rounding moves ends.
constexpr double widened_2d = 1.0 / 128;
/// Of depths; far more than rounding changes them.
constexpr double depth_step_2d = 1 + 0x1p-40;

/// Appends what the line may see of an edge of a convex shape.
void add_piece(LineShape& shape, const Part& part, const Vec<2>& eye, const Primitive<2>& edge) {
    const Footprint seen = footprint_of(part, eye, edge);
    // Seen edge-on up to rounding, an edge adds nothing to its neighbours; a segment alone is not drawn either.
    if (!(seen.begin < seen.end)) return;
    const double begin = seen.begin * part.width - widened_2d, end = seen.end * part.width + widened_2d;
    LineShape::Piece piece;
    piece.first = static_cast<int>(std::clamp(std::ceil(begin - 0.5), 0.0, static_cast<double>(part.width)));
    piece.end = static_cast<int>(std::clamp(std::floor(end - 0.5) + 1, 0.0, static_cast<double>(part.width)));
    if (piece.first >= piece.end) return;
    const double wa = project(part.camera, edge[0] - eye).w, wb = project(part.camera, edge[1] - eye).w;
    piece.nearest = wa > 0 && wb > 0 ? depth_step_2d / std::min(wa, wb) : std::numeric_limits<double>::infinity();
    piece.nearness_0 = piece.nearest;
    // Narrower than this the slope is rounding; then it is as near as its nearer end.
    if (end - begin > 3 * widened_2d) {
        const double slope = seen.inverse_depth.slope / part.width;  // by pixel
        piece.nearness_x = slope * depth_step_2d;
        piece.nearness_0 = (seen.inverse_depth(0.5 / part.width) + std::abs(slope) * widened_2d) * depth_step_2d +
                           (std::abs(slope) * part.width + std::abs(seen.inverse_depth.at)) * 0x1p-40;
    } else if (std::isinf(piece.nearest)) {
        shape.everywhere = true;
        return;
    }
    piece.first += part.first;
    piece.end += part.first;
    piece.nearness_0 -= piece.nearness_x * part.first;
    shape.pieces.push_back(piece);
}

}  // namespace

PixelLine::PixelLine(const View<2>& view, int width) {
    if (width < 1 || width > 1 << 24)
        throw InputError("item buffer: width must be in [1, 16777216], not " + std::to_string(width));
    if (view.all_round && width % 4 != 0)
        throw InputError("item buffer: width of an all-round view must be a multiple of 4, not " +
                         std::to_string(width));
    nearness.assign(static_cast<std::size_t>(width), 0);
    ids.assign(static_cast<std::size_t>(width), none);
}

void draw_line(PixelLine& line, std::span<const Primitive<2>> segments, const View<2>& view) {
    for (const Part& part : parts_of(view, line.width()))
        for (std::size_t id = 0; id < segments.size(); ++id)
            draw_segment(line, part, footprint_of(part, view.eye, segments[id]), static_cast<std::uint32_t>(id));
}

void draw_line(PixelLine& line, std::span<const Primitive<2>> segments, const View<2>& view,
               std::span<const std::uint32_t> which) {
    for (const Part& part : parts_of(view, line.width()))
        for (const std::uint32_t id : which) draw_segment(line, part, footprint_of(part, view.eye, segments[id]), id);
}

void draw_line(PixelLine& line, std::span<const Primitive<2>> segments, const View<2>& view,
               std::span<const std::uint32_t> which, std::span<std::uint8_t> won) {
    std::fill(won.begin(), won.end(), std::uint8_t{0});
    // Parts have no pixel in common, so each may be drawn in the list's order by itself.
    for (const Part& part : parts_of(view, line.width()))
        for (std::size_t i = 0; i < which.size(); ++i)
            if (draw_segment(line, part, footprint_of(part, view.eye, segments[which[i]]), which[i])) won[i] = 1;
}

LineShape seen_cell(const View<2>& view, int width, const CellComplex<2>& cells, std::uint32_t cell) {
    LineShape shape;
    shape.everywhere = true;
    std::vector<Primitive<2>> edges;
    for (const HalfFacet& half : cells.facets_of(cell)) {
        if (facet_side(cells, half, view.eye) >= 0) continue;
        shape.everywhere = false;
        edges.push_back(facet_ends(cells, half));
    }
    for (const Part& part : parts_of(view, width))
        for (const Primitive<2>& edge : edges) add_piece(shape, part, view.eye, edge);
    return shape;
}

LineShape seen_polygon(const View<2>& view, int width, std::span<const Vec<2>> corners) {
    LineShape shape;
    int left = 0, right = 0;
    std::vector<Primitive<2>> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
        const int side = orient(edges.back()[0], edges.back()[1], view.eye);
        left += side >= 0;
        right += side <= 0;
    }
    // All edges on one side of the eye: it lies inside. Those that turn away only add what is farther.
    if (corners.size() > 2 && (left == static_cast<int>(corners.size()) || right == static_cast<int>(corners.size())))
        shape.everywhere = true;
    for (const Part& part : parts_of(view, width))
        for (const Primitive<2>& edge : edges) add_piece(shape, part, view.eye, edge);
    return shape;
}

LineShape seen_box(const View<2>& view, int width, const Box<2>& box) {
    return seen_polygon(view, width, box.corners());
}

bool covers_pixel(const LineShape& shape, int x) {
    return shape.everywhere || std::any_of(shape.pieces.begin(), shape.pieces.end(),
                                           [&](const auto& p) { return x >= p.first && x < p.end; });
}

bool shows_pixel(const LineShape& shape, const PixelLine& line, int x) {
    return shape.everywhere || std::any_of(shape.pieces.begin(), shape.pieces.end(), [&](const LineShape::Piece& p) {
               return x >= p.first && x < p.end && p.nearness(x) >= line.nearness[static_cast<std::size_t>(x)];
           });
}

LineSight look_at(const LineShape& shape, const PixelLine& line) {
    LineSight sight;
    for (int x = 0; x < line.width(); ++x) {
        if (!covers_pixel(shape, x)) continue;
        ++sight.pixels;
        const std::uint32_t id = line.ids[static_cast<std::size_t>(x)];
        if (shows_pixel(shape, line, x)) {
            ++sight.seen;
            if (!sight.witness) sight.witness = x;
        } else if (id != none) {
            sight.hidden_by.push_back(id);
        }
    }
    std::sort(sight.hidden_by.begin(), sight.hidden_by.end());
    sight.hidden_by.erase(std::unique(sight.hidden_by.begin(), sight.hidden_by.end()), sight.hidden_by.end());
    return sight;
}

std::optional<int> find_seen(const LineShape& shape, const PixelLine& line) {
    if (shape.everywhere) return 0;
    std::optional<int> found;
    for (const LineShape::Piece& piece : shape.pieces)
        for (int x = piece.first; x < (found ? std::min(*found, piece.end) : piece.end); ++x)
            if (piece.nearness(x) >= line.nearness[static_cast<std::size_t>(x)]) found = x;
    return found;
}

}  // namespace sightline
