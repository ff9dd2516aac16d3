// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/extinction/cell_extinction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/workers.h"
#include "core/geometry/clip.h"

namespace sightline {

namespace {

/// Any length.
Vec<2> normal_of(const std::array<Vec<2>, 2>& p) { return {p[0].y - p[1].y, p[1].x - p[0].x}; }
Vec<3> normal_of(const std::array<Vec<3>, 3>& p) { return glm::cross(p[1] - p[0], p[2] - p[0]); }

template <int D>
std::array<Vec<D>, D> facet_opposite(const CellComplex<D>& cells, std::uint32_t cell, std::size_t corner) {
    const auto corners = cells.corners_of(cell);
    std::array<Vec<D>, D> facet;
    std::size_t n = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (i != corner) facet[n++] = cells.points[corners[i]];
    return facet;
}

template <int D>
const Box<D>& box_of(const CellComplex<D>& cells, std::uint32_t cell) {
    return cells.tree.nodes[cells.tree.leaves[cell]].box;
}

template <int D>
HalfSpaces<D> sides_of(const CellComplex<D>& cells, std::uint32_t cell) {
    if (cells.has_boxes()) return HalfSpaces<D>(box_of(cells, cell));
    HalfSpaces<D> made;
    const auto corners = cells.corners_of(cell);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto facet = facet_opposite(cells, cell, i);
        const Vec<D> normal = normal_of(facet);
        const bool inward = glm::dot(normal, cells.points[corners[i]] - facet[0]) >= 0;
        made.add(inward ? normal : -normal, facet[0]);
    }
    return made;
}

template <int D>
double length(const Vec<D>& v) {
    return std::sqrt(glm::dot(v, v));
}

ConvexSize cell_size(const CellComplex<2>& cells, std::uint32_t cell) {
    if (cells.has_boxes()) return size_of(box_of(cells, cell));
    const auto c = cells.corners_of(cell);
    const Vec<2>&p = cells.points[c[0]], &q = cells.points[c[1]], &r = cells.points[c[2]];
    const Vec<2> u = q - p, v = r - p;
    return {std::abs(u.x * v.y - u.y * v.x) / 2, length<2>(u) + length<2>(v) + length<2>(r - q)};
}

ConvexSize cell_size(const CellComplex<3>& cells, std::uint32_t cell) {
    if (cells.has_boxes()) return size_of(box_of(cells, cell));
    ConvexSize size;
    for (std::size_t i = 0; i < 4; ++i) size.surface += length<3>(normal_of(facet_opposite(cells, cell, i))) / 2;
    const auto c = cells.corners_of(cell);
    const Vec<3>& p = cells.points[c[0]];
    const Vec<3> normal = glm::cross(cells.points[c[1]] - p, cells.points[c[2]] - p);
    size.inside = std::abs(glm::dot(normal, cells.points[c[3]] - p)) / 6;
    return size;
}

template <int D>
CellExtinction<D> made_from(const Scene<D>& scene, const CellComplex<D>& cells) {
    constexpr std::uint32_t cells_a_part = 256;
    CellExtinction<D> made;
    const std::uint32_t count = cells.cell_count();
    made.depth.resize(count);
    made.chord.resize(count);
    run_parts(static_cast<int>((count + cells_a_part - 1) / cells_a_part), 0, [&](int part) {
        const std::uint32_t begin = static_cast<std::uint32_t>(part) * cells_a_part;
        for (std::uint32_t cell = begin; cell < std::min(count, begin + cells_a_part); ++cell) {
            const ConvexSize size = cell_size(cells, cell);
            const HalfSpaces<D> sides = sides_of(cells, cell);
            double held = 0;
            for (const std::uint32_t primitive : cells.primitives_of(cell))
                held += size_inside(sides, scene.primitives[primitive]);
            const double depth = size.depth_of(held), chord = size.template mean_chord<D>();
            if (!(std::isfinite(depth) && std::isfinite(chord) && chord > 0)) continue;  // out of doubles, or flat
            made.depth[cell] = depth;
            made.chord[cell] = chord;
        }
    });
    return made;
}

}  // namespace

template <int D>
std::shared_ptr<const CellExtinction<D>> cell_extinction(const Problem<D>& problem) {
    return problem.cells->made->template of<CellExtinction<D>>(
        "extinction", [&] { return made_from(*problem.scene, *problem.cells); });
}

template <int D>
double length_in_cell(const CellComplex<D>& cells, std::uint32_t cell, const Vec<D>& from, const Vec<D>& to) {
    return share_inside(sides_of(cells, cell), from, to) * length<D>(to - from);
}

template <int D>
double size_in_cell(const CellComplex<D>& cells, std::uint32_t cell, const Primitive<D>& primitive) {
    return size_inside(sides_of(cells, cell), primitive);
}

#define SIGHTLINE_INSTANTIATE(D)                                                                           \
    template std::shared_ptr<const CellExtinction<D>> cell_extinction<D>(const Problem<D>&);               \
    template double length_in_cell<D>(const CellComplex<D>&, std::uint32_t, const Vec<D>&, const Vec<D>&); \
    template double size_in_cell<D>(const CellComplex<D>&, std::uint32_t, const Primitive<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
