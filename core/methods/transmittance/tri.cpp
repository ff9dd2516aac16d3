// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/tri.h"

#include "core/base/four_floats.h"
#include "core/base/number.h"

namespace sightline {

namespace {

/// Keys of four that wait, from the light at their centroids and from how large they look to the eye, neither of which
/// need be exact: 1 / (size · light), with maximise=count of the size its root. What is edge-on comes last, as what no
/// light reaches.
constexpr float least_product = 0x1p-31f;

template <int D>
class WaitingKeys;

template <>
class WaitingKeys<2> {
public:
    WaitingKeys(const Problem<2>& problem, Maximise maximise, const LightInside<2>& light)
        : problem_(&problem), light_(light), root_(maximise == Maximise::count) {}

    void of_four(const CellContents<2>& contents, std::uint32_t place, std::uint32_t count, float* keys) const {
        for (std::uint32_t i = 0; i < count; ++i) {
            const Primitive<2>& segment = problem_->primitives()[contents.held_at(*problem_->cells, place + i)];
            const Vec<2> middle = (segment[0] + segment[1]) * 0.5, away = middle - problem_->view.eye;
            const auto size = static_cast<float>(std::abs(cross(segment[1] - segment[0], away)) / glm::dot(away, away));
            keys[i] = 1 / std::max((root_ ? std::sqrt(size) : size) * light_at(middle), least_product);
        }
    }

private:
    float light_at(const Vec<2>& p) const {
        const auto along = [&](std::size_t axis) {
            const double at = (p[static_cast<int>(axis)] - double{light_.origin[axis]}) * double{light_.scale[axis]};
            return std::clamp(static_cast<float>(at), light_.nearest, light_.farthest);
        };
        const float x = along(0), y = along(1);
        const float there = light_.terms[0] + light_.terms[1] * x + (light_.terms[2] + light_.terms[3] * x) * y;
        return std::max(std::clamp(there, light_.least, light_.most), least_light);
    }

    const Problem<2>* problem_;
    LightInside<2> light_;
    bool root_;
};

template <>
class WaitingKeys<3> {
public:
    WaitingKeys(const Problem<3>& problem, Maximise maximise, const LightInside<3>& light)
        : light_(light), root_(maximise == Maximise::count) {
        const CellTriangles& triangles = triangles_of(*problem.cells, *problem.scene);
        const Vec<3> eye = problem.view.eye - triangles.origin();
        eye_ = {static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z)};
    }

    /// Rows behind the last can be read.
    void of_four(const CellContents<3>& contents, std::uint32_t place, std::uint32_t, float* keys) const {
        const FourTriangles four(contents.from(place));
        const FourFloats x = eye_[0] - four.at.x, y = eye_[1] - four.at.y, z = eye_[2] - four.at.z;
        const FourFloats squared = x * x + y * y + z * z,
                         along = abs(four.area.x * x + four.area.y * y + four.area.z * z);
        FourFloats size = sqrt(along / (squared * sqrt(squared)));
        if (root_) size = sqrt(size);
        // The other way round a NaN, of what the eye lies in, would be lost.
        (1 / greater(least_product, size * light_at(four.at))).store(keys);
    }

private:
    FourFloats light_at(const FourColumns& p) const {
        const auto along = [&](const FourFloats& at, std::size_t axis) {
            return lesser(greater((at - light_.origin[axis]) * light_.scale[axis], light_.nearest), light_.farthest);
        };
        const FourFloats x = along(p.x, 0), y = along(p.y, 1), z = along(p.z, 2);
        const auto& t = light_.terms;
        const FourFloats low = t[0] + t[1] * x + (t[2] + t[3] * x) * y, rise = t[4] + t[5] * x + (t[6] + t[7] * x) * y;
        return greater(lesser(greater(low + rise * z, light_.least), light_.most), least_light);
    }

    LightInside<3> light_;
    std::array<float, 3> eye_;
    bool root_;
};

/// What places in a cell are relative to, as primitives are.
Vec<2> origin_of(const Problem<2>&) { return Vec<2>(0); }
Vec<3> origin_of(const Problem<3>& problem) { return triangles_of(*problem.cells, *problem.scene).origin(); }

}  // namespace

