// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/labels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/draw/label_place.h"
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

Vec<2> vec(const ImVec2& p) { return {p.x, p.y}; }
ImVec2 window(const Vec<2>& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }
Box<2> box_of(const Area& a) { return {vec(a.min()), vec(a.max())}; }

LabelSpot spot_of(const Label& label, std::size_t index, const ImVec2& anchor, const LabelPaper& paper) {
    const ImVec2 extent = paper.measure(label.text);
    const Vec<2> point = vec(anchor) + Vec<2>(label.offset_pt.x, -label.offset_pt.y) * double{paper.pt};
    LabelSpot spot{index, {}, {}, anchor, 0};
    if (label.disc) spot.radius = std::max(0.62f * extent.y, extent.x / 2 + 0.22f * extent.y);
    const float margin = label.halo.a > 0 ? paper.halo : 1;
    // Letters fill about four fifths of a line's height.
    const LabelSize size{extent.x, 0.4f * extent.y + margin, margin, spot.radius};
    const Box<2> box = label_box(label, point, size, box_of(paper.area));
    const ImVec2 low = window(box.min), across = window(box.extent()), centre = window(box.centre());
    spot.box = {low.x, low.y, across.x, across.y};
    spot.text = {std::round(centre.x - extent.x / 2), std::round(centre.y - extent.y / 2)};
    return spot;
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
