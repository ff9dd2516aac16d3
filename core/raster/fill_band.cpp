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

/// Draws a triangle into rows of 8 pixels. What it covers and how near it is there is what fill_rows says, bit for bit.
class Avx2Fill {
public:
    [[gnu::target("avx2")]] Avx2Fill(const BandPixels& pixels, const FixedTriangle& triangle)
        : pixels_(pixels), plane_(triangle), id_(_mm256_set1_epi32(static_cast<std::int32_t>(triangle.id))) {}

    /// Of the 8 pixels from column x on those in the mask; whether one is seen.
    [[gnu::target("avx2"), gnu::always_inline]] inline bool put(const NearnessPlane::Row& row, std::int32_t first,
                                                                std::int32_t x, std::int32_t y, __m256i mask) const {
        const double i = x - first;
        const __m256d low = _mm256_add_pd(_mm256_set1_pd(i), _mm256_setr_pd(0, 1, 2, 3)),
                      high = _mm256_add_pd(_mm256_set1_pd(i), _mm256_setr_pd(4, 5, 6, 7));
        const __m256 here = _mm256_set_m128(_mm256_cvtpd_ps(at(row, high)), _mm256_cvtpd_ps(at(row, low)));
        const std::size_t place = pixels_.index(x, y);
        float* const nearness = pixels_.nearness + place;
        auto* const ids = reinterpret_cast<__m256i*>(pixels_.ids + place);
        auto* const masked_ids = reinterpret_cast<int*>(pixels_.ids + place);
        // Past the row's end the next row may be another thread's.
        const bool in_row = x + 8 <= pixels_.size.width;
        const __m256 there = in_row ? _mm256_loadu_ps(nearness) : _mm256_maskload_ps(nearness, mask);
        const __m256i owner = in_row ? _mm256_loadu_si256(ids) : _mm256_maskload_epi32(masked_ids, mask);
        const __m256i nearer = _mm256_castps_si256(_mm256_cmp_ps(here, there, _CMP_GT_OQ)),
                      equal = _mm256_castps_si256(_mm256_cmp_ps(here, there, _CMP_EQ_OQ));
        const __m256i sign = _mm256_set1_epi32(std::numeric_limits<std::int32_t>::min());
        const __m256i lower = _mm256_cmpgt_epi32(_mm256_xor_si256(owner, sign), _mm256_xor_si256(id_, sign));
        const __m256i wins = _mm256_and_si256(mask, _mm256_or_si256(nearer, _mm256_and_si256(equal, lower)));
        if (_mm256_testz_si256(wins, wins)) return false;
        if (in_row) {
            _mm256_storeu_ps(nearness, _mm256_blendv_ps(there, here, _mm256_castsi256_ps(wins)));
            _mm256_storeu_si256(ids, _mm256_blendv_epi8(owner, id_, wins));
        } else {
            _mm256_maskstore_ps(nearness, wins, here);
            _mm256_maskstore_epi32(masked_ids, wins, id_);
        }
        return true;
    }

    /// Lanes [0, count).
    [[gnu::target("avx2"), gnu::always_inline]] static inline __m256i first_lanes(std::int32_t count) {
        return _mm256_cmpgt_epi32(_mm256_set1_epi32(count), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    }

    [[gnu::target("avx2")]] bool rows(const FixedTriangle& triangle) const {
        const CoveredRows covered(triangle, pixels_.size);
        const std::int32_t end_row = std::min(covered.end_row, pixels_.end_row);
        bool won = false;
        for (std::int32_t begin = std::max(covered.first_row, pixels_.first_row); begin < end_row;
             begin += CoveredRows::rows_at_once) {
            CoveredRows::Columns first, end;
            covered.spans(begin, first, end);
            for (std::int32_t y = begin; y < std::min(end_row, begin + CoveredRows::rows_at_once); ++y) {
                const std::int32_t from = first[static_cast<std::size_t>(y - begin)],
                                   to = end[static_cast<std::size_t>(y - begin)];
                if (to <= from) continue;
                const NearnessPlane::Row row = plane_.row(y, from);
                for (std::int32_t x = from; x < to; x += 8) won |= put(row, from, x, y, first_lanes(to - x));
            }
        }
        return won;
    }

    /// So small that its edge functions stay far below 2^31, and its pixels lie in 8 columns.
    static bool is_small(const FixedTriangle& t, const PixelBox& box) {
        constexpr std::int32_t most_places = 1 << 12;
        const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
        const auto [top, bottom] = std::minmax({t.y[0], t.y[1], t.y[2]});
        return box.right - box.left <= 8 && right - left <= most_places && bottom - top <= most_places;
    }

    /// By edge functions in whole numbers of 32 bits.
    [[gnu::target("avx2")]] bool small(const FixedTriangle& t, const PixelBox& box) const {
        const std::int32_t first_row = std::max(box.top, pixels_.first_row),
                           end_row = std::min(box.bottom, pixels_.end_row);
        const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7), in_box = first_lanes(box.right - box.left);
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
        bool won = false;
        for (std::int32_t y = first_row; y < end_row; ++y) {
            const __m256i outside = _mm256_or_si256(_mm256_or_si256(edges[0], edges[1]), edges[2]);
            for (int k = 0; k < 3; ++k) edges[k] = _mm256_add_epi32(edges[k], per_row[k]);
            const __m256i covered = _mm256_andnot_si256(_mm256_srai_epi32(outside, 31), in_box);
            if (_mm256_testz_si256(covered, covered)) continue;
            won |= put(plane_.row(y, box.left), box.left, box.left, y, covered);
        }
        return won;
    }

private:
    /// NearnessPlane::Row::at, four places at a time.
    [[gnu::target("avx2"), gnu::always_inline]] static inline __m256d at(const NearnessPlane::Row& row, __m256d i) {
        const __m256d one = _mm256_add_pd(_mm256_set1_pd(row.weight1), _mm256_mul_pd(_mm256_set1_pd(row.step1), i));
        const __m256d two = _mm256_add_pd(_mm256_set1_pd(row.weight2), _mm256_mul_pd(_mm256_set1_pd(row.step2), i));
        return _mm256_add_pd(_mm256_set1_pd(row.far), _mm256_add_pd(_mm256_mul_pd(one, _mm256_set1_pd(row.rise1)),
                                                                    _mm256_mul_pd(two, _mm256_set1_pd(row.rise2))));
    }

    const BandPixels& pixels_;
    NearnessPlane plane_;
    __m256i id_;
};

[[gnu::target("avx2")]] void fill_with_avx2(const BandPixels& pixels, std::span<const FixedTriangle> triangles,
                                            std::span<const std::uint32_t> which, std::uint8_t* won) {
    for (const std::uint32_t index : which) {
        const FixedTriangle& triangle = triangles[index];
        const PixelBox box(triangle, pixels.size);
        const Avx2Fill fill(pixels, triangle);
        const bool seen = Avx2Fill::is_small(triangle, box) ? fill.small(triangle, box) : fill.rows(triangle);
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
