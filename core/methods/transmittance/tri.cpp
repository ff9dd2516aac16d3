// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/tri.h"

#include "core/base/number.h"

namespace sightline {

namespace {

/// Keys of four that wait, from how large they look to the eye, which need not be exact: 1 / (size · light), with
/// maximise=count of the size its root. What is edge-on comes last, as what no light reaches.
constexpr float least_product = 0x1p-31f;

template <int D>
class WaitingKeys;

template <>
class WaitingKeys<2> {
public:
    WaitingKeys(const Problem<2>& problem, Maximise maximise, float light)
        : problem_(&problem), root_(maximise == Maximise::count), light_(light) {}
    void of_four(const CellContents<2>& contents, std::uint32_t place, std::uint32_t count, float* keys) const {
        for (std::uint32_t i = 0; i < count; ++i) {
            const Primitive<2>& segment = problem_->primitives()[contents.held_at(*problem_->cells, place + i)];
            const Vec<2> along = segment[1] - segment[0], away = (segment[0] + segment[1]) * 0.5 - problem_->view.eye;
            const auto size = static_cast<float>(std::abs(cross(along, away)) / glm::dot(away, away));
            keys[i] = 1 / std::max((root_ ? std::sqrt(size) : size) * light_, least_product);
        }
    }

private:
    const Problem<2>* problem_;
    bool root_;
    float light_;
};

template <>
class WaitingKeys<3> {
public:
    WaitingKeys(const Problem<3>& problem, Maximise maximise, float light)
        : root_(maximise == Maximise::count), light_(light) {
        const CellTriangles& triangles = triangles_of(*problem.cells, *problem.scene);
        const Vec<3> eye = problem.view.eye - triangles.origin();
        eye_ = {static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z)};
        rows_ = triangles.rows().data();
    }
#if defined(__SSE__)
    /// Rows behind the last can be read.
    void of_four(const CellContents<3>&, std::uint32_t place, std::uint32_t, float* keys) const {
        const CellTriangle* const t = rows_ + place;
        __m128 x = _mm_loadu_ps(&t[0].centroid[0]), y = _mm_loadu_ps(&t[1].centroid[0]),
               z = _mm_loadu_ps(&t[2].centroid[0]), radius = _mm_loadu_ps(&t[3].centroid[0]);
        _MM_TRANSPOSE4_PS(x, y, z, radius);
        __m128 a = _mm_loadu_ps(&t[0].area[0]), b = _mm_loadu_ps(&t[1].area[0]), c = _mm_loadu_ps(&t[2].area[0]),
               bits = _mm_loadu_ps(&t[3].area[0]);
        _MM_TRANSPOSE4_PS(a, b, c, bits);
        const auto one = [](float value) { return _mm_set1_ps(value); };
        const auto sum = [](__m128 p, __m128 q, __m128 r) { return _mm_add_ps(_mm_add_ps(p, q), r); };
        x = _mm_sub_ps(one(eye_[0]), x);
        y = _mm_sub_ps(one(eye_[1]), y);
        z = _mm_sub_ps(one(eye_[2]), z);
        const __m128 squared = sum(_mm_mul_ps(x, x), _mm_mul_ps(y, y), _mm_mul_ps(z, z)),
                     along = _mm_andnot_ps(one(-0.0f), sum(_mm_mul_ps(a, x), _mm_mul_ps(b, y), _mm_mul_ps(c, z)));
        __m128 size = _mm_sqrt_ps(_mm_div_ps(along, _mm_mul_ps(squared, _mm_sqrt_ps(squared))));
        if (root_) size = _mm_sqrt_ps(size);
        // The other way round a NaN, of what the eye lies in, would be lost.
        const __m128 product = _mm_max_ps(one(least_product), _mm_mul_ps(size, one(light_)));
        _mm_storeu_ps(keys, _mm_div_ps(one(1), product));
    }
#else
    /// The same, one triangle after the other.
    void of_four(const CellContents<3>&, std::uint32_t place, std::uint32_t count, float* keys) const {
        for (std::uint32_t i = 0; i < count; ++i) {
            const CellTriangle& t = rows_[place + i];
            const float x = eye_[0] - t.centroid[0], y = eye_[1] - t.centroid[1], z = eye_[2] - t.centroid[2];
            const float squared = x * x + y * y + z * z, along = t.area[0] * x + t.area[1] * y + t.area[2] * z;
            const float size = std::sqrt(std::abs(along) / (squared * std::sqrt(squared)));
            keys[i] = 1 / std::max((root_ ? std::sqrt(size) : size) * light_, least_product);
        }
    }
#endif

private:
    const CellTriangle* rows_;
    std::array<float, 3> eye_;
    bool root_;
    float light_;
};

}  // namespace

/// What the view does not show for sure never waits.
template <int D>
void Tri<D>::add_waiting(const Problem<D>& problem, const CellContents<D>& contents, std::uint32_t cell,
                         double key) const {
    if (problem.cells->count(cell) == 0) return;
    const auto lit = static_cast<float>(std::max(transmittance(problem, cell, key), least_transmittance));
    const WaitingKeys<D> keys(problem, maximise_, lit);
    contents.by_fours(*problem.cells, cell, [&](std::uint32_t place, std::uint32_t count, const auto& shown) {
        std::array<float, 4> four;
        keys.of_four(contents, place, count, four.data());
        for (std::uint32_t i = 0; i < count; ++i)
            if (!(shown.no >> i & 1)) waiting.add(four[i], {place + i, (shown.yes >> i & 1) != 0});
    });
}

template <int D>
KeyExplanation Tri<D>::explain(const Problem<D>& problem, const Marks& marks, CellsInView<D>& in_view, std::uint32_t a,
                               const HalfFacet& half, int digits) const {
    const LightTerms t = light_.into(problem, marks, in_view, a, half,
                                     [&](std::uint32_t n, double key) { return transmittance(problem, n, key); });
    const double size = 1 / distance_in_sizes(problem, half.neighbour);
    KeyExplanation e = explain_light(t, digits);
    e.terms.pop_back();
    e.key = key_at(problem, half.neighbour, t.transmittance());
    e.parts.front().text = "T = ";
    e.parts.insert(e.parts.begin() + 1, {{"("}});
    e.parts.back().text = ") = " + short_number(t.transmittance(), digits) + ", key = 1 / (" +
                          short_number(t.transmittance(), digits) + " · " + (maximise_ == Maximise::count ? "√" : "") +
                          short_number(size, digits) + ") = " + short_number(e.key, digits);
    e.tip += "; the key is one over T times " + std::string(maximise_ == Maximise::count ? "the square root of " : "") +
             "what a primitive of usual size would look like there";
    e.terms.push_back({"apparent_size", size, {}});
    e.terms.push_back({"key", e.key, {}});
    return e;
}

template <int D>
void Tri<D>::add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* e, int digits) const {
    const std::size_t heading = lines.size();
    add_light_lines(lines, e, digits);
    lines[heading].text = "key(n, c): how little light n gets, and how small things look there";
    add_term_line(lines, "size = usual size of a primitive / distance of n", e, "apparent_size", digits);
    add_term_line(lines, maximise_ == Maximise::count ? "key = 1 / (T · √size)" : "key = 1 / (T · size)", e, "key",
                  digits);
}

template class Tri<2>;
template class Tri<3>;

}  // namespace sightline
