// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/number.h"
#include "core/draw/cell_number.h"
#include "core/draw/choice.h"
#include "core/draw/depth_strip.h"
#include "core/draw/eye_strip.h"
#include "core/draw/notes.h"
#include "core/draw/paint_planes.h"
#include "core/draw/paint_rooms.h"
#include "core/draw/palette.h"
#include "core/draw/round_fields.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_world.h"
#include "core/draw/viewpoint_map.h"
#include "core/methods/cells/facet_geometry.h"
#include "core/run/drawn_levels.h"
#include "core/session/explain.h"

namespace sightline {

namespace {

constexpr int heat_steps = 32;
/// The radius of the rose of directions, of the picture's shorter side.
constexpr double rose_share = 0.1;

std::uint16_t index(Look look) { return static_cast<std::uint16_t>(look); }

/// Builds one picture, layer by layer from the back to the front.
class Painter {
public:
    Painter(const Session<2>& session, const PictureOptions& options)
        : session_(session), set_(session.settings()), cells_(session.cells()), colours_(colours(set_.palette)) {
        if (set_.show_choice == Switch::on && options.choice) choice_ = choice_of(session);
        concealed_ = options.concealed;
        list_.world = widened(options.world ? *options.world : figure_world(session), options.aspect);
        list_.styles = colours_.looks;
        if (session.traversal().tests_planes()) planes_.emplace(session, list_);
        viewpoint_ = shown_viewpoint(session);
        if (viewpoint_) regions_.emplace(*viewpoint_, session.scene(), set_.palette, list_);
        const bool by_state = set_.heat == CellNumber::none && set_.show_states == Switch::on && !regions_;
        const auto wants = [&](PicturePart part) { return options.part == PicturePart::all || options.part == part; };
        if (wants(PicturePart::below)) {
            if (set_.heat != CellNumber::none && options.heat_range) heat_map(*options.heat_range);
            if (by_state) states();
            if (regions_ && set_.heat == CellNumber::none) regions_->regions();
            if (set_.show_states == Switch::on && walks_rooms(session)) paint_windows(session, list_);
            if (set_.show_states == Switch::on) only_there(options.differences);
        }
        if (wants(PicturePart::tessellation) && set_.show_tessellation == Switch::on && !walks_boxes(session) &&
            !walks_rooms(session))
            tessellation();
        if (!wants(PicturePart::above)) return;
        if (by_state) projected_borders();
        if (set_.show_states == Switch::on) only_here(options.differences);
        if (regions_) candidates();
        if (planes_ && set_.show_states == Switch::on) planes_->occluders();
        if (set_.show_states == Switch::on && walks_rooms(session)) paint_portals(session, list_);
        if (set_.show_primitives == Switch::on) primitives();
        if (regions_) regions_->outline();
        if (set_.show_view == Switch::on) view();
        if (regions_) regions_->rose(session.culling_view().eye, rose_share * shorter_side());
        if (set_.show_normals == Switch::on) normals();
        if (set_.show_penalties == Switch::on) penalties();
        if (planes_ && set_.show_planes == Switch::on) planes_->planes();
        highlights();
        if (options.facet) crossed_facet(*options.facet);
        if (set_.show_chain == Switch::on && session.selected_cell != none) chain();
        draw_notes<2>(
            session, [](const Vec<2>& p) { return p; }, colours_, index(Look::note), list_);
        if (set_.show_eye == Switch::on)
            add_eye_strip(session, options.eye ? *options.eye : eye_strip(session), colours_, list_);
        if (set_.show_depth == Switch::on) add_depth_strip(session, colours_, list_);
        labels();
    }
    DrawList take() { return std::move(list_); }

private:
    void cell_shape(std::uint32_t cell, std::uint16_t style) {
        const auto corners = cells_.corners_of(cell);
        list_.shapes.push_back({ShapeKind::polygon, style, static_cast<std::uint32_t>(list_.points.size()),
                                static_cast<std::uint32_t>(corners.size())});
        for (const std::uint32_t p : corners) list_.points.push_back(cells_.points[p]);
    }

    void box_shape(const Box<2>& box, Look look) { list_.add(ShapeKind::polygon, index(look), box.corners()); }

    void box_states() {
        const Look hidden = session_.traversal().worker().postpones() ? Look::postponed : Look::hidden;
        for (const ShownBox<2>& shown : shown_boxes(session_))
            box_shape(shown.box, shown.state == CellState::enqueued ? Look::enqueued
                                 : shown.state == CellState::hidden ? hidden
                                 : shown.state == CellState::unseen ? Look::unseen
                                                                    : Look::projected);
    }

