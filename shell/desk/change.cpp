// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/change.h"

#include <algorithm>

#include "shell/desk/moved.h"
#include "shell/desk/open_scene.h"
#include "shell/desk/undo.h"

namespace sightline {

namespace {

/// "step 37 of 212; order differs from step 12"; empty where nothing was recorded.
template <int D>
std::string what_became(const Workbench<D>& bench, const std::vector<Step>& before, Invalidates what) {
    const auto& now = bench.session.timeline().steps;
    const std::size_t common = std::min(before.size(), now.size());
    std::size_t same = 0;
    while (same < common && before[same].item == now[same].item) ++same;
    if (before.empty() && now.empty() && what < Invalidates::tessellation) return {};
    std::string line = "step " + std::to_string(bench.session.position()) + " of " + std::to_string(now.size()) + "; ";
    if (what >= Invalidates::tessellation)
        line += "new cells: " + std::to_string(bench.session.cells().cell_count());
    else if (same < common)
        line += "the order differs from step " + std::to_string(same + 1);
    else
        line += common > 0 ? "same order so far" : "no step to compare with";
    return line;
}

/// What changes of the picture alone on one side changes beside it as well: both are looked at in the same way.
template <int D>
void picture_settings_too(const Settings& from, const Settings& to, Session<D>& beside) {
    Settings settings = beside.settings();
    for (const SettingRow& row : settings_table())
        if (row.invalidates == Invalidates::picture && row.get(from) != row.get(to)) row.set(settings, row.get(to));
    beside.change(settings);
}

/// Primitives have new numbers: see change_scene.
template <int D>
void renumber(Session<D>& session, std::span<const std::uint32_t> numbers) {
    if (session.selected_primitive != none) session.selected_primitive = numbers[session.selected_primitive];
    for (Note<D>& note : session.notes)
        if (note.anchor == Note<D>::Anchor::primitive) note.index = numbers[note.index];
    std::erase_if(session.notes,
                  [](const Note<D>& note) { return note.anchor == Note<D>::Anchor::primitive && note.index == none; });
}

}  // namespace

std::string left_auto(const Settings& recommended, const Settings& settings) {
    std::string what;
    const auto add = [&](bool differs, const char* name) {
        if (differs) what += (what.empty() ? "the " : " and the ") + std::string(name);
    };
    const TessellationSettings &recommended_cells = recommended, &cells = settings;
    add(recommended.method != settings.method || recommended.parameters != settings.parameters, "method");
    add(recommended.budget != settings.budget, "budget");
    add(recommended_cells != cells, "cells");
    const bool one = what == "the method" || what == "the budget";
    return what.empty() ? "" : "auto is off: " + what + (one ? " was" : " were") + " set by hand";
}

template <int D>
void change_settings(Workbench<D>& bench, const Settings& wanted, const std::string& gesture, SetBy by) {
    const bool follows =
        by == SetBy::hand && bench.session.settings().automatic == Switch::on && wanted.automatic == Switch::on;
    const std::string left = follows ? left_auto(bench.session.settings(), wanted) : "";
    Settings settings = wanted;
    if (!left.empty()) settings.automatic = Switch::off;
    const Invalidates what = difference(bench.session.settings(), settings);
    if (settings == bench.session.settings()) return;
    std::shared_ptr<const Scene<D>> scene = bench.session.shared_scene();
    if (what == Invalidates::scene) scene = reread<D>(scene, settings);
    remember(bench, gesture);
    if (bench.other) picture_settings_too(bench.session.settings(), settings, bench.other->session);
    const std::vector<Step> before = bench.session.timeline().steps;
    const bool flying = bench.session.flying();
    if (scene != bench.session.shared_scene()) bench.session.set_scene(scene);
    bench.session.change(settings);
    if (what < Invalidates::traversal && !flying) return moved(bench);
    traversal_changed(bench);
    if (flying) {
        fly_on(bench, bench.session.culling_view());
        if (!left.empty()) bench.say(left);
        return;
    }
    if (by == SetBy::recommendation) return;
    const std::string became = what_became(bench, before, what);
    const std::string line = became + (became.empty() || left.empty() ? "" : "; ") + left;
    if (!line.empty()) bench.say(line);
}

template <int D>
void change_view(Workbench<D>& bench, const ViewSpec<D>& view, const std::string& gesture) {
    bench.session.check(view);  // throws before anything is remembered
    remember(bench, gesture);
    bench.session.set_view(view);
    bench.session.frozen_part() == Frozen::all ? moved(bench) : traversal_changed(bench);
}

template <int D>
void change_culling_view(Workbench<D>& bench, const ViewSpec<D>& view, const std::string& gesture) {
    bench.session.check(view);  // throws before anything is remembered
    remember(bench, gesture);
    bench.session.set_culling_view(view);
    traversal_changed(bench);
}

template <int D>
void change_scene(Workbench<D>& bench, std::shared_ptr<const Scene<D>> scene, const std::string& gesture,
                  std::span<const std::uint32_t> numbers) {
    remember(bench, gesture);
    if (!numbers.empty()) renumber(bench.session, numbers);
    bench.session.set_scene(std::move(scene));
    traversal_changed(bench);
}

template <int D>
void replace_session(Workbench<D>& bench, Session<D> session) {
    bench.session = std::move(session);
    bench.history = {};
    bench.other.reset();
    bench.hovered_cell = bench.selected_note = none;
    bench.flight = {};
    bench.last_stop = Stop::steps;
    bench.desk.timeline_from = 0;
    bench.desk.timeline_to = 1;
    traversal_changed(bench);
}

template void change_settings<2>(Workbench<2>&, const Settings&, const std::string&, SetBy);
template void change_settings<3>(Workbench<3>&, const Settings&, const std::string&, SetBy);
template void change_view<2>(Workbench<2>&, const ViewSpec<2>&, const std::string&);
template void change_view<3>(Workbench<3>&, const ViewSpec<3>&, const std::string&);
template void change_culling_view<2>(Workbench<2>&, const ViewSpec<2>&, const std::string&);
template void change_culling_view<3>(Workbench<3>&, const ViewSpec<3>&, const std::string&);
template void change_scene<2>(Workbench<2>&, std::shared_ptr<const Scene<2>>, const std::string&,
                              std::span<const std::uint32_t>);
template void change_scene<3>(Workbench<3>&, std::shared_ptr<const Scene<3>>, const std::string&,
                              std::span<const std::uint32_t>);
template void replace_session<2>(Workbench<2>&, Session<2>);
template void replace_session<3>(Workbench<3>&, Session<3>);

}  // namespace sightline
