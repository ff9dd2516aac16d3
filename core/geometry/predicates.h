// Exact predicates: the sign is that of real arithmetic on the given doubles, whatever their size.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "core/geometry/vec.h"

namespace sightline {

namespace detail {
int orient_exact(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c);
int orient_exact(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d);
}  // namespace detail

/// Which way the path a, b, c turns: +1 counter-clockwise, 0 collinear, -1 clockwise. Finite coordinates only.
inline int orient(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    // Forward error bound of Shewchuk (Adaptive precision floating-point arithmetic, 1997), stage A. The lower limit
    // keeps products that may have underflown away from it.
    constexpr double relative_error = 3.3306690738754716e-16;
    constexpr double underflow_limit = 1e-280;
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double det = left - right;
    const double size = std::abs(left) + std::abs(right);
    const double bound = relative_error * size;
    if (size > underflow_limit) {
        if (det > bound) return 1;
        if (-det > bound) return -1;
    }
    return detail::orient_exact(a, b, c);
}

/// Sign of the volume of the tetrahedron abcd: +1 when d sees a, b, c turn counter-clockwise.
inline int orient(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
    // Stage A again; Shewchuk's factor 7 + 56 * 2^-53 is rounded up to 8. The lower limit grows with the last factors,
    // because they multiply what an underflow in the first ones loses. Overflow makes every comparison false.
    constexpr double relative_error = 8 * 0x1p-53;
    constexpr double underflow_limit = 1e-280;
    const Vec<3> u = a - d, v = b - d, w = c - d;
    const double vw = v.x * w.y, wv = w.x * v.y, wu = w.x * u.y, uw = u.x * w.y, uv = u.x * v.y, vu = v.x * u.y;
    const double up = std::abs(u.z), vp = std::abs(v.z), wp = std::abs(w.z);
    const double det = u.z * (wv - vw) + v.z * (uw - wu) + w.z * (vu - uv);
    const double size =
        up * (std::abs(vw) + std::abs(wv)) + vp * (std::abs(wu) + std::abs(uw)) + wp * (std::abs(uv) + std::abs(vu));
    const double bound = relative_error * size;
    if (size > underflow_limit * (1 + up + vp + wp)) {
        if (det > bound) return 1;
        if (-det > bound) return -1;
    }
    return detail::orient_exact(a, b, c, d);
}

/// True when the closed segments ab and cd share at least one point. Zero-length segments count as points.
bool segments_meet(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d);

}  // namespace sightline
