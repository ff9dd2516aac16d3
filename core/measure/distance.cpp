// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/truth/reference.h"

namespace sightline {

namespace {

/// The point to look through at a pixel's centre.
Vec<2> centre_of(const View<2>& view, const IdImage& image, int x, int) {
    if (!view.all_round) {
        const double left = (x + 0.5) / image.width;
        return view.corners[0] + (view.corners[1] - view.corners[0]) * left;
    }
    const int side = image.width / 4, facing = x / side;
    const double across = 2 * (x % side + 0.5) / side - 1;
    const Vec<2> ahead = facing % 2 == 0 ? Vec<2>(1 - facing, 0) : Vec<2>(0, 2 - facing);
    return view.eye + ahead + Vec<2>(-ahead.y, ahead.x) * across;
}
Vec<3> centre_of(const View<3>& view, const IdImage& image, int x, int y) {
    return pixel_centre(view, {image.width, image.height}, x, y);
}

/// How many times the ray is as long where it meets the line or plane of the primitive.
double meets(const Primitive<2>& segment, const Vec<2>& eye, const Vec<2>& ray) {
    const Vec<2> along = segment[1] - segment[0];
    return cross(segment[0] - eye, along) / cross(ray, along);
}
double meets(const Primitive<3>& triangle, const Vec<3>& eye, const Vec<3>& ray) {
    const Vec<3> normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    return glm::dot(normal, triangle[0] - eye) / glm::dot(normal, ray);
}

template <int D>
double length(const Vec<D>& v) {
    return std::sqrt(glm::dot(v, v));
}

/// Corners are rounded to the raster, so that a ray may miss what its pixel shows; then, and always at most, it is as
/// far as the farthest corner.
template <int D>
double distance_to(const Primitive<D>& primitive, const Vec<D>& eye, const Vec<D>& ray) {
    double farthest = 0;
    for (const Vec<D>& corner : primitive) farthest = std::max(farthest, length<D>(corner - eye));
    const double times = meets(primitive, eye, ray);
    return times > 0 && std::isfinite(times) ? std::min(farthest, times * length<D>(ray)) : farthest;
}

}  // namespace

double distance_bin_end(std::size_t bin) {
    return bin + 1 < distance_bins ? std::ldexp(1.0, static_cast<int>(bin + 2) - static_cast<int>(distance_bins))
                                   : std::numeric_limits<double>::infinity();
}

template <int D>
std::vector<std::uint8_t> distance_bins_of(const IdImage& image, const Scene<D>& scene, const View<D>& view) {
    std::vector<std::uint8_t> bins(image.ids.size(), no_bin);
    const double side = bounds<D>(scene.primitives).longest_side();
    std::size_t at = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x, ++at) {
            if (image.ids[at] == none) continue;
            const Vec<D> ray = centre_of(view, image, x, y) - view.eye;
            const double distance = distance_to<D>(scene.primitives[image.ids[at]], view.eye, ray);
            std::uint8_t bin = 0;
            while (bin + 1u < distance_bins && distance >= distance_bin_end(bin) * side) ++bin;
            bins[at] = bin;
        }
    return bins;
}

void count_distances(std::span<const std::uint8_t> bins, std::span<const std::uint8_t> wrong, Values& values) {
    values.wrong_at.fill(0);
    values.pixels_at.fill(0);
    const double pixel = 1 / static_cast<double>(bins.size());
    std::array<std::size_t, distance_bins> all{}, missed{};
    for (std::size_t i = 0; i < bins.size(); ++i) {
        if (bins[i] == no_bin) continue;
        ++all[bins[i]];
        missed[bins[i]] += wrong[i];
    }
    for (std::size_t bin = 0; bin < distance_bins; ++bin) {
        values.wrong_at[bin] = static_cast<double>(missed[bin]) * pixel;
        values.pixels_at[bin] = static_cast<double>(all[bin]) * pixel;
    }
}

template std::vector<std::uint8_t> distance_bins_of<2>(const IdImage&, const Scene<2>&, const View<2>&);
template std::vector<std::uint8_t> distance_bins_of<3>(const IdImage&, const Scene<3>&, const View<3>&);

}  // namespace sightline
