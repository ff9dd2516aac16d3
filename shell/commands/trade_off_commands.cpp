// Commands that measure: the trade-off of speed and accuracy, and what a choice by viewpoint works out beforehand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/base/error.h"
#include "core/session/settings_table.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/auto_choice.h"
#include "shell/desk/change.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/desk/work_out.h"

namespace sightline {

namespace {

/// Both at once: one entry of the history.
template <int D>
void choose(Workbench<D>& bench, Text text) {
    const std::size_t space = text.rfind(' ');
    const Variant<D> variant = make_variant<D>(bench.methods, text.substr(0, space), bench.trade_off.base);
    Settings settings = bench.session.settings();
    settings.method = variant.method.id;
    for (const ParameterRow* row : variant.method.parameters)
        settings.parameters.set(*row, variant.parameters.text(*row));
    settings.budget = parse_budget(text.substr(space + 1));
    change_settings(bench, settings);
}

template <int D>
void trade_off(Workbench<D>& bench, Text text) {
    TradeOff<D>& trade_off = bench.trade_off;
    if (text == "stop" || text == "go") {
        trade_off.stopped = text == "stop";
        return;
    }
    if (text == "wrong" || text == "coverage") {
        trade_off.shown = text == "wrong" ? Measure::wrong : Measure::coverage;
        return;
    }
    if (text == "restart") return restart_trade_off(bench);
    if (text == "finish") {
        trade_off.stopped = false;
        while (advance_trade_off(bench, std::numeric_limits<double>::infinity())) {
        }
        if (trade_off.stopped) throw WorkError(trade_off.word);
        return;
    }
    if (const auto [verb, rest] = split_word(text); verb == "add") {
        trade_off.added.push_back(make_variant<D>(bench.methods, rest).text);
        return update_trade_off(bench);
    }
    if (split_word(text)[1].empty())
        throw InputError("write METHOD BUDGET, add METHOD, stop, go, restart, finish, wrong or coverage");
    choose(bench, text);
}

template <int D>
void choose_for_me(Workbench<D>& bench, Text text) {
    if (!text.empty() && text != "again") throw InputError("write again, or nothing; set auto=off switches it off");
    choose_auto(bench, text == "again", bench.session.settings());
}

template <int D>
void work_out(Workbench<D>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"region", "all", "stop"});
    const std::size_t word = word_argument(text, words);
    word == 2 ? stop_work_out(bench) : begin_work_out(bench, word == 1);
}

template <int D>
void viewpoint(Workbench<D>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"next"});
    word_argument(text, words);
    go_to_next_entry(bench);
}

constexpr std::array worked_out{NamedArgument{"Work out region", "region"}, NamedArgument{"Work out all", "all"}};
constexpr std::array viewpoints{NamedArgument{"Work out next", "next"}};

}  // namespace

template <int D>
std::span<const Command<D>> trade_off_commands() {
    static constexpr std::array table{
        Command<D>{"trade-off", "Trade-off",
                   "METHOD BUDGET | add METHOD | stop | go | restart | finish | wrong | coverage",
                   "set this method and budget; measure one more method or variant; stop, continue, restart, finish; "
                   "choose the vertical axis",
                   "", trade_off<D>},
        Command<D>{"auto", "Automatic method", "[again]",
                   "switch the setting auto on: the method, cells and budget that the trade-off recommends here; "
                   "measured once and remembered, or again",
                   "", choose_for_me<D>, "measuring methods, up to 20 seconds"},
        Command<D>{"work-out", "Work out region", "region | all | stop",
                   "work out beforehand which technique is chosen: for all directions of the eye's region, or for all "
                   "regions; stop",
                   "", work_out<D>, "", worked_out},
        Command<D>{"viewpoint", "Work out next", "next",
                   "work out the next region and directions of which the choice is not known, and move the eye there",
                   "", viewpoint<D>, "", viewpoints},
    };
    return table;
}

template std::span<const Command<2>> trade_off_commands<2>();
template std::span<const Command<3>> trade_off_commands<3>();

}  // namespace sightline
