// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/item_image.h"

#include <algorithm>
#include <limits>

#include "core/base/index.h"

namespace sightline {

namespace {

/// Of depths, on top of what queries widen by.
constexpr double more_depth = 1 + 0x1p-20;
/// In pixels, likewise: thrice that of queries, whose edges meet in corners up to twice as far out.
constexpr double more_pixels = 3 * query_margin;

/// Who shows at each pixel so far.
class Owners {
public:
    Owners(std::size_t pixels, ItemWins wins) : owners_(pixels, none), wins_(wins) {
        if (wins_ == ItemWins::nearest) nearness_.assign(pixels, -std::numeric_limits<double>::infinity());
    }
    void fill(std::uint32_t shape) {
        if (wins_ == ItemWins::last)
            owners_.assign(owners_.size(), shape);
        else if (everywhere_ == none)
            everywhere_ = shape;
    }
    void put(std::size_t pixel, double nearness, std::uint32_t shape) {
        if (wins_ == ItemWins::nearest) {
            if (!(nearness > nearness_[pixel])) return;
            nearness_[pixel] = nearness;
        }
        owners_[pixel] = shape;
    }
    std::vector<std::uint32_t> take() {
        if (everywhere_ != none) std::replace(owners_.begin(), owners_.end(), none, everywhere_);
        return std::move(owners_);
    }

private:
    std::vector<std::uint32_t> owners_;
    std::vector<double> nearness_;
    ItemWins wins_;
    std::uint32_t everywhere_ = none;
};

int cut_up(int x) { return (x + DepthPyramid::block - 1) / DepthPyramid::block; }

void draw_face(Owners& owners, const SeenFace& face, std::uint32_t shape, const DepthImage& image,
               const DepthPyramid& pyramid) {
    constexpr int side = DepthPyramid::block;
    for (int block_y = face.top / side; block_y < cut_up(face.bottom); ++block_y)
        for (int block_x = face.left / side; block_x < cut_up(face.right); ++block_x) {
            const int x = std::max(block_x * side, face.left), y = std::max(block_y * side, face.top),
                      end_x = std::min((block_x + 1) * side, face.right),
                      end_y = std::min((block_y + 1) * side, face.bottom);
            if (face.misses(x, y, end_x, end_y) ||
                face.nearness(x, y, end_x, end_y) < pyramid.levels.front().at(block_x, block_y))
                continue;
            for (int row = y; row < end_y; ++row)
                for (int column = x; column < end_x; ++column) {
                    const std::size_t at = image.index(column, row);
                    const double nearness = face.nearness(column, row);
                    if (nearness >= image.nearness[at] && face.holds(column, row)) owners.put(at, nearness, shape);
                }
        }
}

/// Cut to the tile.
SeenFace widened(SeenFace face, const Tile& tile) {
    for (SeenFace::Edge& e : face.edges) e.c += more_pixels * (std::abs(e.a) + std::abs(e.b));
    face.left = std::max(face.left - 1, tile.left);
    face.top = std::max(face.top - 1, tile.top);
    face.right = std::min(face.right + 1, tile.right);
    face.bottom = std::min(face.bottom + 1, tile.bottom);
    face.nearness_0 += more_pixels * (std::abs(face.nearness_x) + std::abs(face.nearness_y));
    face.nearness_0 *= more_depth;
    face.nearness_x *= more_depth;
    face.nearness_y *= more_depth;
    face.nearest *= more_depth;
    return face;
}

}  // namespace

std::vector<std::uint32_t> draw_items(std::span<const LineShape> shapes, const PixelLine& line, ItemWins wins) {
    Owners owners(static_cast<std::size_t>(line.width()), wins);
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        if (shapes[i].everywhere) {
            owners.fill(i);
            continue;
        }
        for (const LineShape::Piece& piece : shapes[i].pieces)
            for (int x = piece.first; x < piece.end; ++x) {
                const auto at = static_cast<std::size_t>(x);
                if (piece.nearness(x) >= line.nearness[at]) owners.put(at, piece.nearness(x), i);
            }
    }
    return owners.take();
}

std::vector<std::uint32_t> draw_items(std::span<const SeenShape> shapes, const DepthImage& image,
                                      const DepthPyramid& pyramid, ItemWins wins) {
    Owners owners(image.ids.size(), wins);
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        if (shapes[i].everywhere) {
            owners.fill(i);
            continue;
        }
        for (const SeenFace& face : shapes[i].faces) draw_face(owners, face, i, image, pyramid);
    }
    return owners.take();
}

bool tile_may_show(std::span<const LineShape> shapes, const PixelLine& line, const Tile& tile) {
    const auto piece_may = [&](const LineShape::Piece& piece) {
        // A pixel more on each side.
        for (int x = std::max(piece.first - 1, tile.left); x < std::min(piece.end + 1, tile.right); ++x) {
            const double nearness = piece.nearness_0 + piece.nearness_x * x + std::abs(piece.nearness_x);
            if (std::min(piece.nearest, nearness) * more_depth >= line.nearness[static_cast<std::size_t>(x)])
                return true;
        }
        return false;
    };
    return std::any_of(shapes.begin(), shapes.end(), [&](const LineShape& shape) {
        return shape.everywhere || std::any_of(shape.pieces.begin(), shape.pieces.end(), piece_may);
    });
}

bool tile_may_show(std::span<const SeenShape> shapes, const DepthImage& image, const Tile& tile) {
    const auto face_may = [&](const SeenFace& seen) {
        if (seen.right + 1 <= tile.left || seen.left - 1 >= tile.right || seen.bottom + 1 <= tile.top ||
            seen.top - 1 >= tile.bottom)
            return false;
        const SeenFace face = widened(seen, tile);
        for (int y = face.top; y < face.bottom; ++y)
            for (int x = face.left; x < face.right; ++x)
                if (face.nearness(x, y) >= image.nearness[image.index(x, y)] && face.holds(x, y)) return true;
        return false;
    };
    return std::any_of(shapes.begin(), shapes.end(), [&](const SeenShape& shape) {
        return shape.everywhere || std::any_of(shape.faces.begin(), shape.faces.end(), face_may);
    });
}

}  // namespace sightline
