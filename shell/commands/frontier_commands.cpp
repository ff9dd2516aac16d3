// Commands of the frontier of speed and accuracy.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/base/error.h"
#include "core/settings/settings_table.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/change.h"
#include "shell/desk/measure_frontier.h"

namespace sightline {

namespace {

/// Both at once: one entry of the history.
template <int D>
void choose(Workbench<D>& bench, Text text) {
    const auto [method, budget] = split_word(text);
    Settings settings = bench.session.settings();
    settings.method = find_method<D>(bench.methods, method).id;
    settings.budget = parse_budget(budget);
    change_settings(bench, settings);
}

template <int D>
void frontier(Workbench<D>& bench, Text text) {
    Frontier<D>& frontier = bench.frontier;
    if (text == "stop" || text == "go") {
        frontier.stopped = text == "stop";
        return;
    }
    if (text == "wrong" || text == "coverage") {
        frontier.shown = text == "wrong" ? Measure::wrong : Measure::coverage;
        return;
    }
    if (text == "anew") return restart_frontier(bench);
    if (text == "finish") {
        frontier.stopped = false;
        while (advance_frontier(bench, std::numeric_limits<double>::infinity())) {
        }
        if (frontier.stopped) throw WorkError(frontier.word);
        return;
    }
    if (split_word(text)[1].empty()) throw InputError("write METHOD BUDGET, stop, go, anew, finish, wrong or coverage");
    choose(bench, text);
}

}  // namespace

template <int D>
std::span<const Command<D>> frontier_commands() {
    static constexpr std::array table{
        Command<D>{"frontier", "METHOD BUDGET | stop | go | anew | finish | wrong | coverage",
                   "set method and budget of a dot; stop or go on measuring, begin anew, measure all; what is up", "",
                   frontier<D>},
    };
    return table;
}

template std::span<const Command<2>> frontier_commands<2>();
template std::span<const Command<3>> frontier_commands<3>();

}  // namespace sightline
