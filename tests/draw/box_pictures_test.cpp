// Pictures of methods that decide by planes: boxes by state, occluders, planes, and the regions of figure 4a.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/base/random.h"
#include "core/draw/box_palette.h"
#include "core/draw/legend.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/draw/picture_3d.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_planes.h"
#include "core/scene/make/catalogue.h"
#include "core/space/box_tree.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"

namespace sightline {
namespace {

using namespace test;

Scene<2> scene_of(const CatalogueRow<2>& row) { return make_scene(row); }
Scene<3> scene_of(const CatalogueRow<3>& row) { return make_scene(row, fewest_triangles(row)); }

template <int D>
Session<D> session_on(const char* scene, const char* method, std::initializer_list<const char*> assignments = {}) {
    const CatalogueRow<D>& row = *find_in_catalogue<D>(scene);
    Settings settings;
    settings.error_bound = row.error_bound;
    settings.budget = {};
    settings.method = method;
    for (const char* assignment : assignments) apply_setting(settings, assignment);
    return {std::make_shared<const Scene<D>>(scene_of(row)), row.view, settings};
}

std::string hash_of_text(const std::string& text) {
    Hash hash;
    for (const char c : text) hash.add(static_cast<unsigned char>(c));
    return hash_text(hash.value());
}

template <int D>
std::vector<ShownBox<D>> boxes_in(const Session<D>& session, CellState state) {
    std::vector<ShownBox<D>> found = shown_boxes(session);
    std::erase_if(found, [&](const ShownBox<D>& shown) { return shown.state != state; });
    return found;
}

std::size_t count_of(const DrawList& list, std::string_view name) {
    return static_cast<std::size_t>(std::count_if(list.shapes.begin(), list.shapes.end(),
                                                  [&](const Shape& s) { return list.styles[s.style].name == name; }));
}

/// Goldens: the plan in the middle and at the end, the town from above with a box and a plane selected.
constexpr std::array plane_goldens{"3ee9311d7cc48865", "75f84aedce1203c5", "14ee30d10cd41f8c", "06c8eb8ce3a4c135"};

TEST(BoxPictures, AreThoseOfTheGoldens) {
    std::array<std::string, 4> now;
    Session<2> plan = session_on<2>("wall2", "coorg-teller");
    plan.seek(25);
    now[0] = hash_of_text(to_text(make_picture(plan)));
    plan.run();
    Settings settings = plan.settings();
    apply_setting(settings, "palette=paper");
    plan.change(settings);
    plan.selected_node = boxes_in(plan, CellState::hidden).front().node;
    plan.selected_plane = 1;
    now[1] = hash_of_text(to_text(make_picture(plan)));
    Session<3> wall = session_on<3>("wall2", "coorg-teller", {"unseen_as=wireframe", "show_visibility=off"});
    wall.run();
    wall.freeze();
    wall.set_view({{0, -25, 16}, {20, 10, 0}, 60});
    wall.selected_node = boxes_in(wall, CellState::hidden).front().node;
    now[2] = hash_of_text(to_text(make_solid(wall)));
    now[3] = hash_of_text(to_text(make_picture(wall)));
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_EQ(now[i], plane_goldens[i]) << i;
}

TEST(BoxPictures, EachBoxLooksAsItsState) {
    for (const char* method : {"coorg-teller", "coorg-teller connected=on", "shadow-frusta"})
        for (const std::uint32_t step : {0u, 7u, 30u, 1000u}) {
            Session<2> session = session_on<2>("wall2", method);
            session.seek(step);
            const DrawList list = make_picture(session);
            const auto count_in = [&](CellState state) { return boxes_in(session, state).size(); };
            EXPECT_EQ(count_of(list, "invisible"), count_in(CellState::hidden));
            EXPECT_EQ(count_of(list, "shown"), count_in(CellState::projected));
            EXPECT_EQ(count_of(list, "outside"), count_in(CellState::unseen));
            EXPECT_EQ(count_of(list, "enqueued"), count_in(CellState::enqueued));
            EXPECT_EQ(count_of(list, "projected") + count_of(list, "hidden") + count_of(list, "unseen"), 0u);
            EXPECT_EQ(count_of(list, "eye_leaf"), 1u);
            EXPECT_EQ(count_of(list, "last_box"), session.position() > 0);
            std::size_t actual = 0, potential = 0;
            for (const OccluderFact& occluder : session.traversal().occluders())
                (occluder.actual ? actual : potential) += occluder.primitives.size();
            EXPECT_GT(actual, 0u);
            EXPECT_EQ(count_of(list, "actual"), actual);
            EXPECT_EQ(count_of(list, "potential"), potential);
        }
}

TEST(BoxPictures, TheLeafWithTheEyeHoldsIt) {
    Random random(801);
    Session<2> session = session_on<2>("rooms", "coorg-teller");
    const Box<2> around = *session.traversal().eye_box();
    EXPECT_TRUE(around.contains(session.culling_view().eye));
    for (int i = 0; i < 50; ++i) {
        const Vec<2> eye{random.uniform(around.min.x - 1, around.max.x + 1),
                         random.uniform(around.min.y - 1, around.max.y + 1)};
        session.set_culling_view({eye, eye + Vec<2>(1, 0), 90});
        ASSERT_TRUE(session.traversal().eye_box()->contains(eye));
    }
    session.set_culling_view({{1e6, 1e6}, {0, 0}, 90});
    EXPECT_FALSE(session.traversal().eye_box());
}

/// On one of the lines, as near as rounding makes it.
bool is_near(const std::vector<TestedPlane<2>>& planes, const Vec<2>& p) {
    return std::any_of(planes.begin(), planes.end(), [&](const TestedPlane<2>& plane) {
        const Vec<2> along = plane.points[1] - plane.points[0];
        return std::abs(cross(along, p - plane.points[0])) <= 1e-3 * std::sqrt(glm::dot(along, along));
    });
}

bool is_inside(const std::vector<Vec<2>>& polygon, const Vec<2>& p) {
    if (polygon.size() < 3) return false;
    int left = 0, right = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double side = cross(polygon[(i + 1) % polygon.size()] - polygon[i], p - polygon[i]);
        left += side > 0;
        right += side < 0;
    }
    return left == 0 || right == 0;
}

/// What the shaded regions promise of an eye is what the method finds when the eye is there.
TEST(BoxPictures, AnEyeInARegionSeesWhatTheRegionSays) {
    Random random(802);
    Session<2> session = session_on<2>("wall2", "coorg-teller", {"occluder_count=1024", "threshold=1e-6"});
    session.run();
    Box<2> world;
    for (const Primitive<2>& s : session.scene().primitives)
        for (const Vec<2>& p : s) world.add(p);
    const ViewSpec<2> from = session.culling_view();
    std::array<int, 4> seen{};
    for (int i = 0; i < 60; ++i) {
        const auto boxes = shown_boxes(session);
        const std::uint32_t node = boxes[random.below(boxes.size())].node;
        const Item box{node, Kind::node};
        const auto primitive = static_cast<std::uint32_t>(random.below(2));  // one of the two walls
        const std::vector<TestedPlane<2>> planes = session.traversal().tested_planes(box, primitive);
        const EyeRegions regions = eye_regions(planes, from.eye, world);
        if (regions.partial.empty()) continue;
        Session<2> other = session;
        for (int k = 0; k < 20; ++k) {
            const Vec<2> eye{random.uniform(world.min.x, world.max.x), random.uniform(world.min.y, world.max.y)};
            const TestedPlane<2>& own = planes.front();
            const auto side = [&](const Vec<2>& p) { return cross(own.points[1] - own.points[0], p - own.points[0]); };
            if (is_near(planes, eye) || side(eye) * side(from.eye) <= 0) continue;
            other.set_culling_view({eye, eye + Vec<2>(0, 1), 360});
            const std::vector<TestedPlane<2>> there = other.traversal().tested_planes(box, primitive);
            if (there.empty()) continue;  // nearly edge-on: others are larger
            int region = 3;
            for (const TestedPlane<2>& plane : there)
                if (!plane.satisfied) region = std::min(region, plane.kind == PlaneKind::separating ? 1 : 2);
            const int promised = is_inside(regions.hidden, eye) ? 3 : is_inside(regions.partial, eye) ? 2 : 1;
            ASSERT_EQ(promised, region) << "node " << node << ", segment " << primitive;
            ++seen[static_cast<std::size_t>(region)];
        }
    }
    EXPECT_GT(seen[1], 20);
    EXPECT_GT(seen[2], 20);
    EXPECT_GT(seen[3], 20);
}

TEST(BoxPictures, PlanesAreOfTheSelectedBoxAndOccluder) {
    Session<2> session = session_on<2>("wall2", "coorg-teller");
    session.run();
    const std::uint32_t hidden = boxes_in(session, CellState::hidden).front().node;
    EXPECT_EQ(box_at_hand(session), last_node(session));
    session.selected_node = hidden;
    EXPECT_EQ(box_at_hand(session), hidden);
    for (const TestedPlane<2>& plane : planes_at_hand(session)) EXPECT_TRUE(plane.satisfied);
    EXPECT_GT(count_of(make_picture(session), "supporting"), 0u);
    EXPECT_EQ(count_of(make_picture(session), "supporting_fails"), 0u);
    EXPECT_EQ(count_of(make_picture(session), "region"), 0u);
    session.selected_plane = 0;
    EXPECT_EQ(count_of(make_picture(session), "lit"), 1u);
    // Another occluder, which hides nothing of the box; from where it is one is shown too.
    const auto idle = [](const TestedOccluder& occluder) { return occluder.region == 1; };
    for (const ShownBox<2>& shown : boxes_in(session, CellState::projected)) {
        const auto tested = session.traversal().tested_occluders({shown.node, Kind::node});
        const auto found = std::find_if(tested.begin(), tested.end(), idle);
        if (found == tested.end()) continue;
        session.selected_node = shown.node;
        session.selected_primitive = found->primitives.front();
    }
    ASSERT_NE(session.selected_primitive, none);
    ASSERT_EQ(box_at_hand(session), session.selected_node);
    const auto planes = planes_at_hand(session);
    EXPECT_TRUE(std::any_of(planes.begin(), planes.end(), [](const auto& plane) { return !plane.satisfied; }));
    EXPECT_GT(count_of(make_picture(session), "region"), 0u);
    EXPECT_EQ(count_of(make_picture(session), "region_box"), 1u);
    // What is no occluder is in a box.
    std::uint32_t primitive = 0;
    while (is_of_occluder(session, primitive, true)) ++primitive;
    session.selected_node = none;
    session.selected_primitive = primitive;
    const auto in_box = session.traversal().boxes()->primitives_of(box_at_hand(session));
    EXPECT_NE(std::find(in_box.begin(), in_box.end(), primitive), in_box.end());
    // Switched off, nothing of it is drawn.
    Settings settings = session.settings();
    apply_setting(settings, "show_planes=off");
    session.change(settings);
    for (const char* name :
         {"supporting", "supporting_fails", "separating", "separating_fails", "own", "region", "lit"})
        EXPECT_EQ(count_of(make_picture(session), name), 0u) << name;
}

TEST(BoxPictures, AnotherTreeForgetsTheSelectedBox) {
    Session<2> session = session_on<2>("wall2", "coorg-teller");
    session.run();
    session.selected_node = 3;
    session.set_culling_view({session.culling_view().eye + Vec<2>(0.1, 0), session.culling_view().look_at, 90});
    EXPECT_EQ(session.selected_node, 3u);
    Settings settings = session.settings();
    apply_setting(settings, "leaf=64");
    session.change(settings);
    EXPECT_EQ(session.selected_node, none);
}

TEST(BoxPictures, APieceOfAPlaneHoldsItsEdgeAndItsCorner) {
    Session<3> session = session_on<3>("wall2", "coorg-teller");
    session.run();
    std::size_t pieces = 0;
    for (const ShownBox<3>& shown : shown_boxes(session))
        for (const TestedPlane<3>& plane : session.traversal().tested_planes({shown.node, Kind::node}, none)) {
            if (plane.kind == PlaneKind::own) continue;
            const auto piece = piece_of(plane, session.culling_view().eye);
            const Vec<3> normal = glm::cross(piece[1] - piece[0], piece[3] - piece[0]);
            const double size = std::sqrt(glm::dot(normal, normal));
            ASSERT_GT(size, 0);
            for (const auto& points : {std::vector<Vec<3>>(piece.begin(), piece.end()),
                                       std::vector<Vec<3>>(plane.points.begin(), plane.points.end())})
                for (const Vec<3>& p : points) ASSERT_NEAR(glm::dot(normal, p - piece[0]) / size, 0, 1e-9);
            // The corner lies between the two long sides.
            const Vec<3> along = piece[1] - piece[0];
            const Vec<3> out = piece[3] - piece[0];
            const double share = glm::dot(glm::cross(plane.points[2] - piece[0], out), normal) /
                                 glm::dot(glm::cross(along, out), normal);
            ASSERT_GT(share, -1e-9);
            ASSERT_LT(share, 1 + 1e-9);
            ++pieces;
        }
    EXPECT_GT(pieces, 100u);
}

TEST(BoxPictures, OccludersAreDarkAndBoxesOfDrawnTrianglesAreWire) {
    Session<3> session = session_on<3>("wall2", "coorg-teller", {"unseen_as=wireframe", "show_visibility=off"});
    session.run();
    for (const SolidList::Run& run : make_solid(session).runs)
        EXPECT_NE(make_solid(session).styles[run.style].name, "actual") << "from the culling eye nothing is marked";
    session.freeze();
    session.set_view({{0, -25, 16}, {20, 10, 0}, 60});
    const SolidList list = make_solid(session);
    std::map<std::string, std::size_t> faces, edges, triangles;
    for (const std::uint8_t style : list.face_style) ++faces[list.styles[style].name];
    for (const std::uint8_t style : list.edge_style) ++edges[list.styles[style].name];
    for (const SolidList::Run& run : list.runs) triangles[list.styles[run.style].name] += run.count;
    EXPECT_EQ(faces["invisible"], 6 * boxes_in(session, CellState::hidden).size());
    EXPECT_EQ(faces["shown"], 0u);
    EXPECT_EQ(edges["shown"], 12 * boxes_in(session, CellState::projected).size());
    EXPECT_EQ(edges["outside"], 12 * boxes_in(session, CellState::unseen).size());
    std::set<std::uint32_t> actual;
    for (const OccluderFact& occluder : session.traversal().occluders())
        if (occluder.actual) actual.insert(occluder.primitives.begin(), occluder.primitives.end());
    EXPECT_EQ(triangles["actual"], actual.size());
    EXPECT_GT(faces["satisfied"], 0u);
    std::set<std::string> rows;
    UsedStyles used;
    add_used(list, used);
    add_used(make_picture(session), used);
    for (const LegendRow& row : legend_rows(used, session.settings(), std::span<const Note<3>>{}))
        rows.insert(row.text);
    for (const char* text : {"INVISIBLE: dropped", "PARTIAL or VISIBLE", "leaf with the eye", "occluder"})
        EXPECT_TRUE(rows.contains(text)) << text;
}

TEST(BoxPictures, BoxesStayApartWithoutColour) {
    for (const Palette palette : {Palette::standard, Palette::paper, Palette::print}) {
        const auto& looks = box_looks(palette);
        ASSERT_EQ(looks.size(), static_cast<std::size_t>(BoxLook::count));
        ASSERT_EQ(solid_box_looks(palette).size(), static_cast<std::size_t>(SolidBoxLook::count));
        std::vector<Style> states{colours(palette).looks[static_cast<std::size_t>(Look::enqueued)]};
        for (const BoxLook look : {BoxLook::invisible, BoxLook::shown, BoxLook::outside})
            states.push_back(looks[static_cast<std::size_t>(look)]);
        for (std::size_t a = 0; a < states.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_TRUE(std::abs(lightness(states[a].fill) - lightness(states[b].fill)) >= 12 ||
                            states[a].hatch != states[b].hatch ||
                            (palette == Palette::paper && states[a].stroke != states[b].stroke))
                    << states[a].name << " and " << states[b].name;
        for (const Style& style : looks) EXPECT_NE(box_entry(style.name), nullptr) << style.name;
        for (const SolidStyle& style : solid_box_looks(palette))
            EXPECT_NE(box_entry(style.name), nullptr) << style.name;
        // Satisfied or not, supporting or separating: told by dash and width.
        const auto plane = [&](BoxLook look) { return looks[static_cast<std::size_t>(look)]; };
        EXPECT_NE(plane(BoxLook::supporting).dash, plane(BoxLook::supporting_fails).dash);
        EXPECT_NE(plane(BoxLook::separating).dash, plane(BoxLook::separating_fails).dash);
        EXPECT_GE(plane(BoxLook::supporting).width_pt - plane(BoxLook::separating).width_pt, 0.6);
    }
}

TEST(BoxPictures, AClickFindsTheBox) {
    Random random(803);
    Session<2> plan = session_on<2>("wall2", "coorg-teller");
    plan.run();
    for (const ShownBox<2>& shown : shown_boxes(plan)) {
        const std::uint32_t found = box_near(plan, shown.box.centre(), 0);
        ASSERT_NE(found, none);
        ASSERT_TRUE(plan.traversal().boxes()->nodes[found].box.contains(shown.box.centre()));
        ASSERT_LE(plan.traversal().boxes()->nodes[found].box.longest_side(), shown.box.longest_side());
    }
    EXPECT_EQ(box_near(plan, {1e6, 0}, 1), none);
    const std::vector<ShownBox<3>> boxes{{4, CellState::hidden, {{2, -1, -1}, {3, 1, 1}}},
                                         {7, CellState::hidden, {{5, -1, -1}, {6, 1, 1}}},
                                         {9, CellState::hidden, {{-1, -1, -1}, {1, 1, 1}}}};
    EXPECT_EQ(box_along(boxes, {0, 0, 0}, {1, 0, 0}), 4u);
    EXPECT_EQ(box_along(boxes, {0, 0, 0}, {-1, 0, 0}), none) << "the box around the eye is not before it";
    EXPECT_EQ(box_along(boxes, {9, 0, 0}, {-2, 0, 0}), 7u);
    EXPECT_EQ(box_along(boxes, {4, 0, 0}, {1, 0.2, 0}), 7u);
    EXPECT_EQ(box_along(boxes, {0, 3, 0}, {1, 0, 0}), none);
}

}  // namespace
}  // namespace sightline
