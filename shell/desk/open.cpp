// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/open.h"

#include <algorithm>

#include "core/session/state_file.h"
#include "shell/desk/auto_choice.h"
#include "shell/desk/change.h"
#include "shell/desk/compare.h"

namespace sightline {

namespace {

/// For warnings about what is read.
template <int D>
auto warner(const Workbench<D>& bench) {
    return [&bench](const std::string& line) { bench.say("warning: " + line); };
}

enum class Opened : std::uint8_t { scene, state };

template <int D>
Opened open_what(Workbench<D>& bench, const std::string& name) {
    if (const auto text = state_text<D>(name)) {
        open_state_text(bench, *text, name);
        return Opened::state;
    }
    Session<D> session =
        open_scene<D>(name, start_settings<D>(name, bench.record_ahead), bench.methods, warner(bench), bench.graphics);
    add_bookmarks(session);
    replace_session(bench, std::move(session));
    bench.figure = {};
    return Opened::scene;
}

}  // namespace

template <int D>
void open_state_text(Workbench<D>& bench, const std::string& text, const std::string& name) {
    OpenedState<D> opened = open_state<D>(text, name, bench.methods, bench.graphics.draw_ids, bench.graphics.progress);
    std::for_each(opened.warnings.begin(), opened.warnings.end(), warner(bench));
    replace_session(bench, std::move(opened.session));
    bench.figure = std::move(opened.figure);
    if (opened.other) compare_with(bench, std::move(*opened.other), "right", opened.align);
}

template <int D>
void open(Workbench<D>& bench, const std::string& name) {
    const bool follows = bench.session.settings().automatic == Switch::on;
    if (open_what(bench, name) == Opened::scene && follows) choose_auto(bench, false, bench.session.settings());
}

template <int D>
void open_as_it_is(Workbench<D>& bench, const std::string& name) {
    open_what(bench, name);
    Settings settings = bench.session.settings();
    settings.automatic = Switch::off;
    bench.session.change(settings);
}

template <int D>
void compare_file(Workbench<D>& bench, const std::string& name) {
    const auto text = state_text<D>(name);
    if (!text)
        return compare_with(bench,
                            open_scene<D>(name, start_settings<D>(name, bench.record_ahead), bench.methods,
                                          warner(bench), bench.graphics),
                            name);
    OpenedState<D> opened = open_state<D>(*text, name, bench.methods, bench.graphics.draw_ids, bench.graphics.progress);
    std::for_each(opened.warnings.begin(), opened.warnings.end(), warner(bench));
    compare_with(bench, std::move(opened.session), name);
}

#define SIGHTLINE_INSTANTIATE(D)                                                             \
    template void open<D>(Workbench<D>&, const std::string&);                                \
    template void open_as_it_is<D>(Workbench<D>&, const std::string&);                       \
    template void open_state_text<D>(Workbench<D>&, const std::string&, const std::string&); \
    template void compare_file<D>(Workbench<D>&, const std::string&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
