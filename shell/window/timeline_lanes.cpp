// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_lanes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/number.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Values to heights of one lane.
struct Scale {
    float zero = 0;      ///< y of the value 0
    float per_unit = 0;  ///< of y, per unit of value upward
    float y(double value) const { return zero - static_cast<float>(value) * per_unit; }
};

Scale fit(const Area& lane, double low, double high, float pad) {
    const double range = high - low;
    const float room = lane.h - 2 * pad;
    if (!(range > 0)) return {lane.y + lane.h - pad, 0};
    const float per_unit = room / static_cast<float>(range);
    return {lane.y + pad + static_cast<float>(high) * per_unit, per_unit};
}

Colour with_alpha(Colour c, std::uint8_t alpha) {
    c.a = alpha;
    return c;
}

const Colour& stroke(const Colours& colours, Look look) { return colours.looks[static_cast<std::size_t>(look)].stroke; }
const Colour& fill(const Colours& colours, Look look) { return colours.looks[static_cast<std::size_t>(look)].fill; }

const std::vector<LaneSpan>& spans(const TimelineData& data, Curve curve) {
    return data.spans[static_cast<std::size_t>(curve)];
}
double lowest(const TimelineData& data, Curve curve) { return data.lowest[static_cast<std::size_t>(curve)]; }
double highest(const TimelineData& data, Curve curve) { return data.highest[static_cast<std::size_t>(curve)]; }

/// From zero to the largest value, upward or (sign -1) downward; wide ones stand apart.
void bars(ImDrawList& list, const std::vector<LaneSpan>& all, const Scale& scale, float sign, float unit, ImU32 c) {
    for (const LaneSpan& span : all) {
        if (span.high == 0) continue;
        const float apart = span.x1 - span.x0 > 4 * unit ? unit : 0, end = scale.y(sign * span.high);
        list.AddRectFilled({span.x0, std::min(scale.zero, end)},
                           {std::max(span.x1 - apart, span.x0 + unit), std::max(scale.zero, end)}, c);
    }
}

/// A line that holds each value over its span and joins it to the one before.
void staircase(ImDrawList& list, const std::vector<LaneSpan>& all, const Scale& scale, float width, ImU32 c) {
    const LaneSpan* before = nullptr;
    for (const LaneSpan& span : all) {
        const bool joins = before && before->x1 >= span.x0 - 0.5f;
        const float low = scale.y(span.low), high = scale.y(span.high);
        const float from = joins ? std::min(high, scale.y(before->low)) : high;
        const float to = joins ? std::max(low, scale.y(before->high)) : low;
        list.AddRectFilled({span.x0, high - width / 2}, {std::max(span.x1, span.x0 + width), low + width / 2}, c);
        if (from < high || to > low)
            list.AddRectFilled({span.x0, from - width / 2}, {span.x0 + width, to + width / 2}, c);
        before = &span;
    }
}

/// Every second stretch of the line only.
void dashed(ImDrawList& list, const std::vector<LaneSpan>& all, const Scale& scale, float width, float dash, ImU32 c) {
    for (const LaneSpan& span : all) {
        const float y = scale.y(span.high);
        for (float x = std::floor(span.x0 / (2 * dash)) * 2 * dash; x < span.x1; x += 2 * dash) {
            const float a = std::max(x, span.x0), b = std::min(x + dash, span.x1);
            if (a < b) list.AddRectFilled({a, y - width / 2}, {b, y + width / 2}, c);
        }
    }
}

/// Largest value at the top and the smallest at the bottom, where there is room for both.
void scale_labels(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const Area& lane,
                  const std::string& top, const std::string& bottom) {
    const float right = lane.x - 5 * ui.unit;
    if (top == bottom) return small_text(list, ui, right, lane.y + (lane.h - layout.text) / 2, top, theme::faint, 1);
    small_text(list, ui, right, lane.y, top, theme::faint, 1);
    if (lane.h >= 2 * layout.text) small_text(list, ui, right, lane.y + lane.h - layout.text, bottom, theme::faint, 1);
}

struct KeyRow {
    const char* text;
    Colour colour;
    bool dashed = false;
};

/// Half the width of the handle, which holds the number of the step.
float handle_half(const Ui& ui, const TimelineData& data) {
    return std::max(small_width(ui, std::to_string(data.position)) / 2 + 4 * ui.unit, 8 * ui.unit);
}

