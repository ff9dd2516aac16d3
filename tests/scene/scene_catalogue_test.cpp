// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "core/scene/clean.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/make/generators.h"
#include "core/scene/view.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

TEST(SceneCatalogue, RowsAreComplete) {
    std::set<std::string> ids;
    for (const CatalogueRow<2>& row : catalogue()) {
        SCOPED_TRACE(row.id);
        EXPECT_TRUE(ids.insert(row.id).second);
        EXPECT_EQ(find_in_catalogue(row.id), &row);
        const std::string lesson = row.lesson;
        EXPECT_GT(lesson.size(), 60u);
        EXPECT_EQ(lesson.back(), '.');
        EXPECT_EQ(lesson.find(". "), std::string::npos) << "one sentence";
        EXPECT_GT(row.error_bound, 0);
        EXPECT_LE(row.error_bound, 1);
        EXPECT_FALSE(row.bookmarks.empty());
        make_view(row.view);
    }
    EXPECT_EQ(find_in_catalogue("nothing"), nullptr);
}

// Golden: a change here changes every recorded number of the scene.
TEST(SceneCatalogue, ScenesAreTheSameBitsEverywhere) {
    const std::map<std::string, std::string> golden = {
        {"bottleneck", "ae6b9e6ee7fc10cb"}, {"streets", "8630b01d3438c264"}, {"rooms", "c55c93c632a0cc2f"},
        {"cars", "544a2cde0c9a9902"},       {"jungle", "2a4864800813fba8"},  {"terrain", "52b9c0877c7b5eeb"},
        {"wallholes", "44038285407b72d8"},  {"wall2", "e2f51f4e69f6b71e"},   {"statue", "f2d920ec92201485"},
        {"forget", "b2e3f4f0d36a1c6e"},     {"field", "31059c2b3288e503"},   {"soda", "0a604f7fb755bbcf"},
        {"blocks", "b9827a830c1c6a4f"},     {"tetra", "e9c60dc4655e4176"},   {"campus", "b0fd18b10163da70"},
    };
    for (const CatalogueRow<2>& row : catalogue()) {
        const auto found = golden.find(row.id);
        ASSERT_NE(found, golden.end()) << row.id;
        EXPECT_EQ(hash_text(scene_hash(make_scene(row))), found->second) << row.id;
    }
    EXPECT_EQ(golden.size(), catalogue().size());
}

TEST(SceneCatalogue, ScenesAreCleanAndOfTheirSize) {
    for (const CatalogueRow<2>& row : catalogue()) {
        SCOPED_TRACE(row.id);
        const Scene<2> scene = make_scene(row);
        EXPECT_EQ(scene.dropped.total(), 0u);
        EXPECT_TRUE(scene.warnings.empty());
        EXPECT_EQ(scene.origin, Vec<2>(0, 0));
        EXPECT_GE(scene.primitives.size(), 200u);
        EXPECT_LE(scene.primitives.size(), 6000u);
        // The eye stands on nothing, and something is in view.
        const View<2> view = make_view(*scene.start_view);
        std::size_t seen = 0;
        for (const Primitive<2>& s : scene.primitives) {
            seen += in_view(view, s);
            EXPECT_FALSE(segments_meet(s[0], s[1], view.eye, view.eye));
        }
        EXPECT_GT(seen, 50u);
    }
}

/// Leaves of a quadtree over the end points, as the papers build it.
int count_leaves(const std::vector<Vec<2>>& points, const Vec<2>& corner, double side, double bound) {
    if (points.empty() || side < bound) return 1;
    const double half = side / 2;
    int leaves = 0;
    for (const double dx : {0.0, half})
        for (const double dy : {0.0, half}) {
            std::vector<Vec<2>> inside;
            for (const Vec<2>& p : points)
                if ((p.x >= corner.x + half) == (dx > 0) && (p.y >= corner.y + half) == (dy > 0)) inside.push_back(p);
            leaves += count_leaves(inside, corner + Vec<2>(dx, dy), half, bound);
        }
    return leaves;
}

