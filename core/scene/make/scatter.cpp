// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/make/scatter.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/scene/make/plots.h"

namespace sightline {

namespace {

/// No two discs meet, nor do things in them that are rounded to floats.
constexpr double gap_between_stands = 0.05;
constexpr int throws_per_plot = 7;

bool closer(const Vec<2>& a, const Vec<2>& b, double distance) { return glm::dot(a - b, a - b) < distance * distance; }

}  // namespace

std::vector<Stand> scatter(std::uint64_t seed, std::size_t count, double smallest, double largest,
                           std::span<const Vec<2>> free, double clearance) {
    const double side = 4 * largest;  // a disc can only meet those of its own plot and of the eight round it
    std::vector<Stand> stands;
    std::map<std::pair<int, int>, std::vector<std::size_t>> in_plot;
    for (std::size_t plots = count / 3 + 16; stands.size() < count; plots *= 2) {
        stands.clear();
        in_plot.clear();
        for (const Plot& plot : plots_by_distance(plots)) {
            Random random = plot.random(seed);
            for (int k = 0; k < throws_per_plot && stands.size() < count; ++k) {
                const double radius = random.uniform(smallest, largest);
                const double y_in_plot = random.unit(), x_in_plot = random.unit();  // not as arguments: any order
                const Vec<2> centre = side * Vec<2>(plot.x + x_in_plot, plot.y + y_in_plot);
                bool open = std::none_of(free.begin(), free.end(),
                                         [&](const Vec<2>& p) { return closer(p, centre, radius + clearance); });
                for (int x = plot.x - 1; x <= plot.x + 1 && open; ++x)
                    for (int y = plot.y - 1; y <= plot.y + 1 && open; ++y)
                        if (const auto near = in_plot.find({x, y}); near != in_plot.end())
                            for (const std::size_t i : near->second)
                                open = open && !closer(stands[i].centre, centre,
                                                       stands[i].radius + radius + gap_between_stands);
                if (!open) continue;
                in_plot[{plot.x, plot.y}].push_back(stands.size());
                stands.push_back({centre, radius, Random(random.bits())});
            }
        }
    }
    return stands;
}

}  // namespace sightline
