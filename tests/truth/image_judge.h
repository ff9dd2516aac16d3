// How near to undecided a pixel of an id image is, by brute force in double precision.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "core/scene/view.h"
#include "core/truth/id_image.h"

namespace sightline::test {

/// Image coordinates are pixels from the top left corner. The view's corners must be a parallelogram.
class ImageJudge {
public:
    ImageJudge(const Scene<3>& scene, const View<3>& view, const ImageSize& size)
        : scene_(scene), view_(view), size_(size) {
        // Columns: what one pixel to the right, one pixel down and the left top corner are from the eye.
        const auto& c = view.corners;
        const Vec<3> right = (c[2] - c[3]) / static_cast<double>(size.width),
                     down = (c[0] - c[3]) / static_cast<double>(size.height), corner = c[3] - view.eye;
        const double volume = glm::dot(right, glm::cross(down, corner));
        rows_ = {glm::cross(down, corner) / volume, glm::cross(corner, right) / volume,
                 glm::cross(right, down) / volume};
    }

    /// One over the distance (1 on the plane of the corners) at which the plane of the triangle is met there.
    double nearness(std::uint32_t id, double x, double y) const {
        const auto [p, q, r] = seen(id);
        const Vec<3> normal = glm::cross(q - p, r - p);
        return glm::dot(normal, Vec<3>(x, y, 1)) / glm::dot(normal, p);
    }
    /// How much that changes over one pixel at most.
    double slope(std::uint32_t id) const {
        const double here = nearness(id, 0, 0);
        return std::hypot(nearness(id, 1, 0) - here, nearness(id, 0, 1) - here);
    }
    /// The largest nearness of the triangle in the image and half of its size around it.
    double largest_nearness(std::uint32_t id) const {
        double in_triangle = 0, in_image = 0;
        for (const Vec<3>& p : seen(id)) in_triangle = std::max(in_triangle, p.z > 0 ? 1 / p.z : 1e300);
        for (int i = 0; i < 4; ++i)
            in_image = std::max(in_image,
                                nearness(id, size_.width * (i & 1 ? 1.5 : -0.5), size_.height * (i & 2 ? 1.5 : -0.5)));
        return std::min(in_triangle, in_image);
    }
    /// Whether the triangle turns a seen side to the eye and lies in front of it at that point.
    bool covers(std::uint32_t id, double x, double y) const {
        const auto [p, q, r] = seen(id);
        const Vec<3> ray(x, y, 1);
        const double pq = glm::dot(glm::cross(p, q), ray), qr = glm::dot(glm::cross(q, r), ray),
                     rp = glm::dot(glm::cross(r, p), ray);
        const bool both = !scene_.two_sided.empty() && scene_.two_sided[id];
        const auto& [a, b, c] = scene_.primitives[id];
        if (!both && glm::dot(glm::cross(b - a, c - a), view_.eye - a) <= 0) return false;
        const bool inside = (pq >= 0 && qr >= 0 && rp >= 0) || (pq <= 0 && qr <= 0 && rp <= 0);
        return inside && nearness(id, x, y) > 0;
    }
    /// The triangles on the ray through the pixel's centre, nearest first; of equal depth by id.
    std::vector<std::uint32_t> along(int column, int row) const {
        std::vector<std::pair<double, std::uint32_t>> hits;
        for (std::uint32_t id = 0; id < scene_.primitives.size(); ++id)
            if (covers(id, column + 0.5, row + 0.5)) hits.emplace_back(-nearness(id, column + 0.5, row + 0.5), id);
        std::sort(hits.begin(), hits.end());
        std::vector<std::uint32_t> ids;
        for (const auto& hit : hits) ids.push_back(hit.second);
        return ids;
    }
    /// Pixels from the point to the nearest edge of the triangle, as far as it lies in front of the eye.
    double edge_distance(std::uint32_t id, double x, double y) const {
        const auto corners = seen(id);
        double nearest = 1e300;
        for (std::size_t i = 0; i < 3; ++i) {
            Vec<3> a = corners[i], b = corners[(i + 1) % 3];
            if (a.z <= 0 && b.z <= 0) continue;
            const double least = 1e-9 * std::max(a.z, b.z);
            if (a.z < least) a = b + (a - b) * ((b.z - least) / (b.z - a.z));
            if (b.z < least) b = a + (b - a) * ((a.z - least) / (a.z - b.z));
            const Vec<2> from(a.x / a.z - x, a.y / a.z - y), along = Vec<2>(b.x / b.z - x, b.y / b.z - y) - from;
            const double length2 = glm::dot(along, along);
            const double t = length2 > 0 ? std::clamp(-glm::dot(from, along) / length2, 0.0, 1.0) : 0;
            nearest = std::min(nearest, glm::length(from + along * t));
        }
        return nearest;
    }
    /// Whether the depths of two triangles there are too close to tell: equal within a 128th of a pixel, or by floats
    /// that carry the largest nearness of each.
    bool same_depth(std::uint32_t a, std::uint32_t b, double x, double y) const {
        const double floats = 0x1p-22 * (largest_nearness(a) + largest_nearness(b));
        return std::abs(nearness(a, x, y) - nearness(b, x, y)) <= (slope(a) + slope(b)) / 128 + floats;
    }
    /// Whether two answers for a pixel may both be right: one of the triangles has an edge within a 128th of a pixel of
    /// its centre, or both are there at the same depth.
    bool undecided(std::uint32_t a, std::uint32_t b, int column, int row) const {
        const double x = column + 0.5, y = row + 0.5;
        for (const std::uint32_t id : {a, b})
            if (id != none && edge_distance(id, x, y) <= 1.0 / 128) return true;
        if (a == none || b == none) return false;
        return covers(a, x, y) && covers(b, x, y) && same_depth(a, b, x, y);
    }

private:
    /// The corners as (x w, y w, w).
    std::array<Vec<3>, 3> seen(std::uint32_t id) const {
        std::array<Vec<3>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec<3> q = scene_.primitives[id][i] - view_.eye;
            corners[i] = {glm::dot(rows_[0], q), glm::dot(rows_[1], q), glm::dot(rows_[2], q)};
        }
        return corners;
    }

    const Scene<3>& scene_;
    View<3> view_;
    ImageSize size_;
    std::array<Vec<3>, 3> rows_;
};

}  // namespace sightline::test
