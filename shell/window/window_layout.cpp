// Where the parts of the window stand, in the order in which they take their place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "core/session/headline.h"
#include "shell/commands/teach.h"
#include "shell/window/parts.h"
#include "shell/window/splitter.h"
#include "shell/window/theme.h"
#include "shell/window/window.h"

namespace sightline {

namespace {

/// Pixels at scale 1, and times the size of the text.
constexpr float least_timeline = 150, least_column = 180, least_timeline_em = 36;
/// In projector mode: from this shape on words stand beside the picture, and take these shares of the width.
constexpr float least_wide = 1.35f, words_share = 0.36f, words_and_panel_share = 0.45f;

/// Nothing distracts a class from the lecturer.
void draw_blank(const ImVec2& size) { ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, size, colour(theme::ink)); }

}  // namespace

/// All parts of a window of this size around the picture, which gets what they leave.
template <int D>
Area Window<D>::parts_around(const ImVec2& size) {
    const float line = ImGui::GetTextLineHeightWithSpacing();
    Area middle{0, 0, size.x, size.y};
    ui_.legend_room = {};
    if (bench_.desk.projector) {
        projector_parts(middle);
    } else {
        middle.y = menu_bar(ui_, bench_);
        const float bar = line + 18 * ui_.unit, status = line + 6 * ui_.unit;
        title_line(ui_, bench_, {0, middle.y, size.x, bar});
        middle.y += bar;
        middle.h = size.y - middle.y - status;
        if (const std::vector<Row> lesson = lesson_lines(bench_); !lesson.empty()) {
            const float h = block_height(ui_.fonts.text, lesson, size.x, middle.h * 0.3f);
            text_block(bench_, "lesson", ui_.fonts.text, lesson, {0, middle.y, size.x, h});
            middle.y += h;
            middle.h -= h;
        }
        status_line(ui_, bench_, {0, size.y - status, size.x, status});
        columns_and_timeline(middle, size.x);
        middle.h -= bar;
        scrubber(ui_, bench_, {middle.x, middle.y + middle.h, middle.w, bar});
    }
    if (bench_.flight.bar) {
        const float h = line + 18 * ui_.unit;
        middle.h -= h;
        path_bar(ui_, bench_, {middle.x, middle.y + middle.h, middle.w, h});
    }
    return middle;
}

/// The words for the class: beside the picture where the window is wide, else above and below it.
template <int D>
void Window<D>::projector_parts(Area& middle) {
    const std::vector<Row> lesson = lesson_lines(bench_), banner = banner_lines(bench_);
    ImFont* const font = ui_.fonts.banner;
    const bool panel = find_panel<D>(bench_.desk.projector_panel) != nullptr;
    const bool beside = middle.w > least_wide * middle.h;
    const float w = beside ? middle.w * (panel ? words_and_panel_share : words_share) : middle.w;
    const float most = middle.h * (beside ? (panel ? 0.35f : 0.5f) : 0.3f);
    const float above = lesson.empty() ? 0 : block_height(font, lesson, w, most);
    const float below = block_height(font, banner, w, most);
    const float x = middle.x + middle.w - w, bottom = middle.y + middle.h;
    if (!lesson.empty()) text_block(bench_, "lesson", font, lesson, {x, middle.y, w, above});
    text_block(bench_, "banner", font, banner, {x, bottom - below, w, below});
    if (beside && panel)
        panel_column(ui_, bench_, Column::right, {x, middle.y + above, w, bottom - below - middle.y - above});
    if (beside) {
        if (!panel) ui_.legend_room = {x, middle.y + above, w, bottom - below - middle.y - above};
        middle.w -= w;
    } else {
        middle.y += above;
        middle.h -= above + below;
    }
}

/// Takes their place from the area, which is as wide as the window.
template <int D>
void Window<D>::columns_and_timeline(Area& middle, float whole) {
    Desk& desk = bench_.desk;
    const float unit = ui_.unit, widest = whole * 0.4f, strip = splitter_width(ui_);
    const auto width_of = [&](const std::string& shown, double width) {
        return shown.empty() ? 0 : std::min(static_cast<float>(width) * unit, widest);
    };
    const auto column = [&](Column side, const std::string& shown, double& width) {
        const float w = width_of(shown, width);
        if (w == 0) return;
        const bool left = side == Column::left;
        const float x = left ? 0 : middle.x + middle.w - w;
        width = splitter(ui_, left ? "split left" : "split right", {left ? w : x - strip, middle.y, strip, middle.h},
                         {true, left ? 0 : x + w, least_column * unit, widest}, width);
        panel_column(ui_, bench_, side, {x, middle.y, w, middle.h});
        middle.w -= w + strip;
        if (left) middle.x += w + strip;
    };
    const auto timeline_part = [&] {
        if (!desk.timeline || !tells_truth(bench_.session)) return;  // its lanes tell what is visible
        const float highest = middle.h * 0.5f, bottom = middle.y + middle.h;
        const float h = std::min(static_cast<float>(desk.timeline_height) * unit, highest);
        middle.h -= h + strip;
        desk.timeline_height = splitter(ui_, "split timeline", {middle.x, middle.y + middle.h, middle.w, strip},
                                        {false, bottom, least_timeline * unit, highest}, desk.timeline_height);
        timeline(ui_, bench_, {middle.x, bottom - h, middle.w, h});
    };
    // Below the columns where its titles would not fit between them.
    const float between = whole - width_of(desk.left, desk.left_width) - width_of(desk.right, desk.right_width);
    const bool below = between < least_timeline_em * ImGui::GetFontSize();
    if (below) timeline_part();
    column(Column::left, desk.left, desk.left_width);
    column(Column::right, desk.right, desk.right_width);
    if (!below) timeline_part();
}

/// Inside a window of its own, which takes the mouse.
template <int D>
void Window<D>::picture_part(const Area& area) {
    bench_.places.push_back({"picture", area.x, area.y, area.w, area.h});
    ImGui::SetNextWindowPos(area.min());
    ImGui::SetNextWindowSize({area.w, area.h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("picture", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    stage.interact(ui_, area);
    ImGui::End();
}

template <int D>
void Window<D>::lay_out() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    bench_.places.clear();
    if (bench_.desk.blank) return draw_blank(size);
    bench_.hovered_cell = std::exchange(ui_.hovering, none);
    if (bench_.hovered_cell != none && bench_.hovered_cell >= bench_.session.cells().cell_count())
        bench_.hovered_cell = none;
    bench_.lit = std::exchange(ui_.lighting, {});
    const Area middle = parts_around(size);
    const bool room = middle.w > 8 && middle.h > 8;
    if (stage.interact && room) picture_part(middle);
    overlays(ui_, bench_, stage, {0, middle.y, size.x, size.y - middle.y});
    if (stage.draw && room) stage.draw(ui_, middle);
}

template Area Window<2>::parts_around(const ImVec2&);
template Area Window<3>::parts_around(const ImVec2&);
template void Window<2>::projector_parts(Area&);
template void Window<3>::projector_parts(Area&);
template void Window<2>::columns_and_timeline(Area&, float);
template void Window<3>::columns_and_timeline(Area&, float);
template void Window<2>::picture_part(const Area&);
template void Window<3>::picture_part(const Area&);
template void Window<2>::lay_out();
template void Window<3>::lay_out();

}  // namespace sightline
