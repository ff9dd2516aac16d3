// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/portals/pvs.h"

#include <algorithm>

#include "core/geometry/predicates.h"
#include "core/methods/portals/stab.h"

namespace sightline {

namespace {

/// A portal is reached by so many ways, each with all of its portals, from either side; then once more by itself.
constexpr std::uint32_t ways_apart = 32;

constexpr int shadow_planes(int d) { return d == 2 ? 1 : 3; }

/// In the plane that leaves out an axis; 2D: the point itself.
Vec<2> shadow(const Vec<2>& p, int) { return p; }
Vec<2> shadow(const Vec<3>& p, int plane) { return {p[(plane + 1) % 3], p[(plane + 2) % 3]}; }

/// The portal in the plane as a segment that is passed from the side of `near`; false: it is none there.
template <int D>
bool shadow_of(const Portal<D>& portal, const Vec<D>& near, int plane, Doorway2& doorway) {
    Vec<2> a = shadow(portal.corners[0], plane), b = a;
    const auto less = [](const Vec<2>& p, const Vec<2>& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); };
    for (const Vec<D>& corner : portal.corners) {
        const Vec<2> p = shadow(corner, plane);
        if (less(p, a)) a = p;
        if (less(b, p)) b = p;
    }
    for (const Vec<D>& corner : portal.corners)
        if (orient(a, b, shadow(corner, plane)) != 0) return false;
    const int side = orient(a, b, shadow(near, plane));
    if (side == 0) return false;
    doorway = side > 0 ? Doorway2{b, a} : Doorway2{a, b};
    return true;
}

template <int D>
class WaySearch {
public:
    WaySearch(const Scene<D>& scene, const RoomGraph<D>& graph, std::uint32_t room) : scene_(scene), graph_(graph) {
        found_.assign(scene.primitives.size(), 0);
        place_.assign(graph.outside() + 1, none);
        reached_.assign(2 * scene.rooms.portals.size(), 0);
        enter(room, none);
        for (const std::uint32_t primitive : graph.contents.of(room)) take(room, primitive);
        leave(none, room);
        for (std::uint32_t way = 0; way < ways_.size(); ++way) {
            look(way);
            leave(way, ways_[way].room);
        }
    }

    SeenFromRoom take_all() {
        for (std::size_t i = 0; i < rooms_.size(); ++i) {
            SeenRoom& room = rooms_[i];
            std::sort(held_[i].begin(), held_[i].end());
            room.begin = static_cast<std::uint32_t>(seen_.primitives.size());
            seen_.primitives.insert(seen_.primitives.end(), held_[i].begin(), held_[i].end());
            room.end = static_cast<std::uint32_t>(seen_.primitives.size());
            if (room.begin < room.end || i == 0) seen_.rooms.push_back(room);
        }
        seen_.ways = static_cast<std::uint32_t>(ways_.size());
        return std::move(seen_);
    }

private:
    static constexpr int planes = shadow_planes(D);
    struct Way {
        std::uint32_t before = none, portal = none, room = 0;
        std::array<bool, planes> bound{};   ///< whether lines in that plane have passed anything
        std::array<bool, planes> passes{};  ///< whether this portal is a segment there
        std::array<Doorway2, planes> doorway{};
        std::array<StabbingLines, planes> lines{};
    };

    void enter(std::uint32_t room, std::uint32_t portal) {
        if (place_[room] != none) return;
        place_[room] = static_cast<std::uint32_t>(rooms_.size());
        rooms_.push_back({room, portal});
        held_.emplace_back();
    }
    void take(std::uint32_t room, std::uint32_t primitive) {
        found_[primitive] = 1;
        held_[place_[room]].push_back(primitive);
    }
    /// The segments that a way has passed in a plane.
    void passed(std::uint32_t way, int plane, std::vector<Doorway2>& all) const {
        all.clear();
        for (; way != none; way = ways_[way].before)
            if (ways_[way].passes[plane]) all.push_back(ways_[way].doorway[plane]);
    }

