// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/trig.h"
#include "core/scene/clean.h"
#include "core/scene/ray_tree.h"

namespace sightline {

namespace {

constexpr double fov = 60;
constexpr std::size_t columns = 32;                                         ///< of rays all round an eye
constexpr std::array elevations{-25.0, -15.0, -7.0, 0.0, 7.0, 15.0, 25.0};  ///< degrees, of its rows
constexpr std::size_t width = 7;                                            ///< columns in a view, about 75 degrees
constexpr std::size_t per_side = 12;  ///< places along a side where floors are sought
constexpr std::size_t most_eyes = 64;
constexpr double least_room = 0.01;  ///< height of rooms, as a share of the scene's longest side

struct Looker {
    const RayTree& tree;
    const std::vector<std::uint8_t>& two_sided;
    int up;
    double side;  ///< longest side of the scene

    /// A direction; azimuth 0 is the first of the other axes.
    Vec<3> direction(double azimuth, double elevation) const {
        const SinCos a = sincos_degrees(azimuth), e = sincos_degrees(elevation);
        Vec<3> d;
        d[up] = e.sin;
        d[(up + 1) % 3] = e.cos * a.cos;
        d[(up + 2) % 3] = e.cos * a.sin;
        return d;
    }
    bool is_two_sided(const RayTree::Hit& hit) const { return !two_sided.empty() && two_sided[hit.triangle]; }
    bool shows_front(const RayTree::Hit& hit) const { return hit.front || is_two_sided(hit); }
};

enum class Sky { counts, is_free };

/// How much the rays of a view show, in [0, 1]: the share that meets fronts (of all or of those that meet anything),
/// more for many triangles at many depths (powers of two of the distance), less for backs and for what is nearer than
/// `too_near`.
double score(const Looker& looker, std::vector<RayTree::Hit> hits, double too_near, Sky sky) {
    double fronts = 0, backs = 0, near = 0;
    std::vector<int> octaves;
    for (const RayTree::Hit& hit : hits) {
        if (!hit.any()) continue;
        near += hit.distance < too_near;
        if (!looker.shows_front(hit)) {
            ++backs;
            continue;
        }
        ++fronts;
        octaves.push_back(std::ilogb(hit.distance));
    }
    if (fronts == 0) return 0;
    std::sort(octaves.begin(), octaves.end());
    double depths = 0;
    for (std::size_t from = 0, to = 0; from < octaves.size(); from = to) {
        while (to < octaves.size() && octaves[to] == octaves[from]) ++to;
        depths += 20 * (to - from) >= octaves.size();
    }
    const double rays = sky == Sky::counts ? static_cast<double>(hits.size()) : fronts + backs;
    std::erase_if(hits, [](const RayTree::Hit& hit) { return !hit.any(); });
    std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
    const auto last =
        std::unique(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.triangle == b.triangle; });
    const double distinct = static_cast<double>(last - hits.begin()) / rays;
    return fronts / rays * (0.3 + 0.7 * distinct) * (0.4 + 0.15 * std::min(depths, 4.0)) *
           std::max(0.0, 1 - 5 * backs / rays) * std::max(0.0, 1 - 5 * near / rays);
}

struct Choice {
    double score = 0;
    ViewSpec<3> view{};
    void offer(double other, const ViewSpec<3>& other_view) {
        if (other > score) *this = {other, other_view};
    }
};

/// Looks along `ahead`, at the middle distance of what the rays meet.
ViewSpec<3> view_along(const Vec<3>& eye, const Vec<3>& ahead, const std::vector<RayTree::Hit>& hits,
                       double otherwise) {
    std::vector<double> distances;
    for (const RayTree::Hit& hit : hits)
        if (hit.any()) distances.push_back(hit.distance);
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    if (!distances.empty()) std::nth_element(distances.begin(), middle, distances.end());
    return {eye, eye + ahead * (distances.empty() ? otherwise : *middle), fov};
}

// ---------------------------------------------------------------------- inside

struct Floor {
    Vec<3> point;
    double gap;  ///< free height above; infinite under the sky
};

struct Ground {
    std::vector<Floor> floors;  ///< surfaces that face up
    double covered = 0;         ///< share of the footprint that has anything above it
    double roofed = 0;          ///< share of the footprint with a floor that something covers with room to stand
};

/// From a grid of vertical rays.
Ground find_ground(const Looker& looker, const Box<3>& box, const std::vector<Primitive<3>>& triangles) {
    Ground ground;
    Vec<3> down(0);
    down[looker.up] = -1;
    const int a = (looker.up + 1) % 3, b = (looker.up + 2) % 3;
    for (std::size_t i = 0; i < per_side; ++i)
        for (std::size_t j = 0; j < per_side; ++j) {
            // Off the middle of its square by a fixed amount that is no simple fraction: models are full of those.
            Vec<3> from = box.max;
            from[a] = box.min[a] + box.extent()[a] * (static_cast<double>(i) + 0.4571) / per_side;
            from[b] = box.min[b] + box.extent()[b] * (static_cast<double>(j) + 0.5379) / per_side;
            from[looker.up] += looker.side;
            double above = -std::numeric_limits<double>::infinity(), after = 0;
            bool roofed = false, in_solid = false;
            for (int layer = 0; layer < 24; ++layer) {
                const RayTree::Hit hit = looker.tree.cast(from, down, after);
                if (!hit.any()) break;
                ground.covered += layer == 0 ? 1.0 / (per_side * per_side) : 0;
                const Primitive<3>& t = triangles[hit.triangle];
                const Vec<3> normal = glm::cross(t[1] - t[0], t[2] - t[0]);
                const bool flat = std::abs(normal[looker.up]) > 0.9 * std::sqrt(glm::dot(normal, normal));
                if (flat && looker.shows_front(hit)) {
                    ground.floors.push_back({from + down * hit.distance, hit.distance - above});
                    roofed |= layer > 0 && !in_solid && hit.distance - above > least_room * looker.side;
                }
                above = hit.distance;
                in_solid = hit.front && !looker.is_two_sided(hit);
                after = hit.distance + 1e-5 * looker.side;
            }
            ground.roofed += roofed ? 1.0 / (per_side * per_side) : 0;
        }
    return ground;
}

/// Half the usual height of rooms, else a hundredth of the scene.
double eye_height(const std::vector<Floor>& floors, double side) {
    std::vector<double> gaps;
    for (const Floor& floor : floors)
        if (floor.gap > 0.004 * side && floor.gap < side) gaps.push_back(floor.gap);
    if (gaps.empty() || gaps.size() * 10 < floors.size()) return 0.01 * side;
    std::sort(gaps.begin(), gaps.end());
    return std::min(gaps[gaps.size() / 2] / 2, 0.1 * side);
}

void look_around(const Looker& looker, const Vec<3>& eye, double height, Choice& best) {
    std::array<std::vector<RayTree::Hit>, columns> hits;
    std::size_t below = 0, ground = 0;
    for (std::size_t c = 0; c < columns; ++c)
        for (const double elevation : elevations) {
            hits[c].push_back(
                looker.tree.cast(eye, looker.direction(360.0 * static_cast<double>(c) / columns, elevation)));
            below += elevation < 0;
            ground += elevation < 0 && hits[c].back().any();
        }
    if (ground * 5 < below * 4) return;  // on top of some object
    for (std::size_t first = 0; first < columns; ++first) {
        std::vector<RayTree::Hit> view;
        for (std::size_t k = 0; k < width; ++k) {
            const auto& column = hits[(first + k) % columns];
            view.insert(view.end(), column.begin(), column.end());
        }
        const double azimuth = 360.0 * static_cast<double>((first + width / 2) % columns) / columns;
        best.offer(score(looker, view, height, Sky::counts),
                   view_along(eye, looker.direction(azimuth, 0), view, looker.side));
    }
}

Choice best_inside(const Looker& looker, std::vector<Floor> found) {
    const double usual = eye_height(found, looker.side);
    std::erase_if(found, [&](const Floor& floor) { return floor.gap < usual; });
    Choice best;
    const std::size_t eyes = std::min(found.size(), most_eyes);
    for (std::size_t k = 0; k < eyes; ++k) {
        const Floor& floor = found[k * found.size() / eyes];
        const double height = std::min(usual, floor.gap / 2);
        Vec<3> eye = floor.point;
        eye[looker.up] += height;
        look_around(looker, eye, height, best);
    }
    return best;
}

// --------------------------------------------------------------------- outside

struct Frame {
    Vec<3> forward, right, top;
    double tangent;  ///< of half the height
};

/// That of make_view(), but any two directions across do.
Frame frame_of(const Looker& looker, const Vec<3>& ahead, double degrees) {
    const Vec<3> forward = ahead / std::sqrt(glm::dot(ahead, ahead));
    Vec<3> up(0);
    up[std::abs(forward[looker.up]) < 0.99 ? looker.up : (looker.up + 1) % 3] = 1;
    const Vec<3> across = glm::cross(forward, up), right = across / std::sqrt(glm::dot(across, across));
    const SinCos half = sincos_degrees(std::min(degrees, 170.0) / 2);
    return {forward, right, glm::cross(right, forward), half.sin / half.cos};
}

constexpr double aspect = 4.0 / 3;  // of the usual picture

/// How far from its centre a box is seen whole, with a rim of a twentieth.
double whole_from(const Frame& frame, const Box<3>& box) {
    const Vec<3> extent = box.extent();
    double distance = 0.6 * std::sqrt(glm::dot(extent, extent));  // not on a corner
    for (int corner = 0; corner < 8; ++corner) {
        Vec<3> d;
        for (int i = 0; i < 3; ++i) d[i] = (corner >> i & 1 ? 0.5 : -0.5) * extent[i];
        const double tall = std::abs(glm::dot(d, frame.top)), wide = std::abs(glm::dot(d, frame.right)) / aspect;
        distance = std::max(distance, 1.05 * std::max(tall, wide) / frame.tangent - glm::dot(d, frame.forward));
    }
    return distance;
}

std::vector<RayTree::Hit> hits_of(const Looker& looker, const ViewSpec<3>& view) {
    const auto [forward, right, top, tangent] = frame_of(looker, view.look_at - view.eye, view.fov);
    std::vector<RayTree::Hit> hits;
    for (int row = -4; row <= 4; ++row)
        for (int column = -6; column <= 6; ++column) {
            const Vec<3> ray = forward + (column / 6.5 * aspect * tangent) * right + (row / 4.5 * tangent) * top;
            hits.push_back(looker.tree.cast(view.eye, ray / std::sqrt(glm::dot(ray, ray))));
        }
    return hits;
}

struct Outside {
    Choice best;
    std::size_t fronts = 0, backs = 0;  ///< of all hits, whatever is two-sided
    /// It turns its fronts to all sides, from below too.
    bool is_solid() const { return backs * 100 <= fronts; }
};

Outside best_outside(const Looker& looker, const Box<3>& box) {
    Outside outside;
    for (const double elevation : {20.0, 40.0, -20.0, 89.0, -89.0})
        for (int k = 0; k < 8; ++k) {
            const Vec<3> away = looker.direction(45.0 * k + 30, elevation);
            const double distance = whole_from(frame_of(looker, -away, fov), box);
            const ViewSpec<3> view{box.centre() + away * distance, box.centre(), fov};
            const std::vector<RayTree::Hit> hits = hits_of(looker, view);
            for (const RayTree::Hit& hit : hits)
                if (hit.any()) ++(hit.front ? outside.fronts : outside.backs);
            // From above objects look best; from below and straight down is for what shows nothing else.
            const double worth = elevation == 20 ? 1 : elevation == 40 ? 0.9 : 0.5;
            outside.best.offer(worth * score(looker, hits, 0, Sky::is_free), view);
        }
    return outside;
}

/// Face to face with the largest triangle.
ViewSpec<3> before_largest(const std::vector<Primitive<3>>& triangles) {
    Vec<3> normal(0), centre(0);
    double most = -1, size = 0;
    for (const Primitive<3>& t : triangles) {
        const Vec<3> n = glm::cross(t[1] - t[0], t[2] - t[0]);
        const double area = std::sqrt(glm::dot(n, n));
        if (!(area > most)) continue;
        most = area;
        normal = n;
        centre = (t[0] + t[1] + t[2]) / 3.0;
        Box<3> box;
        for (const Vec<3>& v : t) box.add(v);
        size = box.longest_side();
    }
    return {centre + normal * (size / most), centre, fov};
}

}  // namespace

