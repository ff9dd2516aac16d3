// Commands in three dimensions: those that 2D has not, and those that do something else there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/session/state_file.h"
#include "core/space/cells_file.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/camera.h"
#include "shell/desk/open_scene.h"
#include "shell/export/handout.h"
#include "tests/scene/scene_support.h"
#include "tests/session/session_3d_support.h"
#include "tests/shell/commands/commands_support.h"

namespace sightline {
namespace {

using namespace test;

/// A picture without OpenGL.
Pixels one_colour(const SolidList& list, int width, int height, double) {
    return {width, height,
            std::vector<Colour>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), list.background)};
}

/// The bottleneck at step 10 of its run.
class Commands3 : public ::testing::Test {
protected:
    Commands3() {
        Graphics graphics;
        graphics.draw_ids = cast_rays;
        graphics.draw_solid = one_colour;
        Session<3> session = open_scene<3>(
            "bottleneck", start_settings<3>("bottleneck"), method_table<3>(), [](const std::string&) {}, graphics);
        bench.reset(new Workbench<3>{std::move(session)});
        bench->graphics = graphics;
        bench->say = [this](const std::string& line) { said.push_back(line); };
        std::filesystem::create_directories(folder);
        run("run; seek 10");
    }
    ~Commands3() override { std::filesystem::remove_all(folder); }

    void run(const std::string& text) {
        said.clear();
        run_commands(*bench, text);
    }
    Session<3>& session() { return bench->session; }
    const ViewSpec<3>& culling() { return session().culling_view(); }
    const ViewSpec<3>& display() { return session().display_view(); }
    std::string file(const std::string& name) const { return (folder / name).string(); }
    bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }
    Session<3> opened(const std::string& name) {
        return open_state<3>(read_file(file(name)), name, method_table<3>(), cast_rays).session;
    }

    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("sightline-commands3-" + std::to_string(getpid()));
    std::vector<std::string> said;  ///< by the last run()
    std::unique_ptr<Workbench<3>> bench;
};

using EachCommand3 = Commands3;

TEST_F(Commands3, EachThatIsNotAsIn2DHasATest) {
    std::set<std::string> known, own;
    for (const Command<3>& command : command_table<3>()) {
        EXPECT_TRUE(known.emplace(command.id).second) << command.id << " stands twice in the table";
        EXPECT_FALSE(command.text.empty()) << command.id;
        const auto flat = command_table<2>();
        if (std::none_of(flat.begin(), flat.end(), [&](const Command<2>& c) { return c.id == command.id; }))
            own.emplace(command.id);
    }
    // Views have another form, and so have pictures.
    for (const auto& group : {view_commands<3>(), flight_commands<3>(), path_commands<3>(), file_commands<3>()})
        for (const Command<3>& command : group) own.emplace(command.id);
    own.emplace("tool");
    own.emplace("select");
    EXPECT_EQ(tested_commands("EachCommand3"), own);
}

