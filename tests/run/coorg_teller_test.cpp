// Culling in object space: nothing visible is culled, and what saves time changes nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/coorg_teller.h"

#include <gtest/gtest.h>

#include <map>

#include "core/methods/coorg_teller/visible_run.h"
#include "core/methods/method_table.h"
#include "core/run/timeline.h"
#include "core/space/builders.h"
#include "core/truth/software_ids.h"
#include "core/truth/visible_set.h"
#include "tests/run/naive_clipping.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"
#include "tests/space/random_cells.h"

namespace sightline {
namespace {

template <int D>
struct ObjectSpaceCase {
    Scene<D> scene;
    CellComplex<D> cells;
    View<D> view;
    std::vector<ViewSpec<D>> walk;  ///< eyes that follow each other closely

    Problem<D> problem(const Variant<D>& variant) const {
        return make_problem(variant.method, variant.parameters, scene, cells, view);
    }
};

/// A box of two triangles a side, fronts outward.
void add_box(Scene<3>& scene, const Vec<3>& low, const Vec<3>& high) {
    const Box<3> box{low, high};
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : faces) {
        scene.primitives.push_back({box.corner(a), box.corner(b), box.corner(c)});
        scene.primitives.push_back({box.corner(a), box.corner(c), box.corner(d)});
    }
}

/// Walls that partly join, boxes, and small things between and behind them.
ObjectSpaceCase<2> fill(Random& random, ObjectSpaceCase<2> made) {
    made.scene = test::random_scene(random, random.below(400));
    // A polyline of walls round the middle, with corners that turn either way.
    const std::size_t corners = 2 + random.below(8);
    Vec<2> last;
    for (std::size_t i = 0; i < corners; ++i) {
        const Vec<2> corner(0.1 + 0.8 * static_cast<double>(i) / static_cast<double>(corners),
                            random.uniform(0.4, random.below(2) ? 0.5 : 0.9));
        if (i > 0 && corner != last) made.scene.primitives.push_back({last, corner});
        last = corner;
    }
    ViewSpec<2> spec = test::random_view(random);
    if (random.below(3) == 0) spec.fov = 360;
    made.view = make_view(spec);
    const Vec<2> step(random.uniform(-0.005, 0.005), random.uniform(-0.005, 0.005));
    for (int i = 0; i < 12; ++i) {
        made.walk.push_back(spec);
        spec.eye += step;
        spec.look_at += step;
    }
    return made;
}

ObjectSpaceCase<3> fill(Random& random, ObjectSpaceCase<3> made) {
    const auto grid = [&](double low, double high) { return std::floor(random.uniform(low, high) * 64) / 64; };
    const std::uint64_t boxes = random.below(12);
    for (std::uint64_t i = 0; i < boxes; ++i) {
        const Vec<3> low(grid(0, 0.9), grid(0, 0.9), grid(0, 0.5));
        add_box(made.scene, low, low + Vec<3>(grid(0.05, 0.5), grid(0.05, 0.5), grid(0.05, 0.5)));
    }
    // Rows of boxes that share faces, so that their fronts are connected.
    if (random.below(2)) {
        const double y = grid(0.3, 0.7);
        for (int i = 0; i < 4; ++i) add_box(made.scene, {i / 4.0, y, 0}, {(i + 1) / 4.0, y + 0.0625, grid(0.3, 0.9)});
    }
    for (Primitive<3> triangle : test::random_triangles(random, random.below(600))) {
        for (std::size_t k = 1; k < 3; ++k) triangle[k] = triangle[0] + (triangle[k] - triangle[0]) * 0.1;
        made.scene.primitives.push_back(triangle);
    }
    made.scene.two_sided.assign(made.scene.primitives.size(), 0);
    for (auto& side : made.scene.two_sided) side = random.below(8) == 0;
    const double reach = random.below(2) == 0 ? 1.0 : 0;
    const auto point = [&](double low, double high) {
        return Vec<3>(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
    };
    ViewSpec<3> spec{point(-reach, 1 + reach), point(0.2, 0.8), random.uniform(20, 120)};
    made.view = make_view(spec, 4.0 / 3);
    const Vec<3> step = point(-0.005, 0.005);
    for (int i = 0; i < 8; ++i) {
        made.walk.push_back(spec);
        spec.eye += step;
        spec.look_at += step;
    }
    return made;
}

template <int D>
ObjectSpaceCase<D> random_object_case(Random& random) {
    ObjectSpaceCase<D> made = fill(random, ObjectSpaceCase<D>{});
    made.cells = build_cells(made.scene, TessellationSettings{.error_bound = 0.3});
    return made;
}

std::vector<std::uint8_t> seen(const Scene<2>& scene, const View<2>& view) {
    return exact_visible_set(scene.primitives, view).visible;
}
std::vector<std::uint8_t> seen(const Scene<3>& scene, const View<3>& view) {
    std::vector<std::uint8_t> visible(scene.primitives.size());
    const IdImage image = draw_ids_in_software(scene, view, {160, 120}, 1).front();
    for (const std::uint32_t id : image.ids)
        if (id != none) visible[id] = 1;
    return visible;
}

template <int D>
const std::vector<const char*>& forms() {
    static const std::vector<const char*> all = {
        "coorg-teller",
        "coorg-teller tree=octree leaf=1",
        "coorg-teller connected=on",
        "coorg-teller connected=grow",
        "coorg-teller connected=fused threshold=0.001",
        "coorg-teller connected=on threshold=0.0001 leaf=2",
        "coorg-teller connected=grow occluder_count=200 threshold=0.0001 leaf=1",
        "shadow-frusta",
        "coorg-teller leaves=polygons",
        "coorg-teller leaves=polygons connected=grow occluder_count=100 threshold=0.001",
        "coorg-teller leaves=polygons connected=fused leaf=30 threshold=0.001",
        "shadow-frusta leaves=polygons",
        "shadow-frusta shadows=30 threshold=0.0001 leaf=2"};
    return all;
}

template <int D>
void nothing_visible_is_culled(std::uint64_t seed, int count) {
    Random random(seed);
    std::map<std::string, std::array<std::size_t, 3>> met;
    for (int i = 0; i < count; ++i) {
        const ObjectSpaceCase<D> made = random_object_case<D>(random);
        const std::vector<std::uint8_t> visible = seen(made.scene, made.view);
        for (const char* const text : forms<D>()) {
            SCOPED_TRACE(testing::Message() << i << ' ' << text);
            const Variant<D> variant = make_variant<D>(method_table<D>(), text);
            const auto run = variant.method.start(made.problem(variant));
            while (!run->finished()) {
                ASSERT_EQ(run->misses(), Misses::may);
                ASSERT_EQ(run->run(1), Stop::steps);
            }
            ASSERT_EQ(run->misses(), Misses::none);
            const auto rendered = rendered_mask(run->met(), visible.size());
            auto& counts = met[text];
            for (std::size_t p = 0; p < visible.size(); ++p) {
                ASSERT_LE(visible[p], rendered[p]) << p;
                counts[0] += visible[p];
                counts[1] += rendered[p];
            }
            const BoxTree<D>& tree = *run->boxes();
            for (std::uint32_t node = 0; node < tree.nodes.size(); ++node)
                counts[2] += run->mark(Item{node, Kind::node}).state == CellState::hidden;
        }
    }
    for (const auto& [text, counts] : met) {  // or the test tells nothing
        EXPECT_GT(counts[1], counts[0]) << text;
        EXPECT_GT(counts[2], 20u) << text;
    }
}

TEST(CoorgTeller, NothingVisibleIsCulled2d) { nothing_visible_is_culled<2>(1601, test::soak_count(100)); }
TEST(CoorgTeller, NothingVisibleIsCulled3d) { nothing_visible_is_culled<3>(1602, test::soak_count(60)); }

template <int D>
std::unique_ptr<VisibleRun<D>> start(const ObjectSpaceCase<D>& made, const Variant<D>& variant,
                                     std::shared_ptr<const FrameHistory> history = nullptr) {
    Problem<D> problem = made.problem(variant);
    problem.history = std::move(history);
    return std::make_unique<VisibleRun<D>>(
        problem, variant.method.id == "shadow-frusta" ? OccluderKind::convex : OccluderKind::polygon);
}

View<2> looking(const ViewSpec<2>& spec) { return make_view(spec); }
View<3> looking(const ViewSpec<3>& spec) { return make_view(spec, 4.0 / 3); }

/// Along a walk, a run that keeps what it knows ends like one that knows nothing, in every frame.
template <int D>
void kept_is_fresh(std::uint64_t seed, int count) {
    Random random(seed);
    Effort kept, fresh;
    for (int i = 0; i < count; ++i) {
        ObjectSpaceCase<D> made = random_object_case<D>(random);
        for (const char* const text : forms<D>()) {
            SCOPED_TRACE(testing::Message() << i << ' ' << text);
            const Variant<D> with = make_variant<D>(method_table<D>(), text);
            const Variant<D> without = make_variant<D>(method_table<D>(), std::string(text) + " coherence=off");
            std::unique_ptr<VisibleRun<D>> goes_on;
            for (const ViewSpec<D>& spec : made.walk) {
                made.view = looking(spec);
                if (goes_on)
                    ASSERT_TRUE(goes_on->restart(made.problem(with)));
                else
                    goes_on = start(made, with);
                goes_on->run(none, nullptr);
                const auto anew = start(made, without);
                anew->run(none, nullptr);
                ASSERT_EQ(goes_on->hash(), anew->hash());
                kept += goes_on->effort();
                fresh += anew->effort();
            }
        }
    }
    EXPECT_EQ(kept.boxes, fresh.boxes);
    EXPECT_EQ(fresh.kept, 0u);
    EXPECT_EQ(fresh.reused, 0u);
    // Much was kept, or the test tells nothing.
    EXPECT_GT(kept.kept, kept.boxes / 3);
    EXPECT_LT(kept.products, fresh.products);
    EXPECT_GT(kept.changed, 0u);
}
TEST(CoorgTeller, WhatIsKeptChangesNothing2d) { kept_is_fresh<2>(1603, test::soak_count(20)); }
TEST(CoorgTeller, WhatIsKeptChangesNothing3d) { kept_is_fresh<3>(1604, test::soak_count(20)); }

template <int D>
void side_by_side(std::uint64_t seed, int count) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        ObjectSpaceCase<D> made = random_object_case<D>(random);
        for (const char* const text : {"coorg-teller connected=grow leaf=1",
                                       "coorg-teller leaves=polygons connected=on", "shadow-frusta leaf=1"}) {
            const Variant<D> alone = make_variant<D>(method_table<D>(), text);
            const Variant<D> together = make_variant<D>(method_table<D>(), std::string(text) + " workers=4");
            std::unique_ptr<VisibleRun<D>> one, many;
            for (const ViewSpec<D>& spec : made.walk) {
                made.view = looking(spec);
                if (!one) {
                    one = start(made, alone);
                    many = start(made, together);
                } else {
                    one->restart(made.problem(alone));
                    many->restart(made.problem(together));
                }
                one->run(none, nullptr);
                many->run(none, nullptr);
                ASSERT_EQ(one->hash(), many->hash()) << i << ' ' << text;
                ASSERT_EQ(one->effort().boxes, many->effort().boxes);
                for (std::uint32_t node = 0; node < many->boxes()->nodes.size(); ++node) {
                    const bool tested = many->mark(Item{node, Kind::node}).state != CellState::clean;
                    ASSERT_EQ(many->worker_of(node) != none, tested);
                }
            }
        }
    }
}
TEST(CoorgTeller, WorkersChangeNothing2d) { side_by_side<2>(1605, test::soak_count(10)); }
TEST(CoorgTeller, WorkersChangeNothing3d) { side_by_side<3>(1606, test::soak_count(10)); }

