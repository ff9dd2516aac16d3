// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/screen.h"

#include "core/raster/query.h"

namespace sightline {

namespace {

LineShape shape_of(const View<2>& view, const PixelLine& line, const Box<2>& box) {
    return seen_box(view, line.width(), box);
}
SeenShape shape_of(const View<3>& view, const DepthImage& image, const Box<3>& box) {
    return seen_box(view, image.size(), box);
}

}  // namespace

const ParameterRow& draws_row() {
    static const ParameterRow row = choice_row(
        "draws", Draws::own, "docs/methods.md",
        "of a box or a cell that may be seen: the primitives that win a pixel when their turn comes, or all in view");
    return row;
}

template <int D>
void Screen<D>::show(const Problem<D>& problem, std::span<const Met> met, std::uint32_t refreshed, double opacity) {
    const bool too_far =
        drawn_ > met.size() || refreshed_ > refreshed || (refreshed_ < refreshed && refreshed < drawn_);
    if (!begun_ || too_far) {
        image_.begin(*problem.scene, problem.view, image_size<D>(problem.services.image),
                     RasterWork{problem.services.threads});
        begun_ = true;
        drawn_ = refreshed_ = 0;
    }
    if (refreshed_ < refreshed) {
        draw_met(met.first(refreshed));
        refresh(opacity);
    }
    draw_met(met);
}

template <int D>
void Screen<D>::draw_met(std::span<const Met> met) {
    if (drawn_ == met.size()) return;
    draw(rendered_ids(met.subspan(drawn_)));
    drawn_ = static_cast<std::uint32_t>(met.size());
}

template <int D>
void Screen<D>::refresh(double opacity) {
    if (refreshed_ == drawn_) return;
    image_.refresh(opacity);
    refreshed_ = drawn_;
}

template <int D>
std::span<const std::uint8_t> Screen<D>::draw(std::span<const std::uint32_t> primitives) {
    won_.resize(primitives.size());
    image_.draw(primitives, won_);
    return won_;
}

template <int D>
BoxSight Screen<D>::look_closely(const View<D>& view, const Box<D>& box) const {
    if constexpr (D == 2) {
        const LineShape shape = shape_of(view, image_.image(), box);
        if (!shape.everywhere && shape.pieces.empty()) return BoxSight::outside;
        return find_seen(shape, image_.image()) ? BoxSight::seen : BoxSight::hidden;
    } else {
        const SeenShape shape = shape_of(view, image_.image(), box);
        if (!shape.everywhere && shape.faces.empty()) return BoxSight::outside;
        return find_seen(shape, image_.image(), image_.pyramid()) ? BoxSight::seen : BoxSight::hidden;
    }
}

template <int D>
std::optional<std::uint32_t> Screen<D>::seen_at(const Problem<D>& problem, std::uint32_t cell) const {
    const CellComplex<D>& cells = *problem.cells;
    // Most cells are hidden, and most of those show it quickly.
    Box<D> box;
    for (const std::uint32_t corner : cells.corners_of(cell)) box.add(cells.points[corner]);
    if (image_.look(box) != BoxSight::seen) return std::nullopt;
    if constexpr (D == 2) {
        const auto at = find_seen(seen_cell(problem.view, image_.image().width(), cells, cell), image_.image());
        return at ? std::optional(static_cast<std::uint32_t>(*at)) : std::nullopt;
    } else {
        const DepthImage& image = image_.image();
        const auto at = find_seen(seen_cell(problem.view, image.size(), cells, cell), image, image_.pyramid());
        return at ? std::optional(static_cast<std::uint32_t>(image.index(at->x, at->y))) : std::nullopt;
    }
}

template <int D>
SeenPart Screen<D>::part_of(const Problem<D>& problem, const Box<D>& box) const {
    auto sight = look_at(shape_of(problem.view, image_.image(), box), image_.image());
    return {sight.pixels, sight.seen, std::move(sight.hidden_by)};
}

template <int D>
SeenPart Screen<D>::part_of(const Problem<D>& problem, std::uint32_t cell) const {
    if constexpr (D == 2) {
        auto sight = look_at(seen_cell(problem.view, image_.image().width(), *problem.cells, cell), image_.image());
        return {sight.pixels, sight.seen, std::move(sight.hidden_by)};
    } else {
        auto sight = look_at(seen_cell(problem.view, image_.image().size(), *problem.cells, cell), image_.image());
        return {sight.pixels, sight.seen, std::move(sight.hidden_by)};
    }
}

template class Screen<2>;
template class Screen<3>;

}  // namespace sightline