ViewSpec<3> default_view(const std::vector<Primitive<3>>& triangles, int up_axis,
                         const std::vector<std::uint8_t>& two_sided, const std::optional<ViewSpec<3>>& camera) {
    if (triangles.empty()) return camera.value_or(ViewSpec<3>{Vec<3>(0), Vec<3>(1, 0, 0), fov});
    const RayTree tree(triangles);
    const Box<3> box = bounds<3>(triangles);
    const Looker looker{tree, two_sided, up_axis, box.longest_side()};
    if (camera) {
        const std::vector<RayTree::Hit> hits = hits_of(looker, *camera);
        if (score(looker, hits, 0, Sky::is_free) > 0) {
            ViewSpec<3> view = view_along(camera->eye, camera->look_at - camera->eye, hits, 1);
            view.fov = camera->fov;
            return view;
        }
    }
    const Ground ground = find_ground(looker, box, triangles);
    const Outside all_sides = best_outside(looker, box);
    const Choice& outside = all_sides.best;
    // A solid may fill its footprint, but nobody stands in it: where it has floors, these are under the sky.
    const bool is_open = ground.covered < 0.9 || (all_sides.is_solid() && ground.roofed < 0.3);
    const bool is_object = is_open && outside.score > 0.2;
    const Choice inside = is_object ? Choice{} : best_inside(looker, ground.floors);
    if (inside.score > 0 && inside.score >= outside.score / 2) return inside.view;
    if (outside.score > 0) return outside.view;
    return before_largest(triangles);
}

}  // namespace sightline
