// Methods that walk the tree of boxes: nothing that a pixel shows is missed, and what saves time changes nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/image_space/image_methods.h"

#include <gtest/gtest.h>

#include <map>

#include "core/methods/image_space/box_run.h"
#include "core/methods/orders/orders.h"
#include "core/space/builders.h"
#include "core/truth/software_ids.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"
#include "tests/space/random_cells.h"

namespace sightline {
namespace {

template <int D>
struct BoxCase {
    Scene<D> scene;
    CellComplex<D> cells;
    View<D> view, before;  ///< this frame's and the last one's
    ImageSize size = D == 2 ? ImageSize{512, 0} : ImageSize{80, 60};

    Problem<D> problem(const Variant<D>& variant, int threads = 1,
                       std::shared_ptr<const FrameHistory> history = nullptr) const {
        Services services;
        services.image = size;
        services.threads = threads;
        return make_problem(variant.method, variant.parameters, scene, cells, view, none, services, std::move(history));
    }
};

/// Across the middle of the view, near the eye, so that much is hidden.
void add_wall(Scene<2>& scene, const View<2>& view) {
    const Vec<2> ahead = (view.look_at - view.eye) * 0.3, beside(-ahead.y, ahead.x);
    scene.primitives.push_back({view.eye + ahead + beside * 0.8, view.eye + ahead - beside * 0.8});
}
void add_wall(Scene<3>& scene, const View<3>& view) {
    const auto corner = [&](int i) { return view.eye + (view.corners[static_cast<std::size_t>(i)] - view.eye) * 0.1; };
    scene.primitives.push_back({corner(0), corner(1), corner(2)});
    scene.primitives.push_back({corner(0), corner(2), corner(3)});
    for (auto* const triangle : {&scene.primitives.back(), &*(scene.primitives.end() - 2)})
        for (Vec<3>& point : *triangle) point = view.eye + (point - view.eye) * 0.9 + view.forward() * 0.02;
    scene.two_sided.resize(scene.primitives.size(), 1);
}

template <int D>
BoxCase<D> random_box_case(Random& random) {
    BoxCase<D> made;
    if constexpr (D == 2) {
        made.scene = test::random_scene(random, random.below(1500));
        ViewSpec<2> spec = test::random_view(random);
        made.view = make_view(spec);
        spec.eye.x += 0.001;
        made.before = make_view(spec);
    } else {
        // Many small ones behind a few large ones.
        made.scene.primitives = test::random_triangles(random, random.below(20));
        for (Primitive<3> triangle : test::random_triangles(random, random.below(3000))) {
            for (std::size_t k = 1; k < 3; ++k) triangle[k] = triangle[0] + (triangle[k] - triangle[0]) * 0.1;
            made.scene.primitives.push_back(triangle);
        }
        made.scene.two_sided.assign(made.scene.primitives.size(), 1);
        for (auto& side : made.scene.two_sided) side = random.below(3) > 0;
        const double reach = random.below(2) == 0 ? 1.5 : 0;
        const auto point = [&](double low, double high) {
            return Vec<3>(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
        };
        ViewSpec<3> spec{point(-reach, 1 + reach), point(0.2, 0.8), random.uniform(20, 120)};
        made.view = make_view(spec, 4.0 / 3);
        spec.eye.x += 0.001;
        made.before = make_view(spec, 4.0 / 3);
    }
    if (random.below(3) > 0) add_wall(made.scene, made.view);
    made.cells = build_cells(made.scene, TessellationSettings{.error_bound = 0.3});
    return made;
}

IdImage image_ids(const BoxCase<2>& c) { return item_row(c.scene, c.view, c.size); }
IdImage image_ids(const BoxCase<3>& c) { return draw_ids_in_software(c.scene, c.view, c.size, 1).front(); }

constexpr std::array conservative{"boxes",
                                  "boxes refresh=1",
                                  "boxes refresh=3 occluders=plp occluder_share=0.1",
                                  "boxes draws=whole refresh=2",
                                  "boxes occluders=largest",
                                  "hzb",
                                  "hzb draws=whole",
                                  "hom",
                                  "hom occluder_share=0.2 occluders=plp",
                                  "hom draws=winners",
                                  "two-pass",
                                  "two-pass occluders=none",
                                  "two-pass draws=whole occluders=largest occluder_share=0.3"};

template <int D>
void no_pixel_is_missed(std::uint64_t seed, int count) {
    Random random(seed);
    std::map<std::string, std::array<std::size_t, 3>> met;
    for (int i = 0; i < count; ++i) {
        BoxCase<D> made = random_box_case<D>(random);
        const IdImage exact = image_ids(made);
        std::vector<std::uint8_t> seen(made.scene.primitives.size());
        for (const std::uint32_t id : exact.ids)
            if (id != none) seen[id] = 1;
        for (const char* const text : conservative) {
            SCOPED_TRACE(testing::Message() << i << ' ' << text);
            const Variant<D> variant = make_variant<D>(method_table<D>(), text);
            std::shared_ptr<const FrameHistory> history;
            if (i % 2) {
                BoxCase<D> last = made;
                last.view = made.before;
                const auto run = variant.method.start(last.problem(variant));
                run->run(none);
                history = run->next_history();
            }
            const Problem<D> problem = made.problem(variant, 1, history);
            const auto run = variant.method.start(problem);
            while (!run->finished()) {
                ASSERT_EQ(run->misses(), Misses::may);
                ASSERT_EQ(run->run(1), Stop::steps);
            }
            ASSERT_EQ(run->misses(), Misses::none_at_this_resolution);
            const auto rendered = rendered_mask(run->met(), seen.size());
            auto& counts = met[text];
            for (std::size_t p = 0; p < seen.size(); ++p) {
                ASSERT_LE(seen[p], rendered[p]) << p;
                counts[0] += seen[p];
                counts[1] += rendered[p];
            }
            // Whatever is called hidden could change nothing, and says what hides it.
            const BoxTree<D>& tree = problem.boxes();
            for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
                const Item item{node, Kind::node};
                if (run->mark(item).state != CellState::hidden) continue;
                ++counts[2];
                for (const std::uint32_t primitive : tree.primitives_of(node)) ASSERT_FALSE(seen[primitive]);
                const Verdict verdict = run->why_not(item);
                ASSERT_EQ(verdict.reason, "hidden");
                ASSERT_NE(verdict.sentence.find(D == 2 ? "behind segment" : "behind triangle"), std::string::npos)
                    << verdict.sentence;
            }
            // In one go, by several threads.
            const auto whole = variant.method.start(made.problem(variant, 2, history));
            whole->run(none);
            ASSERT_EQ(whole->hash(), run->hash());
            // What the next frame is told was visible is what an image shows.
            ASSERT_EQ(run->next_history()->visible, seen);
        }
    }
    for (const auto& [text, counts] : met) {
        EXPECT_GT(counts[0], 50u) << text;
        // Where depths are refreshed only when there are none yet, nothing can be hidden.
        const bool blind = text == "boxes" || text == "two-pass occluders=none";
        if (!blind) {
            EXPECT_GT(counts[2], 20u) << text << ": nothing was hidden";
        }
        if (text == "boxes refresh=1" || text == "hzb" || text == "two-pass") {
            EXPECT_LT(counts[1], 6 * counts[0]) << text << ": nearly all was drawn";
        }
    }
    EXPECT_LT(met["boxes refresh=1"][1], met["boxes draws=whole refresh=2"][1]);
}

TEST(ImageSpace, InThePlaneNothingThatAPixelShowsIsMissed) { no_pixel_is_missed<2>(91, test::soak_count(30)); }
TEST(ImageSpace, InSpaceNothingThatAPixelShowsIsMissed) { no_pixel_is_missed<3>(92, test::soak_count(30)); }

template <int D>
void refreshing_changes_what_is_tested_not_what_is_drawn(std::uint64_t seed) {
    Random random(seed);
    std::size_t fewer = 0;
    for (int i = 0; i < test::soak_count(20); ++i) {
        const BoxCase<D> made = random_box_case<D>(random);
        std::vector<std::uint32_t> drawn;
        std::uint32_t steps = 0;
        for (const char* const text : {"boxes refresh=1", "boxes refresh=2", "boxes refresh=50", "boxes"}) {
            const Variant<D> variant = make_variant<D>(method_table<D>(), text);
            const auto run = variant.method.start(made.problem(variant));
            run->run(none);
            const std::vector<std::uint32_t> now = rendered_ids(run->met());
            if (drawn.empty()) drawn = now;
            ASSERT_EQ(now, drawn) << text;
            ASSERT_GE(run->steps(), steps) << text;
            fewer += run->steps() > steps && steps > 0;
            steps = run->steps();
        }
    }
    EXPECT_GT(fewer, 5u);
}

TEST(ImageSpace, RefreshingChangesWhatIsTestedNotWhatIsDrawn) {
    refreshing_changes_what_is_tested_not_what_is_drawn<2>(93);
    refreshing_changes_what_is_tested_not_what_is_drawn<3>(94);
}

template <int D>
void view_culling_draws_what_is_in_view(std::uint64_t seed) {
    Random random(seed);
    std::size_t drawn = 0, left_out = 0, whole = 0;
    for (int i = 0; i < test::soak_count(60); ++i) {
        const BoxCase<D> made = random_box_case<D>(random);
        const Variant<D> variant = make_variant<D>(method_table<D>(), "view");
        const Problem<D> problem = made.problem(variant);
        const auto run = variant.method.start(problem);
        run->run(none);
        ASSERT_EQ(run->misses(), Misses::none);
        const auto rendered = rendered_mask(run->met(), made.scene.primitives.size());
        for (std::uint32_t p = 0; p < rendered.size(); ++p) {
            ASSERT_EQ(rendered[p] != 0, shows(problem, p)) << p;
            (rendered[p] ? drawn : left_out) += 1;
        }
        const BoxTree<D>& tree = problem.boxes();
        for (std::uint32_t node = 0; node < tree.nodes.size(); ++node)
            whole += tree.nodes[node].first_child != none &&
                     run->mark({node, Kind::node}).state == CellState::projected &&
                     run->mark({tree.nodes[node].first_child, Kind::node}).state == CellState::clean;
    }
    EXPECT_GT(drawn, 1000u);
    EXPECT_GT(left_out, 1000u);
    EXPECT_GT(whole, 10u) << "boxes of which all is in view";
}

TEST(ImageSpace, ViewCullingDrawsWhatIsInView) {
    view_culling_draws_what_is_in_view<2>(95);
    view_culling_draws_what_is_in_view<3>(96);
}

TEST(ImageSpace, WhereLittleIsInViewNothingIsTested) {
    Random random(99);
    std::size_t tested = 0, left = 0;
    for (int i = 0; i < test::soak_count(40); ++i) {
        const BoxCase<3> made = random_box_case<3>(random);
        const auto start = [&](const char* text) {
            const Variant<3> variant = make_variant<3>(method_table<3>(), text);
            auto run = variant.method.start(made.problem(variant));
            run->run(none);
            return run;
        };
        const auto view = start("view"), boxes = start("boxes worth=8 refresh=2"), all = start("boxes refresh=2");
        // Back faces are in view too, so more lie in view than view culling draws.
        const auto drawn = rendered_mask(boxes->met(), made.scene.primitives.size());
        if (view->counters().rendered_count > static_cast<std::uint32_t>(made.size.width * made.size.height / 8)) {
            ASSERT_EQ(boxes->hash(), all->hash());
            ++tested;
        } else if (boxes->hash() != all->hash()) {
            ASSERT_EQ(drawn, rendered_mask(view->met(), made.scene.primitives.size()));
            ASSERT_EQ(boxes->misses(), Misses::none);
            ++left;
        }
    }
    EXPECT_GT(tested, 3u);
    EXPECT_GT(left, 3u);
}

TEST(ImageSpace, AMapWithHolesOverlooksGaps) {
    Random random(97);
    std::size_t missed = 0;
    for (int i = 0; i < 150; ++i) {
        const BoxCase<3> made = random_box_case<3>(random);
        const Variant<3> variant =
            make_variant<3>(method_table<3>(), "hom occluders=largest occluder_share=0.2 opacity=0.2");
        const auto run = variant.method.start(made.problem(variant));
        run->run(none);
        ASSERT_EQ(run->misses(), Misses::may) << "it does not say so";
        const auto rendered = rendered_mask(run->met(), made.scene.primitives.size());
        for (const std::uint32_t id : image_ids(made).ids) missed += id != none && !rendered[id];
    }
    EXPECT_GT(missed, 0u);
}

TEST(ImageSpace, WhatTheLastFrameSawIsDrawnFirst) {
    Random random(98);
    for (int i = 0; i < 20; ++i) {
        const BoxCase<3> made = random_box_case<3>(random);
        const Variant<3> variant = make_variant<3>(method_table<3>(), "two-pass");
        auto history = std::make_shared<FrameHistory>();
        std::vector<std::uint32_t> expected;
        const Problem<3> problem = made.problem(variant);
        for (std::uint32_t p = 0; p < made.scene.primitives.size(); ++p) {
            history->visible.push_back(random.below(4) == 0);
            if (history->visible.back() && shows(problem, p)) expected.push_back(p);
        }
        const auto run = variant.method.start(made.problem(variant, 1, history));
        run->run(static_cast<std::uint32_t>(expected.size() + 31) / 32);
        ASSERT_EQ(rendered_ids(run->met()), expected);
    }
}

}  // namespace
}  // namespace sightline
