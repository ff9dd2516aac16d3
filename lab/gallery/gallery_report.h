// The gallery as a page for a class: who survives what at a glance, then a section with pictures for each scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/gallery/gallery.h"
#include "lab/gallery/gallery_pictures.h"

namespace sightline::lab {

/// A scene that was measured.
struct GalleryEntry {
    std::string name;  ///< like "2d:cars"
    int dimension = 2;
    int number = 0;  ///< in field-notes D
    std::string title, lesson, look;
    std::vector<Verdict> verdicts;
    std::vector<GalleryPicture> pictures;
    std::string command;  ///< opens it in the viewer
};

struct GalleryCounts {
    std::size_t scenes = 0, expectations = 0, pending = 0, surprises = 0;
};
GalleryCounts count(std::span<const GalleryEntry> entries);

/// "N scenes, M expectations, K pending, 0 surprises".
std::string counts_text(const GalleryCounts& counts);

/// The page; needs no other file, for pictures are embedded. `conditions`: where and with what it was measured.
std::string gallery_page(std::span<const GalleryEntry> entries, const std::string& conditions);

}  // namespace sightline::lab
