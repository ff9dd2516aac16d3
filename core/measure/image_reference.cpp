// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "core/measure/reference.h"
#include "core/settings/settings_table.h"

namespace sightline {

namespace {

/// The point of the triangle's plane on the ray from the eye through a point; nothing where the ray lies along it.
std::optional<Vec<3>> hit(const Primitive<3>& triangle, const Vec<3>& eye, const Vec<3>& through) {
    const Vec<3> normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double along = glm::dot(normal, through - eye);
    if (along == 0) return std::nullopt;
    const Vec<3> point = eye + (through - eye) * (glm::dot(normal, triangle[0] - eye) / along);
    if (!is_finite(point)) return std::nullopt;
    return point;
}

}  // namespace

Vec<3> pixel_centre(const View<3>& view, const ImageSize& size, int x, int y) {
    const double right = (x + 0.5) / size.width, down = (y + 0.5) / size.height;
    const Vec<3>& left_top = view.corners[3];
    return left_top + (view.corners[2] - left_top) * right + (view.corners[0] - left_top) * down;
}

Reference image_reference(IdImage image, const Scene<3>& scene, const CellComplex<3>& cells, const View<3>& view) {
    Reference reference;
    const ImageSize size{image.width, image.height};
    reference.name = "item buffer " + image_size_text(size);
    reference.visible.assign(scene.primitives.size(), 0);
    reference.pixels.assign(scene.primitives.size(), 0);
    std::vector<std::uint32_t> cell_pixels(cells.cell_count(), 0);
    std::size_t covered = 0;
    std::uint32_t cell = none;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint32_t id = image.at(x, y);
            if (id == no_primitive) continue;
            ++covered;
            ++reference.pixels[id];
            const auto point = hit(scene.primitives[id], view.eye, pixel_centre(view, size, x, y));
            if (!point) continue;
            const std::uint32_t found = locate(cells, *point, cell);
            if (found == none) continue;
            cell = found;
            // Rounding may carry the point over a facet into a cell that the triangle does not enter.
            const auto inside = cells.primitives_of(cell);
            if (std::binary_search(inside.begin(), inside.end(), id)) ++cell_pixels[cell];
        }
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) reference.visible[i] = reference.pixels[i] > 0;
    reference.count = static_cast<std::size_t>(std::count(reference.visible.begin(), reference.visible.end(), 1));
    reference.cell_share.resize(cells.cell_count());
    for (std::uint32_t i = 0; i < cells.cell_count(); ++i)
        reference.cell_share[i] = covered == 0 ? 0 : static_cast<double>(cell_pixels[i]) / static_cast<double>(covered);
    reference.image = std::move(image);
    return reference;
}

}  // namespace sightline
