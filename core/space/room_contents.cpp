// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/room_contents.h"

#include <algorithm>
#include <set>

#include "core/geometry/predicates.h"
#include "core/space/box_tree.h"
#include "core/space/triangle_test.h"

namespace sightline {

namespace {

using EdgeKey = std::array<double, 4>;

Box<2> box_of(const Room<2>& room) {
    Box<2> box;
    for (const Vec<2>& p : room.shape) box.add(p);
    return box;
}
Box<3> box_of(const Room<3>& room) { return room.shape; }

template <int D>
bool overlap(const Box<D>& a, const Box<D>& b) {
    for (int i = 0; i < D; ++i)
        if (a.min[i] > b.max[i] || a.max[i] < b.min[i]) return false;
    return true;
}

/// Whether the closed segment meets the closed room.
bool meets_room(const Room<2>& room, const Primitive<2>& segment) {
    if (holds(room, segment[0]) || holds(room, segment[1])) return true;
    for (std::size_t i = 0; i < room.shape.size(); ++i)
        if (segments_meet(segment[0], segment[1], room.shape[i], room.shape[(i + 1) % room.shape.size()])) return true;
    return false;
}
bool meets_room(const Room<3>& room, const Primitive<3>& triangle) { return TriangleTest(triangle).meets(room.shape); }

/// Of a primitive in the room's closure: whether all of it that has a size lies inside, or can only be seen from there.
bool is_of_it_alone(const Room<2>& room, const Primitive<2>& segment, bool) {
    for (std::size_t i = 0; i < room.shape.size(); ++i) {
        const Vec<2>&a = room.shape[i], &b = room.shape[(i + 1) % room.shape.size()];
        if (orient(a, b, segment[0]) == 0 && orient(a, b, segment[1]) == 0) return false;
    }
    return true;
}
bool is_of_it_alone(const Room<3>& room, const Primitive<3>& triangle, bool two_sided) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double plane : {room.shape.min[axis], room.shape.max[axis]})
            if (triangle[0][axis] == plane && triangle[1][axis] == plane && triangle[2][axis] == plane)
                return !two_sided && orient(triangle[0], triangle[1], triangle[2], room.shape.centre()) > 0;
    return true;
}

/// What of the rooms' borders may be that of the outside.
template <int D>
struct Exposed {
    explicit Exposed(const Rooms<D>&) {}
    bool meets(const Primitive<D>&) const { return true; }
};
/// Edges that are not those of another room from the other side.
template <>
struct Exposed<2> {
    explicit Exposed(const Rooms<2>& rooms) {
        std::set<EdgeKey> known;
        const auto each = [&](auto what) {
            for (const Room<2>& room : rooms.all)
                for (std::size_t i = 0; i < room.shape.size(); ++i)
                    what(room.shape[i], room.shape[(i + 1) % room.shape.size()]);
        };
        each([&](const Vec<2>& a, const Vec<2>& b) { known.insert({a.x, a.y, b.x, b.y}); });
        each([&](const Vec<2>& a, const Vec<2>& b) {
            if (!known.contains({b.x, b.y, a.x, a.y})) edges.push_back({a, b});
        });
    }
    bool meets(const Primitive<2>& segment) const {
        const Box<2> box = sightline::bounds<2>({segment});
        return std::any_of(edges.begin(), edges.end(), [&](const Primitive<2>& edge) {
            return overlap(box, sightline::bounds<2>({edge})) &&
                   segments_meet(segment[0], segment[1], edge[0], edge[1]);
        });
    }
    std::vector<Primitive<2>> edges;
};

/// Boxes that overlap another one.
template <int D>
class RoomFinder {
public:
    explicit RoomFinder(const std::vector<Box<D>>& boxes) : boxes_(boxes) {
        std::vector<Primitive<D>> diagonals;
        for (const Box<D>& box : boxes) {
            diagonals.emplace_back().fill(box.max);
            diagonals.back()[0] = box.min;
        }
        tree_ = build_box_tree<D>(diagonals, 4);
    }
    void find(const Box<D>& box, std::vector<std::uint32_t>& found) const {
        found.clear();
        std::vector<std::uint32_t> nodes;
        if (!tree_.nodes.empty()) nodes.push_back(0);
        while (!nodes.empty()) {
            const std::uint32_t node = nodes.back();
            nodes.pop_back();
            const auto& at = tree_.nodes[node];
            if (!overlap(box, at.box)) continue;
            if (at.first_child != none) {
                nodes.insert(nodes.end(), {at.first_child, at.first_child + 1});
                continue;
            }
            for (const std::uint32_t room : tree_.primitives_of(node))
                if (overlap(box, boxes_[room])) found.push_back(room);
        }
        std::sort(found.begin(), found.end());
    }

private:
    const std::vector<Box<D>>& boxes_;
    BoxTree<D> tree_;
};

}  // namespace

template <int D>
RoomContents room_contents(const Scene<D>& scene) {
    const Rooms<D>& rooms = scene.rooms;
    const auto count = static_cast<std::uint32_t>(scene.primitives.size());
    std::vector<Box<D>> boxes;
    for (const Room<D>& room : rooms.all) boxes.push_back(box_of(room));
    const Exposed<D> exposed(rooms);
    const RoomFinder<D> finder(boxes);
    std::vector<std::uint32_t> near;
    std::vector<std::vector<std::uint32_t>> held(rooms.all.size());
    RoomContents contents;
    contents.outside.assign(count, 0);
    for (std::uint32_t p = 0; p < count; ++p) {
        const Primitive<D>& primitive = scene.primitives[p];
        const Box<D> box = bounds<D>({primitive});
        bool alone = false, begins_in_one = false;
        finder.find(box, near);
        for (const std::uint32_t r : near) {
            if (!meets_room(rooms.all[r], primitive)) continue;
            held[r].push_back(p);
            begins_in_one = begins_in_one || holds(rooms.all[r], primitive[0]);
            const auto holds_corner = [&](const Vec<D>& corner) { return holds(rooms.all[r], corner); };
            alone = alone || (std::all_of(primitive.begin(), primitive.end(), holds_corner) &&
                              is_of_it_alone(rooms.all[r], primitive, shows_both_sides(scene, p)));
        }
        contents.outside[p] = !alone && (!begins_in_one || exposed.meets(primitive));
    }
    for (const auto& row : held) {
        contents.primitives.insert(contents.primitives.end(), row.begin(), row.end());
        contents.begin.push_back(static_cast<std::uint32_t>(contents.primitives.size()));
    }
    for (std::uint32_t p = 0; p < count; ++p)
        if (contents.outside[p]) contents.primitives.push_back(p);
    contents.begin.push_back(static_cast<std::uint32_t>(contents.primitives.size()));
    return contents;
}

template RoomContents room_contents<2>(const Scene<2>&);
template RoomContents room_contents<3>(const Scene<3>&);

}  // namespace sightline
