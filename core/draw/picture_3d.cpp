// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/picture_3d.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/number.h"
#include "core/draw/box_palette.h"
#include "core/draw/cell_number.h"
#include "core/draw/choice.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "core/draw/projection.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_cells.h"
#include "core/draw/shown_planes.h"
#include "core/draw/solid_cells.h"
#include "core/draw/viewpoint_map.h"
#include "core/methods/cells/facet_geometry.h"
#include "core/methods/cells/star_shape.h"
#include "core/session/explain.h"

namespace sightline {

namespace {

/// More numbers than this find no room in a picture.
constexpr std::size_t most_labels = 1000;

class Painter {
public:
    Painter(const Session<3>& session, const PictureOptions3& options)
        : session_(session),
          set_(session.settings()),
          cells_(session.cells()),
          colours_(colours(set_.palette)),
          camera_(picture_camera(session, options.aspect)) {
        if (set_.show_choice == Switch::on && options.choice) choice_ = choice_of(session);
        concealed_ = options.concealed;
        list_.world = picture_plane(camera_);
        list_.styles = colours_.looks;
        if (session.traversal().tests_planes()) {
            const auto& looks = box_looks(set_.palette);
            list_.styles.insert(list_.styles.end(), looks.begin(), looks.end());
        }
        if (set_.show_view == Switch::on) seen_from_outside(session) ? view() : frame();
        if (set_.show_normals == Switch::on) normals();
        if (set_.show_penalties == Switch::on) penalties();
        if (session.traversal().tests_planes()) planes();
        if (seen_from_outside(session)) region();
        highlights();
        if (options.facet) crossed_facet(*options.facet);
        if (set_.show_chain == Switch::on && session.selected_cell != none) chain();
        draw_notes<3>(
            session, [this](const Vec<3>& p) { return in_picture(p); }, colours_, index(Look::note), list_);
        if (star_label_) list_.labels.push_back(*star_label_);
        labels();
    }
    DrawList take() { return std::move(list_); }

private:
    std::optional<Vec<2>> in_picture(const Vec<3>& p) const {
        const auto at = project(camera_, p);
        return at && list_.world.contains(*at) ? at : std::nullopt;
    }

    /// Nothing for a line along which the eye looks: it is a point.
    void line(const Vec<3>& a, const Vec<3>& b, std::uint16_t style) {
        const auto shown = project_line(camera_, a, b);
        if (shown && glm::length(shown->b - shown->a) > 1e-9)
            list_.add(ShapeKind::polyline, style, {shown->a, shown->b});
    }
    void line(const Vec<3>& a, const Vec<3>& b, Look look) { line(a, b, index(look)); }

    /// Without its head where that is out of sight.
    void arrow(const Vec<3>& a, const Vec<3>& b, std::uint16_t style) {
        if (const auto shown = project_line(camera_, a, b))
            list_.add(shown->to_the_end ? ShapeKind::arrow : ShapeKind::polyline, style, {shown->a, shown->b},
                      shown->to_the_end ? 4 : 0);
    }

    void mark(ShapeKind kind, const Vec<3>& p, std::uint16_t style, double size_pt) {
        if (const auto at = in_picture(p)) list_.add(kind, style, {*at}, size_pt);
    }

    std::uint16_t add_style(const char* name, Colour stroke, double width_pt) {
        Style style{name};
        style.stroke = stroke;
        style.width_pt = width_pt;
        list_.styles.push_back(style);
        return static_cast<std::uint16_t>(list_.styles.size() - 1);
    }

    void outline_cell(std::uint32_t cell, std::uint16_t style) {
        const auto corners = cells_.corners_of(cell);
        const auto corner = [&](std::uint8_t i) {
            return shrunk(cells_, cell, cells_.points[corners[i]], set_.shrink);
        };
        for (const auto& edge : edges_of(cells_, cell)) line(corner(edge[0]), corner(edge[1]), style);
    }

