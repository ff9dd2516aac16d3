// Commands that read and write files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/session/report.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/launch.h"
#include "shell/desk/open.h"
#include "shell/desk/recent.h"
#include "shell/export/export.h"
#include "shell/export/film.h"
#include "shell/export/handout.h"

namespace sightline {

namespace {

/// Where no speed is asked for.
constexpr double spec_frames_per_second = 25;

/// "FROM-TO" or "FROM-end"; nothing for what is neither.
std::optional<std::array<std::uint32_t, 2>> film_range(std::string_view text) {
    if (!text.ends_with("-end")) return parse_steps(text);
    const auto from = parse_whole(text.substr(0, text.size() - 4));
    return from ? std::optional(std::array{*from, film_to_end}) : std::nullopt;
}

/// FROM-TO FILE [4fps] | path [FROM-TO] FILE [25fps]
template <int D>
void film(Workbench<D>& bench, Text text) {
    FilmSpec spec;
    std::string rest = text;
    const auto take_word = [&] {
        const auto [word, after] = split_word(rest);
        rest = after;
        return word;
    };
    if (split_word(rest)[0] == "path") {
        take_word();
        spec.path = true;
        spec.frames_per_second = spec_frames_per_second;
        spec.last = film_to_end;
    }
    if (const auto range = film_range(split_word(rest)[0])) {
        take_word();
        spec.first = (*range)[0];
        spec.last = (*range)[1];
    } else if (!spec.path) {
        throw InputError("write the first and last step of the film as FROM-TO, such as 0-20 or 0-end");
    }
    spec.file = rest;
    const std::size_t space = rest.rfind(' ');
    if (space != std::string::npos && rest.ends_with("fps")) {
        const std::string speed = rest.substr(space + 1, rest.size() - space - 4);
        spec.frames_per_second = number_argument(speed, "a speed such as 4fps");
        spec.file = rest.substr(0, rest.find_last_not_of(' ', space) + 1);
    }
    file_argument(spec.file);
    write_film(bench, spec);
}

/// Browsers go by the ending.
std::string page_argument(Text text) {
    const std::string file = file_argument(text);
    if (!file.ends_with(".html")) throw InputError("a page is a file such as handout.html");
    return file;
}

template <int D>
void copy(Workbench<D>& bench, Text) {
    if (!bench.clipboard.set) throw InputError("there is no clipboard without a window");
    bench.clipboard.set(bench_state(bench));
    bench.say("state copied to the clipboard, as text");
}

template <int D>
void paste(Workbench<D>& bench, Text) {
    if (!bench.clipboard.get) throw InputError("there is no clipboard without a window");
    open_state_text(bench, bench.clipboard.get(), "clipboard");
    bench.say("opened the state on the clipboard");
}

template <int D>
void other_viewer(Workbench<D>& bench, Text text) {
    const std::string program = D == 2 ? "viewer3d" : "viewer2d";
    launch(program, text);
    bench.say(program + " opens in a window of its own");
}

}  // namespace

template <int D>
std::span<const Command<D>> file_commands() {
    static constexpr std::array table{
        Command<D>{"open", "Open file", "SCENE | FILE", "open a scene (catalogue id or file) or a state file",
                   "Ctrl+O=?",
                   [](Workbench<D>& bench, Text text) {
                       open(bench, file_argument(text));
                       note_opened<D>(bench.recent, text);
                   }},
        Command<D>{D == 2 ? "viewer3d" : "viewer2d", D == 2 ? "3D viewer" : "2D viewer", "[SCENE]",
                   "open the other viewer in its own window", "", other_viewer<D>},
        Command<D>{"size", "Figure size", "84mm | WxH | 8pt | 600dpi",
                   "set the size of figures, of their text, the resolution of their pixels", "",
                   [](Workbench<D>& bench, Text text) { set_figure_size(bench, text); }},
        Command<D>{"shot", "Export figure", "FILE", "write a figure (.png, .svg, .pdf) and its sidecar", "Ctrl+E=?",
                   [](Workbench<D>& bench, Text text) { write_shot(bench, file_argument(text)); }},
        Command<D>{"page", "Export page", "FILE", "write what is shown as a page for any browser (.html)", "",
                   [](Workbench<D>& bench, Text text) { write_page(bench, page_argument(text)); }},
        Command<D>{"film", "Export film", D == 2 ? "FROM-TO FILE [4fps]" : "[path] FROM-TO FILE [4fps]",
                   D == 2 ? "write steps as numbered .png, as pages of a .pdf, as .gif or as .mp4"
                          : "write steps, or frames of the path, as numbered .png, pages of a .pdf, .gif or .mp4",
                   "", film<D>, "Writing the film; the window will not respond until it is done."},
        Command<D>{"save", "Save state", "FILE", "write a state file", "Ctrl+S=?",
                   [](Workbench<D>& bench, Text text) { write_text(file_argument(text), bench_state(bench)); }},
        Command<D>{"cells", "Export cells", "FILE", "save the cells and the primitives in them, for --cells", "",
                   [](Workbench<D>& bench, Text text) { write_cells(bench, file_argument(text)); }},
        Command<D>{"trace", "Export trace", "FILE", "save the records of all steps so far", "",
                   [](Workbench<D>& bench, Text text) { write_text(file_argument(text), trace_json(bench.session)); }},
        Command<D>{"stats", "Export statistics", "FILE", "save the statistics of the run", "",
                   [](Workbench<D>& bench, Text text) {
                       write_text(file_argument(text), stats_json(bench.session, bench.last_stop));
                   }},
        Command<D>{"copy", "Copy state", "", "copy the whole state to the clipboard, as text", "Ctrl+C", copy<D>},
        Command<D>{"paste", "Paste state", "", "open the state on the clipboard", "Ctrl+V", paste<D>},
        Command<D>{"quit", "Quit", "", "close the program", "Ctrl+Q",
                   [](Workbench<D>& bench, Text) { bench.quit = true; }},
    };
    return table;
}

template std::span<const Command<2>> file_commands<2>();
template std::span<const Command<3>> file_commands<3>();

}  // namespace sightline
