// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/picture3d.h"

#include <SDL_scancode.h>

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "core/draw/projection.h"
#include "core/draw/shown_cells.h"
#include "core/session/settings_table.h"
#include "shell/desk/camera.h"
#include "shell/desk/compare.h"
#include "shell/desk/complete.h"
#include "shell/desk/fly.h"
#include "shell/desk/into.h"
#include "shell/pane/cell_words.h"
#include "shell/pane/draw_light.h"
#include "shell/pane/frozen_badge.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// As much of an area, from above, as shows the culling view to both sides; never higher than the area.
Area no_narrower(Area area, float aspect) {
    area.h = std::max(1.0f, std::min(area.h, area.w / aspect));
    return area;
}

struct FlightKey {
    const char* name;
    int scancode;
    Vec<3> direction;  ///< right, up, forward
};
constexpr double run_factor = 4;  ///< with Shift
/// A flying eye is measured against the exact image in every frame while that takes no longer than this, else when it
/// has rested for so long; and once in a while, since it may have become quicker.
constexpr double measured_in_flight_ms = 60;
constexpr float rest_seconds = 0.3f, measured_again_seconds = 2;

const std::array<FlightKey, 6> flight_keys{{{"W", SDL_SCANCODE_W, {0, 0, 1}},
                                            {"S", SDL_SCANCODE_S, {0, 0, -1}},
                                            {"A", SDL_SCANCODE_A, {-1, 0, 0}},
                                            {"D", SDL_SCANCODE_D, {1, 0, 0}},
                                            {"E", SDL_SCANCODE_E, {0, 1, 0}},
                                            {"Q", SDL_SCANCODE_Q, {0, -1, 0}}}};

float title_height(const Ui& ui) { return ui.fonts.text->FontSize / ui.framebuffer + 6 * ui.unit; }

}  // namespace

bool Picture3d::takes_key(const std::string& key) const {
    return bench_.flight.on && std::any_of(flight_keys.begin(), flight_keys.end(), [&](const FlightKey& k) {
               return key == k.name || key == std::string("Shift+") + k.name;
           });
}

std::string Picture3d::title_of(std::size_t pane) const {
    const std::string guarantee = ", " + sessions_[pane].guarantee();
    if (!bench_.other) return std::string(bench_.session.method().id) + guarantee;
    return side_titles(bench_)[pane] + guarantee;
}

void Picture3d::fly(Ui& ui, float seconds) {
    if (!bench_.flight.on || ImGui::GetIO().WantTextInput) return;
    Vec<3> by(0);
    for (const FlightKey& key : flight_keys)
        if (ImGui::IsKeyDown(key.scancode)) by += key.direction;
    if (by == Vec<3>(0)) return;
    const double speed = flight_speed(bench_) * (ImGui::GetIO().KeyShift ? run_factor : 1);
    fly_to(bench_, walked(bench_.session.display_view(), bench_.session.scene().up_axis, by * (speed * seconds)),
           "flight");
    ++ui.revision;
}

void Picture3d::measure(Ui& ui) {
    rested_ = flown_ == bench_.run ? rested_ + ImGui::GetIO().DeltaTime : 0;
    flown_ = bench_.run;
    if (rested_ >= rest_seconds && complete_at_rest(bench_)) ++ui.revision;
    unmeasured_ += ImGui::GetIO().DeltaTime;
    if (measure_ms_ > measured_in_flight_ms && rested_ < rest_seconds && unmeasured_ < measured_again_seconds) return;
    double ms = 0;
    bool any = false;
    for (std::size_t i = 0; i < sessions_.count(); ++i) {
        const Session<3>& session = sessions_[i];
        if (!session.flying() || session.has_reference()) continue;
        const double before = session.times().reference;
        session.reference();
        ms += session.times().reference - before;
        any = true;
    }
    if (!any) return;
    measure_ms_ = ms;
    unmeasured_ = 0;
    ++ui.revision;
}

Picture3d::Part Picture3d::lay_out(const Ui& ui, const Area& area, std::size_t pane) const {
    const Session<3>& session = sessions_[pane];
    Part part;
    part.whole = pane_area(area, pane, sessions_.count());
    part.counters = counters(session, title_of(pane), panes_[pane].draw_ms(),
                             bench_.flight.on ? std::optional(flight_speed(bench_)) : std::nullopt);
    if (bench_.other) {
        const SideHead head = side_head(session, "");
        part.counters[1].text = head.drawn;  // for the triangles
        if (!head.visible.empty()) part.counters.insert(part.counters.begin() + 2, {head.visible, "", true});
    }
    part.head = part.whole;
    part.head.h = counters_height(ui, part.counters, part.whole.w);
    Area body = part.whole;
    body.y += part.head.h;
    body.h = std::max(1.0f, body.h - part.head.h);
    const ImageSize size = image_size<3>(session.settings().reference_size);
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    // From outside, all of the place that there is.
    part.picture = seen_from_outside(session) ? body : no_narrower(body, aspect);
    if (session.settings().split == Split::off) return part;
    // Beside each other or below each other, whichever shows more.
    const float gap = 3, title = title_height(ui);
    Area beside{body.x, body.y + title, std::floor((body.w - gap) / 2), body.h - title};
    Area below{body.x, body.y + title, body.w, std::max(1.0f, std::floor((body.h - gap) / 2) - title)};
    const auto scale = [&](const Area& half) { return std::min(half.w, half.h * aspect); };
    if (scale(beside) >= scale(below)) {
        part.picture = no_narrower(beside, aspect);
        part.split = part.picture;
        part.split->x = body.x + body.w - beside.w;
    } else {
        part.picture = below;
        part.split = below;
        part.split->y += below.h + gap + title;
    }
    return part;
}

