// What a run has drawn, as an image that boxes are tested against.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster/occlusion_image.h"
#include "core/run/problem.h"

namespace sightline {

struct BoxPixels {
    std::uint32_t pixels = 0;              ///< that it covers
    std::vector<std::uint32_t> hidden_by;  ///< ascending: the primitives at those where it is hidden
};

/// A cache: a copy starts empty, and all is drawn again when it is next needed.
template <int D>
class Screen {
public:
    Screen() = default;
    Screen(const Screen&) {}
    Screen& operator=(const Screen&) {
        begun_ = false;
        return *this;
    }

    /// To be drawn anew, in the memory that there is.
    void forget() { begun_ = false; }
    /// Shows what the run has met, its pyramid what it had met when it was `refreshed` last.
    void show(const Problem<D>& problem, std::span<const Met> met, std::uint32_t refreshed, double opacity);
    /// The pyramid shows all that is drawn.
    void refresh(double opacity);
    /// Draws more; which of them change the image. The caller meets those, and only those.
    std::span<const std::uint8_t> draw(std::span<const std::uint32_t> primitives);
    /// So many of the drawn ones have been met.
    void met(std::uint32_t count) { drawn_ = count; }

    BoxSight look(const Box<D>& box) const { return image_.look(box); }
    /// Face by face, down to single pixels. The pyramid must show all that is drawn.
    BoxSight look_closely(const View<D>& view, const Box<D>& box) const;
    /// All its pixels, for those who ask why.
    BoxPixels look_why(const View<D>& view, const Box<D>& box) const;
    const OcclusionImage<D>& image() const { return image_; }

private:
    void draw_met(std::span<const Met> met);

    OcclusionImage<D> image_;
    std::vector<std::uint8_t> won_;
    bool begun_ = false;
    std::uint32_t drawn_ = 0;      ///< entries of the run's list that are drawn
    std::uint32_t refreshed_ = 0;  ///< those that the pyramid shows
};

}  // namespace sightline
