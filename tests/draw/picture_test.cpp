// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/picture.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/draw/cell_number.h"
#include "core/draw/compose.h"
#include "core/draw/shown_boxes.h"
#include "core/session/settings_table.h"
#include "tests/draw/picture_support.h"

namespace sightline {
namespace {

using namespace test;

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
        const CatalogueRow<2>& row = catalogue()[i];
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

TEST(Picture, CellsLookAsTheirStates) {
    Random random(71);
    for (int i = 0; i < 150; ++i) {
        const test::Start start = test::random_start(random);
        Session<2> session = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(40)));
        if (session.traversal().tests_planes()) continue;  // box_pictures_test.cpp
        const DrawList list = make_picture(session);
        std::map<CellState, std::set<std::vector<double>>> expected;
        std::map<CellState, std::vector<std::vector<double>>> boxes;
        for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
            std::vector<double> corners;
            for (const std::uint32_t p : session.cells().corners_of(cell)) {
                corners.push_back(session.cells().points[p].x);
                corners.push_back(session.cells().points[p].y);
            }
            expected[session.mark(cell).state].insert(corners);
        }
        if (session.method().pops == Kind::node) {
            expected.clear();
            for (const ShownBox<2>& shown : shown_boxes(session)) {
                std::vector<double>& corners = boxes[shown.state].emplace_back();
                for (int i = 0; i < 4; ++i)
                    corners.insert(corners.end(), {shown.box.corner(i).x, shown.box.corner(i).y});
            }
            for (const auto& [state, of_state] : boxes) expected[state] = {of_state.begin(), of_state.end()};
            ASSERT_EQ(polygons(list, Look::hidden), expected[CellState::hidden]);
        }
        ASSERT_EQ(polygons(list, Look::projected), expected[CellState::projected]);
        ASSERT_EQ(polygons(list, Look::enqueued), expected[CellState::enqueued]);
        ASSERT_EQ(polygons(list, Look::unseen), expected[CellState::unseen]);
        ASSERT_EQ(count(list, Look::tessellation),
                  session.method().pops == Kind::node ? 0 : session.cells().facet_count());

        // Primitives by what the budget and the exact set say.
        std::array<std::size_t, 4> lines{};
        const std::vector<std::uint32_t> ids = rendered_ids(session.met());
        const std::set<std::uint32_t> rendered(ids.begin(), ids.end());
        for (std::uint32_t p = 0; p < start.scene->primitives.size(); ++p)
            ++lines[2 * rendered.contains(p) + session.reference().visible[p]];
        ASSERT_EQ(count(list, Look::other), lines[0]);
        ASSERT_EQ(count(list, Look::missed), lines[1]);
        ASSERT_EQ(count(list, Look::wasted), lines[2]);
        ASSERT_EQ(count(list, Look::rendered), lines[3]);
        ASSERT_EQ(count(list, Look::last), session.position() > 0 && session.method().pops != Kind::primitive);
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

/// The shapes that are of neither of these looks, and all the labels, as text.
std::string without(DrawList list, std::initializer_list<Look> looks) {
    std::erase_if(list.shapes, [&](const Shape& shape) {
        return std::any_of(looks.begin(), looks.end(), [&](Look look) { return shape.style == style_of(look); });
    });
    return to_text(list);
}

TEST(Picture, AComparisonAddsTheDifferencesAndNothingElse) {
    Random random(76);
    std::size_t inner = 0;
    for (int i = 0; i < 60; ++i) {
        test::Start start = test::random_cell_start(random);
        start.settings.zoom = 0.05;  // the legend says what is in the picture, and all shall be
        Session<2> session = start.session();
        session.seek(static_cast<std::uint32_t>(random.below(20)));
        const CellComplex<2>& cells = session.cells();
        std::vector<Differs> differences(cells.cell_count());
        std::map<Differs, std::size_t> expected;
        for (Differs& differs : differences) {
            differs = static_cast<Differs>(random.below(3));
            ++expected[differs];
        }
        const DrawList list = make_picture(session, {.differences = differences});
        ASSERT_EQ(without(list, {Look::only_here, Look::only_there}), to_text(make_picture(session)));
        ASSERT_EQ(polygons(list, Look::only_there).size(), expected[Differs::only_there]);
        // The outline lies between cells of which one is drawn only here, or at the border of the tessellation.
        std::size_t outline = 0;
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            if (differences[cell] != Differs::only_here) continue;
            for (const HalfFacet& half : cells.facets_of(cell)) {
                if (cells.is_contact(half.facet())) continue;
                const bool inside = half.neighbour != none && differences[half.neighbour] == Differs::only_here;
                outline += !inside;
                inner += inside;
            }
        }
        ASSERT_EQ(count(list, Look::only_here), outline);
        std::set<std::string> rows;
        const Figure figure = make_figure(std::array{PanelSource{session, "", differences}});
        for (const LegendRow& row : figure.legend) rows.insert(row.text);
        ASSERT_EQ(rows.contains("projected only here"), expected[Differs::only_here] > 0);
        ASSERT_EQ(rows.contains("projected only in the other"), expected[Differs::only_there] > 0);
    }
    EXPECT_GT(inner, 100u);
}

