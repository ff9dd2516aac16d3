// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/labels.h"

#include <algorithm>
#include <cmath>

#include "shell/window/halo.h"

namespace sightline {

namespace {

Vec<2> vec(const ImVec2& p) { return {p.x, p.y}; }
ImVec2 window(const Vec<2>& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }
Box<2> box_of(const Area& a) { return {vec(a.min()), vec(a.max())}; }

float radius_of(const Label& label, const ImVec2& text) {
    return label.disc ? std::max(0.62f * text.y, text.x / 2 + 0.22f * text.y) : 0;
}

void draw_leader(ImDrawList& list, const LabelSpot& spot, ImU32 ink, ImU32 halo, float unit) {
    const Area& b = spot.box;
    if (b.contains(spot.anchor)) return;
    const Box<2> box = box_of({b.x - unit, b.y - unit, b.w + 2 * unit, b.h + 2 * unit});
    const ImVec2 centre = window(box.centre()), from = window(leader_start(box, vec(spot.anchor)));
    const ImVec2 d{spot.anchor.x - centre.x, spot.anchor.y - centre.y};
    const float length = std::hypot(d.x, d.y), head = 8 * unit;
    const ImVec2 u{d.x / length, d.y / length}, tip = spot.anchor;
    const ImVec2 base{tip.x - u.x * head, tip.y - u.y * head};
    const ImVec2 left{base.x - u.y * head * 0.4f, base.y + u.x * head * 0.4f},
        right{base.x + u.y * head * 0.4f, base.y - u.x * head * 0.4f};
    list.AddLine(from, base, halo, 4 * unit);
    list.AddTriangle(tip, left, right, halo, 3 * unit);
    list.AddLine(from, base, ink, 1.4f * unit);
    list.AddTriangleFilled(tip, left, right, ink);
}

}  // namespace

std::vector<LabelSpot> place_labels(std::span<const Label> labels, const LabelPaper& paper, std::span<const Area> taken,
                                    LabelMemory& memory) {
    LabelGround ground;
    ground.frame = box_of(paper.area);
    ground.pt = paper.pt;
    ground.least_room = 2 * paper.halo;
    ground.keep_apart = paper.keep_apart;
    ground.to_paper = [&](const Vec<2>& p) { return vec(paper.to_window(p)); };
    ground.size = [&](const Label& label, std::size_t form) -> std::optional<LabelSize> {
        if (form > 0) return std::nullopt;
        const ImVec2 extent = paper.measure(label.text);
        const float margin = label.halo.a > 0 ? paper.halo : 1;
        // Letters fill about four fifths of a line's height.
        return LabelSize{extent.x, 0.4f * extent.y + margin, margin, radius_of(label, extent)};
    };
    std::vector<Box<2>> boxes;
    for (const Area& area : taken) boxes.push_back(box_of(area));
    std::vector<LabelSpot> spots;
    for (const StandingLabel& standing : stand_labels(labels, ground, boxes, &memory)) {
        const Label& label = labels[standing.label];
        const ImVec2 extent = paper.measure(label.text), low = window(standing.box.min),
                     across = window(standing.box.extent()), centre = window(standing.box.centre());
        spots.push_back({standing.label,
                         {low.x, low.y, across.x, across.y},
                         {std::round(centre.x - extent.x / 2), std::round(centre.y - extent.y / 2)},
                         window(standing.leader ? standing.tip : standing.anchor),
                         label.leader || standing.leader,
                         radius_of(label, extent)});
    }
    return spots;
}

LabelPaper label_paper(const Ui& ui, const Area& area, std::function<ImVec2(const Vec<2>&)> to_window) {
    ImFont* const font = ui.fonts.label;
    const float size = font->FontSize / ui.framebuffer;
    return {area, 4.0f / 3 * ui.unit, 2 * ui.unit, false, std::move(to_window), [font, size](const std::string& text) {
                return font->CalcTextSizeA(size, 1e9f, 0, text.data(), text.data() + text.size());
            }};
}

void draw_labels(ImDrawList& list, const Ui& ui, std::span<const Label> labels, std::span<const LabelSpot> spots) {
    ImFont* const font = ui.fonts.label;
    const float size = font->FontSize / ui.framebuffer;
    for (const LabelSpot& spot : spots)
        if (const Label& label = labels[spot.label]; spot.leader)
            draw_leader(list, spot, colour(label.colour), colour(label.halo), ui.unit);
    list.PushTextureID(ui.fonts.label_halo->texture());
    for (const LabelSpot& spot : spots)
        if (const Label& label = labels[spot.label]; label.halo.a > 0)
            ui.fonts.label_halo->add(list, size, spot.text, colour(label.halo), label.text.c_str());
    list.PopTextureID();
    for (const LabelSpot& spot : spots) {
        const Label& label = labels[spot.label];
        const Area& b = spot.box;
        if (label.disc) list.AddCircleFilled({b.x + b.w / 2, b.y + b.h / 2}, spot.radius, colour(*label.disc), 32);
        list.AddText(font, size, spot.text, colour(label.colour), label.text.c_str());
    }
}

}  // namespace sightline
