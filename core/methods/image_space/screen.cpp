// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/image_space/screen.h"

#include "core/raster/query.h"

namespace sightline {

namespace {

LineShape shape_of(const View<2>& view, const PixelLine& line, const Box<2>& box) {
    const std::array corners{box.corner(0), box.corner(1), box.corner(2), box.corner(3)};
    return seen_polygon(view, line.width(), corners);
}
SeenShape shape_of(const View<3>& view, const DepthImage& image, const Box<3>& box) {
    return seen_box(view, image.size(), box);
}

}  // namespace

template <int D>
void Screen<D>::show(const Problem<D>& problem, std::span<const Met> met, std::uint32_t refreshed, double opacity) {
    if (!begun_ || drawn_ > met.size() || refreshed_ != refreshed) {
        image_.begin(*problem.scene, problem.view, image_size<D>(problem.services.image),
                     RasterWork{problem.services.threads});
        begun_ = true;
        drawn_ = refreshed_ = 0;
        draw_met(met.first(refreshed));
        if (refreshed > 0) refresh(opacity);
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
BoxPixels Screen<D>::look_why(const View<D>& view, const Box<D>& box) const {
    auto sight = look_at(shape_of(view, image_.image(), box), image_.image());
    return {sight.pixels, std::move(sight.hidden_by)};
}

template class Screen<2>;
template class Screen<3>;

}  // namespace sightline
