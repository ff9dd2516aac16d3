// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/scene/clean.h"

namespace sightline {

namespace {

constexpr int cells_along = 32;

/// Which cells of a grid the segments cross; coordinates are in cells, from the grid's corner.
struct Grid {
    int columns, rows;
    std::vector<char> crossed;

    static int clamp(double value, int count) {
        return value > 0 ? std::min(static_cast<int>(std::min(value, 1e6)), count - 1) : 0;
    }
    /// Row by row: the part of the segment inside a row covers a run of columns.
    void add(Vec<2> a, Vec<2> b) {
        if (a.y > b.y) std::swap(a, b);
        const int last = clamp(b.y, rows);
        for (int row = clamp(a.y, rows); row <= last; ++row) {
            const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
            double from = a.y < row ? a.x + slope * (row - a.y) : a.x;
            double to = b.y > row + 1 ? a.x + slope * (row + 1 - a.y) : b.x;
            if (from > to) std::swap(from, to);
            for (int column = clamp(from, columns); column <= clamp(to, columns); ++column)
                crossed[static_cast<std::size_t>(row * columns + column)] = 1;
        }
    }
    /// Squared distance to the nearest crossed cell or to outside the grid, in cells.
    int clearance(int column, int row) const {
        const int rim = std::min({column + 1, row + 1, columns - column, rows - row});
        int best = rim * rim;
        for (int y = std::max(0, row - rim); y <= std::min(rows - 1, row + rim); ++y)
            for (int x = std::max(0, column - rim); x <= std::min(columns - 1, column + rim); ++x)
                if (crossed[static_cast<std::size_t>(y * columns + x)])
                    best = std::min(best, (x - column) * (x - column) + (y - row) * (y - row));
        return best;
    }
};

Vec<2> midpoint(const Primitive<2>& s) { return s[0] * 0.5 + s[1] * 0.5; }

double squared_length_between(const Vec<2>& a, const Vec<2>& b) { return glm::dot(b - a, b - a); }

}  // namespace

ViewSpec<2> default_view(const std::vector<Primitive<2>>& segments) {
    if (segments.empty()) return {{0, 0}, {1, 0}, 90};
    const Box<2> box = bounds<2>(segments);
    const double side = box.longest_side();
    const Vec<2> centre = box.centre();

    // Distances in units of the side: their squares neither overflow nor vanish.
    Vec<2> look_at = midpoint(segments[0]);
    double nearest = squared_length_between(look_at / side, centre / side);
    for (const Primitive<2>& s : segments) {
        const double distance = squared_length_between(midpoint(s) / side, centre / side);
        if (distance < nearest) {
            nearest = distance;
            look_at = midpoint(s);
        }
    }

    const double cell = side / cells_along;
    const Vec<2> corner = box.min - Vec<2>(cell);
    const auto count = [&](double extent) { return static_cast<int>(std::ceil(extent / cell)) + 2; };
    Grid grid{count(box.extent().x), count(box.extent().y), {}};
    grid.crossed.assign(static_cast<std::size_t>(grid.columns * grid.rows), 0);
    for (const Primitive<2>& s : segments) grid.add((s[0] - corner) / cell, (s[1] - corner) / cell);

    Vec<2> eye(centre.x, box.min.y - side / 2);
    int best_clearance = 0;
    double best_distance = 0;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const int clearance = grid.clearance(column, row);
            const Vec<2> middle = corner + cell * Vec<2>(column + 0.5, row + 0.5);
            const double distance = squared_length_between(middle / cell, centre / cell);
            if (clearance == 0 || clearance < best_clearance) continue;
            if (clearance == best_clearance && distance >= best_distance) continue;
            best_clearance = clearance;
            best_distance = distance;
            eye = middle;
        }
    // A scene that is tiny for its place may round the eye onto a segment.
    if (std::abs(eye.x - look_at.x) < cell / 4 && std::abs(eye.y - look_at.y) < cell / 4) {
        eye = look_at;
        eye.y -= std::max(side, std::abs(eye.y) / 1024);
    }
    return {eye, look_at, 90};
}

}  // namespace sightline
