// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/plots.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/trig.h"

namespace sightline {

std::vector<Plot> plots_by_distance(std::size_t count) {
    const double radius = std::sqrt(static_cast<double>(count) / pi) + 2;
    const int half = static_cast<int>(radius) + 1;
    std::vector<Plot> plots;
    for (int y = -half; y < half; ++y)
        for (int x = -half; x < half; ++x)
            if (const Plot plot{x, y}; plot.distance2() < radius * radius) plots.push_back(plot);
    std::sort(plots.begin(), plots.end(), [](const Plot& a, const Plot& b) {
        return std::tuple(a.distance2(), a.y, a.x) < std::tuple(b.distance2(), b.y, b.x);
    });
    return plots;
}

}  // namespace sightline
