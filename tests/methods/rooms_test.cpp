// Rooms: plans that are cut into them, what closes them, what they hold, and the lines that pass from one to another.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/geometry/plan_mesh.h"
#include "core/methods/portals/stab.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/plan_rooms.h"
#include "core/scene/view.h"
#include "core/space/room_contents.h"
#include "tests/scene/cast_rays.h"
#include "tests/soak.h"

namespace sightline {
namespace {

Vec<2> grid_point(Random& random, std::uint64_t size) {
    const auto x = static_cast<double>(random.below(size)), y = static_cast<double>(random.below(size));
    return {x, y};
}

std::vector<Primitive<2>> random_walls(Random& random) {
    std::vector<Primitive<2>> walls;
    const std::uint64_t size = 3 + random.below(20), count = 1 + random.below(25);
    for (std::uint64_t i = 0; i < count; ++i) {
        const Vec<2> a = grid_point(random, size), b = grid_point(random, size);
        if (a != b) walls.push_back({a, b});
    }
    // Most have a wall around them, some with a gap.
    const double high = static_cast<double>(size), gap = random.below(3) ? 0 : 1;
    if (random.below(4) > 0)
        for (const Primitive<2>& wall : std::array<Primitive<2>, 5>{{{Vec<2>(-1, -1), Vec<2>(high, -1)},
                                                                     {Vec<2>(high, -1), Vec<2>(high, high)},
                                                                     {Vec<2>(high, high), Vec<2>(-1, high)},
                                                                     {Vec<2>(-1, high), Vec<2>(-1, gap)},
                                                                     {Vec<2>(-1, 0), Vec<2>(-1, -1)}}})
            walls.push_back(wall);
    return walls;
}

double doubled_area(const std::vector<Vec<2>>& polygon) {
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) area += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return area;
}

TEST(PlanMesh, IsATriangulationWhoseKeptEdgesLieOnLines) {
    Random random(1);
    for (int i = 0; i < test::soak_count(300); ++i) {
        std::vector<PlanLine> lines;
        for (const Primitive<2>& wall : random_walls(random)) lines.push_back({wall, 1});
        const PlanMesh mesh = triangulate_plan(lines);
        double area = 0, around = 0;
        for (std::uint32_t half = 0; half < mesh.from.size(); ++half) {
            const Vec<2>&a = mesh.points[mesh.from[half]], &b = mesh.points[mesh.to(half)];
            const std::uint32_t twin = mesh.twin[half];
            if (twin == none) {
                around += cross(a, b);
            } else {
                ASSERT_EQ(mesh.twin[twin], half);
                ASSERT_EQ(mesh.from[twin], mesh.to(half));
                ASSERT_EQ(mesh.kept[twin], mesh.kept[half]);
            }
            if (half % 3 == 0) {
                const double size = doubled_area({a, b, mesh.points[mesh.to(half + 1)]});
                ASSERT_GT(size, 0);
                area += size;
            }
            if (!mesh.kept[half]) continue;
            ASSERT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const PlanLine& line) {
                return segments_meet(line.ends[0], line.ends[1], a, a) &&
                       segments_meet(line.ends[0], line.ends[1], b, b);
            }));
        }
        ASSERT_EQ(area, around);  // whole numbers
        if (mesh.left_out > 0 || mesh.from.empty()) continue;
        for (const PlanLine& line : lines) {  // all of each is there
            double length = 0;
            for (std::uint32_t half = 0; half < mesh.from.size(); ++half) {
                const Vec<2>&a = mesh.points[mesh.from[half]], &b = mesh.points[mesh.to(half)];
                const bool once = mesh.twin[half] == none || mesh.twin[half] > half;
                if (once && mesh.kept[half] && segments_meet(line.ends[0], line.ends[1], a, a) &&
                    segments_meet(line.ends[0], line.ends[1], b, b))
                    length += glm::length(b - a);
            }
            ASSERT_NEAR(length, glm::length(line.ends[1] - line.ends[0]), 1e-9);
        }
    }
}

