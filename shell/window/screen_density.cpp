// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/screen_density.h"

#include <SDL_syswm.h>

#include <cmath>

#include "core/base/number.h"

namespace sightline {

namespace {

/// Of the X server; 0 for other window systems. SDL 2 itself knows only what monitors say, which some do not.
double x11_dots_per_inch([[maybe_unused]] SDL_Window* window) {
#ifdef SDL_VIDEO_DRIVER_X11
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    if (!SDL_GetWindowWMInfo(window, &info) || info.subsystem != SDL_SYSWM_X11) return 0;
    Display* const display = info.info.x11.display;
    if (const char* set = XGetDefault(display, "Xft", "dpi"))
        if (const auto dpi = parse_number(set)) return *dpi;
    float monitor = 0;
    if (SDL_GetDisplayDPI(SDL_GetWindowDisplayIndex(window), nullptr, &monitor, nullptr) == 0) return monitor;
    const int screen = DefaultScreen(display), height_mm = DisplayHeightMM(display, screen);
    return height_mm > 0 ? DisplayHeight(display, screen) * 25.4 / height_mm : 0;
#else
    return 0;
#endif
}

}  // namespace

double screen_density(SDL_Window* window) {
    double dpi = x11_dots_per_inch(window);
    float monitor = 0;
    if (dpi == 0 && SDL_GetDisplayDPI(SDL_GetWindowDisplayIndex(window), nullptr, &monitor, nullptr) == 0)
        dpi = monitor;
    const double density = std::round(dpi / 96 * 4) / 4;
    return density >= 1.5 && density <= 4 ? density : 1;  // below, monitors are read from afar or say nonsense
}

}  // namespace sightline
