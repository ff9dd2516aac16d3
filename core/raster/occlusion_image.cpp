// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/occlusion_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/workers.h"
#include "core/raster/seen_shape.h"

namespace sightline {

namespace {

constexpr std::size_t primitives_of_part = 512;
/// Fewer are drawn by the caller alone: waking a thread takes as long.
constexpr std::size_t worth_threads = 512;

int block_of(int pixel) { return pixel / DepthPyramid::block; }

/// Blocks of a pyramid's level 0: [left, right] x [top, bottom].
struct PixelBlocks {
    int left, top, right, bottom;
};

/// No pixel has a box nearer: it lies behind the planes of all its faces that turn to the eye, and nearness in a plane
/// is linear in column and row.
struct BoxNearness {
    struct Plane {
        double at, by_column, by_row;
    };
    double nearest;
    int planes = 0;
    std::array<Plane, 3> plane{};

    /// Over pixels [x, end_x) x [y, end_y).
    double bound(int x, int y, int end_x, int end_y) const {
        double least = nearest;
        for (int i = 0; i < planes; ++i) {
            const Plane& p = plane[static_cast<std::size_t>(i)];
            least = std::min(least, p.at + p.by_column * (p.by_column > 0 ? end_x - 1 : x) +
                                        p.by_row * (p.by_row > 0 ? end_y - 1 : y));
        }
        return least;
    }
};

/// A point of the face at `c` on an axis, seen at (x, y) of the image, has one over w = d / (c - eye) on that axis,
/// where d is the direction through (x, y) to the plane w = 1.
BoxNearness nearness_of(const Box<3>& box, const View<3>& view, const ImageSize& size, double least_w) {
    constexpr double step = 1 + 0x1p-22;  // of a float, as hidden-tests are widened
    BoxNearness nearness{nearness_1 / least_w * step};
    const auto& c = view.corners;
    const Vec<3> right = (c[1] - c[0]) * 0.5, up = (c[3] - c[0]) * 0.5, middle = (c[0] + c[2]) * 0.5 - view.eye;
    for (int axis = 0; axis < 3; ++axis) {
        const bool low = view.eye[axis] < box.min[axis];
        if (!low && !(view.eye[axis] > box.max[axis])) continue;
        const double scale = nearness_1 * step / ((low ? box.min[axis] : box.max[axis]) - view.eye[axis]);
        const double x = right[axis] * scale, y = up[axis] * scale, at = middle[axis] * scale;
        const double by_column = 2 * x / size.width, by_row = -2 * y / size.height;
        const double wider = (std::abs(by_column) + std::abs(by_row)) * query_margin +
                             0x1p-45 * (std::abs(x) + std::abs(y) + std::abs(at));  // rounding of the corners
        nearness.plane[static_cast<std::size_t>(nearness.planes++)] = {at - x + y + 0.5 * (by_column + by_row) + wider,
                                                                       by_column, by_row};
    }
    return nearness;
}

/// Whether a box may be seen in those of its blocks that block (x, y) of the level has.
bool may_show(const DepthPyramid& pyramid, const PixelBlocks& blocks, const BoxNearness& box, int level, int x, int y) {
    const int side = DepthPyramid::block << level;
    const float farthest = pyramid.levels[static_cast<std::size_t>(level)].at(x, y);
    if (box.bound(x * side, y * side, (x + 1) * side, (y + 1) * side) < farthest) return false;
    if (level == 0) return true;
    const int below = level - 1;
    for (int row = std::max(2 * y, blocks.top >> below); row <= std::min(2 * y + 1, blocks.bottom >> below); ++row)
        for (int column = std::max(2 * x, blocks.left >> below); column <= std::min(2 * x + 1, blocks.right >> below);
             ++column)
            if (may_show(pyramid, blocks, box, below, column, row)) return true;
    return false;
}

/// From the level at which they are few.
bool may_show(const DepthPyramid& pyramid, const PixelBlocks& blocks, const BoxNearness& box) {
    int level = 0;
    const auto most = static_cast<int>(pyramid.levels.size()) - 1;
    while (level < most && ((blocks.right >> level) - (blocks.left >> level) > 1 ||
                            (blocks.bottom >> level) - (blocks.top >> level) > 1))
        ++level;
    for (int y = blocks.top >> level; y <= blocks.bottom >> level; ++y)
        for (int x = blocks.left >> level; x <= blocks.right >> level; ++x)
            if (may_show(pyramid, blocks, box, level, x, y)) return true;
    return false;
}

}  // namespace

void OcclusionImage<3>::begin(const Scene<3>& scene, const View<3>& view, const ImageSize& size,
                              const RasterWork& work) {
    of_ = {scene, view, size};
    work_ = work;
    if (image_.size() == size) {
        std::fill(image_.nearness.begin(), image_.nearness.end(), 0.0f);
        std::fill(image_.ids.begin(), image_.ids.end(), none);
        for (DepthPyramid::Level& level : pyramid_.levels)
            std::fill(level.farthest.begin(), level.farthest.end(), 0.0f);
    } else {
        image_ = DepthImage(size);
        pyramid_ = DepthPyramid(image_);
    }
    dirty_.clear();
    is_dirty_.assign(pyramid_.levels[0].farthest.size(), 0);
    conservative_ = true;
}

/// Whether the pyramid does not hide it. A triangle that it hides would win no pixel.
bool OcclusionImage<3>::may_win(const FixedTriangle& triangle) const {
    if (!conservative_) return true;
    const PixelBox box(triangle, image_.size());
    const float nearest = std::max({triangle.nearness[0], triangle.nearness[1], triangle.nearness[2]});
    const DepthPyramid::Level& level = pyramid_.levels[0];
    for (int y = block_of(box.top); y <= block_of(box.bottom - 1); ++y)
        for (int x = block_of(box.left); x <= block_of(box.right - 1); ++x)
            if (nearest >= level.at(x, y)) return true;
    return false;
}

void OcclusionImage<3>::draw(std::span<const std::uint32_t> primitives, std::span<std::uint8_t> won) {
    const ImageSize size = image_.size();
    const int threads = primitives.size() < worth_threads ? 1 : work_.threads;
    const std::size_t part_count = (primitives.size() + primitives_of_part - 1) / primitives_of_part;
    if (parts_.size() < part_count) parts_.resize(part_count);
    run_parts(static_cast<int>(part_count), threads, [&](int index) {
        Part& part = parts_[static_cast<std::size_t>(index)];
        const std::size_t begin = static_cast<std::size_t>(index) * primitives_of_part;
        part.snapped.clear();
        snap_primitives(of_, primitives.subspan(begin, std::min(primitives_of_part, primitives.size() - begin)),
                        static_cast<std::uint32_t>(begin), work_.best_vectors, part.snapped);
        part.triangles.clear();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < part.snapped.triangles.size(); ++i) {
            if (!may_win(part.snapped.triangles[i])) continue;
            part.triangles.push_back(part.snapped.triangles[i]);
            part.snapped.place[kept++] = part.snapped.place[i];
        }
        part.won.assign(kept, 0);
        sort_into_bands(part, size);
    });
    run_parts(bands_of(size), threads, [&](int band) {
        const BandPixels pixels{size, band * band_rows, std::min((band + 1) * band_rows, size.height),
                                image_.nearness.data(), image_.ids.data()};
        for (std::size_t i = 0; i < part_count; ++i) {
            Part& part = parts_[i];
            const std::vector<std::uint32_t>& which = part.of_band[static_cast<std::size_t>(band)];
            fill_band(pixels, part.triangles, which, work_.best_vectors, part.won.data());
        }
    });
    std::fill(won.begin(), won.end(), std::uint8_t{0});
    for (std::size_t i = 0; i < part_count; ++i)
        for (std::size_t k = 0; k < parts_[i].won.size(); ++k) {
            if (!parts_[i].won[k]) continue;
            won[parts_[i].snapped.place[k]] = 1;
            const PixelBox box(parts_[i].triangles[k], size);
            const DepthPyramid::Level& level = pyramid_.levels[0];
            for (int y = block_of(box.top); y <= block_of(box.bottom - 1); ++y)
                for (int x = block_of(box.left); x <= block_of(box.right - 1); ++x) {
                    const auto at = static_cast<std::uint32_t>(y * level.width + x);
                    if (is_dirty_[at]) continue;
                    is_dirty_[at] = 1;
                    dirty_.push_back(at);
                }
        }
}

