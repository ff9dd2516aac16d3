// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/draw/box_palette.h"
#include "core/draw/cell_number.h"
#include "core/draw/paint_rooms.h"
#include "core/draw/palette.h"
#include "core/draw/picture_3d.h"
#include "core/draw/round_fields.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_cells.h"
#include "core/draw/shown_planes.h"
#include "core/draw/solid_cells.h"
#include "core/draw/solid_palette.h"
#include "core/draw/solid_triangles.h"
#include "core/run/drawn_levels.h"

namespace sightline {

namespace {

constexpr int solid_heat_steps = 32;

std::uint8_t look_index(SolidLook look) { return static_cast<std::uint8_t>(look); }

SolidLook look_of(CellState state, InRounds rounds, bool postpones = false) {
    switch (state) {
        case CellState::enqueued:
            return rounds == InRounds::hidden ? SolidLook::hidden : SolidLook::enqueued;
        case CellState::projected:
            return rounds == InRounds::projected ? SolidLook::completed : SolidLook::projected;
        case CellState::unseen:
            return SolidLook::unseen;
        case CellState::hidden:
            return postpones ? SolidLook::postponed : SolidLook::hidden;
        case CellState::clean:
            break;
    }
    return SolidLook::clean;
}

DrawnAs drawn_as(const Settings& set, SolidLook look) {
    switch (look) {
        case SolidLook::clean:
            return set.clean_as;
        case SolidLook::enqueued:
        case SolidLook::hidden:
        case SolidLook::postponed:
            return set.enqueued_as;
        case SolidLook::unseen:
            return set.unseen_as;
        default:  // projected
            return set.projected_as;
    }
}

/// Adds the steps of the heat map and returns the first; `alpha` is that of all.
std::uint8_t add_heat(const Settings& set, std::uint8_t alpha, SolidList& list) {
    const auto first = static_cast<std::uint8_t>(list.styles.size());
    for (int i = 0; i < solid_heat_steps; ++i) {
        SolidStyle style{"heat " + std::to_string(i), between(colours(set.palette).heat, i / (solid_heat_steps - 1.0))};
        style.colour.a = alpha;
        style.width_pt = 0.8;
        list.styles.push_back(style);
    }
    return first;
}

std::vector<CellPaint> paint_cells(const Session<3>& session, const PictureOptions3& options, SolidList& list) {
    const Settings& set = session.settings();
    const bool heat = set.heat != CellNumber::none, border = set.show_tessellation == Switch::on;
    std::vector<std::optional<double>> numbers;
    if (heat) numbers = cell_numbers(session, set.heat);
    std::uint8_t opaque = 0, glass = 0;
    if (heat) {
        opaque = add_heat(set, 255, list);
        glass = add_heat(set, translucent_alpha, list);
    }
    const auto [low, high] = options.heat_range.value_or(std::array<double, 2>{0, 0});
    const std::vector<std::uint8_t> shown = shown_cells(session, list.slice);
    const RoundFields<3> in_rounds(session.traversal());
    std::vector<CellPaint> paint(shown.size());
    for (std::uint32_t cell = 0; cell < paint.size(); ++cell) {
        if (!shown[cell]) continue;
        const SolidLook look = look_of(session.mark(cell).state, in_rounds(cell));
        CellPaint& own = paint[cell];
        own.group = own.style = look_index(look);
        own.as = drawn_as(set, look);
        if (border) own.border = look_index(SolidLook::border);
        if (heat && !numbers[cell]) {
            if (own.as != DrawnAs::wireframe) own.as = DrawnAs::off;
        } else if (heat) {
            const double share = high > low ? std::clamp((*numbers[cell] - low) / (high - low), 0.0, 1.0) : 0;
            own.style = static_cast<std::uint8_t>((own.as == DrawnAs::translucent ? glass : opaque) +
                                                  std::lround(share * (solid_heat_steps - 1)));
        }
    }
    return paint;
}

SolidBoxLook box_look_of(CellState state) {
    return state == CellState::hidden   ? SolidBoxLook::invisible
           : state == CellState::unseen ? SolidBoxLook::outside
                                        : SolidBoxLook::shown;
}

/// A solid box would hide the triangles in it that are drawn.
DrawnAs drawn_as(const Settings& set, SolidBoxLook look) {
    if (look == SolidBoxLook::outside) return set.unseen_as;
    const bool wire = look == SolidBoxLook::shown && set.triangles != Triangles::off;
    return wire && set.projected_as != DrawnAs::off ? DrawnAs::wireframe : set.projected_as;
}

DrawnAs drawn_as(const Session<3>& session, CellState state) {
    const Settings& set = session.settings();
    if (session.traversal().tests_planes() && state != CellState::enqueued) return drawn_as(set, box_look_of(state));
    return drawn_as(set, look_of(state, InRounds::nothing));
}

/// `first`: of the styles of box_palette.h, in the list of a method that decides by planes.
void paint_boxes(const Session<3>& session, std::size_t first, SolidList& list) {
    const bool by_planes = session.traversal().tests_planes(), postpones = session.traversal().worker().postpones();
    std::vector<Box<3>> boxes;
    std::vector<CellPaint> paint;
    for (const ShownBox<3>& shown : drawn_boxes(session)) {
        const bool own_look = by_planes && shown.state != CellState::enqueued;
        CellPaint& own = paint.emplace_back();
        own.as = drawn_as(session, shown.state);
        own.style = own_look ? static_cast<std::uint8_t>(first + static_cast<std::size_t>(box_look_of(shown.state)))
                             : look_index(look_of(shown.state, InRounds::nothing, postpones));
        own.group = own.border = own.style;
        boxes.push_back(shown.box);
        if (own_look && own.as == DrawnAs::translucent) list.styles[own.style].colour.a = translucent_alpha;
    }
    add_boxes(boxes, paint, list);
}

/// Rooms as boxes, with their portals.
void paint_rooms(const Session<3>& session, SolidList& list) {
    const Settings& set = session.settings();
    const Rooms<3>& rooms = session.scene().rooms;
    const std::vector<CellState> states = states_of_rooms(session);
    std::vector<Box<3>> boxes;
    std::vector<CellPaint> paint;
    for (std::size_t room = 0; room < states.size(); ++room) {
        const SolidLook look = look_of(states[room], InRounds::nothing);
        CellPaint own;
        own.as = drawn_as(set, look);
        if (look == SolidLook::projected && own.as != DrawnAs::off && set.triangles != Triangles::off)
            own.as = DrawnAs::wireframe;  // else it would hide what is drawn in it
        if (list.slice && glm::dot(list.slice->normal, rooms.all[room].shape.centre()) > list.slice->offset) continue;
        own.group = own.style = own.border = look_index(look);
        boxes.push_back(rooms.all[room].shape);
        paint.push_back(own);
    }
    add_boxes(boxes, paint, list);
    for (const Portal<3>& portal : rooms.portals)
        for (std::size_t i = 0; i < portal.corners.size(); ++i) {
            for (const std::size_t k : {i, (i + 1) % portal.corners.size()})
                list.edge_points.push_back(portal.corners[k]);
            list.edge_style.push_back(look_index(SolidLook::border));
        }
}

/// The supporting planes between the box and the occluder at hand, as glass; the separating ones where one is not
/// satisfied; the one that is pointed out alone.
void add_plane_pieces(const Session<3>& session, std::size_t first, SolidList& list) {
    const std::vector<TestedPlane<3>> planes = planes_at_hand(session);
    const bool lit = session.selected_plane < planes.size() && planes[session.selected_plane].kind != PlaneKind::own;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const TestedPlane<3>& plane = planes[i];
        if (plane.kind == PlaneKind::own) continue;
        if (lit ? i != session.selected_plane : plane.kind == PlaneKind::separating && plane.satisfied) continue;
        for (const Vec<3>& p : piece_of(plane, session.culling_view().eye)) list.points.push_back(p);
        list.face_begin.push_back(static_cast<std::uint32_t>(list.points.size()));
        list.face_style.push_back(static_cast<std::uint8_t>(
            first + static_cast<std::size_t>(plane.satisfied ? SolidBoxLook::satisfied : SolidBoxLook::fails)));
        list.face_cell.push_back(none);
    }
}

/// Wire over everything else, whatever the cells themselves are drawn as: those that only the other run projected are
/// often drawn as nothing here.
void add_differences(const Session<3>& session, std::span<const Differs> differences, SolidList& list) {
    const std::vector<std::uint8_t> shown = shown_cells(session, list.slice);
    for (const auto& [differs, look] :
         {std::pair(Differs::only_there, SolidLook::only_there), std::pair(Differs::only_here, SolidLook::only_here)}) {
        std::vector<std::uint8_t> marked(differences.size());
        for (std::uint32_t cell = 0; cell < marked.size(); ++cell)
            marked[cell] = shown[cell] && differences[cell] == differs;
        add_outline(session.cells(), marked, look_index(look), session.settings().shrink, list);
    }
}

void make_glass(const Settings& set, SolidList& list) {
    for (const SolidLook look : {SolidLook::clean, SolidLook::enqueued, SolidLook::projected, SolidLook::unseen,
                                 SolidLook::completed, SolidLook::hidden})
        if (drawn_as(set, look) == DrawnAs::translucent) list.styles[look_index(look)].colour.a = translucent_alpha;
}

}  // namespace

