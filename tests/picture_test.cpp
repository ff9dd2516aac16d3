// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/picture.h"
#include "core/draw/compose.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/draw/cell_number.h"
#include "core/draw/palette.h"
#include "core/number.h"
#include "core/scene/catalogue.h"
#include "tests/session_support.h"

namespace sightline {
namespace {

Session<2> session_of(const CatalogueRow& row, const char* budget = "unlimited") {
    Settings settings;
    settings.error_bound = row.error_bound;
    settings.method = row.method;
    settings.budget = parse_budget(budget);
    for (const SettingOverride& s : row.settings) apply_setting(settings, std::string(s.field) + "=" + s.value);
    return {std::make_shared<const Scene<2>>(make_scene(row)), row.view, settings};
}

void show_everything(Settings& settings) {
    for (const char* assignment : {"show_normals=on", "show_penalties=on", "show_chain=on", "label=solidity",
                                   "label_where=all", "palette=paper"})
        apply_setting(settings, assignment);
}

std::string picture_hash(const Session<2>& session) {
    const std::string text = to_text(make_picture(session, number_range(session, session.settings().heat)));
    Hash hash;
    for (const char c : text) hash.add(static_cast<unsigned char>(c));
    return hash_text(hash.value());
}

/// Goldens. After a wanted change of the pictures the failure prints the new table.
struct Golden {
    const char* id;
    std::array<const char*, 3> hashes;  ///< at the start, at step 12, at the end with everything shown
};
const std::vector<Golden>& goldens();

TEST(Picture, IsThatOfTheGoldens) {
    std::string table;
    bool same = goldens().size() == catalogue().size();
    for (std::size_t i = 0; i < catalogue().size(); ++i) {
        const CatalogueRow& row = catalogue()[i];
        Session<2> session = session_of(row, row.budget);
        std::array<std::string, 3> now;
        now[0] = picture_hash(session);
        session.seek(12);
        now[1] = picture_hash(session);
        session.run();
        Settings settings = session.settings();
        show_everything(settings);
        session.change(settings);
        session.selected_cell = session.cells().cell_count() / 2;
        now[2] = picture_hash(session);
        table += "        {\"" + std::string(row.id) + "\", {";
        for (int k = 0; k < 3; ++k) {
            table += (k ? ", \"" : "\"") + now[k] + "\"";
            same = same && row.id == std::string_view(goldens()[i].id) && now[k] == goldens()[i].hashes[k];
        }
        table += "}},\n";
    }
    EXPECT_TRUE(same) << "the pictures are now\n" << table;
}

std::uint16_t style_of(Look look) { return static_cast<std::uint16_t>(look); }

std::set<std::vector<double>> polygons(const DrawList& list, Look look) {
    std::set<std::vector<double>> found;
    for (const Shape& shape : list.shapes)
        if (shape.kind == ShapeKind::polygon && shape.style == style_of(look)) {
            std::vector<double> corners;
            for (std::uint32_t i = 0; i < shape.point_count; ++i) {
                corners.push_back(list.points[shape.first_point + i].x);
                corners.push_back(list.points[shape.first_point + i].y);
            }
            EXPECT_TRUE(found.insert(corners).second) << "drawn twice";
        }
    return found;
}

std::size_t count(const DrawList& list, Look look) {
    return static_cast<std::size_t>(std::count_if(list.shapes.begin(), list.shapes.end(),
                                                  [&](const Shape& s) { return s.style == style_of(look); }));
}

TEST(Picture, CellsLookAsTheirStates) {
    Random random(71);
    for (int i = 0; i < 150; ++i) {
        const test::Start start = test::random_start(random);
        Session<2> session = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(40)));
        const DrawList list = make_picture(session, std::nullopt);
        std::map<CellState, std::set<std::vector<double>>> expected;
        for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
            std::vector<double> corners;
            for (const std::uint32_t p : session.cells().corners_of(cell)) {
                corners.push_back(session.cells().points[p].x);
                corners.push_back(session.cells().points[p].y);
            }
            expected[session.state().mark(cell).state].insert(corners);
        }
        ASSERT_EQ(polygons(list, Look::projected), expected[CellState::projected]);
        ASSERT_EQ(polygons(list, Look::enqueued), expected[CellState::enqueued]);
        ASSERT_EQ(polygons(list, Look::unseen), expected[CellState::unseen]);
        ASSERT_EQ(count(list, Look::tessellation), session.cells().facet_count());