void OcclusionImage<3>::refresh(double opacity) {
    conservative_ = opacity == 1;
    pyramid_.update(image_, dirty_, opacity);
    for (const std::uint32_t block : dirty_) is_dirty_[block] = 0;
    dirty_.clear();
}

BoxSight OcclusionImage<3>::look(const Box<3>& box) const {
    // The corners as (x w, y w, w): one, and what each side of the box adds.
    const Vec<3> extent = box.extent(), from = box.min - of_.plane.eye, to = box.max - of_.plane.eye;
    const Vec<3> far = glm::max(glm::abs(from), glm::abs(to));
    const auto& across = of_.plane.across;
    const Vec<3> first = of_.plane.project(box.min);
    std::array<Vec<3>, 3> sides;
    double size = 0;  // no term of a coordinate is larger
    for (int i = 0; i < 3; ++i) {
        sides[static_cast<std::size_t>(i)] = {across[0][i] * extent[i], across[1][i] * extent[i],
                                              across[2][i] * extent[i]};
        for (const Vec<3>& axis : across) size = std::max(size, std::abs(axis[i]) * far[i]);
    }
    std::array<Vec<3>, 8> corners;
    double least_w = std::numeric_limits<double>::infinity();
    const double rounding = 0x1p-40 * size;
    bool right = true, left = true, above = true, below = true;
    for (std::size_t i = 0; i < 8; ++i) {
        Vec<3>& p = corners[i] = first;
        for (std::size_t k = 0; k < 3; ++k)
            if (i >> k & 1) p += sides[k];
        least_w = std::min(least_w, p.z);
        right &= p.x > p.z + rounding;
        left &= -p.x > p.z + rounding;
        above &= p.y > p.z + rounding;
        below &= -p.y > p.z + rounding;
    }
    if (right || left || above || below) return BoxSight::outside;
    // Closer to the plane of the eye than this share of its size, rounding moves corners in the image.
    if (!(least_w > 0x1p-24 * size)) return BoxSight::seen;
    Box<2> seen;
    for (const Vec<3>& p : corners) {
        const double w = 1 / p.z;
        seen.add({p.x * w, -p.y * w});
    }
    const auto first_pixel = [](double at, int pixels) {
        return static_cast<int>(std::clamp(std::ceil((at + 1) * 0.5 * pixels - 0.5 - query_margin), 0.0, 1.0 * pixels));
    };
    const auto end_pixel = [](double at, int pixels) {
        return static_cast<int>(
            std::clamp(std::floor((at + 1) * 0.5 * pixels - 0.5 + query_margin) + 1, 0.0, 1.0 * pixels));
    };
    const int x = first_pixel(seen.min.x, image_.width), end_x = end_pixel(seen.max.x, image_.width),
              y = first_pixel(seen.min.y, image_.height), end_y = end_pixel(seen.max.y, image_.height);
    if (x >= end_x || y >= end_y) return BoxSight::outside;
    const PixelBlocks blocks{block_of(x), block_of(y), block_of(end_x - 1), block_of(end_y - 1)};
    return may_show(pyramid_, blocks, nearness_of(box, *of_.view, image_.size(), least_w)) ? BoxSight::seen
                                                                                           : BoxSight::hidden;
}

}  // namespace sightline
