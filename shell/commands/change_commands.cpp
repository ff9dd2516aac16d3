// Commands that change settings, and undo.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/auto_choice.h"
#include "shell/desk/change.h"
#include "shell/desk/complete.h"
#include "shell/desk/undo.h"

namespace sightline {

namespace {

template <int D>
void set(Workbench<D>& bench, Text text) {
    Settings settings = bench.session.settings();
    apply_setting(settings, text, bench.session.method());
    change_by_hand(bench, settings);
}

template <int D>
void cycle(Workbench<D>& bench, Text text) {
    const SettingRow& row = setting_row(text);
    if (row.words.empty()) throw InputError("'" + text + "' has no list of values to cycle through");
    const auto now = std::find(row.words.begin(), row.words.end(), row.get(bench.session.settings()));
    const std::string next(now + 1 == row.words.end() ? row.words.front() : *(now + 1));
    set(bench, text + "=" + next);
    bench.say(text + "=" + next);
}

template <int D>
void preset(Workbench<D>& bench, Text text) {
    Settings settings = bench.session.settings();
    apply_preset(settings, text);
    change_settings(bench, settings);
}

constexpr std::array cycled{NamedArgument{"Heat map", "heat"},
                            NamedArgument{"Cell labels", "label"},
                            NamedArgument{"Penalty", "penalty"},
                            NamedArgument{"Facet normals", "show_normals"},
                            NamedArgument{"Penalty marks", "show_penalties"},
                            NamedArgument{"Chain of updates", "show_chain"},
                            NamedArgument{"Planes of a box", "show_planes"},
                            NamedArgument{"Regions by technique", "show_regions"},
                            NamedArgument{"Colours", "palette"},
                            NamedArgument{"Split picture", "split"},
                            NamedArgument{"Inset picture", "inset"},
                            NamedArgument{"Triangles shown", "triangles"},
                            NamedArgument{"Cells shown", "only"},
                            NamedArgument{"Slice", "slice"}};

constexpr std::array named_methods{NamedArgument{"Choose by viewpoint", "by-viewpoint"}};

}  // namespace

template <int D>
std::span<const Command<D>> change_commands() {
    static constexpr std::array table{
        Command<D>{"set", "Set value", "FIELD=VALUE", "change a setting", "", set<D>},
        Command<D>{"cycle", "Next value", "FIELD", "change a setting to its next value",
                   D == 2 ? "H=heat L=label K=penalty N=show_normals Shift+N=show_planes X=show_penalties M=show_chain"
                          : "H=heat L=label K=penalty N=show_normals Shift+N=show_planes X=show_penalties M=show_chain "
                            "Z=split Shift+Z=inset",
                   cycle<D>, "", cycled},
        Command<D>{"preset", "Preset", "ID", "apply a named set of settings", "", preset<D>},
        Command<D>{"method", "Method", "ID", "change the method", "",
                   [](Workbench<D>& bench, Text text) { set(bench, "method=" + text); }, "", named_methods},
        Command<D>{
            "complete", "Complete picture", "",
            "go on from here in the rounds of cPLP, which complete the picture; in flight they do so wherever the "
            "eye rests; again: without them",
            "Shift+C", [](Workbench<D>& bench, Text) { complete(bench); }},
        Command<D>{"budget", "Budget", "B", "change the budget: 500, 5%, 16ms or unlimited", "",
                   [](Workbench<D>& bench, Text text) { set(bench, "budget=" + text); }},
        Command<D>{"undo", "Undo", "", "undo a change of view, settings, scene or notes; never a step", "Ctrl+Z",
                   [](Workbench<D>& bench, Text) { bench.say(undo(bench) ? "undone" : "nothing to undo"); }},
        Command<D>{"redo", "Redo", "", "redo the change that was undone", "Ctrl+Y Ctrl+Shift+Z",
                   [](Workbench<D>& bench, Text) { bench.say(redo(bench) ? "redone" : "nothing to redo"); }},
    };
    return table;
}

template std::span<const Command<2>> change_commands<2>();
template std::span<const Command<3>> change_commands<3>();

}  // namespace sightline
