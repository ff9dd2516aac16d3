// Objects: names that can be shown, parts that hang together, and what cleaning does to them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/objects.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/base/index.h"
#include "core/base/random.h"
#include "core/scene/clean.h"

namespace sightline {
namespace {

TEST(Objects, TidyNamesAreShortPlainAndDifferentAndNoneIsWithoutPrimitives) {
    Objects objects{{"wall", "nothing", "", "wall", "a\x1b[31m\nb", "wall (2)"}, {0, 2, 3, 3, 4, 5, 0}};
    tidy(objects);
    ASSERT_EQ(objects.names.size(), 5u);
    EXPECT_EQ(objects.names[0], "wall");
    EXPECT_EQ(objects.names[1], "unnamed");
    EXPECT_EQ(objects.names[2], "wall (2)");
    for (const std::string& name : objects.names)
        for (const char c : name) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << name;
    EXPECT_EQ(std::set<std::string>(objects.names.begin(), objects.names.end()).size(), 5u);
    EXPECT_EQ(objects.of, (std::vector<std::uint32_t>{0, 1, 2, 2, 3, 4, 0}));
    EXPECT_EQ(object_named(objects, "wall (2)"), 2u);
    EXPECT_EQ(object_named(objects, "nothing"), none);
}

/// Repeats joining neighbours until nothing changes: slow and plain.
template <int D>
std::vector<std::uint32_t> parts_by_flooding(const std::vector<Primitive<D>>& primitives) {
    std::vector<std::uint32_t> part(primitives.size());
    for (std::uint32_t i = 0; i < part.size(); ++i) part[i] = i;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < part.size(); ++i)
            for (std::size_t j = 0; j < part.size(); ++j)
                for (const Vec<D>& p : primitives[i])
                    for (const Vec<D>& q : primitives[j])
                        if (p == q && part[j] < part[i]) {
                            part[i] = part[j];
                            changed = true;
                        }
    }
    return part;
}

template <int D>
void expect_parts_as_flooded(std::uint64_t seed) {
    Random random(seed);
    std::vector<Primitive<D>> primitives(1 + random.below(40));
    for (Primitive<D>& primitive : primitives)
        for (Vec<D>& p : primitive)
            for (int i = 0; i < D; ++i) p[i] = static_cast<double>(random.below(5)) - 2;  // corners often meet
    const Objects objects = connected_parts<D>(primitives);
    const std::vector<std::uint32_t> expected = parts_by_flooding<D>(primitives);
    ASSERT_EQ(objects.of.size(), primitives.size());
    std::uint32_t seen = 0;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        EXPECT_LE(objects.of[i], seen);  // numbered by their first primitive
        seen = std::max(seen, objects.of[i] + 1);
        for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(objects.of[i] == objects.of[j], expected[i] == expected[j]);
    }
    EXPECT_EQ(objects.names.size(), seen);
    EXPECT_EQ(objects.names.front(), "part 1");
}

TEST(Objects, PartsAreWhatHangsTogetherByCorners) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        expect_parts_as_flooded<2>(seed);
        expect_parts_as_flooded<3>(seed);
    }
    EXPECT_TRUE(connected_parts<3>({}).empty());
}

TEST(Objects, RowsListThePrimitivesOfEach) {
    const Objects objects{{"a", "b", "c"}, {2, 0, 2, 1, 0}};
    const ObjectRows rows = primitives_of_objects(objects);
    EXPECT_EQ(rows.first, (std::vector<std::uint32_t>{0, 2, 3, 5}));
    EXPECT_EQ(rows.ids, (std::vector<std::uint32_t>{1, 4, 3, 0, 2}));
}

/// What cleaning leaves belongs to the object that it belonged to before.
template <int D>
void expect_kept_in_step(std::uint64_t seed) {
    Random random(seed);
    Scene<D> scene;
    scene.objects.names = {"o0", "o1", "o2", "o3"};
    for (int k = 0; k < 60; ++k) {
        const std::size_t object = random.below(3);  // o3 is left without any
        Primitive<D> primitive;
        for (Vec<D>& p : primitive)
            for (int i = 0; i < D; ++i) p[i] = static_cast<double>(10 * object + random.below(3));
        if (random.below(10) == 0) primitive[0][0] = std::numeric_limits<double>::quiet_NaN();
        scene.primitives.push_back(primitive);
        scene.objects.of.push_back(static_cast<std::uint32_t>(object));
    }
    clean(scene, Recentre::no, "x");
    EXPECT_LT(scene.primitives.size(), 60u);
    EXPECT_EQ(scene.objects.names, (std::vector<std::string>{"o0", "o1", "o2"}));
    ASSERT_EQ(scene.objects.of.size(), scene.primitives.size());
    for (std::size_t k = 0; k < scene.primitives.size(); ++k)
        EXPECT_EQ(static_cast<int>(scene.primitives[k][0][0] / 10), static_cast<int>(scene.objects.of[k]));
}

TEST(Objects, CleaningKeepsThemInStep) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        expect_kept_in_step<2>(seed);
        expect_kept_in_step<3>(seed);
    }
}

}  // namespace
}  // namespace sightline
