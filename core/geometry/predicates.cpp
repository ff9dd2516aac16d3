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
}  // namespace

int detail::orient_exact(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    // Segments share their ends so often that equal points are worth a test of their own.
    if (a == b || b == c || c == a) return 0;
    return CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(c.x, c.y));
}

int detail::orient_exact(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
    return CGAL::orientation(Kernel::Point_3(a.x, a.y, a.z), Kernel::Point_3(b.x, b.y, b.z),
                             Kernel::Point_3(c.x, c.y, c.z), Kernel::Point_3(d.x, d.y, d.z));
}

bool segments_meet(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
    const int abc = orient(a, b, c), abd = orient(a, b, d), cda = orient(c, d, a), cdb = orient(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && between(c, a, b)) || (abd == 0 && between(d, a, b)) || (cda == 0 && between(a, c, d)) ||
           (cdb == 0 && between(b, c, d));
}

}  // namespace sightline
