// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/keys.h"

#include <SDL_keyboard.h>

#include <array>
#include <cctype>
#include <utility>

namespace sightline {

namespace {

constexpr std::array named{
    std::pair{SDLK_RIGHT, "Right"},   std::pair{SDLK_LEFT, "Left"},         std::pair{SDLK_UP, "Up"},
    std::pair{SDLK_DOWN, "Down"},     std::pair{SDLK_HOME, "Home"},         std::pair{SDLK_END, "End"},
    std::pair{SDLK_PAGEUP, "PageUp"}, std::pair{SDLK_PAGEDOWN, "PageDown"}, std::pair{SDLK_SPACE, "Space"},
    std::pair{SDLK_RETURN, "Enter"},  std::pair{SDLK_KP_ENTER, "Enter"},    std::pair{SDLK_TAB, "Tab"},
    std::pair{SDLK_ESCAPE, "Escape"}, std::pair{SDLK_DELETE, "Delete"},     std::pair{SDLK_BACKSPACE, "Backspace"},
    std::pair{SDLK_KP_PLUS, "Plus"},  std::pair{SDLK_KP_MINUS, "Minus"},
};

/// Without Ctrl or Alt these come as text.
constexpr std::string_view text_keys = ":[]{}+-";

std::string base_name(SDL_Keycode key, bool with_control) {
    for (const auto& [code, name] : named)
        if (key == code) return name;
    if (key >= SDLK_F1 && key <= SDLK_F12) return "F" + std::to_string(key - SDLK_F1 + 1);
    if (key >= SDLK_a && key <= SDLK_z) return std::string(1, static_cast<char>('A' + (key - SDLK_a)));
    if (key >= SDLK_0 && key <= SDLK_9) return std::string(1, static_cast<char>(key));
    // + lies on = of many keyboards.
    if (with_control && (key == SDLK_EQUALS || key == SDLK_PLUS)) return "Plus";
    if (with_control && key == SDLK_MINUS) return "Minus";
    return {};
}

}  // namespace

std::string key_name(const SDL_Event& event) {
    if (event.type == SDL_TEXTINPUT) {
        if (SDL_GetModState() & KMOD_CTRL) return {};  // X gives the + of Ctrl and + as text too
        const std::string_view text = event.text.text;
        return text.size() == 1 && text_keys.find(text) != std::string_view::npos ? std::string(text) : "";
    }
    if (event.type != SDL_KEYDOWN) return {};
    const SDL_Keysym& sym = event.key.keysym;
    const bool control = sym.mod & KMOD_CTRL, shift = sym.mod & KMOD_SHIFT, alt = sym.mod & KMOD_LALT;
    const std::string base = base_name(sym.sym, control);
    if (base.empty()) return {};
    std::string name;
    if (control) name += "Ctrl+";
    if (alt) name += "Alt+";
    if (shift && base != "Plus") name += "Shift+";
    return name + base;
}

}  // namespace sightline
