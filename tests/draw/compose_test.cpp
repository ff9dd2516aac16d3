// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/compose.h"

#include <gtest/gtest.h>

#include <set>

#include "core/draw/cell_number.h"
#include "core/draw/shown_world.h"
#include "shell/figure/lay_out.h"
#include "tests/draw/picture_support.h"

namespace sightline {
namespace {

using namespace test;

std::vector<Figure> film_of(const std::vector<PanelSource<2>>& frames) {
    const Film film = make_film<2>(frames.size(), [&](std::size_t i) { return std::span(&frames[i], 1); });
    std::vector<Figure> pages;
    for (std::size_t i = 0; i < frames.size(); ++i) pages.push_back(film.page(i));
    return pages;
}

TEST(Compose, PanelsShareLegendAndScale) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    for (const CellNumber heat : {CellNumber::none, CellNumber::order}) {
        Settings settings = session.settings();
        settings.heat = heat;
        settings.label = CellNumber::none;
        settings.show_tessellation = Switch::off;
        session.change(settings);
        std::vector<PanelSource<2>> panels;
        for (const std::uint32_t step : {0u, 30u, 10u}) {
            panels.push_back({session, "step " + std::to_string(step)});
            panels.back().session.seek(step);
        }
        const std::uint64_t hash = panels[1].session.hash();
        const Figure figure = make_figure(panels);
        EXPECT_EQ(panels[1].session.hash(), hash);
        EXPECT_EQ(panels[1].session.position(), 30u);
        ASSERT_EQ(figure.panels.size(), 3u);
        EXPECT_EQ(figure.panels[0].title, "(a) step 0");
        EXPECT_EQ(figure.panels[1].title, "(b) step 30");
        EXPECT_EQ(figure.panels[2].title, "(c) step 10");
        // Every style that a panel uses has its row, once.
        std::set<std::string> used, rows;
        for (const Figure::Panel& panel : figure.panels)
            for (const Shape& shape : panel.list.shapes)
                if (shape.style < style_of(Look::count)) used.insert(panel.list.styles[shape.style].name);
        for (const LegendRow& row : figure.legend) EXPECT_TRUE(rows.insert(row.style.name).second) << row.text;
        EXPECT_EQ(rows, used);
        EXPECT_EQ(figure.bar.has_value(), heat != CellNumber::none);
        if (heat == CellNumber::none) {
            EXPECT_TRUE(used.contains("projected"));
            continue;
        }
        EXPECT_EQ(figure.bar->low, "1");
        EXPECT_EQ(figure.bar->high, "30");
        // The cell of step 5 has one colour in both panels that show it.
        const auto style_at_step_5 = [&](const DrawList& list) {
            const std::uint32_t cell = panels[2].session.timeline().steps[4].item.id;
            const Vec<2> corner = session.cells().points[session.cells().corners_of(cell)[0]];
            for (const Shape& shape : list.shapes)
                if (shape.style >= style_of(Look::count) && list.points[shape.first_point] == corner &&
                    list.points[shape.first_point + 1] == session.cells().points[session.cells().corners_of(cell)[1]])
                    return list.styles[shape.style].name;
            return std::string("none");
        };
        EXPECT_NE(style_at_step_5(figure.panels[1].list), "none");
        EXPECT_EQ(style_at_step_5(figure.panels[1].list), style_at_step_5(figure.panels[2].list));
        EXPECT_EQ(style_at_step_5(figure.panels[0].list), "none");
    }
}

TEST(Compose, NothingJumpsInAFilm) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    Note<2> note;
    note.kind = Note<2>::Kind::callout;
    note.number = 1;
    note.text = "in one frame";
    note.point = {8, 4};
    note.first_step = note.last_step = 12;
    session.notes.push_back(note);
    session.run();
    for (const CellNumber heat : {CellNumber::none, CellNumber::order})
        for (const ZoomAt at : {ZoomAt::view, ZoomAt::last}) {
            Settings settings = session.settings();
            settings.heat = heat;
            settings.label_where = LabelWhere::all;
            settings.zoom_at = at;
            settings.zoom = at == ZoomAt::last ? 4 : 1;
            session.change(settings);
            std::vector<PanelSource<2>> frames;
            for (std::uint32_t step = 0; step <= 24; step += 3) {
                frames.push_back({session, ""});
                frames.back().session.seek(step);
            }
            const std::vector<Figure> film = film_of(frames);
            ASSERT_EQ(film.size(), frames.size());
            const auto text_of = [](const std::vector<LegendRow>& rows) {
                std::string text;
                for (const LegendRow& row : rows) text += row.style.name + ": " + row.text + "\n";
                return text;
            };
            std::set<std::string> used;
            for (std::size_t i = 0; i < film.size(); ++i) {
                const Figure& figure = film[i];
                ASSERT_EQ(figure.panels.size(), 1u);
                const DrawList& list = figure.panels[0].list;
                EXPECT_EQ(list.world.min, film[0].panels[0].list.world.min);
                EXPECT_EQ(list.world.max, film[0].panels[0].list.world.max);
                const Box<2> own = make_picture(frames[i].session).world;
                EXPECT_TRUE(list.world.contains(own.min) && list.world.contains(own.max));
                EXPECT_EQ(text_of(figure.legend), text_of(film[0].legend));
                EXPECT_NE(text_of(figure.legend).find("1: in one frame"), std::string::npos);
                EXPECT_NE(figure.caption.find(" Step " + std::to_string(3 * i) + ":"), std::string::npos);
                // The picture is that of its own step, with the common scale.
                EXPECT_EQ(to_text(list),
                          to_text(make_picture(frames[i].session, {number_range(session, heat), list.world, 0, {}})));
                ASSERT_EQ(figure.bar.has_value(), heat != CellNumber::none);
                if (figure.bar) {
                    EXPECT_EQ(figure.bar->high, film[0].bar->high);
                    EXPECT_EQ(figure.bar->high, std::to_string(session.recorded()));
                }
                for (const LegendRow& row : make_figure(std::span(frames).subspan(i, 1)).legend)
                    used.insert(row.style.name + ": " + row.text);
            }
            const std::vector<Layout> pages = lay_out(film, {}, find_font());
            for (const Layout& page : pages) {
                EXPECT_EQ(page.panels[0].frame.x, pages[0].panels[0].frame.x);
                EXPECT_EQ(page.panels[0].frame.y, pages[0].panels[0].frame.y);
                EXPECT_EQ(page.panels[0].frame.w, pages[0].panels[0].frame.w);
                EXPECT_EQ(page.scale, pages[0].scale);
                ASSERT_EQ(page.legend.size(), pages[0].legend.size());
                for (std::size_t row = 0; row < page.legend.size(); ++row) {
                    EXPECT_EQ(page.legend[row].box.x, pages[0].legend[row].box.x);
                    EXPECT_EQ(page.legend[row].box.y, pages[0].legend[row].box.y);
                }
            }
            // What any frame would list alone is listed.
            for (const std::string& row : used)
                if (at == ZoomAt::view) {
                    EXPECT_NE(text_of(film[0].legend).find(row + "\n"), std::string::npos) << row;
                }
            EXPECT_TRUE(std::string(text_of(film[0].legend)).find("projected last") != std::string::npos)
                << "step 0 has none, but other frames do";
        }
}