    void outline_facet(const HalfFacet& half, std::uint16_t style) {
        const auto polygon = cells_.points_of_facet(half.facet());
        for (std::size_t i = 0; i < polygon.size(); ++i)
            line(cells_.points[polygon[i]], cells_.points[polygon[(i + 1) % polygon.size()]], style);
    }

    /// The pyramid that the culling view sees, as far as the cells reach (TVCG fig. 7 in 2D), and its eye.
    void view() {
        if (seed_cell(session_) != none) outline_cell(seed_cell(session_), index(Look::seed));
        const View<3>& culling = session_.problem().view;
        double reach = 0;
        for (const Vec<3>& p : cells_.points) reach = std::max(reach, depth(culling, p));
        if (reach <= 0) reach = 1;
        std::array<Vec<3>, 4> far;
        for (std::size_t i = 0; i < 4; ++i) far[i] = culling.eye + (culling.corners[i] - culling.eye) * reach;
        for (std::size_t i = 0; i < 4; ++i) {
            line(culling.eye, far[i], Look::view);
            line(far[i], far[(i + 1) % 4], Look::view);
        }
        const Vec<3> ahead = culling.look_at - culling.eye;
        arrow(culling.eye, culling.eye + ahead * (0.06 * reach), index(Look::eye));
        mark(ShapeKind::disc, culling.eye, index(Look::eye), 2.6);
    }

    /// From the culling eye itself: where its image ends in a picture of another shape.
    void frame() {
        const View<3>& culling = session_.problem().view;
        if (std::abs(picture_plane(culling).max.x - list_.world.max.x) < 1e-9) return;
        for (std::size_t i = 0; i < 4; ++i) line(culling.corners[i], culling.corners[(i + 1) % 4], Look::view);
    }

    void normals() {
        const std::uint32_t cell = last_cell(session_);
        if (cell == none) return;
        const std::uint16_t rim = add_style("rim of normals", colours_.halo, 3.2);
        for (const HalfFacet& half : cells_.facets_of(cell)) {
            if (half.neighbour == none || cells_.is_contact(half.facet())) continue;
            const FacetGeometry<3> facet = facet_geometry(cells_, half);
            const double length = glm::length(facet.centroid - cells_.centre(cell));
            const Vec<3> tip = facet.centroid + facet.normal * (length / glm::length(facet.normal));
            line(session_.culling_view().eye, facet.centroid, Look::eye_ray);
            arrow(facet.centroid, tip, rim);
            arrow(facet.centroid, tip, index(Look::normal));
            const Vec<3> beyond = tip + (tip - facet.centroid) * 0.2;
            if (const auto at = in_picture(beyond))
                name_line(*at, "n_" + cell_letter(session_.notes, half.neighbour), list_, colours_);
            if (const auto at = in_picture(facet.centroid + (session_.culling_view().eye - facet.centroid) * 0.2))
                name_line(*at, "v", list_, colours_);
        }
    }

    void penalties() {
        if (last_cell(session_) != none)
            for (const HalfFacet& half : session_.penalised_facets(session_.position()))
                mark(ShapeKind::cross, facet_geometry(cells_, half).centroid, index(Look::penalty), 2);
        const std::uint32_t cell = session_.selected_cell != none ? session_.selected_cell : last_cell(session_);
        if (cell == none) return;
        const std::vector<ChainLink> chain = update_chain(session_, cell);
        if (!chain.empty() && chain.back().update.key->tested) star_test(cell, chain.back().update);
    }

