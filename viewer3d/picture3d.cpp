// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/picture3d.h"

#include <SDL_scancode.h>

#include <algorithm>
#include <cmath>

#include "core/draw/cell_number.h"
#include "core/draw/palette.h"
#include "core/draw/projection.h"
#include "core/measure/metrics.h"
#include "core/number.h"
#include "core/session/substep.h"
#include "shell/bench/camera.h"
#include "shell/bench/flight.h"
#include "shell/bench/into.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// The part of the area that a pane has: all of it, or one half.
Area pane_area(const Area& area, std::size_t pane, std::size_t count) {
    if (count == 1) return area;
    constexpr float gap = 3;
    const float w = std::floor((area.w - gap) / 2);
    return {pane == 0 ? area.x : area.x + area.w - w, area.y, w, area.h};
}

struct FlightKey {
    const char* name;
    int scancode;
    Vec<3> direction;  ///< right, up, forward
};
constexpr double run_factor = 4;  ///< with Shift
/// A flying eye that rests this long is measured against the exact image.
constexpr float rest_seconds = 0.3f;

const std::array<FlightKey, 6> flight_keys{{{"W", SDL_SCANCODE_W, {0, 0, 1}},
                                            {"S", SDL_SCANCODE_S, {0, 0, -1}},
                                            {"A", SDL_SCANCODE_A, {-1, 0, 0}},
                                            {"D", SDL_SCANCODE_D, {1, 0, 0}},
                                            {"E", SDL_SCANCODE_E, {0, 1, 0}},
                                            {"Q", SDL_SCANCODE_Q, {0, -1, 0}}}};

void text_box(ImDrawList& list, const Ui& ui, const Palette palette, const ImVec2& at, const std::string& text,
              bool bold) {
    ImFont* const font = bold ? ui.fonts.bold : ui.fonts.text;
    const float size = font->FontSize / ui.framebuffer, pad = 6 * ui.unit;
    const ImVec2 extent = font->CalcTextSizeA(size, 1e9f, 0, text.c_str());
    Colour paper = colours(palette).background;
    paper.a = 225;
    list.AddRectFilled(at, {at.x + extent.x + 2 * pad, at.y + extent.y + pad}, colour(paper));
    list.AddText(font, size, {at.x + pad, at.y + pad / 2}, colour(colours(palette).ink), text.c_str());
}

}  // namespace

const Session<3>& Picture3d::session_of(std::size_t pane) const {
    return pane == 0 ? bench_.session : bench_.other->session;
}

bool Picture3d::takes_key(const std::string& key) const {
    return bench_.flight.on && std::any_of(flight_keys.begin(), flight_keys.end(), [&](const FlightKey& k) {
               return key == k.name || key == std::string("Shift+") + k.name;
           });
}

void Picture3d::fly(Ui& ui, float seconds) {
    Flight<3>& flight = bench_.flight;
    if (flight.replaying) {
        if (flight.frame + 1 >= flight.path.frames.size()) {
            flight.replaying = false;
            land(bench_);
        } else {
            go_to_frame(bench_, flight.frame + 1);
        }
        ++ui.revision;
        return;
    }
    if (!flight.on || ImGui::GetIO().WantTextInput) return;
    Vec<3> by(0);
    for (const FlightKey& key : flight_keys)
        if (ImGui::IsKeyDown(key.scancode)) by += key.direction;
    rested_ = by == Vec<3>(0) ? rested_ + seconds : 0;
    if (rested_ > rest_seconds && bench_.session.flying() && !bench_.session.has_reference()) {
        bench_.session.reference();
        ++ui.revision;
    }
    if (by == Vec<3>(0)) return;
    const double speed = flight_speed(bench_) * (ImGui::GetIO().KeyShift ? run_factor : 1);
    fly_to(bench_, walked(bench_.session.display_view(), bench_.session.scene().up_axis, by * (speed * seconds)),
           "flight");
    ++ui.revision;
}

