// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/up_axis.h"

#include <algorithm>
#include <array>

#include "core/base/number.h"

namespace sightline {

namespace {

constexpr int levels = 128;
constexpr double least_ground = 0.5, least_lead = 4, low = 0.5;
constexpr const char* names[] = {"x", "y", "z"};

/// The largest flat area at one height in the lower half, seen from above, as a share of the footprint. What lies
/// higher is the top of a thing, not ground to stand on.
double ground(const Scene<3>& scene, const Box<3>& box, int up) {
    const Vec<3> extent = box.extent();
    const double footprint = extent[(up + 1) % 3] * extent[(up + 2) % 3];
    if (!(footprint > 0) || !(extent[up] > 0)) return 0;
    std::array<double, levels + 1> area{};
    for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
        const Primitive<3>& t = scene.primitives[i];
        const Vec<3> twice = glm::cross(t[1] - t[0], t[2] - t[0]);
        if (!(std::abs(twice[up]) >= 0.999 * std::sqrt(glm::dot(twice, twice)))) continue;
        if (twice[up] < 0 && !shows_both_sides(scene, i)) continue;
        const double height = ((t[0][up] + t[1][up] + t[2][up]) / 3 - box.min[up]) / extent[up];
        if (height > low) continue;
        area[static_cast<std::size_t>(std::clamp(height, 0.0, 1.0) * levels)] += std::abs(twice[up]) / 2;
    }
    return std::min(1.0, *std::max_element(area.begin(), area.end()) / footprint);
}

}  // namespace

std::optional<UpGuess> guess_up(const Scene<3>& scene, int custom) {
    const int other = 3 - custom;
    if (scene.primitives.empty()) return std::nullopt;
    int far = 0, near_axis = 0;
    for (int axis = 0; axis < 3; ++axis) {
        far += scene.origin[axis] != 0;
        if (scene.origin[axis] == 0) near_axis = axis;
    }
    if (far == 2 && near_axis == other)
        return UpGuess{other, std::string("the model lies far from zero in ") + names[(other + 1) % 3] + " and " +
                                  names[(other + 2) % 3] + " only"};
    if (far == 2) return std::nullopt;
    const Box<3> box = bounds<3>(scene.primitives);
    if (!(box.extent()[other] > 0) || box.extent()[other] >= box.longest_side()) return std::nullopt;
    const double as_is = ground(scene, box, custom), turned = ground(scene, box, other);
    const bool flatter = box.extent()[other] < box.extent()[custom] / 2;
    if (turned < least_ground || (turned < least_lead * as_is && !flatter)) return std::nullopt;
    return UpGuess{other, "flat ground across it covers " + short_number(std::floor(100 * turned)) + " % of the model"};
}

void turn_up(Scene<3>& scene, Up up, bool known) {
    if (up >= Up::x) scene.up_axis = static_cast<int>(up) - static_cast<int>(Up::x);
    if (up != Up::automatic || known) return;
    const std::string custom = names[scene.up_axis];
    const std::optional<UpGuess> guess = guess_up(scene, scene.up_axis);
    if (!guess) return;
    scene.up_axis = guess->axis;
    scene.warnings.push_back(std::string("up is taken as ") + names[guess->axis] + ": " + guess->why + "; --up " +
                             custom + " changes it");
}

}  // namespace sightline
