// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/draw/cell_number.h"
#include "core/draw/palette.h"
#include "core/draw/picture_3d.h"
#include "core/draw/round_fields.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_cells.h"
#include "core/draw/solid_cells.h"
#include "core/draw/solid_palette.h"
#include "core/draw/solid_triangles.h"

namespace sightline {

namespace {

constexpr int solid_heat_steps = 32;

std::uint8_t look_index(SolidLook look) { return static_cast<std::uint8_t>(look); }

SolidLook look_of(CellState state, InRounds rounds) {
    switch (state) {
        case CellState::enqueued:
            return rounds == InRounds::hidden ? SolidLook::hidden : SolidLook::enqueued;
        case CellState::projected:
            return rounds == InRounds::projected ? SolidLook::completed : SolidLook::projected;
        case CellState::unseen:
            return SolidLook::unseen;
        case CellState::hidden:
            return SolidLook::hidden;
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

void paint_boxes(const Session<3>& session, SolidList& list) {
    const Settings& set = session.settings();
    std::vector<Box<3>> boxes;
    std::vector<CellPaint> paint;
    for (const ShownBox<3>& shown : shown_boxes(session)) {
        if (set.only == OnlyCells::front && shown.state != CellState::enqueued) continue;
        if (list.slice && glm::dot(list.slice->normal, shown.box.centre()) > list.slice->offset) continue;
        const SolidLook look = look_of(shown.state, InRounds::nothing);
        CellPaint& own = paint.emplace_back();
        own.group = own.style = look_index(look);
        own.as = drawn_as(set, look);
        own.border = own.style;
        boxes.push_back(shown.box);
    }
    add_boxes(boxes, paint, list);
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

SolidList make_solid(const Session<3>& session, const PictureOptions3& options) {
    const Settings& set = session.settings();
    SolidList list;
    list.camera = picture_camera(session, options.aspect);
    list.styles = solid_styles(set.palette);
    list.background = colours(set.palette).background;
    list.scene = session.shared_scene();
    list.slice = slice_of(session);
    const bool outside = seen_from_outside(session);
    add_triangles(session, set.show_visibility == Switch::on && (outside || set.triangles > Triangles::rendered), list);
    if (!outside) return list;
    make_glass(set, list);
    if (walks_boxes(session)) {
        paint_boxes(session, list);
        return list;
    }
    add_cells(session.cells(), paint_cells(session, options, list), set.shrink, list);
    if (!options.differences.empty()) add_differences(session, options.differences, list);
    return list;
}

}  // namespace sightline
