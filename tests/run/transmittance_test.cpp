// Light from the eye: how much of cells is covered, what comes into them, and the order in which primitives wait.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/methods/cells/facet_geometry.h"
#include "core/methods/transmittance/tri.h"
#include "tests/run/lit_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using test::LitScene;

/// On the inner side of all facets.
template <int D>
bool cell_holds(const CellComplex<D>& cells, std::uint32_t cell, const Vec<D>& p) {
    for (const HalfFacet& half : cells.facets_of(cell))
        if (!cells.is_contact(half.facet()) && facet_side(cells, half, p) < 0) return false;
    return true;
}

/// Where the line through p along d meets the primitive.
std::optional<Vec<2>> met_at(const Primitive<2>& s, const Vec<2>& p, const Vec<2>& d) {
    const double along = cross(d, s[1] - s[0]), t = -cross(d, s[0] - p) / along;
    if (along == 0 || t < 0 || t > 1) return std::nullopt;
    return s[0] + (s[1] - s[0]) * t;
}
std::optional<Vec<3>> met_at(const Primitive<3>& t, const Vec<3>& p, const Vec<3>& d) {
    const Vec<3> normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    if (!(glm::dot(normal, d) > 0)) return std::nullopt;  // d is towards the eye
    const Vec<3> at = p + d * (glm::dot(normal, t[0] - p) / glm::dot(normal, d));
    for (int i = 0; i < 3; ++i)
        if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], at - t[i]), normal) < 0) return std::nullopt;
    return at;
}

/// Held against random lines along the direction.
template <int D>
void expect_covered_shares(double tolerance) {
    Random random(90 + D);
    int compared = 0;
    double off = 0;
    for (int round = 0; round < test::soak_count(8); ++round) {
        const LitScene<D> lit(random, "flux");
        const CellOpacity<D> opacity(lit.scene, lit.cells, 1);
        for (std::uint32_t cell = 0; cell < lit.cells.cell_count(); ++cell) {
            const std::size_t which = random.below(opacity_directions<D>().size());
            const Vec<D> d = opacity_directions<D>()[which];
            if (lit.cells.count(cell) == 0) {
                ASSERT_EQ(opacity.of(cell, which), 0);
                continue;
            }
            if (random.below(4) != 0) continue;
            Box<D> box;
            for (const std::uint32_t corner : lit.cells.corners_of(cell)) box.add(lit.cells.points[corner]);
            // Start on a plane across d behind the cell: uniform there.
            const Vec<D> centre = box.centre();
            double reach = 0;
            for (int i = 0; i < D; ++i) reach += box.extent()[i];
            int outline = 0, covered = 0;
            for (int i = 0; i < 60000 && outline < 1500; ++i) {
                Vec<D> p = centre;
                if constexpr (D == 2) {
                    p += Vec<2>(-d.y, d.x) * random.uniform(-reach, reach);
                } else {
                    const Vec<3> u = glm::normalize(glm::cross(d, Vec<3>(0.3, 0.5, 0.8)));
                    p += u * random.uniform(-reach, reach) + glm::cross(d, u) * random.uniform(-reach, reach);
                }
                double from = -1e9, to = 1e9;
                for (const HalfFacet& half : lit.cells.facets_of(cell)) {
                    if (lit.cells.is_contact(half.facet())) continue;
                    const FacetGeometry<D> facet = facet_geometry(lit.cells, half);
                    const double slope = glm::dot(facet.normal, d), at = glm::dot(facet.normal, facet.centroid - p);
                    if (slope > 0) to = std::min(to, at / slope);
                    if (slope < 0) from = std::max(from, at / slope);
                    if (slope == 0 && at < 0) to = -1e9;
                }
                if (!(from < to)) continue;
                ++outline;
                for (const std::uint32_t primitive : lit.cells.primitives_of(cell))
                    if (const auto at = met_at(lit.scene.primitives[primitive], p, d);
                        at && glm::dot(*at - p, d) >= from && glm::dot(*at - p, d) <= to) {
                        ++covered;
                        break;
                    }
            }
            if (outline < 300) continue;
            ++compared;
            const double wanted = static_cast<double>(covered) / outline;
            off += std::abs(opacity.of(cell, which) - wanted);
            EXPECT_NEAR(opacity.of(cell, which), wanted, tolerance) << "cell " << cell << " in round " << round;
        }
    }
    EXPECT_GT(compared, 50);
    EXPECT_LT(off / compared, tolerance / 4);
}
TEST(Transmittance, TheCoveredShareIsThatOfRandomLines2d) { expect_covered_shares<2>(0.06); }
TEST(Transmittance, TheCoveredShareIsThatOfRandomLines3d) { expect_covered_shares<3>(0.2); }

