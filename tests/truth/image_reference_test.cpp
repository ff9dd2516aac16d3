// What an image of ids says about primitives, cells and budgets, against brute force.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numeric>

#include "core/draw/wrong_picture.h"
#include "core/measure/metrics.h"
#include "core/measure/wrong_region.h"
#include "tests/scene/soup_scenes.h"
#include "tests/truth/image_judge.h"

namespace sightline::test {
namespace {

constexpr ImageSize size{80, 60};

/// Small triangles, large ones through many cells, and a floor under all of them.
Scene<3> furnished(std::uint64_t seed) {
    Scene<3> scene = soup(60, {0, 0, 0}, 0.4, seed);
    for (const Primitive<3>& large : soup(8, {0, 0, 0}, 1, seed + 100).primitives) scene.primitives.push_back(large);
    scene.primitives.push_back({Vec<3>(-2, -2, -0.5), Vec<3>(2, -2, -0.5), Vec<3>(2, 2, -0.5)});
    scene.primitives.push_back({Vec<3>(-2, -2, -0.5), Vec<3>(2, 2, -0.5), Vec<3>(-2, 2, -0.5)});
    scene.two_sided.assign(scene.primitives.size(), 1);
    return scene;
}

View<3> some_view() { return make_view({{-1.8, 0.4, 0.3}, {0, 0, -0.1}, 60}, 4.0 / 3); }

IdImage image_by_rays(const Scene<3>& scene, const View<3>& view) {
    const ImageJudge judge(scene, view, size);
    IdImage image{size.width, size.height, {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto along = judge.along(x, y);
            image.ids.push_back(along.empty() ? none : along[0]);
        }
    return image;
}

class ImageReference : public ::testing::TestWithParam<Tessellation> {
protected:
    CellComplex<3> cells_of(const Scene<3>& scene) const {
        TessellationSettings settings;
        settings.tessellation = GetParam();
        settings.error_bound = 0.15;
        return build_cells(scene, settings);
    }
};

TEST_P(ImageReference, PrimitivesAreVisibleWhereAPixelShowsThem) {
    const Scene<3> scene = furnished(1);
    const View<3> view = some_view();
    const IdImage image = image_by_rays(scene, view);
    const Reference reference = image_reference(image, scene, cells_of(scene), view);
    EXPECT_EQ(reference.name, "item buffer 80x60");
    EXPECT_EQ(reference.image.ids, image.ids);
    std::size_t visible = 0;
    for (std::uint32_t id = 0; id < scene.primitives.size(); ++id) {
        const auto pixels = std::count(image.ids.begin(), image.ids.end(), id);
        EXPECT_EQ(reference.pixels[id], pixels);
        EXPECT_EQ(reference.visible[id], pixels > 0);
        visible += pixels > 0;
    }
    EXPECT_EQ(reference.count, visible);
    EXPECT_GT(visible, 20u);
    EXPECT_LT(visible, scene.primitives.size());
}

TEST_P(ImageReference, TheShareOfACellIsThatOfThePixelsWhosePointsLieInIt) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Scene<3> scene = furnished(seed);
        const View<3> view = some_view();
        const IdImage image = image_by_rays(scene, view);
        const CellComplex<3> cells = cells_of(scene);
        const Reference reference = image_reference(image, scene, cells, view);
        const ImageJudge judge(scene, view, size);
        std::vector<double> surely(cells.cell_count(), 0), perhaps(cells.cell_count(), 0);
        double covered = 0, doubtful = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const std::uint32_t id = image.at(x, y);
                if (id == none) continue;
                ++covered;
                const Vec<3> through = pixel_centre(view, size, x, y);
                const Vec<3> p = view.eye + (through - view.eye) / judge.nearness(id, x + 0.5, y + 0.5);
                // A little to all sides: where the cells differ, the point is on a border up to rounding.
                std::vector<std::uint32_t> found;
                for (int i = 0; i < 9; ++i) {
                    const double e = 1e-9;
                    const Vec<3> aside(i & 1 ? e : -e, i & 2 ? e : -e, i & 4 ? e : -e);
                    found.push_back(locate(cells, i == 8 ? p : p + aside));
                }
                std::sort(found.begin(), found.end());
                found.erase(std::unique(found.begin(), found.end()), found.end());
                ASSERT_NE(found.back(), none);
                for (const std::uint32_t cell : found) ++perhaps[cell];
                if (found.size() == 1) ++surely[found[0]];
                doubtful += found.size() > 1;
            }
        EXPECT_LT(doubtful, covered / 100);
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            EXPECT_GE(reference.cell_share[cell] * covered, surely[cell] - 1e-6) << "cell " << cell;
            EXPECT_LE(reference.cell_share[cell] * covered, perhaps[cell] + 1e-6) << "cell " << cell;
        }
        const double sum = std::accumulate(reference.cell_share.begin(), reference.cell_share.end(), 0.0);
        EXPECT_NEAR(sum, 1, 1e-3);
        EXPECT_GT(std::count_if(surely.begin(), surely.end(), [](double n) { return n > 0; }), 20);
    }
}

