// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/band.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace sightline {

namespace {

/// Whether it is seen at any pixel. Compiled twice, for other vectors: the same sums and products of doubles, so the
/// same bits.
[[gnu::always_inline]] inline bool fill_rows(const BandPixels& pixels, const FixedTriangle& triangle) {
    const CoveredRows rows(triangle, pixels.size);
    const NearnessPlane plane(triangle);
    const std::int32_t end_row = std::min(rows.end_row, pixels.end_row);
    std::uint32_t won = 0;
    for (std::int32_t y = std::max(rows.first_row, pixels.first_row); y < end_row; ++y) {
        std::int32_t first, end;
        rows.span(y, first, end);
        if (end <= first) continue;
        const NearnessPlane::Row row = plane.row(y, first);
        const std::size_t at = pixels.index(first, y);
        float* __restrict const nearness = pixels.nearness + at;
        std::uint32_t* __restrict const ids = pixels.ids + at;
        const std::uint32_t id = triangle.id;
        const int count = end - first;
        std::uint32_t any = 0;
        for (int i = 0; i < count; ++i) {
            const auto here = static_cast<float>(row.at(i));
            const bool wins = (here > nearness[i]) | ((here == nearness[i]) & (id < ids[i]));
            nearness[i] = wins ? here : nearness[i];
            ids[i] = wins ? id : ids[i];
            any |= wins;
        }
        won |= any;
    }
    return won != 0;
}

void fill(const BandPixels& pixels, std::span<const FixedTriangle> triangles, std::span<const std::uint32_t> which,
          std::uint8_t* won) {
    for (const std::uint32_t index : which)
        if (fill_rows(pixels, triangles[index]) && won) won[index] = 1;
}

}  // namespace

#if defined(__x86_64__)

namespace {

/// A triangle whose pixels lie in 8 columns: its edge functions at a row of them at a time, in whole numbers of 32
/// bits. What it covers and how near it is there is what fill_rows says, bit for bit.
class SmallTriangle {
public:
    /// So that edge functions stay far below 2^31.
    static constexpr std::int32_t most_places = 1 << 12;

    static bool fits(const FixedTriangle& t, const PixelBox& box) {
        const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
        const auto [top, bottom] = std::minmax({t.y[0], t.y[1], t.y[2]});
        return box.right - box.left <= 8 && right - left <= most_places && bottom - top <= most_places;
    }