    double shorter_side() const { return std::min(list_.world.extent().x, list_.world.extent().y); }

    void candidates() {
        for (const std::uint32_t primitive : viewpoint_->occluders) {
            const Primitive<2>& s = session_.scene().primitives[primitive];
            regions_->candidate(s[0], s[1]);
        }
    }

    void states() {
        if (planes_) return planes_->boxes();
        if (walks_boxes(session_)) return box_states();
        const RoundFields<2> in_rounds(session_.traversal());
        for (std::uint32_t cell = 0; cell < cells_.cell_count(); ++cell) {
            const CellState state = session_.mark(cell).state;
            const InRounds rounds = in_rounds(cell);
            if (state == CellState::enqueued)
                cell_shape(cell, index(rounds == InRounds::hidden ? Look::hidden : Look::enqueued));
            if (state == CellState::projected)
                cell_shape(cell, index(rounds == InRounds::projected ? Look::completed : Look::projected));
            if (state == CellState::unseen) cell_shape(cell, index(Look::unseen));
        }
    }

    void only_there(std::span<const Differs> differences) {
        for (std::uint32_t cell = 0; cell < differences.size(); ++cell)
            if (differences[cell] == Differs::only_there) cell_shape(cell, index(Look::only_there));
    }

    /// Outlined as regions: a line about each cell would lie over the cells' borders like a net.
    void only_here(std::span<const Differs> differences) {
        const auto is_one = [&](std::uint32_t cell) { return cell != none && differences[cell] == Differs::only_here; };
        for (std::uint32_t cell = 0; cell < differences.size(); ++cell) {
            if (!is_one(cell)) continue;
            for (const HalfFacet& half : cells_.facets_of(cell)) {
                if (cells_.is_contact(half.facet()) || is_one(half.neighbour)) continue;
                const auto [a, b] = facet_ends(cells_, half);
                list_.add(ShapeKind::polyline, index(Look::only_here), {a, b});
            }
        }
    }

    /// A palette may give projected cells a border of their own, which goes over the tessellation.
    void projected_borders() {
        if (colours_.looks[index(Look::projected)].stroke.a == 0) return;
        for (std::uint32_t cell = 0; cell < cells_.cell_count(); ++cell)
            if (session_.mark(cell).state == CellState::projected)
                for (const HalfFacet& half : cells_.facets_of(cell)) {
                    if (cells_.is_contact(half.facet())) continue;
                    const auto [a, b] = facet_ends(cells_, half);
                    list_.add(ShapeKind::polyline, index(Look::projected), {a, b});
                }
    }

    void heat_map(const std::array<double, 2>& range) {
        const auto first = static_cast<std::uint16_t>(list_.styles.size());
        for (int i = 0; i < heat_steps; ++i) {
            Style style{"heat " + std::to_string(i)};
            style.fill = between(colours_.heat, static_cast<double>(i) / (heat_steps - 1));
            list_.styles.push_back(style);
        }
        const auto numbers = cell_numbers(session_, set_.heat);
        const double span = range[1] - range[0];
        for (std::uint32_t cell = 0; cell < numbers.size(); ++cell)
            if (numbers[cell]) {
                const double share = span > 0 ? std::clamp((*numbers[cell] - range[0]) / span, 0.0, 1.0) : 0;
                cell_shape(cell, static_cast<std::uint16_t>(first + std::lround(share * (heat_steps - 1))));
            }
    }

    void tessellation() {
        for (std::uint32_t facet = 0; facet < cells_.facet_count(); ++facet) {
            if (cells_.is_contact(facet)) continue;
            const auto ends = cells_.points_of_facet(facet);
            list_.add(ShapeKind::polyline, index(Look::tessellation), {cells_.points[ends[0]], cells_.points[ends[1]]});
        }
    }