TEST_P(ImageReference, AnImageOfNothingHasNoShares) {
    const Scene<3> scene = furnished(1);
    const View<3> away = make_view({{-3, 0, 0}, {-4, 0, 0}, 60}, 4.0 / 3);
    const Reference reference = image_reference(image_by_rays(scene, away), scene, cells_of(scene), away);
    EXPECT_EQ(reference.count, 0u);
    for (const double share : reference.cell_share) EXPECT_EQ(share, 0);
    EXPECT_EQ(wrong_pixels(reference, {}), 0);
}

INSTANTIATE_TEST_SUITE_P(Cells, ImageReference, ::testing::Values(Tessellation::delaunay, Tessellation::tree));

TEST(ImageMeasures, APixelIsWrongWhenItsPrimitiveIsNotRendered) {
    const Scene<3> scene = furnished(2);
    const View<3> view = some_view();
    const Reference reference =
        image_reference(image_by_rays(scene, view), scene, build_cells(scene, TessellationSettings{}), view);
    Random random(3);
    std::vector<Met> touched;
    std::vector<bool> rendered(scene.primitives.size());
    for (std::uint32_t id = 0; id < scene.primitives.size(); ++id) {
        const std::uint64_t kind = random.below(3);
        rendered[id] = kind == 0;
        if (kind == 0) touched.push_back({id, false});
        if (kind == 1) touched.push_back({id, true});
    }
    const Pixels picture =
        wrong_picture(reference, wrong_mask(reference.image, rendered_mask(touched, scene.primitives.size())), scene);
    EXPECT_EQ(picture.width, size.width);
    EXPECT_EQ(picture.height, size.height);
    int wrong = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::uint32_t id = reference.image.at(x, y);
            const bool right = id == none || rendered[id];
            wrong += !right;
            const Colour shown = picture.at(x, y);
            if (!right) EXPECT_TRUE(shown.r >= 185 && shown.g == 0 && shown.b == 0) << x << ' ' << y;
            if (id == none) EXPECT_EQ(shown, (Colour{255, 255, 255})) << x << ' ' << y;
            if (right && id != none)  // a ghost, grey and pale
                EXPECT_TRUE(shown.r >= 200 && shown.r < 255 && shown.r == shown.g && shown.g == shown.b)
                    << x << ' ' << y;
        }
    EXPECT_GT(wrong, 100);
    EXPECT_DOUBLE_EQ(wrong_pixels(reference, touched), wrong / double(size.width * size.height));
    EXPECT_EQ(wrong_pixels(Reference{}, {}), 0);
}

TEST(ImageMeasures, TheLayeringNumberIsThatOfTheFirstImageThatShowsIt) {
    const std::uint32_t no = none;
    const std::vector<IdImage> layers{{3, 1, {4, no, 1}}, {3, 1, {0, no, 4}}, {3, 1, {1, no, 2}}};
    EXPECT_EQ(layering_numbers(layers, 6), (std::vector<std::uint32_t>{2, 1, 3, 0, 1, 0}));
    EXPECT_EQ(layering_numbers(std::span<const IdImage>{}, 2), (std::vector<std::uint32_t>{0, 0}));
}

}  // namespace
}  // namespace sightline::test