View<3> picture_camera(const Session<3>& session, double aspect) {
    const ImageSize size = image_size<3>(session.settings().reference_size);
    return make_view(session.display_view(), aspect > 0 ? aspect : static_cast<double>(size.width) / size.height,
                     session.scene().up_axis);
}

std::vector<ShownBox<3>> drawn_boxes(const Session<3>& session) {
    const std::optional<Slice> slice = slice_of(session);
    std::vector<ShownBox<3>> drawn = shown_boxes(session);
    std::erase_if(drawn, [&](const ShownBox<3>& shown) {
        return (session.settings().only == OnlyCells::front && shown.state != CellState::enqueued) ||
               (slice && glm::dot(slice->normal, shown.box.centre()) > slice->offset) ||
               drawn_as(session, shown.state) == DrawnAs::off;
    });
    return drawn;
}

std::vector<std::uint32_t> wire_cells(const Session<3>& session) {
    std::vector<std::uint32_t> wire;
    if (!seen_from_outside(session) || walks_boxes(session) || walks_rooms(session)) return wire;
    const std::vector<std::uint8_t> shown = shown_cells(session, slice_of(session));
    const RoundFields<3> in_rounds(session.traversal());
    for (std::uint32_t cell = 0; cell < shown.size(); ++cell)
        if (shown[cell] &&
            drawn_as(session.settings(), look_of(session.mark(cell).state, in_rounds(cell))) == DrawnAs::wireframe)
            wire.push_back(cell);
    return wire;
}

