// Cells and portals: nothing that can be seen is left out, from anywhere, and most of what cannot is.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "core/base/file.h"
#include "core/base/random.h"
#include "core/methods/method_table.h"
#include "core/run/timeline.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/plan_rooms.h"
#include "core/scene/read/read_wad.h"
#include "core/scene/scene_view.h"
#include "core/truth/reference.h"
#include "core/truth/software_ids.h"
#include "core/truth/visible_set.h"
#include "tests/scene/cast_rays.h"
#include "tests/soak.h"

namespace sightline {
namespace {

constexpr ImageSize portal_image{320, 240};

View<2> portal_view(const ViewSpec<2>& spec, const Scene<2>&) { return make_view(spec); }
View<3> portal_view(const ViewSpec<3>& spec, const Scene<3>& scene) { return make_view(spec, 4.0 / 3, scene.up_axis); }

std::vector<std::uint8_t> seen_from(const Scene<2>& scene, const View<2>& view) {
    return exact_visible_set(scene.primitives, view).visible;
}
std::vector<std::uint8_t> seen_from(const Scene<3>& scene, const View<3>& view) {
    std::vector<std::uint8_t> visible(scene.primitives.size());
    const IdImage image = draw_ids_in_software(scene, view, portal_image, 1).front();
    for (const std::uint32_t id : image.ids)
        if (id != none) visible[id] = 1;
    return visible;
}

/// Whether a ray through a pixel that shows the primitive meets it first. An image whose triangles are snapped to parts
/// of a pixel has cracks where an edge meets the middle of another one, through which it shows what is hidden.
bool is_really_seen(const Scene<2>&, const View<2>&, std::uint32_t) { return true; }
bool is_really_seen(const Scene<3>& scene, const View<3>& view, std::uint32_t primitive) {
    const IdImage image = draw_ids_in_software(scene, view, portal_image, 1).front();
    std::vector<Primitive<3>> fronts;
    std::size_t at = none;
    for (std::size_t p = 0; p < scene.primitives.size(); ++p) {
        if (p == primitive) at = fronts.size();
        if (shows_both_sides(scene, p) || faces(view, scene.primitives[p])) fronts.push_back(scene.primitives[p]);
    }
    for (int y = 0; y < portal_image.height; ++y)
        for (int x = 0; x < portal_image.width; ++x)
            if (image.ids[static_cast<std::size_t>(y * portal_image.width + x)] == primitive) {
                const Vec<3> ray = pixel_centre(view, portal_image, x, y) - view.eye;
                if (test::cast(fronts, view.eye, ray).triangle == at) return true;
            }
    return false;
}

/// A point in a room; in 3D away from what stands on the floor.
Vec<2> point_in(const Room<2>& room, Random& random) {
    double sum = 0;
    Vec<2> p(0);
    for (const Vec<2>& corner : room.shape) {
        const double weight = random.uniform(0.01, 1);
        p += weight * corner;
        sum += weight;
    }
    return p / sum;
}
Vec<3> point_in(const Room<3>& room, Random& random) {
    const double x = random.uniform(0.02, 0.98), y = random.uniform(0.02, 0.98), z = random.uniform(0.02, 0.98);
    return room.shape.min + room.shape.extent() * Vec<3>(x, y, z);
}

/// Counts over views: visible, hidden in view, and drawn of the hidden.
struct Culling {
    std::size_t views = 0, visible = 0, missed = 0, cracks = 0, hidden = 0, drawn_hidden = 0;
    double culled() const { return hidden == 0 ? 1 : 1 - double(drawn_hidden) / double(hidden); }
};

template <int D>
class CullingTest {
public:
    CullingTest(const Scene<D>& scene, std::string_view method)
        : scene_(scene), variant_(make_variant<D>(method_table<D>(), method)) {}

    void look(const ViewSpec<D>& spec) {
        const View<D> view = portal_view(spec, scene_);
        const std::vector<std::uint8_t> visible = seen_from(scene_, view);
        const Problem<D> problem = make_problem(variant_.method, variant_.parameters, scene_, cells_, view);
        run_.start(problem, variant_.method.start);
        run_->run(none);
        ASSERT_EQ(run_->misses(), Misses::none);
        const auto rendered = rendered_mask(run_->met(), visible.size());
        ++total.views;
        for (std::size_t p = 0; p < visible.size(); ++p) {
            total.visible += visible[p];
            if (visible[p] && !rendered[p] && !is_really_seen(scene_, view, static_cast<std::uint32_t>(p))) {
                ++total.cracks;
            } else if (visible[p] && !rendered[p]) {
                ++total.missed;
                ADD_FAILURE() << variant_.text << " misses primitive " << p << " of " << scene_.id << ", seen from "
                              << testing::PrintToString(std::vector<double>(&spec.eye[0], &spec.eye[0] + D))
                              << " toward "
                              << testing::PrintToString(std::vector<double>(&spec.look_at[0], &spec.look_at[0] + D))
                              << ": " << run_->why_not({static_cast<std::uint32_t>(p), Kind::primitive}).sentence;
            }
            if (visible[p] || !shows(problem, static_cast<std::uint32_t>(p))) continue;
            ++total.hidden;
            total.drawn_hidden += rendered[p];
        }
    }

