// The chart of the trade-off panel: a line per method, a dot per budget, the line of the Pareto points under them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/base/number.h"
#include "core/run/budget.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"
#include "shell/window/timeline_lanes.h"
#include "shell/window/trade_off_plot.h"
#include "shell/window/variant_marks.h"

namespace sightline {

namespace {

constexpr Colour front_colour{200, 200, 200};

template <int D>
void progress_bar(Ui& ui, Workbench<D>& bench) {
    const TradeOff<D>& trade_off = bench.trade_off;
    const bool wrong = trade_off.shown == Measure::wrong;
    std::string wanted;
    if (ImGui::Button(wrong ? "wrong pixels" : "coverage")) wanted = wrong ? "trade-off coverage" : "trade-off wrong";
    note_place(bench, "trade-off measure");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Vertical axis; click to switch");
    ImGui::SameLine();
    if (!trade_off.study.finished()) {
        if (ImGui::Button(trade_off.stopped ? "continue" : "stop"))
            wanted = trade_off.stopped ? "trade-off go" : "trade-off stop";
        note_place(bench, trade_off.stopped ? "trade-off go" : "trade-off stop");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("values measured so far are kept");
        ImGui::SameLine();
        const std::size_t done = trade_off.study.done(), total = trade_off.study.total();
        ImGui::ProgressBar(total > 0 ? static_cast<float>(done) / static_cast<float>(total) : 0, {-1, 0}, "");
        // Over the whole bar: ImGui's own text walks along with it, and out of it.
        const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
        const std::string words = trade_off_progress_text(bench);
        const ImVec2 size = ImGui::CalcTextSize(words.c_str());
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.PushClipRect(from, to, true);
        list.AddText({std::max(from.x + 4 * ui.unit, (from.x + to.x - size.x) / 2), (from.y + to.y - size.y) / 2},
                     colour(theme::ink), words.c_str());
        list.PopClipRect();
        note_place(bench, "trade-off progress");
        if (const std::string work = trade_off_work_text(bench); !work.empty() && ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", work.c_str());
    } else {
        if (ImGui::Button("restart")) wanted = "trade-off restart";
        note_place(bench, "trade-off restart");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("discard all values and measure again");
    }
    if (!wanted.empty()) ui.act(wanted);
}

void draw_axes(ImDrawList& list, const Ui& ui, const TradeOffPlot& plot) {
    const Area& a = plot.area;
    list.AddRectFilled(a.min(), a.max(), colour(theme::paper));
    const float text = ImGui::GetFontSize() * 0.87f;
    float number = a.y + a.h + 2 * text;  // the last one's middle
    for (const TradeOffPlot::Tick& tick : plot.shares) {
        list.AddLine({a.x, tick.at}, {a.x + a.w, tick.at}, colour(theme::line));
        if (std::abs(tick.at - number) < 1.2f * text) continue;
        number = tick.at;
        small_text(list, ui, a.x - 4 * ui.unit, tick.at - text / 2, tick.text, theme::faint, 1);
    }
    float free_from = a.x - text;
    for (const TradeOffPlot::Tick& tick : plot.times) {
        list.AddLine({tick.at, a.y}, {tick.at, a.y + a.h}, colour(theme::line));
        const float half = small_width(ui, tick.text) / 2;
        if (tick.at - half < free_from || tick.at + half > a.x + a.w + 6 * ui.unit) continue;
        small_text(list, ui, tick.at, a.y + a.h + 2 * ui.unit, tick.text, theme::faint, 0.5f);
        free_from = tick.at + half + text / 2;
    }
    list.AddRect(a.min(), a.max(), colour(theme::line));
}

/// Front, lines and dots; the method of the session is drawn thicker, its dot ringed.
template <int D>
void draw_dots(ImDrawList& list, const Ui& ui, const Workbench<D>& bench, const TradeOffPlot& plot) {
    const TradeOffStudy<D>& study = bench.trade_off.study;
    const auto at = [&](std::size_t index) {
        return std::find_if(plot.dots.begin(), plot.dots.end(), [&](const auto& dot) { return dot.index == index; });
    };
    std::vector<ImVec2> front;
    for (const std::size_t index : pareto_dots(bench))
        if (const auto found = at(index); found != plot.dots.end()) front.push_back(found->at);
    list.AddPolyline(front.data(), static_cast<int>(front.size()), colour(front_colour), 0, 7 * ui.unit);
    for (const ImVec2& p : front) list.AddCircleFilled(p, 7 * ui.unit, colour(front_colour));
    const std::string now = current_variant(bench).text;
    const std::vector<VariantLook> looks = trade_off_looks(bench);
    for (std::size_t m = 0; m < study.task().variants.size(); ++m) {
        std::vector<ImVec2> line;
        for (const TradeOffPlot::Dot& dot : plot.dots)
            if (study.dots()[dot.index].variant == m) line.push_back(dot.at);
        draw_line(list, line, looks[m], (study.task().variants[m].text == now ? 3.0f : 1.5f) * ui.unit);
        for (const TradeOffPlot::Dot& dot : plot.dots) {
            if (study.dots()[dot.index].variant != m) continue;
            draw_marker(list, dot.at, looks[m], 4 * ui.unit, theme::paper);
            if (is_current(bench, study.dots()[dot.index]))
                list.AddCircle(dot.at, 8 * ui.unit, colour(theme::ink), 0, 2 * ui.unit);
        }
    }
}

/// Dots of the chart under the mouse: what they are, and a click.
template <int D>
void chart_mouse(Ui& ui, const Workbench<D>& bench, const TradeOffPlot& plot) {
    if (!ImGui::IsItemHovered()) return;
    const TradeOffPlot::Dot* const hit = dot_at(plot, ImGui::GetIO().MousePos, 9 * ui.unit);
    if (!hit) return;
    const TradeOffStudy<D>& study = bench.trade_off.study;
    const TradeOffDot& dot = study.dots()[hit->index];
    const Variant<D>& variant = study.task().variants[dot.variant];
    ImGui::GetWindowDrawList()->AddCircle(hit->at, 7 * ui.unit, colour(theme::accent), 0, 2 * ui.unit);
    const auto share = [&](Measure measure) { return short_number(100 * study.value(dot, measure)) + " %"; };
    ImGui::SetTooltip("%s at %s (%s)\n%s, wrong pixels %s, coverage %s\nclick to set this method and budget",
                      variant.text.c_str(), budget_text(dot.budget).c_str(),
                      variant.method.promise_with(variant.parameters) == Misses::may ? "approximate" : "conservative",
                      milliseconds_text(study.value(dot, Measure::total_ms)).c_str(), share(Measure::wrong).c_str(),
                      share(Measure::coverage).c_str());
    if (ImGui::IsItemDeactivated()) ui.act(trade_off_command(bench, dot));
}

/// A swatch and a name per variant, wrapped.
template <int D>
void key(const Ui& ui, const Workbench<D>& bench) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto& variants = bench.trade_off.study.task().variants;
    const std::string now = current_variant(bench).text;
    const float text = ImGui::GetFontSize(), swatch = 2.2f * text, gap = 0.8f * text;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float right = from.x + ImGui::GetContentRegionAvail().x;
    ImVec2 at = from;
    const auto entry = [&](const std::string& name, const VariantLook& look, float width, bool marker) {
        const float w = swatch + 4 * ui.unit + ImGui::CalcTextSize(name.c_str()).x;
        if (at.x > from.x && at.x + w > right) at = {from.x, at.y + 1.2f * text};
        const std::array ends{ImVec2{at.x, at.y + text / 2}, ImVec2{at.x + swatch, at.y + text / 2}};
        draw_line(list, ends, look, width);
        if (marker) draw_marker(list, {at.x + swatch / 2, at.y + text / 2}, look, 4 * ui.unit, theme::paper);
        list.AddText({at.x + swatch + 4 * ui.unit, at.y}, colour(theme::ink), name.c_str());
        at.x += w + gap;
    };
    const std::vector<VariantLook> looks = trade_off_looks(bench);
    for (std::size_t m = 0; m < variants.size(); ++m)
        entry(variants[m].text, looks[m], (variants[m].text == now ? 3.0f : 1.5f) * ui.unit, true);
    entry("Pareto points", {front_colour}, 7 * ui.unit, false);
    ImGui::Dummy({1, at.y + 1.3f * text - from.y});
    ImGui::PushStyleColor(ImGuiCol_Text, colour(theme::faint));
    ImGui::TextWrapped(
        "Each dot is one budget; the ringed dot is the current one. Click a dot to set its method and budget.");
    ImGui::PopStyleColor();
}

/// As much of it as there is room for.
std::string axis_title(const Ui& ui, Measure measure, float room) {
    const bool wrong = measure == Measure::wrong;
    const std::string brief = wrong ? "wrong pixels, %" : "coverage, %";
    const std::string whole = brief + (wrong ? ": lower is better" : ": higher is better");
    return small_width(ui, whole) <= room ? whole : brief;
}

}  // namespace

template <int D>
void trade_off_chart(Ui& ui, Workbench<D>& bench) {
    if (!bench.trade_off.study.task().scene) return;
    progress_bar(ui, bench);
    const float text = ImGui::GetFontSize(), left = 2.6f * text, under = 2.5f * text;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float w = std::max(ImGui::GetContentRegionAvail().x, 8 * text),
                h = std::max(std::min(0.62f * w, 0.5f * ImGui::GetContentRegionAvail().y), 8 * text);
    ImGui::InvisibleButton("trade-off", {w, h});
    note_place(bench, "trade-off chart");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const TradeOffPlot plot =
        trade_off_plot(bench, {at.x + left, at.y + 1.3f * text, w - left - 6 * ui.unit, h - under - 1.3f * text});
    draw_axes(list, ui, plot);
    small_text(list, ui, at.x, at.y, axis_title(ui, bench.trade_off.shown, w).c_str(), theme::ink);
    small_text(list, ui, at.x + w, at.y + h - 1.1f * text, trade_off_time_text(bench), theme::ink, 1);
    if (plot.dots.empty())
        small_text(list, ui, plot.area.x + plot.area.w / 2, plot.area.y + plot.area.h / 2, "nothing measured yet",
                   theme::faint, 0.5f);
    draw_dots(list, ui, bench, plot);
    chart_mouse(ui, bench, plot);
    const float dot = 8 * ui.unit;
    for (const TradeOffPlot::Dot& d : plot.dots)
        bench.places.push_back({"dot " + trade_off_command(bench, bench.trade_off.study.dots()[d.index]).substr(10),
                                d.at.x - dot / 2, d.at.y - dot / 2, dot, dot});
    key(ui, bench);
}

template void trade_off_chart<2>(Ui&, Workbench<2>&);
template void trade_off_chart<3>(Ui&, Workbench<3>&);

}  // namespace sightline