TEST(Picture, WithoutStatesThereAreNoDifferencesOfThem) {
    Session<2> session = session_of(*find_in_catalogue("bottleneck"));
    session.seek(10);
    Settings settings = session.settings();
    settings.show_states = Switch::off;
    session.change(settings);
    const std::vector<Differs> differences(session.cells().cell_count(), Differs::only_here);
    EXPECT_EQ(to_text(make_picture(session, {.differences = differences})), to_text(make_picture(session)));
}

TEST(Picture, BesideAMethodWithoutCellsNothingIsMarked) {
    Session<2> session = session_of(*find_in_catalogue("terrain"));
    session.seek(10);
    Session<2> by_distance = session;
    Settings settings = session.settings();
    settings.method = "centroid";
    by_distance.change(settings);
    for (const auto& [here, there] : {std::pair(&session, &by_distance), std::pair(&by_distance, &session)}) {
        const std::vector<Differs> differences = cell_differences(*here, *there);
        const DrawList list = make_picture(*here, {.differences = differences});
        EXPECT_EQ(count(list, Look::only_here) + count(list, Look::only_there), 0u);
        EXPECT_EQ(to_text(list), to_text(make_picture(*here)));
    }
    EXPECT_GT(count(make_picture(session), Look::enqueued), 0u);
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
            if (row.invalidates != Invalidates::picture) continue;
            for (const std::string_view word : row.words) {
                Settings settings = session.settings();
                row.set(settings, word);
                session.change(settings);
                make_figure(std::array{PanelSource{session, ""}});
                ASSERT_EQ(session.hash(), hash) << row.name;
                ASSERT_EQ(session.recorded(), recorded) << row.name;
            }
        }
    }
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
        {"bottleneck", {"c096c795669b00c2", "ec143914054f17c6", "be116bb0c80eb47f"}},
        {"field", {"ca8739aeacd32750", "3d386d8eff72ea61", "8019d513ff83062d"}},
        {"streets", {"295e244b406380a0", "4ab8298899710e3b", "465a823a72c0dab4"}},
        {"rooms", {"16bb47e2626d751c", "eed76559c59d37c9", "bad14566ad5a3de7"}},
        {"cars", {"a71786e27db2d3bc", "0086e8ff73715e3d", "7eb1fcb7bd020623"}},
        {"jungle", {"218f5482a98d4eb5", "01c1ec74ddb625f8", "c242c507fb3123f9"}},
        {"terrain", {"49b85d863d6a4d20", "266d62e1a90337ca", "fe90faf37bd35859"}},
        {"wallholes", {"c57fb18f6876cf6e", "2ea79cb4e11f0f07", "b0e1e1df18f5d6a7"}},
        {"wall2", {"2026bf0ae22ee35a", "fae2810b9b8955b3", "e89a15c9789139f1"}},
        {"statue", {"9c44162a23e23215", "4f424a1602abbc93", "9d33e7487cff7d64"}},
        {"forget", {"64d0b75d8482c4c1", "41aae3452e06deaa", "932829af2f622611"}},
        {"soda", {"6f3eb71457d897ea", "64efbbb097c948aa", "85005fde6cec45bc"}},
        {"blocks", {"8a08d17d319cb72c", "bb5ded716e8204d5", "70c9360d100ef26b"}},
        {"tetra", {"34a11bc5d2da292a", "189e6871eee44363", "20999be93a95af76"}},
        {"campus", {"d85cce97f662f76e", "9fcec54ee00791f0", "0038c68a8a4ea86a"}},
    };
    return table;
}