    void leave(std::uint32_t way, std::uint32_t room) {
        const bool outside = room == graph_.outside();
        if (outside && scene_.rooms.closed_from == std::numeric_limits<double>::infinity()) return;  // looked at whole
        for (const std::uint32_t id : graph_.portals_of(room)) {
            if (way != none && id == ways_[way].portal) continue;
            const Portal<D>& portal = scene_.rooms.portals[id];
            Way next;
            next.before = way, next.portal = id, next.room = graph_.beyond(portal, room);
            Vec<D> near = graph_.middles[outside ? next.room : room];
            if (outside) near = portal.corners[0] + (portal.corners[0] - near);
            std::uint32_t& reached = reached_[2 * id + (portal.rooms[1] == (outside ? none : room))];
            if (reached > ways_apart) continue;
            bool open = true;
            for (int plane = 0; plane < planes && open; ++plane) {
                next.passes[plane] = shadow_of(portal, near, plane, next.doorway[plane]);
                if (way != none)
                    next.bound[plane] = ways_[way].bound[plane], next.lines[plane] = ways_[way].lines[plane];
                if (!next.passes[plane]) continue;
                if (next.bound[plane]) {
                    passed(way, plane, scratch_);
                    open = stab(ways_[way].lines[plane], scratch_, next.doorway[plane], next.lines[plane]);
                }
            }
            if (!open) continue;
            if (++reached > ways_apart) {
                next.before = none;
                ++seen_.cut_short;
            }
            for (int plane = 0; plane < planes; ++plane) {
                if (next.before == none) next.bound[plane] = false;
                if (next.bound[plane] || !next.passes[plane]) continue;
                next.bound[plane] = true;
                next.lines[plane] = StabbingLines(next.doorway[plane]);
            }
            ways_.push_back(next);
        }
    }

    /// Whether one of the lines meets the primitive: one of its sides in every plane.
    bool may_meet(const Way& way, const Primitive<D>& primitive) {
        for (int plane = 0; plane < planes; ++plane) {
            if (!way.bound[plane]) continue;
            bool meets = false;
            for (std::size_t i = 0; i < (D == 2 ? 1 : 3) && !meets; ++i) {
                const Vec<2> a = shadow(primitive[i], plane), b = shadow(primitive[(i + 1) % D], plane);
                StabbingLines narrower;
                meets = a != b && (stab(way.lines[plane], passed_[plane], {a, b}, narrower) ||
                                   stab(way.lines[plane], passed_[plane], {b, a}, narrower));
            }
            if (!meets) return false;
        }
        return true;
    }
    void look(std::uint32_t index) {
        const Way way = ways_[index];
        for (int plane = 0; plane < planes; ++plane) passed(index, plane, passed_[plane]);
        enter(way.room, way.portal);
        const auto test = [&](std::uint32_t primitive) {
            if (!found_[primitive] && may_meet(way, scene_.primitives[primitive])) take(way.room, primitive);
        };
        if (way.room == graph_.outside() && scene_.rooms.closed_from == std::numeric_limits<double>::infinity())
            for (std::uint32_t primitive = 0; primitive < found_.size(); ++primitive) test(primitive);
        else
            for (const std::uint32_t primitive : graph_.contents.of(way.room)) test(primitive);
    }

    const Scene<D>& scene_;
    const RoomGraph<D>& graph_;
    std::vector<Way> ways_;
    std::vector<std::uint8_t> found_;     ///< per primitive
    std::vector<std::uint32_t> place_;    ///< per room: in rooms_
    std::vector<std::uint32_t> reached_;  ///< per portal and side
    std::vector<SeenRoom> rooms_;
    std::vector<std::vector<std::uint32_t>> held_;
    std::vector<Doorway2> scratch_;
    std::array<std::vector<Doorway2>, planes> passed_;
    SeenFromRoom seen_;
};

}  // namespace

template <int D>
SeenFromRoom seen_from_room(const Scene<D>& scene, const RoomGraph<D>& graph, std::uint32_t room) {
    return WaySearch<D>(scene, graph, room).take_all();
}

template <int D>
std::shared_ptr<const RoomSets<D>> room_sets(const Problem<D>& problem) {
    return problem.cells->made->template of<RoomSets<D>>("pvs",
                                                         [&] { return RoomSets<D>(problem.scene->rooms.all.size()); });
}

#define SIGHTLINE_INSTANTIATE(D)                                                                  \
    template SeenFromRoom seen_from_room<D>(const Scene<D>&, const RoomGraph<D>&, std::uint32_t); \
    template std::shared_ptr<const RoomSets<D>> room_sets<D>(const Problem<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
