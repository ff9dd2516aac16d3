// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/rooms.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/geometry/predicates.h"

namespace sightline {

namespace {

/// The least of the sides on which p lies of a polygon's edges: 1 inside, 0 on the border, -1 outside.
int side_of(const std::vector<Vec<2>>& polygon, const Vec<2>& p) {
    int side = 1;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        side = std::min(side, orient(polygon[i], polygon[(i + 1) % polygon.size()], p));
    return side;
}

/// Whether the point lies on the portal without its ends (3D: on the closed polygon; boxes have portals that fill it).
bool lies_within(const Portal<2>& portal, const Vec<2>& p) {
    const Vec<2>&a = portal.corners[0], &b = portal.corners[1];
    if (orient(a, b, p) != 0 || p == a || p == b) return false;
    return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
           p.y <= std::max(a.y, b.y);
}
bool lies_within(const Portal<3>&, const Vec<3>&) { return false; }

void check_shape(const Room<2>& room, const std::string& name) {
    const std::vector<Vec<2>>& shape = room.shape;
    bool has_area = false;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const Vec<2>&a = shape[i], &b = shape[(i + 1) % shape.size()], &c = shape[(i + 2) % shape.size()];
        if (!is_finite(a)) throw InputError(name + ": corner " + std::to_string(i) + " is not finite");
        if (orient(a, b, c) < 0 || a == b)
            throw InputError(name + ": not convex and counter-clockwise at corner " +
                             std::to_string((i + 1) % shape.size()));
        has_area |= orient(a, b, c) > 0;
    }
    if (!has_area) throw InputError(name + ": has no area");
}
void check_shape(const Room<3>& room, const std::string& name) {
    for (int i = 0; i < 3; ++i)
        if (!(room.shape.min[i] < room.shape.max[i])) throw InputError(name + ": a box without a volume");
}

bool is_on_border(const Room<2>& room, const Portal<2>& portal) {
    for (std::size_t i = 0; i < room.shape.size(); ++i) {
        const Vec<2>&a = room.shape[i], &b = room.shape[(i + 1) % room.shape.size()];
        if (orient(a, b, portal.corners[0]) == 0 && orient(a, b, portal.corners[1]) == 0)
            return holds(room, portal.corners[0]) && holds(room, portal.corners[1]);
    }
    return false;
}
bool is_on_border(const Room<3>& room, const Portal<3>& portal) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double plane : {room.shape.min[axis], room.shape.max[axis]})
            if (std::all_of(portal.corners.begin(), portal.corners.end(),
                            [&](const Vec<3>& p) { return p[axis] == plane && room.shape.contains(p); }))
                return true;
    return false;
}

bool has_size(const Portal<2>& portal) { return portal.corners.size() == 2 && portal.corners[0] != portal.corners[1]; }
bool has_size(const Portal<3>& portal) {
    if (portal.corners.size() < 3) return false;
    const Vec<3> normal = glm::cross(portal.corners[1] - portal.corners[0], portal.corners[2] - portal.corners[0]);
    return normal != Vec<3>(0);
}

}  // namespace

bool holds(const Room<2>& room, const Vec<2>& p) { return side_of(room.shape, p) >= 0; }
bool holds(const Room<3>& room, const Vec<3>& p) { return room.shape.contains(p); }
bool holds_inside(const Room<2>& room, const Vec<2>& p) { return side_of(room.shape, p) > 0; }
bool holds_inside(const Room<3>& room, const Vec<3>& p) {
    for (int i = 0; i < 3; ++i)
        if (!(p[i] > room.shape.min[i] && p[i] < room.shape.max[i])) return false;
    return true;
}

template <int D>
RoomsAt rooms_at(const Rooms<D>& rooms, const Vec<D>& eye) {
    RoomsAt found;
    found.outside = true;
    for (std::uint32_t i = 0; i < rooms.all.size(); ++i) {
        if (!holds(rooms.all[i], eye)) continue;
        found.rooms.push_back(i);
        if (holds_inside(rooms.all[i], eye)) found.outside = false;
    }
    if (found.outside && !found.rooms.empty())
        for (const Portal<D>& portal : rooms.portals)
            if (portal.rooms[0] != none && portal.rooms[1] != none && lies_within(portal, eye)) found.outside = false;
    return found;
}

