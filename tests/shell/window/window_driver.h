// The real window off screen, driven by events as a person's hands would.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "shell/window/window.h"

namespace sightline::test {

template <int D>
class WindowDriver {
public:
    /// `make_stage(bench)` is called when OpenGL is there. Throws WorkError without OpenGL.
    WindowDriver(Workbench<D>& bench, int width, int height, const std::function<Stage(Workbench<D>&)>& make_stage)
        : bench_(bench), window_(bench, {GlContext::Place::off_screen, {width, height, std::nullopt, false}, 1}) {
        bench.desk.animate = false;  // frames of the driver take no time
        window_.stage = make_stage(bench);
        id_ = SDL_GetWindowID(window_.context().window());
        frames(2);
    }

    /// Frames of a thirtieth of a second.
    void frames(int count) {
        for (; count > 0; --count) {
            window_.frame(1 / 30.0);
            ++drawn_;
        }
    }
    int drawn() const { return drawn_; }
    Window<D>& window() { return window_; }

    void move(double x, double y) {
        SDL_Event event{};
        event.type = SDL_MOUSEMOTION;
        event.motion.windowID = id_;
        event.motion.x = static_cast<int>(x);
        event.motion.y = static_cast<int>(y);
        at_[0] = event.motion.x;
        at_[1] = event.motion.y;
        push(event);
    }
    void button(bool down, Uint8 which = SDL_BUTTON_LEFT) {
        SDL_Event event{};
        event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
        event.button.windowID = id_;
        event.button.button = which;
        event.button.state = down ? SDL_PRESSED : SDL_RELEASED;
        event.button.clicks = 1;
        event.button.x = at_[0];
        event.button.y = at_[1];
        push(event);
    }
    void wheel(int y) {
        SDL_Event event{};
        event.type = SDL_MOUSEWHEEL;
        event.wheel.windowID = id_;
        event.wheel.y = y;
        event.wheel.preciseY = static_cast<float>(y);
        push(event);
    }
    void click(double x, double y) {
        move(x, y);
        frames(1);
        button(true);
        frames(1);
        button(false);
        frames(1);
    }
    void drag(double x, double y, double to_x, double to_y, int parts = 3, Uint8 which = SDL_BUTTON_LEFT) {
        move(x, y);
        frames(1);
        button(true, which);
        frames(1);
        for (int i = 1; i <= parts; ++i) {
            move(x + (to_x - x) * i / parts, y + (to_y - y) * i / parts);
            frames(1);
        }
    }
    void drop(Uint8 which = SDL_BUTTON_LEFT) {
        button(false, which);
        frames(2);
    }
    void key(SDL_Keycode code, int modifiers = KMOD_NONE) {
        press(code, modifiers);
        release(code, modifiers);
    }
    /// `modifiers`: those that are held when the event is over.
    void press(SDL_Keycode code, int modifiers = KMOD_NONE) { key_event(SDL_KEYDOWN, SDL_PRESSED, code, modifiers); }
    void release(SDL_Keycode code, int modifiers = KMOD_NONE) { key_event(SDL_KEYUP, SDL_RELEASED, code, modifiers); }
    /// As a keyboard sends them: one event a character.
    void type(const std::string& text) {
        for (const char c : text) {
            SDL_Event event{};
            event.type = SDL_TEXTINPUT;
            event.text.windowID = id_;
            event.text.text[0] = c;
            push(event);
        }
    }
    void resize(int width, int height) { SDL_SetWindowSize(window_.context().window(), width, height); }

    /// Where a part of the window stands; nullptr when it is not shown.
    const Place* place(const std::string& name) const {
        const auto found =
            std::find_if(bench_.places.begin(), bench_.places.end(), [&](const Place& p) { return p.name == name; });
        return found == bench_.places.end() ? nullptr : &*found;
    }

private:
    void key_event(Uint32 type, Uint8 state, SDL_Keycode code, int modifiers) {
        SDL_Event event{};
        event.type = type;
        event.key.windowID = id_;
        event.key.state = state;
        event.key.keysym.sym = code;
        event.key.keysym.scancode = SDL_GetScancodeFromKey(code);
        event.key.keysym.mod = static_cast<Uint16>(modifiers);
        push(event);
    }
    static void push(SDL_Event& event) { EXPECT_EQ(SDL_PushEvent(&event), 1); }

    Workbench<D>& bench_;
    Window<D> window_;
    Uint32 id_ = 0;
    int at_[2] = {0, 0};
    int drawn_ = 0;
};

}  // namespace sightline::test
