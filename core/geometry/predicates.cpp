// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace sightline {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool within(double value, double end0, double end1) {
    return std::min(end0, end1) <= value && value <= std::max(end0, end1);
}

/// For p known to lie on the line ab: whether it lies between a and b.
bool between(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b) {
    return within(p.x, a.x, b.x) && within(p.y, a.y, b.y);
}

/// What brings coordinates to where Boost's rationals take them, without rounding and without a change of sign: they
/// throw at doubles below 1e-292. 1 where all are large enough, or another is too large for it.
template <typename... Points>
double enlargement(const Points&... points) {
    bool tiny = false, large = false;
    const auto look = [&](double value) {
        tiny = tiny || (value != 0 && std::abs(value) < 1e-280);
        large = large || std::abs(value) > 1e150;
    };
    const auto look_at = [&](const auto& p) {
        for (int i = 0; i < p.length(); ++i) look(p[i]);
    };
    (look_at(points), ...);
    return tiny && !large ? 0x1p500 : 1;
}
}  // namespace

int detail::orient_exact(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    // Segments share their ends so often that equal points are worth a test of their own.
    if (a == b || b == c || c == a) return 0;
    const double f = enlargement(a, b, c);
    const auto point = [f](const Vec<2>& p) { return Kernel::Point_2(f * p.x, f * p.y); };
    return CGAL::orientation(point(a), point(b), point(c));
}

int detail::orient_exact(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
    const double f = enlargement(a, b, c, d);
    const auto point = [f](const Vec<3>& p) { return Kernel::Point_3(f * p.x, f * p.y, f * p.z); };
    return CGAL::orientation(point(a), point(b), point(c), point(d));
}

bool segments_meet(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
    const int abc = orient(a, b, c), abd = orient(a, b, d), cda = orient(c, d, a), cdb = orient(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && between(c, a, b)) || (abd == 0 && between(d, a, b)) || (cda == 0 && between(a, c, d)) ||
           (cdb == 0 && between(b, c, d));
}

}  // namespace sightline
