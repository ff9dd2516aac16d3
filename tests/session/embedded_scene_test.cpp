// Scenes that travel inside state files: all that decides comes back, bit for bit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/embedded_scene.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/scene/make/catalogue.h"
#include "core/session/state_file.h"
#include "tests/soak.h"

namespace sightline {
namespace {

template <int D>
Scene<D> there_and_back(const Scene<D>& scene) {
    nlohmann::ordered_json part{{"id", scene.id}, {"seed", scene.seed}, {"source", scene.source}};
    embed_scene(scene, part);
    return embedded_scene<D>(Json::parse(part.dump()), "test");
}

template <int D>
void expect_back(const Scene<D>& scene) {
    SCOPED_TRACE(scene.id);
    const Scene<D> back = there_and_back(scene);
    EXPECT_EQ(scene_hash(back), scene_hash(scene));
    EXPECT_EQ(back.id, scene.id);
    EXPECT_EQ(back.seed, scene.seed);
    EXPECT_EQ(back.title, scene.title);
    EXPECT_EQ(back.source, scene.source);
    EXPECT_EQ(back.two_sided, scene.two_sided);
    EXPECT_EQ(back.objects, scene.objects);
    if constexpr (D == 2) {
        EXPECT_EQ(back.rooms, scene.rooms);
    } else {
        EXPECT_EQ(back.rooms.portals, scene.rooms.portals);
        EXPECT_EQ(back.rooms.closed_from, scene.rooms.closed_from);
        ASSERT_EQ(back.rooms.all.size(), scene.rooms.all.size());
        for (std::size_t i = 0; i < scene.rooms.all.size(); ++i) {
            EXPECT_EQ(back.rooms.all[i].name, scene.rooms.all[i].name);
            EXPECT_EQ(back.rooms.all[i].shape.min, scene.rooms.all[i].shape.min);
            EXPECT_EQ(back.rooms.all[i].shape.max, scene.rooms.all[i].shape.max);
        }
    }
    EXPECT_EQ(back.up_axis, scene.up_axis);
    EXPECT_EQ(back.origin, scene.origin);
}

TEST(EmbeddedScene, EveryCatalogueSceneComesBack) {
    bool rooms = false;
    for (const CatalogueRow<2>& row : catalogue<2>()) {
        const Scene<2> scene = make_scene(row);
        rooms = rooms || !scene.rooms.empty();
        expect_back(scene);
    }
    for (const CatalogueRow<3>& row : catalogue<3>()) {
        if (row.triangles > 20'000) continue;
        const Scene<3> scene = *generated_scene(row.id);
        expect_back(scene);
    }
    EXPECT_TRUE(rooms);
}

TEST(EmbeddedScene, TrianglesOfAnyKindComeBack) {
    Random random(5);
    for (int i = 0; i < test::soak_count(50); ++i) {
        Scene<3> scene;
        scene.id = "random";
        scene.source = "obj";
        scene.title = "a <b> \"c\"";
        scene.up_axis = static_cast<int>(random.below(3));
        scene.origin = {random.uniform(-1e6, 1e6), 0, -0.0};
        std::vector<Vec<3>> points;
        for (int k = 0; k < 12; ++k)
            points.emplace_back(random.uniform(-1, 1), std::ldexp(random.unit(), -60), random.below(2) ? 0.0 : -0.0);
        for (int k = 0; k < 20; ++k)
            scene.primitives.push_back({points[random.below(12)], points[random.below(12)], points[random.below(12)]});
        if (random.below(2))
            for (int k = 0; k < 20; ++k) scene.two_sided.push_back(static_cast<std::uint8_t>(random.below(2)));
        if (random.below(2)) {
            scene.objects.names = {"a", "b"};
            for (int k = 0; k < 20; ++k) scene.objects.of.push_back(static_cast<std::uint32_t>(random.below(2)));
        }
        expect_back(scene);
    }
}

/// A state in three dimensions opens without the file that its scene came from.
TEST(EmbeddedScene, AStateCarriesWhatNoGeneratorMakes) {
    auto scene = std::make_shared<Scene<3>>(*generated_scene("blocks"));
    const ViewSpec<3> view = scene->start_view.value();
    scene->name = "blocks";
    const std::string named =
        state_json(Session<3>(scene, view, {}), {}, {}, Align::step, Carry::what_no_generator_makes);
    EXPECT_EQ(named.find("embedded"), std::string::npos) << "a generated one goes by its name";
    scene->source = "obj";
    scene->id = "gone";
    scene->name = "/nowhere/gone.obj";
    Session<3> session(scene, view, {});
    session.seek(2);
    const std::string small = state_json(session);
    EXPECT_EQ(small.find("embedded"), std::string::npos);
    EXPECT_THROW(open_state<3>(small, "small"), InputError);
    const OpenedState<3> opened =
        open_state<3>(state_json(session, {}, {}, Align::step, Carry::what_no_generator_makes), "whole");
    EXPECT_EQ(opened.session.hash(), session.hash());
    EXPECT_TRUE(opened.warnings.empty());
}

TEST(EmbeddedScene, NonsenseIsRefused) {
    nlohmann::ordered_json good{{"id", "a"}, {"source", "obj"}};
    Scene<3> scene;
    scene.primitives = {{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)}};
    scene.objects = {{"a"}, {0}};
    embed_scene(scene, good);
    const auto refused = [&](const char* place, const char* value) {
        Json bad = Json::parse(good.dump());
        bad[Json::json_pointer(place)] = Json::parse(value);
        try {
            embedded_scene<3>(bad, "bad");
        } catch (const InputError&) {
            return true;
        } catch (const Json::exception&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(refused("/embedded/up_axis", "1"));
    for (const auto& [place, value] :
         std::initializer_list<std::pair<const char*, const char*>>{{"/embedded/triangles", "[0, 1, 3]"},
                                                                    {"/embedded/triangles", "[0, 1]"},
                                                                    {"/embedded/triangles", "[0, 1, -1]"},
                                                                    {"/embedded/triangles", "[0, 1, 1.5]"},
                                                                    {"/embedded/points", "[0, 1]"},
                                                                    {"/embedded/points", "\"x\""},
                                                                    {"/embedded/up_axis", "3"},
                                                                    {"/embedded/origin", "[1, 2]"},
                                                                    {"/embedded/two_sided", "[1, 1]"},
                                                                    {"/embedded/objects/of", "[1]"},
                                                                    {"/embedded/objects/of", "[]"},
                                                                    {"/embedded", "7"}})
        EXPECT_TRUE(refused(place, value)) << place << " " << value;
}

}  // namespace
}  // namespace sightline
