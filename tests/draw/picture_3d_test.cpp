// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/picture_3d.h"
#include "core/draw/choice.h"
#include "core/session/settings_table.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/base/number.h"
#include "core/draw/cell_number.h"
#include "core/draw/compose.h"
#include "core/draw/projection.h"
#include "core/draw/shown_cells.h"
#include "core/draw/solid_palette.h"
#include "core/methods/cells/facet_geometry.h"
#include "core/methods/cells/star_shape.h"
#include "core/session/explain.h"
#include "tests/draw/picture_3d_goldens.h"
#include "tests/draw/picture_support.h"
#include "tests/session/session_3d_support.h"

namespace sightline {
namespace {

using namespace test;

/// Lines and marks of one style.
std::vector<std::vector<Vec<2>>> shapes_of(const DrawList& list, std::string_view style) {
    std::vector<std::vector<Vec<2>>> found;
    for (const Shape& shape : list.shapes)
        if (list.styles[shape.style].name == style)
            found.emplace_back(list.points.begin() + shape.first_point,
                               list.points.begin() + shape.first_point + shape.point_count);
    return found;
}

void set_all(Session<3>& session, std::initializer_list<const char*> assignments) {
    Settings settings = session.settings();
    for (const char* assignment : assignments) apply_setting(settings, assignment);
    session.change(settings);
}

std::size_t edges_per_cell(const Session<3>& session) { return session.cells().kind == Tessellation::tree ? 12 : 6; }

/// From where the whole of the cells is seen.
ViewSpec<3> from_afar(const Session<3>& session) {
    Box<3> box;
    for (const Vec<3>& p : session.cells().points) box.add(p);
    return {box.centre() + Vec<3>(3, -4, 2) * box.longest_side(), box.centre(), 40};
}

std::string hash_of(const std::string& text) {
    Hash hash;
    for (const char c : text) hash.add(static_cast<unsigned char>(c));
    return hash_text(hash.value());
}

/// Goldens, the hash of the solids and that of the lines. After a wanted change the failure prints the new table.
const Goldens& goldens = test::picture_3d_goldens;

TEST(Picture3, IsThatOfTheGoldens) {
    Random random(330);
    std::string table;
    bool same = goldens.size() == 4;
    for (std::size_t i = 0; i < 4; ++i) {
        Start3 start = random_start_3d(random);
        start.settings.budget = {};
        Session<3> session = start.session();
        session.seek(6);
        std::vector<std::string> now;
        const auto add = [&] {
            const PictureOptions3 options{number_range(session, session.settings().heat)};
            now.push_back(hash_of(to_text(make_solid(session, options))));
            now.push_back(hash_of(to_text(make_picture(session, options))));
        };
        add();
        session.freeze();
        session.set_view(from_afar(session));
        add();
        session.run();
        set_all(session, {"show_normals=on", "show_penalties=on", "show_chain=on", "label=solidity", "label_where=all",
                          "palette=paper", "unseen_as=translucent", "slice=z", "shrink=0.8", "triangles=all"});
        session.selected_cell = session.cells().cell_count() / 2;
        session.selected_primitive = 0;
        add();
        table += "        {";
        for (std::size_t k = 0; k < now.size(); ++k) {
            table += (k ? ", \"" : "\"") + now[k] + "\"";
            same = same && now[k] == goldens[i][k];
        }
        table += "},\n";
    }
    EXPECT_TRUE(same) << "the pictures are now\n" << table;
}

TEST(Picture3, EverythingIsFiniteAndNearThePicture) {
    Random random(331);
    for (int i = 0; i < 150; ++i) {
        Start3 start = random_start_3d(random);
        if (i % 3 == 1) start.settings.tessellation = Tessellation::kd;
        if (i % 2 == 1) start.settings.neighbours = Neighbours::touching;
        Session<3> session = random_frozen_session(random, start);
        set_all(session, {"show_normals=on", "show_penalties=on", "show_chain=on", "label=count", "label_where=all"});
        const double aspect = random.uniform(0.3, 4);
        const DrawList list = make_picture(session, {.aspect = aspect, .facet = 0});
        ASSERT_EQ(list.world.min, Vec<2>(0, 0));
        ASSERT_NEAR(list.world.max.x, aspect, 1e-9);
        ASSERT_EQ(list.world.max.y, 1);
        for (const Shape& shape : list.shapes) {
            ASSERT_LT(shape.style, list.styles.size());
            ASSERT_LE(shape.first_point + shape.point_count, list.points.size());
        }
        for (const Vec<2>& p : list.points) {
            ASSERT_TRUE(is_finite(p));
            ASSERT_TRUE(p.x > -0.6 && p.y > -0.6 && p.x < aspect + 0.6 && p.y < 1.6);
        }
        for (const Label& label : list.labels) ASSERT_TRUE(list.world.contains(label.at));
    }
}

TEST(Picture3, ConeEyeAndSeedAreDrawnFromOutsideOnly) {
    Random random(332);
    for (int i = 0; i < 60; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = start.session();
        session.seek(5);
        for (const bool frozen : {false, true}) {
            if (frozen) session.freeze();
            const DrawList own = make_picture(session);
            EXPECT_TRUE(shapes_of(own, "view").empty() && shapes_of(own, "eye").empty() &&
                        shapes_of(own, "seed").empty());
        }
        session.set_view(from_afar(session));
        const DrawList list = make_picture(session);
        EXPECT_EQ(shapes_of(list, "seed").size(), edges_per_cell(session));
        // The disc stands where the eye is, and the four lines of the cone start there.
        const View<3> camera = picture_camera(session);
        const Vec<2> eye = *project(camera, session.culling_view().eye);
        const auto marks = shapes_of(list, "eye");
        ASSERT_EQ(std::count(marks.begin(), marks.end(), std::vector{eye}), list.world.contains(eye));
        std::size_t from_eye = 0;
        for (const auto& line : shapes_of(list, "view")) from_eye += glm::length(line[0] - eye) < 1e-9;
        if (list.world.contains(eye)) {
            EXPECT_EQ(from_eye, 4u);
        }
        set_all(session, {"show_view=off"});
        const DrawList off = make_picture(session);
        EXPECT_TRUE(shapes_of(off, "view").empty() && shapes_of(off, "eye").empty() && shapes_of(off, "seed").empty());
    }
}

TEST(Picture3, APictureOfAnotherShapeShowsWhereTheViewEnds) {
    Random random(340);
    for (int i = 0; i < 40; ++i) {
        const Start3 start = random_start_3d(random);
        const Session<3> session = start.session();
        const DrawList wide = make_picture(session, {.aspect = 2});
        const auto lines = shapes_of(wide, "view");
        ASSERT_EQ(lines.size(), 4u);
        Box<2> border;
        for (const auto& line : lines)
            for (const Vec<2>& p : line) border.add(p);
        EXPECT_NEAR(glm::length(border.min - Vec<2>(1.0 / 3, 0)), 0, 1e-9);  // 4:3 in the middle of 2:1
        EXPECT_NEAR(glm::length(border.max - Vec<2>(5.0 / 3, 1)), 0, 1e-9);
        EXPECT_TRUE(shapes_of(make_picture(session, {.aspect = 4.0 / 3}), "view").empty());
    }
}

TEST(Picture3, TheConeIsThatOfTheCullingView) {
    Random random(333);
    for (int i = 0; i < 60; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = start.session();
        session.freeze();
        session.set_view(from_afar(session));
        // Every end of a line lies on a ray through a corner of the culling view.
        const View<3> camera = picture_camera(session), &culling = session.problem().view;
        for (const auto& line : shapes_of(make_picture(session), "view"))
            for (const Vec<2>& p : line) {
                if (p.x < -0.49 || p.y < -0.49 || p.x > picture_plane(camera).max.x + 0.49 || p.y > 1.49)
                    continue;  // cut
                double nearest = 1;
                for (const Vec<3>& corner : culling.corners) {
                    const auto shown = project_line(camera, culling.eye, culling.eye + (corner - culling.eye) * 100.0);
                    if (!shown) continue;
                    const Vec<2> along = shown->b - shown->a;
                    const double t = std::clamp(glm::dot(p - shown->a, along) / glm::dot(along, along), 0.0, 1.0);
                    nearest = std::min(nearest, glm::length(shown->a + along * t - p));
                }
                ASSERT_LT(nearest, 1e-6);
            }
    }
}

TEST(Picture3, LastAndSelectedAreOutlinedWhereTheyAre) {
    Random random(334);
    for (int i = 0; i < 80; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        session.freeze();
        session.set_view(from_afar(session));
        if (random.below(2)) set_all(session, {"shrink=0.5"});
        const double shrink = session.settings().shrink;
        const DrawList list = make_picture(session);
        const View<3> camera = picture_camera(session);
        const auto near = [](const Vec<2>& a, const Vec<2>& b) { return glm::length(a - b) < 1e-9; };
        const auto check = [&](std::uint32_t cell, const char* style) {
            const auto lines = shapes_of(list, style);
            ASSERT_EQ(lines.size(), cell == none ? 0u : edges_per_cell(session));
            if (cell == none) return;
            for (const std::uint32_t corner : session.cells().corners_of(cell)) {
                const Vec<3>& centre = session.cells().centre(cell);
                const Vec<2> at = *project(camera, centre + (session.cells().points[corner] - centre) * shrink);
                int meeting = 0;
                for (const auto& line : lines) meeting += near(line[0], at) + near(line[1], at);
                ASSERT_EQ(meeting, 3);
            }
        };
        check(last_cell(session), "last");
        check(session.selected_cell, "selected");
        const auto lines = shapes_of(list, "selected_primitive");
        ASSERT_EQ(lines.size(), session.selected_primitive == none ? 0u : 3u);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const Primitive<3>& t = session.scene().primitives[session.selected_primitive];
            ASSERT_TRUE(near(lines[k][0], *project(camera, t[k])) &&
                        near(lines[k][1], *project(camera, t[(k + 1) % 3])));
        }
    }
}

/// Whether p, a point of its plane, lies in a convex facet.
bool in_facet(const CellComplex<3>& cells, std::uint32_t facet, const Vec<3>& p) {
    const auto polygon = cells.points_of_facet(facet);
    const auto at = [&](std::size_t i) { return cells.points[polygon[i % polygon.size()]]; };
    const Vec<3> n = glm::cross(at(1) - at(0), at(2) - at(0));
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (glm::dot(n, glm::cross(at(i + 1) - at(i), p - at(i))) < 0) return false;
    return true;
}

TEST(Picture3, TheStarTestIsShownAsItWasMade) {
    Random random(335);
    int passed = 0, failed = 0, beside = 0;
    for (int i = 0; i < 300; ++i) {
        Start3 start = random_start_3d(random);
        apply_setting(start.settings, "star_shaped=on");
        start.settings.method = "published";
        if (start.settings.parameters.text(penalty_row()) == "none") apply_setting(start.settings, "penalty=multiply");
        Session<3> session = start.session();
        session.seek(static_cast<std::uint32_t>(1 + random.below(30)));
        session.selected_cell = static_cast<std::uint32_t>(random.below(session.cells().cell_count()));
        session.freeze();
        session.set_view(from_afar(session));
        set_all(session, {"show_penalties=on"});
        const DrawList list = make_picture(session);
        const View<3> camera = picture_camera(session);
        const std::uint32_t cell = session.selected_cell;
        const std::vector<ChainLink> chain = explain_cell(session, cell).chain;
        const auto rays = shapes_of(list, "star_ray");
        if (chain.empty()) {
            ASSERT_TRUE(rays.empty());
            continue;
        }
        const Considered& update = chain.back().update;
        ASSERT_EQ(shapes_of(list, "star_facet").size(), session.cells().points_of_facet(update.via.id).size());
        const Vec<3>&eye = session.culling_view().eye, &centre = session.cells().centre(cell);
        ASSERT_FALSE(rays.empty());
        ASSERT_EQ(rays[0].size(), 2u);
        ASSERT_NEAR(glm::length(rays[0][1] - *project(camera, centre)), 0, 1e-9);
        const auto words = update.key->penalised ? update.key->penalty : std::string("star-shaped: no penalty");
        const auto label =
            std::find_if(list.labels.begin(), list.labels.end(), [&](const Label& own) { return own.text == words; });
        // Where the ray meets the plane of the facet decides, so the mark stands inside the facet or beside it.
        const Vec<3> on_facet = session.cells().points[session.cells().points_of_facet(update.via.id)[0]];
        const auto facets = session.cells().facets_of(update.from.id);
        const HalfFacet half =
            *std::find_if(facets.begin(), facets.end(), [&](const HalfFacet& h) { return h.facet() == update.via.id; });
        const Vec<3> n = facet_geometry(session.cells(), half).normal;
        const double share = glm::dot(n, on_facet - eye) / glm::dot(n, centre - eye);
        const bool crosses = share >= 0 && share <= 1;
        const Vec<3> crossing = eye + (centre - eye) * share;
        if (!update.key->penalised) {
            ++passed;
            ASSERT_TRUE(crosses && in_facet(session.cells(), update.via.id, crossing));
        } else {
            ++failed;
            beside += crosses;
            ASSERT_FALSE(crosses && in_facet(session.cells(), update.via.id, crossing) &&
                         facet_side(session.cells(), half, eye) > 0);
        }
        if (!crosses) continue;
        const Vec<2> at = *project(camera, crossing);
        const auto marks = shapes_of(list, !update.key->penalised ? "star_ray" : "penalty");
        ASSERT_EQ(list.world.contains(at), std::any_of(marks.begin(), marks.end(), [&](const auto& points) {
                      return points.size() == 1 && glm::length(points[0] - at) < 1e-9;
                  }));
        ASSERT_EQ(list.world.contains(at), label != list.labels.end());
    }
    EXPECT_GT(passed, 10);
    EXPECT_GT(failed, 10);
    EXPECT_GT(beside, 10);
}

TEST(Picture3, NumbersStandOnTheShownCellsTheNearestFirst) {
    Random random(336);
    for (int i = 0; i < 100; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        Settings settings = session.settings();
        randomise_picture(settings, random);
        settings.label = static_cast<CellNumber::Kind>(1 + random.below(6));
        settings.label_where = static_cast<LabelWhere>(random.below(3));
        session.change(settings);
        const DrawList list = make_picture(session);
        const View<3> camera = picture_camera(session);
        const auto numbers = cell_numbers(session, settings.label);
        const Choice choice = settings.show_choice == Switch::on ? choice_of(session) : Choice{};
        const auto shown = shown_cells(session, slice_of(session));
        std::multimap<double, std::string> by_depth;
        std::multiset<std::string> first, expected;
        for (std::uint32_t cell = 0; cell < numbers.size(); ++cell) {
            const bool must = cell == first_in_front(session) || cell == last_cell(session) || cell == choice.next ||
                              cell == session.selected_cell;
            const bool front = session.mark(cell).state == CellState::enqueued;
            const bool asked = settings.label_where == LabelWhere::all || cell == session.selected_cell ||
                               (settings.label_where == LabelWhere::front && (front || cell == last_cell(session)));
            const auto at = project(camera, session.cells().centre(cell));
            if (!numbers[cell] || !asked || !(must || shown[cell]) || !at || !list.world.contains(*at)) continue;
            const std::string text = cell_label(session, choice, cell, *numbers[cell]);
            expected.insert(text);
            if (must) first.insert(text);
        }
        std::multiset<std::string> found;
        double depth_before = 0;
        for (std::size_t k = 0; k < list.labels.size(); ++k) {
            const Label& label = list.labels[k];
            found.insert(label.text);
            ASSERT_EQ(label.yields, k >= first.size());
            ASSERT_GT(label.room, 0);
            ASSERT_LT(label.room, 100);
            double depth_here = -1;
            for (std::uint32_t cell = 0; cell < numbers.size(); ++cell)
                if (project(camera, session.cells().centre(cell)) == label.at)
                    depth_here = depth(camera, session.cells().centre(cell));
            ASSERT_GE(depth_here, 0);
            if (k > first.size()) {
                ASSERT_GE(depth_here, depth_before - 1e-9);
            }
            depth_before = depth_here;
        }
        if (expected.size() <= 1000) {
            ASSERT_EQ(found, expected);
        }
    }
}

TEST(Picture3, ShowingSomethingElseMovesNothing) {
    Random random(337);
    for (int i = 0; i < 12; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        session.seek(session.position() / 2);
        const std::uint64_t hash = session.hash();
        const std::uint32_t recorded = session.recorded(), position = session.position();
        for (const SettingRow& row : settings_table()) {
            if (row.invalidates != Invalidates::picture) continue;
            std::vector<std::string> values(row.words.begin(), row.words.end());
            if (row.name == "shrink" || row.name == "slice_at") values = {"0.5"};
            if (row.name == "around") values = {"0", "3"};
            for (const std::string& value : values) {
                Settings settings = session.settings();
                row.set(settings, value);
                session.change(settings);
                make_figure(std::array{PanelSource{session, ""}});
                ASSERT_EQ(session.hash(), hash) << row.name;
                ASSERT_EQ(session.recorded(), recorded) << row.name;
                ASSERT_EQ(session.position(), position) << row.name;
            }
        }
    }
}

TEST(Picture3, TheLegendHasARowForEachStyleInSightAndNoOther) {
    Random random(338);
    std::set<std::string> ever;
    for (int i = 0; i < 120; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        Settings settings = session.settings();
        randomise_picture(settings, random);
        settings.slice = SliceAcross::off;  // a triangle may be cut off
        session.change(settings);
        if (random.below(2)) set_all(session, {"show_normals=on", "show_penalties=on", "show_chain=on"});
        session.freeze();
        session.set_view(from_afar(session));  // all of it is in sight
        const Figure figure = make_figure(std::array{PanelSource{session, ""}});
        ASSERT_EQ(figure.panels.size(), 1u);
        const DrawList& list = figure.panels[0].list;
        const SolidList& solid = *figure.panels[0].solid;
        std::set<std::string> used, rows;
        const auto use = [&](std::uint8_t style) {
            if (solid.styles[style].name != "border") used.insert(solid.styles[style].name);
        };
        for (const std::uint8_t style : solid.face_style) use(style);
        for (const std::uint8_t style : solid.edge_style) use(style);
        for (const SolidList::Run& run : solid.runs) use(run.style);
        for (const Shape& shape : list.shapes) {
            Box<2> box;
            for (std::uint32_t k = 0; k < shape.point_count; ++k) box.add(list.points[shape.first_point + k]);
            const bool in_sight = box.min.x <= list.world.max.x && box.max.x >= 0 && box.min.y <= 1 && box.max.y >= 0;
            const std::string& name = list.styles[shape.style].name;
            if (in_sight && !name.starts_with("rim")) used.insert(name);
        }
        for (const LegendRow& row : figure.legend) {
            EXPECT_TRUE(rows.insert(row.style.name).second) << row.text << " twice";
            EXPECT_FALSE(row.text.empty());
        }
        ASSERT_EQ(rows, used);
        ever.insert(used.begin(), used.end());
        // Looking away, nothing of the cells is listed.
        ViewSpec<3> away = session.display_view();
        away.look_at = away.eye * 2.0 - away.look_at;
        session.set_view(away);
        for (const LegendRow& row : make_figure(std::array{PanelSource{session, ""}}).legend)
            ADD_FAILURE() << row.text << " is not in the picture";
    }
    for (const char* name : {"clean",    "enqueued",  "projected", "unseen", "plain",   "rest",  "rendered",
                             "missed",   "wasted",    "other",     "fresh",  "view",    "eye",   "seed",
                             "last",     "selected",  "eye_ray",   "normal", "penalty", "chain", "selected_primitive",
                             "star_ray", "star_facet"})
        EXPECT_TRUE(ever.contains(name)) << name << " was never tried";
}

TEST(Picture3, FiguresAndFilmsShareScaleAndLegend) {
    Random random(339);
    Start3 start = random_start_3d(random);
    while (start.scene->primitives.size() < 30) start = random_start_3d(random);
    start.settings.budget = {};
    Session<3> session = start.session();
    session.run();
    session.freeze();
    session.set_view(from_afar(session));
    set_all(session, {"heat=order", "enqueued_as=off"});
    Note<3> note;
    note.kind = Note<3>::Kind::callout;
    note.number = 1;
    note.text = "in one frame";
    note.point = session.cells().centre(0);
    note.first_step = note.last_step = 4;
    session.notes.push_back(note);
    note.number = 2;
    note.text = "behind the eye of the picture";
    note.point = session.display_view().eye * 2.0 - session.display_view().look_at;
    session.notes.push_back(note);
    std::vector<PanelSource<3>> sources;
    for (const std::uint32_t step : {2u, 4u, 6u}) {
        sources.push_back({session, "step " + std::to_string(step)});
        sources.back().session.seek(step);
    }
    const Figure figure = make_figure(sources);
    const Film made = make_film<3>(3, [&](std::size_t i) { return std::span(&sources[i], 1); });
    const std::vector<Figure> film{made.page(0), made.page(1), made.page(2)};
    ASSERT_EQ(figure.panels.size(), 3u);
    ASSERT_EQ(film.size(), 3u);
    ASSERT_TRUE(figure.bar);
    EXPECT_EQ(figure.bar->low, "1");
    EXPECT_EQ(figure.bar->high, std::to_string(session.recorded()));
    EXPECT_EQ(figure.panels[1].title, "(b) step 4");
    EXPECT_NE(figure.caption.find("Reference: item buffer 40x30"), std::string::npos) << figure.caption;
    EXPECT_NE(figure.caption.find(" triangles"), std::string::npos);
    for (std::size_t i = 0; i < 3; ++i) {
        const PictureOptions3 options{number_range(session, CellNumber::order)};
        for (const Figure::Panel* panel : {&figure.panels[i], &film[i].panels[0]}) {
            EXPECT_EQ(to_text(panel->list), to_text(make_picture(sources[i].session, options)));
            EXPECT_EQ(to_text(*panel->solid), to_text(make_solid(sources[i].session, options)));
            const auto& labels = panel->list.labels;
            EXPECT_EQ(std::count_if(labels.begin(), labels.end(), [](const Label& l) { return l.text == "1"; }),
                      i == 1);
        }
        std::set<std::string> texts;
        for (const LegendRow& row : film[i].legend) texts.insert(row.text);
        EXPECT_TRUE(texts.contains("1: in one frame"));
        EXPECT_FALSE(texts.contains("2: behind the eye of the picture"));
        EXPECT_TRUE(texts.contains("border of the view"));
    }
}

TEST(Picture3, AnEmptySceneHasAPicture) {
    Session<3> session(std::make_shared<const Scene<3>>(), {{0, 0, 0}, {1, 0, 0}, 60}, {}, method_table<3>(),
                       cast_rays);
    session.freeze();
    session.set_view({{5, 5, 5}, {0, 0, 0}, 60});
    set_all(session, {"slice=view", "clean_as=solid", "triangles=all"});
    EXPECT_NO_THROW(make_figure(std::array{PanelSource{session, ""}}));
}

}  // namespace
}  // namespace sightline
