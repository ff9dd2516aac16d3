// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/opacity.h"

#include <algorithm>
#include <cmath>

#include "core/base/workers.h"

namespace sightline {

namespace {

/// Cells that one thread takes at a time.
constexpr std::uint32_t cells_of_part = 64;
constexpr double diagonal_part = 0.57735026918962576451;  // of a unit vector along a diagonal, on each axis

template <int D>
std::vector<Vec<D>> made_directions() {
    std::vector<Vec<D>> all;
    const auto add = [&](Vec<D> d) { all.push_back(d / std::sqrt(glm::dot(d, d))); };
    if constexpr (D == 2) {
        for (int x = -2; x <= 2; ++x)
            for (int y = -2; y <= 2; ++y)
                if (x * x + y * y == 1 || x * x + y * y == 2 || x * x + y * y == 5) add({x, y});
    } else {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (x * x + y * y + z * z == 1 || x * x + y * y + z * z == 3) add({x, y, z});
    }
    return all;
}

/// The part of the segment inside the cell, as shares of its length; empty where none is.
std::pair<double, double> part_inside(const CellComplex<2>& cells, std::uint32_t cell, const Primitive<2>& segment) {
    double begin = 0, end = 1;
    for (const HalfFacet& half : cells.facets_of(cell)) {
        if (cells.is_contact(half.facet())) continue;
        const auto [a, b] = facet_ends(cells, half);
        const double from = cross(b - a, segment[0] - a), to = cross(b - a, segment[1] - a);  // inside: positive
        if (from < 0 && to < 0) return {1, 0};
        if (from < 0) begin = std::max(begin, from / (from - to));
        if (to < 0) end = std::min(end, from / (from - to));
    }
    return {begin, end};
}

}  // namespace

template <int D>
std::span<const Vec<D>> opacity_directions() {
    static const std::vector<Vec<D>> all = made_directions<D>();
    return all;
}

std::size_t nearest_direction(const Vec<2>& to_eye) {
    const auto all = opacity_directions<2>();
    std::size_t nearest = 0;
    double most = glm::dot(all[0], to_eye);
    for (std::size_t i = 1; i < all.size(); ++i)
        if (const double along = glm::dot(all[i], to_eye); along > most) {
            most = along;
            nearest = i;
        }
    return nearest;
}

/// By the numbers that made_directions() gives: an axis where one part is more than all parts along a diagonal.
std::size_t nearest_direction(const Vec<3>& to_eye) {
    static constexpr std::array<std::array<std::size_t, 2>, 3> along{{{2, 11}, {5, 8}, {6, 7}}};
    static constexpr std::array<std::size_t, 8> diagonals{0, 1, 3, 4, 9, 10, 12, 13};
    const Vec<3> size = glm::abs(to_eye);
    const std::size_t axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    if (size[static_cast<int>(axis)] > (size.x + size.y + size.z) * diagonal_part)
        return along[axis][to_eye[static_cast<int>(axis)] > 0];
    return diagonals[std::size_t{to_eye.x > 0} << 2 | std::size_t{to_eye.y > 0} << 1 | std::size_t{to_eye.z > 0}];
}

double covered_share(const Scene<2>& scene, const CellComplex<2>& cells, std::uint32_t cell, const Vec<2>& to_eye) {
    const Vec<2> across{-to_eye.y, to_eye.x};
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::uint32_t corner : cells.corners_of(cell)) {
        const double at = glm::dot(across, cells.points[corner]);
        low = std::min(low, at);
        high = std::max(high, at);
    }
    if (!(low < high)) return 0;
    std::vector<std::pair<double, double>> parts;
    for (const std::uint32_t primitive : cells.primitives_of(cell)) {
        const Primitive<2>& segment = scene.primitives[primitive];
        const auto [begin, end] = part_inside(cells, cell, segment);
        if (!(begin < end)) continue;
        const Vec<2> along = segment[1] - segment[0];
        const double from = glm::dot(across, segment[0] + along * begin),
                     to = glm::dot(across, segment[0] + along * end);
        parts.emplace_back(std::min(from, to), std::max(from, to));
    }
    std::sort(parts.begin(), parts.end());
    double covered = 0, reached = low;
    for (const auto& [from, to] : parts) {
        covered += std::max(0.0, std::min(to, high) - std::max(from, reached));
        reached = std::max(reached, to);
    }
    return std::min(1.0, covered / (high - low));
}

template <int D>
CellOpacity<D>::CellOpacity(const Scene<D>& scene, const CellComplex<D>& cells, int threads) {
    const auto directions = opacity_directions<D>();
    const std::uint32_t count = cells.cell_count();
    shares_.assign(count * directions.size(), 0);
    run_parts(static_cast<int>((count + cells_of_part - 1) / cells_of_part), threads, [&](int part) {
        const std::uint32_t begin = static_cast<std::uint32_t>(part) * cells_of_part;
        for (std::uint32_t cell = begin; cell < std::min(count, begin + cells_of_part); ++cell) {
            if (cells.count(cell) == 0) continue;
            for (std::size_t d = 0; d < directions.size(); ++d)
                shares_[cell * directions.size() + d] =
                    static_cast<std::uint8_t>(covered_share(scene, cells, cell, directions[d]) * 255 + 0.5);
        }
    });
}

template std::span<const Vec<2>> opacity_directions<2>();
template std::span<const Vec<3>> opacity_directions<3>();
template class CellOpacity<2>;
template class CellOpacity<3>;

}  // namespace sightline
