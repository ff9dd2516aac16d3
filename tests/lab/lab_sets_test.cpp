// Sets out of the lab and into it: what is rendered by primitive and object, and an engine's own set as a method.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/methods/listed/listed.h"
#include "lab/command.h"
#include "lab/lab_graphics.h"
#include "lab/measure/measure_path.h"
#include "lab/sets/sets.h"
#include "tests/scene/scene_support.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;
using M = Measure;

Study study_of(const std::vector<std::string>& methods, const std::string& budget = "5%") {
    Study study;
    study.methods.clear();
    for (const std::string& method : methods) study.methods.push_back(parse_method(method));
    study.budgets = {parse_budget(budget)};
    study.frames = 3;
    study.size = {160, 120};
    study.repeats = 0;
    return study;
}

class LabSets : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    std::string file(const std::string& name, const std::string& text) const {
        write_file(folder_ / name, text);
        return (folder_ / name).string();
    }
    /// Of one method on a scene, three frames of its path.
    template <int D>
    std::vector<Row> rows(const std::string& scene, const std::vector<std::string>& methods) {
        const Study study = study_of(methods);
        const LabScene<D> lab = load_lab_scene<D>(scene, "", study);
        Instruments instruments;
        instruments.draw_ids = graphics_.draw_ids();
        return measure_path<D>(lab, study, instruments);
    }

    /// What a method renders, written, is a method that renders just that.
    template <int D>
    void round_trip(const std::string& scene) {
        const Study study = study_of({"published"});
        const LabScene<D> lab = load_lab_scene<D>(scene, "", study);
        const PathSets sets = path_sets<D>(lab, study.methods[0], study.budgets[0], graphics_.draw_ids());
        const std::string json = file("sets.json", sets_json<D>(sets, lab)),
                          csv = file("primitives.csv", primitives_csv(sets));
        const std::vector<Row> both =
            rows<D>(scene, {"published", "listed file=" + json, "listed file=" + csv + " along=" + along_of(lab)});
        ASSERT_EQ(both.size(), 3u);
        for (const Row& listed : {both[1], both[2]})
            for (std::size_t i = 0; i < 3; ++i)
                for (const M measure : {M::rendered, M::visible, M::coverage, M::wrong, M::blob, M::pop, M::flip})
                    EXPECT_TRUE(listed.values[i][measure] == both[0].values[i][measure] ||
                                (std::isnan(listed.values[i][measure]) && std::isnan(both[0].values[i][measure])))
                        << method_text(listed.method) << ' ' << measure_row(measure).id << ' ' << i;
        EXPECT_GT(both[0].values[0][M::wrong], 0) << "or this shows nothing";

        for (std::size_t i = 0; i < 3; ++i) {
            ObjectSet all;
            std::size_t wrong = 0;
            for (const SetEntry& e : sets.frames[i].entries) wrong += e.wrong();
            for (const ObjectSet& sum : by_object(sets.frames[i], sets.objects)) {
                all.visible += sum.visible;
                all.rendered += sum.rendered;
                all.missed += sum.missed;
                all.extra += sum.extra;
                all.wrong += sum.wrong;
            }
            const Values& v = both[0].values[i];
            EXPECT_EQ(all.visible, v[M::visible]);
            EXPECT_EQ(all.rendered, v[M::rendered]);
            EXPECT_EQ(all.visible - all.missed, all.rendered - all.extra);
            EXPECT_DOUBLE_EQ(1 - double(all.missed) / all.visible, v[M::coverage]);
            EXPECT_EQ(all.wrong, wrong);
            EXPECT_DOUBLE_EQ(double(all.wrong) / double(sets.frames[i].image_pixels), v[M::wrong]);
        }
    }
    template <int D>
    std::string along_of(const LabScene<D>& lab) const {
        if (!lab.scene->paths.empty()) return lab.path;
        return file("turn.json", write_path(find_path(*lab.scene, lab.path)));
    }

    LabGraphics graphics_;
    fs::path folder_ = fs::temp_directory_path() / ("sightline-sets-" + std::to_string(getpid()));
};

