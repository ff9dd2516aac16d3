// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/tri.h"

#include "core/base/number.h"

namespace sightline {

namespace {

/// How large what a cell refers to looks to the eye; it need not be exact.
template <int D>
class ApparentSize;

template <>
class ApparentSize<2> {
public:
    explicit ApparentSize(const Problem<2>& problem) : problem_(&problem) {}
    float of(std::uint32_t primitive) const {
        const Primitive<2>& segment = problem_->primitives()[primitive];
        const Vec<2> along = segment[1] - segment[0], away = (segment[0] + segment[1]) * 0.5 - problem_->view.eye;
        return static_cast<float>(std::abs(cross(along, away)) / glm::dot(away, away));
    }

private:
    const Problem<2>* problem_;
};

template <>
class ApparentSize<3> {
public:
    explicit ApparentSize(const Problem<3>& problem) {
        const CellTriangles& triangles = triangles_of(*problem.cells, *problem.scene);
        const Vec<3> eye = problem.view.eye - triangles.origin();
        eye_ = {static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z)};
    }
    float of(const CellTriangle& t) const {
        const float x = eye_[0] - t.centroid[0], y = eye_[1] - t.centroid[1], z = eye_[2] - t.centroid[2];
        const float squared = x * x + y * y + z * z, along = t.area[0] * x + t.area[1] * y + t.area[2] * z;
        return std::sqrt(std::abs(along) / (squared * std::sqrt(squared)));
    }

private:
    std::array<float, 3> eye_;
};

}  // namespace

/// What the view does not show for sure never waits.
template <int D>
void Tri<D>::add_waiting(const Problem<D>& problem, const CellContents<D>& contents, std::uint32_t cell,
                         double key) const {
    const CellComplex<D>& cells = *problem.cells;
    const std::uint32_t begin = cells.cell_primitive_begin[cell], count = cells.count(cell);
    if (count == 0) return;
    const auto lit = static_cast<float>(std::max(transmittance(problem, cell, key), least_transmittance));
    const ApparentSize<D> size(problem);
    for (std::uint32_t place = begin; place < begin + count; ++place) {
        const auto& held = contents.held_at(cells, place);
        if (contents.may_show(held)) waiting.add(waiting_key(size.of(held), lit), place);
    }
}

template <int D>
KeyExplanation Tri<D>::explain(const Problem<D>& problem, const Marks& marks, std::uint32_t a, double,
                               const HalfFacet& half, int digits) const {
    const LightTerms t = terms(problem, marks, a, half);
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
