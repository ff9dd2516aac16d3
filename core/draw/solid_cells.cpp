// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/solid_cells.h"

#include <algorithm>

namespace sightline {

namespace {

/// A convex body by its corners' places in the cell's row.
using Edge = std::array<std::uint8_t, 2>;
constexpr std::array<Edge, 6> tetrahedron_edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<std::uint8_t, 3>, 4> tetrahedron_faces{{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
// Corner c of a box lies on the upper side of axis i where bit i of c is set.
constexpr std::array<Edge, 12> box_edges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr std::array<std::array<std::uint8_t, 4>, 6> box_faces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

bool is_box(const CellComplex<3>& cells, std::uint32_t cell) { return cells.corners_of(cell).size() == 8; }

bool has_faces(const CellPaint& paint) { return paint.as == DrawnAs::solid || paint.as == DrawnAs::translucent; }

/// Of a body of its own.
std::uint8_t edge_style(const CellPaint& paint) {
    if (paint.as == DrawnAs::off) return no_style;
    return paint.as == DrawnAs::wireframe ? paint.style : paint.border;
}

/// Whether the cell of `own` draws the face between them; `other` is nullptr at the border of the tessellation.
bool draws_face(const CellPaint& own, const CellPaint* other) {
    if (!other || !has_faces(*other)) return true;
    if (own.as != other->as) return own.as == DrawnAs::solid;
    return own.group < other->group;
}

/// Pairs of corners, each once: a table of open addressing.
class EdgeSet {
public:
    /// Whether the pair is new.
    bool insert(std::uint32_t a, std::uint32_t b) {
        if (a > b) std::swap(a, b);
        if (2 * (size_ + 1) > slots_.size()) grow();
        return put(static_cast<std::uint64_t>(a) << 32 | b);
    }

private:
    static constexpr std::uint64_t empty = ~std::uint64_t{0};

    bool put(std::uint64_t key) {
        std::size_t slot = static_cast<std::size_t>(key * 0x9e3779b97f4a7c15ull >> shift_);
        while (slots_[slot] != empty) {
            if (slots_[slot] == key) return false;
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = key;
        ++size_;
        return true;
    }
    void grow() {
        std::vector<std::uint64_t> old(slots_.size() * 4, empty);
        old.swap(slots_);
        shift_ -= 2;
        size_ = 0;
        for (const std::uint64_t key : old)
            if (key != empty) put(key);
    }

    std::vector<std::uint64_t> slots_ = std::vector<std::uint64_t>(1 << 12, empty);
    int shift_ = 64 - 12;
    std::size_t size_ = 0;
};

class CellSolids {
public:
    CellSolids(const CellComplex<3>& cells, std::span<const CellPaint> paint, SolidList& list)
        : cells_(cells), paint_(paint), list_(list) {}

    void bodies(double shrink) {
        std::size_t points = 0, edges = 0;
        for (std::uint32_t cell = 0; cell < cells_.cell_count(); ++cell) {
            if (has_faces(paint_[cell])) points += is_box(cells_, cell) ? 24u : 12u;
            if (edge_style(paint_[cell]) != no_style) edges += edges_of(cells_, cell).size();
        }
        list_.points.reserve(list_.points.size() + points);
        list_.edge_points.reserve(list_.edge_points.size() + 2 * edges);
        std::array<Vec<3>, 8> corners;
        for (std::uint32_t cell = 0; cell < cells_.cell_count(); ++cell) {
            const CellPaint& paint = paint_[cell];
            if (paint.as == DrawnAs::off) continue;
            std::size_t count = 0;
            for (const std::uint32_t p : cells_.corners_of(cell))
                corners[count++] = shrunk(cells_, cell, cells_.points[p], shrink);
            const auto add_faces = [&](const auto& faces) {
                for (const auto& face : faces) {
                    for (const std::uint8_t corner : face) list_.points.push_back(corners[corner]);
                    end_face(cell);
                }
            };
            if (has_faces(paint)) is_box(cells_, cell) ? add_faces(box_faces) : add_faces(tetrahedron_faces);
            if (const std::uint8_t style = edge_style(paint); style != no_style)
                for (const Edge& edge : edges_of(cells_, cell)) add_edge(corners[edge[0]], corners[edge[1]], style);
        }
    }

    void wire() {
        for (std::uint32_t cell = 0; cell < cells_.cell_count(); ++cell) {
            if (paint_[cell].as != DrawnAs::wireframe) continue;
            const auto corners = cells_.corners_of(cell);
            for (const Edge& edge : edges_of(cells_, cell))
                add_edge_once(corners[edge[0]], corners[edge[1]], paint_[cell].style);
        }
    }

    /// The edges between cells of wire and others.
    void surface() {
        const auto is_wire = [&](std::uint32_t cell) { return cell != none && paint_[cell].as == DrawnAs::wireframe; };
        for (std::uint32_t cell = 0; cell < cells_.cell_count(); ++cell) {
            if (!is_wire(cell)) continue;
            for (const HalfFacet& half : cells_.facets_of(cell)) {
                if (cells_.is_contact(half.facet()) || is_wire(half.neighbour)) continue;
                const auto polygon = cells_.points_of_facet(half.facet());
                for (std::size_t i = 0; i < polygon.size(); ++i)
                    add_edge_once(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1], paint_[cell].style);
            }
        }
    }

    void boundaries() {
        for (std::uint32_t cell = 0; cell < cells_.cell_count(); ++cell) {
            const CellPaint& own = paint_[cell];
            if (!has_faces(own)) continue;
            for (const HalfFacet& half : cells_.facets_of(cell)) {
                if (cells_.is_contact(half.facet())) continue;
                if (!draws_face(own, half.neighbour == none ? nullptr : &paint_[half.neighbour])) continue;
                const auto polygon = cells_.points_of_facet(half.facet());
                for (const std::uint32_t p : polygon) list_.points.push_back(cells_.points[p]);
                end_face(cell);
                if (own.border == no_style) continue;
                for (std::size_t i = 0; i < polygon.size(); ++i)
                    add_edge_once(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1], own.border);
            }
        }
    }

private:
    void end_face(std::uint32_t cell) {
        list_.face_begin.push_back(static_cast<std::uint32_t>(list_.points.size()));
        list_.face_style.push_back(paint_[cell].style);
        list_.face_cell.push_back(cell);
    }
    void add_edge(const Vec<3>& a, const Vec<3>& b, std::uint8_t style) {
        list_.edge_points.push_back(a);
        list_.edge_points.push_back(b);
        list_.edge_style.push_back(style);
    }
    void add_edge_once(std::uint32_t a, std::uint32_t b, std::uint8_t style) {
        if (edges_.insert(a, b)) add_edge(cells_.points[a], cells_.points[b], style);
    }

    const CellComplex<3>& cells_;
    std::span<const CellPaint> paint_;
    SolidList& list_;
    EdgeSet edges_;
};

}  // namespace

std::span<const Edge> edges_of(const CellComplex<3>& cells, std::uint32_t cell) {
    if (is_box(cells, cell)) return box_edges;
    return tetrahedron_edges;
}

std::span<const Edge> edges_of_boxes() { return box_edges; }

void add_boxes(std::span<const Box<3>> boxes, std::span<const CellPaint> paint, SolidList& list) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (has_faces(paint[i]))
            for (const auto& face : box_faces) {
                for (const std::uint8_t corner : face) list.points.push_back(boxes[i].corner(corner));
                list.face_begin.push_back(static_cast<std::uint32_t>(list.points.size()));
                list.face_style.push_back(paint[i].style);
                list.face_cell.push_back(none);
            }
        const std::uint8_t style = edge_style(paint[i]);
        if (style == no_style) continue;
        for (const Edge& edge : box_edges) {
            for (const std::uint8_t corner : edge) list.edge_points.push_back(boxes[i].corner(corner));
            list.edge_style.push_back(style);
        }
    }
}

void add_outline(const CellComplex<3>& cells, std::span<const std::uint8_t> marked, std::uint8_t style, double shrink,
                 SolidList& list) {
    std::vector<CellPaint> paint(marked.size());
    for (std::size_t cell = 0; cell < marked.size(); ++cell)
        if (marked[cell]) paint[cell] = {DrawnAs::wireframe, style, style};
    CellSolids solids(cells, paint, list);
    shrink < 1 ? solids.bodies(shrink) : solids.surface();
}

void add_cells(const CellComplex<3>& cells, std::span<const CellPaint> paint, double shrink, SolidList& list) {
    CellSolids solids(cells, paint, list);
    if (shrink < 1) {
        solids.bodies(shrink);
    } else {
        solids.wire();
        solids.boundaries();
    }
}

}  // namespace sightline
