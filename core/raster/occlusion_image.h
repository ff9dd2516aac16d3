// Depth images that a method draws its way into: a batch after the other, and boxes tested between them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/raster/band.h"
#include "core/raster/box_sight.h"
#include "core/raster/depth_pyramid.h"
#include "core/raster/pixel_line.h"
#include "core/raster/snap_primitives.h"

namespace sightline {

template <int D>
class OcclusionImage;

/// The image is that of draw_depth over all that was drawn. Tests ask a pyramid of its farthest depths (blocks of 8 x 8
/// pixels and larger) that stays as it was at the last refresh, so that they mean the same however the drawing between
/// two refreshes was cut into batches. Scene and view outlive it.
template <>
class OcclusionImage<3> {
public:
    /// Empties it for another view.
    void begin(const Scene<3>& scene, const View<3>& view, const ImageSize& size, const RasterWork& work = {});

    /// Draws the primitives in that order. won[i] is set to 1 where primitive i covers a pixel at which nothing before
    /// it is nearer (or, equally near, has a lower id), else to 0; as many as primitives.
    void draw(std::span<const std::uint32_t> primitives, std::span<std::uint8_t> won);
    /// Brings the pyramid up to date. A block of which the share `opacity` is covered then counts as covered, and as
    /// far as the farthest of what covers it; below 1 that is not conservative.
    void refresh(double opacity = 1);
    /// Conservative: by the rectangle of pixels around the box, and the planes of its faces that turn to the eye,
    /// widened as hidden-tests are.
    BoxSight look(const Box<3>& box) const;

    const DepthImage& image() const { return image_; }
    const DepthPyramid& pyramid() const { return pyramid_; }

private:
    struct Part : BandedTriangles {
        SnappedTriangles snapped;
        std::vector<std::uint8_t> won;
    };
    bool may_win(const FixedTriangle& triangle) const;

    ImageOf of_;
    RasterWork work_{};
    DepthImage image_;
    DepthPyramid pyramid_;
    std::vector<Part> parts_;             ///< scratch
    std::vector<std::uint32_t> dirty_;    ///< blocks of the pyramid's level 0 whose pixels have changed
    std::vector<std::uint8_t> is_dirty_;  ///< per block
    bool conservative_ = true;            ///< the pyramid is
};

/// The same along a line of pixels; its pyramid has one level, blocks of 8 pixels.
template <>
class OcclusionImage<2> {
public:
    void begin(const Scene<2>& scene, const View<2>& view, const ImageSize& size, const RasterWork& work = {});
    void draw(std::span<const std::uint32_t> primitives, std::span<std::uint8_t> won);
    void refresh(double opacity = 1);
    BoxSight look(const Box<2>& box) const;

    const PixelLine& image() const { return line_; }

private:
    static constexpr int block = 8;

    const Scene<2>* scene_ = nullptr;
    const View<2>* view_ = nullptr;
    PixelLine line_;
    std::vector<double> farthest_;  ///< per block
};

}  // namespace sightline
