// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/cell_complex.h"

#include <algorithm>
#include <utility>

#include "core/base/workers.h"
#include "core/space/builders.h"

namespace sightline {

namespace {

template <typename T>
std::size_t bytes(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}

double distance_to_segment(const Vec<2>& a, const Vec<2>& b, const Vec<2>& p) {
    const Vec<2> ab = b - a;
    const double length2 = glm::dot(ab, ab);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0;
    const Vec<2> d = p - (a + ab * t);
    return std::sqrt(glm::dot(d, d));
}

double distance_to_polygon(const CellComplex<2>& cells, std::span<const std::uint32_t> facet, const Vec<2>& p) {
    return distance_to_segment(cells.points[facet[0]], cells.points[facet[1]], p);
}

double distance_to_polygon(const CellComplex<3>& cells, std::span<const std::uint32_t> facet, const Vec<3>& p) {
    const auto corner = [&](std::size_t i) { return cells.points[facet[i % facet.size()]]; };
    const Vec<3> normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    bool above_inside = true;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < facet.size(); ++i) {
        const Vec<3> a = corner(i), ab = corner(i + 1) - a;
        above_inside &= glm::dot(glm::cross(normal, ab), p - a) >= 0;
        const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
        const Vec<3> d = p - (a + ab * t);
        nearest = std::min(nearest, std::sqrt(glm::dot(d, d)));
    }
    return above_inside ? std::abs(glm::dot(p - corner(0), normal)) / std::sqrt(glm::dot(normal, normal)) : nearest;
}

/// Among the cells that hold p, which are linked through facets on whose line p lies, the one of lowest index.
template <int D>
std::uint32_t lowest_holding(const CellComplex<D>& cells, std::uint32_t cell, const Vec<D>& p) {
    std::vector<std::uint32_t> holding{cell};
    for (std::size_t i = 0; i < holding.size(); ++i)
        for (const HalfFacet& half : cells.facets_of(holding[i])) {
            if (half.neighbour == none || facet_side(cells, half, p) != 0) continue;
            if (std::find(holding.begin(), holding.end(), half.neighbour) != holding.end()) continue;
            const auto facets = cells.facets_of(half.neighbour);
            if (std::all_of(facets.begin(), facets.end(),
                            [&](const HalfFacet& other) { return facet_side(cells, other, p) >= 0; }))
                holding.push_back(half.neighbour);
        }
    return *std::min_element(holding.begin(), holding.end());
}

}  // namespace

template <int D>
std::size_t CellComplex<D>::memory_bytes() const {
    return bytes(points) + bytes(cell_points) + bytes(half_facets) + bytes(cell_facet_begin) + bytes(facet_points) +
           bytes(border_cells) + bytes(tree.nodes) + bytes(tree.leaves) + bytes(leaf_cell);
}

template <int D>
std::size_t CellComplex<D>::reference_memory_bytes() const {
    return bytes(cell_primitive_begin) + bytes(cell_primitives);
}

template <int D>
std::uint32_t any_holding(const CellComplex<D>& cells, const Vec<D>& p, std::uint32_t near) {
    if (cells.cell_count() == 0) return none;
    if (cells.has_boxes() && !cells.tree.root_box().contains(p)) return none;
    if (cells.kind == Tessellation::kd) near = none;  // a walk among its leaves might go round in circles
    std::uint32_t cell = near != none ? near : cells.leaf_cell[cells.tree.leaf_at(p)];
    // Visibility walk: on a Delaunay triangulation it comes to no cell twice, in a tree it starts at its end.
    for (std::uint32_t step = 0; step < cells.cell_count(); ++step) {
        const auto facets = cells.facets_of(cell);
        const auto beyond = std::find_if(facets.begin(), facets.end(),
                                         [&](const HalfFacet& half) { return facet_side(cells, half, p) < 0; });
        if (beyond == facets.end()) return cell;
        if (beyond->neighbour == none) return none;
        cell = beyond->neighbour;
    }
    return none;
}

