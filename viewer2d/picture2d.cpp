// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/picture2d.h"

#include <algorithm>

#include "core/draw/cell_number.h"
#include "core/draw/palette.h"
#include "shell/window/theme.h"

namespace sightline {

void Picture2d::update(const Ui& ui, const Area& area) {
    const bool moved = area.w != area_.w || area.h != area_.h;
    if (revision_ == ui.revision && !moved) {
        camera_.area = area;
        return;
    }
    revision_ = ui.revision;
    area_ = area;
    const Session<2>& session = bench_.session;
    const CellNumber heat = session.settings().heat;
    if (heat_run_ != bench_.run || heat_ != heat) {
        heat_range_ = heat == CellNumber::none ? std::nullopt : number_range(session, heat);
        heat_run_ = bench_.run;
        heat_ = heat;
    }
    PictureOptions options;
    options.heat_range = heat_range_;
    options.aspect = area.w / area.h;
    list_ = make_picture(session, options);
    renderer_.set(list_);
    camera_ = {list_.world, area};
}

void Picture2d::draw(Ui& ui, const Area& area) {
    update(ui, area);
    const auto pixels = [&](float v) { return static_cast<int>(std::lround(v * ui.framebuffer)); };
    const int height = pixels(ImGui::GetIO().DisplaySize.y);
    ListView view;
    view.world = camera_.world;
    view.x = pixels(area.x);
    view.w = pixels(area.w);
    view.h = pixels(area.h);
    view.y = height - pixels(area.y) - view.h;
    view.px_per_pt = 4.0 / 3 * ui.unit * ui.framebuffer;
    view.line_scale = bench_.desk.projector ? 2 : 1;
    const Colour& paper = colours(bench_.session.settings().palette).background;
    glEnable(GL_SCISSOR_TEST);
    glScissor(view.x, view.y, view.w, view.h);
    glClearColor(paper.r / 255.0f, paper.g / 255.0f, paper.b / 255.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    renderer_.draw(view);
}

void Picture2d::draw_labels(const Ui& ui) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* const font = ui.fonts.label;
    const float size = font->FontSize / ui.framebuffer, pt = 4.0f / 3 * ui.unit;
    std::vector<Area> taken;
    for (const Label& label : list_.labels) {
        const ImVec2 extent = font->CalcTextSizeA(size, 1e9f, 0, label.text.c_str());
        const ImVec2 at = camera_.to_window(label.at);
        ImVec2 p{at.x + static_cast<float>(label.offset_pt.x) * pt, at.y - static_cast<float>(label.offset_pt.y) * pt};
        p.y -= extent.y / 2;
        if (label.align == TextAlign::centre) p.x -= extent.x / 2;
        if (label.align == TextAlign::right) p.x -= extent.x;
        const Area box{p.x - 2, p.y - 1, extent.x + 4, extent.y + 2};
        const auto overlaps = [&](const Area& b) {
            return b.x < box.x + box.w && box.x < b.x + b.w && b.y < box.y + box.h && box.y < b.y + b.h;
        };
        if (label.yields && std::any_of(taken.begin(), taken.end(), overlaps)) continue;
        taken.push_back(box);
        if (label.disc)
            list.AddCircleFilled({box.x + box.w / 2, box.y + box.h / 2}, 0.75f * extent.y, colour(*label.disc));
        if (label.leader) list.AddLine({box.x + box.w / 2, box.y + box.h}, at, colour(label.colour), 1.2f * ui.unit);
        if (label.halo.a > 0)
            for (const auto& [dx, dy] : {std::pair{-1.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}})
                list.AddText(font, size, {p.x + dx * ui.unit, p.y + dy * ui.unit}, colour(label.halo),
                             label.text.c_str());
        list.AddText(font, size, p, colour(label.colour), label.text.c_str());
    }
}

}  // namespace sightline