/// Whether one comes along the segment from room to room through portals; near misses of a portal count as hits.
template <int D>
bool leads_through_portals(const Rooms<D>& rooms, std::uint32_t room, const Vec<D>& from, const Vec<D>& to) {
    const auto crosses = [&](const Portal<D>& portal) {
        if constexpr (D == 2) {
            return segments_meet(from, to, portal.corners[0], portal.corners[1]);
        } else {
            Box<3> box;
            for (const Vec<3>& corner : portal.corners) box.add(corner);
            for (int axis = 0; axis < 3; ++axis) {
                if (box.min[axis] != box.max[axis] || from[axis] == to[axis]) continue;
                const double at = (box.min[axis] - from[axis]) / (to[axis] - from[axis]);
                const Vec<3> p = from + (to - from) * at;
                bool inside = at >= 0 && at <= 1;
                for (int i = 0; i < 3; ++i)
                    inside &= i == axis || (p[i] >= box.min[i] - 1e-9 && p[i] <= box.max[i] + 1e-9);
                return inside;
            }
            return false;
        }
    };
    std::vector<std::uint8_t> known(rooms.all.size());
    std::vector<std::uint32_t> waiting{room};
    known[room] = 1;
    while (!waiting.empty()) {
        const std::uint32_t at = waiting.back();
        waiting.pop_back();
        if (holds(rooms.all[at], to)) return true;
        for (const Portal<D>& portal : rooms.portals) {
            if (portal.rooms[0] != at && portal.rooms[1] != at) continue;
            if (!crosses(portal)) continue;
            const std::uint32_t beyond = portal.rooms[portal.rooms[0] == at];
            if (beyond == none) return true;
            if (!known[beyond]) waiting.push_back(beyond);
            known[beyond] = 1;
        }
    }
    return false;
}

TEST(PlanRooms, AreClosedByWallsButAtTheirPortals) {
    Random random(2);
    std::size_t tested = 0;
    for (int i = 0; i < test::soak_count(200); ++i) {
        const std::vector<Primitive<2>> walls = random_walls(random);
        const Rooms<2> rooms = plan_rooms(walls);
        check_rooms(rooms, "random");
        for (int k = 0; k < 20 && !rooms.all.empty(); ++k) {
            const auto room = static_cast<std::uint32_t>(random.below(rooms.all.size()));
            const Vec<2> from = middle_of(rooms.all[room]);
            Vec<2> to = grid_point(random, 25);
            if (random.below(2)) to = middle_of(rooms.all[random.below(rooms.all.size())]);
            to += Vec<2>(random.unit(), random.unit()) - 0.5;
            const bool closed = std::any_of(walls.begin(), walls.end(), [&](const Primitive<2>& wall) {
                return segments_meet(wall[0], wall[1], from, to);
            });
            if (closed) continue;
            ++tested;
            ASSERT_TRUE(leads_through_portals(rooms, room, from, to)) << i;
        }
    }
    EXPECT_GT(tested, 200u);
}

TEST(Rooms, OfGeneratedPlansAreClosedButAtTheirPortals) {
    Random random(3);
    for (const char* id : {"rooms", "soda"}) {
        const Scene<2> scene = make_scene(*find_in_catalogue<2>(id));
        std::size_t open = 0;
        for (int i = 0; i < test::soak_count(2000); ++i) {
            const auto room = static_cast<std::uint32_t>(random.below(scene.rooms.all.size()));
            const Vec<2> from = middle_of(scene.rooms.all[room]);
            const Vec<2> to = from + Vec<2>(random.uniform(-8, 8), random.uniform(-8, 8));
            if (std::any_of(scene.primitives.begin(), scene.primitives.end(),
                            [&](const Primitive<2>& p) { return segments_meet(p[0], p[1], from, to); }))
                continue;
            ++open;
            ASSERT_TRUE(leads_through_portals(scene.rooms, room, from, to)) << id;
        }
        EXPECT_GT(open, 100u) << id;
    }
}

