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

/// Snaps what the view sees of the primitives, a part of them at a time, on several threads; then calls `draw_band` for
/// each band of rows, on several threads, with all parts. An empty list of primitives stands for all where `all` says
/// so.
using DrawBand = std::function<void(int first_row, int end_row, int band, std::span<const BandedTriangles> parts)>;
void for_bands(const Scene<3>& scene, const View<3>& view, const ImageSize& size, bool all,
               std::span<const std::uint32_t> primitives, const RasterWork& work, const DrawBand& draw_band);

/// The loop over a band that stands behind draw_depth, for the vectors of any x86-64 and for AVX2.
struct BandPixels {
    ImageSize size;
    int first_row = 0, end_row = 0;
    float* nearness = nullptr;  ///< of the whole image
    std::uint32_t* ids = nullptr;
};
void fill_band(const BandPixels& pixels, const BandedTriangles& part, int band);
void fill_band_avx2(const BandPixels& pixels, const BandedTriangles& part, int band);
bool has_avx2();

}  // namespace sightline
