// Commands of the frontier of speed and accuracy.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/base/error.h"
#include "core/session/settings_table.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/change.h"
#include "shell/desk/measure_frontier.h"

namespace sightline {

namespace {

/// Both at once: one entry of the history.
template <int D>
void choose(Workbench<D>& bench, Text text) {
    const std::size_t space = text.rfind(' ');
    const Variant<D> variant = make_variant<D>(bench.methods, text.substr(0, space), bench.frontier.base);
    Settings settings = bench.session.settings();
    settings.method = variant.method.id;
    for (const ParameterRow* row : variant.method.parameters)
        settings.parameters.set(*row, variant.parameters.text(*row));
    settings.budget = parse_budget(text.substr(space + 1));
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
    if (const auto [verb, rest] = split_word(text); verb == "add") {
        frontier.added.push_back(make_variant<D>(bench.methods, rest).text);
        return update_frontier(bench);
    }
    if (split_word(text)[1].empty())
        throw InputError("write METHOD BUDGET, add METHOD, stop, go, anew, finish, wrong or coverage");
    choose(bench, text);
}

}  // namespace

template <int D>
std::span<const Command<D>> frontier_commands() {
    static constexpr std::array table{
        Command<D>{"frontier", "METHOD BUDGET | add METHOD | stop | go | anew | finish | wrong | coverage",
                   "set method and budget of a dot; measure one more method or variant; stop, go on, restart, finish; "
                   "choose the vertical axis",
                   "", frontier<D>},
    };
    return table;
}

template std::span<const Command<2>> frontier_commands<2>();
template std::span<const Command<3>> frontier_commands<3>();

}  // namespace sightline
