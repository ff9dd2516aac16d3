// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "core/scene/make/building.h"
#include "core/scene/make/furniture.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/route.h"

namespace sightline::generate {

namespace {

// A block is two rows of four lots, back to back, in the middle of its share of the grid; the rest is half a street.
constexpr double lot_width = 12, lot_depth = 15, pavement = 2, road = 3;  // the road up to its middle line
constexpr int lots_in_row = 4;
constexpr double pitch_x = lots_in_row * lot_width + 2 * (pavement + road);
constexpr double pitch_y = 2 * (lot_depth + pavement + road);
constexpr double kerb = 0.14;

struct Lot {
    int block_x, block_y, row, place;

    /// The corner at the street on the left, seen from the street.
    Vec<2> corner() const {
        const double side = row == 0 ? -1 : 1;
        return {pitch_x * block_x + side * lot_width * (lots_in_row / 2.0 - place),
                pitch_y * (block_y + row) - side * (pavement + road)};
    }
    double degrees() const { return row == 0 ? 0 : 180; }
    /// Squared, from the origin to the lot's middle.
    double distance() const {
        const double side = row == 0 ? 1 : -1;
        const Vec<2> middle = corner() + side * Vec<2>(lot_width / 2, lot_depth / 2);
        return glm::dot(middle, middle);
    }
};

/// At least `count` lots, those nearest the origin first: a larger city begins with all of a smaller one.
std::vector<Lot> lots_by_distance(std::size_t count) {
    const double radius =
        std::sqrt(static_cast<double>(count) * pitch_x * pitch_y / (2 * lots_in_row) / pi) + pitch_x + pitch_y;
    const int blocks_x = static_cast<int>(radius / pitch_x) + 1, blocks_y = static_cast<int>(radius / pitch_y) + 1;
    std::vector<Lot> lots;
    for (int y = -blocks_y; y <= blocks_y; ++y)
        for (int x = -blocks_x; x <= blocks_x; ++x)
            for (int row = 0; row < 2; ++row)
                for (int place = 0; place < lots_in_row; ++place) {
                    const Lot lot{x, y, row, place};
                    if (lot.distance() < radius * radius) lots.push_back(lot);
                }
    std::sort(lots.begin(), lots.end(), [](const Lot& a, const Lot& b) {
        return std::tuple(a.distance(), a.block_y, a.block_x, a.row, a.place) <
               std::tuple(b.distance(), b.block_y, b.block_x, b.row, b.place);
    });
    return lots;
}

/// The lot's share of ground, in its frame.
void ground(Model& m, const Lot& lot) {
    const double left = lot.place == 0 ? pavement : 0, right = lot.place == lots_in_row - 1 ? pavement : 0;
    const double x0 = -left, x1 = lot_width + right;
    m.box({x0, -pavement, 0}, {x1, lot_depth, kerb},
          top_side | front_side | (left > 0 ? unsigned{left_side} : 0u) | (right > 0 ? unsigned{right_side} : 0u));
    const double street0 = left > 0 ? x0 - road : x0, street1 = right > 0 ? x1 + road : x1;
    m.box({street0, -pavement - road, -0.1}, {street1, -pavement, 0}, top_side);
    if (left > 0) m.box({street0, -pavement, -0.1}, {x0, lot_depth, 0}, top_side);
    if (right > 0) m.box({x1, -pavement, -0.1}, {street1, lot_depth, 0}, top_side);
}

void add_lot(Model& m, std::uint64_t seed, const Lot& lot) {
    Hash hash;
    for (const int part : {lot.block_x, lot.block_y, lot.row, lot.place}) hash.add(part);
    Random random(seed + hash.value());

    const Vec<2> corner = lot.corner();
    const Inside frame(m, {corner.x, corner.y, 0}, lot.degrees());
    ground(m, lot);
    const Inside on_kerb(m, {0, 0, kerb});
    House house{};
    house.width = random.uniform(8, 10);
    house.depth = random.uniform(8, 9.5);
    static constexpr int storeys[] = {2, 2, 2, 3, 3, 4};
    house.storeys = storeys[random.below(6)];
    const double x = (lot_width - house.width) / 2 + random.uniform(-0.7, 0.7), y = random.uniform(1.5, 3);
    {
        const Inside place(m, {x, y, 0});
        house_shell(m, random, house);
        if (m.full()) return;
        house_rooms(m, random, house);
    }
    if (lot.place % 2 == 0 && !m.full()) {
        const Inside place(m, {0.4, -pavement + 0.35, 0});
        street_lamp(m);
    }
    const double trees[][2] = {{lot_width / 2, -pavement + 0.5}, {3, lot_depth - 2}, {9, lot_depth - 1.6}};
    for (const auto& tree : trees) {
        const double shift = random.uniform(-1.2, 1.2);
        if (random.below(4) == 0 || m.full()) continue;
        const Inside place(m, {tree[0] + shift, tree[1], 0});
        garden_tree(m, random);
    }
}

constexpr double eye_height = 1.7;

}  // namespace

Generated city(std::uint64_t seed, std::size_t triangles) {
    Model model;
    model.wanted = triangles;
    model.triangles.reserve(triangles + 500);
    std::size_t lots = 0;
    double radius = 0;
    for (const Lot& lot : lots_by_distance(triangles / 600 + 8)) {
        if (model.full()) break;
        add_lot(model, seed, lot);
        radius = std::sqrt(lot.distance());
        ++lots;
    }

    Generated made;
    made.triangles = std::move(model.triangles);
    // Round a block when there is one, else along the street.
    const double x = pitch_x / 2, y = pitch_y, z = eye_height;
    const std::vector<Vec<3>> round = {{-8, 0, z}, {x, 0, z}, {x, y, z}, {-x, y, z}, {-x, 0, z}, {-8, 0, z}};
    const std::vector<Vec<3>> there = {{-8, 0, z}, {8, 0, z}};
    made.paths.push_back(along("street", lots >= 40 ? round : there, 160, 7, 60));
    // Over the roofs toward the middle, from no farther than a few blocks.
    const double reach = std::min(radius, 150.0);
    const std::vector<Vec<3>> over = {
        {-reach, -0.5 * reach, 30}, {-0.4 * reach, -0.3 * reach, 22}, {0.2 * reach, 0, 26}};
    made.paths.push_back(along("air", over, 160, 0.4 * reach, 60));
    for (ViewSpec<3>& frame : made.paths.back().frames) frame.look_at.z -= 0.2 * reach;
    made.paths.push_back(test_path(made.paths.front()));
    return made;
}

}  // namespace sightline::generate
