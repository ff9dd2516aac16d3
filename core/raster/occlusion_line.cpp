// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/raster/occlusion_image.h"

namespace sightline {

void OcclusionImage<2>::begin(const Scene<2>& scene, const View<2>& view, const ImageSize& size, const RasterWork&) {
    scene_ = &scene;
    view_ = &view;
    line_ = PixelLine(view, view.all_round ? std::max(4, size.width / 4 * 4) : size.width);
    farthest_.assign(static_cast<std::size_t>((line_.width() + block - 1) / block), 0.0);
}

void OcclusionImage<2>::draw(std::span<const std::uint32_t> primitives, std::span<std::uint8_t> won) {
    draw_line(line_, scene_->primitives, *view_, primitives, won);
}

void OcclusionImage<2>::refresh() {
    for (std::size_t i = 0; i < farthest_.size(); ++i) {
        const auto first = line_.nearness.begin() + static_cast<std::ptrdiff_t>(i * block);
        farthest_[i] = *std::min_element(first, std::min(first + block, line_.nearness.end()));
    }
}

BoxSight OcclusionImage<2>::look(const Box<2>& box) const {
    const std::array corners{box.corner(0), box.corner(1), box.corner(2), box.corner(3)};
    const LineShape shape = seen_polygon(*view_, line_.width(), corners);
    if (shape.everywhere) return BoxSight::seen;
    if (shape.pieces.empty()) return BoxSight::outside;
    for (const LineShape::Piece& piece : shape.pieces)
        for (int i = piece.first / block; i <= (piece.end - 1) / block; ++i) {
            const int first = std::max(piece.first, i * block), last = std::min(piece.end, (i + 1) * block) - 1;
            if (std::max(piece.nearness(first), piece.nearness(last)) >= farthest_[static_cast<std::size_t>(i)])
                return BoxSight::seen;
        }
    return BoxSight::hidden;
}

}  // namespace sightline
