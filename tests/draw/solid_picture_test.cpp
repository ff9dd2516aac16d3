// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/draw/cell_number.h"
#include "core/draw/palette.h"
#include "core/draw/picture_3d.h"
#include "core/draw/shown_cells.h"
#include "core/draw/solid_cells.h"
#include "core/draw/solid_palette.h"
#include "tests/session/session_3d_support.h"

namespace sightline {
namespace {

using namespace test;

std::uint8_t index_of_style(SolidLook look) { return static_cast<std::uint8_t>(look); }

DrawnAs asked_for(const Settings& s, CellState state) {
    return std::array{s.clean_as, s.enqueued_as, s.projected_as, s.unseen_as}[static_cast<std::size_t>(state)];
}

/// By the definitions: facets counted one by one, the plane from the words of the settings.
bool shall_show(const Session<3>& session, std::uint32_t cell) {
    const Settings& s = session.settings();
    if (s.only == OnlyCells::front && session.mark(cell).state != CellState::enqueued) return false;
    if (s.only == OnlyCells::around) {
        const std::uint32_t middle = session.selected_cell != none ? session.selected_cell : last_cell(session);
        std::set<std::uint32_t> reached;
        if (middle != none) reached.insert(middle);
        for (std::uint32_t ring = 0; ring < s.around; ++ring)
            for (const std::uint32_t from : std::set<std::uint32_t>(reached))
                for (const HalfFacet& half : session.cells().facets_of(from))
                    if (half.neighbour != none) reached.insert(half.neighbour);
        if (!reached.contains(cell)) return false;
    }
    const Box<3> box = bounds<3>(session.scene().primitives);
    if (s.slice == SliceAcross::off || box.empty()) return true;
    const Vec<3>& centre = session.cells().centre(cell);
    if (s.slice != SliceAcross::view) {
        const int axis = static_cast<int>(s.slice) - 1;
        return centre[axis] <= box.min[axis] + box.extent()[axis] * s.slice_at;
    }
    const View<3> view = picture_camera(session);
    std::vector<double> distances;
    for (const double x : {box.min.x, box.max.x})
        for (const double y : {box.min.y, box.max.y})
            for (const double z : {box.min.z, box.max.z})
                distances.push_back(std::max(0.0, glm::dot(Vec<3>(x, y, z) - view.eye, view.forward())));
    const auto [near, far] = std::minmax_element(distances.begin(), distances.end());
    return glm::dot(centre - view.eye, view.forward()) >= *near + (*far - *near) * s.slice_at;
}

TEST(SolidPicture, CellsAreDrawnAsTheSettingsSayOfTheirStates) {
    Random random(321);
    int outside = 0;
    for (int i = 0; i < 150; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        Settings settings = session.settings();
        randomise_picture(settings, random);
        settings.shrink = random.below(2) ? 1 : 0.6;
        session.change(settings);
        const SolidList list = make_solid(session);
        if (session.display_view() == session.culling_view()) {
            ASSERT_TRUE(list.face_style.empty() && list.edge_style.empty());
            continue;
        }
        ++outside;
        std::vector<CellPaint> paint(session.cells().cell_count());
        for (std::uint32_t cell = 0; cell < paint.size(); ++cell) {
            if (!shall_show(session, cell)) continue;
            const CellState state = session.mark(cell).state;
            const auto look =
                static_cast<std::uint8_t>(std::array{SolidLook::clean, SolidLook::enqueued, SolidLook::projected,
                                                     SolidLook::unseen}[static_cast<std::size_t>(state)]);
            paint[cell] = {asked_for(settings, state), look, look,
                           settings.show_tessellation == Switch::on ? index_of_style(SolidLook::border) : no_style};
        }
        SolidList expected;
        add_cells(session.cells(), paint, settings.shrink, expected);
        ASSERT_EQ(list.face_cell, expected.face_cell);
        ASSERT_EQ(list.face_style, expected.face_style);
        ASSERT_EQ(list.points, expected.points);
        ASSERT_EQ(list.edge_points, expected.edge_points);
        ASSERT_EQ(list.edge_style, expected.edge_style);
        for (const CellState state : {CellState::clean, CellState::enqueued, CellState::projected, CellState::unseen}) {
            const std::uint8_t style = std::array{index_of_style(SolidLook::clean), index_of_style(SolidLook::enqueued),
                                                  index_of_style(SolidLook::projected),
                                                  index_of_style(SolidLook::unseen)}[static_cast<std::size_t>(state)];
            ASSERT_EQ(list.styles[style].colour.a < 255, asked_for(settings, state) == DrawnAs::translucent);
        }
    }
    EXPECT_GT(outside, 80);
}

TEST(SolidPicture, WhatIsSlicedOffLeavesClosedBodies) {
    Random random(322);
    int drawn = 0;
    for (int i = 0; i < 150; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        Settings settings = session.settings();
        randomise_picture(settings, random);
        // One state in faces: no face is owned by another one.
        const auto state = static_cast<CellState>(random.below(4));
        for (DrawnAs* as : {&settings.clean_as, &settings.enqueued_as, &settings.projected_as, &settings.unseen_as})
            *as = random.below(2) ? DrawnAs::off : DrawnAs::wireframe;
        *std::array{&settings.clean_as, &settings.enqueued_as, &settings.projected_as,
                    &settings.unseen_as}[static_cast<std::size_t>(state)] = DrawnAs::solid;
        session.change(settings);
        if (session.display_view() == session.culling_view()) continue;
        const SolidList list = make_solid(session);
        // The divergence theorem: the volume that the faces enclose is that of the cells.
        double inside = 0, cells = 0;
        Vec<3> area(0);
        for (std::size_t face = 0; face < list.face_style.size(); ++face) {
            const Vec<3>* p = &list.points[list.face_begin[face]];
            const bool triangle = list.face_begin[face + 1] - list.face_begin[face] == 3;
            Vec<3> n = glm::cross(p[1] - p[0], p[2] - p[0]) * (triangle ? 0.5 : 1);  // the face's area
            if (glm::dot(n, p[0] - session.cells().centre(list.face_cell[face])) < 0) n = -n;
            inside += glm::dot(n, p[0]) / 3;
            area += n;
        }
        for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
            if (session.mark(cell).state != state || !shall_show(session, cell)) continue;
            std::vector<Vec<3>> p;
            for (const std::uint32_t corner : session.cells().corners_of(cell))
                p.push_back(session.cells().points[corner]);
            const Vec<3> e = p.back() - p.front();  // of a box: its diagonal
            cells += p.size() == 8 ? e.x * e.y * e.z : glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), e) / 6;
        }
        ASSERT_NEAR(inside, cells, 1e-9);
        ASSERT_NEAR(glm::length(area), 0, 1e-9);
        drawn += cells > 0;
    }
    EXPECT_GT(drawn, 30);
}

