// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/bench/open.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "core/file.h"
#include "core/scene/catalogue.h"
#include "core/scene/load.h"
#include "core/session/condition.h"
#include "core/session/state_file.h"
#include "core/stopwatch.h"
#include "shell/bench/change.h"

namespace sightline {

std::optional<std::string> state_text(const std::string& name) {
    std::error_code error;
    if (find_in_catalogue(name) || !std::filesystem::is_regular_file(name, error)) return std::nullopt;
    std::string text = read_file(name);
    // Both kinds of JSON say at the top what they are; the rest is the readers' matter.
    if (text.substr(0, 200).find("\"sightline-state\"") == std::string::npos) return std::nullopt;
    return text;
}

Settings start_settings(const std::string& name, bool in_window) {
    Settings settings;
    if (in_window) settings.label = CellNumber::solidity;
    const CatalogueRow<2>* row = find_in_catalogue(name);
    if (!row) return settings;
    settings.error_bound = row->error_bound;
    settings.method = row->method;
    settings.budget = parse_budget(row->budget);
    for (const SettingOverride& s : row->settings) apply_setting(settings, std::string(s.field) + "=" + s.value);
    return settings;
}

Session<2> open_scene(const std::string& name, const Settings& settings, std::span<const Method<2>> methods,
                      const std::function<void(const std::string&)>& warn) {
    const Stopwatch reading;
    auto scene = std::make_shared<const Scene<2>>(load_scene(name, {.two_sided = settings.two_sided == Switch::on}));
    const double read_ms = reading.milliseconds();
    for (const std::string& warning : scene->warnings) warn(warning);
    if (const Dropped& d = scene->dropped; d.total() > 0)
        warn(name + ": dropped " + std::to_string(d.degenerate) + " of zero length, " + std::to_string(d.duplicate) +
             " duplicates, " + std::to_string(d.not_finite) + " not finite");
    const ViewSpec<2> view = scene->start_view.value_or(ViewSpec<2>{{0, 0}, {1, 0}, 60});
    Session<2> session(scene, view, settings, methods);
    session.times().read = read_ms;
    return session;
}

void add_bookmarks(Session<2>& session) {
    const CatalogueRow<2>* row = find_in_catalogue(session.scene().id);
    if (!row || session.scene().source != "generated") return;
    Session<2> scout = session;
    for (const CatalogueBookmark& bookmark : row->bookmarks) {
        const Condition<2> condition(bookmark.condition);
        scout.seek(0);
        if (run_until(scout, condition) == Stop::breakpoint)
            session.bookmarks.push_back({scout.position(), bookmark.label});
    }
}

namespace {

/// For warnings about what is read.
auto warner(const Workbench<2>& bench) {
    return [&bench](const std::string& line) { bench.say("warning: " + line); };
}

}  // namespace

void open_state_text(Workbench<2>& bench, const std::string& text, const std::string& name) {
    OpenedState opened = open_state(text, name, bench.methods);
    std::for_each(opened.warnings.begin(), opened.warnings.end(), warner(bench));
    replace_session(bench, std::move(opened.session));
    bench.figure = std::move(opened.figure);
    if (opened.other) compare_with(bench, std::move(*opened.other), "right", opened.align);
}

void open(Workbench<2>& bench, const std::string& name) {
    if (const auto text = state_text(name)) return open_state_text(bench, *text, name);
    Session<2> session = open_scene(name, start_settings(name, bench.record_ahead), bench.methods, warner(bench));
    add_bookmarks(session);
    replace_session(bench, std::move(session));
    bench.figure = {};
}

void compare_file(Workbench<2>& bench, const std::string& name) {
    const auto text = state_text(name);
    if (!text)
        return compare_with(
            bench, open_scene(name, start_settings(name, bench.record_ahead), bench.methods, warner(bench)), name);
    OpenedState opened = open_state(*text, name, bench.methods);
    std::for_each(opened.warnings.begin(), opened.warnings.end(), warner(bench));
    compare_with(bench, std::move(opened.session), name);
}

std::shared_ptr<const Scene<2>> reread(const std::shared_ptr<const Scene<2>>& scene, const Settings& settings) {
    if (!scene->source.starts_with("wad")) return scene;
    if (scene->name.empty()) throw InputError("two_sided: the level's file is not known, it cannot be read again");
    return std::make_shared<const Scene<2>>(load_scene(scene->name, {.two_sided = settings.two_sided == Switch::on}));
}

}  // namespace sightline
