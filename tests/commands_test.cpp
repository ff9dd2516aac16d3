// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/command_table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/draw/shown_world.h"
#include "core/file.h"
#include "core/scene/catalogue.h"
#include "core/scene/read_json.h"
#include "core/session/report.h"
#include "core/session/state_file.h"
#include "core/session/substep.h"
#include "shell/bench/moves.h"
#include "tests/scene_support.h"

namespace sightline {
namespace {

namespace fs = std::filesystem;

class Commands : public ::testing::Test {
protected:
    Commands() {
        const CatalogueRow& row = *find_in_catalogue("bottleneck");
        settings.error_bound = row.error_bound;
        bench.reset(
            new Workbench<2>{Session<2>(std::make_shared<const Scene<2>>(make_scene(row)), row.view, settings)});
        bench->say = [this](const std::string& line) { said.push_back(line); };
        fs::create_directories(folder);
    }
    ~Commands() override { fs::remove_all(folder); }

    void run(const std::string& text) {
        said.clear();
        run_commands(*bench, text);
    }
    Session<2>& session() { return bench->session; }
    const Other<2>& other() { return bench->other.value(); }
    void flips(const std::string& command, const bool& flag) {
        const bool before = flag;
        run(command);
        EXPECT_NE(flag, before);
        run(command);
        EXPECT_EQ(flag, before);
    }
    std::string file(const std::string& name) const { return (folder / name).string(); }