/// More occluders together never draw more: each box that single ones hide is hidden, or lies in one that is.
template <int D>
void more_is_never_less(std::uint64_t seed, int count) {
    Random random(seed);
    std::map<std::string, std::size_t> drawn;
    for (int i = 0; i < count; ++i) {
        const ObjectSpaceCase<D> made = random_object_case<D>(random);
        const auto mask_of = [&](const std::string& text) {
            const Variant<D> variant = make_variant<D>(method_table<D>(), text + " threshold=0.001");
            const auto run = start(made, variant);
            run->run(none, nullptr);
            drawn[text] += run->met().size();
            return rendered_mask(run->met(), made.scene.primitives.size());
        };
        const auto single = mask_of("coorg-teller"), on = mask_of("coorg-teller connected=on"),
                   grow = mask_of("coorg-teller connected=grow"), fused = mask_of("coorg-teller connected=fused");
        for (std::size_t p = 0; p < single.size(); ++p) {
            ASSERT_LE(on[p], single[p]) << i;
            ASSERT_LE(grow[p], on[p]) << i;
            if constexpr (D == 2) {
                ASSERT_LE(fused[p], grow[p]) << i;
            }
        }
    }
    EXPECT_LT(drawn["coorg-teller connected=on"], drawn["coorg-teller"]);
    EXPECT_LE(drawn["coorg-teller connected=grow"], drawn["coorg-teller connected=on"]);
    if (D == 2) {
        EXPECT_LT(drawn["coorg-teller connected=fused"], drawn["coorg-teller connected=grow"]);
    }
}
TEST(CoorgTeller, TogetherTheyHideNoLess2d) { more_is_never_less<2>(1607, test::soak_count(60)); }
TEST(CoorgTeller, TogetherTheyHideNoLess3d) { more_is_never_less<3>(1608, test::soak_count(60)); }