TEST(SceneCatalogue, BottleneckIsSmallEnoughForALecture) {
    const CatalogueRow<2>& row = *find_in_catalogue("bottleneck");
    const Scene<2> scene = make_scene(row);
    const Box<2> box = bounds<2>(scene.primitives);
    std::vector<Vec<2>> points;
    for (const Primitive<2>& s : scene.primitives) points.insert(points.end(), s.begin(), s.end());
    const double side = box.longest_side();
    const int leaves = count_leaves(points, box.min, side, row.error_bound * side);
    // With the four corners of the inflated box as hull, Delaunay has 2n - 2 - 4 triangles.
    EXPECT_LE(2 * (leaves + 4) - 6, 80);
    EXPECT_GE(leaves, 20);
}

TEST(SceneCatalogue, BottleneckHidesItsCrates) {
    const Scene<2> scene = make_scene(*find_in_catalogue("bottleneck"));
    const Vec<2> eye = scene.start_view->eye;
    Random random(1);
    std::size_t hidden = 0;
    for (const Primitive<2>& crate : scene.primitives) {
        if (crate[0].y < 8 || std::abs(crate[0].x - 8) < 2.4) continue;  // blocks and bench, house
        ++hidden;
        for (int i = 0; i < 50; ++i) {
            const Vec<2> p = crate[0] + (crate[1] - crate[0]) * random.unit();
            bool covered = false;
            for (const Primitive<2>& s : scene.primitives)
                covered = covered || (s[0].y < 8 && segments_meet(eye, p, s[0], s[1]));
            ASSERT_TRUE(covered);
        }
    }
    EXPECT_EQ(hidden, 20u);
}

TEST(SceneGenerators, SeedsMatterAndRepeat) {
    for (const CatalogueRow<2>& row : catalogue()) {
        SCOPED_TRACE(row.id);
        EXPECT_EQ(row.generate(77), row.generate(77));
        EXPECT_NE(row.generate(77), row.generate(78));
        for (std::uint64_t seed = 100; seed < 110; ++seed) {
            Scene<2> scene;
            scene.primitives = row.generate(seed);
            clean(scene, Recentre::no, row.id);
            EXPECT_EQ(scene.dropped.total(), 0u) << seed;
        }
    }
}

bool cross_inside(const Primitive<2>& a, const Primitive<2>& b) {
    return orient(a[0], a[1], b[0]) * orient(a[0], a[1], b[1]) < 0 &&
           orient(b[0], b[1], a[0]) * orient(b[0], b[1], a[1]) < 0;
}

TEST(SceneGenerators, CityBlocksHaveTheAskedSizeAndNoCrossings) {
    for (const std::size_t size : {0u, 1u, 57u, 4000u}) {
        Scene<2> scene;
        scene.primitives = city_blocks(size, 5);
        EXPECT_EQ(scene.primitives.size(), size);
        clean(scene, Recentre::no, "city");
        EXPECT_EQ(scene.dropped.total(), 0u);
        std::size_t crossings = 0;
        for (std::size_t i = 0; i < scene.primitives.size(); ++i)
            for (std::size_t j = i + 1; j < scene.primitives.size(); ++j)
                crossings += cross_inside(scene.primitives[i], scene.primitives[j]);
        EXPECT_EQ(crossings, 0u) << size;
    }
    const std::vector<Primitive<2>> large = city_blocks(1000000, 1);
    EXPECT_EQ(large.size(), 1000000u);
    const Vec<2> extent = bounds<2>(large).extent();
    EXPECT_LT(extent.x / extent.y, 1.5);
    EXPECT_GT(extent.x / extent.y, 0.67);
    Hash hash;
    for (const Primitive<2>& s : large)
        for (const Vec<2>& v : s) hash.add(v.x), hash.add(v.y);
    EXPECT_EQ(hash_text(hash.value()), "a762fbb5ef1bde7e");
}

}  // namespace
}  // namespace sightline
