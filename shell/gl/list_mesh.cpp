// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/list_mesh.h"

#include <array>
#include <cmath>
#include <span>

#include "shell/gl/triangulate.h"

namespace sightline {

namespace {

/// As in figures, no line is thinner.
constexpr double thinnest_pt = 0.5;
/// Beyond this floats would overflow on their way to the screen.
constexpr double absurd = 1e30;
/// A run of fewer indices is not worth a draw call of its own.
constexpr std::uint32_t short_run = 1536;

std::uint16_t units(double pt) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(pt, 0.0, 1000.0) * mesh_units_per_pt));
}

std::int8_t part(double direction) { return static_cast<std::int8_t>(std::lround(direction * 127)); }

class Builder {
public:
    Builder(const DrawList& list, ListMesh& mesh) : list_(list), mesh_(mesh) {
        mesh_.origin = list.world.empty() ? Vec<2>{} : list.world.centre();
        mesh_.vertices.clear();
        mesh_.indices.clear();
        mesh_.runs.clear();
        // Most lists are cells and single lines.
        mesh_.vertices.reserve(list.shapes.size() * 4);
        mesh_.indices.reserve(list.shapes.size() * 6);
    }

    void add(const Shape& shape) {
        if (shape.style >= list_.styles.size() || shape.point_count == 0 ||
            std::size_t{shape.first_point} + shape.point_count > list_.points.size())
            return;
        const std::span<const Vec<2>> points(list_.points.data() + shape.first_point, shape.point_count);
        for (const Vec<2>& p : points)
            if (!(std::abs(p.x - mesh_.origin.x) < absurd && std::abs(p.y - mesh_.origin.y) < absurd)) return;
        const Style& style = list_.styles[shape.style];
        const double size = shape.size_pt;
        switch (shape.kind) {
            case ShapeKind::polygon:
                if (points.size() < 3) return;
                fill(points, style);
                lines(points, style, true, 0);
                return;
            case ShapeKind::polyline:
                lines(points, style, false, 0);
                return;
            case ShapeKind::disc:
            case ShapeKind::ring:
                if (!(size > 0)) return;
                if (shape.kind == ShapeKind::disc && style.fill.a > 0) {
                    MeshVertex disc = vertex(Paint::solid, style.fill);
                    disc.half_width = units(size);
                    quad(disc, points[0], points[0], {1, 0});
                }
                if (style.stroke.a > 0) mark(Paint::ring, style, size, points[0], {1, 0});
                return;
            case ShapeKind::cross:
                if (!(size > 0) || style.stroke.a == 0) return;
                for (const double y : {1.0, -1.0})
                    mark(Paint::bar, style, 2 * std::sqrt(2.0) * size, points[0], Vec<2>(1, y) * std::sqrt(0.5));
                return;
            case ShapeKind::arrow:
                if (style.stroke.a > 0) arrow(points, style, size > 0 ? size : std::max(4.0, 4 * style.width_pt));
                return;
        }
    }

private:
    static MeshVertex vertex(Paint paint, const Colour& colour) {
        MeshVertex v;
        v.paint = paint;
        v.colour = colour;
        return v;
    }

    void place(MeshVertex& v, const Vec<2>& at) const {
        v.x = static_cast<float>(at.x - mesh_.origin.x);
        v.y = static_cast<float>(at.y - mesh_.origin.y);
    }

    /// Says that `count` indices of this kind follow those that there are.
    void extend(MeshRun::Kind kind, bool opaque, std::uint32_t count) {
        auto& runs = mesh_.runs;
        const auto first = static_cast<std::uint32_t>(mesh_.indices.size());
        if (runs.empty()) runs.push_back({kind, opaque, first, 0});
        MeshRun& last = runs.back();
        if (last.kind == kind) {
            last.opaque &= opaque;
            last.count += count;
        } else if (last.count < short_run) {
            last.kind = MeshRun::Kind::mixed;
            last.opaque = false;
            last.count += count;
            if (runs.size() > 1 && runs[runs.size() - 2].kind == MeshRun::Kind::mixed) {
                runs[runs.size() - 2].count += last.count;
                runs.pop_back();
            }
        } else {
            runs.push_back({kind, opaque, first, count});
        }
    }

