// Triangles in 3D that images find hard. All coordinates are floats held in doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/scene/scene.h"

namespace sightline::test {

inline Vec<3> as_float(const Vec<3>& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// A point of the cube of half side `reach` about p.
inline Vec<3> around(Random& random, const Vec<3>& p, double reach) {
    const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
    return as_float(p + Vec<3>(x, y, random.uniform(-reach, reach)));
}

/// Triangles of all sizes up to `size` about a centre, through each other; every third is seen from both sides.
inline Scene<3> soup(std::size_t count, const Vec<3>& centre, double size, std::uint64_t seed) {
    Random random(seed);
    Scene<3> scene;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<3> middle = around(random, centre, size);
        const double reach = size * std::max(random.unit(), 0.1) * 0.7;
        scene.primitives.push_back(
            {around(random, middle, reach), around(random, middle, reach), around(random, middle, reach)});
        scene.two_sided.push_back(i % 3 == 0);
    }
    return scene;
}

/// Long triangles from a pixel's width down to nothing.
inline Scene<3> slivers(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    Scene<3> scene;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<3> a = around(random, {0, 0, 0}, 1), b = around(random, {0, 0, 0}, 1);
        double width = 0.03;
        for (std::uint64_t k = random.below(12); k > 0; --k) width /= 2;
        scene.primitives.push_back({a, b, around(random, a + (b - a) * random.unit(), width)});
    }
    scene.two_sided.assign(count, 1);
    return scene;
}

/// Triangles that overlap within common planes, axis-parallel ones and others.
inline Scene<3> coplanar(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    Scene<3> scene;
    while (scene.primitives.size() < count) {
        const Vec<3> origin = around(random, {0, 0, 0}, 0.7);
        Vec<3> u = around(random, {0, 0, 0}, 0.7), v = around(random, {0, 0, 0}, 0.7);
        if (random.below(2)) u = {0, u.y, 0}, v = {v.x, v.y, 0};
        const auto point = [&] {
            const double s = random.uniform(-1, 1);
            return as_float(origin + u * s + v * random.uniform(-1, 1));
        };
        for (int k = 0; k < 4; ++k) scene.primitives.push_back({point(), point(), point()});
    }
    scene.two_sided.assign(scene.primitives.size(), 1);
    return scene;
}

/// Twelve triangles whose fronts look outwards, or inwards.
inline void add_box(std::vector<Primitive<3>>& out, const Vec<3>& low, const Vec<3>& high, bool inwards) {
    const auto corner = [&](int i) {
        return as_float({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    };
    constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads)
        for (const int k : {1, 2}) {
            Primitive<3> triangle{corner(q[0]), corner(q[k]), corner(q[k + 1])};
            if (inwards) std::swap(triangle[1], triangle[2]);
            out.push_back(triangle);
        }
}

/// Rooms within rooms about the eye at the origin, each with holes, their half sides from `smallest` to `largest`; and
/// triangles that reach from close by to anywhere, also behind the eye.
inline Scene<3> boxes_around_the_eye(double smallest, double largest, std::uint64_t seed) {
    Random random(seed);
    Scene<3> scene;
    for (double half = smallest; half < largest; half *= 3) {
        std::vector<Primitive<3>> box;
        add_box(box, Vec<3>(-half) * random.uniform(0.5, 1), Vec<3>(half) * random.uniform(0.5, 1), true);
        for (const Primitive<3>& triangle : box)
            if (random.below(12) == 0) scene.primitives.push_back(triangle);
        const Vec<3> near = around(random, {0, 0, 0}, half);
        scene.primitives.push_back({near, around(random, {0, 0, 0}, largest), around(random, near, half)});
    }
    scene.two_sided.assign(scene.primitives.size(), 1);
    return scene;
}

/// Round shells, one in the other, dense like the bodies and engines of cars.
inline Scene<3> shells(int rings, int layers) {
    Scene<3> scene;
    const auto point = [&](int i, int j, double radius) {
        // A rational circle: no sine of the library, which differs between machines.
        const auto circle = [](double t) { return Vec<2>((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)); };
        const double u = static_cast<double>(j % (2 * rings)) / rings * 2 - 2;
        const Vec<2> flat = u < 0 ? circle(u + 1) : -circle(u - 1);
        const Vec<2> up = circle(static_cast<double>(i) / rings * 2 - 1);
        return as_float(Vec<3>(flat * up.x, up.y) * radius);
    };
    for (int layer = 0; layer < layers; ++layer)
        for (int i = 0; i < rings; ++i)
            for (int j = 0; j < 2 * rings; ++j) {
                if ((i * 7 + j * 3 + layer) % 11 == 0) continue;  // windows
                const double radius = 1 - 0.15 * layer;
                const Vec<3> a = point(i, j, radius), b = point(i, j + 1, radius), c = point(i + 1, j, radius),
                             d = point(i + 1, j + 1, radius);
                if (a != b) scene.primitives.push_back({a, b, d});
                if (c != d) scene.primitives.push_back({a, d, c});
            }
    return scene;
}

}  // namespace sightline::test
