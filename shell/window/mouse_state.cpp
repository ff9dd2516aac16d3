// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/mouse_state.h"

#include <algorithm>
#include <cfloat>

namespace sightline {

namespace {

bool is_button(const SDL_Event& event) { return event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP; }

}  // namespace

bool MouseState::waits(const SDL_Event& event) const { return changed_ || (event.type == SDL_MOUSEBUTTONUP && moved_); }

void MouseState::take(const SDL_Event& event) {
    const auto place = [this](int x, int y) { at_ = ImVec2(static_cast<float>(x), static_cast<float>(y)); };
    if (event.type == SDL_MOUSEMOTION) {
        place(event.motion.x, event.motion.y);
        moved_ = true;
    } else if (is_button(event)) {
        place(event.button.x, event.button.y);
        changed_ = true;
        const bool down = event.type == SDL_MOUSEBUTTONDOWN;
        if (event.button.button == SDL_BUTTON_LEFT) down_[0] = down;
        if (event.button.button == SDL_BUTTON_RIGHT) down_[1] = down;
        if (event.button.button == SDL_BUTTON_MIDDLE) down_[2] = down;
    } else if (event.type == SDL_WINDOWEVENT) {
        const bool held = std::any_of(down_.begin(), down_.end(), [](bool down) { return down; });
        if (event.window.event == SDL_WINDOWEVENT_LEAVE && !held) at_.reset();
        if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) down_ = {};
    }
}

void MouseState::give(ImGuiIO& io) const {
#if IMGUI_VERSION_NUM < 18700  // later backends queue the events themselves
    io.MousePos = at_.value_or(ImVec2(-FLT_MAX, -FLT_MAX));
    std::copy(down_.begin(), down_.end(), io.MouseDown);
#else
    (void)io;
#endif
}

void take_modifiers(const SDL_Event& event, ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
    if (event.type != SDL_KEYDOWN && event.type != SDL_KEYUP) return;
    io.KeyCtrl = event.key.keysym.mod & KMOD_CTRL;
    io.KeyShift = event.key.keysym.mod & KMOD_SHIFT;
    io.KeyAlt = event.key.keysym.mod & KMOD_ALT;
#else
    (void)event;
    (void)io;
#endif
}

}  // namespace sightline
