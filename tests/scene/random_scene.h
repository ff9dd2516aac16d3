// Random scenes and settings for property tests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/base/number.h"
#include "core/base/random.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"
#include "core/session/settings.h"

namespace sightline::test {

/// `count` segments, on a coarse integer grid (touching, crossing, aligned with cells) or with random coordinates.
inline Scene<2> random_scene(Random& random, std::size_t count) {
    Scene<2> scene;
    const bool on_grid = random.below(2) == 0;
    while (scene.primitives.size() < count) {
        Primitive<2> s;
        if (on_grid) {
            for (Vec<2>& p : s) p = Vec<2>(random.below(17), random.below(17)) / 16.0;
        } else {
            s[0] = {random.unit(), random.unit()};
            s[1] = s[0] + Vec<2>(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
        }
        if (s[0] != s[1]) scene.primitives.push_back(s);
    }
    return scene;
}

/// `count` triangles: small ones, needles, some as large as the scene, axis-aligned ones on a coarse grid. Coordinates
/// are multiples of 2^-20, so that sums of few of them are exact.
inline Scene<3> random_scene_3d(Random& random, std::size_t count) {
    Scene<3> scene;
    const auto grid = [](double x) { return std::floor(x * 0x1p20) * 0x1p-20; };
    const auto point = [&] { return Vec<3>(grid(random.unit()), grid(random.unit()), grid(random.unit())); };
    const auto near = [&](const Vec<3>& p, double reach) {
        return p + Vec<3>(grid(random.uniform(-reach, reach)), grid(random.uniform(-reach, reach)),
                          grid(random.uniform(-reach, reach)));
    };
    const std::uint64_t kinds = 1 + random.below(4);
    while (scene.primitives.size() < count) {
        Primitive<3> t{point(), point(), point()};
        switch (random.below(kinds)) {
            case 0:
                t[1] = near(t[0], 0.05);
                t[2] = near(t[0], 0.05);
                break;
            case 1:  // a needle
                t[2] = near(t[1], 0x1p-18);
                break;
            case 2:
                for (Vec<3>& p : t) p = glm::floor(p * 8.0) / 8.0;
                t[1][static_cast<int>(random.below(3))] = t[0][static_cast<int>(random.below(3))];
                if (random.below(2)) t[0].z = t[1].z = t[2].z;
                break;
            default:  // as large as the scene
                break;
        }
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) scene.primitives.push_back(t);
    }
    return scene;
}

inline ViewSpec<2> random_view(Random& random) {
    const double reach = random.below(4) == 0 ? 2.5 : 1;  // sometimes well outside
    const auto coordinate = [&] {
        return random.below(3) == 0 ? static_cast<double>(random.below(17)) / 16 : random.uniform(1 - reach, reach);
    };
    ViewSpec<2> view{{coordinate(), coordinate()}, {random.uniform(0.2, 0.8), random.uniform(0.2, 0.8)}, 60};
    if (view.look_at == view.eye) view.look_at.x += 1;
    view.fov = random.below(4) == 0 ? 360 : random.uniform(10, 170);
    return view;
}

inline Settings random_settings(Random& random) {
    const auto coin = [&] { return random.below(2) == 0; };
    Settings s;
    s.tessellation = coin() ? Tessellation::delaunay : Tessellation::tree;
    s.error_bound = coin() ? 0.05 : 0.2;
    s.border = random.below(4) == 0 ? Border::none : Border::inflated;
    s.jitter = random.below(4) == 0 ? 0 : 0.02;
    s.seed = random.below(100);
    const auto set = [&](const ParameterRow& row, std::string_view value) { s.parameters.set(row, value); };
    const auto word_of = [&](const ParameterRow& row) { return row.words[random.below(row.words.size())]; };
    const auto coin_of = [&](const ParameterRow& row) { return row.words[coin() ? 0 : 1]; };
    set(view_vector_row(), coin_of(view_vector_row()));
    set(transfer_sign_row(), word_of(transfer_sign_row()));
    set(on_reenqueue_row(), word_of(on_reenqueue_row()));
    set(star_shaped_row(), coin() ? "on" : "off");
    set(penalty_row(), word_of(penalty_row()));
    set(penalty_amount_row(), number_text(random.uniform(0, 4)));
    set(solidity_scale_row(), coin_of(solidity_scale_row()));
    set(outside_view_row(), coin_of(outside_view_row()));
    set(culled_cost_row(), coin_of(culled_cost_row()));
    set(neighbours_before_break_row(), coin() ? "yes" : "no");
    set(seeds_row(), coin_of(seeds_row()));
    constexpr std::array<const char*, 5> methods{"published", "published", "layers", "centroid", "view"};
    s.method = methods[random.below(methods.size())];
    if (coin()) s.budget = {Budget::Kind::primitives, static_cast<double>(random.below(60))};
    return s;
}

/// The same, with kd cells, neighbours that touch, and what else stands beside the papers' form.
inline Settings random_wide_settings(Random& random) {
    Settings s = random_settings(random);
    if (random.below(3) == 0) s.tessellation = Tessellation::kd;
    if (random.below(3) == 0) s.neighbours = Neighbours::touching;
    if (random.below(3) == 0) s.empty_leaves = random.below(2) == 0 ? EmptyLeaves::drop : EmptyLeaves::merge;
    if (random.below(3) == 0) s.split_for = SplitFor::opacity;
    if (random.below(3) == 0) s.leaf_capacity = static_cast<std::uint32_t>(1 + random.below(10));
    if (random.below(3) == 0) s.parameters.set(own_content_row(), "on");
    if (random.below(3) == 0) s.parameters.set(budget_counts_row(), "per_cell");
    return s;
}

}  // namespace sightline::test