TEST(Transmittance, TheCoveredShareDependsOnNoThread) {
    Random random(95);
    const LitScene<3> lit(random, "flux");
    const CellOpacity<3> one(lit.scene, lit.cells, 1), all(lit.scene, lit.cells, 0);
    for (std::uint32_t cell = 0; cell < lit.cells.cell_count(); ++cell)
        for (std::size_t d = 0; d < opacity_directions<3>().size(); ++d) ASSERT_EQ(one.of(cell, d), all.of(cell, d));
}

/// Every key, worked out anew from the definition and from what was projected before, in doubles.
template <int D>
void expect_light() {
    Random random(100 + D);
    std::size_t checked = 0, between = 0;
    for (int round = 0; round < test::soak_count(12); ++round) {
        const LitScene<D> lit(random, "flux");
        const Problem<D> problem = lit.problem();
        const CellOpacity<D> opacity(lit.scene, lit.cells);
        OwnRun<D> run(lit.method().start(problem));
        Timeline<D> timeline;
        timeline.begin(*run);
        std::map<std::uint32_t, double> projected;
        while (timeline.forward(run) == Stop::none) {
            const Step& step = timeline.steps.back();
            projected[step.item.id] = 1 - step.key;
            const auto all = run->considered(step, std::as_const(timeline).changes_of(run->steps()), 17);
            for (const Considered& c : all) {
                if (!c.key) continue;
                double whole = 0, light = 0;
                for (const HalfFacet& half : lit.cells.facets_of(c.item.id)) {
                    if (lit.cells.is_contact(half.facet())) continue;
                    const FacetGeometry<D> facet = facet_geometry(lit.cells, half);
                    const Vec<D> away = facet.centroid - lit.view.eye;
                    double area = glm::length(facet.normal);
                    if constexpr (D == 3) {
                        const auto polygon = lit.cells.points_of_facet(half.facet());
                        const auto point = [&](std::size_t i) { return lit.cells.points[polygon[i]]; };
                        area = polygon.size() == 3
                                   ? glm::length(glm::cross(point(1) - point(0), point(2) - point(0))) / 2
                                   : glm::length(point(1) - point(0)) * glm::length(point(2) - point(1));
                    }
                    const double r = glm::length(away);
                    const double angle =
                        -area * glm::dot(facet.normal, away) / glm::length(facet.normal) / r / (D == 2 ? r : r * r);
                    if (angle <= 0) continue;
                    const std::uint32_t n = half.neighbour;
                    if (n != none && !projected.count(n) && !cell_in_view(lit.cells, lit.view, n)) continue;
                    whole += angle;
                    if (n == none) light += angle;
                    if (projected.count(n))
                        light += angle * projected[n] *
                                 (1 - (lit.cells.count(n)
                                           ? opacity.of(n, nearest_direction(lit.view.eye - lit.cells.centre(n)))
                                           : 0));
                }
                ASSERT_GE(c.key->key, 0);
                ASSERT_LE(c.key->key, 1 + 1e-12);
                if (whole < 1e-9) continue;
                // Facets are kept as floats: those that are seen nearly edge-on may differ.
                EXPECT_NEAR(c.key->key, 1 - light / whole, 1e-4) << "step " << run->steps() << " in round " << round;
                ++checked;
                between += c.key->key > 0.01 && c.key->key < 0.99;
            }
        }
    }
    EXPECT_GT(checked, 500u);
    EXPECT_GT(between, 50u);
}
TEST(Transmittance, KeysAreTheLightThatIsMissing2d) { expect_light<2>(); }
TEST(Transmittance, KeysAreTheLightThatIsMissing3d) { expect_light<3>(); }

TEST(Transmittance, WhatWaitsComesByClassAndPlace) {
    Random random(110);
    Waiting waiting;
    for (int round = 0; round < 50; ++round) {
        waiting.clear();
        std::set<std::pair<std::uint32_t, std::uint32_t>> wanted;
        for (int move = 0; move < 400; ++move) {
            if (random.below(3) != 0) {
                const float key = static_cast<float>(random.uniform(0, 1) / random.uniform(1e-6, 1));
                const auto place = static_cast<std::uint32_t>(random.below(100000));
                const bool shows = random.below(2) == 0;
                if (wanted.emplace(Waiting::class_of(key), place).second) waiting.add(key, {place, shows});
                continue;
            }
            const std::uint32_t end = random.below(5) == 0 ? none : static_cast<std::uint32_t>(random.below(1024));
            const bool some = !wanted.empty() && wanted.begin()->first < end;
            const WaitingReference first = waiting.first(end);
            ASSERT_EQ(static_cast<bool>(first), some);
            if (!some) continue;
            ASSERT_EQ(first.place(), wanted.begin()->second);
            if (const WaitingReference second = waiting.behind_first(1)) {
                ASSERT_EQ(second.place(), std::next(wanted.begin())->second);
            }
            waiting.drop_first();
            wanted.erase(wanted.begin());
        }
    }
    EXPECT_LT(Waiting::class_of(1.0f), Waiting::class_of(1.1f));
    EXPECT_EQ(Waiting::class_of(0), 0u);
    EXPECT_EQ(Waiting::class_of(std::numeric_limits<float>::infinity()), 1023u);
}

