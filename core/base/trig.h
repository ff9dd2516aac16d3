// Trigonometry from + - * / and sqrt alone: the C library's functions differ in the last bit between machines, and
// these values take part in decisions (the view's border, a cell's visible share).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sightline {

inline constexpr double pi = 3.14159265358979323846;

struct SinCos {
    double sin, cos;
};

/// Sine and cosine of an angle in degrees, within 1e-15; exact at multiples of 90. |degrees| <= 1e6.
SinCos sincos_degrees(double degrees);

/// Angle of the vector (x, y) in radians, in (-pi, pi], within 1e-15; 0 for the zero vector.
double angle_of(double y, double x);

}  // namespace sightline