/// Steps, back, seek: the same hash at the same step, however it was reached; steps by change hold the same boxes.
template <int D>
void walks(std::uint64_t seed, int count) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        ObjectSpaceCase<D> made = random_object_case<D>(random);
        for (const char* const text :
             {"coorg-teller connected=on leaf=2", "coorg-teller step=change leaf=2", "shadow-frusta leaf=4"}) {
            SCOPED_TRACE(testing::Message() << i << ' ' << text);
            const Variant<D> variant = make_variant<D>(method_table<D>(), text);
            made.view = looking(made.walk[0]);
            const auto before = start(made, variant);
            before->run(none, nullptr);
            made.view = looking(made.walk[1]);
            Problem<D> problem = made.problem(variant);
            problem.history = before->next_history();
            if (random.below(2)) problem.budget = static_cast<std::uint32_t>(random.below(60));
            OwnRun<D> run(variant.method.start(problem));
            Timeline<D> timeline;
            timeline.begin(*run);
            std::vector<std::uint64_t> hashes{run->hash()};
            while (timeline.forward(run) == Stop::none) hashes.push_back(run->hash());
            // Without a recording it ends alike.
            const auto whole = variant.method.start(problem);
            whole->run(none, nullptr);
            ASSERT_EQ(whole->hash(), hashes.back());
            for (int k = 0; k < 60; ++k) {
                const auto choice = random.below(3);
                if (choice == 0)
                    timeline.back(run);
                else if (choice == 1 && run->steps() < timeline.size())
                    timeline.forward(run);
                else
                    timeline.seek(run, static_cast<std::uint32_t>(random.below(timeline.size() + 1)));
                ASSERT_EQ(run->hash(), hashes[run->steps()]);
                if (k % 10 == 0) {  // from here on it goes as it went
                    const auto again = run->clone();
                    again->run(none, nullptr);
                    ASSERT_EQ(again->hash(), hashes.back());
                }
            }
        }
    }
}
TEST(CoorgTeller, Walks2d) { walks<2>(1609, test::soak_count(40)); }
TEST(CoorgTeller, Walks3d) { walks<3>(1610, test::soak_count(40)); }

