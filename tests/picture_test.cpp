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
#include "shell/figure/layout.h"
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
    const std::string text = to_text(make_picture(session, {number_range(session, session.settings().heat)}));
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
        const DrawList list = make_picture(session);
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
        apply_setting(settings, "penalty=multiply");
        apply_setting(settings, assignment);
        changed.change(settings);
        return make_picture(changed);
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

TEST(Picture, CellsStayApartWithoutColour) {
    // Those that stand in one picture.
    const std::vector<Look> by_state{Look::clean, Look::enqueued, Look::projected, Look::unseen};
    const std::vector<Look> by_side{Look::clean, Look::both, Look::only_left, Look::only_right};
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        const Colours& all = colours(palette);
        const auto& looks = all.looks;
        ASSERT_EQ(looks.size(), style_of(Look::count));
        const auto check = [&](Look a, Look b, bool papers_own) {
            const Style &first = looks[style_of(a)], &second = looks[style_of(b)];
            EXPECT_EQ(first.fill.a, 255);
            EXPECT_EQ(second.fill.a, 255);
            const double apart = std::abs(lightness(first.fill) - lightness(second.fill));
            const bool other_lines = first.hatch != second.hatch || first.stroke.a != second.stroke.a;
            EXPECT_TRUE(apart >= 20 || (papers_own && other_lines)) << first.name << " and " << second.name;
        };
        for (const auto& set : {by_state, by_side})
            for (const Look a : set)
                for (const Look b : set)
                    // The papers' own colours of states lie close together: a hatch or an outline helps.
                    if (a < b) check(a, b, palette == Palette::paper && b <= Look::unseen);
        for (const auto& [a, b] :
             {std::pair(Look::enqueued, Look::unseen), std::pair(Look::only_left, Look::only_right)}) {
            EXPECT_NE(looks[style_of(a)].hatch, Hatch::none);
            EXPECT_NE(looks[style_of(b)].hatch, Hatch::none);
            EXPECT_NE(looks[style_of(a)].hatch, looks[style_of(b)].hatch);
        }
        for (const Style& style : looks)
            if (style.stroke.a > 0) {
                EXPECT_GE(style.width_pt, 0.5) << style.name;
            }
        // A heat map grows lighter or darker all the way.
        const auto& heat = all.heat;
        for (std::size_t i = 2; i < heat.size(); ++i)
            EXPECT_GT((lightness(heat[i]) - lightness(heat[i - 1])) * (lightness(heat[1]) - lightness(heat[0])), 0);
    }
    EXPECT_NEAR(lightness({0, 0, 0}), 0, 1e-9);
    EXPECT_NEAR(lightness({255, 255, 255}), 100, 1e-6);
    EXPECT_NEAR(lightness({119, 119, 119}), 50.03, 0.01);
}

TEST(Picture, TextStandsOutFromWhatIsBehindIt) {
    EXPECT_NEAR(contrast({0, 0, 0}, {255, 255, 255}), 21, 1e-9);
    EXPECT_NEAR(contrast({118, 118, 118}, {255, 255, 255}), 4.54, 0.01);  // WCAG's own example of 4.5:1
    EXPECT_EQ(contrast({9, 90, 200}, {9, 90, 200}), 1);
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    session.seek(20);
    for (const Note<2>::Kind kind : {Note<2>::Kind::text, Note<2>::Kind::arrow, Note<2>::Kind::callout}) {
        Note<2> note;
        note.kind = kind;
        note.text = "x";
        session.notes.push_back(note);
    }
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        Settings settings = session.settings();
        settings.palette = palette;
        settings.label = CellNumber::solidity;
        session.change(settings);
        const DrawList list = make_picture(session);
        ASSERT_GT(list.labels.size(), 5u);
        for (const Label& label : list.labels) {
            const Colour behind = label.disc.value_or(label.halo);
            ASSERT_EQ(behind.a, 255);
            EXPECT_GE(contrast(label.colour, behind), 7) << label.text;
        }
        EXPECT_GE(contrast(colours(palette).ink, colours(palette).background), 7);
    }
}

