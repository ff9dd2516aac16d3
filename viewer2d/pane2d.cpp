// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/pane2d.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/draw/cell_number.h"
#include "core/draw/legend.h"
#include "core/draw/notes.h"
#include "core/draw/palette.h"

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

std::optional<ColourBar> colour_bar(const Session<2>& session, const PictureOptions& options) {
    const Settings& settings = session.settings();
    if (settings.heat == CellNumber::none || !options.heat_range) return std::nullopt;
    return ColourBar{std::string(number_title(settings.heat)), short_number((*options.heat_range)[0]),
                     short_number((*options.heat_range)[1]), colours(settings.palette).heat};
}

bool tells_sides(const LegendRow& row) {
    const std::string& name = row.style.name;
    return name == "both" || name == "only_left" || name == "only_right" || name == "clean";
}

}  // namespace

ListView Pane2d::view(const Box<2>& world) const {
    return {world, 0, 0, size_.w, size_.h, size_.px_per_pt, size_.line_scale};
}

void Pane2d::update(const Ui& ui, const Session<2>& session, const PictureOptions& options, std::uint64_t revision,
                    const Area& area, bool projector, bool with_legend) {
    const auto pixels = [&](float v) { return static_cast<int>(std::lround(v * ui.framebuffer)); };
    const int height = pixels(ImGui::GetIO().DisplaySize.y);
    Size size{pixels(area.x), 0, std::max(1, pixels(area.w)), std::max(1, pixels(area.h))};
    size.y = height - pixels(area.y) - size.h;
    size.px_per_pt = 4.0 / 3 * ui.unit * ui.framebuffer;
    size.line_scale = projector ? 2 : 1;
    const bool as_before = revision == revision_ && size == size_ && same(*options.world, camera_.world);
    camera_ = {*options.world, area};
    if (as_before) return;
    revision_ = revision;
    size_ = size;

    PictureOptions part = options;
    part.part = PicturePart::below;
    below_ = make_picture(session, part);
    part.part = PicturePart::above;
    above_ = make_picture(session, part);
    legend_ = {};
    legend_area_ = {};
    if (with_legend) make_legend_box(ui, session, options);
    const std::array<Area, 1> taken{legend_area_};
    spots_ =
        place_labels(above_.labels, label_paper(ui, area, [this](const Vec<2>& p) { return camera_.to_window(p); }),
                     legend_.w > 0 ? std::span<const Area>(taken) : std::span<const Area>(), memory_);
    render(session, options);
}

void Pane2d::make_legend_box(const Ui& ui, const Session<2>& session, const PictureOptions& options) {
    const std::array<const DrawList*, 2> lists{&below_, &above_};
    auto rows = legend_rows(lists, session.settings(), current_notes(session));
    // Half a window has room for what is new about two sides only.
    if (!options.sides.empty()) std::erase_if(rows, [](const LegendRow& row) { return !tells_sides(row); });
    LabelPaper paper = label_paper(ui, camera_.area, [](const Vec<2>&) { return ImVec2(); });
    legend_ = make_legend(rows, colour_bar(session, options), colours(session.settings().palette), paper.measure,
                          ui.unit, size_.line_scale);
    // A legend that would take most of the picture helps nobody.
    if (legend_.h > camera_.area.h - 20 * ui.unit || legend_.w > camera_.area.w * 0.6f) legend_ = {};
    if (legend_.w == 0) return;
    const std::array<ImVec2, 2> eyes{camera_.to_window(session.display_view().eye),
                                     camera_.to_window(session.culling_view().eye)};
    legend_area_ = legend_place(legend_, camera_.area, 10 * ui.unit, eyes);
    paper.area = legend_area_;
    paper.to_window = [this](const Vec<2>& p) {
        return ImVec2(legend_area_.x + static_cast<float>(p.x),
                      legend_area_.y + legend_area_.h - static_cast<float>(p.y));
    };
    LabelMemory nothing;
    legend_spots_ = place_labels(legend_.list.labels, paper, {}, nothing);
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
    if (legend_.w > 0) {
        const double px = size_.w / static_cast<double>(camera_.area.w);
        legend_renderer_.set(legend_.list);
        ListView corner = view(legend_.list.world);
        corner.x = static_cast<int>(std::lround((legend_area_.x - camera_.area.x) * px));
        corner.y =
            static_cast<int>(std::lround((camera_.area.y + camera_.area.h - legend_area_.y - legend_area_.h) * px));
        corner.w = static_cast<int>(std::lround(legend_area_.w * px));
        corner.h = static_cast<int>(std::lround(legend_area_.h * px));
        legend_renderer_.draw(corner);
    }
    picture_->resolve();
}

void Pane2d::draw() const {
    if (picture_) quad_.draw(picture_->texture(), size_.x, size_.y, size_.w, size_.h, false);
}

void Pane2d::draw_texts(ImDrawList& list, const Ui& ui) const {
    draw_labels(list, ui, above_.labels, spots_);
    if (legend_.w > 0) draw_labels(list, ui, legend_.list.labels, legend_spots_);
}

}  // namespace sightline
