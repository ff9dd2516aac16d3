// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/software_ids.h"

#include "core/raster/depth_image.h"

namespace sightline {

std::vector<IdImage> draw_ids_in_software(const Scene<3>& scene, const View<3>& view, const ImageSize& size,
                                          int layers) {
    std::vector<IdImage> images;
    for (DepthImage& drawn : draw_layers(scene, view, size, layers))
        images.push_back({drawn.width, drawn.height, std::move(drawn.ids), true});
    return images;
}

DrawIds drawing_of(ReferenceBy by, const DrawIds& opengl) {
    if (by == ReferenceBy::software || !opengl) return draw_ids_in_software;
    return opengl;
}

}  // namespace sightline
