// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/key_light.h"

#include <algorithm>

#include "core/methods/cells/facet_geometry.h"

namespace sightline {

namespace {

/// Of the longest side of the cell before: as long as a facet is wide, about.
constexpr double normal_length = 0.5;

template <int D>
LightLine<D> facet_line(const CellComplex<D>& cells, std::uint32_t facet) {
    LightLine<D> line;
    for (const std::uint32_t point : cells.points_of_facet(facet)) line.points.push_back(cells.points[point]);
    line.closed = D == 3;
    return line;
}

template <int D>
std::vector<LightLine<D>> cell_lines(const CellComplex<D>& cells, std::uint32_t cell) {
    std::vector<LightLine<D>> lines;
    for (const HalfFacet& half : cells.facets_of(cell))
        if (!cells.is_contact(half.facet())) lines.push_back(facet_line(cells, half.facet()));
    return lines;
}

}  // namespace

KeyLight light_of(const Considered& update, KeyAbout about) {
    return {about, id_of(update.from, Kind::cell), update.via.id, id_of(update.item, Kind::cell)};
}

template <int D>
std::vector<LightLine<D>> key_light(const Session<D>& session, const KeyLight& light) {
    const CellComplex<D>& cells = session.cells();
    if (!light || light.from >= cells.cell_count() || light.cell >= cells.cell_count()) return {};
    const auto facets = cells.facets_of(light.from);
    const auto half =
        std::find_if(facets.begin(), facets.end(), [&](const HalfFacet& own) { return own.facet() == light.facet; });
    if (half == facets.end() || half->neighbour != light.cell) return {};
    const Vec<D> eye = session.culling_view().eye;
    switch (light.about) {
        case KeyAbout::content:
        case KeyAbout::handed_on:
            return cell_lines(cells, light.from);
        case KeyAbout::own:
            return cell_lines(cells, light.cell);
        case KeyAbout::star:
            return {facet_line(cells, light.facet), {{eye, cells.centre(light.cell)}, false, true}};
        case KeyAbout::angle: {
            const FacetGeometry<D> facet = facet_geometry(cells, *half);
            Box<D> box;
            for (const LightLine<D>& line : cell_lines(cells, light.from))
                for (const Vec<D>& point : line.points) box.add(point);
            const double length = normal_length * box.longest_side() / glm::length(facet.normal);
            return {facet_line(cells, light.facet),
                    {{eye, facet.centroid}, false, false},
                    {{facet.centroid, facet.centroid + facet.normal * length}, false, true}};
        }
        case KeyAbout::nothing:
        case KeyAbout::count:
            break;
    }
    return {};
}

template std::vector<LightLine<2>> key_light<2>(const Session<2>&, const KeyLight&);
template std::vector<LightLine<3>> key_light<3>(const Session<3>&, const KeyLight&);

}  // namespace sightline
