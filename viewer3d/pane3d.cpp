// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/pane3d.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/base/stopwatch.h"
#include "core/draw/cell_number.h"
#include "core/draw/legend.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "core/draw/projection.h"
#include "core/draw/shown_cells.h"

namespace sightline {

namespace {

std::optional<ColourBar> colour_bar(const Session<3>& session, const PictureOptions3& options) {
    const Settings& settings = session.settings();
    if (settings.heat == CellNumber::none || !options.heat_range) return std::nullopt;
    return ColourBar{std::string(number_title(settings.heat)), short_number((*options.heat_range)[0]),
                     short_number((*options.heat_range)[1]), colours(settings.palette).heat};
}

}  // namespace

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
    key.outside = session.display_view() != session.culling_view();
    key.flying = session.flying();
    key.sides = !options.sides.empty();
    key.settings = session.settings();
    key.facet = options.facet;
    key.heat = options.heat_range;
    if (key.settings.slice == SliceAcross::view) key.sliced_from = session.display_view();
    if (key_ != key) {
        solid_ = make_solid(session, options);
        solid_renderer_.set(solid_);
        key_ = key;
    }
    solid_.camera = picture_camera(session, options.aspect);
}

void Pane3d::update(const Ui& ui, const Session<3>& session, const PictureOptions3& options, std::uint64_t revision,
                    std::uint64_t run, const Area& area, bool projector, bool with_legend, bool moving,
                    std::span<const Area> insets) {
    const auto pixels = [&](float v) { return static_cast<int>(std::lround(v * ui.framebuffer)); };
    const int height = pixels(ImGui::GetIO().DisplaySize.y);
    Size size{pixels(area.x), 0, std::max(1, pixels(area.w)), std::max(1, pixels(area.h))};
    size.y = height - pixels(area.y) - size.h;
    size.px_per_pt = 4.0 / 3 * ui.unit * ui.framebuffer;
    size.line_scale = projector ? 2 : 1;
    area_ = area;
    if (revision == revision_ && size == size_) return;
    revision_ = revision;
    size_ = size;

    const Stopwatch drawing;
    make_solid_list(session, options, run);
    over_ = make_picture(session, options);
    legend_ = {};
    legend_area_ = {};
    if (with_legend) make_legend_box(ui, session, options, insets);
    std::vector<Area> taken(insets.begin(), insets.end());
    if (legend_.w > 0) taken.push_back(legend_area_);
    spots_ = place_labels(over_.labels, label_paper(ui, area, [this](const Vec<2>& p) { return to_window(p); }), taken,
                          memory_);
    render(moving);
    draw_ms_ = drawing.milliseconds();
}

void Pane3d::make_legend_box(const Ui& ui, const Session<3>& session, const PictureOptions3& options,
                             std::span<const Area> insets) {
    const std::array<const DrawList*, 1> lists{&over_};
    const std::array<const SolidList*, 1> solids{&solid_};
    const auto rows = legend_rows(lists, solids, session.settings(), current_notes(session));
    LabelPaper paper = label_paper(ui, area_, [](const Vec<2>&) { return ImVec2(); });
    legend_ = make_legend(rows, colour_bar(session, options), colours(session.settings().palette), paper.measure,
                          ui.unit, size_.line_scale);
    // A legend that would take most of the picture helps nobody.
    if (legend_.h > area_.h - 20 * ui.unit || legend_.w > area_.w * 0.6f) legend_ = {};
    if (legend_.w == 0) return;
    std::vector<ImVec2> busy;
    for (const Area& inset : insets) busy.push_back({inset.x + inset.w / 2, inset.y + inset.h / 2});
    const auto add = [&](const Vec<3>& point) {
        if (const auto at = project(solid_.camera, point)) busy.push_back(to_window(*at));
    };
    if (session.selected_cell != none) add(session.cells().centre(session.selected_cell));
    if (seen_from_outside(session)) {
        add(session.culling_view().eye);
        add(session.culling_view().look_at);
    }
    legend_area_ = legend_place(legend_, area_, 10 * ui.unit, busy);
    paper.area = legend_area_;
    paper.to_window = [this](const Vec<2>& p) {
        return ImVec2(legend_area_.x + static_cast<float>(p.x),
                      legend_area_.y + legend_area_.h - static_cast<float>(p.y));
    };
    LabelMemory nothing;
    legend_spots_ = place_labels(legend_.list.labels, paper, {}, nothing);
}

void Pane3d::render(bool moving) {
    if (!picture_ || picture_->width() != size_.w || picture_->height() != size_.h)
        picture_.emplace(size_.w, size_.h, 1, true);
    picture_->bind();
    solid_renderer_.draw(solid_.camera, 0, 0, size_.w, size_.h, size_.px_per_pt, moving);
    const ListView view{over_.world, 0, 0, size_.w, size_.h, size_.px_per_pt, size_.line_scale};
    over_renderer_.set(over_);
    over_renderer_.draw(view);
    if (legend_.w > 0) {
        const double px = size_.w / static_cast<double>(area_.w);
        legend_renderer_.set(legend_.list);
        ListView corner = view;
        corner.world = legend_.list.world;
        corner.x = static_cast<int>(std::lround((legend_area_.x - area_.x) * px));
        corner.y = static_cast<int>(std::lround((area_.y + area_.h - legend_area_.y - legend_area_.h) * px));
        corner.w = static_cast<int>(std::lround(legend_area_.w * px));
        corner.h = static_cast<int>(std::lround(legend_area_.h * px));
        legend_renderer_.draw(corner);
    }
    picture_->resolve();
    glFinish();  // what the frame costs is told: a driver may put all of it off
}

void Pane3d::draw() const {
    if (picture_) quad_.draw(picture_->texture(), size_.x, size_.y, size_.w, size_.h, false);
}

void Pane3d::draw_texts(ImDrawList& list, const Ui& ui) const {
    draw_labels(list, ui, over_.labels, spots_);
    if (legend_.w > 0) draw_labels(list, ui, legend_.list.labels, legend_spots_);
}

}  // namespace sightline
