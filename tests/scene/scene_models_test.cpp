// The scenes that stand in for the models of Coorg and Teller 1996: their sizes, closed solids, ways free of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/make/generators.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/office_floor.h"
#include "tests/scene/cast_rays.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

using test::cast, test::distance_to, test::Hit;

/// Numbers of polygons of table 1.
const std::map<std::string, double> measured_by_coorg_and_teller = {{"soda", 1685}, {"blocks", 2857}, {"tetra", 3601}};
constexpr std::uint64_t other_seeds = 3;

/// Polygons as they were made: triangles in a row that are a fan in one plane. A few of them could be joined.
std::size_t count_polygons(const std::vector<Primitive<3>>& triangles) {
    const auto normal = [](const Primitive<3>& t) {
        const Vec<3> n = glm::cross(t[1] - t[0], t[2] - t[0]);
        return n / std::sqrt(glm::dot(n, n));
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        count += i == 0 || triangles[i][0] != triangles[i - 1][0] || triangles[i][1] != triangles[i - 1][2] ||
                 glm::dot(normal(triangles[i]), normal(triangles[i - 1])) < 0.9999;
    return count;
}

TEST(SceneModels, ModelsHaveAsManyPolygonsAsThoseMeasured) {
    for (const auto& [id, polygons] : measured_by_coorg_and_teller) {
        const CatalogueRow<3>& row = *find_in_catalogue<3>(id);
        for (std::uint64_t seed = row.seed; seed <= row.seed + other_seeds; ++seed)
            EXPECT_NEAR(static_cast<double>(count_polygons(row.generate(seed, row.triangles).triangles)) / polygons, 1,
                        id == "blocks" ? 0.02 : 0.01)
                << id << " seed " << seed;
    }
}

TEST(SceneModels, ModelsOfAnySizeAreAsLargeAsAsked) {
    for (const char* id : {"soda", "blocks", "tetra"}) {
        const CatalogueRow<3>& row = *find_in_catalogue<3>(id);
        for (std::size_t size = fewest_triangles(row); size < 9'000; size += 97)
            EXPECT_NEAR(static_cast<double>(row.generate(1, size).triangles.size()) / static_cast<double>(size), 1,
                        0.05)
                << id << " " << size;
    }
}

/// The edges, from corner to corner, to which no triangle on the other side belongs.
std::vector<std::pair<Vec<3>, Vec<3>>> open_edges(const std::vector<Primitive<3>>& triangles) {
    using Corner = std::array<double, 3>;
    std::map<std::pair<Corner, Corner>, int> count;
    const auto corner = [](const Vec<3>& p) { return Corner{p.x, p.y, p.z}; };
    for (const Primitive<3>& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner a = corner(t[i]), b = corner(t[(i + 1) % 3]);
            ++count[{a, b}];
            --count[{b, a}];
        }
    std::vector<std::pair<Vec<3>, Vec<3>>> open;
    for (const auto& [edge, balance] : count) {
        const auto& [a, b] = edge;
        if (balance > 0) open.push_back({{a[0], a[1], a[2]}, {b[0], b[1], b[2]}});
    }
    return open;
}

TEST(SceneModels, TetrahedraAndHousesAreClosed) {
    for (std::uint64_t seed = 1; seed <= other_seeds; ++seed) {
        EXPECT_EQ(open_edges(generate::tetra(seed, 3'602).triangles).size(), 4u) << "only the border of the ground";
        std::vector<Primitive<3>> city = generate::blocks(seed, 5'520).triangles;
        for (const auto& [a, b] : open_edges(city)) EXPECT_EQ(a.z, b.z) << "a wall is closed but where it stands";
        std::size_t on_ground = 0;
        for (const auto& [a, b] : open_edges(city)) on_ground += a.z == 0;
        EXPECT_GT(on_ground, 1'200u);
    }
}

TEST(SceneModels, TetrahedraDoNotMeet) {
    const std::vector<Primitive<3>> all = generate::tetra(5, 3'602).triangles;
    std::vector<Box<3>> boxes;
    for (std::size_t i = 0; i + 4 < all.size(); i += 4)
        boxes.push_back(bounds<3>(
            {all.begin() + static_cast<std::ptrdiff_t>(i), all.begin() + static_cast<std::ptrdiff_t>(i + 4)}));
    ASSERT_EQ(boxes.size(), 900u);
    // Two convex solids are apart along a normal of a face or one square to an edge of each.
    const auto parted = [&](std::size_t i, std::size_t j) {
        std::array<std::vector<Vec<3>>, 2> edges;
        std::vector<Vec<3>> axes;
        for (const std::size_t which : {0, 1})
            for (std::size_t k = 0; k < 4; ++k) {
                const Primitive<3>& face = all[4 * (which ? j : i) + k];
                axes.push_back(glm::cross(face[1] - face[0], face[2] - face[0]));
                for (std::size_t n = 0; n < 3; ++n) edges[which].push_back(face[(n + 1) % 3] - face[n]);
            }
        for (const Vec<3>& a : edges[0])
            for (const Vec<3>& b : edges[1]) axes.push_back(glm::cross(a, b));
        return std::any_of(axes.begin(), axes.end(), [&](const Vec<3>& axis) {
            std::array<double, 2> least{1e9, 1e9}, most{-1e9, -1e9};
            for (const std::size_t which : {0, 1})
                for (std::size_t k = 0; k < 4; ++k)
                    for (const Vec<3>& p : all[4 * (which ? j : i) + k]) {
                        least[which] = std::min(least[which], glm::dot(axis, p));
                        most[which] = std::max(most[which], glm::dot(axis, p));
                    }
            return most[0] < least[1] || most[1] < least[0];
        });
    };
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_EQ(boxes[i].min.z, 0);
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if (boxes[i].min.x < boxes[j].max.x && boxes[j].min.x < boxes[i].max.x && boxes[i].min.y < boxes[j].max.y &&
                boxes[j].min.y < boxes[i].max.y) {
                EXPECT_TRUE(parted(i, j)) << i << " and " << j;
            }
    }
}

TEST(SceneModels, TheOfficeFloorIsClosedButForItsExits) {
    for (std::uint64_t seed = 11; seed <= 11 + other_seeds; ++seed) {
        const Generated made = generate::soda(seed, 3'394);
        const Box<3> box = bounds<3>(made.triangles);
        EXPECT_EQ(box.extent().x, 62.25);
        EXPECT_EQ(box.extent().y, 44.25);
        Random random(seed);
        std::size_t out = 0;
        for (std::size_t i = 0; i < 480; i += 2) {
            const Vec<3> eye = made.paths[0].frames[i].eye;
            Vec<3> direction;
            for (int k = 0; k < 3; ++k) direction[k] = random.uniform(-1, 1) * (k == 2 ? 0.2 : 1);
            if (std::isfinite(cast(made.triangles, eye, direction).distance)) continue;
            ++out;
            // Where it leaves: in the middle of one of the sides, below the top of a door.
            double t = std::numeric_limits<double>::infinity();
            for (int k = 0; k < 2; ++k)
                t = std::min(t, ((direction[k] > 0 ? box.max : box.min)[k] - eye[k]) / direction[k]);
            const Vec<3> p = eye + t * direction;
            EXPECT_TRUE(std::abs(p.x - 31) < 0.75 || std::abs(p.y - 22) < 0.75);
            EXPECT_TRUE(p.z > 0 && p.z < office_door_height);
        }
        EXPECT_LT(out, 24u);
    }
}

TEST(SceneModels, WalkersTakeStepsAndMeetNothing) {
    for (const char* id : {"soda", "blocks", "tetra"}) {
        const CatalogueRow<3>& row = *find_in_catalogue<3>(id);
        for (std::uint64_t seed = row.seed; seed <= row.seed + other_seeds; ++seed) {
            const Generated made = row.generate(seed, row.triangles);
            for (std::size_t k = 0; k < 2; ++k) {
                SCOPED_TRACE(row.id + (" " + made.paths[k].id) + " seed " + std::to_string(seed));
                const std::vector<ViewSpec<3>>& frames = made.paths[k].frames;
                ASSERT_EQ(frames.size(), k == 0 ? 480u : 320u);
                double nearest = std::numeric_limits<double>::infinity(), shortest = 1, longest = 0;
                std::size_t within = 0;
                for (std::size_t i = 0; i < frames.size(); ++i) {
                    EXPECT_EQ(frames[i].eye.z, 1.7);
                    for (const Primitive<3>& t : made.triangles)
                        nearest = std::min(nearest, distance_to(t, frames[i].eye));
                    // Straight up and down: out of a solid its back would be seen.
                    for (const double up : {1.0, -1.0}) {
                        const Hit hit = cast(made.triangles, frames[i].eye, {1e-4, 2e-4, up});
                        if (!std::isfinite(hit.distance)) continue;
                        const Primitive<3>& t = made.triangles[hit.triangle];
                        within += glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), Vec<3>(1e-4, 2e-4, up)) >= 0;
                    }
                    if (i == 0) continue;
                    const Vec<3> step = frames[i].eye - frames[i - 1].eye;
                    shortest = std::min(shortest, std::sqrt(glm::dot(step, step)));
                    longest = std::max(longest, std::sqrt(glm::dot(step, step)));
                }
                EXPECT_GE(nearest, 0.2);
                EXPECT_EQ(within, 0u);
                EXPECT_GT(shortest, k == 0 ? 0.045 : 0.05 - 1e-9);
                EXPECT_LT(longest, 0.05 + 1e-9);
            }
        }
    }
}

TEST(SceneModels, LargerModelsBeginWithTheSmallerOnes) {
    for (const char* id : {"soda", "blocks", "tetra"}) {
        const CatalogueRow<3>& row = *find_in_catalogue<3>(id);
        const Generated small = row.generate(3, row.triangles), large = row.generate(3, 30'000);
        // But for the ground and the outside of outer walls, which come last.
        const std::size_t same = small.triangles.size() - 60;
        EXPECT_TRUE(std::equal(small.triangles.begin(), small.triangles.begin() + static_cast<std::ptrdiff_t>(same),
                               large.triangles.begin()))
            << id;
        EXPECT_EQ(small.paths, large.paths) << id;
    }
}

TEST(SceneModels, LinesOfThePlansDoNotCross) {
    for (const char* id : {"soda", "blocks", "tetra"})
        for (std::uint64_t seed = 1; seed <= other_seeds; ++seed) {
            const std::vector<Primitive<2>> all = find_in_catalogue<2>(id)->generate(seed);
            std::size_t crossings = 0;
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t j = i + 1; j < all.size(); ++j) {
                    const auto &a = all[i], &b = all[j];
                    crossings += orient(a[0], a[1], b[0]) * orient(a[0], a[1], b[1]) < 0 &&
                                 orient(b[0], b[1], a[0]) * orient(b[0], b[1], a[1]) < 0;
                }
            EXPECT_EQ(crossings, 0u) << id << " seed " << seed;
        }
}

// A wing is solid but for its rooms and corridors: each line begins where another ends, or stands against a wall.
TEST(SceneModels, WallsOfThePlanAreClosed) {
    for (std::uint64_t seed = 1; seed <= other_seeds; ++seed) {
        const std::vector<Primitive<2>> all = find_in_catalogue<2>("soda")->generate(seed);
        std::map<std::array<double, 2>, int> balance;
        for (const Primitive<2>& s : all) {
            ++balance[{s[0].x, s[0].y}];
            --balance[{s[1].x, s[1].y}];
        }
        std::size_t shelf_ends = 0;
        for (const auto& [corner, count] : balance) {
            if (count == 0) continue;
            const Vec<2> p(corner[0], corner[1]);
            ++shelf_ends;
            EXPECT_TRUE(std::any_of(
                all.begin(), all.end(),
                [&](const Primitive<2>& s) { return p != s[0] && p != s[1] && segments_meet(s[0], s[1], p, p); }))
                << seed << ": " << p.x << ", " << p.y;
        }
        EXPECT_LT(shelf_ends, 120u);
    }
}

}  // namespace
}  // namespace sightline
