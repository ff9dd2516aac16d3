// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/light.h"

#include <algorithm>
#include <cmath>

#include "core/methods/cells/facet_geometry.h"

namespace sightline {

namespace {

/// As long as the facet's area, on the side that facet_geometry says.
Vec<2> area_vector(const CellComplex<2>&, const HalfFacet&, const FacetGeometry<2>& facet) { return facet.normal; }
Vec<3> area_vector(const CellComplex<3>& cells, const HalfFacet& half, const FacetGeometry<3>& facet) {
    const auto polygon = cells.points_of_facet(half.facet());
    Vec<3> twice(0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        twice += glm::cross(cells.points[polygon[i]] - cells.points[polygon[0]],
                            cells.points[polygon[i + 1]] - cells.points[polygon[0]]);
    return (glm::dot(twice, facet.normal) < 0 ? -0.5 : 0.5) * twice;
}

/// In [size / 2, size], a power of 2, so that dividing by it rounds nothing.
double power_below(double size) {
    if (!(size > 0) || !std::isfinite(size)) return 1;
    int exponent;
    std::frexp(size, &exponent);
    return std::ldexp(1.0, exponent - 1);
}

/// Those that no more than a tenth exceeds; 1 where there are none.
template <int D>
double usual_size_of(const Scene<D>& scene) {
    if (scene.primitives.empty()) return 1;
    std::vector<double> sizes;
    sizes.reserve(scene.primitives.size());
    for (const Primitive<D>& primitive : scene.primitives) sizes.push_back(primitive_size(primitive));
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>((sizes.size() - 1) * 9 / 10);
    std::nth_element(sizes.begin(), at, sizes.end());
    return *at > 0 ? *at : 1;
}

}  // namespace

double primitive_size(const Primitive<2>& segment) { return glm::length(segment[1] - segment[0]); }
double primitive_size(const Primitive<3>& triangle) {
    return std::sqrt(0.5 * glm::length(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0])));
}

template <int D>
CellLight<D>::CellLight(const Scene<D>& scene, const CellComplex<D>& cells, int threads)
    : opacity(scene, cells, threads), usual_size(usual_size_of(scene)) {
    centres.reserve(cells.cell_count());
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) centres.push_back(cells.centre(cell));
    Box<D> around;
    for (const Vec<D>& point : cells.points) around.add(point);
    if (around.empty()) return;
    origin = around.centre();
    unit = power_below(around.longest_side());
    facets.resize(cells.half_facets.size());
    std::size_t i = 0;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (const HalfFacet& half : cells.facets_of(cell)) {
            LitFacet<D>& facet = facets[i++];
            if (cells.is_contact(half.facet())) continue;
            const FacetGeometry<D> geometry = facet_geometry(cells, half);
            const Vec<D> centroid = (geometry.centroid - origin) / unit, area = area_vector(cells, half, geometry);
            for (int axis = 0; axis < D; ++axis) {
                facet.centroid[static_cast<std::size_t>(axis)] = static_cast<float>(centroid[axis]);
                facet.out[static_cast<std::size_t>(axis)] =
                    static_cast<float>(D == 2 ? area[axis] / unit : area[axis] / unit / unit);
            }
        }
}

template <int D>
std::shared_ptr<const CellLight<D>> cell_light(const Problem<D>& problem) {
    return problem.cells->made->template of<CellLight<D>>(
        "light", [&] { return CellLight<D>(*problem.scene, *problem.cells, problem.services.threads); });
}

template struct CellLight<2>;
template struct CellLight<3>;
template std::shared_ptr<const CellLight<2>> cell_light<2>(const Problem<2>&);
template std::shared_ptr<const CellLight<3>> cell_light<3>(const Problem<3>&);

}  // namespace sightline
