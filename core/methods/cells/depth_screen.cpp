// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cells/depth_screen.h"

namespace sightline {

namespace {

/// 2D: as item_row, a multiple of 4 all round.
int line_width(const Problem<2>& problem) {
    const int width = image_size<2>(problem.services.image).width;
    return problem.view.all_round ? std::max(4, width / 4 * 4) : width;
}

}  // namespace

template <int D>
void DepthScreen<D>::draw(const Problem<D>& problem, std::span<const Met> met) {
    if (!begun_ || drawn_ > met.size()) {
        if constexpr (D == 2)
            image_ = PixelLine(problem.view, line_width(problem));
        else
            image_ = DepthImage(image_size<3>(problem.services.image));
        drawn_ = 0;
    }
    const std::vector<std::uint32_t> ids = rendered_ids(met.subspan(drawn_));
    if constexpr (D == 2) {
        draw_line(image_, problem.primitives(), problem.view, ids);
    } else {
        draw_depth(image_, *problem.scene, problem.view, ids);
        if (!begun_ || !ids.empty()) pyramid_ = DepthPyramid(image_);
    }
    drawn_ = met.size();
    begun_ = true;
}

template <int D>
std::optional<std::uint32_t> DepthScreen<D>::seen_at(const Problem<D>& problem, std::uint32_t cell) const {
    if constexpr (D == 2) {
        const auto at = find_seen(seen_cell(problem.view, image_.width(), *problem.cells, cell), image_);
        return at ? std::optional(static_cast<std::uint32_t>(*at)) : std::nullopt;
    } else {
        const auto at = find_seen(seen_cell(problem.view, image_.size(), *problem.cells, cell), image_, pyramid_);
        return at ? std::optional(static_cast<std::uint32_t>(image_.index(at->x, at->y))) : std::nullopt;
    }
}

template <int D>
CellSight DepthScreen<D>::look(const Problem<D>& problem, std::uint32_t cell) const {
    if constexpr (D == 2) {
        auto sight = look_at(seen_cell(problem.view, image_.width(), *problem.cells, cell), image_);
        return {sight.pixels, sight.seen, std::move(sight.hidden_by)};
    } else {
        auto sight = look_at(seen_cell(problem.view, image_.size(), *problem.cells, cell), image_);
        return {sight.pixels, sight.seen, std::move(sight.hidden_by)};
    }
}

template class DepthScreen<2>;
template class DepthScreen<3>;

}  // namespace sightline
