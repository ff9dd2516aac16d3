// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "core/raster/occlusion_image.h"

namespace sightline {

void OcclusionImage<2>::begin(const Scene<2>& scene, const View<2>& view, const ImageSize& size, const RasterWork&) {
    scene_ = &scene;
    view_ = &view;
    line_ = PixelLine(view, whole_line_width(view, size.width));
    farthest_.assign(static_cast<std::size_t>((line_.width() + block - 1) / block), 0.0);
}

void OcclusionImage<2>::draw(std::span<const std::uint32_t> primitives, std::span<std::uint8_t> won) {
    draw_line(line_, scene_->primitives, *view_, primitives, won);
}

void OcclusionImage<2>::refresh(double opacity) {
    const auto pixels = static_cast<std::size_t>(line_.width());
    for (std::size_t i = 0; i < farthest_.size(); ++i) {
        const std::size_t first = i * block, end = std::min(first + block, pixels);
        std::size_t covered = 0;
        double farthest = std::numeric_limits<double>::infinity();
        for (std::size_t x = first; x < end; ++x)
            if (line_.nearness[x] > 0) {
                farthest = std::min(farthest, line_.nearness[x]);
                ++covered;
            }
        const bool counts = covered > 0 && static_cast<double>(covered) >= opacity * static_cast<double>(end - first);
        farthest_[i] = counts ? farthest : 0;
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