TEST(SolidPicture, TrianglesAreApartByWhatIsKnownOfThem) {
    Random random(323);
    std::map<std::string, int> seen;
    for (int i = 0; i < 150; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        Settings settings = session.settings();
        randomise_picture(settings, random);
        session.change(settings);
        const SolidList list = make_solid(session);
        std::vector<int> look(session.scene().primitives.size(), -1);
        std::set<std::uint8_t> styles;
        std::uint32_t next = 0;
        for (const SolidList::Run& run : list.runs) {
            ASSERT_TRUE(styles.insert(run.style).second);
            ASSERT_EQ(run.first, next);
            next += run.count;
            for (std::uint32_t k = 0; k < run.count; ++k) {
                int& own = look[list.triangles[run.first + k]];
                ASSERT_EQ(own, -1) << "drawn twice";
                own = run.style;
            }
        }
        ASSERT_EQ(next, list.triangles.size());
        std::set<std::uint32_t> before, all;
        for (std::uint32_t t = 0; t < session.counters().touched_count; ++t) {
            if (session.met()[t].culled()) continue;
            const std::uint32_t triangle = session.met()[t].primitive();
            all.insert(triangle);
            if (t < session.timeline().before(std::max(1u, session.position())).touched_count) before.insert(triangle);
        }
        const bool outside = session.display_view() != session.culling_view();
        const bool tell =
            settings.show_visibility == Switch::on && (outside || settings.triangles >= Triangles::visible);
        for (std::uint32_t p = 0; p < look.size(); ++p) {
            const bool visible = session.reference().visible[p], rendered = all.contains(p);
            const bool adds_missed = settings.triangles == Triangles::missed &&
                                     settings.show_visibility == Switch::on && (session.frozen() || session.finished());
            SolidLook expected = rendered ? SolidLook::plain : SolidLook::rest;
            if (tell && rendered) expected = visible ? SolidLook::rendered : SolidLook::wasted;
            if ((tell || adds_missed) && !rendered) expected = visible ? SolidLook::missed : SolidLook::other;
            if (rendered && !before.contains(p)) expected = SolidLook::fresh;
            const bool shown =
                settings.triangles == Triangles::all ||
                ((settings.triangles == Triangles::rendered || settings.triangles == Triangles::missed) && rendered) ||
                (adds_missed && visible) || (settings.triangles == Triangles::visible && visible);
            ASSERT_EQ(look[p], shown ? index_of_style(expected) : -1);
            if (shown) ++seen[list.styles[index_of_style(expected)].name];
        }
    }
    EXPECT_EQ(seen.size(), 7u);  // each kind was there
}

TEST(SolidPicture, TheOwnImageAsksForNoReference) {
    Random random(324);
    for (int i = 0; i < 20; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = start.session();
        session.fly(random_view_3d(random));
        const SolidList list = make_solid(session);
        make_picture(session);
        EXPECT_FALSE(session.has_reference());
        EXPECT_TRUE(session.flying());
        EXPECT_EQ(list.triangles.size(), session.counters().rendered_count);
        ASSERT_LE(list.runs.size(), 1u);
        if (!list.runs.empty()) {
            EXPECT_EQ(list.runs[0].style, index_of_style(SolidLook::plain));
        }
        EXPECT_TRUE(list.face_style.empty());
    }
}

