// Commands that change where the traversal looks from, and how much of it the picture shows.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/change.h"
#include "shell/desk/moved.h"
#include "shell/desk/undo.h"
#include "shell/desk/zoom.h"

namespace sightline {

namespace {

template <int D>
void eye(Workbench<D>& bench, Text text) {
    ViewSpec<D> view = bench.session.display_view();
    view.eye = parse_point(text, bench.session.scene());
    change_view(bench, view);
}

template <int D>
void look(Workbench<D>& bench, Text text) {
    ViewSpec<D> view = bench.session.display_view();
    view.look_at = text == "selected" ? box_of_selection(bench).centre() : parse_point(text, bench.session.scene());
    change_view(bench, view);
}

template <int D>
void fov(Workbench<D>& bench, Text text) {
    ViewSpec<D> view = bench.session.display_view();
    view.fov = number_argument(text, "an angle in degrees");
    change_view(bench, view);
}

template <int D>
void freeze(Workbench<D>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"all", "eye", "direction"});
    constexpr std::array parts{Frozen::all, Frozen::eye, Frozen::direction};
    const Frozen part = parts[text.empty() ? 0 : word_argument(text, words)];
    remember(bench);
    bench.session.freeze(part);
    moved(bench);
}

template <int D>
void unfreeze(Workbench<D>& bench, Text) {
    remember(bench);
    bench.session.unfreeze();
    moved(bench);
}

template <int D>
void pan_by(Workbench<D>& bench, Text text) {
    const auto shares = parse_pair(text);
    if (!shares) throw InputError("write by which share of the picture to move as DX,DY");
    pan(bench, *shares);
}

template <int D>
void eye_strip(Workbench<D>& bench, Text) {
    Settings settings = bench.session.settings();
    settings.show_eye = settings.show_eye == Switch::on ? Switch::off : Switch::on;
    change_settings(bench, settings);
}

template <int D>
void fit_to(Workbench<D>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"selected"});
    if (text.empty()) return fit(bench);
    word_argument(text, words);
    fit_selection(bench);
}

constexpr std::array looked_at{NamedArgument{"Look at selection", "selected"}};
constexpr std::array fitted{NamedArgument{"Go to selection", "selected"}};
constexpr std::array zooms{NamedArgument{"Zoom in", "1.25"}, NamedArgument{"Zoom out", "0.8"}};
constexpr std::array pans{NamedArgument{"Pan right", "0.1,0"}, NamedArgument{"Pan left", "-0.1,0"},
                          NamedArgument{"Pan up", "0,0.1"}, NamedArgument{"Pan down", "0,-0.1"}};

}  // namespace

template <int D>
std::span<const Command<D>> view_commands() {
    static constexpr std::array table{
        Command<D>{"eye", "Move eye", D == 2 ? "X,Y" : "X,Y,Z",
                   "move the eye; while frozen, move only the eye of the display view", "", eye<D>},
        Command<D>{"look", "Look at", D == 2 ? "X,Y | selected" : "X,Y,Z | selected",
                   "turn the view towards a point, or to what is selected", "", look<D>, "", looked_at},
        Command<D>{"fov", "Field of view", "DEGREES",
                   D == 2 ? "set the field of view; 360 looks all around" : "set the field of view", "", fov<D>},
        Command<D>{"fit", "Whole scene", "[selected]",
                   D == 2 ? "show the whole scene again, or what is selected in the middle of the picture"
                          : "show the whole scene again, or freeze the view and go to what is selected",
                   "0 Shift+X=selected", fit_to<D>, "", fitted},
        Command<D>{"zoom", "Zoom", "FACTOR", "zoom about the centre of the picture", "+=1.25 -=0.8",
                   [](Workbench<D>& bench, Text text) { zoom(bench, number_argument(text, "a factor")); }, "", zooms},
        Command<D>{"pan", "Pan", "DX,DY", "pan by a share of the picture: 0.1,0 moves to the right",
                   "Alt+Right=0.1,0 Alt+Left=-0.1,0 Alt+Up=0,0.1 Alt+Down=0,-0.1", pan_by<D>, "", pans},
        Command<D>{"freeze", "Freeze view", "[all | eye | direction]",
                   "freeze the culling view, or only its eye or direction; then only the display view moves", "F",
                   freeze<D>},
        Command<D>{"unfreeze", "End freeze", "", "end the freeze: one view for culling and display", "Shift+F",
                   unfreeze<D>},
        Command<D>{"eye-strip", "What the eye sees", "",
                   "show or hide a strip under the plan: exact above, drawn so far below, red where they differ", "Z",
                   eye_strip<D>},
    };
    // In 3D an inset shows what the eye sees.
    return std::span(table).first(D == 2 ? table.size() : table.size() - 1);
}

template std::span<const Command<2>> view_commands<2>();
template std::span<const Command<3>> view_commands<3>();

}  // namespace sightline
