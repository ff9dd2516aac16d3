// The naive way of CT figure 2: clip what occluders cover away from the occludee, piece by piece; what is left is seen.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/coorg_teller/shadow.h"

namespace sightline::test {

template <int D>
using Piece = std::vector<Vec<D>>;  ///< 2D: the ends of a segment; 3D: the corners of a convex polygon in order

/// The part of a piece on the side of a plane where dot(inward, p - eye) >= offset, or on the other one.
template <int D>
Piece<D> clipped(const Piece<D>& piece, const ShadowPlane<D>& plane, const Vec<D>& eye, bool inside) {
    Piece<D> left;
    const auto value = [&](const Vec<D>& p) {
        const double v = glm::dot(plane.inward, p - eye) - plane.offset;
        return inside ? v : -v;
    };
    const std::size_t edges = D == 2 ? piece.size() - 1 : piece.size();
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const double here = value(piece[i]);
        if (here >= 0) left.push_back(piece[i]);
        if (i >= edges) continue;
        const Vec<D>& next = piece[(i + 1) % piece.size()];
        const double there = value(next);
        if ((here < 0 && there > 0) || (here > 0 && there < 0))
            left.push_back(piece[i] + (next - piece[i]) * (here / (here - there)));
    }
    return left.size() < D ? Piece<D>{} : left;
}

/// Twice the area (3D: six times the volume) between the piece and the eye: 0 for one that is seen edge-on.
inline double size_seen(const Piece<2>& piece, const Vec<2>& eye) {
    return piece.empty() ? 0 : std::abs(cross(piece.front() - eye, piece.back() - eye));
}
inline double size_seen(const Piece<3>& piece, const Vec<3>& eye) {
    Vec<3> sum(0);
    for (std::size_t i = 2; i < piece.size(); ++i) sum += glm::cross(piece[i - 1] - piece[0], piece[i] - piece[0]);
    return piece.empty() ? 0 : std::abs(glm::dot(sum, piece[0] - eye));
}

/// How much of the pieces the occluder leaves.
template <int D>
void clip_away(std::vector<Piece<D>>& pieces, const Shadow<D>& occluder, const Vec<D>& eye) {
    std::vector<Piece<D>> left;
    for (const Piece<D>& piece : pieces) {
        Piece<D> rest = piece;
        const auto cut = [&](const ShadowPlane<D>& plane) {
            if (rest.empty()) return;
            if (Piece<D> outside = clipped(rest, plane, eye, false); size_seen(outside, eye) > 0)
                left.push_back(std::move(outside));
            rest = clipped(rest, plane, eye, true);
        };
        for (const auto& front : occluder.fronts) cut(front.plane);
        for (const auto& side : occluder.sides) cut(side.plane);
    }
    pieces = std::move(left);
}

/// The border of a box.
inline std::vector<Piece<2>> border_of(const Box<2>& box) {
    std::vector<Piece<2>> pieces;
    for (int i = 0; i < 4; ++i) pieces.push_back({box.corner(i), box.corner((i + 1) % 4)});
    return pieces;
}
inline std::vector<Piece<3>> border_of(const Box<3>& box) {
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    std::vector<Piece<3>> pieces;
    for (const auto& [a, b, c, d] : faces)
        pieces.push_back({box.corner(a), box.corner(b), box.corner(c), box.corner(d)});
    return pieces;
}

/// What the occluders leave of a box's border, as size_seen has it.
template <int D>
double left_of(const Box<D>& box, std::span<const Shadow<D>> occluders, const Vec<D>& eye) {
    std::vector<Piece<D>> pieces = border_of(box);
    for (const Shadow<D>& occluder : occluders)
        if (!occluder.polygons.empty()) clip_away(pieces, occluder, eye);
    double left = 0;
    for (const Piece<D>& piece : pieces) left += size_seen(piece, eye);
    return left;
}

}  // namespace sightline::test