SolidList make_solid(const Session<3>& session, const PictureOptions3& options) {
    const Settings& set = session.settings();
    SolidList list;
    list.camera = picture_camera(session, options.aspect);
    list.styles = solid_styles(set.palette);
    list.background = colours(set.palette).background;
    list.scene = drawn_scene(session.traversal(), session.shared_scene());
    if (list.scene != session.shared_scene())
        list.levels_from = static_cast<std::uint32_t>(session.scene().primitives.size());
    list.slice = slice_of(session);
    const bool outside = seen_from_outside(session);
    const bool by_planes = session.traversal().tests_planes();
    const std::size_t first = list.styles.size();
    if (by_planes || (outside && marks_occluders(session))) {
        const auto& looks = solid_box_looks(set.palette);
        list.styles.insert(list.styles.end(), looks.begin(), looks.end());
    }
    add_triangles(session, set.show_visibility == Switch::on && (outside || set.triangles > Triangles::missed), list);
    if (!outside) return list;
    make_glass(set, list);
    if (walks_rooms(session)) {
        paint_rooms(session, list);
        return list;
    }
    if (walks_boxes(session)) {
        paint_boxes(session, first, list);
        if (by_planes && set.show_planes == Switch::on) add_plane_pieces(session, first, list);
        return list;
    }
    add_cells(session.cells(), paint_cells(session, options, list), set.shrink, list);
    if (!options.differences.empty()) add_differences(session, options.differences, list);
    return list;
}

}  // namespace sightline
