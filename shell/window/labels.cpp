// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/labels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shell/window/halo.h"

namespace sightline {

namespace {

bool overlap(const Area& a, const Area& b) {
    return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

/// Rectangles by the tiles of a grid that they touch.
class TakenPlaces {
public:
    explicit TakenPlaces(const Area& area)
        : area_(area), columns_(count(area.w)), rows_(count(area.h)), tiles_(columns_ * rows_) {}

    bool is_free(const Area& box) const {
        bool free = true;
        visit(box, [&](std::size_t tile) {
            for (const Area& other : tiles_[tile]) free = free && !overlap(box, other);
        });
        return free;
    }
    void take(const Area& box) {
        visit(box, [&](std::size_t tile) { tiles_[tile].push_back(box); });
    }

private:
    static constexpr float side = 64;
    static std::size_t count(float extent) {
        return static_cast<std::size_t>(std::clamp(std::ceil(extent / side), 1.0f, 512.0f));
    }
    template <typename F>
    void visit(const Area& box, F f) const {
        const auto tile = [](float at, std::size_t most) {
            return static_cast<std::size_t>(std::clamp(at / side, 0.0f, static_cast<float>(most - 1)));
        };
        const std::size_t x1 = tile(box.x + box.w - area_.x, columns_), y1 = tile(box.y + box.h - area_.y, rows_);
        for (std::size_t y = tile(box.y - area_.y, rows_); y <= y1; ++y)
            for (std::size_t x = tile(box.x - area_.x, columns_); x <= x1; ++x) f(y * columns_ + x);
    }

    Area area_;
    std::size_t columns_, rows_;
    std::vector<std::vector<Area>> tiles_;
};

float kept_inside(float low, float extent, float frame_low, float frame_extent) {
    if (extent > frame_extent) return frame_low + (frame_extent - extent) / 2;
    return std::clamp(low, frame_low, frame_low + frame_extent - extent);
}

/// Where a label may stand, in shares of its room: at its point, or else a little beside it. The order is fixed.
constexpr std::array<std::array<float, 2>, 13> shifts{{{0, 0},
                                                       {0, -0.5f},
                                                       {0, 0.5f},
                                                       {-0.5f, 0},
                                                       {0.5f, 0},
                                                       {0, -1},
                                                       {0, 1},
                                                       {-1, 0},
                                                       {1, 0},
                                                       {-0.7f, -0.7f},
                                                       {0.7f, -0.7f},
                                                       {-0.7f, 0.7f},
                                                       {0.7f, 0.7f}}};

/// As in figures (shell/figure/label.h).
LabelSpot spot_of(const Label& label, std::size_t index, const ImVec2& anchor, const LabelPaper& paper) {
    const ImVec2 extent = paper.measure(label.text);
    ImVec2 centre{anchor.x + static_cast<float>(label.offset_pt.x) * paper.pt,
                  anchor.y - static_cast<float>(label.offset_pt.y) * paper.pt};
    LabelSpot spot{index, {}, {}, anchor, 0};
    if (label.disc) spot.radius = std::max(0.62f * extent.y, extent.x / 2 + 0.22f * extent.y);
    if (label.align == TextAlign::left) centre.x += extent.x / 2;
    if (label.align == TextAlign::right) centre.x -= extent.x / 2;
    const float margin = label.halo.a > 0 ? paper.halo : 1;
    // Letters fill about four fifths of a line's height.
    const float half_w = std::max(extent.x / 2 + margin, spot.radius),
                half_h = std::max(0.4f * extent.y + margin, spot.radius);
    const Area& area = paper.area;
    spot.box = {kept_inside(centre.x - half_w, 2 * half_w, area.x, area.w),
                kept_inside(centre.y - half_h, 2 * half_h, area.y, area.h), 2 * half_w, 2 * half_h};
    spot.text = {std::round(spot.box.x + half_w - extent.x / 2), std::round(spot.box.y + half_h - extent.y / 2)};
    return spot;
}

void draw_leader(ImDrawList& list, const LabelSpot& spot, ImU32 ink, ImU32 halo, float unit) {
    const Area& b = spot.box;
    if (b.contains(spot.anchor)) return;
    const ImVec2 centre{b.x + b.w / 2, b.y + b.h / 2};
    const ImVec2 d{spot.anchor.x - centre.x, spot.anchor.y - centre.y};
    const float across = d.x != 0 ? (b.w / 2 + unit) / std::abs(d.x) : 1,
                along = d.y != 0 ? (b.h / 2 + unit) / std::abs(d.y) : 1, share = std::min({across, along, 1.0f});
    const ImVec2 from{centre.x + d.x * share, centre.y + d.y * share};
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
    TakenPlaces places(paper.area);
    for (const Area& area : taken) places.take(area);
    std::vector<LabelSpot> spots;
    LabelMemory shown;
    const auto place_at = [&](std::size_t i, const ImVec2& anchor, const ImVec2& to, std::size_t shift) {
        LabelSpot spot = spot_of(labels[i], i, to, paper);
        spot.anchor = anchor;
        if (labels[i].yields && !places.is_free(spot.box)) return false;
        places.take(spot.box);
        spots.push_back(spot);
        shown.push_back({labels[i].at.x, labels[i].at.y, shift});
        return true;
    };
    /// From this one of its places on.
    const auto place = [&](std::size_t i, std::size_t first) {
        const Label& label = labels[i];
        const ImVec2 anchor = paper.to_window(label.at);
        if (!paper.area.contains(anchor)) return;
        const float room = paper.to_window(label.at + Vec<2>(label.room, 0)).x - anchor.x;
        const std::size_t count = room > 2 * paper.halo ? shifts.size() : 1;  // less would not help
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t shift = (first + k) % count;
            const ImVec2 to{anchor.x + shifts[shift][0] * room, anchor.y + shifts[shift][1] * room};
            if (place_at(i, anchor, to, shift)) return;
        }
    };
    const auto remembered = [&](const Label& label) {
        const auto found = std::lower_bound(memory.begin(), memory.end(), ShownLabel{label.at.x, label.at.y, 0});
        return found != memory.end() && found->x == label.at.x && found->y == label.at.y ? &*found : nullptr;
    };
    std::vector<std::size_t> later;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (!labels[i].yields) {
            const ShownLabel* const before = remembered(labels[i]);
            place(i, before ? before->shift : 0);
        }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!labels[i].yields) continue;
        if (const ShownLabel* const before = remembered(labels[i]))
            place(i, before->shift);
        else
            later.push_back(i);
    }
    for (const std::size_t i : later) place(i, 0);
    std::sort(shown.begin(), shown.end());
    memory = std::move(shown);
    return spots;
}

LabelPaper label_paper(const Ui& ui, const Area& area, std::function<ImVec2(const Vec<2>&)> to_window) {
    ImFont* const font = ui.fonts.label;
    const float size = font->FontSize / ui.framebuffer;
    return {area, 4.0f / 3 * ui.unit, 2 * ui.unit, std::move(to_window), [font, size](const std::string& text) {
                return font->CalcTextSizeA(size, 1e9f, 0, text.data(), text.data() + text.size());
            }};
}

void draw_labels(ImDrawList& list, const Ui& ui, std::span<const Label> labels, std::span<const LabelSpot> spots) {
    ImFont* const font = ui.fonts.label;
    const float size = font->FontSize / ui.framebuffer;
    for (const LabelSpot& spot : spots)
        if (const Label& label = labels[spot.label]; label.leader)
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
