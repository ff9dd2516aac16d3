// Scenes that are hard on a rasteriser, each with a view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster/depth_image.h"
#include "core/scene/view.h"
#include "tests/scene/soup_scenes.h"

namespace sightline::test {

inline constexpr ImageSize small_size{101, 75};

inline View<3> raster_view(const Vec<3>& eye, const Vec<3>& look_at, double fov, const ImageSize& size = small_size) {
    return make_view({as_float(eye), look_at, fov}, static_cast<double>(size.width) / size.height);
}

struct RasterCase {
    const char* what;
    Scene<3> scene;
    View<3> view;
};

inline std::vector<RasterCase> raster_cases(std::uint64_t seed) {
    Random random(seed);
    const Vec<3> outside = around(random, {0, 0, 0}, 2);
    return {{"soup", soup(300, {0, 0, 0}, 1, seed), raster_view(outside, {0, 0, 0}, 70)},
            {"small", soup(300, {0, 0, 0}, 1e-6, seed), raster_view(outside * 1e-6, {0, 0, 0}, 70)},
            {"huge", soup(300, {0, 0, 0}, 1e7, seed), raster_view(outside * 1e7, {0, 0, 0}, 70)},
            {"inside", soup(200, {0, 0, 0}, 1, seed), raster_view({0.1, 0, 0}, {1, 0.2, 0}, 170)},
            {"slivers", slivers(400, seed), raster_view({-2, 0.3, 0.4}, {0, 0, 0}, 50)},
            {"coplanar", coplanar(60, seed), raster_view({-2, 0.3, 0.4}, {0, 0, 0}, 50)},
            {"near", boxes_around_the_eye(0.05, 10, seed), raster_view({0, 0, 0}, {1, 0.1, 0.3}, 90)},
            {"very near", boxes_around_the_eye(1e-5, 1000, seed), raster_view({0, 0, 0}, {0.2, -1, 0.3}, 90)}};
}

inline DepthImage whole_image(const RasterCase& c, const RasterWork& work = {}) {
    DepthImage image(small_size);
    draw_depth(image, c.scene, c.view, work);
    return image;
}

}  // namespace sightline::test
