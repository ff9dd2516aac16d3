// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/route.h"

#include <cmath>

namespace sightline {

namespace {

double distance(const Vec<3>& a, const Vec<3>& b) { return std::sqrt(glm::dot(b - a, b - a)); }

Vec<3> point_at(std::span<const Vec<3>> points, double walked) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double piece = distance(points[i - 1], points[i]);
        if (walked <= piece || i + 1 == points.size())
            return points[i - 1] + (points[i] - points[i - 1]) * (walked / piece);
        walked -= piece;
    }
    return points.front();
}

}  // namespace

FlightPath<3> along(std::string id, std::span<const Vec<3>> points, std::size_t frames, double ahead, double fov) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
    FlightPath<3> path{std::move(id), {}};
    for (std::size_t i = 0; i < frames; ++i) {
        const double walked = length * static_cast<double>(i) / static_cast<double>(frames - 1);
        path.frames.push_back({point_at(points, walked), point_at(points, walked + ahead), fov});
    }
    return path;
}

FlightPath<3> test_path(const FlightPath<3>& path) {
    FlightPath<3> test{"test", {}};
    for (const std::size_t i : spread_frames(path.frames.size(), 8)) test.frames.push_back(path.frames[i]);
    return test;
}

}  // namespace sightline
