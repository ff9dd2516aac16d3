// What a run misses, by regions, objects and pixels: recounted by hand over random sessions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/missed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/measure/metrics.h"
#include "core/session/counterfactual.h"
#include "core/session/explain_primitive.h"
#include "core/session/object_report.h"
#include "core/session/pixel_history.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// With a tight budget, so that something is missed, and somewhere along the run.
template <int D>
Session<D> cut_session(Session<D> session, Random& random) {
    Settings settings = session.settings();
    settings.budget = parse_budget(std::to_string(1 + random.below(12)));
    session.change(settings);
    session.run();
    if (random.below(3) == 0) session.seek(random.below(session.recorded() + 1));
    return session;
}

template <int D>
void expect_recounted(const Session<D>& session) {
    const Missed found = missed_by(session);
    const IdImage& exact = session.reference().image;
    const std::vector<std::uint8_t> rendered = rendered_mask(session.met(), session.scene().primitives.size());
    std::map<std::uint32_t, std::uint32_t> wrong;  // of each primitive
    for (const std::uint32_t id : exact.ids)
        if (id != none && !rendered[id]) ++wrong[id];
    std::map<std::uint32_t, std::uint32_t> told;
    std::size_t sum = 0, before = static_cast<std::size_t>(-1);
    for (const WrongRegion& region : found.regions) {
        EXPECT_LE(region.pixels, before);
        before = region.pixels;
        std::uint32_t in_region = 0;
        for (const PixelCount& count : region.primitives) {
            told[count.primitive] += count.pixels;
            in_region += count.pixels;
        }
        EXPECT_EQ(in_region, region.pixels);
        EXPECT_TRUE(std::is_sorted(region.primitives.begin(), region.primitives.end(),
                                   [](const auto& a, const auto& b) { return a.pixels > b.pixels; }));
        EXPECT_LE(region.pixels, static_cast<std::uint32_t>((region.box[1] - region.box[0] + 1) *
                                                            (region.box[3] - region.box[2] + 1)));
        sum += region.pixels;
    }
    EXPECT_EQ(told, wrong);
    EXPECT_EQ(found.wrong, sum);
    EXPECT_EQ(found.pixels, exact.ids.size());
    EXPECT_DOUBLE_EQ(found.share(), wrong_pixels(session.reference(), session.met()));
    std::set<std::uint32_t> primitives;
    for (const PixelCount& count : found.primitives) {
        EXPECT_FALSE(rendered[count.primitive]);
        EXPECT_EQ(count.pixels, wrong.count(count.primitive) ? wrong[count.primitive] : 0);
        primitives.insert(count.primitive);
    }
    for (std::uint32_t p = 0; p < rendered.size(); ++p)
        if (session.reference().visible[p] && !rendered[p]) EXPECT_TRUE(primitives.count(p)) << p;
}

TEST(Missed, RegionsAndPrimitivesAreThoseOfTheImage) {
    Random random(2001);
    for (int i = 0; i < test::soak_count(40); ++i) {
        expect_recounted<2>(cut_session(test::random_start(random).session(), random));
        expect_recounted<3>(cut_session(test::random_start_3d(random).session(), random));
    }
}

/// What the hunt ends in: the run as it is never renders what is told as missed, and each change that is told to bring
/// it does so in a session of its own.
template <int D>
int expect_verdicts_hold(const Session<D>& session) {
    int checked = 0;
    const Missed found = missed_by(session);
    for (std::size_t r = 0; r < std::min<std::size_t>(found.regions.size(), 2); ++r) {
        const std::uint32_t primitive = found.regions[r].primitives.front().primitive;
        const PrimitiveExplanation e = explain_primitive(session, primitive);
        EXPECT_EQ(e.met_at, 0u);
        const Counterfactuals all = counterfactuals(session, primitive_item(primitive));
        EXPECT_EQ(all.now.step, 0u);
        for (const auto& [change, outcome] : all.changes) {
            if (outcome.step == 0) continue;
            Session<D> other = session;
            Settings settings = other.settings();
            apply_setting(settings, change, session.method());
            other.change(settings);
            other.seek(outcome.step);
            EXPECT_TRUE(other.traversal().drawn().has(primitive)) << change;
            other.back();
            EXPECT_FALSE(rendered_mask(other.met(), session.scene().primitives.size())[primitive]) << change;
            ++checked;
        }
    }
    return checked;
}

TEST(Missed, EveryVerdictAgreesWithARunOfItsOwn) {
    Random random(2002);
    int checked = 0;
    for (int i = 0; i < test::soak_count(25); ++i) {
        const auto at_the_end = [&](auto session) {
            session.run();
            return session;
        };
        checked += expect_verdicts_hold<2>(at_the_end(cut_session(test::random_cell_start(random).session(), random)));
        checked += expect_verdicts_hold<3>(at_the_end(cut_session(test::random_start_3d(random).session(), random)));
    }
    EXPECT_GT(checked, 20);
}