    void primitives() {
        const auto& segments = session_.scene().primitives;
        const bool tell = set_.show_visibility == Switch::on;
        const Reference& reference = session_.reference();
        const std::vector<std::uint8_t> rendered = rendered_mask(session_.met(), segments.size());
        std::vector<std::uint8_t> stood_in(segments.size());
        for_stood_in(session_.traversal(), [&](std::uint32_t p) { stood_in[p] = 1; });
        const auto look = [&](std::size_t p) {
            if (!tell) return rendered[p] ? Look::rendered : Look::other;
            if (rendered[p]) return reference.visible[p] ? Look::rendered : Look::wasted;
            return reference.visible[p] && !stood_in[p] ? Look::missed : Look::other;
        };
        // What matters most comes last, on top.
        for (const Look layer : {Look::other, Look::wasted, Look::rendered, Look::missed})
            for (std::size_t p = 0; p < segments.size(); ++p)
                if (look(p) == layer) list_.add(ShapeKind::polyline, index(layer), {segments[p][0], segments[p][1]});
        for (const StandIn& stand_in : session_.traversal().stand_ins()) {
            const std::shared_ptr<const Levels<2>> levels = session_.traversal().levels();
            const Level& level = levels->at(stand_in.object, stand_in.level);
            for (std::uint32_t i = level.begin; i < level.end; ++i)
                list_.add(ShapeKind::polyline, index(level_look(Look::level_1, stand_in.level)),
                          {levels->primitives[i][0], levels->primitives[i][1]});
        }
    }

    void cone(const ViewSpec<2>& spec, Look look) {
        const View<2> made = make_view(spec);
        // Long enough to leave the picture from anywhere near it.
        const double reach = 4 * list_.world.longest_side() + glm::length(spec.eye - list_.world.centre());
        if (!made.all_round)
            for (const Vec<2>& corner : made.corners)
                list_.add(ShapeKind::polyline, index(look),
                          {spec.eye, spec.eye + (corner - spec.eye) * (reach / glm::length(corner - spec.eye))});
    }

    void view() {
        if (seed_cell(session_) != none) cell_shape(seed_cell(session_), index(Look::seed));
        cone(session_.culling_view(), Look::view);
        const ViewSpec<2>& spec = session_.culling_view();
        const Vec<2> forward = make_view(spec).forward();
        list_.add(ShapeKind::arrow, index(Look::eye),
                  {spec.eye, spec.eye + forward * (0.06 * list_.world.longest_side())}, 4);
        list_.add(ShapeKind::disc, index(Look::eye), {spec.eye}, 2.6);
        if (session_.frozen() && session_.display_view() != spec) {
            cone(session_.display_view(), Look::display_view);
            list_.add(ShapeKind::ring, index(Look::display_view), {session_.display_view().eye}, 2.6);
        }
    }

    void normals() {
        const std::uint32_t cell = last_cell(session_);
        if (cell == none) return;
        const Vec<2> eye = session_.culling_view().eye;
        Style rim{"rim of normals"};  // the arrows lie over light and dark cells alike
        rim.stroke = colours_.halo;
        rim.width_pt = 3.2;
        const auto halo = static_cast<std::uint16_t>(list_.styles.size());
        list_.styles.push_back(rim);
        for (const HalfFacet& half : cells_.facets_of(cell)) {
            if (half.neighbour == none || cells_.is_contact(half.facet())) continue;
            const FacetGeometry<2> facet = facet_geometry(cells_, half);
            const Vec<2> n = facet.normal / glm::length(facet.normal);
            list_.add(ShapeKind::polyline, index(Look::eye_ray), {eye, facet.centroid});
            const Vec<2> tip = facet.centroid + n * (0.07 * list_.world.longest_side());
            list_.add(ShapeKind::arrow, halo, {facet.centroid, tip}, 4);
            list_.add(ShapeKind::arrow, index(Look::normal), {facet.centroid, tip}, 4);
            name_line(tip + n * (0.015 * list_.world.longest_side()),
                      "n_" + cell_letter(session_.notes, half.neighbour), list_, colours_);
            // Where the rays have drawn apart.
            name_line(facet.centroid + (eye - facet.centroid) * 0.2, "v", list_, colours_);
        }
    }

    void penalties() {
        for (std::uint32_t step = 1; step <= session_.position(); ++step)
            for (const HalfFacet& half : session_.penalised_facets(step))
                list_.add(ShapeKind::cross, index(Look::penalty), {facet_geometry(cells_, half).centroid}, 2);
    }