/// What a run says of a hidden box is true, plane by plane, and what it says of a drawn one names a plane that fails.
/// Where the box lies beyond the occluder, satisfied means that the eye lies on the occluder's side of the plane.
template <int D>
void words_are_true(std::uint64_t seed, int count) {
    Random random(seed);
    std::size_t hidden = 0, partial = 0;
    for (int i = 0; i < count; ++i) {
        const ObjectSpaceCase<D> made = random_object_case<D>(random);
        const Variant<D> variant =
            make_variant<D>(method_table<D>(),
                            std::string("coorg-teller leaf=2 threshold=0.001 connected=") + (i % 3 == 0   ? "off"
                                                                                             : i % 3 == 1 ? "on"
                                                                                                          : "fused"));
        const auto run = start(made, variant);
        run->run(none, nullptr);
        for (std::uint32_t node = 0; node < run->boxes()->nodes.size(); ++node) {
            const Item item{node, Kind::node};
            const auto planes = run->tested_planes(item, none);
            if (run->mark(item).state == CellState::hidden) {
                ++hidden;
                ASSERT_FALSE(planes.empty());
                for (const auto& plane : planes) {
                    ASSERT_TRUE(plane.satisfied) << i << " node " << node;
                    ASSERT_GE(plane.distance, 0);
                }
                ASSERT_NE(run->why_not(item).sentence.find("INVISIBLE"), std::string::npos);
            } else if (run->mark(item).state == CellState::projected && !planes.empty()) {
                ++partial;
                const bool is_visible = run->why_drawn(item).reason == "visible";
                const bool any_fails = std::any_of(planes.begin(), planes.end(), [&](const auto& plane) {
                    return !plane.satisfied && (is_visible || plane.kind != PlaneKind::separating);
                });
                ASSERT_TRUE(any_fails) << i << " node " << node;
                for (const auto& plane : planes)
                    ASSERT_TRUE(plane.satisfied || is_visible || plane.kind != PlaneKind::separating);
                ASSERT_NE(run->why_drawn(item).sentence.find(is_visible ? "nothing of it, as" : "but"),
                          std::string::npos);
            }
        }
    }
    EXPECT_GT(hidden, 0u);
    EXPECT_GT(partial, 0u);
}
TEST(CoorgTeller, WhatItSaysIsTrue2d) { words_are_true<2>(1611, test::soak_count(40)); }
TEST(CoorgTeller, WhatItSaysIsTrue3d) { words_are_true<3>(1612, test::soak_count(40)); }

