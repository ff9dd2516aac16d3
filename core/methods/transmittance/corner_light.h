// Light at the corners of cells, by short characteristics: each asks the one cell that lies before it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/large_pages.h"
#include "core/methods/transmittance/corner_rays.h"
#include "core/methods/transmittance/light.h"
#include "core/methods/transmittance/transmittance_parameters.h"
#include "core/run/cell_contents.h"

namespace sightline {

/// Whether the problem asks for light at corners; `usual`: what its method does unasked.
template <int D>
bool takes_corners(const Problem<D>& problem, LightTransport usual) {
    const auto asked = problem.parameters.template choice<LightTransport>(transport_row());
    return (asked == LightTransport::usual ? usual : asked) == LightTransport::corners;
}

/// How light depends on the place in a cell, for centroids of primitives: boxes by weights along the axes, simplices by
/// a plane through the corners. In [least, most], also outside of the cell.
template <int D>
struct LightInside {
    std::array<float, D> origin{}, scale{};  ///< the place as its terms take it is (p − origin) · scale
    float nearest = 0, farthest = 0;         ///< and is cut to this range on each axis
    std::array<float, 1 << D> terms{};       ///< place i: of the product over the axes whose bits are set in i
    float least = 0, most = 0;

    /// The same everywhere.
    static LightInside everywhere(float light) {
        LightInside inside;
        inside.terms[0] = inside.least = inside.most = light;
        return inside;
    }
};

/// A cache: all of it depends on the view only. A copy starts empty.
template <int D>
class CornerLight {
public:
    explicit CornerLight(const Problem<D>& problem) { begin(problem); }
    CornerLight(const CornerLight& other) : scene_(other.scene_), rays_(other.rays_) {}
    CornerLight& operator=(const CornerLight& other) {
        scene_ = other.scene_;
        rays_ = other.rays_;
        corners_.clear();
        return *this;
    }
    CornerLight(CornerLight&&) noexcept = default;
    CornerLight& operator=(CornerLight&&) noexcept = default;

    /// For another view. Costs nothing however many cells there are.
    void begin(const Problem<D>& problem) {
        scene_ = cell_light(problem);
        rays_ = corner_rays(problem);
        ++epoch_;
        if (corners_.size() != problem.cells->points.size() || epoch_ == 0) corners_.clear();
    }
    const CellLight<D>& of_scene() const { return *scene_; }

    /// 1: nothing between the point and the eye hides anything; else what the cell before it leaves open of the light
    /// where the ray to the eye leaves that cell, which is that of the corners there by their weights. In [0, 1].
    float at(const Problem<D>& problem, std::uint32_t corner) const {
        if (corners_.empty()) [[unlikely]]
            make(problem);
        const Known& known = corners_[corner];
        return known.epoch == epoch_ ? known.value : found(problem, corner);
    }
    /// The mean over its corners.
    double of_cell(const Problem<D>& problem, std::uint32_t cell) const {
        const auto corners = problem.cells->corners_of(cell);
        prefetch_rays(problem, corners);
        double sum = 0;
        for (const std::uint32_t corner : corners) sum += double{at(problem, corner)};
        return sum / static_cast<double>(corners.size());
    }
    /// Places are relative to `origin`.
    LightInside<D> inside(const Problem<D>& problem, std::uint32_t cell, const Vec<D>& origin) const;
    CornerRay<D> ray(const Problem<D>& problem, std::uint32_t corner) const {
        return rays_->from(*problem.cells, corner, problem.view.eye);
    }
    /// 1 less the opacity of the ray's cell.
    float open(const CornerRay<D>& ray) const {
        return ray.cell == none ? 1
                                : 1 - static_cast<float>(scene_->opacity.of(ray.cell, nearest_direction(ray.to_eye)));
    }
    /// Asks for memory ahead.
    void prefetch(const CellComplex<D>& cells, std::uint32_t cell) const {
        detail::prefetch(cells.corners_of(cell).data());
        detail::prefetch(&scene_->centres[cell]);
    }

private:
    struct Known {
        float value = 0;
        std::uint32_t epoch = 0;
    };
    /// A corner that waits until those before it are known.
    struct Pending {
        std::uint32_t corner;
        std::uint32_t next;  ///< of the ray's corners: those before are known
        CornerRay<D> ray;
    };

    void make(const Problem<D>& problem) const {
        epoch_ = 1;
        corners_.assign(problem.cells->points.size(), {});
    }
    float found(const Problem<D>& problem, std::uint32_t corner) const;
    /// Of corners whose light is not known yet: what found() reads, of all of them at once.
    void prefetch_rays(const Problem<D>& problem, std::span<const std::uint32_t> corners) const {
        if (corners_.empty()) return;
        std::array<std::uint32_t, 1 << D> unknown;
        std::size_t count = 0;
        for (const std::uint32_t corner : corners)
            if (corners_[corner].epoch != epoch_) {
                rays_->prefetch(corner);
                unknown[count++] = corner;
            }
        for (std::size_t i = 0; i < count; ++i)
            if (const std::uint32_t cell = rays_->prefetch_cell(unknown[i], problem.view.eye); cell != none)
                detail::prefetch(scene_->opacity.address_of(cell));
    }

    std::shared_ptr<const CellLight<D>> scene_;
    std::shared_ptr<const CornerRays<D>> rays_;
    mutable LargeVector<Known> corners_;
    mutable std::vector<Pending> pending_;
    mutable std::uint32_t epoch_ = 0;
};

extern template class CornerLight<2>;
extern template class CornerLight<3>;

}  // namespace sightline