template <int D>
bool closed_for(const Rooms<D>& rooms, const Vec<D>& eye) {
    if constexpr (D == 2) {
        return rooms.closed_from == 0;
    } else {
        return std::all_of(rooms.all.begin(), rooms.all.end(), [&](const Room<3>& room) {
            double away = 0;
            for (int i = 0; i < 3; ++i) away = std::max({away, room.shape.min[i] - eye[i], eye[i] - room.shape.max[i]});
            return away > rooms.closed_from;
        });
    }
}

Vec<2> middle_of(const Room<2>& room) {
    Vec<2> sum(0);
    for (const Vec<2>& p : room.shape) sum += p;
    return sum / static_cast<double>(room.shape.size());
}
Vec<3> middle_of(const Room<3>& room) { return room.shape.centre(); }

template <int D>
void check_rooms(const Rooms<D>& rooms, const std::string& name) {
    for (std::size_t i = 0; i < rooms.all.size(); ++i)
        check_shape(rooms.all[i], name + ": room " + std::to_string(i) + " (" + rooms.all[i].name + ")");
    for (std::size_t i = 0; i < rooms.portals.size(); ++i) {
        const Portal<D>& portal = rooms.portals[i];
        const std::string here = name + ": portal " + std::to_string(i);
        if (portal.rooms[0] == portal.rooms[1]) throw InputError(here + ": leads from a room into itself");
        if (!has_size(portal)) throw InputError(here + ": has no size");
        for (const std::uint32_t room : portal.rooms) {
            if (room == none) continue;
            if (room >= rooms.all.size())
                throw InputError(here + ": room " + std::to_string(room) + " of " + std::to_string(rooms.all.size()));
            if (!is_on_border(rooms.all[room], portal))
                throw InputError(here + ": does not lie on the border of room " + std::to_string(room) + " (" +
                                 rooms.all[room].name + ")");
        }
    }
}

std::vector<Portal<3>> portals_between(const std::vector<Room<3>>& rooms) {
    std::vector<Portal<3>> portals;
    std::vector<std::uint32_t> by_x(rooms.size());
    for (std::uint32_t i = 0; i < rooms.size(); ++i) by_x[i] = i;
    std::stable_sort(by_x.begin(), by_x.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return rooms[a].shape.min.x < rooms[b].shape.min.x; });
    for (std::size_t first = 0; first < by_x.size(); ++first)
        for (std::size_t second = first + 1; second < by_x.size(); ++second) {
            const std::uint32_t i = by_x[first], j = by_x[second];
            if (rooms[j].shape.min.x > rooms[i].shape.max.x) break;
            const Vec<3> low = glm::max(rooms[i].shape.min, rooms[j].shape.min);
            const Vec<3> high = glm::min(rooms[i].shape.max, rooms[j].shape.max);
            int flat = -1, wide = 0;
            for (int axis = 0; axis < 3; ++axis) {
                wide += low[axis] < high[axis];
                if (low[axis] == high[axis]) flat = axis;
            }
            if (flat < 0 || wide != 2) continue;
            const int u = (flat + 1) % 3, v = (flat + 2) % 3;
            Portal<3> portal{{i, j}, {4, low}};
            portal.corners[1][u] = portal.corners[2][u] = high[u];
            portal.corners[2][v] = portal.corners[3][v] = high[v];
            portals.push_back(std::move(portal));
        }
    return portals;
}

#define SIGHTLINE_INSTANTIATE(D)                                  \
    template RoomsAt rooms_at<D>(const Rooms<D>&, const Vec<D>&); \
    template bool closed_for<D>(const Rooms<D>&, const Vec<D>&);  \
    template void check_rooms<D>(const Rooms<D>&, const std::string&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