TEST(Picture, CellsOfTwoSessionsLookAsWhoProjectedThem) {
    Random random(76);
    for (int i = 0; i < 60; ++i) {
        test::Start start = test::random_cell_start(random);
        start.settings.zoom = 0.05;  // the legend says what is in the picture, and all shall be
        Session<2> session = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(20)));
        std::vector<Side> sides(session.cells().cell_count());
        std::map<Side, std::size_t> expected;
        for (Side& side : sides) {
            side = static_cast<Side>(random.below(4));
            ++expected[side];
        }
        const DrawList list = make_picture(session, {.sides = sides});
        ASSERT_EQ(polygons(list, Look::both).size(), expected[Side::both]);
        ASSERT_EQ(polygons(list, Look::only_left).size(), expected[Side::left]);
        ASSERT_EQ(polygons(list, Look::only_right).size(), expected[Side::right]);
        for (const Look look : {Look::projected, Look::enqueued, Look::unseen}) ASSERT_EQ(count(list, look), 0u);
        std::set<std::string> rows;
        const Figure figure = make_figure(std::array{PanelSource{session, "", sides}});
        for (const LegendRow& row : figure.legend) rows.insert(row.text);
        ASSERT_EQ(rows.contains("projected by both"), expected[Side::both] > 0);
        ASSERT_EQ(rows.contains("only by the left method"), expected[Side::left] > 0);
        ASSERT_EQ(rows.contains("only by the right method"), expected[Side::right] > 0);
        ASSERT_EQ(rows.contains("projected by neither"), sides.size() > expected[Side::neither]);
    }
}

TEST(Picture, AWindowIsFilledWithoutCuttingAnything) {
    Random random(77);
    for (int i = 0; i < 100; ++i) {
        const test::Start start = test::random_start(random);
        Session<2> session = start.session();
        Settings settings = session.settings();
        settings.zoom = random.uniform(0.5, 10);
        session.change(settings);
        const double aspect = random.uniform(0.2, 5);
        const Box<2> own = make_picture(session).world, wide = make_picture(session, {.aspect = aspect}).world;
        const Vec<2> size = wide.extent();
        ASSERT_NEAR(size.x / size.y, aspect, 1e-9 * aspect);
        ASSERT_NEAR(glm::length(wide.centre() - own.centre()), 0, 1e-9 * glm::length(own.extent()));
        const double slack = 1e-9 * own.longest_side();
        ASSERT_TRUE(wide.min.x <= own.min.x + slack && wide.min.y <= own.min.y + slack);
        ASSERT_TRUE(wide.max.x >= own.max.x - slack && wide.max.y >= own.max.y - slack);
        ASSERT_TRUE(std::abs(size.x - own.extent().x) <= slack || std::abs(size.y - own.extent().y) <= slack);
    }
}

TEST(Picture, TheSelectedSegmentIsDrawnOnTop) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    EXPECT_EQ(count(make_picture(session), Look::selected_primitive), 0u);
    session.selected_primitive = 17;
    const Figure figure = make_figure(std::array{PanelSource{session, ""}});
    const DrawList& list = figure.panels[0].list;
    ASSERT_EQ(count(list, Look::selected_primitive), 1u);
    const Shape& shape = list.shapes.back();
    EXPECT_EQ(shape.style, style_of(Look::selected_primitive));
    EXPECT_EQ(list.points[shape.first_point], session.scene().primitives[17][0]);
    EXPECT_EQ(list.points[shape.first_point + 1], session.scene().primitives[17][1]);
    EXPECT_TRUE(std::any_of(figure.legend.begin(), figure.legend.end(),
                            [](const LegendRow& row) { return row.text == "selected segment"; }));
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
            const Box<2> world = make_picture(session).world;
            std::multiset<std::string> expected, found;
            for (std::uint32_t cell = 0; cell < numbers.size(); ++cell) {
                const bool front = session.state().mark(cell).state == CellState::enqueued;
                const bool wanted = where == LabelWhere::all || cell == last || (where == LabelWhere::front && front);
                if (numbers[cell] && wanted && world.contains(session.cells().centres[cell]))
                    expected.insert(short_number(*numbers[cell]));
            }
            const DrawList list = make_picture(session);
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