/// The lane's titles, each with a sample of its colour, spread over the height.
void titles(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const Area& lane,
            std::initializer_list<KeyRow> rows, const Colour& background) {
    const float x = layout.header.x, sample = 12 * ui.unit;
    const auto n = static_cast<float>(rows.size());
    if (lane.h < 0.8f * n * layout.text) return;  // its tooltip is left
    const float line = std::min(layout.text, lane.h / n);
    float y = lane.y + (lane.h - n * line) / 2;
    for (const KeyRow& row : rows) {
        const float middle = y + line / 2, half = 3.5f * ui.unit;
        list.AddRectFilled({x, middle - half}, {x + sample, middle + half}, colour(background));
        if (row.dashed) {
            for (const float at : {1.0f, 5.0f, 9.0f})
                list.AddRectFilled({x + at * ui.unit, middle - ui.unit}, {x + (at + 2.4f) * ui.unit, middle + ui.unit},
                                   colour(row.colour));
        } else {
            list.AddRectFilled({x + ui.unit, middle - half + ui.unit}, {x + sample - ui.unit, middle + half - ui.unit},
                               colour(row.colour));
        }
        small_text(list, ui, x + sample + 5 * ui.unit, y + (line - layout.text) / 2, row.text, theme::ink);
        y += line;
    }
}

}  // namespace

TimelineLayout timeline_layout(const Ui& ui, const Area& area) {
    TimelineLayout layout;
    const float unit = ui.unit, gap = 3 * unit;
    layout.text = std::round(ImGui::GetFontSize() * 0.87f);
    layout.mark_row = std::round(layout.text * 0.72f);
    const float left = std::min(13.2f * layout.text, area.w * 0.3f);
    const float plot = area.x + left, w = std::max(area.w - left, 1.0f);
    layout.header = {area.x, area.y, left, area.h};
    layout.ruler = {plot, area.y, w, layout.text + 5 * unit};
    layout.budgets = {plot, layout.ruler.y + layout.ruler.h, w, layout.text + 2 * unit};
    layout.marks = {plot, layout.budgets.y + layout.budgets.h, w, mark_rows * layout.mark_row + 2 * unit};
    std::array share{1.45f, 1.0f, 1.0f, 1.15f};
    const float top = layout.marks.y + layout.marks.h + gap, room = area.y + area.h - top;
    // Two titles need two lines.
    const float both = 2 * (1.8f * layout.text + gap), one = layout.text + gap;
    if (room < both + 2 * one) share[TimelineLayout::front] = 0;
    if (room < both + one) share[TimelineLayout::key] = 0;
    const float whole = std::accumulate(share.begin(), share.end(), 0.0f);
    float y = top;
    for (std::size_t i = 0; i < share.size(); ++i) {
        const float h = share[i] == 0 ? 0 : std::max(std::floor(room * share[i] / whole - gap), unit);
        layout.lanes[i] = {plot, y, w, h};
        if (h > 0) y += h + gap;
    }
    return layout;
}

void small_text(ImDrawList& list, const Ui& ui, float x, float y, const std::string& text, const Colour& c,
                float align) {
    const float size = std::round(ImGui::GetFontSize() * 0.87f);
    list.AddText(ui.fonts.text, size, {std::round(x - align * small_width(ui, text)), std::round(y)}, colour(c),
                 text.c_str());
}

float small_width(const Ui& ui, const std::string& text) {
    return ui.fonts.text->CalcTextSizeA(std::round(ImGui::GetFontSize() * 0.87f), 1e6f, 0, text.c_str()).x;
}

void draw_mark(ImDrawList& list, MarkShape shape, const ImVec2& at, float side, ImU32 c) {
    const float r = side / 2;
    switch (shape) {
        case MarkShape::triangle:
            return list.AddTriangleFilled({at.x, at.y - r}, {at.x + r, at.y + r}, {at.x - r, at.y + r}, c);
        case MarkShape::diamond:
            return list.AddQuadFilled({at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}, c);
        case MarkShape::ring:
            return list.AddCircle(at, r * 0.8f, c, 12, r * 0.45f);
        case MarkShape::cross:
            list.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, c, r * 0.5f);
            return list.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, c, r * 0.5f);
        case MarkShape::disc:
            return list.AddCircleFilled(at, r, c, 12);
        case MarkShape::flag:
            list.AddRectFilled({at.x - r * 0.3f, at.y - r}, {at.x + r * 0.1f, at.y + r}, c);
            return list.AddTriangleFilled({at.x, at.y - r}, {at.x + 1.3f * r, at.y - r * 0.3f}, {at.x, at.y + r * 0.4f},
                                          c);
    }
}

