// Levels of detail: how far they lie from their objects, what they leave out, and that threads decide nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/levels.h"

#include <gtest/gtest.h>

#include "core/scene/make/catalogue.h"
#include "core/space/builders.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

Vec<2> point_on(Random& random, const Primitive<2>& s) { return s[0] + (s[1] - s[0]) * random.uniform(0, 1); }
Vec<3> point_on(Random& random, const Primitive<3>& t) {
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return t[0] + (t[1] - t[0]) * u + (t[2] - t[0]) * v;
}

double away_from(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b) {
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(p - (a + (b - a) * t));
}
double away_from(const Vec<3>& p, const Vec<3>& a, const Vec<3>& b) {
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(p - (a + (b - a) * t));
}
double away_from(const Vec<2>& p, const Primitive<2>& s) { return away_from(p, s[0], s[1]); }
double away_from(const Vec<3>& p, const Primitive<3>& t) {
    const Vec<3> normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double length = glm::length(normal);
    if (length > 0) {
        const Vec<3> n = normal / length, foot = p - n * glm::dot(n, p - t[0]);
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i)
            inside = inside && glm::dot(glm::cross(t[(i + 1) % 3] - t[i], foot - t[i]), normal) >= 0;
        if (inside) return std::abs(glm::dot(n, p - t[0]));
    }
    return std::min({away_from(p, t[0], t[1]), away_from(p, t[1], t[2]), away_from(p, t[2], t[0])});
}
template <int D>
double away_from(const Vec<D>& p, const std::vector<Primitive<D>>& all) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Primitive<D>& primitive : all) nearest = std::min(nearest, away_from(p, primitive));
    return nearest;
}

/// One object: chains that cross, loops and loose ends, or a bent sheet, a rod, leaves and specks.
Scene<2> one_object(Random& random, Vec<2>) {
    Scene<2> scene;
    const auto chain = [&](Vec<2> at, int count, double step, bool closed) {
        const Vec<2> first = at;
        double turn = random.uniform(0, 6);
        for (int i = 0; i < count; ++i) {
            turn += random.uniform(-0.4, 0.4);
            const Vec<2> next = closed && i == count - 1 ? first : at + Vec<2>(std::cos(turn), std::sin(turn)) * step;
            if (next != at) scene.primitives.push_back({at, next});
            at = next;
        }
    };
    for (int i = 0; i < 3; ++i)
        chain({random.uniform(0, 1), random.uniform(0, 1)}, 2 + static_cast<int>(random.below(60)),
              random.uniform(0.01, 0.05), random.below(2) == 0);
    const Vec<2> on = scene.primitives[scene.primitives.size() / 2][0];  // a crossing
    chain(on, 20, 0.03, false);
    scene.objects.names = {"one"};
    scene.objects.of.assign(scene.primitives.size(), 0);
    return scene;
}
Scene<3> one_object(Random& random, Vec<3>) {
    Scene<3> scene;
    const auto quad = [&](const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d, bool both) {
        scene.primitives.push_back({a, b, c});
        scene.primitives.push_back({a, c, d});
        scene.two_sided.insert(scene.two_sided.end(), 2, both);
    };
    const int n = 4 + static_cast<int>(random.below(12));
    const double bend = random.uniform(0, 0.5);
    const auto at = [&](int i, int j) {
        const double x = double(i) / n, y = double(j) / n;
        return Vec<3>(x, y, bend * std::sin(5 * x) * std::cos(3 * y));
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), false);
    for (int i = 0; i < 12; ++i) {  // a rod, far from all else
        const double z = 1 + 0.1 * i;
        quad({2, 2, z}, {2.002, 2, z}, {2.002, 2, z + 0.1}, {2, 2, z + 0.1}, false);
    }
    for (int i = 0; i < 20; ++i) {
        const Vec<3> p(random.uniform(0, 1), random.uniform(0, 1), random.uniform(1, 2));
        const Vec<3> u(random.uniform(-.1, .1), random.uniform(-.1, .1), random.uniform(-.1, .1));
        const Vec<3> v(random.uniform(-.1, .1), random.uniform(-.1, .1), random.uniform(-.1, .1));
        quad(p, p + u, p + u + v, p + v, true);
    }
    scene.objects.names = {"one"};
    scene.objects.of.assign(scene.primitives.size(), 0);
    return scene;
}

template <int D>
std::vector<Primitive<D>> level_primitives(const Levels<D>& levels, const Level& level) {
    return {levels.primitives.begin() + level.begin, levels.primitives.begin() + level.end};
}

