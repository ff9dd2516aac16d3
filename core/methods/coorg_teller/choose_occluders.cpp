// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/choose_occluders.h"

#include <algorithm>
#include <unordered_map>

#include "core/methods/coorg_teller/occluder_region.h"
#include "core/methods/coorg_teller/shadow.h"

namespace sightline {

namespace {

bool is_before_plane(const Scene<2>& scene, std::uint32_t primitive, bool behind, const Vec<2>& p) {
    const Primitive<2>& s = scene.primitives[primitive];
    return orient(s[0], s[1], p) * (behind ? -1 : 1) > 0;
}
bool is_before_plane(const Scene<3>& scene, std::uint32_t primitive, bool behind, const Vec<3>& p) {
    const Primitive<3>& t = scene.primitives[primitive];
    return orient(t[0], t[1], t[2], p) * (behind ? -1 : 1) > 0;
}

/// Whether no corner of `b` lies before a plane of `a`.
template <int D>
bool lies_behind(const Scene<D>& scene, const Polygons<D>& polygons, std::uint32_t b, std::uint32_t a, bool behind) {
    for (const std::uint32_t primitive : polygons.planes_of(a))
        for (const auto& side : polygons.sides_of(b))
            if (is_before_plane(scene, primitive, behind, polygons.points[side.point])) return false;
    return true;
}

}  // namespace

template <int D>
std::vector<Candidate> potential_occluders(const Prepared<D>& prepared, const Scene<D>& scene, const View<D>& view,
                                           std::size_t count) {
    const Polygons<D>& polygons = prepared.polygons;
    const Vec<D>& eye = view.eye;
    const auto can_hide = [&](std::uint32_t polygon) {
        if (side_seen(scene, polygons, polygon, eye) == 0) return false;
        const auto members = polygons.members_of(polygon);
        return std::any_of(members.begin(), members.end(),
                           [&](std::uint32_t member) { return in_view(view, scene.primitives[member]); });
    };
    std::vector<Candidate> found;
    for (const std::uint32_t polygon : prepared.near(eye)) {
        double value = area_angle<D>(polygons.area[polygon], polygons.centre[polygon], eye);
        if (polygons.two_sided[polygon]) value = std::abs(value);
        if (value >= prepared.threshold) found.push_back({value, polygon});
    }
    const auto larger = [](const Candidate& a, const Candidate& b) {
        return a.area_angle != b.area_angle ? a.area_angle > b.area_angle : a.polygon < b.polygon;
    };
    // Sorted piece by piece, as far as anybody asks: few of many are large.
    std::vector<Candidate> seen;
    std::size_t begin = 0;
    while (seen.size() < count && begin < found.size()) {
        const std::size_t end = std::min(found.size() - begin, count == none ? found.size() : count) + begin;
        const auto at = [&](std::size_t i) { return found.begin() + static_cast<std::ptrdiff_t>(i); };
        std::partial_sort(at(begin), at(end), found.end(), larger);
        for (; begin < end && seen.size() < count; ++begin)
            if (can_hide(found[begin].polygon)) seen.push_back(found[begin]);
    }
    return seen;
}

OccluderLists single_occluders(std::span<const Candidate> chosen) {
    OccluderLists all;
    for (const Candidate& candidate : chosen) all.push_back({candidate.polygon});
    return all;
}

template <int D>
OccluderLists convex_occluders(const Prepared<D>& prepared, const Scene<D>& scene, const Vec<D>& eye,
                               std::span<const Candidate> potential, std::size_t count) {
    const Polygons<D>& polygons = prepared.polygons;
    struct Seen {
        bool behind = false, taken = false;
    };
    std::unordered_map<std::uint32_t, Seen> seen;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> at_edge;
    for (const Candidate& candidate : potential) {
        seen[candidate.polygon].behind = side_seen(scene, polygons, candidate.polygon, eye) < 0;
        for (const auto& side : polygons.sides_of(candidate.polygon)) at_edge[side.edge].push_back(candidate.polygon);
    }
    OccluderLists all;
    for (const Candidate& candidate : potential) {
        if (all.size() == count) break;
        if (seen[candidate.polygon].taken) continue;
        seen[candidate.polygon].taken = true;
        std::vector<std::uint32_t> body{candidate.polygon};
        for (std::size_t next = 0; next < body.size(); ++next)
            for (const auto& side : polygons.sides_of(body[next]))
                for (const std::uint32_t other : at_edge[side.edge]) {
                    if (seen[other].taken) continue;
                    if (!std::all_of(body.begin(), body.end(), [&](std::uint32_t member) {
                            return lies_behind(scene, polygons, other, member, seen[member].behind) &&
                                   lies_behind(scene, polygons, member, other, seen[other].behind);
                        }))
                        continue;
                    seen[other].taken = true;
                    body.push_back(other);
                }
        std::sort(body.begin(), body.end());
        all.push_back(std::move(body));
    }
    return all;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                                \
    template std::vector<Candidate> potential_occluders<D>(const Prepared<D>&, const Scene<D>&, const View<D>&, \
                                                           std::size_t);                                        \
    template OccluderLists convex_occluders<D>(const Prepared<D>&, const Scene<D>&, const Vec<D>&,              \
                                               std::span<const Candidate>, std::size_t);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
