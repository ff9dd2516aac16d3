// Whether a cell meets the view cone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/view.h"
#include "core/space/cell_complex.h"

namespace sightline {

/// 2D: exact. 3D: conservative (never false when it does).
bool cell_in_view(const CellComplex<2>& cells, const View<2>& view, std::uint32_t cell);
bool cell_in_view(const CellComplex<3>& cells, const View<3>& view, std::uint32_t cell);

/// The same for many cells and one view.
template <int D>
class CellsInView {
public:
    void begin(const CellComplex<D>&) {}
    bool has(const CellComplex<D>& cells, const View<D>& view, std::uint32_t cell,
             std::span<const std::uint32_t> /*its corners*/) const {
        return cell_in_view(cells, view, cell);
    }
    std::size_t memory_bytes() const { return 0; }
};

/// 3D: remembers of each point where it lies, since some twenty cells share it.
template <>
class CellsInView<3> {
public:
    /// For another view. Costs nothing however many points there are.
    void begin(const CellComplex<3>& cells) {
        if (points_.size() != cells.points.size() || epoch_ == last_epoch) {
            points_.assign(cells.points.size(), 0);
            epoch_ = 0;
        }
        ++epoch_;
    }
    bool has(const CellComplex<3>& cells, const View<3>& view, std::uint32_t /*cell*/,
             std::span<const std::uint32_t> corners) {
        unsigned all = ~0u;
        for (const std::uint32_t corner : corners) {
            std::uint32_t& known = points_[corner];
            if (known >> plane_bits != epoch_) known = epoch_ << plane_bits | planes_beyond(view, cells.points[corner]);
            all &= known;
        }
        return (all & ((1u << plane_bits) - 1)) == 0;
    }
    std::size_t memory_bytes() const { return points_.capacity() * sizeof(std::uint32_t); }

private:
    static constexpr int plane_bits = 4;
    static constexpr std::uint32_t last_epoch = (1u << (32 - plane_bits)) - 1;
    LargeVector<std::uint32_t> points_;  ///< epoch * 16 + planes that it lies beyond
    std::uint32_t epoch_ = 0;
};

}  // namespace sightline
