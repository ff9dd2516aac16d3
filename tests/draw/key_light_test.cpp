// What a term of a key lights up: against the records, in two and three dimensions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/key_light.h"

#include <gtest/gtest.h>

#include "core/base/number.h"
#include "core/session/explain.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"

namespace sightline {
namespace {

template <int D>
bool has_corner(const CellComplex<D>& cells, std::uint32_t cell, const Vec<D>& point) {
    for (const HalfFacet& half : cells.facets_of(cell))
        for (const std::uint32_t corner : cells.points_of_facet(half.facet()))
            if (cells.points[corner] == point) return true;
    return false;
}

/// The sum in pieces reads as its terms say, and each term lights what it is computed from.
template <int D>
void check_update(const Session<D>& session, const Considered& update, int digits) {
    const CellComplex<D>& cells = session.cells();
    const KeyExplanation& key = *update.key;
    ASSERT_EQ(key.parts.front().text, "ρ = ");
    ASSERT_TRUE(key.sum().ends_with(" = " + short_number(test::term(key, "unpenalised"), digits)));
    const auto lines = [&](KeyAbout about) { return key_light(session, light_of(update, about)); };
    for (const KeyPart& part : key.parts) {
        const bool term = part.about != KeyAbout::nothing;
        EXPECT_EQ(lines(part.about).empty(), !term);
        EXPECT_EQ(part.name.empty(), !term);
        if (part.about == KeyAbout::angle) EXPECT_EQ(part.text, short_number(test::term(key, "weight"), digits));
    }
    for (const KeyAbout about : {KeyAbout::content, KeyAbout::handed_on})
        for (const LightLine<D>& line : lines(about))
            for (const Vec<D>& point : line.points) EXPECT_TRUE(has_corner(cells, update.from.id, point));
    for (const LightLine<D>& line : lines(KeyAbout::own))
        for (const Vec<D>& point : line.points) EXPECT_TRUE(has_corner(cells, update.item.id, point));
    for (const KeyAbout about : {KeyAbout::angle, KeyAbout::star}) {
        const auto shown = lines(about);
        ASSERT_GE(shown.size(), 2u);
        for (const Vec<D>& point : shown[0].points) {  // the facet lies between the two
            EXPECT_TRUE(has_corner(cells, update.from.id, point));
            EXPECT_TRUE(has_corner(cells, update.item.id, point));
        }
        EXPECT_EQ(shown[1].points.front(), session.culling_view().eye);
    }
    // The normal leads out of the cell that handed the key on.
    const auto angle = lines(KeyAbout::angle);
    ASSERT_EQ(angle.size(), 3u);
    const Vec<D> normal = angle[2].points[1] - angle[2].points[0];
    EXPECT_GT(glm::dot(normal, cells.centre(update.item.id) - cells.centre(update.from.id)), 0);
}

/// Returns how many updates there were.
template <int D>
std::uint32_t check(Session<D> session) {
    session.run(30);
    std::uint32_t seen = 0;
    for (std::uint32_t step = 1; step <= session.position(); ++step) {
        const StepExplanation shown = explain_step(session, step);
        for (const Considered& update : shown.looked_at)
            if (update.key) {
                check_update(session, update, shown.digits);
                ++seen;
            }
    }
    return seen;
}

TEST(KeyLight, LightsWhatATermIsComputedFrom) {
    Random random(31);
    std::uint32_t seen = 0;
    for (int i = 0; i < 10; ++i) {
        test::Start start = test::random_start(random);
        start.settings.method = "published";
        seen += check(start.session());
        test::Start3 start3 = test::random_start_3d(random);
        start3.settings.method = "published";
        seen += check(start3.session());
    }
    EXPECT_GT(seen, 100u);
}

Session<2> random_run() {
    Random random(7);
    test::Start start = test::random_start(random, 200);
    start.settings.method = "published";
    Session<2> session = start.session();
    session.run(16);
    return session;
}

TEST(KeyLight, IsDarkForWhatTheSessionDoesNotHave) {
    const Session<2> session = random_run();
    const std::uint32_t cells = session.cells().cell_count();
    EXPECT_TRUE(key_light(session, KeyLight{}).empty());
    EXPECT_TRUE(key_light(session, KeyLight{KeyAbout::angle, cells, 0, 0}).empty());
    EXPECT_TRUE(key_light(session, KeyLight{KeyAbout::own, 0, 0, cells}).empty());
    EXPECT_TRUE(key_light(session, KeyLight{KeyAbout::star, 0, 0xfffffff0u, 0}).empty());
}

TEST(KeyLight, TheSourceOfAKeyIsTheEndOfItsChain) {
    const Session<2> session = random_run();
    std::uint32_t with = 0;
    for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
        const auto chain = update_chain(session, cell);
        const auto source = key_source(session, cell, 3);
        ASSERT_EQ(source.has_value(), !chain.empty());
        if (!source) continue;
        EXPECT_EQ(source->step, chain.back().step);
        EXPECT_EQ(source->update.via, chain.back().update.via);
        ++with;
    }
    EXPECT_GT(with, 5u);
}

}  // namespace
}  // namespace sightline