/// In the end it has rendered what flux renders: all in view that a cell holds.
template <int D>
void expect_all_rendered() {
    Random random(120 + D);
    std::size_t rendered = 0;
    for (int round = 0; round < test::soak_count(15); ++round) {
        const LitScene<D> lit(random, "tri");
        const auto run = lit.method().start(lit.problem());
        const auto other = find_method<D>(method_table<D>(), "flux").start(lit.problem());
        run->run(none);
        other->run(none);
        auto mine = rendered_ids(run->met()), all = rendered_ids(other->met());
        std::sort(mine.begin(), mine.end());
        std::sort(all.begin(), all.end());
        EXPECT_EQ(mine, all) << round;
        EXPECT_TRUE(run->finished());
        rendered += all.size();
    }
    EXPECT_GT(rendered, 100u);
}
/// What a frame leaves are cells that it projected and that show something; the next one starts from them too.
template <int D>
void expect_seen_before() {
    Random random(140 + D);
    std::size_t more_seeds = 0, without = 0;
    for (int round = 0; round < test::soak_count(12); ++round) {
        const LitScene<D> lit(random, "tri-seen");
        Problem<D> problem = lit.problem();
        problem.services.image = D == 2 ? ImageSize{512, 0} : ImageSize{80, 60};
        const Method<D>& tri = find_method<D>(method_table<D>(), "tri");
        const auto first = lit.method().start(problem), plain = tri.start(problem);
        first->run(none);
        plain->run(none);
        ASSERT_EQ(first->hash(), plain->hash()) << "without a frame before";
        EXPECT_EQ(plain->next_history(), nullptr);
        const auto left = first->next_history();
        ASSERT_EQ(left->cells.size(), lit.cells.cell_count());
        std::set<std::uint32_t> wanted;
        const auto exact = D == 2 ? problem.services.visible_set() : nullptr;  // 3D: at other pixels
        for (std::uint32_t cell = 0; cell < left->cells.size(); ++cell) {
            const bool projected = first->mark(cell).state == CellState::projected;
            ASSERT_TRUE(!left->cells[cell] || (projected && lit.cells.count(cell) > 0)) << "cell " << cell;
            // A run without a budget has drawn all, so that its picture shows what is visible and no more.
            bool any = false;
            if (exact)
                for (const std::uint32_t primitive : lit.cells.primitives_of(cell)) any = any || (*exact)[primitive];
            ASSERT_TRUE(!exact || !left->cells[cell] || any) << "cell " << cell;
            without += projected && !left->cells[cell];
            if (left->cells[cell] && cell_in_view(lit.cells, lit.view, cell)) wanted.insert(cell);
        }
        problem.history = left;
        const auto next = lit.method().start(problem);
        std::set<std::uint32_t> seeds;
        for (const Item& item : next->seeds()) {
            ASSERT_TRUE(seeds.insert(item.id).second) << "twice";
            EXPECT_EQ(next->mark(item).state, CellState::enqueued);
        }
        for (const Item& item : plain->seeds()) wanted.insert(item.id);
        ASSERT_EQ(seeds, wanted);
        more_seeds += seeds.size() > plain->seeds().size();
        next->run(none);
        const std::size_t count = lit.scene.primitives.size();
        EXPECT_EQ(rendered_mask(next->met(), count), rendered_mask(plain->met(), count)) << "in another order";
        const auto again = lit.method().start(problem);
        again->run(none);
        EXPECT_EQ(again->hash(), next->hash());
        // Of other cells it means nothing.
        FrameHistory other = *left;
        other.cells.push_back(1);
        problem.history = std::make_shared<const FrameHistory>(other);
        const auto unknown = lit.method().start(problem);
        EXPECT_TRUE(
            std::equal(unknown->seeds().begin(), unknown->seeds().end(), plain->seeds().begin(), plain->seeds().end()));
    }
    EXPECT_GT(more_seeds, 4u);
    EXPECT_GT(without, 10u);
}
TEST(Transmittance, TriSeenStartsFromWhatShowedBefore2d) { expect_seen_before<2>(); }
TEST(Transmittance, TriSeenStartsFromWhatShowedBefore3d) { expect_seen_before<3>(); }

