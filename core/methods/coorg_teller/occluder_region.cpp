// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/occluder_region.h"

#include "core/base/trig.h"

namespace sightline {

namespace {

template <int D>
double length(const Vec<D>& v) {
    return std::sqrt(glm::dot(v, v));
}

/// How far the region of one side reaches in a direction whose cosine with the normal is `cosine`, as a share of its
/// reach. 2D: a circle through the centre.
double extent_share(double cosine, int dimension) {
    if (dimension == 2) return (1 + cosine) / 2;
    // The farthest point of √cosθ at an angle α from the normal has tanθ = (-3 ± √(9 + 8 tan²α)) / (2 tanα); written
    // with sines, so that neither α = 0 nor α = 90° divides by 0.
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double root = std::sqrt(9 * cosine * cosine + 8 * sine * sine);
    const double up = root - 3 * cosine, along = 2 * sine;  // tanθ = up / along
    const double size = std::sqrt(up * up + along * along);
    if (size == 0) return cosine > 0 ? 1 : 0;  // α is 0 or 180°
    const double cos_theta = along / size, sin_theta = up / size;
    return std::sqrt(cos_theta) * (cos_theta * cosine + sin_theta * sine);
}

template <int D>
double reach_of(const Vec<D>& area, double threshold) {
    const double size = length<D>(area);
    return D == 2 ? size / threshold : std::sqrt(size / threshold);
}

}  // namespace

template <int D>
double area_angle(const Vec<D>& area, const Vec<D>& centre, const Vec<D>& eye) {
    const Vec<D> away = eye - centre;
    const double distance2 = glm::dot(away, away);
    if (distance2 == 0) return 0;
    const double seen = glm::dot(area, away) / std::sqrt(distance2);  // |A| cosθ
    return seen / (D == 2 ? std::sqrt(distance2) : distance2);
}

template <int D>
Box<D> occluder_region(const Vec<D>& area, const Vec<D>& centre, double threshold, bool both_sides) {
    const double reach = reach_of<D>(area, threshold), size = length<D>(area);
    Box<D> box{centre, centre};
    if (size == 0) return box;
    for (int i = 0; i < D; ++i) {
        const double cosine = area[i] / size;
        double up = extent_share(cosine, D), down = extent_share(-cosine, D);
        if (both_sides) up = down = std::max(up, down);
        box.max[i] += up * reach;
        box.min[i] -= down * reach;
    }
    return box;
}

template <int D>
std::vector<Vec<D>> region_outline(const Vec<D>& area, const Vec<D>& centre, double threshold, const Vec<D>& across,
                                   int count) {
    const double reach = reach_of<D>(area, threshold), size = length<D>(area);
    std::vector<Vec<D>> outline;
    if (size == 0) return outline;
    const Vec<D> normal = area / size;
    Vec<D> side = across - normal * glm::dot(across, normal);
    if (const double l = length<D>(side); l > 0) side /= l;
    for (int i = 0; i < count; ++i) {
        const SinCos theta = sincos_degrees(-90 + 180.0 * i / (count - 1));
        const double r = reach * (D == 2 ? theta.cos : std::sqrt(std::max(0.0, theta.cos)));
        outline.push_back(centre + normal * (r * theta.cos) + side * (r * theta.sin));
    }
    return outline;
}

#define SIGHTLINE_INSTANTIATE(D)                                                    \
    template double area_angle<D>(const Vec<D>&, const Vec<D>&, const Vec<D>&);     \
    template Box<D> occluder_region<D>(const Vec<D>&, const Vec<D>&, double, bool); \
    template std::vector<Vec<D>> region_outline<D>(const Vec<D>&, const Vec<D>&, double, const Vec<D>&, int);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
