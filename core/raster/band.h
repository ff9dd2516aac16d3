// Rows of an image that one worker draws, and the triangles that meet them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/raster/depth_image.h"
#include "core/raster/fixed_triangle.h"

namespace sightline {

/// So many rows that depths and ids of a band stay in a core's own cache: 1024 x 32 pixels are 256 kB.
constexpr int band_rows = 32;

/// Triangles of a part of the primitives, and which of them meet which band.
struct BandedTriangles {
    std::vector<FixedTriangle> triangles;
    std::vector<std::vector<std::uint32_t>> of_band;
};

inline int bands_of(const ImageSize& size) { return (size.height + band_rows - 1) / band_rows; }

/// Fills of_band.
void sort_into_bands(BandedTriangles& part, const ImageSize& size);

/// Snaps what the view sees of the primitives, a part of them at a time, on several threads; then calls `draw_band` for
/// each band of rows, on several threads, with all parts. An empty list of primitives stands for all where `all` says
/// so.
using DrawBand = std::function<void(int first_row, int end_row, int band, std::span<const BandedTriangles> parts)>;
void for_bands(const Scene<3>& scene, const View<3>& view, const ImageSize& size, bool all,
               std::span<const std::uint32_t> primitives, const RasterWork& work, const DrawBand& draw_band);

/// Rows [first_row, end_row) of an image.
struct BandPixels {
    ImageSize size;
    int first_row = 0, end_row = 0;
    float* nearness = nullptr;  ///< of the whole image
    std::uint32_t* ids = nullptr;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
    }
};

/// Draws those of the triangles that `which` names, in that order, for the vectors of any x86-64 or for AVX2 where the
/// machine has it. won[i] is set where triangle i covers a pixel that nothing before it has nearer; nullptr: nobody
/// asks.
void fill_band(const BandPixels& pixels, std::span<const FixedTriangle> triangles, std::span<const std::uint32_t> which,
               bool best_vectors, std::uint8_t* won = nullptr);
bool has_avx2();

}  // namespace sightline