TEST(Transmittance, TriRendersAllThatFluxDoes2d) { expect_all_rendered<2>(); }
TEST(Transmittance, TriRendersAllThatFluxDoes3d) { expect_all_rendered<3>(); }

/// With a picture as fine as the reference nothing is missing when the last box has been tested; in the end all that is
/// in view is there.
template <int D>
void expect_feedback(const char* parameters) {
    Random random(130 + D);
    int complete = 0;
    for (int round = 0; round < test::soak_count(15); ++round) {
        LitScene<D> lit(random, "tri-z");
        lit.settings.reference_size = D == 2 ? ImageSize{256, 0} : ImageSize{96, 72};
        for (const char* const set : {"detail=1", parameters}) apply_setting(lit.settings, set);
        Problem<D> problem = lit.problem();
        problem.services.image = lit.settings.reference_size;
        const auto run = lit.method().start(problem);
        const Truth truth = make_truths<D>(lit.scene, std::array<const CellComplex<D>*, 1>{&lit.cells}, lit.view,
                                           lit.settings.reference_size, {}, false)
                                .front();
        while (run->misses() == Misses::may && run->run(1) == Stop::steps) {
        }
        std::vector<std::uint8_t> rendered = rendered_mask(run->met(), lit.scene.primitives.size());
        for (const std::uint32_t id : truth.reference.image.ids)
            if (id != none) EXPECT_TRUE(rendered[id]) << "primitive " << id << " in round " << round;
        complete += run->steps() > 0;
        run->run(none);
        EXPECT_TRUE(run->finished());
        rendered = rendered_mask(run->met(), lit.scene.primitives.size());
        for (std::uint32_t p = 0; p < lit.scene.primitives.size(); ++p)
            if (rendered[p]) EXPECT_TRUE(shows(problem, p)) << p;
    }
    EXPECT_GT(complete, 10);
}
/// Also from so far that the picture shows nothing of the scene: in the end it has rendered what view culling renders.
template <int D>
void expect_feedback_has_all_in_view() {
    Random random(150 + D);
    std::size_t rendered = 0;
    int far_away = 0;
    for (int round = 0; round < test::soak_count(60); ++round) {
        LitScene<D> lit(random, "tri-z");
        lit.settings.reference_size = D == 2 ? ImageSize{256, 0} : ImageSize{96, 72};
        apply_setting(lit.settings, "detail=" + number_text(random.below(4) == 0 ? 1 : random.uniform(0.05, 1)));
        apply_setting(lit.settings, random.below(2) ? "maximise=pixels" : "maximise=count");
        ViewSpec<D> spec{{}, Vec<D>(0.5), random.uniform(20, 120)};
        const double reach = std::pow(10, random.uniform(0, 6));
        for (int i = 0; i < D; ++i) spec.eye[i] = 0.5 + reach * random.uniform(-1, 1);
        if (D == 2 && random.below(3) == 0) spec.fov = 360;
        lit.view = scene_view(spec, lit.scene, lit.settings.reference_size);
        Problem<D> problem = lit.problem();
        problem.services.image = lit.settings.reference_size;
        const auto run = lit.method().start(problem), all = find_method<D>(method_table<D>(), "view").start(problem);
        run->run(none);
        all->run(none);
        EXPECT_TRUE(run->finished());
        EXPECT_EQ(run->misses(), Misses::none);
        const std::size_t count = lit.scene.primitives.size();
        EXPECT_EQ(rendered_mask(run->met(), count), rendered_mask(all->met(), count)) << "round " << round;
        rendered += all->counters().rendered_count;
        far_away += reach > 1000 && all->counters().rendered_count > 0;
    }
    EXPECT_GT(rendered, 500u);
    EXPECT_GT(far_away, 10);
}
TEST(Transmittance, FeedbackRendersAllThatIsInViewInTheEnd2d) { expect_feedback_has_all_in_view<2>(); }
TEST(Transmittance, FeedbackRendersAllThatIsInViewInTheEnd3d) { expect_feedback_has_all_in_view<3>(); }

TEST(Transmittance, FeedbackAsFineAsTheReferenceMissesNothing2d) { expect_feedback<2>("maximise=count"); }
TEST(Transmittance, FeedbackAsFineAsTheReferenceMissesNothing3d) { expect_feedback<3>("maximise=count"); }
TEST(Transmittance, FeedbackByPixelsMissesNothingEither2d) { expect_feedback<2>("maximise=pixels"); }
TEST(Transmittance, FeedbackByPixelsMissesNothingEither3d) { expect_feedback<3>("maximise=pixels"); }

}  // namespace
}  // namespace sightline
