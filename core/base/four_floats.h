// Four floats at once: in one register where the machine has such, and the same to the last bit where it has none.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#else
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#endif

namespace sightline {

#if defined(__SSE__)

struct FourFloats {
    __m128 lanes;

    FourFloats(__m128 given) : lanes(given) {}
    FourFloats(float all) : lanes(_mm_set1_ps(all)) {}

    void store(float* to) const { _mm_storeu_ps(to, lanes); }
    int signs() const { return _mm_movemask_ps(lanes); }  ///< bit i: the sign bit of the i-th, also of a NaN

    friend FourFloats operator+(FourFloats a, FourFloats b) { return _mm_add_ps(a.lanes, b.lanes); }
    friend FourFloats operator-(FourFloats a, FourFloats b) { return _mm_sub_ps(a.lanes, b.lanes); }
    friend FourFloats operator*(FourFloats a, FourFloats b) { return _mm_mul_ps(a.lanes, b.lanes); }
    friend FourFloats operator/(FourFloats a, FourFloats b) { return _mm_div_ps(a.lanes, b.lanes); }
    friend FourFloats operator-(FourFloats a) { return _mm_xor_ps(a.lanes, _mm_set1_ps(-0.0f)); }
    /// Bit i: whether the i-th is less.
    friend int operator<(FourFloats a, FourFloats b) { return _mm_movemask_ps(_mm_cmplt_ps(a.lanes, b.lanes)); }
    friend int operator>(FourFloats a, FourFloats b) { return b < a; }
};

inline FourFloats abs(FourFloats a) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), a.lanes); }
inline FourFloats sqrt(FourFloats a) { return _mm_sqrt_ps(a.lanes); }
// Of a NaN and a number: b.
inline FourFloats lesser(FourFloats a, FourFloats b) { return _mm_min_ps(a.lanes, b.lanes); }
inline FourFloats greater(FourFloats a, FourFloats b) { return _mm_max_ps(a.lanes, b.lanes); }

/// Four rows of 16 bytes, as columns.
struct FourColumns {
    FourFloats x, y, z, w;

    FourColumns(const void* a, const void* b, const void* c, const void* d)
        : x(row(a)), y(row(b)), z(row(c)), w(row(d)) {
        _MM_TRANSPOSE4_PS(x.lanes, y.lanes, z.lanes, w.lanes);
    }

private:
    static FourFloats row(const void* at) { return _mm_loadu_ps(static_cast<const float*>(at)); }
};

#else

struct FourFloats {
    std::array<float, 4> lanes;

    FourFloats(std::array<float, 4> given) : lanes(given) {}
    FourFloats(float all) : lanes{all, all, all, all} {}

    template <typename Of>
    static FourFloats each(Of of) {
        return std::array<float, 4>{of(0), of(1), of(2), of(3)};
    }
    template <typename Of>
    static int bits(Of of) {
        return int{of(0)} | int{of(1)} << 1 | int{of(2)} << 2 | int{of(3)} << 3;
    }

    float operator[](std::size_t i) const { return lanes[i]; }
    void store(float* to) const {
        for (std::size_t i = 0; i < 4; ++i) to[i] = lanes[i];
    }
    int signs() const {
        return bits([this](std::size_t i) { return std::signbit(lanes[i]); });
    }

    friend FourFloats operator+(FourFloats a, FourFloats b) {
        return each([&](std::size_t i) { return a[i] + b[i]; });
    }
    friend FourFloats operator-(FourFloats a, FourFloats b) {
        return each([&](std::size_t i) { return a[i] - b[i]; });
    }
    friend FourFloats operator*(FourFloats a, FourFloats b) {
        return each([&](std::size_t i) { return a[i] * b[i]; });
    }
    friend FourFloats operator/(FourFloats a, FourFloats b) {
        return each([&](std::size_t i) { return a[i] / b[i]; });
    }
    friend FourFloats operator-(FourFloats a) {
        return each([&](std::size_t i) { return -a[i]; });
    }
    /// Bit i: whether the i-th is less.
    friend int operator<(FourFloats a, FourFloats b) {
        return bits([&](std::size_t i) { return a[i] < b[i]; });
    }
    friend int operator>(FourFloats a, FourFloats b) { return b < a; }
};

inline FourFloats abs(FourFloats a) {
    return FourFloats::each([&](std::size_t i) { return std::abs(a[i]); });
}
inline FourFloats sqrt(FourFloats a) {
    return FourFloats::each([&](std::size_t i) { return std::sqrt(a[i]); });
}
// Of a NaN and a number: b.
inline FourFloats lesser(FourFloats a, FourFloats b) {
    return FourFloats::each([&](std::size_t i) { return a[i] < b[i] ? a[i] : b[i]; });
}
inline FourFloats greater(FourFloats a, FourFloats b) {
    return FourFloats::each([&](std::size_t i) { return a[i] > b[i] ? a[i] : b[i]; });
}

/// Four rows of 16 bytes, as columns.
struct FourColumns {
    FourFloats x, y, z, w;

    FourColumns(const void* a, const void* b, const void* c, const void* d)
        : FourColumns(std::array<Row, 4>{row(a), row(b), row(c), row(d)}) {}

private:
    using Row = std::array<float, 4>;
    explicit FourColumns(const std::array<Row, 4>& rows)
        : x(column(rows, 0)), y(column(rows, 1)), z(column(rows, 2)), w(column(rows, 3)) {}
    static Row row(const void* at) {
        Row found;
        std::memcpy(&found, at, sizeof found);
        return found;
    }
    static FourFloats column(const std::array<Row, 4>& rows, std::size_t i) {
        return Row{rows[0][i], rows[1][i], rows[2][i], rows[3][i]};
    }
};

#endif

}  // namespace sightline
