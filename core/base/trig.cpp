// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/trig.h"

#include <cmath>

namespace sightline {

namespace {

/// Taylor series for |x| <= pi/4; the last terms are below 1e-18.
SinCos sincos_small(double x) {
    const double x2 = x * x;
    double sin = 0, cos = 0;
    for (int n = 20; n >= 2; n -= 2) {
        cos = 1 - x2 / (n * (n - 1)) * (n == 20 ? 1 : cos);
        sin = 1 - x2 / (n * (n + 1)) * (n == 20 ? 1 : sin);
    }
    return {x * sin, cos};
}

/// arctan for 0 <= t <= 1: two halvings of the angle, then the series.
double atan_unit(double t) {
    for (int i = 0; i < 2; ++i) t = t / (1 + std::sqrt(1 + t * t));
    const double t2 = t * t;
    double sum = 0;
    for (int n = 33; n >= 1; n -= 2) sum = 1.0 / n - t2 * sum;
    return 4 * t * sum;
}

}  // namespace

SinCos sincos_degrees(double degrees) {
    const double quarter = std::nearbyint(degrees / 90);
    const SinCos s = sincos_small((degrees - 90 * quarter) * (pi / 180));
    switch (static_cast<long>(quarter) & 3) {
        case 0:
            return s;
        case 1:
            return {s.cos, -s.sin};
        case 2:
            return {-s.sin, -s.cos};
        default:
            return {-s.cos, s.sin};
    }
}

double angle_of(double y, double x) {
    const double ax = std::abs(x), ay = std::abs(y);
    if (ax == 0 && ay == 0) return 0;
    double angle = ay <= ax ? atan_unit(ay / ax) : pi / 2 - atan_unit(ax / ay);
    if (x < 0) angle = pi - angle;
    return y < 0 ? -angle : angle;
}

}  // namespace sightline