    Culling total;

private:
    const Scene<D>& scene_;
    CellComplex<D> cells_;
    Variant<D> variant_;
    OwnRun<D> run_;
};

/// From points in rooms, from beside them, and from corners of rooms.
template <int D>
Culling cull_from_anywhere(const Scene<D>& scene, std::string_view method, int views, Random& random) {
    CullingTest<D> test(scene, method), rest(scene, method);
    const Rooms<D>& rooms = scene.rooms;
    const Box<D> box = bounds<D>(scene.primitives);
    for (int i = 0; i < views && !testing::Test::HasFailure(); ++i) {
        Vec<D> eye = point_in(rooms.all[random.below(rooms.all.size())], random), target = eye;
        const bool odd = i % 8 == 7;
        if (odd && random.below(2)) {
            for (int k = 0; k < D; ++k) eye[k] = box.centre()[k] + box.extent()[k] * random.uniform(-0.7, 0.7) + 1e-3;
        } else if (odd && !rooms.portals.empty()) {
            eye = rooms.portals[random.below(rooms.portals.size())].corners[random.below(2)];
        }
        while (target == eye || D == 3) {
            target = point_in(rooms.all[random.below(rooms.all.size())], random);
            if (D == 3 && target != eye) break;
        }
        const double fov = D == 2 && random.below(4) == 0 ? 360 : random.uniform(20, 120);
        (odd ? rest : test).look({eye, target, fov});
    }
    test.total.missed += rest.total.missed, test.total.cracks += rest.total.cracks;
    return test.total;
}

void say(const std::string& scene, std::string_view method, const Culling& total) {
    std::printf("%-24s %-8s %zu views, %zu visible, %zu missed, %zu in cracks, culled %.3f of %zu hidden in view\n",
                scene.c_str(), std::string(method).c_str(), total.views, total.visible, total.missed, total.cracks,
                total.culled(), total.hidden);
}

TEST(Portals, InPlansNothingVisibleIsLeftOutAndMostOfTheRestIs) {
    Random random(1);
    for (const char* id : {"rooms", "soda"}) {
        const Scene<2> scene = make_scene(*find_in_catalogue<2>(id));
        ASSERT_FALSE(scene.rooms.empty());
        check_rooms(scene.rooms, id);
        for (const char* method : {"portals", "pvs"}) {
            const Culling total = cull_from_anywhere(scene, method, test::soak_count(50), random);
            say(id, method, total);
            EXPECT_GE(total.culled(), method == std::string("pvs") ? 0.7 : 0.8) << id << ' ' << method;
        }
    }
}

/// Of Freedoom, where it is installed.
TEST(Portals, InLevelsOfDoomNothingVisibleIsLeftOutAndMostOfTheRestIs) {
    Random random(2);
    int levels = 0;
    std::array<Culling, 2> of_all;
    constexpr std::array methods{"portals", "pvs"};
    for (const char* file : {"/usr/share/games/doom/freedoom1.wad", "/usr/share/games/doom/freedoom2.wad"}) {
        if (!std::filesystem::exists(file)) continue;
        const std::string bytes = read_file(file);
        for (const std::string& map : wad_maps(bytes, file)) {
            if (++levels > 20) break;
            const Scene<2> scene = read_wad(bytes, "freedoom", {map});
            check_rooms(scene.rooms, map);
            const std::string name =
                map + " " + std::to_string(scene.primitives.size()) + " in " + std::to_string(scene.rooms.all.size());
            for (std::size_t i = 0; i < methods.size(); ++i) {
                const Culling total = cull_from_anywhere(scene, methods[i], test::soak_count(5), random);
                say(name, methods[i], total);
                Culling& all = of_all[i];
                all.views += total.views, all.visible += total.visible, all.missed += total.missed;
                all.hidden += total.hidden, all.drawn_hidden += total.drawn_hidden;
            }
        }
    }
    if (levels == 0) GTEST_SKIP() << "no levels of Freedoom here";
    for (std::size_t i = 0; i < methods.size(); ++i) {
        say("all levels", methods[i], of_all[i]);
        EXPECT_GE(of_all[i].culled(), 0.8) << methods[i];
    }
}

TEST(Portals, InHallsAndOfficesNothingVisibleIsLeftOutAndMostOfTheRestIs) {
    Random random(3);
    for (const char* id : {"soda", "soda:20k", "room:10k"}) {
        const Scene<3> scene = *generated_scene(id);
        ASSERT_FALSE(scene.rooms.empty());
        check_rooms(scene.rooms, id);
        for (const char* method : {"portals", "pvs"}) {
            const Culling total = cull_from_anywhere(scene, method, test::soak_count(40), random);
            say(id, method, total);
            if (scene.rooms.portals.empty()) continue;
            EXPECT_GE(total.culled(), method == std::string("pvs") ? 0.7 : 0.8) << id << ' ' << method;
        }
    }
}

/// Steps, words and budgets where there are rooms; every_method_test has scenes without.
template <int D>
void expect_steps(const Scene<D>& scene, const char* text, std::uint64_t seed) {
    Random random(seed);
    const CellComplex<D> cells;
    const Variant<D> variant = make_variant<D>(method_table<D>(), text);
    const View<D> view = portal_view(*scene.start_view, scene);
    const Problem<D> problem = make_problem(variant.method, variant.parameters, scene, cells, view);
    std::vector<std::uint64_t> hashes;
    const std::unique_ptr<Run<D>> forward = variant.method.start(problem);
    do hashes.push_back(forward->hash());
    while (forward->run(1) == Stop::steps);
    ASSERT_GT(hashes.size(), 5u);

    OwnRun<D> run(variant.method.start(problem));
    Timeline<D> timeline;
    timeline.begin(*run);
    for (int move = 0; move < 30; ++move) {
        const auto target = static_cast<std::uint32_t>(random.below(hashes.size()));
        while (run->steps() > target) ASSERT_TRUE(timeline.back(run));
        while (run->steps() < target) ASSERT_EQ(timeline.forward(run), Stop::none);
        ASSERT_EQ(run->hash(), hashes[target]) << text;
        const Step* const last = target > 0 ? &timeline.steps[target - 1] : nullptr;
        if (last) {
            ASSERT_FALSE(run->popped_words(*last).empty());
        }
        for (const bool in_step : {false, true}) {
            if (in_step && !last) continue;
            CodePlace place{last, target, {}, 0, {}};
            if (in_step) place.substep = 0;
            const std::vector<CodeLine> code = run->code(place);
            ASSERT_EQ(std::count_if(code.begin(), code.end(), [](const CodeLine& line) { return line.lit; }), 1)
                << text << " at step " << target << (in_step ? ", in it" : "");
        }
    }
    while (timeline.forward(run) == Stop::none) {
    }
    const auto rendered = rendered_mask(run->met(), scene.primitives.size());
    for (std::uint32_t p = 0; p < rendered.size(); ++p) {
        ASSERT_NE(bool(rendered[p]), bool(run->why_not(primitive_item(p)))) << text << ": primitive " << p;
    }
    Problem<D> small = problem;
    small.budget = 7;
    const std::unique_ptr<Run<D>> part = variant.method.start(small);
    while (part->run(none) == Stop::budget) {
        ASSERT_TRUE(std::equal(part->met().begin(), part->met().end(), run->met().begin()));
        part->set_budget(part->problem().budget + 1 + static_cast<std::uint32_t>(random.below(9)));
    }
    EXPECT_EQ(part->hash(), run->hash());
    EXPECT_EQ(part->misses(), Misses::none);
}

TEST(Portals, StepBackAndForthAndSayWhatTheyDo) {
    for (const char* text : {"portals", "pvs"}) {
        expect_steps(make_scene(*find_in_catalogue<2>("rooms")), text, 7);
        expect_steps(*generated_scene("soda"), text, 8);
    }
}

TEST(Portals, WithoutRoomsAreViewCulling) {
    const Scene<2> scene = make_scene(*find_in_catalogue<2>("streets"));
    const CellComplex<2> cells;
    const View<2> view = make_view(*scene.start_view);
    std::vector<std::vector<std::uint8_t>> drawn;
    for (const char* text : {"view", "portals", "pvs"}) {
        const Variant<2> variant = make_variant<2>(method_table<2>(), text);
        const Problem<2> problem = make_problem(variant.method, variant.parameters, scene, cells, view);
        const auto run = variant.method.start(problem);
        Recording recording;
        Recorder recorder(recording);
        run->run(none, &recorder);
        drawn.push_back(rendered_mask(run->met(), scene.primitives.size()));
        EXPECT_EQ(drawn.back(), drawn.front()) << text;
        if (text != std::string("view")) {
            EXPECT_EQ(run->popped_words(recording.steps[0]), "all that is in view: the scene marks no rooms");
        }
    }
}

}  // namespace
}  // namespace sightline