TEST(Rooms, OfGeneratedBuildingsAreClosedButAtTheirPortals) {
    Random random(4);
    for (const char* id : {"soda", "room:10k"}) {
        const Scene<3> scene = *generated_scene(id);
        std::size_t open = 0;
        for (int i = 0; i < test::soak_count(400); ++i) {
            const auto room = static_cast<std::uint32_t>(random.below(scene.rooms.all.size()));
            const Box<3>& box = scene.rooms.all[room].shape;
            const auto share = [&] { return random.uniform(0.05, 0.95); };
            const double x = share(), y = share(), z = share();
            const Vec<3> from = box.min + box.extent() * Vec<3>(x, y, z);
            const double dx = random.uniform(-20, 20), dy = random.uniform(-20, 20), dz = random.uniform(-2, 2);
            const Vec<3> to = from + Vec<3>(dx, dy, dz);
            std::vector<Primitive<3>> fronts;
            for (const Primitive<3>& triangle : scene.primitives)
                if (orient(triangle[0], triangle[1], triangle[2], from) > 0) fronts.push_back(triangle);
            const double reach = std::min(1.0, test::cast(fronts, from, to - from).distance * (1 - 1e-9));
            ++open;
            ASSERT_TRUE(leads_through_portals(scene.rooms, room, from, from + (to - from) * reach))
                << id << " from " << scene.rooms.all[room].name;
        }
        EXPECT_GT(open, 100u) << id;
    }
}

/// Against a look at every room and at points of the primitive.
TEST(RoomContents, HoldAllThatMeetsARoomAndAllThatIsSeenFromOutside) {
    Random random(5);
    for (int i = 0; i < test::soak_count(100); ++i) {
        Scene<2> scene;
        scene.primitives = random_walls(random);
        scene.rooms = plan_rooms(scene.primitives);
        for (int k = 0; k < 20; ++k) {  // furniture
            const Vec<2> a = grid_point(random, 20) + 0.5;
            scene.primitives.push_back({a, a + Vec<2>(random.uniform(-2, 2), 0.25)});
        }
        const RoomContents contents = room_contents(scene);
        for (std::uint32_t p = 0; p < scene.primitives.size(); ++p)
            for (int k = 0; k <= 16; ++k) {
                const Vec<2> at =
                    scene.primitives[p][0] + (scene.primitives[p][1] - scene.primitives[p][0]) * (k / 16.0);
                bool inside = false;
                for (std::uint32_t room = 0; room < scene.rooms.all.size(); ++room) {
                    if (!holds(scene.rooms.all[room], at)) continue;
                    inside = true;
                    const auto row = contents.of(room);
                    if (holds_inside(scene.rooms.all[room], at)) {
                        ASSERT_TRUE(std::binary_search(row.begin(), row.end(), p));
                    }
                }
                if (!inside) {
                    ASSERT_TRUE(contents.outside[p]);
                }
            }
    }
}