template <int D>
void expect_errors() {
    Random random(70 + D);
    std::size_t checked = 0;
    double nearest_to_bound = 0;
    for (int round = 0; round < test::soak_count(D == 2 ? 40 : 12); ++round) {
        const Scene<D> scene = one_object(random, Vec<D>(0));
        const Levels<D> levels = build_levels(scene);
        ASSERT_FALSE(levels.levels.empty());
        std::uint32_t before = static_cast<std::uint32_t>(scene.primitives.size());
        double error = -1;
        for (const Level& level : levels.of(0)) {
            ASSERT_LE(level.count() * 4, before * (D == 2 ? 3 : 2));
            ASSERT_GT(level.count(), 0u);
            ASSERT_GT(level.error, error);
            before = level.count();
            error = level.error;
            const auto coarse = level_primitives(levels, level);
            double largest = 0;
            for (int i = 0; i < 300; ++i) {
                const Vec<D> of_object = point_on(random, scene.primitives[random.below(scene.primitives.size())]);
                const Vec<D> of_level = point_on(random, coarse[random.below(coarse.size())]);
                largest =
                    std::max({largest, away_from<D>(of_object, coarse), away_from<D>(of_level, scene.primitives)});
                for (const Primitive<D>& p : coarse)
                    for (const Vec<D>& corner : p) ASSERT_TRUE(levels.boxes[0].contains(corner));
            }
            if (D == 2)  // of chains the points that are left out are the farthest
                for (const Primitive<D>& p : scene.primitives) largest = std::max(largest, away_from<D>(p[0], coarse));
            ASSERT_LE(largest, level.error * (1 + 1e-9) + 1e-12);
            if (level.error > 0) nearest_to_bound = std::max(nearest_to_bound, largest / level.error);
            ++checked;
        }
    }
    EXPECT_GT(checked, 20u);
    EXPECT_GT(nearest_to_bound, D == 2 ? 0.999999 : 0.3) << "a bound that is nowhere near says little";
}
TEST(Levels, LieAsFarFromTheirObjectAsTheySay2d) { expect_errors<2>(); }
TEST(Levels, LieAsFarFromTheirObjectAsTheySay3d) { expect_errors<3>(); }

template <int D>
void expect_the_same_from_any_threads(const Scene<D>& scene) {
    const Levels<D> one = build_levels(scene, 1), all = build_levels(scene, 0);
    EXPECT_GT(one.levels.size(), 10u) << scene.id;
    EXPECT_EQ(one.first, all.first);
    EXPECT_EQ(one.levels, all.levels);
    EXPECT_EQ(one.primitives, all.primitives);
    EXPECT_EQ(one.two_sided, all.two_sided);
    ASSERT_EQ(one.first.size(), std::size_t{one.object_count()} + 1);
    for (std::uint32_t object = 0; object < one.object_count(); ++object) {
        EXPECT_FALSE(one.primitives_of(object).empty());
        if (one.primitives_of(object).size() < least_object) {
            EXPECT_TRUE(one.of(object).empty());
        }
    }
}
TEST(Levels, DependOnNoThread) {
    Random random(5);
    Scene<2> flat;
    for (int i = 0; i < 30; ++i) {
        const Scene<2> one = one_object(random, Vec<2>(0));
        flat.objects.names.push_back(std::to_string(i));
        flat.primitives.insert(flat.primitives.end(), one.primitives.begin(), one.primitives.end());
        flat.objects.of.insert(flat.objects.of.end(), one.primitives.size(), static_cast<std::uint32_t>(i));
    }
    expect_the_same_from_any_threads(flat);
    for (const char* name : {"city", "jungle", "cars"})
        expect_the_same_from_any_threads(make_scene(*find_in_catalogue<3>(name), 20'000));
}

TEST(Levels, StandBehindThePrimitivesOfTheScene) {
    const Scene<3> scene = make_scene(*find_in_catalogue<3>("jungle"), 5000);
    const CellComplex<3> cells = build_cells(scene, TessellationSettings{});
    const auto levels = levels_of(cells, scene);
    const auto all = scene_with_levels(cells, scene);
    EXPECT_EQ(levels, levels_of(cells, scene)) << "made twice";
    ASSERT_EQ(all->primitives.size(), scene.primitives.size() + levels->primitives.size());
    ASSERT_EQ(all->two_sided.size(), all->primitives.size());
    ASSERT_EQ(all->objects.of.size(), all->primitives.size());
    EXPECT_TRUE(std::equal(scene.primitives.begin(), scene.primitives.end(), all->primitives.begin()));
    std::size_t both = 0;
    for (std::uint32_t object = 0; object < levels->object_count(); ++object)
        for (const Level& level : levels->of(object))
            for (std::uint32_t i = level.begin; i < level.end; ++i) {
                EXPECT_EQ(all->primitives[scene.primitives.size() + i], levels->primitives[i]);
                EXPECT_EQ(all->objects.of[scene.primitives.size() + i], object);
                both += levels->two_sided[i];
            }
    EXPECT_GT(both, levels->primitives.size() / 2) << "leaves are seen from both sides";
}

}  // namespace
}  // namespace sightline