/// Whatever could be seen in a leaf that is drawn and was left out says who hides it.
template <int D>
void left_out_is_hidden(std::uint64_t seed, int count) {
    Random random(seed);
    std::size_t left_out = 0;
    for (int i = 0; i < count; ++i) {
        const ObjectSpaceCase<D> made = random_object_case<D>(random);
        const Variant<D> variant =
            make_variant<D>(method_table<D>(), "coorg-teller leaves=polygons connected=on leaf=20 threshold=0.001");
        const auto run = start(made, variant);
        run->run(none, nullptr);
        for (std::uint32_t node = 0; node < run->boxes()->nodes.size(); ++node) {
            if (run->boxes()->nodes[node].first_child != none ||
                run->mark(Item{node, Kind::node}).state != CellState::projected)
                continue;
            for (const std::uint32_t primitive : run->boxes()->primitives_of(node)) {
                const Verdict verdict = run->why_not(primitive_item(primitive));
                const bool is_left_out = !run->drawn().has(primitive) && shows(run->problem(), primitive);
                left_out += is_left_out;
                ASSERT_TRUE(!is_left_out || verdict.reason == "hidden") << i << ' ' << primitive;
                ASSERT_TRUE(!run->drawn().has(primitive) || !verdict) << i << ' ' << primitive;
            }
        }
    }
    EXPECT_GT(left_out, 20u);
}
TEST(CoorgTeller, WhatIsLeftOutIsHidden2d) { left_out_is_hidden<2>(1615, test::soak_count(20)); }
TEST(CoorgTeller, WhatIsLeftOutIsHidden3d) { left_out_is_hidden<3>(1616, test::soak_count(10)); }