template <int D>
std::uint32_t locate(const CellComplex<D>& cells, const Vec<D>& p, std::uint32_t near) {
    const std::uint32_t cell = any_holding(cells, p, near);
    return cell == none ? none : lowest_holding(cells, cell, p);
}

template <int D>
double distance_to_facet(const CellComplex<D>& cells, std::uint32_t facet, const Vec<D>& p) {
    return distance_to_polygon(cells, cells.points_of_facet(facet), p);
}

template <int D>
void set_cell_primitives(CellComplex<D>& cells, std::span<const std::vector<CellPrimitive>> parts, int threads) {
    std::size_t count = 0;
    for (const auto& part : parts) count += part.size();
    // Runs of parts are counted and written side by side, each to places of its own.
    const std::size_t cell_count = cells.cell_count();
    const std::size_t runs = count > 2 * cell_count ? std::min<std::size_t>(parts.size(), 4) : 1;
    std::vector<std::vector<std::uint32_t>> places(runs, std::vector<std::uint32_t>(cell_count));
    const auto for_each_run = [&](auto use) {
        run_parts(static_cast<int>(runs), threads, [&](int index) {
            const auto run = static_cast<std::size_t>(index);
            for (std::size_t part = run * parts.size() / runs; part < (run + 1) * parts.size() / runs; ++part)
                for (const CellPrimitive& pair : parts[part]) use(pair, places[run][pair.cell]);
        });
    };
    for_each_run([](const CellPrimitive&, std::uint32_t& counted) { ++counted; });
    std::vector<std::uint32_t>& begin = cells.cell_primitive_begin;
    begin.assign(cell_count + 1, 0);
    for (std::size_t cell = 0; cell < cell_count; ++cell) {
        std::uint32_t next = begin[cell];
        for (auto& of_run : places) next += std::exchange(of_run[cell], next);
        begin[cell + 1] = next;
    }
    cells.cell_primitives.resize(count);
    for_each_run(
        [&](const CellPrimitive& pair, std::uint32_t& place) { cells.cell_primitives[place++] = pair.primitive; });
    cells.copies = std::make_shared<const typename CellComplex<D>::Copies>();
    set_solidity_scales(cells);
}

template <int D>
void set_solidity_scales(CellComplex<D>& cells) {
    cells.rho_max = cells.rho_p95 = 0;
    std::vector<std::uint32_t> counts;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        if (cells.count(cell) > 0) counts.push_back(cells.count(cell));
    if (counts.empty()) return;
    const auto p95 = counts.begin() + static_cast<std::ptrdiff_t>((counts.size() - 1) * 95 / 100);
    std::nth_element(counts.begin(), p95, counts.end());
    cells.rho_p95 = *p95;
    cells.rho_max = *std::max_element(counts.begin(), counts.end());
}

template <int D>
void set_border_cells(CellComplex<D>& cells) {
    cells.border_cells.clear();
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const auto facets = cells.facets_of(cell);
        if (std::any_of(facets.begin(), facets.end(), [](const HalfFacet& half) { return half.neighbour == none; }))
            cells.border_cells.push_back(cell);
    }
}

#define SIGHTLINE_INSTANTIATE(D)                                                                             \
    template struct CellComplex<D>;                                                                          \
    template std::uint32_t locate<D>(const CellComplex<D>&, const Vec<D>&, std::uint32_t);                   \
    template std::uint32_t any_holding<D>(const CellComplex<D>&, const Vec<D>&, std::uint32_t);              \
    template double distance_to_facet<D>(const CellComplex<D>&, std::uint32_t, const Vec<D>&);               \
    template void set_cell_primitives<D>(CellComplex<D>&, std::span<const std::vector<CellPrimitive>>, int); \
    template void set_solidity_scales<D>(CellComplex<D>&);                                                   \
    template void set_border_cells<D>(CellComplex<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
