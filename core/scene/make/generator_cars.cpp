// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/car.h"
#include "core/scene/make/generators_3d.h"
#include "core/scene/make/route.h"

namespace sightline {

namespace {

struct CarField {
    Model model;
    std::vector<CarPart> parts;
};

CarField car_field(std::uint64_t seed, std::size_t triangles) {
    Random random(seed);
    CarField park;
    Model& model = park.model;
    model.triangles.reserve(triangles + 500);
    model.box({-8, -5, -0.1}, {8, 5, 0}, top_side);
    park.parts.resize(model.triangles.size(), CarPart::none);

    // Bodies get a quarter of the triangles, engines most of the others.
    constexpr std::size_t count = 5;
    int detail = 1;
    while (static_cast<std::size_t>((detail + 1) * (detail + 1)) * car_body_triangles * 4 * count < triangles) ++detail;
    for (std::size_t i = 0; i < count; ++i) {
        model.wanted = triangles * (i + 1) / count;
        const double x = -6 + 3.0 * static_cast<double>(i), degrees = 90 + random.uniform(-8, 8);
        const bool turned_round = i % 2 == 1;
        const Inside place(model, {x, turned_round ? 2.2 : -2.2, 0}, turned_round ? degrees + 180 : degrees);
        car(model, random, detail, i == 2, park.parts);
    }
    return park;
}

}  // namespace

std::vector<CarPart> car_parts(std::uint64_t seed, std::size_t triangles) { return car_field(seed, triangles).parts; }

Generated generate::cars(std::uint64_t seed, std::size_t triangles) {
    Generated made;
    made.triangles = car_field(seed, triangles).model.triangles;
    FlightPath<3> round{"round", {}};
    for (int i = 0; i < 200; ++i) {
        const SinCos turn = sincos_degrees(-120 + 1.8 * i), rise = sincos_degrees(5.4 * i);
        const Vec<3> eye(10 * turn.cos, 6.2 * turn.sin, 1.9 + 0.7 * rise.sin);
        round.frames.push_back({eye, {2.5 * turn.cos, 0, 0.6}, 50});
    }
    made.paths = {round, test_path(round)};
    return made;
}

}  // namespace sightline