void draw_lanes(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data,
                const Colours& colours) {
    const float unit = ui.unit, pad = 2 * unit, line = 1.6f * unit;
    for (const Area& lane : layout.lanes) list.AddRectFilled(lane.min(), lane.max(), colour(colours.background));

    const Area& rendered = layout.lanes[TimelineLayout::rendered];
    const double up = highest(data, Curve::visible), down = highest(data, Curve::hidden);
    const Scale both = fit(rendered, -down, up, pad);
    const Colour &visible = stroke(colours, Look::rendered), &hidden = stroke(colours, Look::wasted);
    bars(list, spans(data, Curve::visible), both, 1, unit, colour(visible));
    bars(list, spans(data, Curve::hidden), both, -1, unit, colour(hidden));
    list.AddLine({rendered.x, both.zero}, {rendered.x + rendered.w, both.zero}, colour(theme::faint), unit);
    titles(list, ui, layout, rendered, {{"new, visible", visible}, {"new, hidden", hidden}}, colours.background);
    scale_labels(list, ui, layout, rendered, short_number(up), short_number(down));

    if (const Area& key = layout.lanes[TimelineLayout::key]; key.h > 0) {
        const double low = lowest(data, Curve::key), high = highest(data, Curve::key);
        const Colour& last = stroke(colours, Look::last);
        staircase(list, spans(data, Curve::key), fit(key, low, high, pad), line, colour(last));
        titles(list, ui, layout, key, {{"popped key", last}}, colours.background);
        scale_labels(list, ui, layout, key, short_number(high), short_number(low));
    }
    if (const Area& front = layout.lanes[TimelineLayout::front]; front.h > 0) {
        const Colour& enqueued = fill(colours, Look::enqueued);
        const double high = highest(data, Curve::front);
        bars(list, spans(data, Curve::front), fit(front, 0, high, pad), 1, unit, colour(enqueued));
        titles(list, ui, layout, front, {{"front size", enqueued}}, colours.background);
        scale_labels(list, ui, layout, front, short_number(high), "0");
    }
    const Area& coverage = layout.lanes[TimelineLayout::coverage];
    const Colour& best = stroke(colours, Look::other);
    if (spans(data, Curve::coverage).empty()) {
        small_text(list, ui, coverage.x + 6 * unit, coverage.y + (coverage.h - layout.text) / 2,
                   "no primitive is visible: no coverage", colours.ink);
    } else {
        const Scale share = fit(coverage, 0, 1, pad);
        dashed(list, spans(data, Curve::oracle), share, line, 4 * unit, colour(best));
        staircase(list, spans(data, Curve::coverage), share, line, colour(visible));
    }
    titles(list, ui, layout, coverage, {{"coverage", visible}, {"oracle", best, true}}, colours.background);
    scale_labels(list, ui, layout, coverage, "1", "0");
    for (const Area& lane : layout.lanes)
        if (lane.h > 0) list.AddRect(lane.min(), lane.max(), colour(theme::line), 0, 0, unit);
}

void draw_ruler(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data) {
    const Area& ruler = layout.ruler;
    const float unit = ui.unit, foot = ruler.y + ruler.h;
    const auto width = [&](const std::string& text) { return small_width(ui, text); };
    list.AddLine({ruler.x, foot}, {ruler.x + ruler.w, foot}, colour(theme::faint), unit);
    for (const BudgetTick& budget : data.budgets) {
        const float x = x_of_step(data.axis, budget.step);
        if (x < ruler.x || x > ruler.x + ruler.w) continue;
        for (float y = foot; y < layout.bottom(); y += 5 * unit)
            list.AddRectFilled({x - unit / 2, y}, {x + unit / 2, std::min(y + 2 * unit, layout.bottom())},
                               colour(theme::faint));
    }
    for (const RulerLabel& label : budget_labels(data.axis, data.budgets, width, 9 * unit)) {
        const Area& row = layout.budgets;
        list.AddRectFilled({label.left - 3 * unit, row.y + unit}, {label.left + label.w + 3 * unit, row.y + row.h},
                           colour(theme::lit), 2 * unit);
        small_text(list, ui, label.left, row.y, label.text, theme::ink);
    }
    if (!data.budgets.empty())
        small_text(list, ui, layout.header.x, layout.budgets.y, "budget of primitives", theme::faint);
    for (const RulerLabel& label : ruler_labels(data.axis, width, 9 * unit)) {
        const bool number = label.kind == RulerLabel::Kind::number;
        const float y = ruler.y, handle = x_of_step(data.axis, data.position), half = handle_half(ui, data);
        if (label.left - 3 * unit < handle + half && label.left + label.w + 3 * unit > handle - half) continue;
        small_text(list, ui, label.left, y, label.text, number ? theme::faint : theme::ink);
        list.AddRectFilled({label.at - unit / 2, foot - 4 * unit}, {label.at + unit / 2, foot}, colour(theme::faint));
    }
    const float end = x_of_step(data.axis, static_cast<std::uint32_t>(data.cell.size()));
    if (end <= ruler.x + ruler.w + 0.5f)
        list.AddRectFilled({end - unit, foot}, {end + unit, layout.bottom()}, colour(theme::ink));
}

