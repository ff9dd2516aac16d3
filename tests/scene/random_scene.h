// Random scenes and settings for property tests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"
#include "core/settings/settings.h"

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
    s.view_vector = coin() ? ViewVector::eye : ViewVector::camera;
    s.transfer_sign = static_cast<TransferSign>(random.below(3));
    s.on_reenqueue = static_cast<OnReenqueue>(random.below(3));
    s.star_shaped = coin() ? Switch::on : Switch::off;
    s.penalty = static_cast<Penalty>(random.below(3));
    s.penalty_amount = random.uniform(0, 4);
    s.solidity_scale = coin() ? SolidityScale::max : SolidityScale::p95;
    s.outside_view = coin() ? OutsideView::unseen : OutsideView::enqueue;
    s.culled_cost = coin() ? CulledCost::free : CulledCost::charged;
    s.neighbours_before_break = coin() ? YesNo::yes : YesNo::no;
    s.seeds = coin() ? Seeds::one : Seeds::hull;
    constexpr std::array<const char*, 5> methods{"published", "published", "layers", "centroid", "view"};
    s.method = methods[random.below(methods.size())];
    if (coin()) s.budget = {Budget::Kind::primitives, static_cast<double>(random.below(60))};
    return s;
}

}  // namespace sightline::test