    /// TVCG section 3.2: the ray from the eye to the cell's centre, the facet that it should cross, where it crosses
    /// the plane of that facet, and what it costs when it does so beside the facet.
    void star_test(std::uint32_t cell, const Considered& update) {
        const auto facets = cells_.facets_of(update.from.id);
        const HalfFacet& half = *std::find_if(facets.begin(), facets.end(),
                                              [&](const HalfFacet& own) { return own.facet() == update.via.id; });
        const Style& look = colours_.looks[index(Look::eye_ray)];
        const std::uint16_t ray = add_style("star_ray", look.stroke, 1.2);
        outline_facet(half, add_style("star_facet", colours_.accent, 1.8));
        const Vec<3>&eye = session_.culling_view().eye, &centre = cells_.centre(cell);
        line(eye, centre, ray);
        mark(ShapeKind::disc, centre, ray, 1.4);
        const FacetGeometry<3> facet = facet_geometry(cells_, half);
        const double along = glm::dot(facet.normal, centre - eye);
        const double share = along != 0 ? glm::dot(facet.normal, facet.centroid - eye) / along : -1;
        const Vec<3> crossing = share >= 0 && share <= 1 ? eye + (centre - eye) * share : facet.centroid;
        if (!update.key->penalised)
            mark(ShapeKind::ring, crossing, ray, 2.6);
        else
            mark(ShapeKind::cross, crossing, index(Look::penalty), 3.4);
        const auto at = in_picture(crossing);
        if (!at) return;
        Label& label = star_label_.emplace();
        label.at = *at;
        label.offset_pt = {6, 6};
        label.align = TextAlign::left;
        label.text = update.key->penalised ? update.key->penalty : "star-shaped: no penalty";
        label.scale = 0.8;
        label.colour = colours_.ink;
        label.halo = colours_.halo;
    }

    static std::uint16_t index(Look look) { return static_cast<std::uint16_t>(look); }
    std::uint16_t index(BoxLook look) const {
        return static_cast<std::uint16_t>(colours_.looks.size() + static_cast<std::size_t>(look));
    }
    void outline(const Box<3>& box, std::uint16_t style) {
        for (const auto& edge : edges_of_boxes()) line(box.corner(edge[0]), box.corner(edge[1]), style);
    }
    void outline(std::span<const Vec<3>> closed, std::uint16_t style) {
        for (std::size_t i = 0; i < closed.size(); ++i) line(closed[i], closed[(i + 1) % closed.size()], style);
    }

    /// Of a method that decides by planes, from outside: the leaf with the eye, the edges of the occluder at hand with
    /// what their planes say, the plane that is pointed out, and from where the selected occluder is one.
    void planes() {
        if (!seen_from_outside(session_)) return;
        if (const auto leaf = session_.traversal().eye_box(); leaf && set_.show_view == Switch::on)
            outline(*leaf, index(BoxLook::eye_leaf));
        if (set_.show_planes == Switch::off) return;
        const std::vector<TestedPlane<3>> tested = planes_at_hand(session_);
        for (std::size_t i = 0; i < tested.size(); ++i) {
            const TestedPlane<3>& plane = tested[i];
            if (i == session_.selected_plane)
                plane.kind == PlaneKind::own
                    ? outline(plane.points, index(BoxLook::lit))
                    : outline(piece_of(plane, session_.culling_view().eye), index(BoxLook::lit));
            if (plane.kind == PlaneKind::supporting)
                line(plane.points[0], plane.points[1],
                     index(plane.satisfied ? BoxLook::supporting : BoxLook::supporting_fails));
        }
        if (const auto region = region_at_hand(session_)) {
            for (const auto& closed : region->outlines) outline(closed, index(BoxLook::region));
            outline(region->box, index(BoxLook::region_box));
        }
    }

    /// Of the culling eye, where the method chooses by it.
    void region() {
        const auto fact = shown_viewpoint(session_);
        if (!fact) return;
        const Style look = region_here_style(set_.palette);
        list_.styles.push_back(look);
        outline(fact->map[fact->region_here].box, static_cast<std::uint16_t>(list_.styles.size() - 1));
    }

    void highlights() {
        if (choice_.next != none) outline_cell(choice_.next, index(Look::next));
        if (const std::uint32_t last = last_cell(session_); last != none) outline_cell(last, index(Look::last));
        const bool by_planes = session_.traversal().tests_planes();
        if (const auto box = last_box(session_)) outline(*box, by_planes ? index(BoxLook::last) : index(Look::last));
        if (const auto box = by_planes ? explained_box(session_) : selected_box(session_))
            outline(*box, by_planes ? index(BoxLook::selected) : index(Look::selected));
        if (session_.selected_cell != none) outline_cell(session_.selected_cell, index(Look::selected));
        if (session_.selected_primitive == none) return;
        const Primitive<3>& triangle = session_.scene().primitives[session_.selected_primitive];
        for (std::size_t i = 0; i < 3; ++i) line(triangle[i], triangle[(i + 1) % 3], Look::selected_primitive);
    }