TEST(SolidPicture, TheHeatOfACellIsThatOfItsNumber) {
    Random random(325);
    for (int i = 0; i < 80; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        Settings settings = session.settings();
        settings.heat = static_cast<CellNumber::Kind>(1 + random.below(6));
        for (DrawnAs* as : {&settings.clean_as, &settings.projected_as, &settings.enqueued_as, &settings.unseen_as})
            *as = static_cast<DrawnAs>(1 + random.below(3));
        settings.shrink = 0.9;
        session.change(settings);
        if (session.display_view() == session.culling_view()) continue;
        const auto numbers = cell_numbers(session, settings.heat);
        const auto range = number_range(session, settings.heat);
        const SolidList list = make_solid(session, {.heat_range = range});
        std::size_t wires = 0, wires_of_state = 0;
        for (const std::uint8_t style : list.edge_style) wires_of_state += style < index_of_style(SolidLook::border);
        std::map<std::uint32_t, std::uint8_t> heat;
        for (std::size_t face = 0; face < list.face_style.size(); ++face)
            heat[list.face_cell[face]] = list.face_style[face];
        for (std::uint32_t cell = 0; cell < numbers.size(); ++cell) {
            const DrawnAs as = asked_for(settings, session.mark(cell).state);
            wires += !numbers[cell] && as == DrawnAs::wireframe;
            ASSERT_EQ(heat.contains(cell), numbers[cell].has_value() && as != DrawnAs::wireframe);
            if (!heat.contains(cell)) continue;
            const auto [low, high] = *range;
            const double share = high > low ? (*numbers[cell] - low) / (high - low) : 0;
            const Colour expected = between(colours(settings.palette).heat, std::lround(share * 31) / 31.0);
            Colour colour = list.styles[heat[cell]].colour;
            ASSERT_EQ(colour.a < 255, as == DrawnAs::translucent);
            colour.a = 255;
            ASSERT_EQ(colour, expected);
        }
        ASSERT_EQ(wires_of_state, (session.cells().kind == Tessellation::tree ? 12 : 6) * wires);
    }
}

TEST(SolidPicture, AComparisonAddsWiresAndNothingElse) {
    Random random(326);
    std::array<int, 2> wires{};
    for (int i = 0; i < 30; ++i) {
        const Start3 start = random_start_3d(random);
        Session<3> session = random_frozen_session(random, start);
        Settings settings = session.settings();
        settings.shrink = i % 2 == 0 ? 0.5 : 1;
        settings.slice = i % 3 == 0 ? SliceAcross::x : SliceAcross::off;  // what is cut away is not marked
        settings.slice_at = 0.5;
        session.change(settings);
        std::vector<Differs> differences(session.cells().cell_count());
        for (Differs& differs : differences) differs = static_cast<Differs>(random.below(3));
        const SolidList alone = make_solid(session), list = make_solid(session, {.differences = differences});
        SolidList before = list;
        before.edge_style.resize(alone.edge_style.size());
        before.edge_points.resize(alone.edge_points.size());
        ASSERT_EQ(to_text(before), to_text(alone));
        if (session.display_view() == session.culling_view() || session.method().pops == Kind::node) {
            ASSERT_EQ(list.edge_style.size(), alone.edge_style.size());
            continue;
        }
        std::array<std::size_t, 2> edges{}, expected{};
        for (std::size_t edge = alone.edge_style.size(); edge < list.edge_style.size(); ++edge)
            ++edges[list.edge_style[edge] == index_of_style(SolidLook::only_there)];
        const auto shown = shown_cells(session, slice_of(session));
        for (std::uint32_t cell = 0; cell < differences.size(); ++cell)
            if (shown[cell] && differences[cell] != Differs::no)
                expected[differences[cell] == Differs::only_there] += edges_of(session.cells(), cell).size();
        const auto is = [&](std::uint32_t cell, Differs differs) {
            return cell != none && shown[cell] && differences[cell] == differs;
        };
        const auto edges_about = [&](Differs differs) {
            const CellComplex<3>& cells = session.cells();
            std::set<std::pair<std::uint32_t, std::uint32_t>> about;
            for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
                for (const HalfFacet& half : cells.facets_of(cell)) {
                    if (!is(cell, differs) || is(half.neighbour, differs) || cells.is_contact(half.facet())) continue;
                    const auto polygon = cells.points_of_facet(half.facet());
                    for (std::size_t k = 0; k < polygon.size(); ++k)
                        about.insert(std::minmax({polygon[k], polygon[(k + 1) % polygon.size()]}));
                }
            return about.size();
        };
        if (session.settings().shrink == 1)
            expected = {edges_about(Differs::only_here), edges_about(Differs::only_there)};
        for (std::size_t which = 0; which < 2; ++which) {
            ASSERT_EQ(edges[which], expected[which]);
            wires[which] += edges[which] > 0;
        }
    }
    EXPECT_GT(wires[0], 5);
    EXPECT_GT(wires[1], 5);
}

}  // namespace
}  // namespace sightline
