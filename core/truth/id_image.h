// Images whose pixels are primitive ids: the reference in 3D (TVCG section 4.4). OpenGL draws them (shell/gl), or the
// rasteriser of core (software_ids.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/image_size.h"
#include "core/truth/visible_set.h"

namespace sightline {

/// Rows from the top; none where nothing is seen. The sample of a pixel is its centre.
struct IdImage {
    int width = 0, height = 0;
    std::vector<std::uint32_t> ids;
    bool software = false;  ///< drawn without OpenGL

    std::uint32_t at(int x, int y) const {
        return ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// Draws what the view sees of a scene: image 0 has the nearest primitive at each pixel, image i the one that lies
/// behind those of the images before it (at most `layers` images, fewer when an image is empty; image 0 always is
/// there). Primitives that turn their back on the eye (faces, traversal/view.h) are not drawn. Throws WorkError when
/// it cannot be drawn.
using DrawIds =
    std::function<std::vector<IdImage>(const Scene<3>& scene, const View<3>& view, const ImageSize& size, int layers)>;

}  // namespace sightline