        // Primitives by what the budget and the exact set say.
        std::array<std::size_t, 4> lines{};
        std::set<std::uint32_t> rendered;
        for (std::uint32_t t = 0; t < session.state().touched_count; ++t)
            if (session.state().touched[t] < State<2>::culled_bit) rendered.insert(session.state().touched[t]);
        for (std::uint32_t p = 0; p < start.scene->primitives.size(); ++p)
            ++lines[2 * rendered.contains(p) + session.reference().visible[p]];
        ASSERT_EQ(count(list, Look::other), lines[0]);
        ASSERT_EQ(count(list, Look::missed), lines[1]);
        ASSERT_EQ(count(list, Look::wasted), lines[2]);
        ASSERT_EQ(count(list, Look::rendered), lines[3]);
        ASSERT_EQ(count(list, Look::last), session.position() > 0 && session.method().orders_cells);
        for (const Shape& shape : list.shapes) {
            ASSERT_LT(shape.style, list.styles.size());
            ASSERT_LE(shape.first_point + shape.point_count, list.points.size());
        }
        for (const Vec<2>& point : list.points) ASSERT_TRUE(is_finite(point));
    }
}

TEST(Picture, SwitchesTakeAwayWhatTheyName) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    session.seek(12);
    session.selected_cell = 5;
    const auto with = [&](const char* assignment) {
        Session<2> changed = session;
        Settings settings = session.settings();
        apply_setting(settings, "show_normals=on");
        apply_setting(settings, "show_penalties=on");
        apply_setting(settings, assignment);
        changed.change(settings);
        return make_picture(changed, std::nullopt);
    };
    const DrawList all = with("show_view=on");
    const std::pair<const char*, std::vector<Look>> switches[] = {
        {"show_tessellation=off", {Look::tessellation}},
        {"show_states=off", {Look::projected, Look::enqueued, Look::unseen}},
        {"show_primitives=off", {Look::other, Look::rendered, Look::wasted, Look::missed}},
        {"show_view=off", {Look::view, Look::eye, Look::seed}},
        {"show_normals=off", {Look::normal, Look::eye_ray}},
        {"show_penalties=off", {Look::penalty}},
    };
    for (const auto& [assignment, looks] : switches) {
        const DrawList list = with(assignment);
        for (std::uint16_t look = 0; look < style_of(Look::count); ++look) {
            const bool gone = std::find(looks.begin(), looks.end(), static_cast<Look>(look)) != looks.end();
            EXPECT_EQ(count(list, static_cast<Look>(look)), gone ? 0 : count(all, static_cast<Look>(look)))
                << assignment << " and style " << all.styles[look].name;
        }
        for (const Look look : looks) EXPECT_GT(count(all, look), 0u) << assignment;
    }
}

TEST(Picture, StatesStayApartWithoutColour) {
    constexpr std::array states{Look::clean, Look::enqueued, Look::projected, Look::unseen};
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        const auto& looks = colours(palette).looks;
        ASSERT_EQ(looks.size(), style_of(Look::count));
        for (const Look a : states)
            for (const Look b : states) {
                if (a >= b) continue;
                const Style &first = looks[style_of(a)], &second = looks[style_of(b)];
                EXPECT_EQ(first.fill.a, 255);
                const double apart = std::abs(lightness(first.fill) - lightness(second.fill));
                if (palette == Palette::paper)  // the papers' own colours: a hatch or an outline helps
                    EXPECT_TRUE(apart >= 18 || first.hatch != second.hatch || first.stroke.a != second.stroke.a)
                        << first.name << " and " << second.name;
                else
                    EXPECT_GE(apart, 18) << first.name << " and " << second.name;
            }
        EXPECT_NE(looks[style_of(Look::enqueued)].hatch, Hatch::none);
        EXPECT_NE(looks[style_of(Look::unseen)].hatch, Hatch::none);
        EXPECT_NE(looks[style_of(Look::enqueued)].hatch, looks[style_of(Look::unseen)].hatch);
        for (const Style& style : looks)
            if (style.stroke.a > 0) {
                EXPECT_GE(style.width_pt, 0.5) << style.name;
            }
        // A heat map grows lighter or darker all the way.
        const auto& heat = colours(palette).heat;
        for (std::size_t i = 2; i < heat.size(); ++i)
            EXPECT_GT((lightness(heat[i]) - lightness(heat[i - 1])) * (lightness(heat[1]) - lightness(heat[0])), 0);
    }
    EXPECT_NEAR(lightness({0, 0, 0}), 0, 1e-9);
    EXPECT_NEAR(lightness({255, 255, 255}), 100, 1e-6);
    EXPECT_NEAR(lightness({119, 119, 119}), 50.03, 0.01);
}

