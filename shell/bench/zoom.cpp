// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/bench/zoom.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/draw/shown_world.h"
#include "core/error.h"
#include "shell/bench/change.h"

namespace sightline {

namespace {

/// Limits of the setting.
constexpr double least = 0.01, most = 1000;

}  // namespace

void zoom_about(Workbench<2>& bench, const Vec<2>& fixed, double factor, const std::string& gesture) {
    if (!(factor > 0)) throw InputError("the factor must be above 0");
    Settings settings = bench.session.settings();
    const double zoom = std::clamp(settings.zoom * factor, least, most);
    const Vec<2> middle = shown_world(bench.session).centre();
    const Vec<2> to = fixed + (middle - fixed) * (settings.zoom / zoom);
    settings.zoom = zoom;
    settings.zoom_at = ZoomAt::point;
    settings.zoom_x = to.x;
    settings.zoom_y = to.y;
    change_settings(bench, settings, gesture);
}

void zoom(Workbench<2>& bench, double factor) { zoom_about(bench, shown_world(bench.session).centre(), factor); }

void centre_on(Workbench<2>& bench, const Vec<2>& middle, const std::string& gesture) {
    Settings settings = bench.session.settings();
    settings.zoom_at = ZoomAt::point;
    settings.zoom_x = middle.x;
    settings.zoom_y = middle.y;
    change_settings(bench, settings, gesture);
}

void hold(Workbench<2>& bench, const Box<2>& world, const std::string& gesture) {
    const Vec<2> shown = shown_world(bench.session).extent(), held = world.extent();
    const double factor = std::max(shown.x / held.x, shown.y / held.y);
    // Nothing that an eye could see: a picture that fits the scene goes on fitting it.
    const double off = glm::length(shown_world(bench.session).centre() - world.centre()) / glm::length(held);
    if (std::abs(factor - 1) < 1e-6 && off < 1e-6) return;
    zoom_about(bench, shown_world(bench.session).centre(), factor, gesture);
    centre_on(bench, world.centre(), gesture);
}

void fit(Workbench<2>& bench) {
    Settings settings = bench.session.settings();
    settings.zoom = 1;
    settings.zoom_at = ZoomAt::view;
    change_settings(bench, settings);
}

}  // namespace sightline
