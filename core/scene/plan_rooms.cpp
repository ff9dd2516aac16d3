// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/plan_rooms.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/geometry/plan_mesh.h"
#include "core/geometry/predicates.h"

namespace sightline {

namespace {

constexpr std::uint8_t wall_bit = 1, opening_bit = 2;

/// Triangles that can be reached from outside.
std::vector<std::uint8_t> open_triangles(const PlanMesh& mesh) {
    std::vector<std::uint8_t> open(mesh.triangles());
    std::vector<std::uint32_t> waiting;
    const auto reach = [&](std::uint32_t triangle) {
        if (open[triangle]) return;
        open[triangle] = 1;
        waiting.push_back(triangle);
    };
    for (std::uint32_t half = 0; half < mesh.from.size(); ++half)
        if (mesh.twin[half] == none && !mesh.kept[half]) reach(half / 3);
    while (!waiting.empty()) {
        const std::uint32_t triangle = waiting.back();
        waiting.pop_back();
        for (std::uint32_t half = 3 * triangle; half < 3 * triangle + 3; ++half)
            if (mesh.twin[half] != none && !mesh.kept[half]) reach(mesh.twin[half] / 3);
    }
    return open;
}

/// Rings of half-edges about convex parts, made larger by taking edges out between them (Hertel and Mehlhorn 1983),
/// the longest first.
class ConvexParts {
public:
    ConvexParts(const PlanMesh& mesh, const std::vector<std::uint8_t>& open) : mesh_(mesh) {
        const auto count = static_cast<std::uint32_t>(mesh.from.size());
        next_.resize(count), before_.resize(count), alive_.resize(count);
        for (std::uint32_t half = 0; half < count; ++half) {
            next_[half] = PlanMesh::next(half);
            before_[next_[half]] = half;
            alive_[half] = !open[half / 3];
        }
        std::vector<std::uint32_t> cuts;
        for (std::uint32_t half = 0; half < count; ++half)
            if (mesh.twin[half] != none && mesh.twin[half] > half && !mesh.kept[half] && alive_[half])
                cuts.push_back(half);
        std::stable_sort(cuts.begin(), cuts.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return length(a) > length(b); });
        for (const std::uint32_t half : cuts) take_out(half);
    }

    /// The rings: rooms[half] of each half-edge; none: of no room.
    std::vector<std::vector<std::uint32_t>> rings(std::vector<std::uint32_t>& room_of) const {
        std::vector<std::vector<std::uint32_t>> all;
        room_of.assign(next_.size(), none);
        for (std::uint32_t first = 0; first < next_.size(); ++first) {
            if (!alive_[first] || room_of[first] != none) continue;
            std::vector<std::uint32_t>& ring = all.emplace_back();
            std::uint32_t half = first;
            do {
                room_of[half] = static_cast<std::uint32_t>(all.size() - 1);
                ring.push_back(half);
                half = next_[half];
            } while (half != first);
        }
        return all;
    }

private:
    double length(std::uint32_t half) const {
        const Vec<2> way = mesh_.points[mesh_.to(half)] - mesh_.points[mesh_.from[half]];
        return glm::dot(way, way);
    }
    const Vec<2>& start(std::uint32_t half) const { return mesh_.points[mesh_.from[half]]; }

    void take_out(std::uint32_t half) {
        const std::uint32_t other = mesh_.twin[half];
        const std::uint32_t a = before_[half], b = next_[other], c = before_[other], d = next_[half];
        const auto is_convex = [&](std::uint32_t into, std::uint32_t out) {
            return orient(start(into), start(out), mesh_.points[mesh_.from[next_[out]]]) >= 0;
        };
        if (mesh_.twin[a] == b || mesh_.twin[c] == d || !is_convex(a, b) || !is_convex(c, d)) return;
        next_[a] = b, before_[b] = a, next_[c] = d, before_[d] = c;
        alive_[half] = alive_[other] = 0;
    }

    const PlanMesh& mesh_;
    std::vector<std::uint32_t> next_, before_;
    std::vector<std::uint8_t> alive_;
};

/// Whether it lies on a side of a room.
bool lies_on_a_border(const std::vector<Primitive<2>>& sides, const Primitive<2>& segment) {
    const Box<2> box = bounds<2>({segment});
    return std::any_of(sides.begin(), sides.end(), [&](const Primitive<2>& side) {
        const Box<2> around = bounds<2>({side});
        for (int i = 0; i < 2; ++i)
            if (box.min[i] > around.max[i] || box.max[i] < around.min[i]) return false;
        return orient(side[0], side[1], segment[0]) == 0 && orient(side[0], side[1], segment[1]) == 0;
    });
}

using EndPoints = std::array<double, 4>;
EndPoints end_points(const Primitive<2>& s) { return {s[0].x, s[0].y, s[1].x, s[1].y}; }

std::set<EndPoints> segments_of(const Scene<2>& scene) {
    std::set<EndPoints> all;
    for (const Primitive<2>& segment : scene.primitives) all.insert(end_points(segment));
    return all;
}

}  // namespace

Rooms<2> rooms_after_edit(const Scene<2>& before, const Scene<2>& after) {
    std::vector<Primitive<2>> sides, openings, walls;
    for (const Room<2>& room : before.rooms.all)
        for (std::size_t i = 0; i < room.shape.size(); ++i)
            sides.push_back({room.shape[i], room.shape[(i + 1) % room.shape.size()]});
    const std::set<EndPoints> then = segments_of(before), now = segments_of(after);
    const bool stands = std::all_of(before.primitives.begin(), before.primitives.end(), [&](const Primitive<2>& s) {
        return now.contains(end_points(s)) || !lies_on_a_border(sides, s);
    });
    if (stands) return before.rooms;
    for (const Primitive<2>& segment : after.primitives)
        if (!then.contains(end_points(segment)) || lies_on_a_border(sides, segment)) walls.push_back(segment);
    for (const Portal<2>& portal : before.rooms.portals) openings.push_back({portal.corners[0], portal.corners[1]});
    return plan_rooms(walls, openings);
}

Rooms<2> plan_rooms(std::span<const Primitive<2>> walls, std::span<const Primitive<2>> openings) {
    std::vector<PlanLine> lines;
    for (const Primitive<2>& wall : walls) lines.push_back({wall, wall_bit});
    for (const Primitive<2>& opening : openings) lines.push_back({opening, opening_bit});
    const PlanMesh mesh = triangulate_plan(lines);
    const ConvexParts parts(mesh, open_triangles(mesh));
    std::vector<std::uint32_t> room_of;
    Rooms<2> rooms;
    for (const std::vector<std::uint32_t>& ring : parts.rings(room_of)) {
        Room<2>& room = rooms.all.emplace_back();
        room.name = std::to_string(rooms.all.size() - 1);
        for (const std::uint32_t half : ring) room.shape.push_back(mesh.points[mesh.from[half]]);
    }
    for (std::uint32_t half = 0; half < mesh.from.size(); ++half) {
        if (room_of[half] == none || (mesh.kept[half] & wall_bit)) continue;
        const std::uint32_t twin = mesh.twin[half], beyond = twin == none ? none : room_of[twin];
        if (beyond != none && twin < half) continue;  // once
        rooms.portals.push_back({{room_of[half], beyond}, {mesh.points[mesh.from[half]], mesh.points[mesh.to(half)]}});
    }
    return rooms;
}

}  // namespace sightline
