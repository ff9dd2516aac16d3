// Solid lists that tests and the benchmark share: boxes, tetrahedra, a town cut into cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>

#include "core/base/random.h"
#include "core/draw/solid_list.h"

namespace sightline::test {

inline void add_face(SolidList& list, std::uint8_t style, std::initializer_list<Vec<3>> corners) {
    list.points.insert(list.points.end(), corners);
    list.face_begin.push_back(static_cast<std::uint32_t>(list.points.size()));
    list.face_style.push_back(style);
    list.face_cell.push_back(0);
}

inline void add_edge(SolidList& list, std::uint8_t style, const Vec<3>& from, const Vec<3>& to) {
    list.edge_points.insert(list.edge_points.end(), {from, to});
    list.edge_style.push_back(style);
}

/// Twelve triangles, fronts outwards.
inline void add_box(std::vector<Primitive<3>>& triangles, const Vec<3>& low, const Vec<3>& high) {
    const auto corner = [&](int i) {
        return Vec<3>(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    constexpr std::array<std::array<int, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& s : sides) {
        triangles.push_back({corner(s[0]), corner(s[1]), corner(s[2])});
        triangles.push_back({corner(s[0]), corner(s[2]), corner(s[3])});
    }
}

/// Houses on a plate of 100 x 100, about this many triangles.
inline std::shared_ptr<const Scene<3>> box_town(std::size_t triangles) {
    Random random(4);
    Scene<3> scene;
    add_box(scene.primitives, {0, 0, -1}, {100, 100, 0});
    while (scene.primitives.size() < triangles) {
        const Vec<3> at(random.uniform(1, 97), random.uniform(1, 97), 0);
        const double side = random.uniform(0.3, 2.5);
        add_box(scene.primitives, at, at + Vec<3>(side, side, random.uniform(0.5, 9)));
    }
    return std::make_shared<const Scene<3>>(std::move(scene));
}

/// All triangles of the scene in one style.
inline void show_scene(SolidList& list, std::uint8_t style, std::shared_ptr<const Scene<3>> scene) {
    list.scene = std::move(scene);
    list.triangles.resize(list.scene->primitives.size());
    for (std::uint32_t i = 0; i < list.triangles.size(); ++i) list.triangles[i] = i;
    list.runs = {{style, 0, static_cast<std::uint32_t>(list.triangles.size())}};
}

/// A block of 6 side³ jittered tetrahedra: those near one corner are style 0, a ragged layer around them style 1, whose
/// edges are style 2, and the rest is not shown. Faces between tetrahedra of one style are left out.
inline void add_tetrahedra(SolidList& list, int side, double ragged, const Vec<3>& low, const Vec<3>& high) {
    Random random(8);
    const int n = side + 1;
    std::vector<Vec<3>> points;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const Vec<3> jitter(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
                points.push_back(low + (high - low) * ((Vec<3>(i, j, k) + jitter) / static_cast<double>(side)));
            }
    const auto index = [&](int i, int j, int k) { return static_cast<std::uint32_t>((k * n + j) * n + i); };
    constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    std::map<std::array<std::uint32_t, 3>, std::vector<int>> sides;  ///< a face and the states on both sides
    std::map<std::array<std::uint32_t, 2>, int> edges;
    for (int k = 0; k < side; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
                for (const auto& order : orders) {
                    int at[3] = {i, j, k};
                    std::array<std::uint32_t, 4> corners{index(i, j, k)};
                    for (int step = 0; step < 3; ++step) {
                        ++at[order[step]];
                        corners[static_cast<std::size_t>(step) + 1] = index(at[0], at[1], at[2]);
                    }
                    std::sort(corners.begin(), corners.end());
                    const Vec<3> from_low = Vec<3>(i, j, k) / static_cast<double>(side);
                    const double reach = std::sqrt(glm::dot(from_low, from_low)) + random.uniform(-ragged, ragged);
                    const int state = reach < 0.5 ? 0 : reach < 1.35 ? 1 : 2;
                    for (std::size_t out = 0; out < 4; ++out) {
                        std::array<std::uint32_t, 3> face{};
                        for (std::size_t c = 0, f = 0; c < 4; ++c)
                            if (c != out) face[f++] = corners[c];
                        sides[face].push_back(state);
                    }
                    if (state == 1)
                        for (std::size_t a = 0; a < 4; ++a)
                            for (std::size_t b = a + 1; b < 4; ++b) edges[{corners[a], corners[b]}] = 2;
                }
    for (const auto& [face, states] : sides) {
        const int one = states[0], other = states.size() > 1 ? states[1] : 2;
        if (one == other || std::min(one, other) == 2) continue;
        add_face(list, static_cast<std::uint8_t>(std::min(one, other)),
                 {points[face[0]], points[face[1]], points[face[2]]});
    }
    for (const auto& [edge, style] : edges)
        add_edge(list, static_cast<std::uint8_t>(style), points[edge[0]], points[edge[1]]);
}

}  // namespace sightline::test