/// What the view does not show for sure never waits.
template <int D>
void Tri<D>::add_waiting(const Problem<D>& problem, const CellContents<D>& contents, std::uint32_t cell,
                         double key) const {
    if (problem.cells->count(cell) == 0) return;
    const WaitingKeys<D> keys(problem, maximise_,
                              corners_
                                  ? corners_->inside(problem, cell, origin_of(problem))
                                  : LightInside<D>::everywhere(static_cast<float>(transmittance(problem, cell, key))));
    contents.by_fours(*problem.cells, cell, [&](std::uint32_t place, std::uint32_t count, const auto& shown) {
        const unsigned all = (1u << count) - 1;
        if ((static_cast<unsigned>(shown.no) & all) == all) return;
        std::array<float, 4> four;
        keys.of_four(contents, place, count, four.data());
        for (std::uint32_t i = 0; i < count; ++i)
            if (!(shown.no >> i & 1)) waiting.add(four[i], {place + i, (shown.yes >> i & 1) != 0});
    });
}

template <int D>
KeyExplanation Tri<D>::explain(const Problem<D>& problem, const Marks& marks, CellsInView<D>& in_view, std::uint32_t a,
                               const HalfFacet& half, int digits) const {
    const auto number = [&](double v) { return short_number(v, digits); };
    const double size = 1 / distance_in_sizes(problem, half.neighbour);
    const bool by_root = maximise_ == Maximise::count;
    KeyExplanation e;
    double light = 0;
    std::string missing;  // what makes it dark
    if (corners_) {
        const CornerTerms t = corner_terms(*corners_, problem, half.neighbour);
        light = t.mean;
        e.parts = {{"T = mean of "}, {listed(t, digits), KeyAbout::own, "light at its corners"}, {" = "}};
        e.tip = "the light that comes to the corners of the cell through what lies before them";
        add_terms(e.terms, t);
        missing = "the light that its corners lack: T is " + short_number(light) + what_darkens(t);
    } else {
        const LightTerms t = light_.into(problem, marks, in_view, a, half,
                                         [&](std::uint32_t n, double key) { return transmittance(problem, n, key); });
        light = t.transmittance();
        e = explain_light(t, digits);
        e.terms.pop_back();
        e.parts.front().text = "T = ";
        e.parts.back().text = " = ";
        missing = e.weightiest;
    }
    const bool dark = light < double{least_light};
    const std::string taken = number(std::max(light, double{least_light}));
    e.key = key_at(problem, half.neighbour, light);
    e.parts.back().text +=
        number(light) + (dark ? ", at least " + taken : "") + "; key = 1 / (" + taken + " · " + (by_root ? "√" : "");
    e.parts.push_back({number(size), KeyAbout::star, "size"});
    e.parts.push_back({") = " + number(e.key)});
    e.tip += "; the key is one over T times " + std::string(by_root ? "the square root of " : "") +
             "what a primitive of usual size would look like there";
    e.weightiest = 1 / std::max(light, double{least_light}) >= of_ratio(1 / size)
                       ? missing
                       : "how small things look there: a primitive of usual size has " + number(size);
    e.terms.push_back({"apparent_size", size, {}});
    e.terms.push_back({"key", e.key, {}});
    return e;
}

template <int D>
void Tri<D>::add_key_lines(std::vector<CodeLine>& lines, const KeyExplanation* e, int digits) const {
    lines.push_back({"key(n, c): how little light n gets, and how small things look there", 0, false, {}, {}});
    if (corners_)
        add_corner_lines(lines, e, digits);
    else
        add_light_lines(lines, e, digits);
    add_term_line(lines, "size = usual size of a primitive / distance of n", e, "apparent_size", digits);
    add_term_line(lines,
                  maximise_ == Maximise::count ? "key = 1 / (T · √size), T at least 2^-20"
                                               : "key = 1 / (T · size), T at least 2^-20",
                  e, "key", digits);
}

template class Tri<2>;
template class Tri<3>;

}  // namespace sightline
