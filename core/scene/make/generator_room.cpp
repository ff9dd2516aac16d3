// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/scene/make/building.h"
#include "core/scene/make/furniture.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/route.h"

namespace sightline::generate {

namespace {

/// A bent board: a sheet of `thick` metres over points (x, y, z)(u, v) with u and v from 0 to 1; closed.
template <typename Surface>
void board(Model& m, const Surface& surface, int columns, int rows, const Vec<3>& thick) {
    const auto at = [&](int i, int j) {
        return surface(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
    };
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            const Vec<3> a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            m.polygon({a, b, c, d});
            m.polygon({a - thick, d - thick, c - thick, b - thick});
            if (j == 0) m.polygon({b, a, a - thick, b - thick});
            if (i + 1 == columns) m.polygon({c, b, b - thick, c - thick});
            if (j + 1 == rows) m.polygon({d, c, c - thick, d - thick});
            if (i == 0) m.polygon({a, d, d - thick, a - thick});
        }
}

/// A chair of tubes and bent boards, looking toward +y, 0.5 x 0.5; `detail` from 1 on.
void tube_chair(Model& m, int detail) {
    const int corners = 4 + detail, pieces = 1 + detail;
    for (const double x : {-0.2, 0.2}) {
        m.rod({x, 0.2, 0}, {x, 0.18, 0.43}, 0.012, corners);
        m.rod({x, -0.24, 0}, {x, -0.2, 0.85}, 0.012, corners);
    }
    board(m,
          [](double u, double v) {
              const double side = 2 * u - 1;
              return Vec<3>(0.22 * side, -0.18 + 0.4 * v, 0.45 + 0.02 * side * side - 0.03 * v * v);
          },
          pieces, pieces, {0, 0, 0.015});
    board(m,
          [](double u, double v) {
              const double side = 2 * u - 1;
              return Vec<3>(-0.22 * side, -0.18 + 0.04 * side * side - 0.03 * v, 0.6 + 0.28 * v);
          },
          pieces, pieces, {0, 0.015, 0});
    // A board to write on, on the right.
    m.rod({0.23, 0.1, 0.4}, {0.25, 0.14, 0.66}, 0.012, corners);
    m.box({0.08, 0.05, 0.66}, {0.32, 0.32, 0.68});
}

std::size_t chair_triangles(int detail) {
    Model model;
    tube_chair(model, detail);
    return model.triangles.size();
}

constexpr double spacing = 0.72, row_spacing = 1.05, aisle = 1.3, first_row = 1.9;

struct Hall {
    std::size_t chairs;
    int half_row, rows;
    double width() const { return 2 * (half_row * spacing + aisle / 2 + 1.2); }
    double depth() const { return first_row + rows * row_spacing + 3.6; }
};
constexpr double hall_height = 3.6;

Hall hall_for(std::size_t chairs) {
    Hall hall{chairs, 3, 0};
    while (hall.half_row * hall.half_row * 3 < static_cast<int>(chairs)) ++hall.half_row;
    hall.rows = static_cast<int>((chairs + 2 * static_cast<std::size_t>(hall.half_row) - 1) /
                                 (2 * static_cast<std::size_t>(hall.half_row)));
    return hall;
}

/// Walls, floor and ceiling of 20 cm, lamps, and what stands in front.
void walls(Model& m, const Hall& hall) {
    const double x = hall.width() / 2, y = hall.depth(), t = 0.2;
    m.box({-x - t, -t, -t}, {x + t, y + t, 0});
    m.box({-x - t, -t, hall_height}, {x + t, y + t, hall_height + t});
    const std::array<Vec<3>, 4> corners = {{{-x, -t, 0}, {x + t, 0, 0}, {x, y + t, 0}, {-x - t, y, 0}}};
    for (std::size_t side = 0; side < 4; ++side) {
        const double length = side % 2 == 0 ? 2 * x : y;
        const Inside place(m, corners[side], 90.0 * static_cast<double>(side));
        wall_panel(m, {-t, length + t, 0, hall_height, t, t, 0}, {});
    }
    for (int i = 0; i < 3; ++i)  // lamps
        for (const double side : {-0.5, 0.5}) {
            const double yy = y * (i + 0.5) / 3;
            m.box({side * x - 0.6, yy - 0.15, hall_height - 0.12}, {side * x + 0.6, yy + 0.15, hall_height - 0.04});
            for (const double end : {-0.5, 0.5})
                m.rod({side * x + end, yy, hall_height - 0.04}, {side * x + end, yy, hall_height}, 0.01, 4);
        }
    m.box({-1.8, y - 0.08, 0.9}, {1.8, y - 0.02, 2.2});              // blackboard
    m.box({-1.8, y - 0.16, 0.86}, {1.8, y - 0.08, 0.9});             // its shelf
    m.box({0.9 * x - 1, y - 0.06, 0.02}, {0.9 * x, y - 0.01, 2.1});  // door
    {
        const Inside place(m, {-1.4, y - 1.6, 0});
        table(m, 1.6, 0.8);
    }
    m.box({0.6, y - 1.9, 0}, {1.2, y - 1.5, 1.1});  // lectern
}

}  // namespace

Generated room(std::uint64_t seed, std::size_t triangles) {
    Random random(seed);
    Model model;
    // More chairs first; beyond a thousand they get finer instead.
    int detail = 1;
    while (triangles > 1000 * chair_triangles(detail)) ++detail;
    const std::size_t each = chair_triangles(detail);
    Model empty;
    walls(empty, hall_for(1));
    const Hall hall = hall_for((triangles - empty.triangles.size() + each / 2) / each);
    model.triangles.reserve(empty.triangles.size() + hall.chairs * each);
    walls(model, hall);
    for (std::size_t k = 0; k < hall.chairs; ++k) {
        const int in_row = static_cast<int>(k) % (2 * hall.half_row), row = static_cast<int>(k) / (2 * hall.half_row);
        const int place = in_row / 2;
        const double side = in_row % 2 == 0 ? -1 : 1;
        const double x = side * (aisle / 2 + (place + 0.5) * spacing) + random.uniform(-0.05, 0.05);
        const double y = first_row + (row + 0.5) * row_spacing + random.uniform(-0.08, 0.08);
        const Inside frame(model, {x, y, 0}, random.uniform(-12, 12));
        tube_chair(model, detail);
    }

    Generated made;
    made.triangles = std::move(model.triangles);
    const Vec<3> corner(float_value(hall.width() / 2), float_value(hall.depth()), float_value(hall_height));
    made.rooms.all.push_back({"hall", {{-corner.x, 0, 0}, corner}});
    made.rooms.closed_from = 0.25;  // walls, floor and ceiling are solids of 0.2
    // Round the rows, looking half ahead and half at their middle.
    const double x = hall.width() / 2 - 0.6, front = hall.depth() - 2.6, back = 0.9, eye = 1.6;
    const std::vector<Vec<3>> walk = {{0, back, eye},   {x, back, 1.4},  {x, 0.5 * front, 1.3}, {x, front, 1.7},
                                      {-x, front, eye}, {-x, back, 1.2}, {0, back, eye}};
    made.paths.push_back(along("walk", walk, 235, 3, 65));
    const Vec<3> middle(0, hall.depth() / 2, 0.4);
    for (ViewSpec<3>& frame : made.paths.back().frames) frame.look_at = (frame.look_at + middle) * 0.5;
    // Round the closed hall outside.
    const double w = hall.width() / 2 + 4, d = hall.depth() + 4, high = 2.2;
    const std::vector<Vec<3>> round = {{0, -4, high}, {w, -4, high},  {w, d, high},
                                       {-w, d, high}, {-w, -4, high}, {0, -4, high}};
    made.paths.push_back(along("outside", round, 235, 3, 65));
    for (ViewSpec<3>& frame : made.paths.back().frames) frame.look_at = middle;
    made.paths.push_back(test_path(made.paths.front()));
    return made;
}

}  // namespace sightline::generate
