// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "core/base/image_size.h"
#include "core/space/builders.h"
#include "core/truth/reference.h"

namespace sightline {

namespace {

/// The point of the triangle's plane on the ray from the eye through a point; nothing where the ray lies along it.
std::optional<Vec<3>> point_of(const Primitive<3>& triangle, const Vec<3>& eye, const Vec<3>& through) {
    const Vec<3> normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double along = glm::dot(normal, through - eye);
    if (along == 0) return std::nullopt;
    const Vec<3> point = eye + (through - eye) * (glm::dot(normal, triangle[0] - eye) / along);
    if (!is_finite(point)) return std::nullopt;
    return point;
}

/// Which cell each pixel's point lies in, counted per cell. Points on a row of one primitive lie on a line and cells
/// are convex: where the first and the last point share a cell, so do all between them.
class CellPixels {
public:
    CellPixels(const IdImage& image, const Scene<3>& scene, const CellComplex<3>& cells, const View<3>& view)
        : scene_(scene), cells_(cells), view_(view), size_{image.width, image.height} {
        counts.assign(cells.cell_count(), 0);
        only_cell_.assign(scene.primitives.size(), none);
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
            for (const std::uint32_t id : cells.primitives_of(cell))
                only_cell_[id] = only_cell_[id] == none ? cell : several;
    }

    /// Pixels [first, end) of row y show the primitive.
    void add(std::uint32_t id, int first, int end, int y) {
        if (only_cell_[id] == none) return;
        if (only_cell_[id] != several) {
            counts[only_cell_[id]] += static_cast<std::uint32_t>(end - first);
            return;
        }
        const std::uint32_t left = cell_at(id, first, y);
        split(id, first, left, end - 1, end - first > 1 ? cell_at(id, end - 1, y) : left, y);
        count(id, left, 1);
    }

    std::vector<std::uint32_t> counts;  ///< per cell

private:
    static constexpr std::uint32_t several = none - 1;

    /// Counts the pixels after `first`, which lies in cell `left`, to `last`, which lies in cell `right`.
    void split(std::uint32_t id, int first, std::uint32_t left, int last, std::uint32_t right, int y) {
        if (left == right || last - first <= 1) {
            count(id, right, last - first);
            return;
        }
        const int middle = (first + last) / 2;
        const std::uint32_t between = cell_at(id, middle, y);
        split(id, first, left, middle, between, y);
        split(id, middle, between, last, right, y);
    }

    std::uint32_t cell_at(std::uint32_t id, int x, int y) {
        const auto point = point_of(scene_.primitives[id], view_.eye, pixel_centre(view_, size_, x, y));
        const std::uint32_t cell = point ? any_holding(cells_, *point, near_) : none;
        if (cell != none) near_ = cell;
        return cell;
    }

    /// Rounding may carry a point over a facet into a cell that the primitive does not enter.
    void count(std::uint32_t id, std::uint32_t cell, int pixels) {
        if (cell == none || pixels == 0) return;
        const auto inside = cells_.primitives_of(cell);
        if (std::binary_search(inside.begin(), inside.end(), id)) counts[cell] += static_cast<std::uint32_t>(pixels);
    }

    const Scene<3>& scene_;
    const CellComplex<3>& cells_;
    const View<3>& view_;
    ImageSize size_;
    std::vector<std::uint32_t> only_cell_;  ///< per primitive: its cell, none or several
    std::uint32_t near_ = none;             ///< where the last point was found
};

}  // namespace

Vec<3> pixel_centre(const View<3>& view, const ImageSize& size, int x, int y) {
    const double right = (x + 0.5) / size.width, down = (y + 0.5) / size.height;
    const Vec<3>& left_top = view.corners[3];
    return left_top + (view.corners[2] - left_top) * right + (view.corners[0] - left_top) * down;
}

Reference image_reference(IdImage image, const Scene<3>& scene, const CellComplex<3>& cells, const View<3>& view) {
    Reference reference;
    reference.name =
        (image.software ? "software item buffer " : "item buffer ") + image_size_text({image.width, image.height});
    reference.visible.assign(scene.primitives.size(), 0);
    reference.pixels.assign(scene.primitives.size(), 0);
    CellPixels cell_pixels(image, scene, cells, view);
    std::size_t covered = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0, end = 0; x < image.width; x = end) {
            const std::uint32_t id = image.at(x, y);
            for (end = x + 1; end < image.width && image.at(end, y) == id;) ++end;
            if (id == none) continue;
            covered += static_cast<std::size_t>(end - x);
            reference.pixels[id] += static_cast<std::uint32_t>(end - x);
            cell_pixels.add(id, x, end, y);
        }
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) reference.visible[i] = reference.pixels[i] > 0;
    reference.count = static_cast<std::size_t>(std::count(reference.visible.begin(), reference.visible.end(), 1));
    reference.cell_share.resize(cells.cell_count());
    for (std::uint32_t i = 0; i < cells.cell_count(); ++i)
        reference.cell_share[i] =
            covered == 0 ? 0 : static_cast<double>(cell_pixels.counts[i]) / static_cast<double>(covered);
    reference.image = std::move(image);
    return reference;
}

}  // namespace sightline
