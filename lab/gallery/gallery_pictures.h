// Pictures of a scene of the gallery: the step at which it goes wrong, and what the whole budget misses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "lab/lab_graphics.h"

namespace sightline::lab {

struct GalleryPicture {
    std::filesystem::path file;  ///< PNG or SVG
    std::string caption;         ///< text
};

/// Of a session as gallery_session() makes it: at its step, then at the end of the run, in 3D with what is missed in
/// red; in 2D one only where its step is the end. Files go into `folder`; their names begin with `stem`. Throws
/// WorkError.
template <int D>
std::vector<GalleryPicture> draw_gallery_pictures(const Session<D>& session, const std::filesystem::path& folder,
                                                  const std::string& stem, LabGraphics& graphics);

}  // namespace sightline::lab
