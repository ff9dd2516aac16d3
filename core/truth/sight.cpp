// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/sight.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/trig.h"
#include "core/raster/image_triangles.h"
#include "core/truth/angular.h"

namespace sightline {

namespace {

double angle_between(const Vec<2>& eye, const Vec<2>& from, const Vec<2>& to) {
    const Vec<2> u = from - eye, v = to - eye;
    return std::max(0.0, angle_of(cross(u, v), glm::dot(u, v)));
}

/// `amounts`: per primitive that is seen there.
void set_shares(PrimitiveSight& sight, const std::map<std::uint32_t, double>& amounts, std::uint32_t own) {
    double total = 0;
    for (const auto& [primitive, amount] : amounts) total += amount;
    for (const auto& [primitive, amount] : amounts)
        if (primitive == own)
            sight.share = amount / total;
        else
            sight.hiders.push_back({primitive, amount / total});
    std::stable_sort(sight.hiders.begin(), sight.hiders.end(),
                     [](const Hider& a, const Hider& b) { return a.share > b.share; });
}

/// Twice the signed area of the triangle a, b, c in the image.
double edge_side(const ImageCorner& a, const ImageCorner& b, double x, double y) {
    return (static_cast<double>(b.x) - a.x) * (y - a.y) - (static_cast<double>(b.y) - a.y) * (x - a.x);
}

bool covers(std::span<const ImageCorner> corners, double x, double y) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const double a = edge_side(corners[i], corners[i + 1], x, y),
                     b = edge_side(corners[i + 1], corners[i + 2], x, y),
                     c = edge_side(corners[i + 2], corners[i], x, y);
        if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) return true;
    }
    return false;
}

}  // namespace

PrimitiveSight sight_of(const Scene<2>& scene, const View<2>& view, const Reference&, std::uint32_t primitive) {
    PrimitiveSight sight;
    const FacingSet set = facing_set(std::span(scene.primitives).subspan(primitive, 1), view.eye);
    if (set.facing.empty()) {
        sight.unseen = in_view(view, scene.primitives[primitive]) ? Unseen::edge_on : Unseen::outside;
        return sight;
    }
    std::map<std::uint32_t, double> angles;
    for (const Sector& sector : sectors(view))
        for (const Arc& arc : clipped_arcs(set.facing, sector)) {
            // Whatever is seen in the cone that the primitive fills lies before it, or is the primitive.
            View<2> cone = view;
            cone.all_round = false;
            cone.corners = {arc.from.point, arc.to.point};
            for (const VisiblePiece& piece : exact_visible_set(scene.primitives, cone).pieces) {
                angles[piece.primitive] += angle_between(view.eye, piece.from, piece.to);
                if (piece.primitive == primitive) sight.pieces.push_back(piece);
            }
        }
    if (angles.empty())
        sight.unseen = Unseen::outside;
    else
        set_shares(sight, angles, primitive);
    return sight;
}

PrimitiveSight sight_of(const Scene<3>& scene, const View<3>& view, const Reference& reference,
                        std::uint32_t primitive) {
    PrimitiveSight sight;
    const Primitive<3>& triangle = scene.primitives[primitive];
    if (!in_view(view, triangle)) {
        sight.unseen = Unseen::outside;
        return sight;
    }
    if (!faces(view, triangle) && !shows_both_sides(scene, primitive)) {
        sight.unseen = Unseen::turned_away;
        return sight;
    }
    const IdImage& image = reference.image;
    std::vector<ImageCorner> corners;
    append_image_triangle(scene, view, image_plane(view), {image.width, image.height}, primitive, corners);
    Box<2> box;
    for (const ImageCorner& corner : corners) box.add({corner.x, corner.y});
    const auto index = [](double at, int pixels) {
        return static_cast<int>(std::clamp(std::floor((at + 1) * 0.5 * pixels), 0.0, pixels - 1.0));
    };
    std::map<std::uint32_t, double> counts;
    for (int y = index(box.min.y, image.height); !corners.empty() && y <= index(box.max.y, image.height); ++y)
        for (int x = index(box.min.x, image.width); x <= index(box.max.x, image.width); ++x) {
            const std::uint32_t id = image.at(x, y);
            if (id != primitive && !covers(corners, (x + 0.5) * 2 / image.width - 1, (y + 0.5) * 2 / image.height - 1))
                continue;
            ++sight.pixels;
            if (id != none) ++counts[id];
            if (id != primitive) continue;
            auto& b = sight.seen_box;
            if (sight.seen_pixels++ == 0) b = {x, x, y, y};
            b = {std::min(b[0], x), std::max(b[1], x), std::min(b[2], y), std::max(b[3], y)};
        }
    if (sight.pixels == 0)
        sight.unseen = Unseen::no_pixel;
    else
        set_shares(sight, counts, primitive);
    return sight;
}

}  // namespace sightline