    Settings settings;
    fs::path folder = fs::temp_directory_path() / ("sightline-commands-" + std::to_string(getpid()));
    std::vector<std::string> said;
    std::string clip;
    std::unique_ptr<Workbench<2>> bench;
};

TEST_F(Commands, EveryOneOfTheTableDoesWhatItSays) {
    // In this order, on one bench; each leaves it at step 10 of the whole run.
    const std::vector<std::pair<std::string, std::function<void()>>> cases{
        {"step",
         [&] {
             run("step");
             EXPECT_EQ(session().position(), 1u);
             run("step 9");
             EXPECT_EQ(session().position(), 10u);
             EXPECT_EQ(bench->last_stop, Stop::steps);
         }},
        {"back",
         [&] {
             run("back; back 4");
             EXPECT_EQ(session().position(), 5u);
             run("back 100");
             EXPECT_EQ(session().position(), 0u);
         }},
        {"run",
         [&] {
             run("run");
             EXPECT_EQ(bench->last_stop, Stop::front_empty);
             EXPECT_EQ(session().recorded(), session().position());
             EXPECT_GT(session().position(), 50u);
         }},
        {"seek",
         [&] {
             const std::uint32_t end = session().position();
             run("seek start");
             EXPECT_EQ(session().position(), 0u);
             run("seek end");
             EXPECT_EQ(session().position(), end);
             run("seek 999999");
             EXPECT_EQ(session().position(), end);
             EXPECT_EQ(bench->last_stop, Stop::front_empty);
             run("seek 10");
             EXPECT_EQ(session().position(), 10u);
             EXPECT_EQ(bench->last_stop, Stop::steps);
         }},
        {"until",
         [&] {
             run("until step:20");
             EXPECT_EQ(session().position(), 20u);
             EXPECT_EQ(bench->last_stop, Stop::breakpoint);
             run("seek 10; until rendered_now > 0 && step > 11");
             EXPECT_GT(session().position(), 11u);
         }},
        {"into",
         [&] {
             run("seek 10; into");
             EXPECT_EQ(session().position(), 11u);
             EXPECT_EQ(bench->substep, 0u);
             run("into");
             EXPECT_EQ(bench->substep, 1u);
             run("step");
             EXPECT_EQ(session().position(), 11u) << "it completes the step";
             EXPECT_EQ(bench->substep, std::nullopt);
         }},
        {"out",
         [&] {
             run("out");
             EXPECT_EQ(bench->substep, substep_count(session(), 11) - 1);
             run("seek 10; into; into; out; out");
             EXPECT_EQ(session().position(), 10u);
             EXPECT_EQ(bench->substep, std::nullopt);
         }},
        {"bookmark",
         [&] {
             run("seek 10; bookmark the tenth step; seek 3; seek @the tenth step");
             EXPECT_EQ(session().position(), 10u);
             EXPECT_EQ(session().bookmarks, (std::vector<Bookmark>{{10, "the tenth step"}}));
         }},
        {"eye",
         [&] {
             run("eye 8,2");
             EXPECT_EQ(session().culling_view().eye, Vec<2>(8, 2));
         }},
        {"look",
         [&] {
             run("look 8.5,7");
             EXPECT_EQ(session().culling_view().look_at, Vec<2>(8.5, 7));
         }},
        {"fov",
         [&] {
             run("fov 75");
             EXPECT_EQ(session().culling_view().fov, 75);
             EXPECT_EQ(session().position(), 10u) << "a moved view keeps the step";
         }},
        {"freeze",
         [&] {
             const ViewSpec<2> view = session().culling_view();
             const std::uint64_t hash = session().hash();
             run("freeze; eye 1,1; look 2,2; fov 30");
             EXPECT_TRUE(session().frozen());
             EXPECT_EQ(session().culling_view(), view);
             EXPECT_EQ(session().display_view(), (ViewSpec<2>{{1, 1}, {2, 2}, 30}));
             EXPECT_EQ(session().hash(), hash);
         }},
        {"unfreeze",
         [&] {
             run("unfreeze");
             EXPECT_FALSE(session().frozen());
             EXPECT_EQ(session().display_view(), session().culling_view());
         }},
        {"set",
         [&] {
             run("set palette=print");
             EXPECT_EQ(session().settings().palette, Palette::print);
             EXPECT_TRUE(said.empty()) << "nothing was run again";
             run("set penalty=add");
             EXPECT_EQ(session().settings().penalty, Penalty::add);
             ASSERT_EQ(said.size(), 1u);
             EXPECT_EQ(said[0].find("step 10 of "), 0u) << said[0];
             run("set error_bound=0.5");
             EXPECT_NE(said.at(0).find("new cells: "), std::string::npos) << said[0];
         }},
        {"preset",
         [&] {
             run("preset letter");
             EXPECT_EQ(session().settings().view_vector, ViewVector::camera);
             run("preset default; set error_bound=0.25; seek 10");
             EXPECT_EQ(session().settings().view_vector, ViewVector::eye);
         }},
        {"method",
         [&] {
             run("method centroid");
             EXPECT_EQ(session().method().id, "centroid");
             run("method published; seek 10");
         }},
        {"budget",
         [&] {
             run("budget 5%; run");
             EXPECT_EQ(bench->last_stop, Stop::budget);
             EXPECT_EQ(budget_text(session().settings().budget), "5%");
             run("budget unlimited; seek 10");
         }},
        {"select",
         [&] {
             run("select 7");
             EXPECT_EQ(session().selected_cell, 7u);
             run("select none");
             EXPECT_EQ(session().selected_cell, none);
         }},
        {"note",
         [&] {
             run("note text 1,2 \"a; b\"; note callout cell:3 [4,-5.5] first; note callout primitive:2 second; "
                 "note ring 0,0");
             const auto& notes = session().notes;
             ASSERT_EQ(notes.size(), 4u);
             EXPECT_EQ(notes[0].text, "a; b");
             EXPECT_EQ(notes[0].point, Vec<2>(1, 2));
             EXPECT_EQ(notes[1].anchor, Note<2>::Anchor::cell);
             EXPECT_EQ(notes[1].index, 3u);
             EXPECT_EQ(notes[1].offset_pt, Vec<2>(4, -5.5));
             EXPECT_EQ(notes[1].text, "first");
             EXPECT_EQ(notes[1].number, 1u);
             EXPECT_EQ(notes[2].anchor, Note<2>::Anchor::primitive);
             EXPECT_EQ(notes[2].number, 2u);
             EXPECT_EQ(notes[3].kind, Note<2>::Kind::ring);
         }},
        {"explain",
         [&] {
             run("explain");
             EXPECT_EQ(said.at(0).find("Step 10: "), 0u) << said[0];
             run("explain step 4");
             EXPECT_EQ(said.at(0).find("Step 4: "), 0u);
             run("explain cell 3");
             EXPECT_EQ(said.at(0).find("Cell 3: "), 0u);
             run("seek 0; explain; seek 10");
             EXPECT_EQ(said.at(0).find("Step 0: "), 0u);
         }},
        {"front",
         [&] {
             run("front");
             EXPECT_EQ(said.size(), session().state().front_size + 1);
             EXPECT_EQ(said[0], std::to_string(session().state().front_size) + " cells in the front, first to last");
             // The first of the list is what the next step takes.
             const std::string first = said.at(1);
             run("step; explain; seek 10");
             EXPECT_EQ(first.find("  1. cell " + std::to_string(session().timeline().steps[10].cell) + "  key "), 0u)
                 << first;
         }},
        {"inversions",
         [&] {
             run("run; inversions; seek 10");
             EXPECT_EQ(said.size(), session().inversions().size() + 1);
             EXPECT_GT(said.size(), 1u);
         }},
        {"markers",
         [&] {
             run("markers");
             EXPECT_EQ(said.size(), session().markers().size() + 1);
             EXPECT_EQ(said.back(), "  step 10: bookmark 'the tenth step'");
         }},
        {"size",
         [&] {
             run("size 400x300");
             EXPECT_EQ(bench->figure.size, "400x300");
         }},
        {"shot",
         [&] {
             const std::uint64_t hash = session().hash();
             run("shot " + file("a.svg") + "; shot \"" + file("b c;d.png") + "\"");
             EXPECT_EQ(session().hash(), hash);
             EXPECT_EQ(session().position(), 10u);
             for (const char* name : {"a.svg", "a.svg.json", "b c;d.png", "b c;d.png.json"})
                 EXPECT_TRUE(fs::exists(folder / name)) << name;
             EXPECT_EQ(open_state(read_file(file("a.svg.json")), "f").session.hash(), hash);
         }},
        {"save",
         [&] {
             run("save " + file("s.json"));
             EXPECT_EQ(open_state(read_file(file("s.json")), "f").session.hash(), session().hash());
         }},
        {"trace",
         [&] {
             run("trace " + file("t.json"));
             EXPECT_EQ(nlohmann::json::parse(read_file(file("t.json")))["steps"].size(), 10u);
         }},
        {"stats",
         [&] {
             run("stats " + file("q.json"));
             EXPECT_EQ(nlohmann::json::parse(read_file(file("q.json")))["steps"], 10);
         }},
        {"reach",
         [&] {
             const std::uint32_t cell = session().timeline().steps[3].cell;
             run("reach " + std::to_string(cell));
             EXPECT_EQ(session().position(), 4u);
             run("seek 0; select " + std::to_string(cell) + "; reach selected");
             EXPECT_EQ(session().position(), 4u);
             Session<2> end = session();
             end.run();
             for (std::uint32_t c = 0; c < end.cells().cell_count(); ++c)
                 if (end.state().mark(c).state != CellState::projected) {
                     run("reach " + std::to_string(c));
                     EXPECT_NE(said.back().find("never projected"), std::string::npos);
                     EXPECT_EQ(session().position(), 4u) << "it stays";
                     break;
                 }
             run("select none; seek 10");
         }},
        {"break",
         [&] {
             run("break step:12; break rho > 1e9");
             EXPECT_EQ(session().breakpoints.size(), 2u);
             run("break rho > 1e9");
             EXPECT_EQ(session().breakpoints, (std::vector<Breakpoint>{{"step:12", true}}));
         }},
        {"continue",
         [&] {
             run("continue");
             EXPECT_EQ(session().position(), 12u);
             EXPECT_EQ(bench->last_stop, Stop::breakpoint);
             run("continue");
             EXPECT_TRUE(session().finished());
             EXPECT_NE(said.back().find("no breakpoint"), std::string::npos);
             run("seek 10");
         }},
        {"break-switch",
         [&] {
             run("break-switch 1; continue");
             EXPECT_TRUE(session().finished());
             run("break none; seek 10");
             EXPECT_TRUE(session().breakpoints.empty());
         }},
        {"mark",
         [&] {
             run("mark visible_share == 0");
             EXPECT_FALSE(bench->marked.empty());
             const std::uint32_t first = bench->marked.front();
             run("seek 0; until visible_share == 0");
             EXPECT_EQ(session().position(), first);
             run("mark none; seek 10");
             EXPECT_TRUE(bench->marked.empty());
         }},
        {"toggle",
         [&] {
             run("toggle");
             EXPECT_EQ(transport_state(*bench), TransportState::playing);
             run("toggle");
             EXPECT_EQ(transport_state(*bench), TransportState::paused);
         }},
        {"play",
         [&] {
             run("play");
             advance_clock(*bench, 0.25);
             EXPECT_EQ(session().position(), 10u) << "half a step is due";
             advance_clock(*bench, 0.25);
             EXPECT_EQ(session().position(), 11u);
             run("play 20s");
             Session<2> end = session();
             end.run();
             EXPECT_DOUBLE_EQ(bench->transport.steps_per_second, end.recorded() / 20.0);
         }},
        {"pause",
         [&] {
             run("pause; seek 10");
             EXPECT_EQ(transport_state(*bench), TransportState::paused);
         }},
        {"speed",
         [&] {
             run("speed 2; speed half");
             EXPECT_EQ(bench->transport.steps_per_second, 1);
             run("speed double; speed double");
             EXPECT_EQ(bench->transport.steps_per_second, 4);
         }},
        {"cycle",
         [&] {
             const Penalty before = session().settings().penalty;
             for (int i = 0; i < 3; ++i) {
                 run("cycle penalty");
                 EXPECT_EQ(session().settings().penalty == before, i == 2);
             }
             EXPECT_EQ(session().position(), 10u);
         }},
        {"undo",
         [&] {
             const Settings before = session().settings();
             run("set jitter=0.1; undo");
             EXPECT_EQ(session().settings(), before);
             EXPECT_EQ(session().position(), 10u);
         }},
        {"redo",
         [&] {
             run("redo");
             EXPECT_EQ(session().settings().jitter, 0.1);
             run("undo");
         }},
        {"fit",
         [&] {
             run("set zoom=3; set zoom_at=point; set zoom_x=7; fit");
             EXPECT_EQ(session().settings().zoom, 1);
             EXPECT_EQ(session().settings().zoom_at, ZoomAt::view);
         }},
        {"zoom",
         [&] {
             const Box<2> before = shown_world(session());
             run("zoom 2");
             const Box<2> after = shown_world(session());
             EXPECT_NEAR(before.extent().x, 2 * after.extent().x, 1e-9);
             EXPECT_NEAR(glm::length(before.centre() - after.centre()), 0, 1e-9);
             run("undo");
             EXPECT_EQ(session().settings().zoom, 1);
             run("zoom 1e9; zoom 1e-30; zoom 1e9; fit");
         }},
        {"pan",
         [&] {
             const Box<2> before = shown_world(session());
             run("pan 0.5,-0.25");
             const Box<2> after = shown_world(session());
             EXPECT_NEAR(after.min.x, before.min.x + before.extent().x / 2, 1e-9);
             EXPECT_NEAR(after.min.y, before.min.y - before.extent().y / 4, 1e-9);
             run("fit");
         }},
        {"delete",
         [&] {
             const std::size_t notes = session().notes.size(), segments = session().scene().primitives.size();
             run("note text 1,1 gone soon; select 3; select primitive:2; select note:" + std::to_string(notes + 1));
             EXPECT_EQ(session().selected_cell, 3u);  // is still being explained
             EXPECT_EQ(session().selected_primitive, none);
             run("delete");
             EXPECT_EQ(session().notes.size(), notes);
             run("select primitive:2");
             EXPECT_EQ(session().selected_cell, 3u);
             run("delete");
             EXPECT_EQ(session().scene().primitives.size(), segments - 1);
             run("undo; undo; undo; select 4; seek 10");
             EXPECT_EQ(session().scene().primitives.size(), segments);
             EXPECT_EQ(session().selected_primitive, none);
             test::expect_input_error([&] { run("delete"); },
                                      "command 'delete': command 'segment delete': no primitive is selected");
             run("select none");
         }},
        {"note-edit",
         [&] {
             const std::size_t before = session().notes.size();
             run("note text 1,1 {3-20} first; note-edit " + std::to_string(before + 1) + " other words");
             EXPECT_EQ(session().notes.back().text, "other words");
             EXPECT_EQ(session().notes.back().first_step, 3u);
             EXPECT_EQ(session().notes.back().last_step, 20u);
             const std::string n = std::to_string(before + 1);
             run("note-edit " + n + " [3,-4]; note-edit " + n + " {5-}; note-edit " + n + " at cell:6");
             EXPECT_EQ(session().notes.back().offset_pt, Vec<2>(3, -4));
             EXPECT_EQ(session().notes.back().last_step, none);
             EXPECT_EQ(session().notes.back().anchor, Note<2>::Anchor::cell);
             EXPECT_EQ(session().notes.back().index, 6u);
             EXPECT_EQ(session().notes.back().text, "other words");
             run(quote_command("note-edit " + n + " {0-} say \"delete; me\""));
             EXPECT_EQ(session().notes.back().text, "say \"delete; me\"");
             run("select note:" + n + "; note-edit selected {0-} delete");
             EXPECT_EQ(session().notes.back().text, "delete");
             run("note-edit " + n + " delete");
             EXPECT_EQ(session().notes.size(), before);
         }},
        {"panels",
         [&] {
             run("panels " + file("p.txt"));
             EXPECT_NE(read_file(file("p.txt")).find("step 10 of"), std::string::npos);
         }},
        {"compare",
         [&] {
             run("compare centroid");
             EXPECT_EQ(other().session.method().id, "centroid");
             EXPECT_EQ(other().session.position(), 10u);
             EXPECT_EQ(session().method().id, "published");
             run("compare jitter=0.25,penalty=none");
             EXPECT_EQ(other().session.settings().jitter, 0.25);
             EXPECT_EQ(other().session.settings().penalty, Penalty::none);
             run("compare preset:letter");
             EXPECT_EQ(other().session.settings().view_vector, ViewVector::camera);
             run("compare streets");
             EXPECT_EQ(other().session.scene().id, "streets");
             run("set jitter=0.1; save " + file("right.json") + "; undo; compare " + file("right.json"));
             EXPECT_EQ(other().session.settings().jitter, 0.1);
             EXPECT_EQ(other().session.shared_scene(), session().shared_scene());
             run("compare same");
             EXPECT_EQ(other().session.settings(), session().settings());
             run("shot " + file("pair.svg") + "; compare off");
             EXPECT_FALSE(bench->other);
             EXPECT_TRUE(open_state(read_file(file("pair.svg.json")), "f").other.has_value());
         }},
        {"align",
         [&] {
             run("compare centroid; align rendered; seek 12");
             EXPECT_EQ(other().align, Align::rendered);
             EXPECT_GE(other().session.state().rendered_count, session().state().rendered_count);
             run("align step; seek 10");
             EXPECT_EQ(other().session.position(), 10u);
         }},
        {"difference",
         [&] {
             run("difference");
             const auto step = first_difference(at_the_end(session()), at_the_end(other().session));
             ASSERT_TRUE(step);
             EXPECT_EQ(session().position(), *step);
             EXPECT_EQ(other().session.position(), *step);
             EXPECT_EQ(said.at(0).find("Step " + std::to_string(*step) + ": left projects"), 0u);
             run("seek 10; compare same; difference");
             EXPECT_EQ(said.at(0).find("Both agree to the end"), 0u);
             EXPECT_EQ(session().position(), 10u);
         }},
        {"swap",
         [&] {
             run("compare centroid; swap");
             EXPECT_EQ(session().method().id, "centroid");
             EXPECT_EQ(other().session.method().id, "published");
             run("swap; compare off; seek 10");
             EXPECT_EQ(session().method().id, "published");
         }},
        {"segment",
         [&] {
             const auto before = session().shared_scene();
             const auto count = static_cast<std::uint32_t>(before->primitives.size());
             run("segment add 1,1 2,1.5");
             ASSERT_EQ(session().scene().primitives.size(), count + 1);
             EXPECT_EQ(session().scene().primitives.back(), (Primitive<2>{Vec<2>(1, 1), Vec<2>(2, 1.5)}));
             EXPECT_EQ(session().selected_primitive, count);
             EXPECT_EQ(session().scene().source, "edited");
             run("segment move selected 1,1 2,1; segment delete 0");
             EXPECT_EQ(session().scene().primitives.back(), (Primitive<2>{Vec<2>(1, 1), Vec<2>(2, 1)}));
             EXPECT_EQ(session().selected_primitive, count - 1);
             run("segment delete");
             EXPECT_EQ(session().scene().primitives.size(), count - 1);
             EXPECT_EQ(session().selected_primitive, none);
             run("undo; undo; undo; undo; seek 10");
             EXPECT_EQ(session().shared_scene(), before);
         }},
        {"scene",
         [&] {
             const auto before = session().shared_scene();
             run("scene save " + file("scene.json") + "; scene new");
             EXPECT_TRUE(session().scene().primitives.empty());
             EXPECT_TRUE(session().notes.empty());
             run("undo; seek 10");
             EXPECT_EQ(session().shared_scene(), before);
             EXPECT_EQ(scene_hash(read_json(read_file(file("scene.json")), "f")), scene_hash(*before));
         }},
        {"film",
         [&] {
             const std::uint64_t hash = session().hash();
             run("size 200x150; film 2-4 " + file("f.png") + "; film 0-1 " + file("f.pdf"));
             for (const char* name : {"f-0001.png", "f-0002.png", "f-0003.png", "f.png.json", "f.pdf", "f.pdf.json"})
                 EXPECT_TRUE(fs::exists(folder / name)) << name;
             EXPECT_FALSE(fs::exists(folder / "f-0004.png"));
             EXPECT_EQ(session().hash(), hash);
             EXPECT_EQ(open_state(read_file(file("f.png.json")), "f").session.position(), 2u);
         }},
        {"open",
         [&] {
             run("save " + file("o.json"));
             const std::uint64_t hash = session().hash();
             run("open streets");
             EXPECT_EQ(session().scene().id, "streets");
             run("open " + file("o.json"));
             EXPECT_EQ(session().hash(), hash);
             EXPECT_EQ(session().position(), 10u);
         }},
        {"copy",
         [&] {
             bench->clipboard.set = [&](const std::string& text) { clip = text; };
             run("copy");
             EXPECT_EQ(open_state(clip, "clip").session.hash(), session().hash());
         }},
        {"paste",
         [&] {
             bench->clipboard.get = [&] { return clip; };
             run("seek 3; paste");
             EXPECT_EQ(session().position(), 10u);
         }},
        {"scenes", [&] { flips("scenes", bench->desk.chooser); }},
        {"projector", [&] { flips("projector", bench->desk.projector); }},
        {"fullscreen", [&] { flips("fullscreen", bench->desk.fullscreen); }},
        {"console", [&] { flips("console", bench->desk.console); }},
        {"help", [&] { flips("help", bench->desk.help); }},
        {"show",
         [&] {
             run("show front");
             EXPECT_EQ(bench->desk.right, "front");
             run("show front");
             EXPECT_EQ(bench->desk.right, "");
             flips("show timeline", bench->desk.timeline);
         }},
        {"tool",
         [&] {
             run("tool ring");
             EXPECT_EQ(bench->desk.tool, Tool::ring);
         }},
        {"axis",
         [&] {
             run("axis primitives");
             EXPECT_EQ(bench->desk.axis, TimelineAxis::primitives);
         }},
        {"zoom-timeline",
         [&] {
             const double steps = whole_run(*bench);
             ASSERT_GT(steps, 40);
             run("zoom-timeline 10-40");
             EXPECT_EQ(bench->desk.timeline_from, 10 / steps);
             EXPECT_EQ(bench->desk.timeline_to, 40 / steps);
             run("zoom-timeline 20-999999");
             EXPECT_EQ(bench->desk.timeline_from, 20 / steps);
             EXPECT_EQ(bench->desk.timeline_to, 1);
             for (const char* wrong : {"", "3", "7-7", "9-3", "-", "a-b", "999999-9999999"})
                 EXPECT_THROW(run(std::string("zoom-timeline ") + wrong), InputError) << wrong;
             EXPECT_EQ(bench->desk.timeline_from, 20 / steps);
             run("zoom-timeline all");
             EXPECT_EQ(bench->desk.timeline_from, 0);
             EXPECT_EQ(bench->desk.timeline_to, 1);
         }},
        {"scale",
         [&] {
             run("scale 2; scale up");
             EXPECT_EQ(bench->desk.scale, 2.25);
         }},
        {"quit",
         [&] {
             run("quit; seek 3");
             EXPECT_TRUE(bench->quit);
             EXPECT_EQ(session().position(), 10u) << "nothing runs after quit";
         }},
    };
    std::set<std::string_view> tested, known;
    for (const auto& [id, test] : cases) {
        SCOPED_TRACE(id);
        ASSERT_NO_THROW(test());
        tested.insert(id);
    }
    for (const Command<2>& command : command_table<2>()) {
        EXPECT_TRUE(known.insert(command.id).second) << command.id << " stands twice in the table";
        EXPECT_FALSE(command.text.empty());
    }
    EXPECT_EQ(tested, known);
}

TEST_F(Commands, SeparatorsAndQuotes) {
    run("  ;; step ;\n step\t;");
    EXPECT_EQ(session().position(), 2u);
    run("");
    run(";;;");
    run("\"step\"");
    EXPECT_EQ(session().position(), 3u);
    run("bookmark \"a;b\"; seek 0; seek \"@a;b\"");
    EXPECT_EQ(session().position(), 3u);
    run("step   2");
    EXPECT_EQ(session().position(), 5u);
    const std::uint32_t before = session().position();
    test::expect_input_error([&] { run("step; note text 0,0 \"open"); }, "commands: a quote is not closed");
    EXPECT_EQ(session().position(), before) << "nothing runs when the text is not understood";
}

TEST_F(Commands, ErrorsNameTheCommandAndChangeNothing) {
    run("seek 10");
    const std::uint64_t hash = session().hash();
    const Settings before = session().settings();
    const ViewSpec<2> view = session().culling_view();
    for (const std::string command : {"step x",
                                      "step -1",
                                      "step 1.5",
                                      "step 1e10",
                                      "back x",
                                      "seek",
                                      "seek x",
                                      "seek -1",
                                      "seek @nowhere",
                                      "until",
                                      "until rho >",
                                      "until solidity > 1",
                                      "until step = 3",
                                      "eye",
                                      "eye 1",
                                      "eye 1,2,3",
                                      "eye nan,1",
                                      "eye 1,1e999",
                                      "eye 8,8",
                                      "look 8,2.05",
                                      "look x,y",
                                      "fov",
                                      "fov x",
                                      "fov 0",
                                      "fov 180",
                                      "fov -90",
                                      "fov 361",
                                      "set",
                                      "set jitter",
                                      "set jitter=2",
                                      "set colour=red",
                                      "set method=none",
                                      "preset",
                                      "preset nothing",
                                      "method",
                                      "method none",
                                      "budget",
                                      "budget -1",
                                      "budget five",
                                      "select",
                                      "select x",
                                      "select 999999",
                                      "select -1",
                                      "bookmark",
                                      "note",
                                      "note blob 0,0 x",
                                      "select note:1",
                                      "select note:0",
                                      "note-edit selected x",
                                      "zoom",
                                      "zoom 0",
                                      "zoom -1",
                                      "pan",
                                      "pan 1",
                                      "pan a,b",
                                      "note text",
                                      "note text 0 x",
                                      "note text cell:999999 x",
                                      "note text cell:x y",
                                      "note text primitive:999999 x",
                                      "note text 0,0 [1] x",
                                      "note text 0,0 [1,2 x",
                                      "note text 0,0 [a,b] x",
                                      "explain nothing",
                                      "explain step",
                                      "explain step 11",
                                      "explain step x",
                                      "explain cell",
                                      "explain cell 999999",
                                      "size",
                                      "size 84",
                                      "size 0mm",
                                      "size -84mm",
                                      "size 0x0",
                                      "size x",
                                      "shot",
                                      "compare",
                                      "compare nothing-like-this",
                                      "compare preset:nothing",
                                      "compare jitter=2",
                                      "compare jitter=0.1,colour=red",
                                      "compare method=none",
                                      "compare two_sided=on",
                                      "align step",
                                      "align by ear",
                                      "difference",
                                      "swap",
                                      "segment",
                                      "segment add",
                                      "segment add 1,1",
                                      "segment add 1,1 1,1",
                                      "segment add 1,1 2",
                                      "segment add 1,1 1e200,1",
                                      "segment add 1,1 nan,1",
                                      "segment move 0",
                                      "segment move 0 1,1 1,1",
                                      "segment move 999999 1,1 2,2",
                                      "segment move selected 1,1 2,2",
                                      "segment delete",
                                      "segment delete x",
                                      "segment delete 999999",
                                      "segment delete 0 1",
                                      "scene",
                                      "scene old",
                                      "scene save",
                                      "film",
                                      "film 1-2",
                                      "film 2 a.png",
                                      "film 3-2 a.png",
                                      "film 1-999999 a.png",
                                      "film x-2 a.png",
                                      "film 1-2 a.svg",
                                      "film 1-2 a.gif 0fps",
                                      "film 1-2 a.gif xfps",
                                      "shot a.gif",
                                      "shot a",
                                      "save",
                                      "trace",
                                      "stats"}) {
        SCOPED_TRACE(command);
        test::expect_input_error([&] { run(command); }, "command '" + command + "': *");
        EXPECT_EQ(session().hash(), hash);
        EXPECT_FALSE(bench->other);
        EXPECT_EQ(session().settings(), before);
        EXPECT_EQ(session().culling_view(), view);
        EXPECT_TRUE(session().notes.empty());
        EXPECT_TRUE(session().bookmarks.empty());
        EXPECT_EQ(bench->figure.size, "84mm");
    }
    EXPECT_TRUE(fs::is_empty(folder));
    for (const Command<2>& command : command_table<2>())
        test::expect_input_error([&] { run(std::string(command.id) + "x"); },
                                 "command '" + std::string(command.id) + "x' does not exist; there are step, back, *");
    // Those before the wrong one were carried out.
    EXPECT_THROW(run("step 2; nothing; step 2"), InputError);
    EXPECT_EQ(session().position(), 12u);
    // A place that cannot be written is no wrong usage.
    EXPECT_THROW(run("save " + file("missing/s.json")), WorkError);
}

TEST_F(Commands, StatsTellWhyTheSessionStandsWhereItDoes) {
    const auto stop = [&](const std::string& commands) {
        run(commands);
        return nlohmann::json::parse(stats_json(session(), bench->last_stop))["stop"].get<std::string>();
    };
    EXPECT_EQ(stop("seek 5"), "steps");
    EXPECT_EQ(stop("until step:7"), "breakpoint");
    EXPECT_EQ(stop("back 2"), "steps");
    EXPECT_EQ(stop("run"), "front empty");
    EXPECT_EQ(stop("budget 10; run"), "budget");
    EXPECT_EQ(stop("seek 99999"), "budget");
}

}  // namespace
}  // namespace sightline
