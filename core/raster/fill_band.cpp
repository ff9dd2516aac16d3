// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/band.h"

namespace sightline {

namespace {

/// Compiled twice, for other vectors: the same sums and products of doubles, so the same bits.
[[gnu::always_inline]] inline void fill(const BandPixels& pixels, const BandedTriangles& part, int band) {
    for (const std::uint32_t index : part.of_band[static_cast<std::size_t>(band)]) {
        const FixedTriangle& triangle = part.triangles[index];
        const CoveredRows rows(triangle, pixels.size);
        const NearnessPlane plane(triangle);
        const std::int32_t end_row = std::min(rows.end_row, pixels.end_row);
        for (std::int32_t y = std::max(rows.first_row, pixels.first_row); y < end_row; ++y) {
            std::int32_t first, end;
            rows.span(y, first, end);
            if (end <= first) continue;
            const NearnessPlane::Row row = plane.row(y, first);
            const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.size.width) +
                                   static_cast<std::size_t>(first);
            float* __restrict const nearness = pixels.nearness + at;
            std::uint32_t* __restrict const ids = pixels.ids + at;
            const std::uint32_t id = triangle.id;
            const int count = end - first;
            for (int i = 0; i < count; ++i) {
                const auto here = static_cast<float>(row.at(i));
                const bool wins = (here > nearness[i]) | ((here == nearness[i]) & (id < ids[i]));
                nearness[i] = wins ? here : nearness[i];
                ids[i] = wins ? id : ids[i];
            }
        }
    }
}

}  // namespace

void fill_band(const BandPixels& pixels, const BandedTriangles& part, int band) { fill(pixels, part, band); }

#if defined(__x86_64__)
[[gnu::target("avx2")]] void fill_band_avx2(const BandPixels& pixels, const BandedTriangles& part, int band) {
    fill(pixels, part, band);
}
bool has_avx2() { return __builtin_cpu_supports("avx2"); }
#else
void fill_band_avx2(const BandPixels& pixels, const BandedTriangles& part, int band) { fill(pixels, part, band); }
bool has_avx2() { return false; }
#endif

}  // namespace sightline
