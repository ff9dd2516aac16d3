// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/model.h"

#include <array>

namespace sightline {

void Model::polygon(std::span<const Vec<3>> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) triangle(corners[0], corners[i - 1], corners[i]);
}

void Model::box(const Vec<3>& low, const Vec<3>& high, unsigned sides) {
    // Corner i takes x, y, z from `high` where bits 0, 1, 2 of i are set.
    const auto corner = [&](unsigned i) {
        return Vec<3>((i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z);
    };
    static constexpr std::array<std::array<unsigned, 4>, 6> faces = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (unsigned f = 0; f < 6; ++f)
        if (sides >> f & 1)
            polygon({corner(faces[f][0]), corner(faces[f][1]), corner(faces[f][2]), corner(faces[f][3])});
}

void Model::turned_solid(const Vec<3>& foot, const Vec<3>& axis, std::span<const Vec<2>> profile, int corners) {
    // Any two directions square to the axis and to each other, so that (u, v, axis) is right-handed.
    const Vec<3> helper = std::abs(axis.z) < 0.9 ? Vec<3>(0, 0, 1) : Vec<3>(1, 0, 0);
    Vec<3> u = glm::cross(helper, axis);
    u /= std::sqrt(glm::dot(u, u));
    const Vec<3> v = glm::cross(axis, u);
    std::vector<Vec<3>> outward;
    for (int i = 0; i <= corners; ++i) {
        const SinCos turn = sincos_degrees(360.0 * (i % corners) / corners);
        outward.push_back(turn.cos * u + turn.sin * v);
    }
    const auto ring_point = [&](const Vec<2>& p, int i) {
        return foot + axis * p.y + p.x * outward[static_cast<std::size_t>(i)];
    };
    for (std::size_t k = 1; k < profile.size(); ++k)
        for (int i = 0; i < corners; ++i) {
            const Vec<2>&low = profile[k - 1], &high = profile[k];
            if (low.x > 0) triangle(ring_point(low, i), ring_point(low, i + 1), ring_point(high, i + 1));
            if (high.x > 0) triangle(ring_point(low, i), ring_point(high, i + 1), ring_point(high, i));
        }
}

void Model::rod(const Vec<3>& a, const Vec<3>& b, double radius, int corners) {
    const double length = std::sqrt(glm::dot(b - a, b - a));
    turned_solid(a, (b - a) / length, {{0, 0}, {radius, 0}, {radius, length}, {0, length}}, corners);
}

void Model::bent_rod(const Vec<3>& a, const Vec<3>& corner, const Vec<3>& c, double radius, int pieces, int corners) {
    // One direction square to all of the curve, which lies in a plane.
    Vec<3> across = glm::cross(corner - a, c - corner);
    across /= std::sqrt(glm::dot(across, across));
    std::vector<Vec<3>> before, ring(static_cast<std::size_t>(corners));
    for (int piece = 0; piece <= pieces; ++piece) {
        const double t = static_cast<double>(piece) / pieces;
        Vec<3> along = (1 - t) * (corner - a) + t * (c - corner);
        along /= std::sqrt(glm::dot(along, along));
        const Vec<3> middle = (1 - t) * (1 - t) * a + 2 * t * (1 - t) * corner + t * t * c;
        const Vec<3> up = glm::cross(along, across);
        for (int i = 0; i < corners; ++i) {
            const SinCos turn = sincos_degrees(360.0 * i / corners);
            ring[static_cast<std::size_t>(i)] = middle + radius * (turn.cos * across + turn.sin * up);
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            const std::size_t next = (i + 1) % before.size();
            polygon({before[i], before[next], ring[next], ring[i]});
        }
        before = ring;
    }
}

Inside::Inside(Model& model, const Vec<3>& origin, double degrees)
    : model_(model), outer_plan_(model.plan), outer_height_(model.height) {
    const Placement inner = turned({0, 0}, degrees);
    model.plan = {outer_plan_.at({origin.x, origin.y}), outer_plan_.cos * inner.cos - outer_plan_.sin * inner.sin,
                  outer_plan_.sin * inner.cos + outer_plan_.cos * inner.sin};
    model.height = outer_height_ + origin.z;
}

Inside::~Inside() {
    model_.plan = outer_plan_;
    model_.height = outer_height_;
}

}  // namespace sightline
