// Occluder fusion by pixels, against all triangles on each pixel's ray.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/hiding.h"

#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "core/truth/reference.h"
#include "tests/scene/soup_scenes.h"
#include "tests/truth/image_judge.h"

namespace sightline::test {
namespace {

constexpr ImageSize small{40, 30};

/// What hides every primitive, by all that lies on the rays of its pixels.
struct OnRays {
    std::vector<IdImage> layers;                                     ///< the first most_layers of them
    std::vector<std::optional<std::set<std::uint32_t>>> in_front{};  ///< those that are at all of its pixels
    std::vector<std::uint8_t> visible{}, shown{};                    ///< in the first layer, in any
    std::size_t deepest = 0;
};

OnRays on_rays(const Scene<3>& scene, const View<3>& view) {
    const ImageJudge judge(scene, view, small);
    const std::size_t count = scene.primitives.size();
    const IdImage empty{small.width, small.height, std::vector<std::uint32_t>(std::size_t{40} * 30, none)};
    OnRays all{std::vector<IdImage>(most_layers, empty)};
    all.in_front.resize(count);
    all.visible.resize(count);
    all.shown.resize(count);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const std::vector<std::uint32_t> ids = judge.along(x, y);
            all.deepest = std::max(all.deepest, ids.size());
            std::set<std::uint32_t> nearer;
            for (std::size_t depth = 0; depth < ids.size(); ++depth) {
                const std::uint32_t id = ids[depth];
                if (depth < most_layers) all.layers[depth].ids[static_cast<std::size_t>(y * 40 + x)] = id;
                all.shown[id] |= depth < most_layers;
                all.visible[id] |= depth == 0;
                if (!all.in_front[id]) all.in_front[id] = nearer;
                std::erase_if(*all.in_front[id], [&](std::uint32_t other) { return !nearer.contains(other); });
                nearer.insert(id);
            }
        }
    return all;
}

TEST(HidingByPixels, IsExactWhereTheLayersGoThroughAndNeverCallsFusedWhatOneHides) {
    std::size_t exact = 0, deep = 0, fused = 0, alone = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Scene<3> scene = soup(seed % 2 == 0 ? 20 : 400, {0, 0, 0}, seed % 3 == 0 ? 1.2 : 0.6, seed);
        scene.two_sided.assign(scene.primitives.size(), 1);
        const OnRays all = on_rays(scene, make_view({{-2.5, 0.4, 0.3}, {0, 0, 0}, 50}, 4.0 / 3));
        const std::vector<Hiding> found = hiding(all.layers, scene.primitives.size());
        const bool through = all.deepest <= static_cast<std::size_t>(most_layers);
        (through ? exact : deep) += 1;
        for (std::size_t p = 0; p < found.size(); ++p) {
            ASSERT_EQ(found[p] == Hiding::none, all.visible[p] || !all.shown[p]) << p;
            if (found[p] == Hiding::none) continue;
            const bool by_one = !all.in_front[p]->empty();
            if (found[p] == Hiding::fused || through) {
                ASSERT_EQ(found[p] == Hiding::alone, by_one) << "seed " << seed << ", primitive " << p;
            }
            (by_one ? alone : fused) += 1;
        }
    }
    EXPECT_GE(exact, 5u);
    EXPECT_GE(deep, 5u);
    EXPECT_GT(fused, 50u);
    EXPECT_GT(alone, 50u);
}

}  // namespace
}  // namespace sightline::test