/// A line that stabs all is found by trying many; whoever finds one knows that stab() must say yes.
TEST(Stab, AllowsWhatARandomLineDoesAndRefusesWhatNoneCan) {
    Random random(6);
    std::size_t yes = 0, no = 0;
    for (int i = 0; i < test::soak_count(400); ++i) {
        std::vector<Doorway2> passed;
        StabbingLines lines;
        bool open = true;
        for (int k = 0; k < 5 && open; ++k) {
            const double x = 4 * k, low = static_cast<double>(random.below(8));
            const double turn = random.uniform(-1.5, 1.5), wide = 1 + static_cast<double>(random.below(4));
            const Doorway2 next{{x - turn, low + wide}, {x + turn, low}};
            StabbingLines narrower(next);
            open = passed.empty() || stab(lines, passed, next, narrower);
            lines = narrower;
            passed.push_back(next);
            bool found = false;
            for (int a = 0; a <= 60 && !found; ++a)
                for (int b = 0; b <= 60 && !found; ++b) {
                    const Vec<2> p = passed[0].right + (passed[0].left - passed[0].right) * (a / 60.0);
                    const Vec<2> q = next.right + (next.left - next.right) * (b / 60.0);
                    found = p.x < q.x && std::all_of(passed.begin(), passed.end(), [&](const Doorway2& at) {
                                return orient(p, q, at.left) > 0 && orient(p, q, at.right) < 0;
                            });
                }
            if (found) {
                ASSERT_TRUE(open) << i;
            }
            (open ? yes : no) += 1;
            if (!open) break;
            // The outermost lines do what they say.
            for (const Doorway2& at : passed)
                for (const auto& line : {lines.to_right, lines.to_left}) {
                    ASSERT_GE(orient(line[0], line[1], at.left), 0);
                    ASSERT_LE(orient(line[0], line[1], at.right), 0);
                }
        }
    }
    EXPECT_GT(yes, 100u);
    EXPECT_GT(no, 100u);
}

template <int D>
void expect_unsound(const Rooms<D>& rooms, const std::string& part) {
    try {
        check_rooms(rooms, "x");
        ADD_FAILURE() << "nothing was said of: " << part;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(Rooms, SayWhatIsWrongWithThem) {
    Rooms<2> plan;
    plan.all = {{"a", {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {"b", {{2, 0}, {4, 0}, {4, 2}, {2, 2}}}};
    plan.portals = {{{0, 1}, {{2, 0.5}, {2, 1.5}}}};
    check_rooms(plan, "x");
    Rooms<2> broken = plan;
    std::swap(broken.all[1].shape[0], broken.all[1].shape[1]);
    expect_unsound(broken, "room 1 (b): not convex");
    broken = plan;
    broken.portals[0].rooms = {0, 7};
    expect_unsound(broken, "portal 0: room 7 of 2");
    broken = plan;
    broken.portals[0].rooms = {none, none};
    expect_unsound(broken, "into itself");
    broken = plan;
    broken.portals[0].corners[1] = {2.5, 1};
    expect_unsound(broken, "portal 0: does not lie on the border of room 0 (a)");

    Rooms<3> boxes;
    boxes.all = {{"a", {{0, 0, 0}, {1, 1, 1}}}, {"b", {{1, 0.5, 0}, {2, 2, 2}}}};
    boxes.portals = portals_between(boxes.all);
    ASSERT_EQ(boxes.portals.size(), 1u);
    check_rooms(boxes, "x");
    boxes.all[0].shape.max.x = 0;
    expect_unsound(boxes, "without a volume");
}

TEST(Rooms, KnowWhereAnEyeIs) {
    Rooms<2> plan;
    plan.all = {{"a", {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {"b", {{2, 0}, {4, 0}, {4, 2}, {2, 2}}}};
    plan.portals = {{{0, 1}, {{2, 0.5}, {2, 1.5}}}};
    const auto at = [&](double x, double y) { return rooms_at(plan, Vec<2>(x, y)); };
    EXPECT_EQ(at(1, 1).rooms, std::vector<std::uint32_t>{0});
    EXPECT_FALSE(at(1, 1).outside);
    EXPECT_EQ(at(2, 1).rooms, (std::vector<std::uint32_t>{0, 1}));  // on the portal
    EXPECT_FALSE(at(2, 1).outside);
    EXPECT_TRUE(at(2, 0.5).outside);  // at its end a wall begins
    EXPECT_TRUE(at(0, 1).outside);
    EXPECT_EQ(at(0, 1).rooms.size(), 1u);
    EXPECT_TRUE(at(9, 9).outside);
    EXPECT_TRUE(at(9, 9).rooms.empty());
}

}  // namespace
}  // namespace sightline