TEST_F(LabSets, WrittenAndListedAreTheSameIn2D) { round_trip<2>("2d:rooms"); }
TEST_F(LabSets, WrittenAndListedAreTheSameIn3D) { round_trip<3>("city:10k"); }

/// Two walls, the far one hidden by the near one, and one beside them.
constexpr const char* walls_scene =
    R"({"format": "sightline-scene", "version": 1, "dimension": 2, "id": "walls",
        "view": {"eye": [0, 0], "look_at": [10, 0], "fov": 90},
        "segments": [[2, -1, 2, 1], [4, -1, 4, 1], [4, 2, 4, 3], [4, 3, 5, 4.5]]})";

TEST_F(LabSets, AnEnginesSetHasItsMissesAndItsExtras) {
    const std::string scene = file("walls.json", walls_scene);
    // The connected parts: the near wall, the far one, and two that hang together.
    const auto values = [&](const std::string& sets) {
        return rows<2>(scene, {"listed file=" + sets}).front().values.front();
    };
    const std::string head = R"({"format":"sightline-sets","version":1,"dimension":2,"frames":[)";
    const std::string view = R"("view":{"eye":[0,0],"look_at":[10,0],"fov":90})";
    const auto every_view = [&](const std::string& lists) {  // those of the turn
        const Study study = study_of({"view"});
        const LabScene<2> lab = load_lab_scene<2>(scene, "", study);
        std::string text = head;
        for (std::size_t i = 0; i < lab.specs.size(); ++i)
            text += std::string(i > 0 ? "," : "") +
                    nlohmann::json{{"frame", i},
                                   {"view",
                                    {{"eye", {lab.specs[i].eye.x, lab.specs[i].eye.y}},
                                     {"look_at", {lab.specs[i].look_at.x, lab.specs[i].look_at.y}},
                                     {"fov", lab.specs[i].fov}}}}
                        .dump();
        for (std::size_t at = 0; (at = text.find("\"frame\"", at)) != std::string::npos; at += lists.size() + 8)
            text.insert(at, lists + ",");
        return file("engine.json", text + "]}");
    };
    const Values wrong = values(every_view(R"("rendered":[1],"rendered_objects":["part 3"])"));
    EXPECT_EQ(wrong[M::visible], 3);
    EXPECT_EQ(wrong[M::rendered], 3);
    EXPECT_DOUBLE_EQ(wrong[M::coverage], 2.0 / 3) << "the near wall is missing";
    EXPECT_DOUBLE_EQ(wrong[M::efficiency], 2.0 / 3) << "the far one need not be there";
    EXPECT_EQ(values(every_view(R"("rendered":[0],"rendered_objects":["part 3"])"))[M::coverage], 1);

    const auto refused = [&](const std::string& sets, const std::string& why) {
        sightline::test::expect_input_error([&] { values(sets); }, why);
    };
    const std::string where = scene + ", path turn, frame 0: ", engine = (folder_ / "engine.json").string();
    refused(every_view(R"("rendered":[7])"), where + engine + ": lists primitive 7, and the scene has 4");
    refused(every_view(R"("rendered_objects":["door"])"),
            where + engine + ": lists object 'door', which the scene does not have");
    refused(
        file("engine.json", head + R"({"rendered":[1],"view":{"eye":[0,1],"look_at":[10,0],"fov":90}}]})"),
        where + engine + ": none of its 1 frame has the view from 0,0; does it number frames? Then give along=PATH");
    refused(file("engine.json", head + R"({"rendered":[1]}]})"),
            engine + ": /frames/0: needs \"frame\", \"view\" or both");
    refused(file("engine.json", head + R"({"frame":1}]})"),
            engine + ": /frames/0: needs \"rendered\", \"rendered_objects\" or both");
    refused(file("engine.csv", "frame,thing\n"),
            (folder_ / "engine.csv").string() +
                ": line 1: the first line names the columns: there must be primitive or object");
    refused(file("engine.csv", "frame,primitive\n0,x\n"),
            (folder_ / "engine.csv").string() + ": line 2: primitive: 'x' is no whole number");
    refused(file("engine.csv", "frame,primitive\n0\n"),
            (folder_ / "engine.csv").string() + ": line 2: has 1 field, not 2");
    EXPECT_THROW(rows<2>(scene, {"listed"}), InputError) << "without a file";
    EXPECT_THROW(parse_method("listed file=" + (folder_ / "nosuch").string()), InputError);
}