void draw_marks(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data) {
    const float row = layout.mark_row, side = row - 2 * ui.unit, top = layout.marks.y + ui.unit;
    list.AddRectFilled(layout.marks.min(), layout.marks.max(), colour(theme::paper));
    for (const MarkGroup& group : data.groups) {
        const MarkLook& how = look(group.kind);
        const ImVec2 centre{group.x, top + (static_cast<float>(how.row) + 0.5f) * row};
        if (!group.crowded && group.count == 1) {
            draw_mark(list, how.shape, centre, side, colour(how.colour));
            continue;
        }
        const auto alpha = static_cast<std::uint8_t>(std::min(255u, 70 + 60 * group.count));
        list.AddRectFilled({centre.x - ui.unit, centre.y - side / 2}, {centre.x + ui.unit, centre.y + side / 2},
                           colour(with_alpha(how.colour, alpha)));
    }
    const float x = layout.header.x, second = 5.6f * layout.text;
    const auto key = [&](MarkKind kind, const char* word, int column, int line) {
        const float h = layout.marks.h / 3, left = x + (column == 0 ? 0 : second);
        const float y = layout.marks.y + static_cast<float>(line) * h;
        draw_mark(list, look(kind).shape, {left + 5 * ui.unit, y + h / 2}, side, colour(look(kind).colour));
        small_text(list, ui, left + 13 * ui.unit, y + (h - layout.text) / 2, word, theme::ink);
    };
    key(MarkKind::penalty, "penalty", 0, 0);
    key(MarkKind::mis_ranked, "mis-ranked", 1, 0);
    key(MarkKind::unreached, "unreached", 1, 1);
    key(MarkKind::first_wrong, "wrong", 0, 1);
    key(MarkKind::pop, "pop", 0, 2);
    key(MarkKind::bookmark, "bookmarks", 1, 2);
}

void draw_position(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data,
                   const Colours& colours) {
    const float unit = ui.unit, right = layout.ruler.x + layout.ruler.w;
    const float x = std::clamp(x_of_step(data.axis, data.position), layout.ruler.x, right);
    for (const Area& lane : layout.lanes) {
        const bool words = &lane == &layout.lanes.back() && spans(data, Curve::coverage).empty();
        if (!words)
            list.AddRectFilled({x, lane.y}, {right, lane.y + lane.h}, colour(with_alpha(colours.background, 150)));
    }
    const float at = x_of_step(data.axis, data.position);
    if (at < layout.ruler.x - 1 || at > right + 1) return;
    list.AddRectFilled({x - unit, layout.ruler.y}, {x + unit, layout.bottom()}, colour(theme::accent));
    const std::string text = std::to_string(data.position);
    const float half = handle_half(ui, data), foot = layout.ruler.y + layout.text + unit;
    const float middle = std::min(x, right + 8 * unit - half);  // at the end of the run it stays in the window
    list.AddRectFilled({middle - half, layout.ruler.y}, {middle + half, foot}, colour(theme::accent), 3 * unit);
    list.AddTriangleFilled({x - 5 * unit, foot - unit}, {x + 5 * unit, foot - unit}, {x, foot + 5 * unit},
                           colour(theme::accent));
    small_text(list, ui, middle, layout.ruler.y, text, {255, 255, 255}, 0.5f);
}

void draw_hovered_step(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data,
                       std::uint32_t step) {
    const float right = layout.ruler.x + layout.ruler.w, x1 = std::min(x_of_step(data.axis, step), right);
    const float x0 = std::max(step > 0 ? x_of_step(data.axis, step - 1) : x1, layout.ruler.x);
    list.AddRectFilled({x0, layout.marks.y}, {std::max(x1, x0 + ui.unit), layout.bottom()},
                       colour(with_alpha(theme::accent, 45)));
    list.AddRectFilled({x1 - ui.unit / 2, layout.marks.y}, {x1 + ui.unit / 2, layout.bottom()}, colour(theme::accent));
}

void draw_step_of_cell(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data,
                       std::uint32_t cell) {
    if (cell == none || cell >= data.step_of_cell.size() || data.step_of_cell[cell] == 0) return;
    const float x = middle_of_step(data.axis, data.step_of_cell[cell]), s = 6 * ui.unit, y = layout.bottom();
    if (x < layout.ruler.x || x > layout.ruler.x + layout.ruler.w) return;
    list.AddTriangleFilled({x, y - 1.6f * s}, {x + s, y}, {x - s, y}, IM_COL32_WHITE);
    list.AddTriangleFilled({x, y - 1.3f * s}, {x + 0.75f * s, y - ui.unit}, {x - 0.75f * s, y - ui.unit},
                           colour(theme::bad));
}

}  // namespace sightline
