// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/model.h"
#include "core/scene/make/plots.h"
#include "core/scene/make/route.h"

namespace sightline::generate {

namespace {

constexpr double plot_side = 3;

double ground_height(double x, double y) {
    return 0.35 * sincos_degrees(13 * x).sin + 0.3 * sincos_degrees(11 * y + 7 * x).sin;
}

/// The trail runs along x and winds.
double trail(double x) { return 3 * sincos_degrees(9 * x).sin; }
constexpr double trail_half_width = 0.8;

Vec<3> unit_vector(Random& random) {
    for (;;) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        const Vec<3> v(x, y, z);
        const double size = glm::dot(v, v);
        if (size > 0.01 && size < 1) return v / std::sqrt(size);
    }
}

class Jungle {
public:
    Jungle(Model& model, std::vector<std::uint8_t>& two_sided) : m_(model), two_sided_(two_sided) {}

    void ground(const Vec<2>& low) {
        const Vec<2> high = low + plot_side;
        const auto corner = [](double x, double y) { return Vec<3>(x, y, ground_height(x, y)); };
        m_.polygon({corner(low.x, low.y), corner(high.x, low.y), corner(high.x, high.y), corner(low.x, high.y)});
        mark(0);
    }
    void trunk(const Vec<3>& foot, double radius, double height) {
        m_.turned_solid(foot - Vec<3>(0, 0, 0.3), {0, 0, 1},
                        {{1.4 * radius, 0}, {radius, 0.8}, {0.6 * radius, height}, {0, height + 0.2}}, 7);
        mark(0);
    }
    /// Leaves in the outer parts of an ellipsoid, hanging outward.
    void clump(Random& random, const Vec<3>& centre, const Vec<3>& radii, int leaves, double size) {
        for (int i = 0; i < leaves && !m_.full(); ++i) {
            const Vec<3> out = unit_vector(random);
            const double depth = random.uniform(0.45, 1);
            Vec<3> along = out + 0.7 * unit_vector(random) - Vec<3>(0, 0, 0.4);
            along /= std::sqrt(std::max(glm::dot(along, along), 0.01));
            leaf(random, centre + radii * out * depth, along, size * random.uniform(0.7, 1.3));
        }
        mark(1);
    }
    /// Long leaves that bend down all round.
    void fern(Random& random, const Vec<3>& foot, double reach) {
        const int fronds = 9;
        for (int i = 0; i < fronds; ++i) {
            const SinCos turn = sincos_degrees(360.0 * i / fronds + random.uniform(-15, 15));
            const double length = reach * random.uniform(0.8, 1), rise = random.uniform(0.7, 1.1);
            const Vec<3> out(turn.cos, turn.sin, 0), side(-turn.sin, turn.cos, 0);
            Vec<3> left = foot, right = foot;
            for (int piece = 1; piece <= 4; ++piece) {
                const double t = piece / 4.0, half = 0.09 * (1 - t) * (1 + 3 * t);
                const Vec<3> middle = foot + out * (length * t) + Vec<3>(0, 0, rise * t * (1.9 - 1.6 * t));
                const Vec<3> next_left = middle + side * half, next_right = middle - side * half;
                if (piece > 1) m_.triangle(right, left, next_left);
                if (piece < 4)
                    m_.triangle(right, next_left, next_right);
                else
                    left = next_left;
                left = next_left, right = next_right;
            }
        }
        mark(1);
    }

private:
    /// Two triangles, folded along the middle.
    void leaf(Random& random, const Vec<3>& at, const Vec<3>& along, double size) {
        Vec<3> side = glm::cross(along, unit_vector(random));
        side /= std::sqrt(std::max(glm::dot(side, side), 0.01));
        const Vec<3> fold = glm::cross(side, along) * (0.1 * size), tip = at + along * size;
        m_.triangle(at, at + along * (0.4 * size) - side * (0.35 * size) + fold, tip);
        m_.triangle(at, tip, at + along * (0.4 * size) + side * (0.35 * size) + fold);
    }
    void mark(std::uint8_t both_sides) { two_sided_.resize(m_.triangles.size(), both_sides); }

    Model& m_;
    std::vector<std::uint8_t>& two_sided_;
};

/// As near to the plot's middle as the trail allows something of this radius.
Vec<3> beside_trail(Random& random, const Vec<2>& middle, double radius) {
    const double x = middle.x + random.uniform(-0.9, 0.9), y = middle.y + random.uniform(-0.9, 0.9);
    const double from = y - trail(x), clear = trail_half_width + radius;
    const double moved = std::abs(from) >= clear ? y : trail(x) + (from < 0 ? -clear : clear);
    return {x, moved, ground_height(x, moved)};
}

}  // namespace

Generated jungle(std::uint64_t seed, std::size_t triangles) {
    Generated made;
    Model model;
    model.wanted = triangles;
    model.triangles.reserve(triangles + 500);
    made.two_sided.reserve(triangles + 500);
    Jungle jungle(model, made.two_sided);
    double reach = 0;
    for (const Plot& plot : plots_by_distance(triangles / 300 + 20)) {
        if (model.full()) break;
        reach = plot_side * std::sqrt(plot.distance2());
        Random random = plot.random(seed);
        const Vec<2> low = plot_side * Vec<2>(plot.x, plot.y), middle = low + plot_side / 2;
        jungle.ground(low);
        if (random.below(3) == 0) {
            const double radius = random.uniform(0.12, 0.25), height = random.uniform(4.5, 8);
            const Vec<3> foot = beside_trail(random, middle, radius);
            jungle.trunk(foot, radius, height);
            for (int i = 0; i < 3; ++i) {
                const double dx = random.uniform(-1, 1), dy = random.uniform(-1, 1), dz = random.uniform(-1.2, 0.6);
                const double size = random.uniform(0.9, 1.4);
                jungle.clump(random, foot + Vec<3>(dx, dy, height + dz), {size, size, 0.6 * size}, 70, 0.4);
            }
        }
        const double bush = random.uniform(0.6, 1.1);
        const Vec<3> foot = beside_trail(random, middle, bush + 0.3);
        jungle.clump(random, foot + Vec<3>(0, 0, 0.9 * bush), {bush, bush, bush}, 110, 0.3);
        const double reach_of_fern = random.uniform(0.7, 1);
        if (random.below(2) == 0 && !model.full())
            jungle.fern(random, beside_trail(random, middle, 0.9), reach_of_fern);
    }
    made.triangles = std::move(model.triangles);

    const double end = std::min(0.75 * reach, 40.0);
    std::vector<Vec<3>> way;
    for (int i = 0; i <= 80; ++i) {
        const double x = end * (i / 40.0 - 1);
        way.push_back({x, trail(x), ground_height(x, trail(x)) + 1.6});
    }
    made.paths.push_back(along("trail", way, 200, 3, 60));
    made.paths.push_back(test_path(made.paths.front()));
    return made;
}

}  // namespace sightline::generate
