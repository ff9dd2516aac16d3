// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/query.h"

#include <algorithm>

#include "core/base/index.h"

namespace sightline {

namespace {

/// Goes down the pyramid wherever the shape may be seen.
class Descent {
public:
    Descent(const SeenShape& shape, const DepthImage& image, const DepthPyramid& pyramid, bool any)
        : shape_(shape), image_(image), pyramid_(pyramid), any_(any) {}

    void run() { visit(static_cast<int>(pyramid_.levels.size()) - 1, 0, 0); }

    std::uint32_t count = 0;
    std::optional<Pixel> witness;

private:
    void visit(int level, int block_x, int block_y) {
        const int side = DepthPyramid::block << level, x = block_x * side, y = block_y * side,
                  end_x = std::min(x + side, image_.width), end_y = std::min(y + side, image_.height);
        const float farthest = pyramid_.levels[static_cast<std::size_t>(level)].at(block_x, block_y);
        if (!shape_.everywhere && std::none_of(shape_.faces.begin(), shape_.faces.end(), [&](const SeenFace& face) {
                return !face.misses(x, y, end_x, end_y) && face.nearness(x, y, end_x, end_y) >= farthest;
            }))
            return;
        if (level == 0) {
            read(x, y, end_x, end_y);
            return;
        }
        const DepthPyramid::Level& below = pyramid_.levels[static_cast<std::size_t>(level) - 1];
        for (int i = 0; i < 4 && !(any_ && witness); ++i) {
            const int next_x = 2 * block_x + i % 2, next_y = 2 * block_y + i / 2;
            if (next_x < below.width && next_y < below.height) visit(level - 1, next_x, next_y);
        }
    }

    void read(int x, int y, int end_x, int end_y) {
        for (int row = y; row < end_y; ++row)
            for (int column = x; column < end_x; ++column) {
                const float there = image_.nearness[image_.index(column, row)];
                if (!shape_.everywhere &&
                    std::none_of(shape_.faces.begin(), shape_.faces.end(), [&](const SeenFace& face) {
                        return face.nearness(column, row) >= there && face.holds(column, row);
                    }))
                    continue;
                ++count;
                if (!witness) witness = Pixel{column, row};
                if (any_) return;
            }
    }

    const SeenShape& shape_;
    const DepthImage& image_;
    const DepthPyramid& pyramid_;
    bool any_;
};

}  // namespace

std::optional<Pixel> find_seen(const SeenShape& shape, const DepthImage& image, const DepthPyramid& pyramid) {
    Descent descent(shape, image, pyramid, true);
    descent.run();
    return descent.witness;
}

std::uint32_t count_seen(const SeenShape& shape, const DepthImage& image, const DepthPyramid& pyramid) {
    Descent descent(shape, image, pyramid, false);
    descent.run();
    return descent.count;
}

ShapeSight look_at(const SeenShape& shape, const DepthImage& image) {
    ShapeSight sight;
    for_covered(shape, image, [&](int x, int y, bool shows) {
        const std::uint32_t id = image.ids[image.index(x, y)];
        ++sight.pixels;
        sight.seen += shows;
        if (!shows && id != none) sight.hidden_by.push_back(id);
    });
    std::sort(sight.hidden_by.begin(), sight.hidden_by.end());
    sight.hidden_by.erase(std::unique(sight.hidden_by.begin(), sight.hidden_by.end()), sight.hidden_by.end());
    return sight;
}

}  // namespace sightline
