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
    whole_ = points_at_legend(ui);
    std::vector<LegendRow> shown(rows.begin(), rows.end());
    if (!whole_) shown = short_legend(std::move(shown));
    if (shown.size() < rows.size()) shown.emplace_back().text = "point here for all";
    legend_ = make_legend(shown, bar, colours, paper.measure, ui.unit, size_.line_scale);
    if (legend_.h > area_.h - 20 * ui.unit || legend_.w > area_.w * 0.6f) legend_ = {};
    legend_area_ = {};
    if (legend_.w == 0) return;
    legend_area_ = legend_place(legend_, area_, 10 * ui.unit, busy);
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
    if (legend_.w > 0) all.push_back(legend_area_);
    LabelPaper paper = label_paper(ui, area_, std::move(to_window));
    paper.keep_apart = true;
    spots_ = place_labels(labels, paper, all, memory_);
}

void PaneTexts::draw_legend() {
    if (legend_.w == 0) return;
    const double px = size_.w / static_cast<double>(area_.w);
    const auto pixels = [&](float length) { return static_cast<int>(std::lround(length * px)); };
    const Area& at = legend_area_;
    legend_renderer_.set(legend_.list);
    legend_renderer_.draw({legend_.list.world, pixels(at.x - area_.x), pixels(area_.y + area_.h - at.y - at.h),
                           pixels(at.w), pixels(at.h), size_.px_per_pt, size_.line_scale});
}

void PaneTexts::draw(ImDrawList& list, const Ui& ui, std::span<const Label> labels) const {
    draw_labels(list, ui, labels, spots_);
    if (legend_.w > 0) draw_labels(list, ui, legend_.list.labels, legend_spots_);
}

}  // namespace sightline