TEST_F(Commands3, ErrorsNameTheCommandAndChangeNothing) {
    const std::uint64_t hash = session().hash();
    const Settings before = session().settings();
    const ViewSpec<3> view = culling();
    const double speed = bench->flight.speed;
    for (const std::string command : {"eye",
                                      "eye 1,2",
                                      "eye 1,2,3,4",
                                      "eye nan,1,1",
                                      "eye 1,inf,1",
                                      "eye 1,1e999,1",
                                      "eye 8,8,1.6",
                                      "look 8,1.6,1.6",
                                      "look nan,0,0",
                                      "look x,y,z",
                                      "fov",
                                      "fov nan",
                                      "fov 0",
                                      "fov 180",
                                      "fov 360",
                                      "fov -90",
                                      "zoom",
                                      "zoom 0",
                                      "zoom -2",
                                      "zoom nan",
                                      "zoom 1e-320",
                                      "pan",
                                      "pan 1",
                                      "pan nan,0",
                                      "pan 1e308,1e308",
                                      "freeze half",
                                      "orbit",
                                      "orbit 10",
                                      "orbit nan,0",
                                      "orbit 10,20,30",
                                      "turn",
                                      "turn x,0",
                                      "turn 0,inf",
                                      "walk",
                                      "walk 1,2",
                                      "walk 1,2,3,4",
                                      "walk nan,0,0",
                                      "walk 1e308,1e308,1e308",
                                      "through",
                                      "fly up",
                                      "fly-speed",
                                      "fly-speed 0",
                                      "fly-speed -1",
                                      "fly-speed nan",
                                      "fly-speed x",
                                      "fly-speed x0",
                                      "fly-speed xnan",
                                      "path nowhere",
                                      "path frame",
                                      "path frame 0",
                                      "path frame x",
                                      "path play",
                                      "path save",
                                      "path open",
                                      "path open /no/such/path.json",
                                      "set slice=w",
                                      "set slice_at=nan",
                                      "set shrink=-1",
                                      "set reference_size=0x0",
                                      "set reference_size=9000x9000",
                                      "select primitive:999999",
                                      "note text 0,0 x",
                                      "note text nan,0,0 x",
                                      "tool segment",
                                      "tool hammer",
                                      "compare nothing-like-this",
                                      "film 999998-999999 a.png",
                                      "film 1-2 a.svg",
                                      "shot a.gif",
                                      "size 0x0"}) {
        SCOPED_TRACE(command);
        expect_input_error([&] { run(command); }, "command '" + command + "': *");
        EXPECT_EQ(session().hash(), hash);
        EXPECT_EQ(session().position(), 10u);
        EXPECT_EQ(session().settings(), before);
        EXPECT_EQ(culling(), view);
        EXPECT_EQ(display(), view);
        EXPECT_FALSE(session().frozen());
        EXPECT_EQ(bench->flight.speed, speed);
        EXPECT_TRUE(bench->flight.path.frames.empty());
        EXPECT_TRUE(session().notes.empty());
        EXPECT_FALSE(bench->other);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(EachCommand3, eye) {
    run("eye 8,2,1.7");
    EXPECT_EQ(culling().eye, Vec<3>(8, 2, 1.7));
}

TEST_F(EachCommand3, look) {
    run("look 8.5,7,1");
    EXPECT_EQ(culling().look_at, Vec<3>(8.5, 7, 1));
}

TEST_F(EachCommand3, fov) {
    run("fov 75");
    EXPECT_EQ(culling().fov, 75);
    EXPECT_EQ(session().position(), 10u) << "a moved view keeps the step";
}

TEST_F(EachCommand3, fit) {
    run("freeze; fit");
    const View<3> view = make_view(display(), 4.0 / 3, session().scene().up_axis);
    for (const Primitive<3>& triangle : session().scene().primitives)
        for (const Vec<3>& corner : triangle) EXPECT_TRUE(in_view(view, std::span<const Vec<3>>(&corner, 1)));
    const ViewSpec<3> before = culling();
    run("unfreeze; eye " + point_text(before.eye, session().scene()) + "; select primitive:4; fit selected");
    EXPECT_TRUE(session().frozen()) << "the run stays";
    Box<3> box;
    for (const Vec<3>& corner : session().scene().primitives[4]) box.add(corner);
    EXPECT_NEAR(glm::length(display().look_at - box.centre()), 0, 1e-9) << "what circling goes about";
    EXPECT_EQ(session().settings().projected_as, DrawnAs::off) << "they would fill the picture";
    const auto& [a, b, c] = session().scene().primitives[4];
    const Vec<3> normal = glm::normalize(glm::cross(b - a, c - a)),
                 along = glm::normalize(display().look_at - display().eye);
    EXPECT_GT(std::abs(glm::dot(normal, along)), 0.45) << "not edge-on";
    const View<3> near = make_view(display(), 4.0 / 3, session().scene().up_axis);
    for (const Vec<3>& corner : session().scene().primitives[4])
        EXPECT_TRUE(in_view(near, std::span<const Vec<3>>(&corner, 1)));
}

TEST_F(EachCommand3, select) {
    run("run; select pixel:20,15");
    const IdImage& image = session().reference().image;
    ASSERT_EQ(bench->pixel, (std::array{20, 15}));
    if (image.at(20, 15) != none) EXPECT_EQ(session().selected_primitive, image.at(20, 15));
    run("select primitive:3");
    EXPECT_FALSE(bench->pixel);
    expect_input_error([&] { run("select pixel:4000,2"); },
                       "command 'select pixel:4000,2': there is no pixel 4000,2: the image has 40 x 30");
}

TEST_F(EachCommand3, zoom) {
    const double before = glm::length(display().look_at - display().eye);
    run("freeze; zoom 0.5");
    EXPECT_NEAR(glm::length(display().look_at - display().eye), 2 * before, 1e-9);
    run("zoom 1e9; zoom 1e-9");
    EXPECT_NEAR(glm::length(display().look_at - display().eye), 2 * before, 1e-3);
}

TEST_F(EachCommand3, pan) {
    const ViewSpec<3> before = display();
    run("freeze; pan 0.5,0.25");
    const Vec<3> by = display().eye - before.eye;
    EXPECT_LT(glm::length(by - (display().look_at - before.look_at)), 1e-12);
    EXPECT_GT(by.z, 0);
    EXPECT_NEAR(glm::dot(by, before.look_at - before.eye), 0, 1e-9);
}

TEST_F(EachCommand3, freeze) {
    const ViewSpec<3> view = culling();
    const std::uint64_t hash = session().hash();
    run("freeze; eye 1,1,1; look 2,2,2; fov 30");
    EXPECT_TRUE(session().frozen());
    EXPECT_EQ(culling(), view);
    EXPECT_EQ(display(), (ViewSpec<3>{{1, 1, 1}, {2, 2, 2}, 30}));
    EXPECT_EQ(session().hash(), hash);

    run("unfreeze; freeze eye; turn 30,0");
    EXPECT_EQ(session().frozen_part(), Frozen::eye);
    EXPECT_EQ(culling().eye, view.eye);
    EXPECT_EQ(culling().look_at, display().look_at) << "it turns with what is shown";
    EXPECT_NE(culling().look_at, view.look_at);

    run("unfreeze; freeze direction");
    const Vec<3> ahead = culling().look_at - culling().eye;
    run("turn 40,10; walk 1,0,0");
    EXPECT_EQ(session().frozen_part(), Frozen::direction);
    EXPECT_EQ(culling().eye, display().eye);
    EXPECT_LT(glm::length(culling().look_at - culling().eye - ahead), 1e-12);
    run("freeze all");
    EXPECT_EQ(session().frozen_part(), Frozen::all);
}

TEST_F(EachCommand3, unfreeze) {
    run("freeze; walk 0,0,-5");
    EXPECT_NE(display(), culling());
    run("unfreeze");
    EXPECT_FALSE(session().frozen());
    EXPECT_EQ(display(), culling());
}

TEST_F(EachCommand3, orbit) {
    const ViewSpec<3> before = display();
    run("orbit 90,0");
    EXPECT_EQ(display().look_at, before.look_at);
    const Vec<3> from = before.eye - before.look_at, to = display().eye - before.look_at;
    EXPECT_NEAR(glm::length(to), glm::length(from), 1e-9);
    EXPECT_NEAR(from.x * to.x + from.y * to.y, 0, 1e-9);
    run("undo");
    EXPECT_EQ(display(), before);
}

TEST_F(EachCommand3, turn) {
    const ViewSpec<3> before = display();
    run("turn 90,0");
    EXPECT_EQ(display().eye, before.eye);
    EXPECT_NEAR(glm::dot(display().look_at - before.eye, before.look_at - before.eye), 0, 1e-9);
}

TEST_F(EachCommand3, walk) {
    const ViewSpec<3> before = display();  // it looks along y
    run("walk 1,2,3");
    EXPECT_LT(glm::length(display().eye - before.eye - Vec<3>(1, 3, 2)), 1e-12);
    EXPECT_LT(glm::length(display().look_at - before.look_at - Vec<3>(1, 3, 2)), 1e-12);
}

TEST_F(EachCommand3, through) {
    run("freeze; orbit 40,20; zoom 0.2; through");
    EXPECT_EQ(display(), culling());
    EXPECT_TRUE(session().frozen());
}

TEST_F(EachCommand3, fly) {
    run("fly");
    EXPECT_TRUE(bench->flight.on);
    run("fly on");
    EXPECT_TRUE(bench->flight.on);
    run("path test; path frame 2");
    EXPECT_TRUE(session().flying());
    const std::uint64_t hash = session().hash();
    run("fly off");
    EXPECT_FALSE(bench->flight.on);
    EXPECT_FALSE(session().flying());
    EXPECT_EQ(session().hash(), hash);
    EXPECT_GT(session().position(), 0u);
}

TEST_F(EachCommand3, fly_speed) {
    run("fly-speed 5");
    EXPECT_EQ(bench->flight.speed, 5);
    run("fly-speed x2");
    EXPECT_EQ(bench->flight.speed, 10);
    run("fly-speed x1e300");
    const double high = bench->flight.speed;
    expect_input_error([&] { run("fly-speed x1e300"); }, "command 'fly-speed x1e300': *");
    EXPECT_EQ(bench->flight.speed, high);
}

TEST_F(EachCommand3, path) {
    run("path test");
    const FlightPath<3> test = bench->flight.path;
    ASSERT_EQ(test.frames.size(), 8u);
    run("path frame 3");
    EXPECT_EQ(culling(), test.frames[3]);
    EXPECT_FALSE(session().flying()) << "a frame that stands can be stepped through";
    run("path step; path step 2; path back 4");
    EXPECT_EQ(culling(), test.frames[2]);
    run("path step 99");
    EXPECT_EQ(culling(), test.frames[7]);
    run("path start");
    EXPECT_EQ(culling(), test.frames[0]);
    expect_input_error([&] { run("path frame 8"); },
                       "command 'path frame 8': there is no frame 8: the path has 8 frames, from 0");
    run("path play; path loop");
    EXPECT_TRUE(bench->flight.replaying);
    EXPECT_TRUE(bench->flight.loop);
    run("path stop");
    EXPECT_FALSE(bench->flight.replaying);
    EXPECT_FALSE(session().flying());

    run("path save " + file("p.json") + "; path record");
    EXPECT_TRUE(bench->flight.recording);
    EXPECT_EQ(bench->flight.path.frames, std::vector{culling()});
    run("path record");
    EXPECT_FALSE(bench->flight.recording);
    run("path save " + file("one.json") + "; path open " + file("p.json"));
    EXPECT_EQ(bench->flight.path, test);
    EXPECT_EQ(read_path<3>(read_file(file("one.json")), "one").frames.size(), 1u);

    // A path file that cannot be used leaves the path that there is.
    for (const char* frame :
         {R"({"eye": [null, 0, 0], "look_at": [1, 1, 1]})", R"({"eye": [0, 0], "look_at": [1, 1, 1]})",
          R"({"eye": [0, 0, NaN], "look_at": [1, 1, 1]})", R"({"eye": [0, 0, 1e999], "look_at": [1, 1, 1]})",
          R"({"eye": [1, 1, 1], "look_at": [1, 1, 1]})", R"({"eye": [0, 0, 0], "look_at": [1, 1, 1], "fov": 180})",
          R"({"eye": [0, 0, 0], "look_at": [1, 1, 1], "fov": null})", R"({"look_at": [1, 1, 1]})", "7"}) {
        SCOPED_TRACE(frame);
        write_file(file("bad.json"), std::string(R"({"format": "sightline-path", "version": 1, "dimension": 3,)") +
                                         R"("frames": [{"eye": [0, 0, 0], "look_at": [1, 0, 0]}, )" + frame + "]}");
        expect_input_error([&] { run("path open " + file("bad.json")); },
                           "command 'path open " + file("bad.json") + "': " + file("bad.json") + ": *");
        EXPECT_EQ(bench->flight.path, test);
    }
}

TEST_F(EachCommand3, open) {
    run("freeze; orbit 30,10; save " + file("o.json"));
    const std::uint64_t hash = session().hash();
    const ViewSpec<3> shown = display();
    run("path test; open wall2");
    EXPECT_EQ(session().scene().id, "wall2");
    EXPECT_FALSE(session().frozen());
    run("open " + file("o.json"));
    EXPECT_EQ(session().hash(), hash);
    EXPECT_EQ(session().position(), 10u);
    EXPECT_EQ(display(), shown);
}

TEST_F(EachCommand3, viewer2d) {
    // The tests' own folder has no viewer to start.
    EXPECT_THROW(run("viewer2d bottleneck"), InputError);
}

TEST_F(EachCommand3, size) {
    run("size 400x300");
    EXPECT_EQ(bench->figure.size, "400x300");
}

TEST_F(EachCommand3, shot) {
    const std::uint64_t hash = session().hash();
    run("size 200x150; freeze; orbit 20,20; shot " + file("a.svg") + "; shot " + file("b.png") + "; shot " +
        file("c.pdf"));
    EXPECT_EQ(session().hash(), hash);
    for (const char* name : {"a.svg", "a.svg.json", "b.png", "b.png.json", "c.pdf", "c.pdf.json"})
        EXPECT_TRUE(exists(name)) << name;
    EXPECT_EQ(opened("c.pdf.json").hash(), hash);
    EXPECT_EQ(opened("c.pdf.json").display_view(), display());
}

TEST_F(EachCommand3, page) {
    write_file(file("built.html"), "<script type=\"application/json\" id=\"handout\"></script>");
    bench->page = file("built.html");
    const std::uint64_t hash = session().hash();
    run("freeze; orbit 40,20; page " + file("h.html"));
    const std::string page = read_file(file("h.html"));
    const std::size_t begin = page.find('{');
    const std::string text = page.substr(begin, page.rfind('}') + 1 - begin);
    const ViewSpec<3> shown = display();
    run("unfreeze; seek 3");
    open_handout(*bench, text, "h.html");
    EXPECT_EQ(session().hash(), hash);
    EXPECT_EQ(display(), shown);
    EXPECT_TRUE(session().frozen());
}

TEST_F(EachCommand3, film) {
    const std::uint64_t hash = session().hash();
    run("size 200x150; film 2-4 " + file("f.png"));
    for (const char* name : {"f-0001.png", "f-0002.png", "f-0003.png", "f.png.json"}) EXPECT_TRUE(exists(name)) << name;
    EXPECT_FALSE(exists("f-0004.png"));
    EXPECT_EQ(session().hash(), hash);
    EXPECT_EQ(opened("f.png.json").position(), 2u);
    bench->flight.path.frames = {culling(), orbited(culling(), session().scene().up_axis, 5, 0)};
    run("film path 0-1 " + file("g.png"));
    EXPECT_TRUE(exists("g-0001.png"));
    EXPECT_TRUE(exists("g-0002.png"));
    EXPECT_EQ(session().hash(), hash);
}

TEST_F(EachCommand3, save) {
    run("save " + file("s.json"));
    EXPECT_EQ(opened("s.json").hash(), session().hash());
}

TEST_F(EachCommand3, cells) {
    run("cells " + file("c.cells"));
    EXPECT_EQ(read_cells<3>(file("c.cells"), session().scene(), session().settings()).cell_primitives,
              session().cells().cell_primitives);
}

TEST_F(EachCommand3, trace) {
    run("trace " + file("t.json"));
    EXPECT_EQ(nlohmann::json::parse(read_file(file("t.json")))["steps"].size(), 10u);
}

TEST_F(EachCommand3, stats) {
    run("stats " + file("q.json"));
    const auto stats = nlohmann::json::parse(read_file(file("q.json")));
    EXPECT_EQ(stats["steps"], 10);
    EXPECT_TRUE(stats.contains("wrong_pixels"));
}

TEST_F(EachCommand3, copy) {
    std::string clip;
    bench->clipboard.set = [&](const std::string& text) { clip = text; };
    run("copy");
    EXPECT_EQ(open_state<3>(clip, "clip", method_table<3>(), cast_rays).session.hash(), session().hash());
}

TEST_F(EachCommand3, paste) {
    const std::string clip = state_json<3>(session());
    bench->clipboard.get = [&] { return clip; };
    run("seek 3; paste");
    EXPECT_EQ(session().position(), 10u);
}

TEST_F(EachCommand3, quit) {
    run("quit; seek 3");
    EXPECT_TRUE(bench->quit);
    EXPECT_EQ(session().position(), 10u) << "nothing runs after quit";
}

TEST_F(EachCommand3, tool) {
    run("tool ring");
    EXPECT_EQ(bench->desk.tool, Tool::ring);
    EXPECT_THROW(run("tool segment"), InputError);
    EXPECT_EQ(bench->desk.tool, Tool::ring);
}

}  // namespace
}  // namespace sightline
