// The bar under the picture: play and step, how much is found so far, and where in the run it stands.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/number.h"
#include "core/draw/palette.h"
#include "core/session/headline.h"
#include "shell/desk/moves.h"
#include "shell/desk/play.h"
#include "shell/window/buttons.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"
#include "shell/window/wrap.h"

namespace sightline {

namespace {

template <int D>
void step_buttons(Ui& ui, Workbench<D>& bench) {
    struct Button {
        const char *id, *command, *tip;
        Icon icon;
        bool enabled;
    };
    const bool playing = transport_state(bench) == TransportState::playing;
    const bool begun = bench.session.position() > 0, ended = bench.session.position() >= bench.session.recorded();
    const std::array buttons{
        Button{"##start", "seek start", "to the start (Home)", Icon::start, begun},
        Button{"##back", "back", "one step back (Left, PageUp); ten: Shift+Left", Icon::back, begun},
        Button{"##toggle", "toggle", playing ? "pause (Space)" : "play (Space); the whole run in 20 seconds: Y",
               playing ? Icon::pause : Icon::play, true},
        Button{"##step", "step", "one step forward (Right, PageDown); ten: Shift+Right", Icon::step, !ended},
        Button{"##end", "run", "to the end (End)", Icon::end, !ended},
    };
    for (const Button& button : buttons) {
        if (icon_button(button.id, button.icon, button.enabled, button.tip)) ui.act(button.command);
        note_place(bench, "button " + std::string(button.command));
        ImGui::SameLine(0, 3 * ui.unit);
    }
}

/// Where the run stands, as wide as at its end.
template <int D>
std::string position_text(const Session<D>& s) {
    if (s.flying()) return "not recorded";
    return "step " + std::to_string(s.position()) + " of " + std::to_string(s.recorded());
}

/// A curve over the steps, in the plot.
struct Plot {
    Area area;
    std::size_t steps;

    float x(double step) const { return area.x + static_cast<float>(step / static_cast<double>(steps)) * area.w; }
    float y(double share) const { return area.y + (1 - static_cast<float>(share)) * area.h; }
};

void curve(ImDrawList& list, const Plot& plot, const std::vector<double>& shares, bool dotted, float width, ImU32 c) {
    const int columns = std::max(1, static_cast<int>(plot.area.w));
    ImVec2 before{plot.area.x, plot.y(0)};
    for (int column = 1; column <= columns; ++column) {
        const double at = static_cast<double>(column) / columns * static_cast<double>(shares.size());
        const std::size_t step = std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(at)), 1, shares.size());
        const double share = shares[step - 1];
        if (!std::isfinite(share)) continue;
        const ImVec2 now{plot.x(at * static_cast<double>(plot.steps) / static_cast<double>(shares.size())),
                         plot.y(share)};
        if (!dotted || column / 3 % 2 == 0) list.AddLine(before, now, c, width);
        before = now;
    }
}

/// Ticks under steps that drew what nobody sees, and nothing else.
void wasted(ImDrawList& list, const Plot& plot, const TimelineData& data, float unit, ImU32 c) {
    const auto& visible = data.values[static_cast<std::size_t>(Curve::visible)];
    const auto& hidden = data.values[static_cast<std::size_t>(Curve::hidden)];
    float end = -1;
    for (std::size_t step = 0; step < hidden.size(); ++step) {
        if (visible[step] > 0 || !(hidden[step] > 0)) continue;
        const float x0 = std::max(end, plot.x(static_cast<double>(step))),
                    x1 = std::max(plot.x(static_cast<double>(step) + 1) - unit, x0 + unit);
        if (x1 <= end) continue;
        list.AddRectFilled({x0, plot.area.y + plot.area.h - 3 * unit}, {x1, plot.area.y + plot.area.h}, c);
        end = x1;
    }
}

