// What a run has drawn, as an image that boxes and cells are tested against.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/raster/occlusion_image.h"
#include "core/run/problem.h"

namespace sightline {

/// What is drawn of a box or a cell that may be seen; own: what the method does unless it is told otherwise.
enum class Draws : std::uint8_t { own, winners, whole };
template <>
inline constexpr auto words<Draws> = std::to_array<std::string_view>({"own", "winners", "whole"});
const ParameterRow& draws_row();

/// So many of SeenPart::hidden_by a sentence names.
inline constexpr std::size_t most_hiders = 4;

/// What a box or a cell would show of itself if all in it were drawn.
struct SeenPart {
    std::uint32_t pixels = 0;              ///< that it covers
    std::uint32_t seen = 0;                ///< of those the ones where it lies before all that is drawn
    std::vector<std::uint32_t> hidden_by;  ///< ascending: the primitives at the others
};

/// A cache: a copy starts empty, and all is drawn again when it is next needed. The size is that of Problem::services.
template <int D>
class Screen {
public:
    Screen() = default;
    Screen(const Screen&) {}
    Screen& operator=(const Screen&) {
        begun_ = false;
        return *this;
    }

    /// To be drawn anew, in the memory that there is. For a run that goes back: it may go on another way.
    void forget() { begun_ = false; }
    /// Shows what the run has met, its pyramid what it had met when it was `refreshed` last.
    void show(const Problem<D>& problem, std::span<const Met> met, std::uint32_t refreshed, double opacity = 1);
    /// Whether it shows what the run has met as it is.
    bool shows(std::span<const Met> met) const { return begun_ && drawn_ == met.size(); }
    /// The pyramid shows all that is drawn.
    void refresh(double opacity = 1);
    /// Draws more; which of them change the image. The caller meets those, and only those.
    std::span<const std::uint8_t> draw(std::span<const std::uint32_t> primitives);
    /// So many of the drawn ones have been met.
    void met(std::uint32_t count) { drawn_ = count; }

    /// By rectangle and blocks of pixels.
    BoxSight look(const Box<D>& box) const { return image_.look(box); }
    /// Face by face, down to single pixels. The pyramid must show all that is drawn.
    BoxSight look_closely(const View<D>& view, const Box<D>& box) const;
    /// A pixel where the cell lies before all that is drawn: y * width + x; nothing where it is hidden. Conservative.
    /// The pyramid must show all that is drawn.
    std::optional<std::uint32_t> seen_at(const Problem<D>& problem, std::uint32_t cell) const;
    /// All their pixels, for those who ask why.
    SeenPart part_of(const Problem<D>& problem, const Box<D>& box) const;
    SeenPart part_of(const Problem<D>& problem, std::uint32_t cell) const;

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
