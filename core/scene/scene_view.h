// A view in a scene as references and traversals take it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/image_size.h"
#include "core/scene/view.h"

namespace sightline {

/// Throws as make_view does.
inline View<2> scene_view(const ViewSpec<2>& spec, const Scene<2>&, const ImageSize&) { return make_view(spec); }

/// The size of the reference gives the aspect: a window's never does.
inline View<3> scene_view(const ViewSpec<3>& spec, const Scene<3>& scene, const ImageSize& reference_size) {
    const ImageSize size = image_size<3>(reference_size);
    return make_view(spec, static_cast<double>(size.width) / size.height, scene.up_axis);
}

}  // namespace sightline
