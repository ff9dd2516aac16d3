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

void stroll(std::vector<Vec<2>>& way, const Vec<2>& to, Random& random, double sway) {
    const Vec<2> from = way.back(), whole = to - from;
    const double length = std::sqrt(glm::dot(whole, whole));
    const Vec<2> aside = Vec<2>(-whole.y, whole.x) / length;
    const int pieces = static_cast<int>(length / 3) + 1;
    for (int i = 1; i < pieces; ++i)
        way.push_back(from + whole * (static_cast<double>(i) / pieces) + aside * random.uniform(-sway, sway));
    way.push_back(to);
}

FlightPath<3> on_foot(std::string id, std::span<const Vec<2>> way, std::size_t frames) {
    constexpr double eye_height = 1.7, step = 0.05, ahead = 2, fov = 60;
    constexpr int pieces = 8;  // of a curve, each well below a step or two
    const auto raised = [](const Vec<2>& p) { return Vec<3>(p.x, p.y, eye_height); };
    // A quadratic B-spline: from middle to middle, each point between drawing the curve to itself.
    std::vector<Vec<3>> smooth{raised(way.front())};
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
        const Vec<2> a = i == 1 ? way[0] : (way[i - 1] + way[i]) * 0.5, c = (way[i] + way[i + 1]) * 0.5;
        for (int k = 1; k <= pieces; ++k) {
            const double t = static_cast<double>(k) / pieces;
            smooth.push_back(raised((1 - t) * (1 - t) * a + 2 * t * (1 - t) * way[i] + t * t * c));
        }
    }
    smooth.push_back(raised(way.back()));
    FlightPath<3> path{std::move(id), {}};
    for (std::size_t i = 0; i < frames; ++i) {
        const double walked = step * static_cast<double>(i);
        path.frames.push_back({point_at(smooth, walked), point_at(smooth, walked + ahead), fov});
    }
    return path;
}

FlightPath<3> test_path(const FlightPath<3>& path) {
    FlightPath<3> test{"test", {}};
    for (const std::size_t i : spread_frames(path.frames.size(), 8)) test.frames.push_back(path.frames[i]);
    return test;
}

}  // namespace sightline
