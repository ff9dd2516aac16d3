// Light at corners by short characteristics: rays against the geometry of cells, light against its definition.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/corner_light.h"

#include <gtest/gtest.h>

#include "tests/run/lit_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// How far p lies inside of the cell: negative outside.
template <int D>
double depth_in_cell(const CellComplex<D>& cells, std::uint32_t cell, const Vec<D>& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const HalfFacet& half : cells.facets_of(cell)) {
        if (cells.is_contact(half.facet())) continue;
        const auto polygon = cells.points_of_facet(half.facet());
        const Vec<D> a = cells.points[polygon[0]], b = cells.points[polygon[1]];
        Vec<D> normal;
        if constexpr (D == 2)
            normal = {a.y - b.y, b.x - a.x};
        else
            normal = glm::cross(b - a, cells.points[polygon[2]] - a);
        const double along = glm::dot(normal, p - a) / glm::length(normal);
        const double inside = glm::dot(normal, cells.centre(cell) - a) < 0 ? -along : along;
        least = std::min(least, inside);
    }
    return least;
}

template <int D>
void expect_rays() {
    Random random(200 + D);
    int through = 0, out = 0, ended = 0, whole = 0;
    for (int round = 0; round < test::soak_count(30); ++round) {
        const test::LitScene<D> lit(random, "tri", 0.05, test::Eyes::far_too);
        const CellComplex<D>& cells = lit.cells;
        const CornerRays<D> rays(cells);
        const Vec<D> eye = lit.view.eye;
        Box<D> around;
        for (const Vec<D>& p : cells.points) around.add(p);
        const double close = 1e-5 * around.longest_side();  // boxes are kept as floats
        for (std::uint32_t corner = 0; corner < cells.points.size(); ++corner) {
            const Vec<D> p = cells.points[corner], d = eye - p;
            if (glm::length(d) < 0.01) continue;
            const CornerRay<D> ray = rays.from(cells, corner, eye);
            if (ray.cell == none) {
                const Vec<D> next = p + d * (0.001 / glm::length(d));
                double deepest = -1;
                for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
                    deepest = std::max(deepest, depth_in_cell(cells, cell, next));
                ASSERT_LT(deepest, close) << "corner " << corner << " in round " << round;
                ++out;
                continue;
            }
            EXPECT_LT(glm::length(ray.to_eye - (eye - cells.centre(ray.cell))), close);
            if (ray.ends) {
                ASSERT_GT(depth_in_cell(cells, ray.cell, eye), -close);
                ++ended;
                continue;
            }
            ++through;
            float sum = 0;
            Vec<D> leaves(0);
            const auto own = cells.corners_of(ray.cell);
            for (std::uint32_t i = 0; i < ray.count; ++i) {
                ASSERT_NE(std::find(own.begin(), own.end(), ray.corners[i]), own.end());
                ASSERT_NE(ray.corners[i], corner);
                ASSERT_GT(ray.weights[i], 0);
                sum += ray.weights[i];
                leaves += cells.points[ray.corners[i]] * double{ray.weights[i]};
            }
            if (ray.count > 0) {
                ASSERT_NEAR(sum, 1, 1e-5);
            }
            // Of simplices, corners that are no closer to the eye than this one are left out.
            if (!cells.has_boxes())
                for (std::uint32_t i = 0; i < ray.count; ++i)
                    ASSERT_LT(glm::length(eye - cells.points[ray.corners[i]]), glm::length(d));
            const bool all = cells.has_boxes() || ray.count == D;
            if (!all) continue;
            ++whole;
            const double t = glm::dot(leaves - p, d) / glm::dot(d, d);
            ASSERT_GT(t, 0);
            ASSERT_LT(t, 1 + 1e-5);
            ASSERT_LT(glm::length(leaves - (p + d * t)), 10 * close) << "off the ray";
            ASSERT_NEAR(depth_in_cell(cells, ray.cell, leaves), 0, 10 * close) << "not where it leaves the cell";
            ASSERT_GT(depth_in_cell(cells, ray.cell, (p + leaves) * 0.5), -10 * close) << "not through the cell";
        }
    }
    EXPECT_GT(through, 500);
    EXPECT_GT(whole, 400);
    EXPECT_GT(out, 50);
    EXPECT_GT(ended, 10);
}
TEST(CornerLight, RaysGoThroughTheCellBeforeACorner2d) { expect_rays<2>(); }
TEST(CornerLight, RaysGoThroughTheCellBeforeACorner3d) { expect_rays<3>(); }