    void fill(std::span<const Vec<2>> points, const Style& style) {
        const bool hatched = style.hatch != Hatch::none && style.hatch_colour.a > 0;
        if (style.fill.a == 0 && !hatched) return;
        triangles_.clear();
        triangulate(points, triangles_);
        extend(MeshRun::Kind::fills, style.fill.a == 255, static_cast<std::uint32_t>(triangles_.size()));
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        MeshVertex v = vertex(Paint::fill, style.fill);
        if (hatched) {
            v.second = style.hatch_colour;
            v.corner = static_cast<std::uint8_t>(style.hatch);
        }
        for (const Vec<2>& p : points) {
            place(v, p);
            mesh_.vertices.push_back(v);
        }
        for (const std::uint32_t i : triangles_) mesh_.indices.push_back(first + i);
    }

    /// The four corners of a line or a mark; `v` says all but their places.
    void quad(MeshVertex v, const Vec<2>& from, const Vec<2>& to, const Vec<2>& direction) {
        const bool plain = v.paint == Paint::solid && v.size == 0;
        extend(plain ? MeshRun::Kind::lines : MeshRun::Kind::mixed, false, 6);
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        v.dx = part(direction.x);
        v.dy = part(direction.y);
        std::array<MeshVertex, 4> corners;
        for (std::uint8_t corner = 0; corner < 4; ++corner) {
            v.corner = corner;
            place(v, corner & 1 ? to : from);
            corners[corner] = v;
        }
        mesh_.vertices.insert(mesh_.vertices.end(), corners.begin(), corners.end());
        mesh_.indices.insert(mesh_.indices.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
    }

    MeshVertex line_vertex(Paint paint, const Style& style) const {
        MeshVertex v = vertex(paint, style.stroke);
        v.half_width = units(std::max(style.width_pt, thinnest_pt) / 2);
        return v;
    }

    void mark(Paint paint, const Style& style, double size, const Vec<2>& at, const Vec<2>& direction) {
        MeshVertex v = line_vertex(paint, style);
        v.size = units(size);
        quad(v, at, at, direction);
    }

    /// The lines between the points, and back to the first where `closed`; the last is `shorter_pt` shorter.
    void lines(std::span<const Vec<2>> points, const Style& style, bool closed, double shorter_pt) {
        if (points.size() < 2 || style.stroke.a == 0) return;
        constexpr std::array paints{Paint::solid, Paint::dashed, Paint::dotted};
        MeshVertex v = line_vertex(paints[static_cast<std::size_t>(style.dash)], style);
        double start = 0;
        const std::size_t count = closed ? points.size() : points.size() - 1;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec<2>&a = points[i], &b = points[i + 1 < points.size() ? i + 1 : 0];
            const double length = glm::length(b - a);
            v.length = static_cast<float>(length);
            v.start = static_cast<float>(start);
            if (i + 1 == count) v.size = units(shorter_pt);
            quad(v, a, b, length > 0 ? (b - a) / length : Vec<2>(1, 0));
            start += length;
        }
    }

    void arrow(std::span<const Vec<2>> points, const Style& style, double head) {
        while (points.size() > 1 && points[points.size() - 2] == points.back())
            points = points.first(points.size() - 1);
        if (points.size() < 2) return;
        // The line ends inside the head, or its round end would blunt the tip.
        lines(points, style, false, 0.8 * head);
        const Vec<2> along = points.back() - points[points.size() - 2];
        mark(Paint::head, style, head, points.back(), along / glm::length(along));
    }

    const DrawList& list_;
    ListMesh& mesh_;
    std::vector<std::uint32_t> triangles_;
};

}  // namespace

void make_mesh(const DrawList& list, ListMesh& mesh) {
    Builder builder(list, mesh);
    for (const Shape& shape : list.shapes) builder.add(shape);
}

}  // namespace sightline
