// What the generated 3D scenes promise: size, the same bits everywhere, clean triangles, fronts that look outward.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "core/base/random.h"
#include "core/scene/clean.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/view.h"
#include "tests/scene/cast_rays.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

using test::cast, test::distance_to, test::Hit;

Scene<3> scene_of(const CatalogueRow<3>& row, std::size_t triangles) {
    return make_scene(row, row.triangles == 0 ? 0 : triangles);
}

// Golden: a change here changes every recorded number of the scene.
TEST(SceneGenerated, ScenesAreTheSameBitsEverywhere) {
    const std::map<std::string, std::string> golden = {
        {"bottleneck", "85e0a78cd8f3db19"}, {"wall2", "bed3d800b0a3f398"},  {"city", "d0afa59a9614ee98"},
        {"cars", "dc96f90584c63dc3"},       {"room", "22e202fa55219732"},   {"jungle", "a31b63d6163c5a4d"},
        {"plant", "5c038434752d1cf5"},      {"soda", "29e7bcaeddbbe3af"},   {"blocks", "2564b183e70e570c"},
        {"tetra", "958a15bd9f6b52a7"},      {"campus", "9990b972d06ab94e"},
    };
    EXPECT_EQ(golden.size(), catalogue<3>().size());
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        const auto found = golden.find(row.id);
        ASSERT_NE(found, golden.end()) << row.id;
        EXPECT_EQ(hash_text(scene_hash(scene_of(row, 10'000))), found->second) << row.id;
    }
}

TEST(SceneGenerated, SizesAreAsAsked) {
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        if (row.triangles == 0) continue;
        for (const std::size_t size : {std::min<std::size_t>(row.triangles, 10'000), std::size_t{10'000},
                                       std::size_t{13'370}, std::size_t{50'000}, std::size_t{500'000}})
            for (const std::uint64_t seed : {row.seed, row.seed + 1}) {
                const Generated made = row.generate(seed, size);
                EXPECT_NEAR(static_cast<double>(made.triangles.size()) / static_cast<double>(size), 1, 0.05)
                    << row.id << " " << size << " seed " << seed;
            }
    }
}

TEST(SceneGenerated, SeedsMatterAndRepeat) {
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        EXPECT_EQ(row.generate(77, 10'000).triangles, row.generate(77, 10'000).triangles) << row.id;
        EXPECT_NE(row.generate(77, 10'000).triangles, row.generate(78, 10'000).triangles) << row.id;
    }
}

// make_scene does not look for what clean would drop.
TEST(SceneGenerated, NothingIsLeftToClean) {
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        SCOPED_TRACE(row.id);
        for (const std::size_t size : {10'000, 60'000})
            for (std::uint64_t seed = row.seed; seed < row.seed + 3; ++seed) {
                Generated made = row.generate(seed, size);
                for (const Primitive<3>& t : made.triangles)
                    for (const Vec<3>& p : t)
                        for (int i = 0; i < 3; ++i) ASSERT_EQ(p[i], double{static_cast<float>(p[i])}) << "no float";
                EXPECT_TRUE(made.two_sided.empty() || made.two_sided.size() == made.triangles.size());
                Scene<3> scene;
                scene.primitives = std::move(made.triangles);
                clean(scene, Recentre::no, row.id);
                EXPECT_EQ(scene.dropped, Dropped{}) << size << " seed " << seed;
            }
    }
}

TEST(SceneGenerated, ScenesAreComplete) {
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        SCOPED_TRACE(row.id);
        const Scene<3> scene = scene_of(row, 10'000);
        EXPECT_EQ(scene.id, row.id);
        EXPECT_EQ(scene.source, "generated");
        EXPECT_EQ(scene.seed, row.seed);
        EXPECT_EQ(scene.up_axis, 2);
        EXPECT_EQ(scene.origin, Vec<3>(0, 0, 0));
        EXPECT_EQ(scene.start_view, row.view);
        EXPECT_EQ(scene.two_sided.empty(), std::string(row.id) != "jungle");
        ASSERT_EQ(scene.paths.size(), row.paths.size());
        for (std::size_t i = 0; i < scene.paths.size(); ++i) {
            EXPECT_EQ(scene.paths[i].id, row.paths[i]);
            for (const ViewSpec<3>& frame : scene.paths[i].frames) check_view(frame, row.id, row.paths[i]);
        }
        EXPECT_EQ(scene.paths.back().frames.size(), 8u);
    }
    // As long as the flights of TVCG 5.2.
    const std::map<std::string, std::size_t> frames = {{"city", 160}, {"cars", 200}, {"room", 235}};
    for (const auto& [id, count] : frames) {
        const std::optional<Scene<3>> scene = generated_scene(id + ":10k");
        for (std::size_t i = 0; i + 1 < scene->paths.size(); ++i)
            EXPECT_EQ(scene->paths[i].frames.size(), count) << id << " " << scene->paths[i].id;
    }
}

TEST(SceneGenerated, ALargerCityHasTheSameStreet) {
    const Generated small = generate::city(1, 200'000), large = generate::city(1, 800'000);
    EXPECT_EQ(small.paths[0], large.paths[0]);
    // Lots follow one another by distance, and only the last one is cut short.
    const std::size_t same = small.triangles.size() - 2'500;
    const auto middle = large.triangles.begin() + static_cast<std::ptrdiff_t>(same);
    EXPECT_TRUE(std::equal(large.triangles.begin(), middle, small.triangles.begin()));
    const double radius = 0.5 * bounds<3>(small.triangles).longest_side();
    double nearest = radius;
    for (auto t = middle; t != large.triangles.end(); ++t)
        for (const Vec<3>& p : *t) nearest = std::min(nearest, std::sqrt(p.x * p.x + p.y * p.y));
    EXPECT_GT(nearest, 0.7 * radius);
}

/// A ray through a random place of the picture.
Vec<3> random_ray(Random& random, const View<3>& view) {
    const double u = random.unit(), v = random.unit();
    const Vec<3> low = view.corners[0] * (1 - u) + view.corners[1] * u;
    const Vec<3> high = view.corners[3] * (1 - u) + view.corners[2] * u;
    return low * (1 - v) + high * v - view.eye;
}

TEST(SceneGenerated, EyesSeeFrontsAndStandInTheOpen) {
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        const Scene<3> scene = scene_of(row, 10'000);
        std::vector<FlightPath<3>> paths = scene.paths;
        paths.push_back({"start", {*scene.start_view}});
        for (const FlightPath<3>& path : paths) {
            SCOPED_TRACE(std::string(row.id) + " " + path.id);
            Random random(5);
            std::size_t hits = 0, backs = 0;
            double nearest = std::numeric_limits<double>::infinity();
            const std::size_t rays = 500 / path.frames.size() + 1;
            for (const ViewSpec<3>& frame : path.frames) {
                const View<3> view = make_view(frame, 4.0 / 3, scene.up_axis);
                std::vector<Primitive<3>> fronts;
                for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
                    const Primitive<3>& t = scene.primitives[k];
                    nearest = std::min(nearest, distance_to(t, view.eye));
                    if (shows_both_sides(scene, k) || faces(view, t)) fronts.push_back(t);
                }
                for (std::size_t i = 0; i < rays; ++i) {
                    const Vec<3> ray = random_ray(random, view);
                    const Hit hit = cast(scene.primitives, view.eye, ray);
                    if (!std::isfinite(hit.distance)) continue;
                    ++hits;
                    // A thin wall may be a front toward either side, in one place.
                    backs += cast(fronts, view.eye, ray).distance > hit.distance * (1 + 1e-9);
                }
            }
            EXPECT_GT(hits, 100u);
            EXPECT_LT(static_cast<double>(backs), 0.01 * static_cast<double>(hits));
            EXPECT_GE(nearest, 0.05);
        }
    }
}

TEST(SceneGenerated, TheRoomIsClosed) {
    const Scene<3> scene = *generated_scene("room:10k");
    const Box<3> box = bounds<3>(scene.primitives);
    Random random(3);
    for (const ViewSpec<3>& frame : scene.paths.front().frames) {
        EXPECT_TRUE(box.contains(frame.eye));
        Vec<3> direction;
        for (int i = 0; i < 3; ++i) direction[i] = random.uniform(-1, 1);
        EXPECT_TRUE(std::isfinite(cast(scene.primitives, frame.eye, direction).distance));
    }
}

/// How many of the triangles of the box can be seen from the eye, by rays to points on them.
std::size_t seen_inside(const Scene<3>& scene, const Vec<3>& eye, const Box<3>& box, std::size_t& tried) {
    Random random(9);
    std::size_t seen = 0;
    for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
        const Primitive<3>& t = scene.primitives[k];
        if (!box.contains(t[0]) || !box.contains(t[1]) || !box.contains(t[2])) continue;
        ++tried;
        bool any = false;
        for (int i = 0; i < 10 && !any; ++i) {
            double u = random.unit(), v = random.unit();
            if (u + v > 1) u = 1 - u, v = 1 - v;
            any = cast(scene.primitives, eye, t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]) - eye).triangle == k;
        }
        seen += any;
    }
    return seen;
}

TEST(SceneGenerated, LessonsHideTheirCrates) {
    const Scene<3> bottleneck = *generated_scene("bottleneck"), wall = *generated_scene("wall2");
    std::size_t tried = 0;
    for (const Box<3>& box : {Box<3>{{0, 8, 0.01}, {5.7, 16, 4}}, Box<3>{{10.3, 8, 0.01}, {16, 16, 4}}})
        EXPECT_EQ(seen_inside(bottleneck, bottleneck.start_view->eye, box, tried), 0u);
    EXPECT_GT(tried, 100u);
    tried = 0;
    EXPECT_EQ(seen_inside(wall, wall.start_view->eye, {{0, 14.5, 0.01}, {40, 40, 9}}, tried), 0u);
    EXPECT_GT(tried, 2'000u);
}

}  // namespace
}  // namespace sightline