/// The mouse goes to the step under it.
template <int D>
void seek_under_mouse(Ui& ui, Workbench<D>& bench, const Plot& plot) {
    const float share = std::clamp((ImGui::GetIO().MousePos.x - plot.area.x) / plot.area.w, 0.0f, 1.0f);
    const auto step = static_cast<std::uint32_t>(std::lround(share * static_cast<float>(plot.steps)));
    if (ImGui::IsItemActive() && (step != bench.session.position() || bench.substep)) {
        pause(bench);
        go_to_step(bench, step);
        ++ui.revision;
    }
    if (!ImGui::IsItemHovered()) return;
    if (step > 0) ui.hovering = ui.timeline.cell[step - 1];
    const double found = step > 0 ? ui.timeline.values[static_cast<std::size_t>(Curve::coverage)][step - 1] : 0;
    const bool tells = tells_truth(bench.session) && std::isfinite(found);
    ImGui::SetTooltip("step %u%s", step, tells ? (", " + short_number(100 * found) + " % found").c_str() : "");
}

template <int D>
void track(Ui& ui, Workbench<D>& bench, const Area& area) {
    ImGui::SetCursorScreenPos(area.min());
    ImGui::InvisibleButton("scrubber", {area.w, area.h});
    note_place(bench, "scrubber");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(area.min(), area.max(), colour(theme::paper));
    list.AddRect(area.min(), area.max(), colour(theme::line));
    const float pad = 2 * ui.unit;
    TimelineData& data = ui.timeline;
    const bool any = update_run(data, bench);
    if (!any || bench.session.flying()) return;
    const Plot plot{{area.x + pad, area.y + pad, area.w - 2 * pad, area.h - 2 * pad}, data.cell.size()};
    const auto of = [&](Curve which) -> const std::vector<double>& {
        return data.values[static_cast<std::size_t>(which)];
    };
    if (tells_truth(bench.session)) {
        const Colours& palette = colours(bench.session.settings().palette);
        wasted(list, plot, data, ui.unit, colour(palette.looks[static_cast<std::size_t>(Look::wasted)].stroke));
        curve(list, plot, of(Curve::oracle), true, ui.unit, colour(theme::faint));
        if (!data.other_coverage.empty())
            curve(list, {plot.area, std::max(plot.steps, data.other_coverage.size())}, data.other_coverage, false,
                  1.5f * ui.unit, colour(theme::paused));
        curve(list, plot, of(Curve::coverage), false, 2 * ui.unit, colour(theme::ink));
    }
    const float x = plot.x(bench.session.position());
    list.AddLine({x, area.y}, {x, area.y + area.h}, colour(theme::accent), 2 * ui.unit);
    list.AddTriangleFilled({x - 5 * ui.unit, area.y}, {x + 5 * ui.unit, area.y}, {x, area.y + 7 * ui.unit},
                           colour(theme::accent));
    seek_under_mouse(ui, bench, plot);
}

}  // namespace

template <int D>
void scrubber(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_part("transport", area);
    const Session<D>& session = bench.session;
    step_buttons(ui, bench);
    const std::string position = position_text(session);
    const std::string widest = "step " + std::string(std::to_string(session.recorded()).size(), '0') + " of " +
                               std::to_string(session.recorded());
    const float gap = 10 * ui.unit, padding = 2 * ImGui::GetStyle().FramePadding.x;
    const float text = std::max(ImGui::CalcTextSize(widest.c_str()).x, ImGui::CalcTextSize(position.c_str()).x);
    const char* const more = bench.desk.timeline ? "less" : "more";
    const float button = ImGui::CalcTextSize(more).x + padding;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float behind = area.x + area.w - ImGui::GetStyle().WindowPadding.x - at.x - text - gap;
    const bool has_button = behind > button + 2 * gap;  // its key is there in any case
    const float room = behind - (has_button ? button + 2 * gap : gap);
    if (room > 40 * ui.unit) track(ui, bench, {at.x + gap, at.y, room, ImGui::GetFrameHeight()});
    ImGui::SetCursorScreenPos({at.x + std::max(room, 0.0f) + (has_button ? 2 : 1) * gap, at.y});
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shortened(position, text + std::min(room, 0.0f), width_of_line).c_str());
    const std::string state =
        session.flying() ? "flying" : std::string(transport_words[static_cast<std::size_t>(transport_state(bench))]);
    note_place(bench, "state " + state);
    if (!has_button) return ImGui::End();
    ImGui::SameLine(0, gap);
    if (ImGui::Button(more)) ui.act("show timeline");
    note_place(bench, "button show timeline");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", bench.desk.timeline ? "only this bar (Tab)" : "the whole timeline (Tab)");
    ImGui::End();
}

template void scrubber<2>(Ui&, Workbench<2>&, const Area&);
template void scrubber<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
