// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/projection.h"

namespace sightline {

namespace {

/// What lies no further than this before the eye, in distances to look_at, counts as behind it.
constexpr double nearest = 1e-6;
/// Lines are drawn as far as this beside the picture, in its heights: files take no coordinates of any size.
constexpr double margin = 0.5;

/// A point before the division by its depth: the picture shows it at (x, y) / depth. All three are linear in the point.
struct Homogeneous {
    double x, y, depth;
};

struct Axes {
    Vec<3> forward, right, up;  ///< to look_at, along the lower and the left side of the picture
    double aspect;

    explicit Axes(const View<3>& view)
        : forward(view.look_at - view.eye),
          right(view.corners[1] - view.corners[0]),
          up(view.corners[3] - view.corners[0]),
          aspect(std::sqrt(glm::dot(right, right) / glm::dot(up, up))) {}

    Homogeneous of(const View<3>& view, const Vec<3>& p) const {
        const Vec<3> d = p - view.eye;
        const double depth = glm::dot(d, forward) / glm::dot(forward, forward);
        const Vec<3> from_corner = d - (view.corners[0] - view.eye) * depth;
        return {glm::dot(from_corner, right) / glm::dot(right, right) * aspect,
                glm::dot(from_corner, up) / glm::dot(up, up), depth};
    }
};

}  // namespace

Box<2> picture_plane(const View<3>& view) { return {{0, 0}, {Axes(view).aspect, 1}}; }

double depth(const View<3>& view, const Vec<3>& p) {
    const Vec<3> forward = view.look_at - view.eye;
    return glm::dot(p - view.eye, forward) / glm::dot(forward, forward);
}

std::optional<Vec<2>> project(const View<3>& view, const Vec<3>& p) {
    const Homogeneous h = Axes(view).of(view, p);
    if (!(h.depth > nearest)) return std::nullopt;
    return Vec<2>(h.x, h.y) / h.depth;
}

std::optional<ProjectedLine> project_line(const View<3>& view, const Vec<3>& a, const Vec<3>& b) {
    const Axes axes(view);
    const Homogeneous p = axes.of(view, a), q = axes.of(view, b);
    // Liang and Barsky's clipping: the part from `begin` to `end` is where all distances are >= 0.
    double begin = 0, end = 1;
    const auto clip = [&](double at_p, double at_q) {
        if (at_p < 0 && at_q < 0) begin = 2;
        if (at_p < 0 && at_q >= 0) begin = std::max(begin, at_p / (at_p - at_q));
        if (at_p >= 0 && at_q < 0) end = std::min(end, at_p / (at_p - at_q));
    };
    const auto right_of = [&](const Homogeneous& h) { return h.x + margin * h.depth; };
    const auto left_of = [&](const Homogeneous& h) { return (axes.aspect + margin) * h.depth - h.x; };
    const auto above = [&](const Homogeneous& h) { return h.y + margin * h.depth; };
    const auto below = [&](const Homogeneous& h) { return (1 + margin) * h.depth - h.y; };
    clip(p.depth - nearest, q.depth - nearest);
    clip(right_of(p), right_of(q));
    clip(left_of(p), left_of(q));
    clip(above(p), above(q));
    clip(below(p), below(q));
    if (!(begin <= end)) return std::nullopt;
    const auto at = [&](double t) {
        const double depth = p.depth + (q.depth - p.depth) * t;
        return Vec<2>(p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t) / depth;
    };
    return ProjectedLine{at(begin), at(end), end == 1};
}

}  // namespace sightline