TEST(Picture, LayeringNumbersAreThoseOfTheViewAndTheSceneNow) {
    Random random(78);
    for (int i = 0; i < 60; ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        const auto check = [&] {
            const auto layers = layering_numbers(session.scene().primitives, make_view(session.culling_view()));
            const auto numbers = cell_numbers(session, CellNumber::zeta);
            for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
                std::optional<double> least;
                for (const std::uint32_t p : session.cells().primitives_of(cell))
                    if (layers[p] > 0) least = std::min<double>(least.value_or(layers[p]), layers[p]);
                ASSERT_EQ(numbers[cell], least);
            }
        };
        check();
        session.set_view(test::random_view(random));
        check();
        session.seek(7);
        session.set_scene(test::random_start(random).scene);
        check();
        Settings settings = session.settings();
        settings.error_bound = 0.3;
        session.change(settings);
        check();
    }
}

TEST(Picture, PanelsShareLegendAndScale) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    for (const CellNumber heat : {CellNumber::none, CellNumber::order}) {
        Settings settings = session.settings();
        settings.heat = heat;
        settings.label = CellNumber::none;
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

TEST(Picture, NothingJumpsInAFilm) {
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
            std::vector<PanelSource> frames;
            for (std::uint32_t step = 0; step <= 24; step += 3) {
                frames.push_back({session, ""});
                frames.back().session.seek(step);
            }
            const std::vector<Figure> film = make_film(frames);
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
        EXPECT_EQ(label("4")->at, session.cells().centres[7]);
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
    const Vec<2> whole = make_picture(session).world.extent();
    Random random(75);
    for (int i = 0; i < 200; ++i) {
        Settings settings = session.settings();
        settings.zoom_at = ZoomAt::point;
        settings.zoom = i % 4 == 0 ? 1 : random.uniform(0.2, 20);
        settings.zoom_x = random.uniform(-50, 50);
        settings.zoom_y = random.uniform(-50, 50);
        session.change(settings);
        const Box<2> world = make_picture(session).world;
        ASSERT_NEAR(world.centre().x, settings.zoom_x, 1e-9);
        ASSERT_NEAR(world.centre().y, settings.zoom_y, 1e-9);
        ASSERT_NEAR(world.extent().x, whole.x / settings.zoom, 1e-9);
        ASSERT_NEAR(world.extent().y, whole.y / settings.zoom, 1e-9);
    }
}

TEST(Picture, AnEmptySceneHasAWorld) {
    for (const Vec<2> eye : {Vec<2>(0, 0), Vec<2>(1e6, -3)}) {
        Session<2> session(std::make_shared<const Scene<2>>(), {eye, eye + Vec<2>(1, 0), 60}, {});
        const DrawList list = make_picture(session);
        EXPECT_GT(list.world.extent().x, 0);
        EXPECT_GT(list.world.extent().y, 0);
    }
}

const std::vector<Golden>& goldens() {
    static const std::vector<Golden> table{
        {"bottleneck", {"c40795377bb0c11c", "87039a81bb4f7a62", "722a2d2ff5d87b2d"}},
        {"streets", {"f30ef3993e4f3dd6", "df5d32bc98cb09a7", "583e9bf2d2c63876"}},
        {"rooms", {"2c917de7abe2acc8", "0036b8e51509fa3f", "b894818e99b3b7c7"}},
        {"cars", {"53375df48d77b2ef", "89dd8ff57643a827", "1d682c8bf437a4c0"}},
        {"jungle", {"89712fee4f22c64c", "a12df0e820cbeb56", "fcf4b1a91c1210f1"}},
        {"terrain", {"288f0445cfffd0cd", "56483c64548756d8", "0b5f43792c05577e"}},
        {"wallholes", {"bd7be110f48bf14d", "5ca6df54703894a8", "5ed7c79b63732097"}},
        {"wall2", {"c4992baadaa1201f", "cd3b3f385ab7bf27", "2ae8a350ddf0d8ff"}},
        {"statue", {"85a5a16ed253a383", "84807f4b17539c68", "9fb56febae013aa9"}},
        {"forget", {"af9dafc06a92fd38", "039c4c3c621b2000", "07e4b1b1c095ae59"}},
    };
    return table;
}

}  // namespace
}  // namespace sightline
