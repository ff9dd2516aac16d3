// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/pixels.h"

#include <algorithm>
#include <array>

namespace sightline {

namespace {

/// The first of `from` pixels under pixel i of `to`.
int first_under(int i, int from, int to) { return static_cast<int>(std::int64_t{i} * from / to); }

}  // namespace

Pixels resized(const Pixels& pixels, int width, int height) {
    Pixels out{width, height, {}};
    out.colours.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const int top = first_under(y, pixels.height, height);
        const int bottom = std::max(top + 1, first_under(y + 1, pixels.height, height));
        for (int x = 0; x < width; ++x) {
            const int left = first_under(x, pixels.width, width);
            const int right = std::max(left + 1, first_under(x + 1, pixels.width, width));
            std::array<std::uint64_t, 4> sum{};
            for (int v = top; v < bottom; ++v)
                for (int u = left; u < right; ++u) {
                    const Colour& c = pixels.at(u, v);
                    sum[0] += c.r, sum[1] += c.g, sum[2] += c.b, sum[3] += c.a;
                }
            const auto count = static_cast<std::uint64_t>(bottom - top) * static_cast<std::uint64_t>(right - left);
            const auto mean = [&](int i) { return static_cast<std::uint8_t>((sum[i] + count / 2) / count); };
            out.colours.push_back({mean(0), mean(1), mean(2), mean(3)});
        }
    }
    return out;
}

}  // namespace sightline
