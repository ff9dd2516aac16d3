// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/drawing_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/raster/image_plane.h"

namespace sightline {

namespace {

constexpr double ns_per_ms = 1e6;

/// Pixels of `count` over [-1, 1] that a stretch touches.
std::uint64_t touched_pixels(double from, double to, int count) {
    const double half = count / 2.0;
    const double first = std::floor((std::clamp(from, -1.0, 1.0) + 1) * half);
    const double end = std::ceil((std::clamp(to, -1.0, 1.0) + 1) * half);
    return end > first ? static_cast<std::uint64_t>(end - first) : 0;
}

double squared_length(const Vec<2>& v) { return glm::dot(v, v); }
double squared_length(const Vec<3>& v) { return glm::dot(v, v); }

/// Where the image is, the change of its coordinate with the point is (across - x depth) / depth for an x in [-1, 1]:
/// its length is largest at one of the ends.
template <int D>
double squared_change(const Vec<D>& across, const Vec<D>& depth) {
    return std::max(squared_length(across - depth), squared_length(across + depth));
}

}  // namespace

double DrawingCost::ms(double vertices, double pixels) const {
    return std::max(vertex_ns * vertices, pixel_ns * pixels) / ns_per_ms;
}

void FrameDrawing::add(const DrawnSize& object) {
    all_.vertices += object.vertices;
    all_.pixels += object.pixels;
    sum_of_max_ += cost_.ms(static_cast<double>(object.vertices), static_cast<double>(object.pixels));
}

void FrameDrawing::take_out(const DrawnSize& object) {
    all_.vertices -= object.vertices;
    all_.pixels -= object.pixels;
    sum_of_max_ -= cost_.ms(static_cast<double>(object.vertices), static_cast<double>(object.pixels));
}

double FrameDrawing::ms(CostReading reading) const {
    if (reading == CostReading::max_of_sums)
        return cost_.ms(static_cast<double>(all_.vertices), static_cast<double>(all_.pixels));
    return std::max(0.0, sum_of_max_);
}

template <>
PixelScale<2>::PixelScale(const View<2>& view, const ImageSize& asked) : eye_(view.eye), all_round_(view.all_round) {
    const int width = image_size<2>(asked).width;
    if (all_round_) {
        pixels_ = {width / 4};
        parts_ = {
            {{Vec<2>(0, 1)}, {1, 0}}, {{Vec<2>(-1, 0)}, {0, 1}}, {{Vec<2>(0, -1)}, {-1, 0}}, {{Vec<2>(1, 0)}, {0, -1}}};
    } else {
        pixels_ = {width};
        const Vec<2> half = (view.corners[1] - view.corners[0]) * 0.5;
        const Vec<2> middle = (view.corners[0] + view.corners[1]) * 0.5 - view.eye;
        const double whole = cross(middle, half);
        parts_ = {{{Vec<2>(-middle.y, middle.x) / whole}, Vec<2>(half.y, -half.x) / whole}};
    }
    most_at_1_ = pixels_[0] / 2.0 * std::sqrt(squared_change<2>(parts_[0].across[0], parts_[0].depth));
}

template <>
PixelScale<3>::PixelScale(const View<3>& view, const ImageSize& asked) : eye_(view.eye) {
    const ImageSize size = image_size<3>(asked);
    const ImagePlane plane = image_plane(view);
    pixels_ = {size.width, size.height};
    parts_ = {{{plane.across[0], plane.across[1]}, plane.across[2]}};
    // The largest singular value of the two changes, in the corner where it is largest.
    const double half_w = size.width / 2.0, half_h = size.height / 2.0;
    const Vec<3>&x = plane.across[0], &y = plane.across[1], &w = plane.across[2];
    const double xx = half_w * half_w * squared_change<3>(x, w), yy = half_h * half_h * squared_change<3>(y, w);
    double xy = 0;
    for (const double i : {-1.0, 1.0})
        for (const double j : {-1.0, 1.0})
            xy = std::max(xy, half_w * half_h * std::abs(glm::dot(x - w * i, y - w * j)));
    most_at_1_ = std::sqrt((xx + yy) / 2 + std::sqrt((xx - yy) / 2 * ((xx - yy) / 2) + xy * xy));
}

template <int D>
std::uint64_t PixelScale<D>::pixels_of(const Part& part, const std::array<Vec<D>, 1 << D>& corners) const {
    Box<D> seen;  // its last axis has the depths
    for (const Vec<D>& corner : corners) {
        const Vec<D> q = corner - eye_;
        Vec<D> at(0);
        at[D - 1] = glm::dot(part.depth, q);
        for (std::size_t i = 0; i < D - 1; ++i) at[static_cast<int>(i)] = glm::dot(part.across[i], q) / at[D - 1];
        seen.add(at);
    }
    if (!(seen.max[D - 1] > 0)) return 0;
    const bool crosses = !(seen.min[D - 1] > 0);
    std::uint64_t pixels = 1;
    for (std::size_t i = 0; i < D - 1; ++i) {
        const int axis = static_cast<int>(i);
        pixels *= crosses ? static_cast<std::uint64_t>(pixels_[i])
                          : touched_pixels(seen.min[axis], seen.max[axis], pixels_[i]);
    }
    return pixels;
}

template <int D>
std::uint64_t PixelScale<D>::pixels_of(const Box<D>& box) const {
    std::uint64_t pixels = 0;
    if (box.empty()) return pixels;
    const auto corners = box.corners();
    for (const Part& part : parts_) pixels += pixels_of(part, corners);
    return pixels;
}

template <int D>
double PixelScale<D>::pixels_per_unit(const Box<D>& box) const {
    double depth = std::numeric_limits<double>::infinity();
    if (all_round_) {  // of the line that faces it
        depth = 0;
        for (int i = 0; i < D; ++i) depth = std::max({depth, box.min[i] - eye_[i], eye_[i] - box.max[i]});
    } else {
        for (const Vec<D>& corner : box.corners()) depth = std::min(depth, glm::dot(parts_[0].depth, corner - eye_));
    }
    return depth > 0 ? most_at_1_ / depth : std::numeric_limits<double>::infinity();
}

template class PixelScale<2>;
template class PixelScale<3>;

}  // namespace sightline