    [[gnu::target("avx2")]] static bool fill(const BandPixels& pixels, const FixedTriangle& t, const PixelBox& box) {
        const std::int32_t first_row = std::max(box.top, pixels.first_row),
                           end_row = std::min(box.bottom, pixels.end_row);
        const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
        const __m256i in_box = _mm256_cmpgt_epi32(_mm256_set1_epi32(box.right - box.left), lanes);
        const std::int32_t px = box.left * subpixels + subpixels / 2, py = first_row * subpixels + subpixels / 2;
        __m256i edges[3], per_row[3];
        for (int k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(k), j = (i + 1) % 3;
            const std::int32_t dx = t.x[j] - t.x[i], dy = t.y[j] - t.y[i];
            const std::int32_t at = dx * (py - t.y[i]) - dy * (px - t.x[i]) - (t.owns_edge(k) ? 0 : 1);
            edges[k] =
                _mm256_add_epi32(_mm256_set1_epi32(at), _mm256_mullo_epi32(lanes, _mm256_set1_epi32(-dy * subpixels)));
            per_row[k] = _mm256_set1_epi32(dx * subpixels);
        }
        const NearnessPlane plane(t);
        const __m256i sign = _mm256_set1_epi32(std::numeric_limits<std::int32_t>::min());
        const __m256i id = _mm256_set1_epi32(static_cast<std::int32_t>(t.id)), id_signed = _mm256_xor_si256(id, sign);
        const __m256d low = _mm256_setr_pd(0, 1, 2, 3), high = _mm256_setr_pd(4, 5, 6, 7);
        int won = 0;
        for (std::int32_t y = first_row; y < end_row; ++y) {
            const __m256i outside = _mm256_or_si256(_mm256_or_si256(edges[0], edges[1]), edges[2]);
            for (int k = 0; k < 3; ++k) edges[k] = _mm256_add_epi32(edges[k], per_row[k]);
            // Its sign bit says it of a lane.
            const __m256i covered = _mm256_andnot_si256(_mm256_srai_epi32(outside, 31), in_box);
            if (_mm256_testz_si256(covered, covered)) continue;
            const NearnessPlane::Row row = plane.row(y, box.left);
            const __m256 here = _mm256_set_m128(_mm256_cvtpd_ps(at(row, high)), _mm256_cvtpd_ps(at(row, low)));
            const std::size_t place = pixels.index(box.left, y);
            float* const nearness = pixels.nearness + place;
            int* const ids = reinterpret_cast<int*>(pixels.ids + place);
            const __m256 there = _mm256_maskload_ps(nearness, covered);
            const __m256i owner = _mm256_maskload_epi32(ids, covered);
            const __m256 nearer = _mm256_cmp_ps(here, there, _CMP_GT_OQ),
                         equal = _mm256_cmp_ps(here, there, _CMP_EQ_OQ);
            const __m256i lower = _mm256_cmpgt_epi32(_mm256_xor_si256(owner, sign), id_signed);
            const __m256i wins = _mm256_and_si256(
                covered,
                _mm256_or_si256(_mm256_castps_si256(nearer), _mm256_and_si256(_mm256_castps_si256(equal), lower)));
            _mm256_maskstore_ps(nearness, wins, here);
            _mm256_maskstore_epi32(ids, wins, id);
            won |= _mm256_movemask_ps(_mm256_castsi256_ps(wins));
        }
        return won != 0;
    }

private:
    /// NearnessPlane::Row::at, four places at a time.
    [[gnu::target("avx2")]] static __m256d at(const NearnessPlane::Row& row, __m256d i) {
        const __m256d one = _mm256_add_pd(_mm256_set1_pd(row.weight1), _mm256_mul_pd(_mm256_set1_pd(row.step1), i));
        const __m256d two = _mm256_add_pd(_mm256_set1_pd(row.weight2), _mm256_mul_pd(_mm256_set1_pd(row.step2), i));
        return _mm256_add_pd(_mm256_set1_pd(row.far), _mm256_add_pd(_mm256_mul_pd(one, _mm256_set1_pd(row.rise1)),
                                                                    _mm256_mul_pd(two, _mm256_set1_pd(row.rise2))));
    }
};

[[gnu::target("avx2")]] void fill_with_avx2(const BandPixels& pixels, std::span<const FixedTriangle> triangles,
                                            std::span<const std::uint32_t> which, std::uint8_t* won) {
    for (const std::uint32_t index : which) {
        const FixedTriangle& triangle = triangles[index];
        const PixelBox box(triangle, pixels.size);
        const bool seen = SmallTriangle::fits(triangle, box) ? SmallTriangle::fill(pixels, triangle, box)
                                                             : fill_rows(pixels, triangle);
        if (seen && won) won[index] = 1;
    }
}

}  // namespace

bool has_avx2() { return __builtin_cpu_supports("avx2"); }

void fill_band(const BandPixels& pixels, std::span<const FixedTriangle> triangles, std::span<const std::uint32_t> which,
               bool best_vectors, std::uint8_t* won) {
    (best_vectors && has_avx2() ? fill_with_avx2 : fill)(pixels, triangles, which, won);
}

#else

bool has_avx2() { return false; }

void fill_band(const BandPixels& pixels, std::span<const FixedTriangle> triangles, std::span<const std::uint32_t> which,
               bool, std::uint8_t* won) {
    fill(pixels, triangles, which, won);
}

#endif

}  // namespace sightline
