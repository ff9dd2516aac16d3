// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/pane3d.h"

#include "core/base/stopwatch.h"
#include "core/draw/legend.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "core/draw/projection.h"
#include "core/draw/shown_cells.h"
#include "core/draw/shown_planes.h"
#include "shell/pane/side_by_side.h"

namespace sightline {

ImVec2 Pane3d::to_window(const Vec<2>& plane) const {
    return {area_.x + static_cast<float>(plane.x) * area_.h, area_.y + area_.h * static_cast<float>(1 - plane.y)};
}

Vec<2> Pane3d::to_plane(const ImVec2& window) const {
    return {(window.x - area_.x) / area_.h, 1 - (window.y - area_.y) / area_.h};
}

void Pane3d::make_solid_list(const Session<3>& session, const PictureOptions3& options, std::uint64_t run) {
    SolidKey key;
    key.scene = &session.scene();
    key.run = run;
    key.position = session.position();
    key.cell = session.selected_cell;
    key.primitive = session.selected_primitive;
    key.node = session.selected_node;
    key.plane = session.selected_plane;
    key.outside = session.display_view() != session.culling_view();
    key.frozen = session.frozen();
    key.flying = session.flying();
    key.differences.assign(options.differences.begin(), options.differences.end());
    key.settings = session.settings();
    key.facet = options.facet;
    key.heat = options.heat_range;
    // A slice across the view turns with it, and occluders are marked where their fronts are seen.
    const bool turns = key.settings.slice == SliceAcross::view || (key.outside && marks_occluders(session));
    if (turns) key.made_from = session.display_view();
    if (key_ != key) {
        solid_ = make_solid(session, options);
        solid_renderer_.set(solid_);
        key_ = key;
    }
    solid_.camera = picture_camera(session, options.aspect);
}

bool Pane3d::update(const Ui& ui, const Session<3>& session, const PictureOptions3& options, const PaneFrame& frame,
                    const Area& area, bool moving, const PaneInsets& insets) {
    const PaneSize size = pane_size(ui, area, frame.projector);
    area_ = area;
    if (frame.revision == revision_ && size == size_ && !texts_.legend_turned(ui)) return false;
    revision_ = frame.revision;
    size_ = size;

    const Stopwatch drawing;
    make_solid_list(session, options, frame.run);
    over_ = make_picture(session, options);
    texts_.begin(area, size);
    if (frame.with_legend) add_legend(ui, session, options, insets);
    texts_.place(
        ui, over_.labels, [this](const Vec<2>& p) { return to_window(p); }, insets.areas);
    fade_.next(picture_, {frame.run, session.position(), size, frame.animate && !session.flying()}, ImGui::GetTime());
    render(moving);
    draw_ms_ = drawing.milliseconds();
    return true;
}

void Pane3d::add_legend(const Ui& ui, const Session<3>& session, const PictureOptions3& options,
                        const PaneInsets& insets) {
    std::vector<const DrawList*> lists{&over_};
    if (insets.plan) lists.push_back(insets.plan);
    const std::array<const SolidList*, 1> solids{&solid_};
    const auto rows = legend_rows(lists, solids, session.settings(), key_title(session), current_notes(session));
    std::vector<ImVec2> busy;
    for (const Area& inset : insets.areas) busy.push_back({inset.x + inset.w / 2, inset.y + inset.h / 2});
    const auto add = [&](const Vec<3>& point) {
        if (const auto at = project(solid_.camera, point)) busy.push_back(to_window(*at));
    };
    if (session.selected_cell != none) add(session.cells().centre(session.selected_cell));
    if (seen_from_outside(session)) {
        add(session.culling_view().eye);
        add(session.culling_view().look_at);
    }
    const Settings& settings = session.settings();
    texts_.add_legend(ui, rows, colour_bar(session, options.heat_range), colours(settings.palette), busy);
}

void Pane3d::render(bool moving) {
    if (!picture_ || picture_->width() != size_.w || picture_->height() != size_.h)
        picture_.emplace(size_.w, size_.h, 1, true);
    picture_->bind();
    solid_renderer_.draw(solid_.camera, 0, 0, size_.w, size_.h, size_.px_per_pt, moving);
    over_renderer_.set(over_);
    over_renderer_.draw({over_.world, 0, 0, size_.w, size_.h, size_.px_per_pt, size_.line_scale});
    texts_.draw_legend();
    picture_->resolve();
    glFinish();  // what the frame costs is told: a driver may put all of it off
}

void Pane3d::draw() const {
    if (!picture_) return;
    quad_.draw(picture_->texture(), size_.x, size_.y, size_.w, size_.h, false);
    fade_.draw(quad_, size_, ImGui::GetTime());
    texts_.draw_legend_beside();
}

void Pane3d::draw_texts(ImDrawList& list, const Ui& ui) const { texts_.draw(list, ui, over_.labels); }

}  // namespace sightline
