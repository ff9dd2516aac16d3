// What drawing a frame costs, predicted from the vertices and the pixels of its objects (Funkhouser and Sequin 1993).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/image_size.h"
#include "core/base/words.h"
#include "core/scene/view.h"

namespace sightline {

/// Vertices and pixels go through one pipeline, whose slower part decides (Dynamic Algorithm Selection, 3.1.1, where
/// the two are α_v and α_p). Plain numbers, from a data sheet or from a calibration.
struct DrawingCost {
    double vertex_ns = 0, pixel_ns = 0;
    bool operator==(const DrawingCost&) const = default;

    double ms(double vertices, double pixels) const;
};

/// An object, or all of a frame, as it goes through the pipeline.
struct DrawnSize {
    std::uint64_t vertices = 0;  ///< D for each primitive: none is shared
    std::uint64_t pixels = 0;    ///< that it is taken to cover, covered ones again
    bool operator==(const DrawnSize&) const = default;
};

/// The paper gives the cost of one object and leaves open what a frame of many costs: each waits for the slower part of
/// its own, or all of one kind of work overlaps with all of the other.
enum class CostReading : std::uint8_t { sum_of_max, max_of_sums };
template <>
inline constexpr auto words<CostReading> = std::to_array<std::string_view>({"sum-of-max", "max-of-sums"});

/// A frame as a sum over its objects; both readings are kept. Objects may be added and taken out again; a value that
/// was copied before is the way back, for taking out rounds.
class FrameDrawing {
public:
    FrameDrawing() = default;
    explicit FrameDrawing(const DrawingCost& cost) : cost_(cost) {}

    void add(const DrawnSize& object);
    void take_out(const DrawnSize& object);
    /// Milliseconds, never negative.
    double ms(CostReading reading) const;
    const DrawnSize& size() const { return all_; }

private:
    DrawingCost cost_;
    DrawnSize all_;
    double sum_of_max_ = 0;
};

/// How large things look in an image of `size` pixels. In 2D it is a line of size.width pixels, all round four lines of
/// a quarter each.
template <int D>
class PixelScale {
public:
    PixelScale() = default;
    PixelScale(const View<D>& view, const ImageSize& size);

    /// Of the 2D box around the projected box, clipped to the image (DAS 3.1.1), whole pixels. All of the image for a
    /// box across the plane of the eye, none for one behind it.
    std::uint64_t pixels_of(const Box<D>& box) const;
    /// How many pixels a unit of length takes at most in the box: the images of two points of the box, of which one is
    /// in the view, lie no farther apart than so many pixels times their distance. Infinite for a box that reaches the
    /// plane of the eye.
    double pixels_per_unit(const Box<D>& box) const;

private:
    /// One image line (2D) or the image (3D): a point p has depth dot(depth, p - eye), 1 on the plane of the view's
    /// corners, and is seen at dot(across[i], p - eye) / depth, from -1 to +1.
    struct Part {
        std::array<Vec<D>, D - 1> across{};
        Vec<D> depth{};
    };
    std::uint64_t pixels_of(const Part& part, const std::array<Vec<D>, 1 << D>& corners) const;

    Vec<D> eye_{};
    bool all_round_ = false;
    std::vector<Part> parts_;
    std::array<int, D - 1> pixels_{};  ///< of a part
    double most_at_1_ = 0;             ///< pixels per unit at depth 1, where that is largest
};

template <>
PixelScale<2>::PixelScale(const View<2>& view, const ImageSize& size);
template <>
PixelScale<3>::PixelScale(const View<3>& view, const ImageSize& size);
extern template class PixelScale<2>;
extern template class PixelScale<3>;

}  // namespace sightline
