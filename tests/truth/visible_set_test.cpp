// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/visible_set.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "core/truth/hiding.h"
#include "tests/soak.h"
#include "tests/truth/brute_visibility.h"

namespace sightline {
namespace {

struct Case {
    std::vector<Primitive<2>> primitives;
    View<2> view;
};

View<2> look_round(const Vec<2>& eye) { return {eye, eye + Vec<2>(1, 0), 360, true, {}}; }
View<2> look_between(const Vec<2>& eye, const Vec<2>& right, const Vec<2>& left) {
    return {eye, (right + left) * 0.5, 90, false, {right, left}};
}

/// All round, or a cone through two random points.
template <typename RandomPoint>
View<2> random_case_view(Random& random, const Vec<2>& eye, RandomPoint random_point) {
    for (int tries = 0; random.below(8) > 2 && tries < 20; ++tries) {
        const Vec<2> right = random_point(), left = random_point();
        if (orient(eye, right, left) > 0) return look_between(eye, right, left);
    }
    return look_round(eye);
}

/// Small integers: crossings, touching ends, T-junctions, overlaps, duplicates, zero length, eyes on everything.
Case degenerate_case(Random& random, int size, std::size_t most = 12) {
    const auto point = [&] { return Vec<2>(random.below(size), random.below(size)); };
    Case c;
    const std::size_t count = 2 + random.below(most - 1);
    while (c.primitives.size() < count) {
        c.primitives.push_back({point(), point()});
        if (random.below(8) == 0) c.primitives.push_back(c.primitives[random.below(c.primitives.size())]);
        if (random.below(8) == 0) std::swap(c.primitives.back()[0], c.primitives.back()[1]);
        // A polyline goes on.
        if (random.below(3) == 0) c.primitives.push_back({c.primitives.back()[1], point()});
    }
    c.view = random_case_view(random, point(), point);
    return c;
}

/// Integers of 16 bits: no degeneracy but by chance; long segments, which cross, or short ones.
Case generic_case(Random& random, bool with_long_ones, std::size_t most = 12) {
    const auto point = [&] { return Vec<2>(random.below(1 << 16), random.below(1 << 16)); };
    Case c;
    const std::size_t count = 2 + random.below(most - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<2> a = point();
        const Vec<2> step(static_cast<double>(random.below(1 << 14)) - (1 << 13),
                          static_cast<double>(random.below(1 << 14)) - (1 << 13));
        c.primitives.push_back({a, with_long_ones ? point() : a + step});
    }
    c.view = random_case_view(random, point(), point);
    return c;
}

/// Full doubles, a part of them as near to a degeneracy as rounding allows.
Case rounded_case(Random& random) {
    const double scale = std::array{1.0, 1e-6, 1e6, 0.1}[random.below(4)];
    const double offset = std::array{0.0, 1e6, -1.0}[random.below(3)];
    const auto point = [&] { return Vec<2>(offset) + scale * Vec<2>(random.uniform(-1, 1), random.uniform(-1, 1)); };
    Case c;
    const Vec<2> eye = point();
    const std::size_t count = 2 + random.below(7);
    const auto some_segment = [&] { return c.primitives[random.below(c.primitives.size())]; };
    const auto near_point = [&]() -> Vec<2> {
        if (c.primitives.empty()) return point();
        const auto [a, b] = some_segment();
        switch (random.below(5)) {
            case 0:
                return a + (b - a) * random.unit();  // on a segment
            case 1:
                return eye + (a - eye) * random.uniform(0.5, 2);  // behind or before an end
            case 2:
                return b;
            default:
                return point();
        }
    };
    while (c.primitives.size() < count) {
        const Vec<2> a = near_point(), b = near_point();
        c.primitives.push_back({a, b});
    }
    c.view = random_case_view(random, eye, near_point);
    return c;
}

void expect_same(const VisibleSet& set, const brute::Result& reference, double tolerance) {
    ASSERT_EQ(set.visible, reference.visible);
    ASSERT_EQ(set.count, static_cast<std::size_t>(std::count(set.visible.begin(), set.visible.end(), 1)));
    ASSERT_EQ(set.eye_on, reference.eye_on);
    ASSERT_EQ(set.pieces.size(), reference.pieces.size());
    for (std::size_t i = 0; i < set.pieces.size(); ++i) {
        const VisiblePiece &piece = set.pieces[i], &expected = reference.pieces[i];
        ASSERT_EQ(piece.primitive, expected.primitive) << "piece " << i;
        for (int d = 0; d < 2; ++d) {
            ASSERT_NEAR(piece.from[d], expected.from[d], tolerance);
            ASSERT_NEAR(piece.to[d], expected.to[d], tolerance);
        }
    }
}

/// What a run of scenes held, so that a test can tell that it tested something.
struct Tally {
    std::size_t pieces = 0, hidden = 0, fused = 0, deep = 0, eye_on = 0;
};

template <typename T>
void check(const Case& c, double tolerance, Tally& tally) {
    const brute::Result reference = brute::visibility<T>(c.primitives, c.view);
    ASSERT_NO_FATAL_FAILURE(expect_same(exact_visible_set(c.primitives, c.view), reference, tolerance));
    ASSERT_EQ(layering_numbers(c.primitives, c.view), reference.layers);
    const std::vector<Hiding> found = hiding(c.primitives, c.view, reference.layers);
    for (std::size_t p = 0; p < found.size(); ++p) {
        const bool is_hidden = reference.layers[p] > 1;
        const Hiding expected = !is_hidden                       ? Hiding::none
                                : reference.in_front[p]->empty() ? Hiding::fused
                                                                 : Hiding::alone;
        ASSERT_EQ(found[p], expected) << "primitive " << p;
        tally.fused += expected == Hiding::fused;
    }
    tally.pieces += reference.pieces.size();
    tally.hidden +=
        std::count_if(reference.layers.begin(), reference.layers.end(), [](auto layer) { return layer > 1; });
    tally.deep += std::count_if(reference.layers.begin(), reference.layers.end(), [](auto layer) { return layer > 4; });
    tally.eye_on += reference.eye_on;
}

TEST(VisibleSet, AgreesWithBruteForceOnDegenerateScenes) {
    Random random(1);
    Tally tally;
    for (int i = 0; i < test::soak_count(60000); ++i) {
        SCOPED_TRACE(i);
        const int size = 3 + i % 5;
        ASSERT_NO_FATAL_FAILURE(check<__int128>(degenerate_case(random, size), 1e-13, tally));
    }
    EXPECT_GT(tally.pieces, 100000u);
    EXPECT_GT(tally.hidden, 100000u);
    EXPECT_GT(tally.deep, 10000u);
    EXPECT_GT(tally.eye_on, 10000u);
}

TEST(VisibleSet, AgreesWithBruteForceOnGenericScenes) {
    Random random(2);
    Tally tally;
    for (int i = 0; i < test::soak_count(20000); ++i) {
        SCOPED_TRACE(i);
        ASSERT_NO_FATAL_FAILURE(check<__int128>(generic_case(random, i % 2 == 0), 1e-8, tally));
    }
    EXPECT_GT(tally.pieces, 50000u);
    EXPECT_GT(tally.hidden, 20000u);
    EXPECT_GT(tally.fused, 1000u);
    EXPECT_GT(tally.deep, 1000u);
}

TEST(VisibleSet, AgreesWithBruteForceOnLargerScenes) {
    Random random(7);
    Tally tally;
    for (int i = 0; i < test::soak_count(150); ++i) {
        SCOPED_TRACE(i);
        const Case c = i % 3 == 0 ? degenerate_case(random, 12, 80) : generic_case(random, i % 3 == 1, 80);
        ASSERT_NO_FATAL_FAILURE(check<__int128>(c, 1e-7, tally));
    }
    EXPECT_GT(tally.deep, 1000u);
}

TEST(VisibleSet, AgreesWithBruteForceOnNearlyDegenerateDoublesOfManyScales) {
    Random random(3);
    Tally tally;
    for (int i = 0; i < test::soak_count(6000); ++i) {
        SCOPED_TRACE(i);
        const Case c = rounded_case(random);
        const Box<2> box = bounds<2>(c.primitives);
        const double largest = std::max(glm::length(box.min), glm::length(box.max));
        ASSERT_NO_FATAL_FAILURE(check<CGAL::Exact_rational>(c, 1e-13 * largest, tally));
    }
    EXPECT_GT(tally.pieces, 10000u);
    EXPECT_GT(tally.hidden, 5000u);
}

Case scaled(const Case& c, int exponent) {
    const double factor = std::ldexp(1.0, exponent);
    Case result = c;
    for (Primitive<2>& p : result.primitives)
        for (Vec<2>& v : p) v *= factor;
    result.view.eye *= factor;
    result.view.look_at *= factor;
    for (Vec<2>& corner : result.view.corners) corner *= factor;
    return result;
}

TEST(VisibleSet, ScalingByAPowerOfTwoChangesNoBit) {
    Random random(4);
    for (int i = 0; i < test::soak_count(6000); ++i) {
        SCOPED_TRACE(i);
        const Case c = i % 3 == 0   ? degenerate_case(random, 6)
                       : i % 3 == 1 ? generic_case(random, true)
                                    : rounded_case(random);
        const int exponent = static_cast<int>(random.below(121)) - 60;
        const Case s = scaled(c, exponent);
        const VisibleSet before = exact_visible_set(c.primitives, c.view),
                         after = exact_visible_set(s.primitives, s.view);
        ASSERT_EQ(before.visible, after.visible);
        ASSERT_EQ(before.eye_on, after.eye_on);
        ASSERT_EQ(before.pieces.size(), after.pieces.size());
        for (std::size_t k = 0; k < before.pieces.size(); ++k) {
            ASSERT_EQ(before.pieces[k].from * std::ldexp(1.0, exponent), after.pieces[k].from);
            ASSERT_EQ(before.pieces[k].to * std::ldexp(1.0, exponent), after.pieces[k].to);
        }
        ASSERT_EQ(layering_numbers(c.primitives, c.view), layering_numbers(s.primitives, s.view));
    }
}

TEST(VisibleSet, TinyAndHugeCoordinatesKeepTheAnswer) {
    Random random(5);
    for (int i = 0; i < test::soak_count(1000); ++i) {
        SCOPED_TRACE(i);
        const Case c = i % 2 == 0 ? degenerate_case(random, 6) : generic_case(random, true);
        const VisibleSet before = exact_visible_set(c.primitives, c.view);
        for (const int exponent : {-1070, -700, -332, 332, 700, 1000}) {
            const Case s = scaled(c, exponent);
            const VisibleSet after = exact_visible_set(s.primitives, s.view);
            ASSERT_EQ(before.visible, after.visible) << exponent;
            ASSERT_EQ(before.pieces.size(), after.pieces.size());
            for (const VisiblePiece& piece : after.pieces) ASSERT_TRUE(is_finite(piece.from) && is_finite(piece.to));
        }
    }
}

TEST(VisibleSet, OrderOfThePrimitivesDoesNotMatter) {
    Random random(6);
    for (int i = 0; i < test::soak_count(6000); ++i) {
        SCOPED_TRACE(i);
        const Case c = generic_case(random, i % 2 == 0);
        std::vector<std::uint32_t> old_id(c.primitives.size());
        std::iota(old_id.begin(), old_id.end(), 0u);
        for (std::size_t k = old_id.size(); k > 1; --k) std::swap(old_id[k - 1], old_id[random.below(k)]);
        std::vector<Primitive<2>> shuffled;
        for (const std::uint32_t id : old_id) shuffled.push_back({c.primitives[id][1], c.primitives[id][0]});
        const VisibleSet before = exact_visible_set(c.primitives, c.view), after = exact_visible_set(shuffled, c.view);
        const auto layers = layering_numbers(c.primitives, c.view),
                   shuffled_layers = layering_numbers(shuffled, c.view);
        ASSERT_EQ(before.pieces.size(), after.pieces.size());
        for (std::size_t k = 0; k < before.pieces.size(); ++k)
            ASSERT_EQ(before.pieces[k].primitive, old_id[after.pieces[k].primitive]);
        for (std::size_t k = 0; k < old_id.size(); ++k) ASSERT_EQ(layers[old_id[k]], shuffled_layers[k]);
    }
}

TEST(Hiding, TellsFusedOccludersFromSingleOnes) {
    // One wall in two halves before one segment, and before another that a half alone hides.
    const std::vector<Primitive<2>> walls{
        {{{1, -1}, {1, 0}}}, {{{1, 0}, {1, 1}}}, {{{2, -1}, {2, 1}}}, {{{3, 1}, {3, 2}}}, {{{4, -9}, {4, -8}}}};
    const View<2> view = look_between({0, 0}, {1, -1}, {1, 1});
    const auto all = hiding(walls, view, layering_numbers(walls, view));
    EXPECT_EQ(all, (std::vector{Hiding::none, Hiding::none, Hiding::fused, Hiding::alone, Hiding::none}));
    EXPECT_EQ(fused_share(all), 0.5);
    EXPECT_TRUE(std::isnan(fused_share(std::span(all).first(2))));
}

TEST(VisibleSet, AWallHidesWhatIsBehindIt) {
    const std::vector<Primitive<2>> walls{{{{4, -3}, {4, 3}}}, {{{2, -1}, {2, 1}}}, {{{3, -1}, {3, 1}}}};
    const VisibleSet set = exact_visible_set(walls, look_between({0, 0}, {1, -1}, {1, 1}));
    EXPECT_EQ(set.visible, (std::vector<std::uint8_t>{1, 1, 0}));
    ASSERT_EQ(set.pieces.size(), 3u);
    EXPECT_EQ(set.pieces[0].from, Vec<2>(4, -3));
    EXPECT_EQ(set.pieces[0].to, Vec<2>(4, -2));
    EXPECT_EQ(set.pieces[1].from, Vec<2>(2, -1));
    EXPECT_EQ(set.pieces[1].to, Vec<2>(2, 1));
    EXPECT_EQ(set.pieces[2].from, Vec<2>(4, 2));
    EXPECT_EQ(set.pieces[2].to, Vec<2>(4, 3));
    EXPECT_EQ(layering_numbers(walls, look_between({0, 0}, {1, -1}, {1, 1})), (std::vector<std::uint32_t>{1, 1, 2}));
}

TEST(VisibleSet, AWallIsCutByTheCone) {
    const std::vector<Primitive<2>> walls{{{{2, 9}, {2, -9}}}};
    const VisibleSet set = exact_visible_set(walls, look_between({0, 0}, {4, -2}, {1, 1}));
    ASSERT_EQ(set.pieces.size(), 1u);
    EXPECT_EQ(set.pieces[0].from, Vec<2>(2, -1));
    EXPECT_EQ(set.pieces[0].to, Vec<2>(2, 2));
    EXPECT_EQ(exact_visible_set(walls, look_between({0, 0}, {-1, 1}, {-1, -1})).count, 0u);
}

TEST(VisibleSet, AnAllRoundViewIsCutAheadOnly) {
    const std::vector<Primitive<2>> box{
        {{{-1, -1}, {1, -1}}}, {{{1, -1}, {1, 1}}}, {{{1, 1}, {-1, 1}}}, {{{-1, 1}, {-1, -1}}}};
    const VisibleSet set = exact_visible_set(box, look_round({0, 0}));
    std::vector<std::uint32_t> owners;
    for (const VisiblePiece& piece : set.pieces) owners.push_back(piece.primitive);
    EXPECT_EQ(owners, (std::vector<std::uint32_t>{1, 2, 3, 0, 1}));
    EXPECT_EQ(set.pieces[0].from, Vec<2>(1, 0));
    EXPECT_EQ(set.pieces[2].from, Vec<2>(-1, 1));
    EXPECT_EQ(set.pieces[2].to, Vec<2>(-1, -1));
    EXPECT_EQ(set.pieces[4].to, Vec<2>(1, 0));
}

TEST(VisibleSet, CrossingSegmentsShareTheView) {
    const std::vector<Primitive<2>> cross{{{{1, -1}, {3, 1}}}, {{{3, -1}, {1, 1}}}};
    const VisibleSet set = exact_visible_set(cross, look_round({0, 0}));
    ASSERT_EQ(set.pieces.size(), 2u);
    EXPECT_EQ(set.pieces[0].primitive, 1u);
    EXPECT_EQ(set.pieces[0].from, Vec<2>(2, 0));
    EXPECT_EQ(set.pieces[0].to, Vec<2>(1, 1));
    EXPECT_EQ(set.pieces[1].primitive, 0u);
    EXPECT_EQ(set.pieces[1].from, Vec<2>(1, -1));
    EXPECT_EQ(set.pieces[1].to, Vec<2>(2, 0));
    EXPECT_EQ(layering_numbers(cross, look_round({0, 0})), (std::vector<std::uint32_t>{1, 1}));
}

TEST(VisibleSet, OfOverlappingSegmentsTheLowestIdIsSeen) {
    const std::vector<Primitive<2>> walls{{{{2, 0}, {2, 2}}}, {{{2, 3}, {2, 1}}}, {{{2, 2}, {2, 0}}}};
    const VisibleSet set = exact_visible_set(walls, look_round({0, 0}));
    EXPECT_EQ(set.visible, (std::vector<std::uint8_t>{1, 1, 0}));
    ASSERT_EQ(set.pieces.size(), 2u);
    EXPECT_EQ(set.pieces[1].from, Vec<2>(2, 2));
    EXPECT_EQ(layering_numbers(walls, look_round({0, 0})), (std::vector<std::uint32_t>{1, 1, 2}));
}

TEST(VisibleSet, SegmentsOnALineThroughTheEyeAreNeitherSeenNorHide) {
    const std::vector<Primitive<2>> walls{
        {{{1, 0}, {2, 0}}}, {{{-1, 0}, {1, 0}}}, {{{0, 0}, {0, 5}}}, {{{3, -1}, {3, 1}}}, {{{0, 0}, {0, 0}}}};
    const VisibleSet set = exact_visible_set(walls, look_round({0, 0}));
    EXPECT_EQ(set.visible, (std::vector<std::uint8_t>{0, 0, 0, 1, 0}));
    EXPECT_EQ(set.eye_on, 2u);
    EXPECT_EQ(set.pieces.size(), 2u);
}

TEST(VisibleSet, NothingToSee) {
    EXPECT_EQ(exact_visible_set({}, look_round({0, 0})).pieces.size(), 0u);
    EXPECT_EQ(exact_visible_set({}, look_between({0, 0}, {1, 0}, {0, 1})).count, 0u);
    EXPECT_TRUE(layering_numbers({}, look_round({0, 0})).empty());
}

}  // namespace
}  // namespace sightline