TEST(Picture, ShowingSomethingElseMovesNothing) {
    Random random(72);
    for (int i = 0; i < 60; ++i) {
        const test::Start start = test::random_start(random);
        Session<2> session = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(30)));
        session.seek(session.position() / 2);
        const std::uint64_t hash = session.hash();
        const std::uint32_t recorded = session.recorded();
        for (const SettingRow& row : settings_table()) {
            if (row.invalidates != Invalidates::picture || row.name == "zoom" || row.values == "a finite number")
                continue;
            for (std::size_t begin = 0; begin < row.values.size();) {
                const std::size_t end = std::min(row.values.find(" | ", begin), row.values.size());
                Settings settings = session.settings();
                row.set(settings, row.values.substr(begin, end - begin));
                session.change(settings);
                make_figure(std::array{PanelSource{session, ""}});
                ASSERT_EQ(session.hash(), hash) << row.name;
                ASSERT_EQ(session.recorded(), recorded) << row.name;
                begin = end + 3;
            }
        }
    }
}

TEST(Picture, LabelsAreTheNumbersOfTheCells) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    session.seek(20);
    const std::uint32_t last = session.timeline().steps[19].cell;
    for (const CellNumber what : {CellNumber::solidity, CellNumber::count, CellNumber::order, CellNumber::zeta,
                                  CellNumber::share, CellNumber::id})
        for (const LabelWhere where : {LabelWhere::all, LabelWhere::front, LabelWhere::selected}) {
            Settings settings = session.settings();
            settings.label = what;
            settings.label_where = where;
            session.change(settings);
            session.selected_cell = last;
            const auto numbers = cell_numbers(session, what);
            const Box<2> world = make_picture(session, std::nullopt).world;
            std::multiset<std::string> expected, found;
            for (std::uint32_t cell = 0; cell < numbers.size(); ++cell) {
                const bool front = session.state().mark(cell).state == CellState::enqueued;
                const bool wanted = where == LabelWhere::all || cell == last || (where == LabelWhere::front && front);
                if (numbers[cell] && wanted && world.contains(session.cells().centres[cell]))
                    expected.insert(short_number(*numbers[cell]));
            }
            const DrawList list = make_picture(session, std::nullopt);
            for (const Label& label : list.labels) found.insert(label.text);
            if (where != LabelWhere::selected) {
                EXPECT_EQ(found, expected) << number_title(what);
            }
            EXPECT_EQ(found.empty(), !numbers[last] && where == LabelWhere::selected);
            if (numbers[last]) {
                // The cell just projected keeps its number however crowded the picture is.
                ASSERT_FALSE(list.labels.empty());
                EXPECT_FALSE(list.labels.front().yields);
                EXPECT_EQ(list.labels.front().at, session.cells().centres[last]);
            }
        }
}

TEST(Picture, CellNumbersAreWhatTheySay) {
    Random random(73);
    for (int i = 0; i < 60; ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(40)));
        const auto order = cell_numbers(session, CellNumber::order), keys = cell_numbers(session, CellNumber::solidity);
        const auto share = cell_numbers(session, CellNumber::share), ids = cell_numbers(session, CellNumber::id);
        const auto count_of = cell_numbers(session, CellNumber::count);
        for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
            const CellMark mark = session.state().mark(cell);
            ASSERT_EQ(order[cell].has_value(), mark.state == CellState::projected);
            if (order[cell]) {
                ASSERT_EQ(session.timeline().steps[static_cast<std::size_t>(*order[cell]) - 1].cell, cell);
            }
            ASSERT_EQ(keys[cell].has_value(), mark.state == CellState::projected || mark.state == CellState::enqueued);
            if (keys[cell]) {
                ASSERT_EQ(*keys[cell], mark.key);
            }
            ASSERT_EQ(share[cell], session.reference().cell_share[cell]);
            ASSERT_EQ(ids[cell], cell);
            ASSERT_EQ(count_of[cell], session.cells().count(cell));
        }
        // A scale covers every number of the recording, wherever the session stands.
        const auto range = number_range(session, CellNumber::order);
        const std::uint32_t recorded = session.recorded();
        session.seek(session.position() / 2);
        ASSERT_EQ(number_range(session, CellNumber::order), range);
        if (recorded > 0) {
            ASSERT_EQ(range, (std::array<double, 2>{1, double(recorded)}));
        }
    }
}