/// A parameter that another method was given says nothing to one that does not have it.
template <int D>
void others_parameters_say_nothing(std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < 40; ++i) {
        const ObjectSpaceCase<D> made = random_object_case<D>(random);
        const Variant<D> variant =
            make_variant<D>(method_table<D>(), "shadow-frusta shadows=30 threshold=0.001 leaf=2");
        Problem<D> problem = made.problem(variant);
        const auto run = variant.method.start(problem);
        run->run(none);
        problem.parameters.set(connected_row(), D == 2 ? "fused" : "grow");
        const auto with = variant.method.start(problem);
        with->run(none);
        ASSERT_EQ(with->hash(), run->hash()) << i;
    }
}
TEST(CoorgTeller, ParametersOfAnotherMethodSayNothing2d) { others_parameters_say_nothing<2>(1617); }
TEST(CoorgTeller, ParametersOfAnotherMethodSayNothing3d) { others_parameters_say_nothing<3>(1618); }

/// Against figure 2's naive way: what is INVISIBLE leaves nothing when all occluders are clipped away from it; in 2D,
/// with fused shadows, what leaves nothing is INVISIBLE, as long as it lies beyond them.
template <int D>
void naive_clipping_agrees(std::uint64_t seed, int count) {
    Random random(seed);
    std::map<std::string, std::array<std::size_t, 3>> met;
    for (int i = 0; i < count; ++i) {
        const ObjectSpaceCase<D> made = random_object_case<D>(random);
        for (const std::string text : {"coorg-teller connected=off", "coorg-teller connected=on",
                                       "coorg-teller connected=grow", "coorg-teller connected=fused"}) {
            const Variant<D> variant = make_variant<D>(method_table<D>(), text + " leaf=2 threshold=0.001");
            const auto run = start(made, variant);
            run->run(none, nullptr);
            const auto shadows = run->states().shadows();
            auto& [hidden, clipped, not_hidden] = met[text];
            for (std::uint32_t node = 0; node < run->boxes()->nodes.size(); ++node) {
                const CellState state = run->mark(Item{node, Kind::node}).state;
                if (state != CellState::hidden && state != CellState::projected) continue;
                const Box<D>& box = run->boxes()->nodes[node].box;
                const double left = test::left_of<D>(box, shadows, made.view.eye);
                if (state == CellState::hidden) {
                    ++hidden;
                    ASSERT_LT(left, 1e-9) << i << ' ' << text << " node " << node;
                } else if (left == 0 && test::left_of<D>(box, {}, made.view.eye) > 0) {  // not one seen edge-on
                    // Not hidden, though nothing of it is seen: occluders that fail to meet, or that it lies between.
                    ++clipped;
                    const bool beyond_all = std::all_of(shadows.begin(), shadows.end(), [&](const Shadow<D>& shadow) {
                        std::uint64_t products = 0;
                        const Relation found = relation(shadow, made.scene, EyeBox<D>(box, made.view.eye), products);
                        return found.region == Region::visible || found.beyond;
                    });
                    not_hidden += beyond_all;
                }
            }
        }
    }
    for (const auto& [text, counts] : met) EXPECT_GT(counts[0], 50u) << text;
    EXPECT_GT(met["coorg-teller connected=off"][2], 0u);
    if constexpr (D == 2) {
        EXPECT_EQ(met["coorg-teller connected=fused"][2], 0u);
    }
}
TEST(CoorgTeller, NaiveClippingAgrees2d) { naive_clipping_agrees<2>(1613, test::soak_count(60)); }
TEST(CoorgTeller, NaiveClippingAgrees3d) { naive_clipping_agrees<3>(1614, test::soak_count(20)); }

}  // namespace
}  // namespace sightline
