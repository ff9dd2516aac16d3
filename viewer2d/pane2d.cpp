// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/pane2d.h"

#include <algorithm>
#include <array>

#include "core/draw/legend.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "shell/pane/side_by_side.h"

namespace sightline {

namespace {

bool same(const Box<2>& a, const Box<2>& b) { return a.min == b.min && a.max == b.max; }

void clear(const Colour& c) {
    glDisable(GL_SCISSOR_TEST);
    glClearColor(c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, c.a / 255.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

void fit_target(std::optional<GlTarget>& target, int w, int h) {
    if (!target || target->width() != w || target->height() != h) target.emplace(w, h);
}

/// Half a window has room for few rows.
bool is_for_two(const LegendRow& row) {
    constexpr std::array<std::string_view, 5> names{"projected", "enqueued", "only_here", "only_there", "missed"};
    return std::find(names.begin(), names.end(), row.style.name) != names.end();
}

}  // namespace

ListView Pane2d::view(const Box<2>& world) const {
    return {world, 0, 0, size_.w, size_.h, size_.px_per_pt, size_.line_scale};
}

void Pane2d::update(const Ui& ui, const Session<2>& session, const PictureOptions& options, const PaneFrame& frame,
                    const Area& area) {
    const PaneSize size = pane_size(ui, area, frame.projector);
    const bool as_before = frame.revision == revision_ && size == size_ && same(*options.world, camera_.world) &&
                           !texts_.legend_turned(ui);
    camera_ = {*options.world, area};
    if (as_before) return;
    revision_ = frame.revision;
    size_ = size;

    PictureOptions part = options;
    part.part = PicturePart::below;
    below_ = make_picture(session, part);
    part.part = PicturePart::above;
    strip_.reset();
    if (session.settings().show_eye == Switch::on) strip_ = eye_strip(session);
    part.eye = strip();
    above_ = make_picture(session, part);
    texts_.begin(area, size);
    if (frame.with_legend) add_legend(ui, session, options);
    texts_.place(ui, above_.labels, [this](const Vec<2>& p) { return camera_.to_window(p); });
    fade_.next(picture_, {frame.run, session.position(), size, frame.animate}, ImGui::GetTime());
    render(session, options);
}

void Pane2d::add_legend(const Ui& ui, const Session<2>& session, const PictureOptions& options) {
    const std::array<const DrawList*, 2> lists{&below_, &above_};
    auto rows = legend_rows(lists, session.settings(), key_title(session), current_notes(session));
    if (!options.differences.empty()) std::erase_if(rows, [](const LegendRow& row) { return !is_for_two(row); });
    std::vector<ImVec2> busy{camera_.to_window(session.display_view().eye),
                             camera_.to_window(session.culling_view().eye)};
    if (strip_)  // the lower corners
        for (const double x : {camera_.world.min.x, camera_.world.max.x}) {
            const float in = x == camera_.world.min.x ? 1.0f : -1.0f;
            const ImVec2 corner = camera_.to_window({x, camera_.world.min.y});
            busy.push_back({corner.x + in * 20 * ui.unit, corner.y - 20 * ui.unit});
        }
    const Settings& settings = session.settings();
    texts_.add_legend(ui, rows, colour_bar(session, options.heat_range), colours(settings.palette), busy);
}

void Pane2d::draw_borders(const Session<2>& session, const PictureOptions& options, const ListView& view) {
    const CellComplex<2>& cells = session.cells();
    const Palette palette = session.settings().palette;
    Borders& b = borders_;
    const bool same_lines = b.palette == palette && b.points == cells.points && b.facet_points == cells.facet_points;
    if (same_lines && same(b.world, view.world) && b.size == size_) return;
    if (!same_lines) {
        PictureOptions part = options;
        part.part = PicturePart::tessellation;
        border_renderer_.set(make_picture(session, part));
    }
    b = {cells.points, cells.facet_points, palette, view.world, size_};
    fit_target(border_picture_, size_.w, size_.h);
    border_picture_->bind();
    clear(transparent);
    border_renderer_.draw(view);
}

void Pane2d::render(const Session<2>& session, const PictureOptions& options) {
    const bool borders = session.settings().show_tessellation == Switch::on;
    if (borders) draw_borders(session, options, view(camera_.world));
    fit_target(picture_, size_.w, size_.h);
    picture_->bind();
    clear(colours(session.settings().palette).background);
    below_renderer_.set(below_);
    below_renderer_.draw(view(camera_.world));
    if (borders) quad_.draw(border_picture_->texture(), 0, 0, size_.w, size_.h, true);
    above_renderer_.set(above_);
    above_renderer_.draw(view(camera_.world));
    texts_.draw_legend();
    picture_->resolve();
}

void Pane2d::draw() const {
    if (!picture_) return;
    quad_.draw(picture_->texture(), size_.x, size_.y, size_.w, size_.h, false);
    fade_.draw(quad_, size_, ImGui::GetTime());
    texts_.draw_legend_beside();
}

void Pane2d::draw_texts(ImDrawList& list, const Ui& ui) const { texts_.draw(list, ui, above_.labels); }

}  // namespace sightline
