// What a frame has found out about the light in cells, so that it is worked out once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/large_pages.h"
#include "core/methods/transmittance/light.h"
#include "core/run/cell_contents.h"

namespace sightline {

/// A cache: what it says depends on the view, the cell and the cell's key only. A copy starts empty.
template <int D>
class KnownLight {
public:
    struct Cell {
        double key = 0, given = -1;  ///< the light that it hands on with that key; below 0: not known
        double ratio = -1;           ///< of key_at() (tri.h); below 0: not known
        std::uint32_t epoch = 0;
        std::uint8_t direction = unknown;  ///< in which the eye lies
        std::uint8_t in_view = unknown;    ///< 0 or 1
        bool angles = false;               ///< those of its facets are known
        bool lit = false;                  ///< it turns a facet to the eye that counts
    };
    static constexpr std::uint8_t unknown = 255;

    KnownLight() = default;
    KnownLight(const KnownLight&) {}
    KnownLight& operator=(const KnownLight&) {
        cells_.clear();
        return *this;
    }
    KnownLight(KnownLight&&) noexcept = default;
    KnownLight& operator=(KnownLight&&) noexcept = default;

    /// For another view. Costs nothing however many cells there are.
    void begin(const CellComplex<D>& cells) {
        ++epoch_;
        if (cells_.size() != cells.cell_count() || angles_.size() != cells.half_facets.size() || epoch_ == 0)
            cells_.clear();
    }
    Cell& of(const CellComplex<D>& cells, std::uint32_t cell) {
        if (cells_.empty()) [[unlikely]]
            make(cells);
        Cell& known = cells_[cell];
        if (known.epoch != epoch_) {
            known = {};
            known.epoch = epoch_;
        }
        return known;
    }
    /// angle_of() of the cell's facets, in their order.
    const double* angles_of(const CellComplex<D>& cells, std::uint32_t cell, const LitFacet<D>* lit,
                            const Vec<D>& eye) {
        Cell& known = of(cells, cell);
        const std::size_t first = first_facet(cells, cell);
        if (!known.angles) {
            known.angles = true;
            const std::size_t end = first + cells.facets_of(cell).size();
            for (std::size_t i = first; i < end; ++i) angles_[i] = angle_of(lit[i], eye);
        }
        return &angles_[first];
    }

    // Asks for memory ahead.
    void prefetch(std::uint32_t cell, std::size_t first) const {
        if (cells_.empty()) return;
        detail::prefetch(&cells_[cell]);
        detail::prefetch(&angles_[first]);
    }

    /// The place of the cell's first facet in CellComplex::half_facets.
    static std::size_t first_facet(const CellComplex<D>& cells, std::uint32_t cell) {
        return static_cast<std::size_t>(cells.facets_of(cell).data() - cells.half_facets.data());
    }

private:
    void make(const CellComplex<D>& cells) {
        epoch_ = 1;
        cells_.assign(cells.cell_count(), {});
        angles_.assign(cells.half_facets.size(), 0);
    }

    LargeVector<Cell> cells_;
    LargeVector<double> angles_;  ///< as CellComplex::half_facets
    std::uint32_t epoch_ = 0;
};

}  // namespace sightline