void Picture3d::update(const Ui& ui, const Area& area) {
    if (sides_revision_ != ui.revision) {
        sides_revision_ = ui.revision;
        sides_ = bench_.other ? projected_sides(bench_.session, bench_.other->session) : std::vector<Side>();
    }
    const Shown<3> shown(bench_);
    for (std::size_t i = 0; i < pane_count(); ++i) {
        const Session<3>& session = i == 0 ? *shown : session_of(i);
        const CellNumber what = session.settings().heat;
        HeatRange& heat = heat_[i];
        if (heat.run != bench_.run || heat.what != what)
            heat = {bench_.run, what,
                    what == CellNumber::none || session.flying() ? std::nullopt : number_range(session_of(i), what)};
        const Area part = pane_area(area, i, pane_count());
        PictureOptions3 options;
        options.heat_range = heat.range;
        options.aspect = part.w / part.h;
        options.sides = sides_;
        if (i == 0 && bench_.substep && *bench_.substep >= first_facet_substep)
            options.facet = *bench_.substep - first_facet_substep;
        panes_[i].update(ui, session, options, ui.revision, bench_.run, part, bench_.desk.projector,
                         i == 0 && bench_.desk.legend, mouse_.dragging() || lively());
        insets_[i].update(session, ui.revision);
    }
    bench_.flight.draw_ms = panes_[0].draw_ms();
}

/// What the frame costs and finds, always in sight.
void Picture3d::draw_counters(const Ui& ui, const Area& area, const Session<3>& session) {
    const State<3>& state = session.state();
    std::string text = std::to_string(state.rendered_count) + " triangles, " + std::to_string(state.step) +
                       (session.method().orders_cells ? " cells" : " batches");
    if (session.has_reference()) {
        const auto share = coverage(session.reference(), session.visible_rendered());
        text +=
            ", coverage " + (share ? short_number(100 * *share) + " %" : std::string("none")) + ", wrong pixels " +
            short_number(100 * wrong_pixels(session.reference(), std::span(state.touched).first(state.touched_count))) +
            " %";
    } else {
        text += ", coverage …";
    }
    text += ", traversal " + short_number(session.times().traverse) + " ms, drawing " +
            short_number(bench_.flight.draw_ms) + " ms";
    if (bench_.flight.on) text += ", speed " + short_number(flight_speed(bench_));
    text_box(*ImGui::GetWindowDrawList(), ui, bench_.session.settings().palette, {area.x, area.y}, text, false);
}

/// Where the cells stand that scripts and readers of the screen may ask for.
void Picture3d::note_places() {
    const auto add = [&](const std::string& name, std::uint32_t cell) {
        if (cell >= bench_.session.cells().cell_count()) return;
        const auto at = project(panes_[0].camera(), bench_.session.cells().centre(cell));
        if (!at) return;
        const ImVec2 window = panes_[0].to_window(*at);
        bench_.places.push_back({name, window.x, window.y, 0, 0});
    };
    add("selected cell", bench_.session.selected_cell);
    add("last cell", last_cell(bench_.session));
}

void Picture3d::interact(Ui& ui, const Area& area) {
    ImGui::InvisibleButton(
        "scene", {area.w, area.h},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    const std::span<const Pane3d> panes = std::span<const Pane3d>(panes_).first(pane_count());
    mouse_.frame(ui, panes);
    fly(ui, ImGui::GetIO().DeltaTime);
    update(ui, area);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(area.min(), area.max(), true);
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const Area& part = panes[i].area();
        list.PushClipRect(part.min(), part.max(), true);
        panes[i].draw_texts(list, ui);
        insets_[i].draw(list, ui, part);
        draw_counters(ui, part, session_of(i));
        if (bench_.other)
            text_box(list, ui, bench_.session.settings().palette, {part.x, part.y + 26 * ui.unit},
                     (i == 0 ? "left: " : "right: ") + side_titles(bench_)[i], true);
        list.PopClipRect();
    }
    mouse_.draw(ui, panes, area);
    list.PopClipRect();
    note_places();
}

void Picture3d::draw(Ui&, const Area&) {
    for (std::size_t i = 0; i < pane_count(); ++i) panes_[i].draw();
}

}  // namespace sightline
