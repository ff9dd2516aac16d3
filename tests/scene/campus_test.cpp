// The campus: marked rooms that are closed but at their portals, named objects, copies, and a walk through it all.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/make/generators_3d.h"
#include "tests/scene/cast_rays.h"

namespace sightline {
namespace {

using test::cast, test::distance_to, test::Hit;

Generated campus_of(std::uint64_t seed) { return generate::campus(seed, 75'000); }

/// Which axis the portal is square to.
int axis_of(const Portal<3>& portal) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::all_of(portal.corners.begin(), portal.corners.end(),
                        [&](const Vec<3>& p) { return p[axis] == portal.corners[0][axis]; }))
            return axis;
    return -1;
}

Box<3> box_of(const Portal<3>& portal) {
    Box<3> box;
    for (const Vec<3>& p : portal.corners) box.add(p);
    return box;
}

bool is_around(const Box<3>& box, const Vec<3>& p, double slack) {
    for (int i = 0; i < 3; ++i)
        if (p[i] < box.min[i] - slack || p[i] > box.max[i] + slack) return false;
    return true;
}

std::uint32_t room_at(const Rooms<3>& rooms, const Vec<3>& p) {
    for (std::uint32_t i = 0; i < rooms.all.size(); ++i)
        if (is_around(rooms.all[i].shape, p, 0)) return i;
    return none;
}

TEST(Campus, HasTheSizeOfThePapersModel) {
    for (const std::uint64_t seed : {14u, 15u, 16u}) {
        const Generated made = campus_of(seed);
        EXPECT_NEAR(static_cast<double>(made.objects.names.size()), 3'500, 200);
        EXPECT_EQ(made.objects.of.size(), made.triangles.size());
        Objects tidied = made.objects;
        tidy(tidied);
        EXPECT_EQ(tidied, made.objects) << "each name once, none without a triangle";
    }
    const Generated one = campus_of(14), all = generate::campus(14, 3'600'000);
    EXPECT_EQ(all.triangles.size(), 49 * one.triangles.size());
    EXPECT_EQ(all.rooms.all.size(), 49 * one.rooms.all.size());
    const Vec<3> size = bounds<3>(all.triangles).extent();
    EXPECT_EQ(size.x, 7 * 128);
    EXPECT_EQ(size.y, 7 * 128);
    EXPECT_EQ(all.objects.names[0], one.objects.names[0]);
    EXPECT_EQ(all.objects.names.back(), "campus 49 / " + one.objects.names.back());
}

TEST(Campus, ALargerOneBeginsWithTheSmallerOnesAndHasTheSameWalk) {
    const Generated one = campus_of(14), four = generate::campus(14, 300'000);
    EXPECT_TRUE(std::equal(one.triangles.begin(), one.triangles.end(), four.triangles.begin()));
    EXPECT_TRUE(std::equal(one.rooms.portals.begin(), one.rooms.portals.end(), four.rooms.portals.begin()));
    EXPECT_EQ(one.paths, four.paths);
    EXPECT_EQ(bounds<3>(four.triangles).extent().x, 256);
    EXPECT_EQ(bounds<3>(four.triangles).extent().y, 256);
}

TEST(Campus, PortalsLieInTheBordersOfBothRooms) {
    const Generated made = generate::campus(14, 160'000);  // more than one copy
    std::set<std::string> names;
    for (const Room<3>& room : made.rooms.all) EXPECT_TRUE(names.insert(room.name).second) << room.name;
    std::vector<int> portals(made.rooms.all.size());
    std::size_t outside = 0;
    for (const Portal<3>& portal : made.rooms.portals) {
        ASSERT_EQ(portal.corners.size(), 4u);
        const int axis = axis_of(portal);
        ASSERT_GE(axis, 0);
        const Box<3> box = box_of(portal);
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(i == axis || box.max[i] - box.min[i] > 0.8);
        EXPECT_NE(portal.rooms[0], none);
        outside += portal.rooms[1] == none;
        for (const std::uint32_t room : portal.rooms) {
            if (room == none) continue;
            ++portals[room];
            const Box<3>& shape = made.rooms.all[room].shape;
            EXPECT_TRUE(is_around(shape, box.min, 0) && is_around(shape, box.max, 0));
            EXPECT_TRUE(box.min[axis] == shape.min[axis] || box.min[axis] == shape.max[axis]);
        }
    }
    EXPECT_GT(outside, 200u);
    for (std::size_t i = 0; i < portals.size(); ++i) EXPECT_GT(portals[i], 0) << made.rooms.all[i].name;
}

TEST(Campus, RoomsDoNotOverlapAndNothingStandsInTwo) {
    const Generated made = campus_of(14);
    const auto meet = [](const Box<3>& a, const Box<3>& b, double slack) {
        for (int i = 0; i < 3; ++i)
            if (a.max[i] <= b.min[i] + slack || b.max[i] <= a.min[i] + slack) return false;
        return true;
    };
    const std::vector<Room<3>>& rooms = made.rooms.all;
    for (std::size_t i = 0; i < rooms.size(); ++i)
        for (std::size_t k = i + 1; k < rooms.size(); ++k)
            EXPECT_FALSE(meet(rooms[i].shape, rooms[k].shape, 0)) << rooms[i].name << ", " << rooms[k].name;
    for (std::size_t k = 0; k < made.triangles.size(); ++k) {
        const Box<3> box = bounds<3>({made.triangles[k]});
        for (const Room<3>& room : rooms)
            if (meet(box, room.shape, 1e-4)) {
                EXPECT_TRUE(is_around(room.shape, box.min, 1e-4) && is_around(room.shape, box.max, 1e-4))
                    << made.objects.names[made.objects.of[k]] << " reaches out of " << room.name;
            }
    }
}

// What a scene promises that marks rooms. Only fronts count, as in pictures.
TEST(Campus, FromInsideARoomIsClosedButAtItsPortals) {
    const Generated made = generate::campus(14, 160'000);
    Random random(4);
    std::size_t through = 0, closed = 0;
    for (std::uint32_t r = 0; r < made.rooms.all.size(); ++r) {
        const Box<3>& shape = made.rooms.all[r].shape;
        std::vector<Primitive<3>> inside, border;
        for (std::size_t k = 0; k < made.triangles.size(); ++k) {
            const Primitive<3>& t = made.triangles[k];
            if (!std::all_of(t.begin(), t.end(), [&](const Vec<3>& p) { return is_around(shape, p, 0); })) continue;
            inside.push_back(t);
            const std::string& name = made.objects.names[made.objects.of[k]];
            for (const char* part : {"walls", "floor", "ceiling"})
                if (name.find(part) != std::string::npos) border.push_back(t);
        }
        for (int i = 0; i < 300; ++i) {
            Vec<3> eye, way;
            for (int a = 0; a < 3; ++a) {
                eye[a] = random.uniform(shape.min[a], shape.max[a]);
                way[a] = random.uniform(-1, 1);
            }
            double leaves = std::numeric_limits<double>::infinity();
            for (int a = 0; a < 3; ++a)
                leaves = std::min(leaves, ((way[a] > 0 ? shape.max[a] : shape.min[a]) - eye[a]) / way[a]);
            const Vec<3> at = eye + leaves * way;
            const bool in_portal =
                std::any_of(made.rooms.portals.begin(), made.rooms.portals.end(), [&](const Portal<3>& portal) {
                    return (portal.rooms[0] == r || portal.rooms[1] == r) && is_around(box_of(portal), at, 1e-9);
                });
            const auto fronts = [&](const std::vector<Primitive<3>>& all) {
                std::vector<Primitive<3>> front;
                for (const Primitive<3>& t : all)
                    if (glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), eye - t[0]) > 0) front.push_back(t);
                return front;
            };
            ++(in_portal ? through : closed);
            if (in_portal)
                EXPECT_FALSE(std::isfinite(cast(fronts(border), eye, way).distance)) << made.rooms.all[r].name;
            else
                EXPECT_LE(cast(fronts(inside), eye, way).distance, leaves * (1 + 1e-9)) << made.rooms.all[r].name;
        }
    }
    EXPECT_GT(through, 1'000u);
    EXPECT_GT(closed, 10'000u);
}

// For eyes in the air, in the street and under the ground.
TEST(Campus, FromOutsideRoomsAreClosedButAtTheirPortals) {
    const Generated made = campus_of(14);
    Scene<3> scene;
    scene.primitives = made.triangles;
    scene.rooms = made.rooms;
    const Box<3> around = bounds<3>(made.triangles);
    Random random(5);
    std::size_t through = 0, closed = 0, below = 0;
    while (closed < 700) {
        Vec<3> eye;
        for (int a = 0; a < 3; ++a) eye[a] = random.uniform(around.min[a] - 10, around.max[a] + 10);
        if (!closed_for(scene.rooms, eye)) continue;
        const Room<3>& room = made.rooms.all[random.below(made.rooms.all.size())];
        Vec<3> target;
        for (int a = 0; a < 3; ++a) target[a] = random.uniform(room.shape.min[a], room.shape.max[a]);
        const Vec<3> way = target - eye;
        // Where the way first enters any room: of what lies behind nothing is asked here.
        double enters = 1;
        for (const Room<3>& any : made.rooms.all) {
            double in = 0, out = 1;
            for (int a = 0; a < 3; ++a) {
                const double p = (any.shape.min[a] - eye[a]) / way[a], q = (any.shape.max[a] - eye[a]) / way[a];
                in = std::max(in, std::min(p, q));
                out = std::min(out, std::max(p, q));
            }
            if (in < out) enters = std::min(enters, in);
        }
        const Vec<3> at = eye + enters * way;
        const bool in_portal = std::any_of(
            made.rooms.portals.begin(), made.rooms.portals.end(),
            [&](const Portal<3>& portal) { return portal.rooms[1] == none && is_around(box_of(portal), at, 1e-9); });
        ++(in_portal ? through : closed);
        if (in_portal) continue;
        below += eye.z < 0;
        std::vector<Primitive<3>> fronts;
        for (const Primitive<3>& t : made.triangles)
            if (glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), eye - t[0]) > 0) fronts.push_back(t);
        EXPECT_LE(cast(fronts, eye, way).distance, enters)
            << room.name << " from " << eye.x << " " << eye.y << " " << eye.z;
    }
    EXPECT_GT(through, 3u);
    EXPECT_GT(below, 100u);
}

TEST(Campus, TheWalkLeavesARoomFollowsTheCorridorAndRisesAboveTheRoofs) {
    for (const std::uint64_t seed : {14u, 15u, 16u}) {
        SCOPED_TRACE(seed);
        const Generated made = campus_of(seed);
        const std::vector<ViewSpec<3>>& walk = made.paths[0].frames;
        ASSERT_EQ(walk.size(), 240u);
        std::vector<std::uint32_t> visited;
        std::map<std::uint32_t, int> frames;
        for (const ViewSpec<3>& frame : walk) {
            const std::uint32_t room = room_at(made.rooms, frame.eye);
            if (visited.empty() || visited.back() != room) visited.push_back(room);
            ++frames[room];
            for (const Primitive<3>& t : made.triangles) EXPECT_GE(distance_to(t, frame.eye), 0.2);
        }
        ASSERT_EQ(visited.size(), 3u);
        EXPECT_EQ(made.rooms.all[visited[0]].name, "building 1 / room 101");
        EXPECT_EQ(made.rooms.all[visited[1]].name, "building 1 / corridor 100");
        EXPECT_EQ(visited[2], none);
        EXPECT_GE(frames[visited[0]], 5);
        EXPECT_GE(frames[visited[1]], 20);
        EXPECT_EQ(walk.back().eye.z, 70);
        // A door, not a wall: what is passed between two frames is a portal.
        for (std::size_t i = 1; i < walk.size(); ++i) {
            const std::uint32_t from = room_at(made.rooms, walk[i - 1].eye), to = room_at(made.rooms, walk[i].eye);
            if (from == to) continue;
            const Vec<3> step = walk[i].eye - walk[i - 1].eye;
            EXPECT_TRUE(std::any_of(made.rooms.portals.begin(), made.rooms.portals.end(), [&](const Portal<3>& portal) {
                const int axis = axis_of(portal);
                const double share = (portal.corners[0][axis] - walk[i - 1].eye[axis]) / step[axis];
                return share >= 0 && share <= 1 && is_around(box_of(portal), walk[i - 1].eye + share * step, 1e-9) &&
                       std::set{portal.rooms[0], portal.rooms[1]} == std::set{from, to};
            }));
        }
        // It does not jump, and turns by less than a fifth of a right angle a frame.
        for (std::size_t i = 1; i < walk.size(); ++i) {
            const auto direction = [](const ViewSpec<3>& v) {
                const Vec<3> way = v.look_at - v.eye;
                return way / std::sqrt(glm::dot(way, way));
            };
            const Vec<3> step = walk[i].eye - walk[i - 1].eye;
            EXPECT_LT(std::sqrt(glm::dot(step, step)), 2.0) << i;
            EXPECT_GT(glm::dot(direction(walk[i - 1]), direction(walk[i])), 0.9) << i;
        }
    }
}

/// How far along the way the segment is met; infinity: it is not.
double met_at(const Primitive<2>& s, const Vec<2>& eye, const Vec<2>& way) {
    const auto cross = [](const Vec<2>& a, const Vec<2>& b) { return a.x * b.y - a.y * b.x; };
    const Vec<2> along = s[1] - s[0];
    const double det = cross(way, along);
    if (det == 0) return std::numeric_limits<double>::infinity();
    const double t = cross(s[0] - eye, along) / det, u = cross(s[0] - eye, way) / det;
    return t > 0 && u >= 0 && u <= 1 ? t : std::numeric_limits<double>::infinity();
}

TEST(Campus, ItsPlanHasTheSameRoomsOnTheGround) {
    const Scene<2> plan = make_scene(*find_in_catalogue<2>("campus"));
    const Generated made = campus_of(14);
    EXPECT_EQ(plan.dropped, Dropped{});
    std::size_t on_ground = 0;
    for (const Room<3>& room : made.rooms.all) {
        if (room.shape.min.z > 1) continue;
        ++on_ground;
        const auto same = std::find_if(plan.rooms.all.begin(), plan.rooms.all.end(),
                                       [&](const Room<2>& other) { return other.name == room.name; });
        ASSERT_NE(same, plan.rooms.all.end()) << room.name;
        Box<2> box;
        for (const Vec<2>& p : same->shape) box.add(p);
        EXPECT_EQ(box.min, Vec<2>(room.shape.min.x, room.shape.min.y)) << room.name;
        EXPECT_EQ(box.max, Vec<2>(room.shape.max.x, room.shape.max.y)) << room.name;
    }
    EXPECT_EQ(plan.rooms.all.size(), on_ground);
}

TEST(Campus, RoomsOfThePlanAreClosedButAtTheirPortals) {
    const Scene<2> plan = make_scene(*find_in_catalogue<2>("campus"));
    Random random(4);
    std::size_t through = 0, closed = 0;
    for (std::uint32_t r = 0; r < plan.rooms.all.size(); ++r) {
        const std::vector<Vec<2>>& shape = plan.rooms.all[r].shape;
        ASSERT_EQ(shape.size(), 4u);
        Box<2> box;
        for (std::size_t i = 0; i < 4; ++i) {
            box.add(shape[i]);
            EXPECT_GT(orient(shape[i], shape[(i + 1) % 4], shape[(i + 2) % 4]), 0) << plan.rooms.all[r].name;
        }
        for (int i = 0; i < 500; ++i) {
            Vec<2> eye, way;
            for (int a = 0; a < 2; ++a) {
                eye[a] = random.uniform(box.min[a], box.max[a]);
                way[a] = random.uniform(-1, 1);
            }
            double leaves = std::numeric_limits<double>::infinity();
            for (int a = 0; a < 2; ++a)
                leaves = std::min(leaves, ((way[a] > 0 ? box.max[a] : box.min[a]) - eye[a]) / way[a]);
            const Vec<2> at = eye + leaves * way;
            const bool in_portal =
                std::any_of(plan.rooms.portals.begin(), plan.rooms.portals.end(), [&](const Portal<2>& portal) {
                    Box<2> gap;
                    for (const Vec<2>& p : portal.corners) gap.add(p);
                    return (portal.rooms[0] == r || portal.rooms[1] == r) && at.x > gap.min.x - 1e-9 &&
                           at.x < gap.max.x + 1e-9 && at.y > gap.min.y - 1e-9 && at.y < gap.max.y + 1e-9;
                });
            double nearest = std::numeric_limits<double>::infinity(), on_border = nearest;
            for (const Primitive<2>& s : plan.primitives) {
                const double t = met_at(s, eye, way);
                nearest = std::min(nearest, t);
                if (t > leaves * (1 - 1e-9) && t < leaves * (1 + 1e-9)) on_border = t;
            }
            ++(in_portal ? through : closed);
            if (in_portal)
                EXPECT_FALSE(std::isfinite(on_border)) << plan.rooms.all[r].name;
            else
                EXPECT_LE(nearest, leaves * (1 + 1e-9)) << plan.rooms.all[r].name;
        }
    }
    EXPECT_GT(through, 1'000u);
    EXPECT_GT(closed, 10'000u);
}

TEST(Campus, LinesOfThePlanDoNotCross) {
    for (const std::uint64_t seed : {14u, 15u, 16u}) {
        const std::vector<Primitive<2>> all = find_in_catalogue<2>("campus")->generate(seed);
        std::size_t crossings = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = i + 1; j < all.size(); ++j) {
                const auto &a = all[i], &b = all[j];
                crossings += orient(a[0], a[1], b[0]) * orient(a[0], a[1], b[1]) < 0 &&
                             orient(b[0], b[1], a[0]) * orient(b[0], b[1], a[1]) < 0;
            }
        EXPECT_EQ(crossings, 0u) << seed;
    }
}

}  // namespace
}  // namespace sightline
