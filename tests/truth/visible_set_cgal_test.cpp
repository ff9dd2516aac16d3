// The exact visible set beside CGAL's triangular expansion, on scenes that its contract allows.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>
#include <gtest/gtest.h>

#include <map>

#include "core/base/random.h"
#include "core/truth/visible_set.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Exact>>;
using Visibility = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;

/// Stretches of one primitive as parts of its length in ascending order, those that touch joined.
using Stretches = std::vector<std::array<double, 2>>;

void join(Stretches& stretches) {
    for (auto& [from, to] : stretches)
        if (from > to) std::swap(from, to);
    std::sort(stretches.begin(), stretches.end());
    Stretches joined;
    for (const auto& s : stretches) {
        if (!joined.empty() && s[0] - joined.back()[1] < 1e-12)
            joined.back()[1] = s[1];
        else
            joined.push_back(s);
    }
    stretches = joined;
}

double part_of(const Primitive<2>& primitive, const Vec<2>& p) {
    const Vec<2> whole = primitive[1] - primitive[0];
    return glm::dot(p - primitive[0], whole) / glm::dot(whole, whole);
}

/// A closed polygon of three to six corners, star-shaped about the centre of its field, on integers.
void add_polygon(std::vector<Primitive<2>>& scene, Random& random, const Vec<2>& centre) {
    static constexpr std::array<std::array<int, 2>, 8> ring{
        {{3, 0}, {3, 3}, {0, 3}, {-3, 3}, {-3, 0}, {-3, -3}, {0, -3}, {3, -3}}};
    std::vector<Vec<2>> corners;
    const std::size_t first = random.below(8);
    for (std::size_t i = 0; i < 8; ++i) {
        const auto& [x, y] = ring[(first + i) % 8];
        // Every third at the least, so that the centre stays inside.
        if (i % 3 == 0 || random.below(3) == 0) corners.push_back(centre + Vec<2>(x, y) * double(1 + random.below(3)));
    }
    for (std::size_t i = 0; i < corners.size(); ++i) scene.push_back({corners[i], corners[(i + 1) % corners.size()]});
}

std::map<std::uint32_t, Stretches> seen_by_cgal(const std::vector<Primitive<2>>& scene, const Visibility& visibility,
                                                Arrangement::Face_const_handle face, const Exact::Point_2& eye) {
    Arrangement seen;
    visibility.compute_visibility(eye, face, seen);
    std::map<std::uint32_t, Stretches> result;
    for (auto edge = seen.edges_begin(); edge != seen.edges_end(); ++edge) {
        const Exact::Point_2 p = edge->source()->point(), q = edge->target()->point();
        if (CGAL::collinear(eye, p, q)) continue;  // a border of the view, or a wall that subtends no angle
        for (std::uint32_t i = 0; i < scene.size(); ++i) {
            const Exact::Segment_2 segment({scene[i][0].x, scene[i][0].y}, {scene[i][1].x, scene[i][1].y});
            if (!segment.has_on(p) || !segment.has_on(q)) continue;
            const auto part = [&](const Exact::Point_2& r) {
                return part_of(scene[i], {CGAL::to_double(r.x()), CGAL::to_double(r.y())});
            };
            result[i].push_back({part(p), part(q)});
        }
    }
    for (auto& [i, stretches] : result) join(stretches);
    return result;
}

TEST(VisibleSet, AgreesWithTriangularExpansion) {
    Random random(1);
    int compared = 0;
    std::size_t hidden = 0;
    for (int round = 0; round < test::soak_count(60); ++round) {
        std::vector<Primitive<2>> scene{{{{-20, -20}, {120, -20}}},
                                        {{{120, -20}, {120, 120}}},
                                        {{{120, 120}, {-20, 120}}},
                                        {{{-20, 120}, {-20, -20}}}};
        for (int row = 0; row < 5; ++row)
            for (int column = 0; column < 5; ++column)
                if (random.below(4) > 0) add_polygon(scene, random, {10 + 20 * column, 10 + 20 * row});
        std::vector<Exact::Segment_2> segments;
        for (const auto& [a, b] : scene) segments.push_back({{a.x, a.y}, {b.x, b.y}});
        Arrangement arrangement;
        CGAL::insert(arrangement, segments.begin(), segments.end());
        const Visibility visibility(arrangement);
        const CGAL::Arr_naive_point_location<Arrangement> location(arrangement);
        for (int view = 0; view < 10; ++view) {
            // On integers many corners lie on one line with the eye.
            const Vec<2> eye = view % 2 == 0 ? Vec<2>(random.below(100), random.below(100))
                                             : Vec<2>(random.uniform(0, 100), random.uniform(0, 100));
            const auto found = location.locate({eye.x, eye.y});
            const auto* face = boost::get<Arrangement::Face_const_handle>(&found);
            if (face == nullptr) continue;  // on a wall
            SCOPED_TRACE(std::to_string(round) + " " + std::to_string(view));
            const auto expected = seen_by_cgal(scene, visibility, *face, {eye.x, eye.y});
            const VisibleSet set = exact_visible_set(scene, {eye, eye + Vec<2>(1, 0), 360, true, {}});
            std::map<std::uint32_t, Stretches> actual;
            for (const VisiblePiece& piece : set.pieces)
                actual[piece.primitive].push_back(
                    {part_of(scene[piece.primitive], piece.from), part_of(scene[piece.primitive], piece.to)});
            for (auto& [i, stretches] : actual) join(stretches);
            ASSERT_EQ(set.count, expected.size());
            for (const auto& [i, stretches] : expected) {
                ASSERT_EQ(actual[i].size(), stretches.size()) << "primitive " << i;
                for (std::size_t k = 0; k < stretches.size(); ++k)
                    for (int end = 0; end < 2; ++end) ASSERT_NEAR(actual[i][k][end], stretches[k][end], 1e-10);
            }
            ++compared;
            hidden += scene.size() - set.count;
        }
    }
    EXPECT_GT(compared, 400);
    EXPECT_GT(hidden, 10000u);
}

}  // namespace
}  // namespace sightline