/// The names of the styles of the strip's bars, and how often each is there.
std::map<std::string, int> strip_of(const Session<2>& session) {
    const DrawList list = make_picture(session);
    std::map<std::string, int> bars;
    for (const Shape& shape : list.shapes)
        if (const std::string& name = list.styles[shape.style].name; name.starts_with("depth") || name == "tile_read")
            ++bars[name];
    return bars;
}

TEST(Picture, AStripOfDepthsShowsWhichTilesARoundReads) {
    Random random(75);
    bool fewer = false;
    for (int i = 0; i < 10; ++i) {
        test::Start start = test::random_start(random);
        start.settings.method = "cplp";
        start.settings.budget = {Budget::Kind::share, 0.1};
        for (const char* const assignment : {"test=item", "show_depth=on", "reference_size=640"})
            apply_setting(start.settings, assignment);
        Session<2> session = start.session();
        EXPECT_EQ(strip_of(session)["tile_read"], 0);
        session.run();
        const auto tiles = session.traversal().tiles();
        const auto read = std::count_if(tiles.begin(), tiles.end(), [](const ReadTile& tile) { return tile.read; });
        EXPECT_EQ(strip_of(session)["tile_read"], read);
        fewer |= read < static_cast<std::ptrdiff_t>(tiles.size());
    }
    EXPECT_TRUE(fewer);
}

TEST(Picture, AStripOfDepthsShowsWhatTheEyeHasBeforeIt) {
    test::Start start;
    Scene<2> scene;
    scene.primitives = {{Vec<2>(2, -1), Vec<2>(2, 1)}, {Vec<2>(3, -3), Vec<2>(3, -0.5)}, {Vec<2>(-1, 5), Vec<2>(9, 5)}};
    start.scene = std::make_shared<const Scene<2>>(scene);
    start.view = {{0, 0}, {1, 0}, 90};
    start.settings.method = "everything";
    start.settings.budget = {};
    Session<2> session = start.session();
    EXPECT_TRUE(strip_of(session).empty());
    Settings settings = session.settings();
    apply_setting(settings, "show_depth=on");
    apply_setting(settings, "reference_size=768");
    session.change(settings);
    auto bars = strip_of(session);
    EXPECT_EQ(bars["depth"], 0) << "nothing is rendered";
    EXPECT_EQ(bars["depth_rim"], 1);
    session.run();
    // All but what lies between the wall's left end, at half of the way to the border, and 5/9 of it.
    bars = strip_of(session);
    EXPECT_NEAR(bars["depth"], 192 * (1 - (5.0 / 9 - 0.5) / 2), 2);
    const auto label = [&] {
        const DrawList list = make_picture(session);
        std::string text;
        for (const Label& each : list.labels) text += each.text + "\n";
        return text;
    };
    EXPECT_NE(label().find("747 of 768 pixels covered"), std::string::npos) << label();
    // A cell behind the wall shows nothing of itself; the eye's own cell shows everywhere.
    for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
        session.selected_cell = cell;
        bars = strip_of(session);
        const Vec<2> centre = session.cells().centre(cell);
        if (centre.x > 2.5 && std::abs(centre.y) < 0.2) {
            EXPECT_GT(bars["depth_hidden"], 0) << cell;
        }
    }
    session.selected_cell = locate(session.cells(), Vec<2>(0, 0));
    if (session.selected_cell != none) {
        EXPECT_EQ(strip_of(session)["depth_seen"], 192);
        EXPECT_NE(label().find("768 seen, 0 hidden"), std::string::npos) << label();
    }
}

}  // namespace
}  // namespace sightline
