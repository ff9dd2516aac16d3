// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/solid_mesh.h"

#include <cmath>

namespace sightline {

namespace {

/// As in figures, no line is thinner.
constexpr double thinnest_edge_pt = 0.5;
/// Beyond this floats would overflow on their way to the screen.
constexpr double too_far = 1e30;

bool usable(std::span<const Vec<3>> points) {
    for (const Vec<3>& p : points)
        if (!(std::abs(p.x) < too_far && std::abs(p.y) < too_far && std::abs(p.z) < too_far)) return false;
    return true;
}

void add_face(SolidMesh& mesh, std::span<const Vec<3>> points, const SolidStyle& style, bool sliced) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto corners = static_cast<std::uint32_t>(points.size());
    SolidVertex v;
    v.normal = normal_of(points);
    v.colour = style.colour;
    v.lit = style.lit;
    v.sliced = sliced;
    Vec<3> centre(0);
    for (const Vec<3>& p : points) {
        v.x = static_cast<float>(p.x);
        v.y = static_cast<float>(p.y);
        v.z = static_cast<float>(p.z);
        mesh.vertices.push_back(v);
        mesh.bounds.add(p);
        centre += p / static_cast<double>(corners);
    }
    std::vector<std::uint32_t>& indices = style.colour.a == 255 ? mesh.opaque : mesh.translucent;
    if (style.colour.a < 255)
        mesh.sheets.push_back(
            {{static_cast<float>(centre.x), static_cast<float>(centre.y), static_cast<float>(centre.z)},
             static_cast<std::uint32_t>(indices.size()),
             3 * (corners - 2)});
    for (std::uint32_t i = 1; i + 1 < corners; ++i) indices.insert(indices.end(), {first, first + i, first + i + 1});
}

void add_edge(SolidMesh& mesh, const Vec<3>& from, const Vec<3>& to, const SolidStyle& style) {
    const auto first = static_cast<std::uint32_t>(mesh.edges.size());
    const double width = std::clamp(style.width_pt, thinnest_edge_pt, 1000.0);
    EdgeVertex v{static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z),
                 static_cast<float>(to.x),   static_cast<float>(to.y),   static_cast<float>(to.z)};
    v.colour = style.colour;
    v.half_width = static_cast<std::uint16_t>(std::lround(width / 2 * edge_units_per_pt));
    for (v.corner = 0; v.corner < 4; ++v.corner) mesh.edges.push_back(v);
    mesh.edge_indices.insert(mesh.edge_indices.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
    mesh.line_indices.insert(mesh.line_indices.end(), {first, first + 1});
    mesh.widest_pt = std::max(mesh.widest_pt, width);
    mesh.bounds.add(from);
    mesh.bounds.add(to);
}

}  // namespace

void make_mesh(const SolidList& list, SolidMesh& mesh) {
    mesh.vertices.clear();
    mesh.opaque.clear();
    mesh.translucent.clear();
    mesh.sheets.clear();
    mesh.edges.clear();
    mesh.edge_indices.clear();
    mesh.line_indices.clear();
    mesh.widest_pt = 0;
    mesh.bounds = {};
    const auto style_of = [&](const std::vector<std::uint8_t>& styles, std::size_t i) -> const SolidStyle* {
        if (i >= styles.size() || styles[i] >= list.styles.size()) return nullptr;
        const SolidStyle& style = list.styles[styles[i]];
        return style.colour.a > 0 ? &style : nullptr;
    };
    mesh.vertices.reserve(list.points.size());
    for (std::size_t i = 0; i + 1 < list.face_begin.size(); ++i) {
        const std::size_t begin = list.face_begin[i], end = list.face_begin[i + 1];
        const SolidStyle* style = style_of(list.face_style, i);
        if (!style || end > list.points.size() || begin + 3 > end) continue;
        const std::span<const Vec<3>> points(list.points.data() + begin, end - begin);
        if (usable(points)) add_face(mesh, points, *style, false);
    }
    const std::size_t edges = list.edge_points.size() / 2;
    mesh.edges.reserve(4 * edges);
    mesh.edge_indices.reserve(6 * edges);
    mesh.line_indices.reserve(2 * edges);
    for (std::size_t i = 0; i < edges; ++i) {
        const SolidStyle* style = style_of(list.edge_style, i);
        const std::span<const Vec<3>> points(list.edge_points.data() + 2 * i, 2);
        if (style && usable(points)) add_edge(mesh, points[0], points[1], *style);
    }
}

void add_triangle(SolidMesh& mesh, const Primitive<3>& triangle, const SolidStyle& style) {
    if (style.colour.a > 0 && usable(triangle)) add_face(mesh, triangle, style, true);
}

}  // namespace sightline
