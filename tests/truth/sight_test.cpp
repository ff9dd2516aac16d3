// How one primitive is seen and what hides it, against looking in many directions and through every pixel.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// Distance along the ray from the eye in lengths of `d`; infinite where it misses.
double hit_at(const Primitive<2>& s, const Vec<2>& eye, const Vec<2>& d) {
    const Vec<2> along = s[1] - s[0], to = s[0] - eye;
    const double w = cross(d, along), t = cross(to, along) / w, u = cross(to, d) / w;
    return w != 0 && t > 0 && u >= 0 && u <= 1 ? t : std::numeric_limits<double>::infinity();
}

double sum(const PrimitiveSight& sight) {
    double total = sight.share;
    for (const Hider& hider : sight.hiders) total += hider.share;
    return total;
}

TEST(PrimitiveSight, InThePlaneTheSharesAreThoseOfManyDirections) {
    Random random(71);
    int hidden = 0, parts = 0, outside = 0;
    for (int i = 0; i < test::soak_count(60); ++i) {
        const test::Start start = test::random_start(random, 20);
        const auto& primitives = start.scene->primitives;
        if (primitives.empty()) continue;
        const View<2> view = make_view(start.view);
        const Reference reference = exact_reference(primitives, start.session().cells(), view);
        const auto own = static_cast<std::uint32_t>(random.below(primitives.size()));
        const PrimitiveSight sight = sight_of(*start.scene, view, reference, own);
        SCOPED_TRACE("scene " + std::to_string(i) + " segment " + std::to_string(own));
        ASSERT_EQ(sight.share > 0, reference.visible[own] != 0);
        ASSERT_EQ(sight.share > 0, !sight.pieces.empty());
        constexpr int directions = 20000;
        int total = 0;
        std::map<std::uint32_t, int> nearest;
        const double middle = std::atan2(view.forward().y, view.forward().x), pi = std::acos(-1.0);
        const double half = view.all_round ? pi : start.view.fov / 360 * pi;
        for (int k = 0; k < directions; ++k) {
            const double angle = middle + half * (2 * (k + 0.5) / directions - 1);
            const Vec<2> d(std::cos(angle), std::sin(angle));
            if (!std::isfinite(hit_at(primitives[own], view.eye, d))) continue;
            ++total;
            std::uint32_t first = own;
            double at = hit_at(primitives[own], view.eye, d);
            for (std::uint32_t p = 0; p < primitives.size(); ++p)
                if (const double other = hit_at(primitives[p], view.eye, d); other < at) {
                    first = p;
                    at = other;
                }
            ++nearest[first];
        }
        if (sight.unseen != Unseen::no) {
            ASSERT_LE(total, 2);
            ++outside;
            continue;
        }
        ASSERT_NEAR(sum(sight), 1, 1e-9);
        if (total < 200) continue;
        const double tolerance = 6.0 / total + 1e-6;
        ASSERT_NEAR(sight.share, double(nearest[own]) / total, tolerance);
        double before = 1 + 1e-9;
        for (const Hider& hider : sight.hiders) {
            ASSERT_NE(hider.primitive, own);
            ASSERT_LE(hider.share, before);
            before = hider.share;
            ASSERT_NEAR(hider.share, double(nearest[hider.primitive]) / total, tolerance);
            nearest.erase(hider.primitive);
        }
        nearest.erase(own);
        for (const auto& [primitive, count] : nearest) ASSERT_LE(count, 6) << primitive << " hides it too";
        hidden += sight.share == 0;
        parts += sight.hiders.size() > 1;
    }
    EXPECT_GT(hidden, 3);
    EXPECT_GT(parts, 5);
    EXPECT_GT(outside, 3);
}

TEST(PrimitiveSight, InSpaceThePixelsAreThoseWhoseRaysHitIt) {
    Random random(72);
    std::size_t covered = 0, off = 0, hidden = 0, turned = 0;
    for (int i = 0; i < test::soak_count(100); ++i) {
        test::Start3 start = test::random_start_3d(random, 30);
        Scene<3> large = *start.scene;  // so that one hides the other
        for (Primitive<3>& t : large.primitives) {
            const Vec<3> centre = (t[0] + t[1] + t[2]) / 3.0;
            for (Vec<3>& p : t) p = centre + (p - centre) * 6.0;
        }
        start.scene = std::make_shared<const Scene<3>>(std::move(large));
        start.settings.error_bound = 0.5;
        const auto& primitives = start.scene->primitives;
        if (primitives.empty()) continue;
        const Session<3> session = start.session();
        const View<3>& view = session.problem().view;
        const IdImage& image = session.reference().image;
        for (std::uint32_t own = 0; own < primitives.size(); ++own) {
            const PrimitiveSight sight = sight_of(*start.scene, view, session.reference(), own);
            ASSERT_EQ(sight.seen_pixels > 0, session.reference().visible[own] != 0);
            ASSERT_EQ(sight.seen_pixels, session.reference().pixels[own]);
            if (sight.unseen == Unseen::turned_away) {
                ASSERT_FALSE(faces(view, primitives[own]));
                ++turned;
            }
            if (sight.unseen != Unseen::no) continue;
            std::size_t total = 0;
            std::map<std::uint32_t, std::size_t> ids;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const Vec<3> d = pixel_centre(view, {image.width, image.height}, x, y) - view.eye;
                    if (!std::isfinite(test::hit_distance(primitives[own], view.eye, d))) continue;
                    ++total;
                    ++ids[image.at(x, y)];
                }
            covered += total;
            off += std::max(total, sight.pixels) - std::min(total, sight.pixels);
            if (total != sight.pixels) continue;  // a centre on its border
            ASSERT_NEAR(sum(sight), 1, 1e-9);
            for (const Hider& hider : sight.hiders)
                ASSERT_EQ(hider.share, double(ids[hider.primitive]) / double(total));
            hidden += sight.share == 0;
        }
    }
    EXPECT_GT(covered, 10000u);
    EXPECT_LT(off * 1000, covered);
    EXPECT_GT(hidden, 20u);
    EXPECT_GT(turned, 20u);
}

}  // namespace
}  // namespace sightline