TEST(Compose, NotesShowInTheirStepsAtTheirAnchors) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    Note<2> note;
    note.text = "in the middle";
    note.point = {1, 2};
    note.first_step = 3;
    note.last_step = 5;
    session.notes.push_back(note);
    note = {};
    note.kind = Note<2>::Kind::callout;
    note.anchor = Note<2>::Anchor::cell;
    note.index = 7;
    note.number = 4;
    note.text = "explained beside";
    session.notes.push_back(note);
    note.number = 5;
    note.text = "for two steps";
    note.first_step = 2;
    note.last_step = 3;
    session.notes.push_back(note);
    note = {};
    note.kind = Note<2>::Kind::callout;
    note.number = 6;
    note.text = "beside the picture";
    note.point = {1e5, 0};
    session.notes.push_back(note);
    note = {};
    note.kind = Note<2>::Kind::ring;
    note.anchor = Note<2>::Anchor::primitive;
    note.index = 2;
    session.notes.push_back(note);
    for (std::uint32_t step = 0; step < 8; ++step) {
        session.seek(step);
        const Figure figure = make_figure(std::array{PanelSource{session, ""}});
        const DrawList& list = figure.panels[0].list;
        const auto label = [&](const std::string& text) {
            return std::find_if(list.labels.begin(), list.labels.end(), [&](const Label& l) { return l.text == text; });
        };
        ASSERT_EQ(label("in the middle") != list.labels.end(), step >= 3 && step <= 5) << step;
        if (step == 4) {
            EXPECT_EQ(label("in the middle")->at, Vec<2>(1, 2));
        }
        ASSERT_NE(label("4"), list.labels.end());
        EXPECT_EQ(label("4")->at, session.cells().centre(7));
        EXPECT_TRUE(label("4")->disc);
        const auto listed = [&](const char* text) {
            return std::any_of(figure.legend.begin(), figure.legend.end(),
                               [&](const LegendRow& row) { return row.text == text; });
        };
        EXPECT_TRUE(listed("4: explained beside"));
        EXPECT_EQ(listed("5: for two steps"), step == 2 || step == 3) << step;
        EXPECT_FALSE(listed("6: beside the picture"));
        EXPECT_TRUE(std::any_of(list.shapes.begin(), list.shapes.end(), [&](const Shape& shape) {
            const Primitive<2>& p = session.scene().primitives[2];
            return shape.kind == ShapeKind::ring && list.points[shape.first_point] == (p[0] + p[1]) * 0.5;
        }));
    }
}

TEST(Compose, AFigureHasTheNotesThatAWindowShowsBesideTheScene) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    const Box<2> scene = shown_world(session);
    Note<2> note;
    note.text = "beside";
    note.point = {scene.max.x + 0.4 * scene.extent().x, scene.centre().y};
    session.notes.push_back(note);
    note.point = {scene.max.x + 4 * scene.extent().x, scene.centre().y};  // no reason to shrink all
    session.notes.push_back(note);
    const Box<2> world = make_figure(std::array{PanelSource{session, ""}}).panels[0].list.world;
    EXPECT_TRUE(world.contains(session.notes[0].point));
    EXPECT_FALSE(world.contains(note.point));
    EXPECT_TRUE(film_of({{session, ""}})[0].panels[0].list.world.contains(session.notes[0].point));
}

TEST(Compose, TheCaptionNamesTheConditions) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"), "20%");
    session.seek(12);
    const Figure figure = make_figure(std::array{PanelSource{session, ""}});
    for (const std::string& part : std::vector<std::string>{
             "Bottleneck", "seed 147", "published (approximate)", "budget 20% = 67 segments", "Step 12",
             "Reference: exact visible set", std::to_string(session.cells().cell_count()) + " Delaunay cells"})
        EXPECT_NE(figure.caption.find(part), std::string::npos) << part << " in: " << figure.caption;
    Settings settings = session.settings();
    settings.caption = Switch::off;
    settings.legend = Legend::off;
    session.change(settings);
    const Figure bare = make_figure(std::array{PanelSource{session, ""}});
    EXPECT_TRUE(bare.caption.empty());
    EXPECT_EQ(bare.legend_place, LegendPlace::off);
}

}  // namespace
}  // namespace sightline