    void highlights() {
        if (choice_.next != none) cell_shape(choice_.next, index(Look::next));
        if (const std::uint32_t last = last_cell(session_); last != none) cell_shape(last, index(Look::last));
        if (planes_)
            planes_->outlines();
        else if (const auto box = last_box(session_))
            box_shape(*box, Look::last);
        if (!planes_)
            if (const auto box = selected_box(session_)) box_shape(*box, Look::selected);
        if (session_.selected_cell != none) cell_shape(session_.selected_cell, index(Look::selected));
        if (session_.selected_primitive == none) return;
        const Primitive<2>& segment = session_.scene().primitives[session_.selected_primitive];
        list_.add(ShapeKind::polyline, index(Look::selected_primitive), {segment[0], segment[1]});
    }

    /// The facet as a bar, and what lies behind it outlined.
    void crossed_facet(std::uint32_t place) {
        const std::uint32_t last = last_cell(session_);
        if (last == none || place >= cells_.facets_of(last).size()) return;
        const HalfFacet half = cells_.facets_of(last)[place];
        const auto [a, b] = facet_ends(cells_, half);
        const auto add = [&](const char* name, Colour stroke, double width) {
            Style style{name};
            style.stroke = stroke;
            style.width_pt = width;
            list_.styles.push_back(style);
            return static_cast<std::uint16_t>(list_.styles.size() - 1);
        };
        const std::uint16_t rim = add("rim of the facet", colours_.halo, 7), bar = add("facet", colours_.accent, 4.5),
                            behind = add("behind the facet", colours_.accent, 1.8);
        if (half.neighbour != none) cell_shape(half.neighbour, behind);
        list_.add(ShapeKind::polyline, rim, {a, b});
        list_.add(ShapeKind::polyline, bar, {a, b});
    }

    void chain() {
        for (const ChainLink& link : update_chain(session_, session_.selected_cell))
            list_.add(ShapeKind::arrow, index(Look::chain),
                      {cells_.centre(link.update.from.id), cells_.centre(link.update.item.id)}, 4);
    }

    /// Distance from a cell's centre to its nearest edge.
    double room_about_centre(std::uint32_t cell) const {
        const auto corners = cells_.corners_of(cell);
        double room = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec<2> a = cells_.points[corners[i]], edge = cells_.points[corners[(i + 1) % corners.size()]] - a;
            const Vec<2> d = cells_.centre(cell) - a;
            room = std::min(room, std::abs(edge.x * d.y - edge.y * d.x) / glm::length(edge));
        }
        return room;
    }

    /// What lies lower is under the strip of what the eye sees.
    double paper_top() const {
        if (set_.show_eye == Switch::off) return list_.world.min.y;
        return eye_strip_place(list_.world, set_.show_depth == Switch::on).top;
    }

    void labels() {
        if (set_.label == CellNumber::none) return;
        const auto numbers = cell_numbers(session_, set_.label);
        const std::uint32_t last = last_cell(session_), first = first_in_front(session_);
        for (std::uint32_t cell = 0; cell < numbers.size(); ++cell) {
            if (!numbers[cell]) continue;
            const bool in_front = session_.mark(cell).state == CellState::enqueued;
            const bool wanted = set_.label_where == LabelWhere::all || cell == session_.selected_cell ||
                                (set_.label_where == LabelWhere::front && (in_front || cell == last));
            if (!wanted || !list_.world.contains(cells_.centre(cell)) || cells_.centre(cell).y < paper_top()) continue;
            Label label;
            label.at = cells_.centre(cell);
            label.text = cell == concealed_ ? "?" : cell_label(session_, choice_, cell, *numbers[cell]);
            label.scale = 0.8;
            label.colour = colours_.ink;
            label.halo = colours_.halo;
            label.room = room_about_centre(cell);
            label.yields = cell != first && cell != last && cell != choice_.next && cell != session_.selected_cell;
            list_.labels.insert(cell == first ? list_.labels.begin() : list_.labels.end(), label);
        }
        // Those that must show claim their place first.
        std::stable_partition(list_.labels.begin(), list_.labels.end(), [](const Label& l) { return !l.yields; });
    }

    const Session<2>& session_;
    const Settings& set_;
    const CellComplex<2>& cells_;
    const Colours& colours_;
    Choice choice_;
    std::optional<std::uint32_t> concealed_;
    DrawList list_;
    std::optional<PlanePainter> planes_;  ///< of a method that decides by planes
    std::optional<ViewpointFact<2>> viewpoint_;
    std::optional<RegionPainter<2>> regions_;  ///< of a method that chooses by viewpoint
};

}  // namespace

DrawList make_picture(const Session<2>& session, const PictureOptions& options) {
    return Painter(session, options).take();
}

}  // namespace sightline