TEST(Picture, PanelsShareLegendAndScale) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    for (const CellNumber heat : {CellNumber::none, CellNumber::order}) {
        Settings settings = session.settings();
        settings.heat = heat;
        settings.show_tessellation = Switch::off;
        session.change(settings);
        std::vector<PanelSource> panels;
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
            const std::uint32_t cell = panels[2].session.timeline().steps[4].cell;
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

TEST(Picture, NotesShowInTheirStepsAtTheirAnchors) {
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
        EXPECT_EQ(label("4")->at, session.cells().centres[7]);
        EXPECT_TRUE(label("4")->disc);
        EXPECT_TRUE(std::any_of(figure.legend.begin(), figure.legend.end(),
                                [](const LegendRow& row) { return row.text == "4: explained beside"; }));
        EXPECT_TRUE(std::any_of(list.shapes.begin(), list.shapes.end(), [&](const Shape& shape) {
            const Primitive<2>& p = session.scene().primitives[2];
            return shape.kind == ShapeKind::ring && list.points[shape.first_point] == (p[0] + p[1]) * 0.5;
        }));
    }
}

TEST(Picture, TheCaptionNamesTheConditions) {
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

TEST(Picture, ThePointInTheMiddleIsTheOneAskedFor) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    const Vec<2> whole = make_picture(session, std::nullopt).world.extent();
    Random random(75);
    for (int i = 0; i < 200; ++i) {
        Settings settings = session.settings();
        settings.zoom_at = ZoomAt::point;
        settings.zoom = i % 4 == 0 ? 1 : random.uniform(0.2, 20);
        settings.zoom_x = random.uniform(-50, 50);
        settings.zoom_y = random.uniform(-50, 50);
        session.change(settings);
        const Box<2> world = make_picture(session, std::nullopt).world;
        ASSERT_NEAR(world.centre().x, settings.zoom_x, 1e-9);
        ASSERT_NEAR(world.centre().y, settings.zoom_y, 1e-9);
        ASSERT_NEAR(world.extent().x, whole.x / settings.zoom, 1e-9);
        ASSERT_NEAR(world.extent().y, whole.y / settings.zoom, 1e-9);
    }
}

TEST(Picture, AnEmptySceneHasAWorld) {
    for (const Vec<2> eye : {Vec<2>(0, 0), Vec<2>(1e6, -3)}) {
        Session<2> session(std::make_shared<const Scene<2>>(), {eye, eye + Vec<2>(1, 0), 60}, {});
        const DrawList list = make_picture(session, std::nullopt);
        EXPECT_GT(list.world.extent().x, 0);
        EXPECT_GT(list.world.extent().y, 0);
    }
}

const std::vector<Golden>& goldens() {
    static const std::vector<Golden> table{
        {"bottleneck", {"44272a7fec5ae06f", "a51db83ef48aaa6d", "7c68d3ecd4c24ca0"}},
        {"streets", {"1ecebe0c3378249d", "54bcd4d4ea9d17bb", "3461801b63546227"}},
        {"rooms", {"8feaba47922e556a", "17ca086d07fd2770", "4ada867764ce8eef"}},
        {"cars", {"17e747b11acb4000", "000de1006bf7569a", "085ff03129e2a089"}},
        {"jungle", {"92c1d109481afbd2", "69a929827866f1eb", "594a809e4031a44d"}},
        {"terrain", {"bba85392f8177fdf", "a49d3256ad896cf7", "abdb347e71c2c295"}},
        {"wallholes", {"8d738c0ef163bd5e", "78333dd1b11800b2", "e5ba6a7ab6b49963"}},
        {"wall2", {"40bb4ab0fcbee660", "7a5478cbcff60219", "cd1e884b30e8693c"}},
        {"statue", {"bde2c2c2f7f8fe86", "8abe867e625d80c1", "11496bc6f62be356"}},
        {"forget", {"024d8e4b87776b98", "3336be2914d154a3", "511e049f8c0d5e8c"}},
    };
    return table;
}

}  // namespace
}  // namespace sightline