void Picture3d::update(const Ui& ui) {
    sessions_.update(ui.revision);
    const ShownSession<3> shown(bench_);
    for (std::size_t i = 0; i < sessions_.count(); ++i) {
        const Session<3>& session = i == 0 ? *shown : sessions_[i];
        const Area& picture = parts_[i].picture;
        auto options = sessions_.options<PictureOptions3>(i);
        options.aspect = picture.w / picture.h;
        const Stopwatch drawing;
        eyes_[i].update(session, ui.revision);
        const PaneFrame frame{ui.revision, bench_.run, bench_.desk.projector, i == 0 && bench_.desk.legend,
                              bench_.desk.animate};
        const bool moving = mouse_.dragging() || bench_.flight.on || bench_.flight.replaying;
        const bool drawn = panes_[i].update(ui, session, options, frame, picture, moving,
                                            {eyes_[i].insets(ui, picture, session), eyes_[i].plan()});
        // A new frame of a flight: what it was drawn for says what the next one will leave for its traversal.
        if (drawn && session.flying() && bench_.run != drawn_run_)
            note_frame(drawn_frames_[i], session.counters().drawn(), drawing.milliseconds());
        if (const Budget& budget = session.settings().budget; budget.kind == Budget::Kind::milliseconds)
            (i == 0 ? bench_.session : bench_.other->session)
                .set_frame_cost(predict_cost(drawn_frames_[i], budget.value));
    }
    drawn_run_ = bench_.run;
}

void Picture3d::draw_part(ImDrawList& list, const Ui& ui, std::size_t pane) {
    const Session<3>& session = sessions_[pane];
    const Part& part = parts_[pane];
    const auto fill = [&](const Area& area) { list.AddRectFilled(area.min(), area.max(), colour(theme::panel)); };
    draw_counters(list, ui, part.counters, part.head);
    note(pane == 0 ? "counters" : "counters right", part.head);
    list.PushClipRect(part.picture.min(), part.picture.max(), true);
    if (pane == 0)
        draw_key_light(list, ui, session, bench_.lit, [&](const Vec<3>& p) {
            const auto at = project(panes_[pane].camera(), p);
            return at ? std::optional(panes_[pane].to_window(*at)) : std::nullopt;
        });
    panes_[pane].draw_texts(list, ui);
    eyes_[pane].draw_insets(list, ui, part.picture, session);
    if (pane == 0) draw_frozen_badge(list, ui, bench_, part.picture);
    list.PopClipRect();
    if (!part.split) return;
    const auto title = [&](const Area& area, const std::string& text) {
        const Area at{area.x, area.y - title_height(ui), area.w, title_height(ui)};
        fill(at);
        const float pad = 6 * ui.unit, size = ImGui::GetFontSize();
        const float shrunk = std::min(1.0f, (at.w - 2 * pad) / ImGui::CalcTextSize(text.c_str()).x);
        list.AddText(ui.fonts.text, size * shrunk, {at.x + pad, at.y + 2 * ui.unit}, colour(theme::ink), text.c_str());
        note(text, area);
    };
    title(part.picture, seen_from_outside(session) ? "seen from a different eye"
                                                   : "what " + std::string(session.method().id) + " draws");
    title(*part.split, eyes_[pane].split_title(session));
    eyes_[pane].draw_split(list, *part.split, session);
}

void Picture3d::note(const std::string& name, const Area& area) {
    bench_.places.push_back({name, area.x, area.y, area.w, area.h});
}

void Picture3d::note_cells() {
    const auto to_window = [&](const Vec<3>& p) {
        const auto at = project(panes_[0].camera(), p);
        return at ? std::optional(panes_[0].to_window(*at)) : std::nullopt;
    };
    note_cell(bench_, "selected cell", bench_.session.selected_cell, to_window);
    note_cell(bench_, "last cell", last_cell(bench_.session), to_window);
}

/// Of the exact image, in a picture of the culling eye. Where two sessions are compared, that of the first one: the eye
/// is the same.
std::optional<std::array<int, 2>> Picture3d::pixel_under_mouse(const Ui& ui) const {
    for (std::size_t i = 0; i < sessions_.count(); ++i)
        if (const auto pixel =
                eyes_[i].pixel_at(ui, ImGui::GetIO().MousePos, parts_[i].picture, parts_[i].split, sessions_[i]))
            return pixel;
    return std::nullopt;
}

void Picture3d::interact(Ui& ui, const Area& area) {
    ImGui::InvisibleButton(
        "scene", {area.w, area.h},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    if (!mouse_.dragging() && frozen_badge_takes_mouse(ui, bench_, parts_[0].picture))
        mouse_.leave();
    else
        mouse_.frame(ui, std::span<const Pane3d>(panes_).first(sessions_.count()), pixel_under_mouse(ui));
    fly(ui, ImGui::GetIO().DeltaTime);
    measure(ui);
    for (std::size_t i = 0; i < sessions_.count(); ++i) parts_[i] = lay_out(ui, area, i);
    update(ui);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(area.min(), area.max(), true);
    for (std::size_t i = 0; i < sessions_.count(); ++i) draw_part(list, ui, i);
    mouse_.draw(ui, std::span<const Pane3d>(panes_).first(sessions_.count()), area);
    list.PopClipRect();
    note_cells();
}

void Picture3d::draw(Ui&, const Area&) {
    for (std::size_t i = 0; i < sessions_.count(); ++i) panes_[i].draw();
}

}  // namespace sightline
