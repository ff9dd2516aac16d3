// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/outline.h"

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace sightline {

namespace {

/// Where the segment enters and leaves the rectangle, as parameters in [0, 1].
std::optional<std::pair<double, double>> clip_segment(const Vec<2>& a, const Vec<2>& b, const Rect& r) {
    double enter = 0, leave = 1;
    const Vec<2> low(r.x, r.y), high(r.right(), r.bottom());
    for (int axis = 0; axis < 2; ++axis) {
        const double d = b[axis] - a[axis];
        if (d == 0) {
            if (a[axis] < low[axis] || a[axis] > high[axis]) return std::nullopt;
            continue;
        }
        const double at_low = (low[axis] - a[axis]) / d, at_high = (high[axis] - a[axis]) / d;
        enter = std::max(enter, std::min(at_low, at_high));
        leave = std::min(leave, std::max(at_low, at_high));
    }
    if (enter > leave) return std::nullopt;
    return std::pair(enter, leave);
}

/// Crossings of a polygon with the lines dot(p, across) = k * pitch, turned into the stretches inside.
struct Crossing {
    double line;   ///< k
    double along;  ///< position on the line
    int winding;
    bool operator<(const Crossing& o) const {
        return std::tie(line, along, winding) < std::tie(o.line, o.along, o.winding);
    }
};

template <typename Emit>
void scan(std::span<const Vec<2>> polygon, const Vec<2>& along, double pitch, Emit emit) {
    const Vec<2> across(-along.y, along.x);
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<2>& p = polygon[i];
        const Vec<2>& q = polygon[(i + 1) % polygon.size()];
        const double up = glm::dot(p, across) / pitch, uq = glm::dot(q, across) / pitch;
        if (up == uq) continue;
        // Half open, so that a vertex on a line is counted once.
        for (double k = std::ceil(std::min(up, uq)); k < std::max(up, uq); ++k) {
            const double t = (k - up) / (uq - up);
            crossings.push_back({k, glm::dot(p + (q - p) * t, along), up < uq ? 1 : -1});
        }
    }
    std::sort(crossings.begin(), crossings.end());
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].winding;
        if (crossings[i].line != crossings[i + 1].line)
            winding = 0;
        else if (winding != 0 && crossings[i].along < crossings[i + 1].along)
            emit(crossings[i].line, crossings[i].along, crossings[i + 1].along);
    }
}

void add_lines(std::span<const Vec<2>> polygon, const Vec<2>& along, double pitch, Path& out) {
    const Vec<2> across(-along.y, along.x);
    scan(polygon, along, pitch, [&](double k, double from, double to) {
        const Vec<2> base = across * (k * pitch);
        out.add({base + along * from, base + along * to});
    });
}

void add_dots(std::span<const Vec<2>> polygon, double pitch, Path& out) {
    const double rows = pitch * 0.5 * std::sqrt(3.0);
    scan(polygon, {1, 0}, rows, [&](double k, double from, double to) {
        const double shift = std::fmod(std::abs(k), 2) == 1 ? 0.5 : 0;
        for (double i = std::ceil(from / pitch - shift); (i + shift) * pitch <= to; ++i) {
            const Vec<2> at((i + shift) * pitch, k * rows);
            out.add({at, at});
        }
    });
}

}  // namespace

std::vector<Vec<2>> clip_polygon(std::span<const Vec<2>> polygon, const Rect& rect) {
    std::vector<Vec<2>> in(polygon.begin(), polygon.end()), out;
    const auto cut = [&](int axis, double limit, double sign) {
        out.clear();
        for (std::size_t i = 0; i < in.size(); ++i) {
            const Vec<2>& p = in[i];
            const Vec<2>& q = in[(i + 1) % in.size()];
            const double dp = (p[axis] - limit) * sign, dq = (q[axis] - limit) * sign;
            if (dp >= 0) out.push_back(p);
            if ((dp < 0) != (dq < 0)) {
                Vec<2> at = p + (q - p) * (dp / (dp - dq));
                at[axis] = limit;
                out.push_back(at);
            }
        }
        std::swap(in, out);
    };
    cut(0, rect.x, 1);
    cut(0, rect.right(), -1);
    cut(1, rect.y, 1);
    cut(1, rect.bottom(), -1);
    return in;
}

Path clip_polyline(std::span<const Vec<2>> line, const Rect& rect) {
    Path path;
    bool open = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto part = clip_segment(line[i], line[i + 1], rect);
        if (!part) {
            if (std::exchange(open, false)) path.end_run();
            continue;
        }
        const Vec<2> d = line[i + 1] - line[i];
        if (!open) path.points.push_back(part->first > 0 ? line[i] + d * part->first : line[i]);
        path.points.push_back(part->second < 1 ? line[i] + d * part->second : line[i + 1]);
        open = part->second >= 1;
        if (!open) path.end_run();
    }
    if (open) path.end_run();
    return path;
}

double clipped_length(const Vec<2>& a, const Vec<2>& b, const Rect& rect) {
    const auto part = clip_segment(a, b, rect);
    return part ? (part->second - part->first) * glm::length(b - a) : 0;
}

Path hatch_lines(std::span<const Vec<2>> polygon, Hatch hatch, double pitch) {
    Path path;
    const double half = std::sqrt(0.5);
    if (hatch == Hatch::diagonal || hatch == Hatch::cross) add_lines(polygon, {half, -half}, pitch, path);
    if (hatch == Hatch::back_diagonal || hatch == Hatch::cross) add_lines(polygon, {half, half}, pitch, path);
    if (hatch == Hatch::horizontal) add_lines(polygon, {1, 0}, pitch, path);
    if (hatch == Hatch::dots) add_dots(polygon, pitch, path);
    return path;
}

}  // namespace sightline