template <int D>
void expect_object_sums(const Session<D>& session) {
    const std::vector<ObjectReport> reports = object_reports(session);
    const Objects& objects = session.objects();
    ASSERT_EQ(reports.size(), objects.names.size());
    const Missed found = missed_by(session);
    std::size_t primitives = 0, rendered = 0, missed_count = 0, wrong = 0;
    for (const ObjectReport& report : reports) {
        primitives += report.primitives;
        rendered += report.rendered;
        missed_count += report.missed;
        wrong += report.wrong;
        // A box that is hidden holds nothing that is seen.
        if (report.box != BoxSight::seen) EXPECT_EQ(report.pixels, 0u);
        EXPECT_EQ(report.rendered > 0, report.first_step > 0);
        EXPECT_LE(report.first_step, report.last_step);
        EXPECT_FALSE(verdict_words<D>(report).empty());
    }
    EXPECT_EQ(primitives, session.scene().primitives.size());
    EXPECT_EQ(rendered, session.counters().rendered_count);
    EXPECT_EQ(wrong, found.wrong);
    EXPECT_EQ(missed_count, session.reference().count - session.visible_rendered());
}

TEST(ObjectReport, AddsUpToTheWholeRun) {
    Random random(2003);
    for (int i = 0; i < test::soak_count(30); ++i) {
        expect_object_sums<2>(cut_session(test::random_start(random).session(), random));
        expect_object_sums<3>(cut_session(test::random_start_3d(random).session(), random));
    }
}

TEST(PixelHistory, ItsLayersAreWhatTheRayMeets) {
    Random random(2004);
    int owned = 0;
    for (int i = 0; i < test::soak_count(20); ++i) {
        const Session<3> session = cut_session(test::random_start_3d(random).session(), random);
        const IdImage& image = session.reference().image;
        const std::vector<std::uint8_t> rendered = rendered_mask(session.met(), session.scene().primitives.size());
        for (std::size_t k = 0; k < image.ids.size(); ++k) {
            if (image.ids[k] == none && random.below(20) != 0) continue;
            const int x = static_cast<int>(k) % image.width, y = static_cast<int>(k) / image.width;
            const PixelHistory history = pixel_history(session, x, y);
            EXPECT_EQ(history.should_own, image.at(x, y));
            if (history.should_own == none) {
                EXPECT_TRUE(history.layers.empty());
                continue;
            }
            ASSERT_FALSE(history.layers.empty());
            EXPECT_EQ(history.layers.front().primitive, history.should_own);
            if (rendered[history.should_own]) EXPECT_EQ(history.owns, history.should_own);
            if (history.owns != none) EXPECT_TRUE(rendered[history.owns]);
            for (std::size_t layer = 2; layer < history.layers.size(); ++layer)
                EXPECT_GE(history.layers[layer].distance, history.layers[layer - 1].distance);
            ++owned;
        }
        EXPECT_THROW(pixel_history(session, image.width, 0), InputError);
    }
    EXPECT_GT(owned, 50);
}

/// As a card may decide it: of two triangles that lie equally near, the reference shows one, the run's own image the
/// other.
TEST(Missed, APixelSaysThatItIsATie) {
    for (const double behind : {0.0, 0.25}) {
        Scene<3> scene;
        scene.primitives = {{Vec<3>{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                            {Vec<3>{0, 0, behind}, {0, 1, behind}, {1, 0, behind}}};
        const DrawIds the_second = [](const Scene<3>& drawn, const View<3>& view, const ImageSize& size, int layers) {
            std::vector<IdImage> images = test::cast_rays(drawn, view, size, layers);
            for (std::uint32_t& id : images[0].ids)
                if (id == 0) id = 1;
            return images;
        };
        Settings settings;
        settings.method = "boxes";
        Session<3> session(std::make_shared<const Scene<3>>(scene), {{0.25, 0.25, -2}, {0.25, 0.25, 0}, 40}, settings,
                           method_table<3>(), the_second);
        session.run();
        ASSERT_EQ(session.counters().rendered_count, 1u);
        const IdImage& image = session.reference().image;
        const PixelHistory history = pixel_history(session, image.width / 2, image.height / 2);
        EXPECT_EQ(history.should_own, 1u);
        EXPECT_EQ(history.owns, 0u);
        EXPECT_EQ(history.tie, behind == 0);
    }
}

}  // namespace
}  // namespace sightline
