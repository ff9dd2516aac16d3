// What a run has rendered, as a depth image that cells are tested against.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/image_size.h"
#include "core/raster/pixel_line.h"
#include "core/raster/query.h"
#include "core/run/problem.h"

namespace sightline {

/// What a cell would show of itself if all in it were drawn.
struct CellSight {
    std::uint32_t pixels = 0;              ///< that it covers
    std::uint32_t seen = 0;                ///< of those the ones where it lies before all that is drawn
    std::vector<std::uint32_t> hidden_by;  ///< ascending: the primitives at the others
};

/// A cache: a copy starts empty and is drawn again when it is next needed.
template <int D>
class DepthScreen {
public:
    DepthScreen() = default;
    DepthScreen(const DepthScreen&) {}
    DepthScreen& operator=(const DepthScreen&) { return *this = DepthScreen(); }
    DepthScreen& operator=(DepthScreen&&) noexcept = default;

    /// Draws what of `met` is not drawn yet; again from the start where less was met than is drawn. The size is that of
    /// Problem::services.
    void draw(const Problem<D>& problem, std::span<const Met> met);
    /// A pixel where the cell lies before all that is drawn: y * width + x; nothing where it is hidden. Conservative.
    std::optional<std::uint32_t> seen_at(const Problem<D>& problem, std::uint32_t cell) const;
    /// All its pixels, for those who ask why.
    CellSight look(const Problem<D>& problem, std::uint32_t cell) const;

private:
    std::conditional_t<D == 2, PixelLine, DepthImage> image_;
    std::conditional_t<D == 2, char, DepthPyramid> pyramid_{};
    std::size_t drawn_ = 0;  ///< of the run's list
    bool begun_ = false;
};

}  // namespace sightline