TEST_F(LabSets, ViewsMayBeInSinglePrecision) {
    const SetsFile<2> sets = read_sets<2>(
        "eye_x,eye_y,look_at_x,look_at_y,fov,object,primitive\r\n"
        "0.1,0.2,1,0,90,\"a, \"\"b\"\"\",\r\n"
        "0.1,0.2,1,0,90,,4\r\n\r\n"
        "7,0.2,1,0,90,,\r\n",
        "x");
    ASSERT_EQ(sets.frames.size(), 2u);
    EXPECT_EQ(sets.frames[0].objects, std::vector<std::string>{"a, \"b\""});
    EXPECT_EQ(sets.frames[0].primitives, std::vector<std::uint32_t>{4});
    EXPECT_TRUE(sets.frames[1].primitives.empty()) << "a frame in which nothing is rendered";

    const std::string scene = file("walls.json", R"({"format": "sightline-scene", "version": 1, "dimension": 2,
        "view": {"eye": [0.1, 0.2], "look_at": [10, 0.3], "fov": 90}, "segments": [[2, -1, 2, 1]]})");
    const std::string engine = file("floats.csv",
                                    "eye_x,eye_y,look_at_x,look_at_y,fov,primitive\n"
                                    "0.10000000149011612,0.20000000298023224,10,0.30000001192092896,90,0\n");
    Study study = study_of({"listed file=" + engine});
    const LabScene<2> lab = load_lab_scene<2>(scene, "start", study);
    const std::vector<Row> rows = measure_path<2>(lab, study, {});
    EXPECT_EQ(rows.front().values.front()[M::rendered], 1);

    // What the file says decides: frames measured with another are not taken.
    const std::string key = checkpoint_key(lab);
    file("floats.csv", "eye_x,eye_y,look_at_x,look_at_y,fov,primitive\n0.1,0.2,10,0.3,90,\n");
    EXPECT_NE(checkpoint_key(load_lab_scene<2>(scene, "start", study)), key);
}

TEST_F(LabSets, CommandWritesWhatTheManualNames) {
    const std::string manual = read_file(SIGHTLINE_SOURCE_DIR "/docs/measuring.md");
    const std::string out = (folder_ / "out").string();
    const std::vector<const char*> words{"lab sets", "2d:rooms", "--frames", "2",     "--method",
                                         "layers",   "--budget", "5%",       "--out", out.c_str()};
    testing::internal::CaptureStdout();
    EXPECT_EQ(sets_command(static_cast<int>(words.size()), words.data(), {}), 0);
    const std::string said = testing::internal::GetCapturedStdout();
    EXPECT_NE(said.find("2 frames, layers at 5%: on average"), std::string::npos) << said;
    for (const char* name : {"primitives.csv", "objects.csv"}) {
        const std::string text = read_file(folder_ / "out" / name);
        EXPECT_NE(manual.find("`" + text.substr(0, text.find('\n')) + "`"), std::string::npos)
            << "docs/measuring.md does not name the columns of " << name;
    }
    const auto json = nlohmann::json::parse(read_file(folder_ / "out/sets.json"));
    EXPECT_EQ(json.at("frames").size(), 2u);
    for (const auto& [field, value] : json.items())
        EXPECT_NE(manual.find("`" + field + "`"), std::string::npos) << field;
    for (const auto& [field, value] : json.at("frames").at(0).items())
        EXPECT_NE(manual.find("`" + field + "`"), std::string::npos) << field;
    const std::vector<const char*> two{"lab sets", "2d:rooms", "--methods", "layers,view"};
    EXPECT_THROW(sets_command(static_cast<int>(two.size()), two.data(), {}), InputError);
}

}  // namespace
}  // namespace sightline::lab