template <int D>
void expect_definition() {
    Random random(210 + D);
    int dark = 0, between = 0, lit_corners = 0;
    for (int round = 0; round < test::soak_count(30); ++round) {
        const test::LitScene<D> lit(random, "tri", 0.05, test::Eyes::far_too);
        const CellComplex<D>& cells = lit.cells;
        const Problem<D> problem = lit.problem();
        const CellOpacity<D> opacity(lit.scene, cells);
        const CornerLight<D> light(problem), backwards(problem);
        const auto count = static_cast<std::uint32_t>(cells.points.size());
        for (std::uint32_t corner = 0; corner < count; ++corner) light.at(problem, corner);
        for (std::uint32_t corner = count; corner-- > 0;) {
            const float value = backwards.at(problem, corner);
            ASSERT_EQ(value, light.at(problem, corner)) << "depends on what was asked before";
            const CornerRay<D> ray = light.ray(problem, corner);
            double wanted = 1;
            if (ray.cell != none && !ray.ends) {
                double there = ray.count == 0 ? 1 : 0;
                bool all = true;
                for (std::uint32_t i = 0; i < ray.count; ++i) {
                    there += double{ray.weights[i]} * double{light.at(problem, ray.corners[i])};
                    all = all && light.at(problem, ray.corners[i]) == 1;
                }
                if (all && lit.cells.count(ray.cell) == 0) {
                    ASSERT_EQ(value, 1) << "nothing is in the way";
                }
                wanted = there * (1 - opacity.of(ray.cell, nearest_direction(ray.to_eye)));
            }
            ASSERT_NEAR(value, wanted, 1e-5);
            ASSERT_GE(value, 0);
            ASSERT_LE(value, 1);
            dark += value < 0.01f;
            lit_corners += value == 1;
            between += value > 0.01f && value < 0.99f;
        }
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            const auto corners = cells.corners_of(cell);
            const Vec<D> origin(0.25);
            const LightInside<D> inside = light.inside(problem, cell, origin);
            const auto at = [&](const Vec<D>& p) {
                float sum = 0;
                for (std::size_t term = 0; term < inside.terms.size(); ++term) {
                    float product = inside.terms[term];
                    for (std::size_t axis = 0; axis < D; ++axis)
                        if (term >> axis & 1)
                            product *= std::clamp(
                                (static_cast<float>((p - origin)[static_cast<int>(axis)]) - inside.origin[axis]) *
                                    inside.scale[axis],
                                inside.nearest, inside.farthest);
                    sum += product;
                }
                return sum;
            };
            float least = 1, most = 0;
            double mean = 0;
            for (const std::uint32_t corner : corners) {
                const float value = light.at(problem, corner);
                least = std::min(least, value);
                most = std::max(most, value);
                mean += double{value} / static_cast<double>(corners.size());
                EXPECT_NEAR(at(cells.points[corner]), value, 1e-2);
            }
            EXPECT_EQ(inside.least, least);
            EXPECT_EQ(inside.most, most);
            EXPECT_NEAR(light.of_cell(problem, cell), mean, 1e-6);
            EXPECT_NEAR(at(cells.centre(cell)), mean, 1e-2);
        }
    }
    if (D == 2) EXPECT_GT(dark, 20);
    EXPECT_GT(between, 200);
    EXPECT_GT(lit_corners, 100);
}
TEST(CornerLight, IsWhatTheCellBeforeLeavesOpen2d) { expect_definition<2>(); }
TEST(CornerLight, IsWhatTheCellBeforeLeavesOpen3d) { expect_definition<3>(); }

TEST(CornerLight, TheNearestOfTheDirectionsIsFound) {
    Random random(220);
    const auto all = opacity_directions<3>();
    for (int i = 0; i < test::soak_count(20000); ++i) {
        const Vec<3> d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        double most = -10;
        for (const Vec<3>& other : all) most = std::max(most, glm::dot(other, d));
        ASSERT_NEAR(glm::dot(all[nearest_direction(d)], d), most, 1e-12);
    }
}

}  // namespace
}  // namespace sightline
