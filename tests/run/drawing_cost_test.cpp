// The cost of drawing a frame, and how large things look in it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/drawing_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/base/random.h"
#include "core/scene/view.h"

namespace sightline {
namespace {

TEST(DrawingCost, IsThatOfTheSlowerPartInBothReadings) {
    const DrawingCost cost{100, 2};  // ns
    EXPECT_DOUBLE_EQ(cost.ms(30'000, 1'000'000), 3);
    EXPECT_DOUBLE_EQ(cost.ms(30'000, 2'000'000), 4);
    FrameDrawing frame(cost);
    frame.add({30'000, 1'000'000});  // waits for its vertices
    frame.add({300, 3'000'000});     // waits for its pixels
    EXPECT_DOUBLE_EQ(frame.ms(CostReading::sum_of_max), 3 + 6);
    EXPECT_DOUBLE_EQ(frame.ms(CostReading::max_of_sums), 8);
    frame.take_out({300, 3'000'000});
    EXPECT_NEAR(frame.ms(CostReading::sum_of_max), 3, 1e-12);
    EXPECT_DOUBLE_EQ(frame.ms(CostReading::max_of_sums), 3);
    EXPECT_EQ(frame.size(), (DrawnSize{30'000, 1'000'000}));
}

TEST(DrawingCost, TheSumIsNeverBelowTheMaximum) {
    Random random(4);
    for (int round = 0; round < 200; ++round) {
        FrameDrawing frame({random.uniform(0, 50), random.uniform(0, 5)});
        for (int i = 0; i < 20; ++i) frame.add({random.below(5000), random.below(90'000)});
        ASSERT_GE(frame.ms(CostReading::sum_of_max) * (1 + 1e-12), frame.ms(CostReading::max_of_sums));
    }
}

template <int D>
struct Sight {
    View<D> view;
    ImageSize size;
    PixelScale<D> scale;
};
Sight<2> random_sight(Random& random, Vec<2>) {
    const Vec<2> eye(random.uniform(-1, 1), random.uniform(-1, 1));
    const ViewSpec<2> spec{eye, eye + Vec<2>(random.uniform(-1, 1), random.uniform(.1, 1)),
                           random.below(4) == 0 ? 360 : random.uniform(10, 150)};
    const View<2> view = make_view(spec);
    const ImageSize size{400, 1};
    return {view, size, PixelScale<2>(view, size)};
}
Sight<3> random_sight(Random& random, Vec<3>) {
    const Vec<3> eye(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const View<3> view =
        make_view({eye, eye + Vec<3>(random.uniform(-1, 1), random.uniform(.1, 1), random.uniform(-1, 1)),
                   random.uniform(10, 120)},
                  4.0 / 3);
    const ImageSize size{400, 300};
    return {view, size, PixelScale<3>(view, size)};
}

/// In pixels from the image's corner; nothing behind the eye. By the view's corners alone. All round, `line` tells
/// which of the four lines it is on.
std::optional<Vec<2>> seen_at(const Sight<3>& sight, const Vec<3>& p) {
    const auto& c = sight.view.corners;
    // p = eye + t (c3 + x (c2 - c3) + y (c0 - c3) - eye): Cramer's rule.
    const Vec<3> q = p - sight.view.eye, o = c[3] - sight.view.eye, u = c[2] - c[3], v = c[0] - c[3];
    const auto det = [](const Vec<3>& a, const Vec<3>& b, const Vec<3>& d) { return glm::dot(a, glm::cross(b, d)); };
    const double whole = det(o, u, v), t = det(q, u, v) / whole;
    if (!(t > 0)) return std::nullopt;
    return Vec<2>(det(o, q, v) / whole / t * sight.size.width, det(o, u, q) / whole / t * sight.size.height);
}
std::optional<Vec<2>> seen_at(const Sight<2>& sight, const Vec<2>& p) {
    const Vec<2> q = p - sight.view.eye;
    if (sight.view.all_round) {
        const double side = sight.size.width / 4.0;
        const double deep = std::max(std::abs(q.x), std::abs(q.y));
        if (!(deep > 0)) return std::nullopt;
        if (q.x == deep) return Vec<2>((q.y / deep + 1) / 2 * side, 0);
        if (q.y == deep) return Vec<2>((1 - q.x / deep) / 2 * side + side, 0);
        if (q.x == -deep) return Vec<2>((1 - q.y / deep) / 2 * side + 2 * side, 0);
        return Vec<2>((q.x / deep + 1) / 2 * side + 3 * side, 0);
    }
    const Vec<2> right = sight.view.corners[0] - sight.view.eye, along = sight.view.corners[1] - sight.view.corners[0];
    const double t = cross(q, along) / cross(right, along);
    if (!(t > 0)) return std::nullopt;
    return Vec<2>(cross(right, q) / cross(right, along) / t * sight.size.width, 0);
}

template <int D>
void expect_bounds() {
    Random random(60 + D);
    int tight = 0, compared = 0;
    for (int round = 0; round < 400; ++round) {
        const Sight<D> sight = random_sight(random, Vec<D>(0));
        Box<D> box;
        Vec<D> middle, half;
        for (int i = 0; i < D; ++i) middle[i] = random.uniform(-4, 4), half[i] = random.uniform(0.001, 0.3);
        box.add(middle - half);
        box.add(middle + half);
        const double most = sight.scale.pixels_per_unit(box);
        const auto point = [&] {
            Vec<D> p;
            for (int i = 0; i < D; ++i) p[i] = random.uniform(box.min[i], box.max[i]);
            return p;
        };
        const auto inside = [&](const Vec<2>& at) {
            return at.x >= 0 && at.x <= sight.size.width && at.y >= 0 && at.y <= sight.size.height;
        };
        double largest = 0;
        Box<2> pixels;
        for (int i = 0; i < 60; ++i) {
            const Vec<D> p = point(), q = i % 2 ? point() : p + (point() - p) * 1e-4;
            const auto a = seen_at(sight, p), b = seen_at(sight, q);
            if (!a || !inside(*a)) continue;
            pixels.add(*a);
            if (!b) {
                ASSERT_TRUE(std::isinf(most));
                continue;
            }
            double apart = std::sqrt(glm::dot(*a - *b, *a - *b));
            if (sight.view.all_round) apart = std::min(apart, sight.size.width - apart);
            ASSERT_LE(apart, most * std::sqrt(glm::dot(p - q, p - q)) * (1 + 1e-6) + 1e-9);
            largest = std::max(largest, apart / std::sqrt(glm::dot(p - q, p - q)) / most);
        }
        const auto counted = static_cast<double>(sight.scale.pixels_of(box));
        ASSERT_LE(counted, double(sight.size.width) * sight.size.height);
        if (pixels.empty()) continue;
        ++compared;
        tight += largest > 0.5;
        const Vec<2> e = pixels.extent();
        ASSERT_GE(counted + 1e-6, D == 2 ? e.x * (sight.view.all_round ? 0 : 1) : e.x * e.y);
        ASSERT_GE(counted, 1);
    }
    EXPECT_GT(compared, 40);
    EXPECT_GT(tight, compared / 3) << "a bound that is nowhere reached says little";
}
TEST(PixelScale, BoundsWhatItShows2d) { expect_bounds<2>(); }
TEST(PixelScale, BoundsWhatItShows3d) { expect_bounds<3>(); }

TEST(PixelScale, CountsTheBoxOfThePixels) {
    const View<3> view = make_view({{0, 0, 0}, {0, 1, 0}, 90}, 1);
    const PixelScale<3> scale(view, {100, 100});
    const auto box = [](Vec<3> low, Vec<3> high) {
        Box<3> made;
        made.add(low);
        made.add(high);
        return made;
    };
    EXPECT_EQ(scale.pixels_of(box({-0.1, 10, -0.2}, {0.1, 10, 0.2})), 4u);       // two half pixels by two
    EXPECT_EQ(scale.pixels_of(box({-100, 10, -100}, {100, 10, 100})), 10'000u);  // clipped
    EXPECT_EQ(scale.pixels_of(box({-0.1, -1, -0.2}, {0.1, 1, 0.2})), 10'000u);   // across the plane of the eye
    EXPECT_EQ(scale.pixels_of(box({-0.1, -2, -0.2}, {0.1, -1, 0.2})), 0u);       // behind
    EXPECT_TRUE(std::isinf(scale.pixels_per_unit(box({-0.1, -1, -0.2}, {0.1, 1, 0.2}))));
}

}  // namespace
}  // namespace sightline
