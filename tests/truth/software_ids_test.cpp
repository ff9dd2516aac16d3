// References without OpenGL: who draws them, and that a session obeys the setting.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/software_ids.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/session/settings_table.h"
#include "core/truth/truth.h"
#include "tests/scene/soup_scenes.h"
#include "tests/session/session_3d_support.h"
#include "tests/truth/image_judge.h"

namespace sightline::test {
namespace {

constexpr ImageSize asked_of_software{80, 60};

View<3> software_view() { return make_view({{-1.8, 0.4, 0.3}, {0, 0, -0.1}, 60}, 4.0 / 3); }

TEST(SoftwareIds, LayersAreAllThatRaysMeetNearestFirst) {
    const Scene<3> scene = soup(40, {0, 0, 0}, 0.6, 1);
    const auto images = draw_ids_in_software(scene, software_view(), asked_of_software, 6);
    ASSERT_GT(images.size(), 2u);
    const ImageJudge judge(scene, software_view(), asked_of_software);
    int wrong = 0, met = 0;
    for (int y = 0; y < asked_of_software.height; ++y)
        for (int x = 0; x < asked_of_software.width; ++x) {
            const auto along = judge.along(x, y);
            met += !along.empty();
            for (std::size_t i = 0; i < images.size(); ++i) {
                const std::uint32_t seen = images[i].at(x, y), there = i < along.size() ? along[i] : none;
                if (seen == there) continue;
                // One undecided edge shifts all layers behind it.
                const bool near_edge = std::any_of(along.begin(), along.end(), [&](std::uint32_t id) {
                    return judge.edge_distance(id, x + 0.5, y + 0.5) <= 1.0 / 128;
                });
                wrong += !near_edge && !judge.undecided(seen, there, x, y);
                break;
            }
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(met, 300);
    for (const IdImage& image : images) EXPECT_TRUE(image.software);
}

TEST(SoftwareIds, DrawWhereAPersonWantsThemOrWhereThereIsNoOpenGl) {
    int by_opengl = 0;
    const DrawIds opengl = [&](const Scene<3>&, const View<3>&, const ImageSize& size, int) {
        ++by_opengl;
        return std::vector<IdImage>{{size.width, size.height, std::vector<std::uint32_t>(80 * 60, none)}};
    };
    const Scene<3> scene = soup(10, {0, 0, 0}, 0.6, 1);
    const auto software = [&](ReferenceBy by, const DrawIds& given) {
        return drawing_of(by, given)(scene, software_view(), asked_of_software, 1).front().software;
    };
    EXPECT_FALSE(software(ReferenceBy::opengl, opengl));
    EXPECT_EQ(by_opengl, 1);
    EXPECT_TRUE(software(ReferenceBy::software, opengl));
    EXPECT_TRUE(software(ReferenceBy::opengl, {}));
    EXPECT_EQ(by_opengl, 1);
}

TEST(SoftwareIds, ASessionObeysTheSettingAndSaysWhoDrew) {
    const auto scene = std::make_shared<const Scene<3>>(soup(60, {0, 0, 0}, 0.6, 2));
    const ViewSpec<3> spec{{-1.8, 0.4, 0.3}, {0, 0, -0.1}, 60};
    Settings settings;
    settings.reference_size = asked_of_software;
    Session<3> session(scene, spec, settings, method_table<3>(), cast_rays);
    EXPECT_EQ(session.reference().name, "item buffer 40x30");
    apply_setting(settings, "reference=software");
    session.change(settings);
    EXPECT_EQ(session.reference().name, "software item buffer 80x60");
    EXPECT_EQ(session.reference().visible,
              visible_set<3>(*scene, make_view(spec, 4.0 / 3), asked_of_software, draw_ids_in_software));
    std::size_t first = 0, ranked = 0;
    for (const std::uint32_t number : session.layering()) {
        first += number == 1;
        ranked += number > 0;
    }
    EXPECT_EQ(first, session.reference().count);
    EXPECT_GT(ranked, first);
    // Without OpenGL: a state that asks for it opens all the same.
    settings.reference = ReferenceBy::opengl;
    EXPECT_EQ(Session<3>(scene, spec, settings).reference().name, "software item buffer 80x60");
}

}  // namespace
}  // namespace sightline::test
