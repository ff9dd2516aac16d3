// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/by_viewpoint/directions.h"

#include "core/base/number.h"
#include "core/base/trig.h"

namespace sightline {

namespace {

/// Half degrees are told: 112.5°.
std::string degrees(double value) { return (value < 0 ? "−" : "") + short_number(value < 0 ? -value : value, 4) + "°"; }

}  // namespace

template <int D>
Directions<D>::Directions(std::uint32_t azimuths, std::uint32_t elevations, int up_axis)
    : azimuths_(azimuths), elevations_(elevations), up_(up_axis) {
    if constexpr (D == 3) {
        x_ = up_ == 0 ? 1 : 0;
        y_ = up_ == 2 ? 1 : 2;
        const double band = 180.0 / (elevations_ + 1);
        for (std::uint32_t i = 0; i <= elevations_; ++i) sine_.push_back(sincos_degrees(-90 + band * (i + 0.5)).sin);
    }
    for (std::uint32_t i = 0; i < azimuths_; ++i) {
        const SinCos at = sincos_degrees(azimuth(i)[0]);
        first_.push_back({at.cos, at.sin});
    }
}

template <int D>
std::array<double, 2> Directions<D>::azimuth(std::uint32_t interval) const {
    if (is_cap(interval)) return {0, 360};
    const double width = 360.0 / azimuths_;
    const double from = width * (interval % azimuths_ - 0.5);
    return {from, from + width};
}

template <int D>
std::array<double, 2> Directions<D>::elevation(std::uint32_t interval) const {
    if (D == 2) return {0, 0};
    const double band = 180.0 / (elevations_ + 1);
    if (interval == azimuths_ * elevations_) return {-90, -90 + band / 2};
    if (is_cap(interval)) return {90 - band / 2, 90};
    const double from = -90 + band * (interval / azimuths_ + 0.5);
    return {from, from + band};
}

template <int D>
std::uint32_t Directions<D>::sector(double x, double y) const {
    const Vec<2> d(x, y);
    for (std::uint32_t i = 0; i + 1 < azimuths_; ++i)
        if (cross(first_[i], d) >= 0 && cross(first_[i + 1], d) < 0) return i;
    return azimuths_ - 1;  // the only one left; also where x and y are 0
}

template <int D>
std::uint32_t Directions<D>::at(const Vec<D>& direction) const {
    if constexpr (D == 2) {
        return sector(direction.x, direction.y);
    } else {
        const double up = direction[up_], length = std::sqrt(glm::dot(direction, direction));
        std::uint32_t band = 0;
        while (band <= elevations_ && up >= sine_[band] * length) ++band;
        if (band == 0) return azimuths_ * elevations_;
        if (band > elevations_) return azimuths_ * elevations_ + 1;
        return (band - 1) * azimuths_ + sector(direction[x_], direction[y_]);
    }
}

template <int D>
Vec<D> Directions<D>::inside(std::uint32_t interval, double across, double up) const {
    const auto [from, to] = azimuth(interval);
    const SinCos level = sincos_degrees(from + (to - from) * across);
    if constexpr (D == 2) {
        return {level.cos, level.sin};
    } else {
        const auto [low, high] = elevation(interval);
        const SinCos height = sincos_degrees(low + (high - low) * up);
        Vec<3> d(0);
        d[x_] = level.cos * height.cos;
        d[y_] = level.sin * height.cos;
        d[up_] = height.sin;
        return d;
    }
}

template <int D>
std::string Directions<D>::words(std::uint32_t interval) const {
    const auto [from, to] = azimuth(interval);
    const auto [low, high] = elevation(interval);
    const std::string height = D == 2 ? "" : "elevation " + degrees(low) + " to " + degrees(high);
    if (is_cap(interval)) return height;
    return "azimuth " + degrees(from) + " to " + degrees(to) + (D == 2 ? "" : ", " + height);
}

template class Directions<2>;
template class Directions<3>;

}  // namespace sightline