    /// The facet in bold, and what lies behind it outlined.
    void crossed_facet(std::uint32_t place) {
        const std::uint32_t last = last_cell(session_);
        if (last == none || place >= cells_.facets_of(last).size()) return;
        const HalfFacet half = cells_.facets_of(last)[place];
        if (half.neighbour != none) outline_cell(half.neighbour, add_style("behind the facet", colours_.accent, 1.8));
        outline_facet(half, add_style("rim of the facet", colours_.halo, 7));
        outline_facet(half, add_style("facet", colours_.accent, 4.5));
    }

    void chain() {
        for (const ChainLink& link : update_chain(session_, session_.selected_cell))
            arrow(cells_.centre(link.update.from.id), cells_.centre(link.update.item.id), index(Look::chain));
    }

    /// In heights of the picture, how far the centre of the cell as it is drawn is from its nearest facet.
    double room_about_centre(std::uint32_t cell) const {
        double room = std::numeric_limits<double>::infinity();
        for (const HalfFacet& half : cells_.facets_of(cell))
            if (!cells_.is_contact(half.facet()))
                room = std::min(room, distance_to_facet(cells_, half.facet(), cells_.centre(cell)));
        const double height = glm::length(camera_.corners[3] - camera_.corners[0]);
        return room * set_.shrink / (height * depth(camera_, cells_.centre(cell)));
    }

    /// The nearest to the eye of the picture claim their places first; before them those that must show.
    void labels() {
        if (set_.label == CellNumber::none) return;
        const auto numbers = cell_numbers(session_, set_.label);
        const std::vector<std::uint8_t> shown = shown_cells(session_, slice_of(session_));
        const std::uint32_t last = last_cell(session_), first = first_in_front(session_);
        struct Numbered {
            bool yields, later;
            double depth;
            std::uint32_t cell;
            auto operator<=>(const Numbered&) const = default;
        };
        std::vector<Numbered> wanted;
        for (std::uint32_t cell = 0; cell < numbers.size(); ++cell) {
            const bool highlighted =
                cell == first || cell == last || cell == choice_.next || cell == session_.selected_cell;
            if (!numbers[cell] || !(shown[cell] || highlighted)) continue;
            const bool in_front = session_.mark(cell).state == CellState::enqueued;
            if (set_.label_where == LabelWhere::all || cell == session_.selected_cell ||
                (set_.label_where == LabelWhere::front && (in_front || cell == last)))
                if (in_picture(cells_.centre(cell)))
                    wanted.push_back({!highlighted, cell != first, depth(camera_, cells_.centre(cell)), cell});
        }
        std::sort(wanted.begin(), wanted.end());
        if (wanted.size() > most_labels) wanted.resize(most_labels);
        for (const Numbered& numbered : wanted) {
            Label label;
            label.at = *project(camera_, cells_.centre(numbered.cell));
            label.text = numbered.cell == concealed_
                             ? "?"
                             : cell_label(session_, choice_, numbered.cell, *numbers[numbered.cell]);
            label.scale = 0.8;
            label.colour = colours_.ink;
            label.halo = colours_.halo;
            label.room = room_about_centre(numbered.cell);
            label.yields = numbered.yields;
            list_.labels.push_back(label);
        }
    }

    const Session<3>& session_;
    const Settings& set_;
    const CellComplex<3>& cells_;
    const Colours& colours_;
    View<3> camera_;
    Choice choice_;
    std::optional<std::uint32_t> concealed_;
    DrawList list_;
    std::optional<Label> star_label_;  ///< notes have theirs first
};

}  // namespace

DrawList make_picture(const Session<3>& session, const PictureOptions3& options) {
    return Painter(session, options).take();
}

}  // namespace sightline
