// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/pane_texts.h"

#include <cmath>

#include "core/draw/legend.h"

namespace sightline {

void PaneTexts::begin(const Area& area, const PaneSize& size) {
    area_ = area;
    size_ = size;
    legend_ = {};
}

bool PaneTexts::points_at_legend(const Ui& ui) const {
    return ui.mouse_awake && legend_area_.contains(ImGui::GetIO().MousePos);
}

void PaneTexts::add_legend(const Ui& ui, std::span<const LegendRow> rows, const std::optional<ColourBar>& bar,
                           const Colours& colours, std::span<const ImVec2> busy) {
    LabelPaper paper = label_paper(ui, area_, {});
    const float margin = 10 * ui.unit;
    whole_ = points_at_legend(ui);
    std::vector<LegendRow> shown(rows.begin(), rows.end());
    if (!whole_) shown = short_legend(std::move(shown));
    if (shown.size() < rows.size()) shown.emplace_back().text = "point here for all";
    const auto make = [&] { legend_ = make_legend(shown, bar, colours, paper.measure, ui.unit, size_.line_scale); };
    make();
    beside_ = fits_beside(ui, shown, make);
    if (!beside_ && (legend_.h > area_.h - 20 * ui.unit || legend_.w > area_.w * 0.6f)) legend_ = {};
    legend_area_ = {};
    if (legend_.w == 0) return;
    const Area& room = ui.legend_room;
    legend_area_ = beside_ ? Area{room.x + margin, room.y + room.h - legend_.h - margin, legend_.w, legend_.h}
                           : legend_place(legend_, area_, margin, busy);
    legend_renderer_.set(legend_.list);
    paper.area = legend_area_;
    paper.to_window = [this](const Vec<2>& p) {
        return ImVec2(legend_area_.x + static_cast<float>(p.x),
                      legend_area_.y + legend_area_.h - static_cast<float>(p.y));
    };
    LabelMemory nothing;
    legend_spots_ = place_labels(legend_.list.labels, paper, {}, nothing);
}

void PaneTexts::place(const Ui& ui, std::span<const Label> labels, std::function<ImVec2(const Vec<2>&)> to_window,
                      std::span<const Area> taken) {
    std::vector<Area> all(taken.begin(), taken.end());
    if (legend_.w > 0 && !beside_) all.push_back(legend_area_);
    LabelPaper paper = label_paper(ui, area_, std::move(to_window));
    paper.keep_apart = true;
    spots_ = place_labels(labels, paper, all, memory_);
}

/// Rows are dropped from the end while it is too high; all of them are asked for, or it is not shown here.
bool PaneTexts::fits_beside(const Ui& ui, std::vector<LegendRow>& rows, const std::function<void()>& make) {
    const float margin = 20 * ui.unit;
    const auto fits = [&] { return legend_.w <= ui.legend_room.w - margin && legend_.h <= ui.legend_room.h - margin; };
    if (ui.legend_room.w == 0 || fits()) return ui.legend_room.w > 0;
    if (whole_) return false;
    const std::vector<LegendRow> all = rows;
    while (rows.size() > 2 && !fits()) {
        rows.pop_back();
        make();
    }
    if (fits()) return true;
    rows = all;
    make();
    return false;
}

void PaneTexts::draw_swatches(int x, int y) const {
    const double px = size_.w / static_cast<double>(area_.w);
    const auto pixels = [&](float length) { return static_cast<int>(std::lround(length * px)); };
    const Area& at = legend_area_;
    legend_renderer_.draw({legend_.list.world, x + pixels(at.x - area_.x), y + pixels(area_.y + area_.h - at.y - at.h),
                           pixels(at.w), pixels(at.h), size_.px_per_pt, size_.line_scale});
}

void PaneTexts::draw_legend() const {
    if (legend_.w > 0 && !beside_) draw_swatches(0, 0);
}

void PaneTexts::draw_legend_beside() const {
    if (legend_.w > 0 && beside_) draw_swatches(size_.x, size_.y);
}

void PaneTexts::draw(ImDrawList& list, const Ui& ui, std::span<const Label> labels) const {
    draw_labels(list, ui, labels, spots_);
    if (legend_.w > 0)
        draw_labels(beside_ ? *ImGui::GetBackgroundDrawList() : list, ui, legend_.list.labels, legend_spots_);
}

}  // namespace sightline
