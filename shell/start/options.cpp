// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/start/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/session/condition.h"
#include "core/session/settings_table.h"
#include "shell/commands/command_table.h"
#include "shell/desk/desk.h"
#include "shell/figure/figure.h"
#include "shell/window/placement.h"

namespace sightline {

namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
}

/// The tables behind the options, so that help is complete without another page.
template <int D>
std::string tables(std::span<const Method<D>> methods) {
    std::string text = "\nMethods:\n";
    for (const Method<D>& m : methods)
        text += "  " + padded(std::string(m.id), 14) + std::string(m.sentence) +
                (m.promise == Misses::may ? " [approximate]\n" : " [conservative]\n");
    text += "\nPresets:\n";
    for (const Preset& p : presets()) text += "  " + padded(std::string(p.id), 14) + std::string(p.title) + "\n";
    text += "\nSettings (--set FIELD=VALUE), with default and source:\n";
    const Settings defaults;
    for (const SettingRow& row : settings_table())
        if (row.dimension == 0 || row.dimension == D)
            text += "  " + padded(std::string(row.name), 24) + std::string(row.help) + "\n" + std::string(26, ' ') +
                    std::string(row.values) + "; default " + row.get(defaults) + "; " + std::string(row.source) + "\n";
    text += "\nCommands (--do):\n";
    for (const Command<D>& c : command_table<D>())
        text += "  " + padded(std::string(c.id) + " " + std::string(c.arguments), 34) + std::string(c.text) + "\n";
    text += "\nFields of conditions (--until), values after a step:\n";
    for (const RecordField<D>& field : record_fields<D>())
        text += "  " + padded(std::string(field.name), 16) + std::string(field.help) + "\n";
    return text;
}

std::array<int, 2> window_size(const std::string& text) {
    const std::size_t x = text.find('x');
    const auto w = x == std::string::npos ? std::nullopt : parse_whole(std::string_view(text).substr(0, x));
    const auto h = w ? parse_whole(std::string_view(text).substr(x + 1)) : std::nullopt;
    const auto fits = [](std::uint32_t size, int least) {
        return size >= static_cast<std::uint32_t>(least) && size <= static_cast<std::uint32_t>(largest_size);
    };
    if (!h || !fits(*w, smallest_width) || !fits(*h, smallest_height))
        throw InputError("--window '" + text + "': write a size such as 1280x720, at least " +
                         std::to_string(smallest_width) + "x" + std::to_string(smallest_height));
    return {static_cast<int>(*w), static_cast<int>(*h)};
}

/// Numbers as they were typed, before anything says what is wrong with them.
struct Typed {
    std::string fov, steps, font, dpi, columns, scale, window, frame, frames;
};

template <int D>
void add_scene_options(CLI::App& app, Options& o, Typed& typed) {
    constexpr const char* point = D == 2 ? "X,Y" : "X,Y,Z";
    app.add_option("SCENE", o.scene,
                   D == 2
                       ? "a catalogue id (--list), a file (Sightline JSON, GeoJSON, Doom WAD as FILE.wad#MAP), "
                         "freedoom1#E1M2, or a state file; default: the last one opened; without a window, bottleneck"
                       : "a catalogue id (--list), optionally with a size (city:100k), a file (OBJ, PLY, STL, OFF, "
                         "glTF, GLB and whatever else Assimp reads), a folder of them, or a state file; default: "
                         "the last one opened; without a window, bottleneck");
    app.add_flag("--list", o.list,
                 D == 2 ? "print the catalogue and the installed levels, and exit" : "print the catalogue, and exit");
    app.add_flag("--headless", o.headless, "no window: run the options, write the files, exit");
    app.add_option("--eye", o.eye, std::string(point) + " of the eye, in the file's coordinates");
    app.add_option("--look-at", o.look_at, std::string(point) + " of a point to look at");
    if (D == 3) app.add_option("--up", o.up, "x, y or z: the axis that points up; as --set up=");
    app.add_option("--fov", typed.fov,
                   D == 2 ? "field of view in degrees; 360 looks all around" : "vertical field of view in degrees");
}

void add_setting_options(CLI::App& app, Options& o) {
    app.add_option("--method", o.method, "method id, see below");
    app.add_option("--preset", o.preset, "preset id, see below");
    app.add_option("--cells", o.cells,
                   "file with the scene's cells: read if it exists, else the cells are made and written to it");
    app.add_option("--settings", o.settings_file, "file with settings, such as lab cells writes; --set overrides it");
    app.add_option("--set", o.settings, "FIELD=VALUE, see below; may be given several times")->allow_extra_args(false);
    app.add_flag(
        "--auto", o.automatic,
        "as --set auto=on: method, cells and budget that the trade-off of this scene on this machine recommends, "
        "measured once, in up to 20 seconds, and remembered; --method, --budget, --preset, --settings and --set "
        "override it");
    app.add_option("--budget", o.budget, "500 | 5% | 16ms | unlimited");
}

template <int D>
void add_step_options(CLI::App& app, Options& o, Typed& typed) {
    app.add_option("--steps", typed.steps, "start at step 0 and go to step N");
    app.add_option(
        "--until", o.until,
        "start at step 0 and stop at step:N, cell:ID, primitive:ID, object:NAME or where an expression holds");
    app.add_option("--do", o.commands, "\"COMMAND; COMMAND\": start at step 0 and run commands, see below");
    app.add_option("--path", o.path, "a flight path of the scene (--list) or from a file; opens at its first frame");
    app.add_option("--frame", typed.frame, "frame of the path to open at, from 0");
    app.add_option(
        "--frames", typed.frames,
        "with --headless and --stats: write the statistics of N frames spread evenly over the path, as an array");
}

void add_file_options(CLI::App& app, Options& o, Typed& typed) {
    app.add_option("--shot", o.shots, "write a figure: FILE.png, .svg or .pdf; its sidecar is FILE.ext.json")
        ->allow_extra_args(false);
    app.add_option("--panels", o.panels, "\"step 1; step 12; end\": a figure with panels (a), (b), (c)");
    app.add_option("--size", o.size, "size of the figure: a width such as 84mm, or pixels such as 1280x720");
    app.add_option("--font", typed.font, "size of the figure's text, such as 8pt");
    app.add_option("--dpi", typed.dpi, "resolution of a PNG whose width is in millimetres, such as 600; default 300");
    app.add_option("--columns", typed.columns, "columns of the figure's panels: 3 puts three beside each other");
    app.add_option(
        "--state", o.state,
        "open a state file or sidecar: same scene, settings, view, step; SCENE, if given, in place of its scene");
    app.add_option("--page", o.page,
                   "the page that the command page takes, such as a sightline.html; default: the one that ./run web "
                   "has made");
    app.add_option("--trace", o.trace, "write the records of all steps as JSON (- for standard output)");
    app.add_option("--stats", o.stats, "write the statistics as JSON (- for standard output)");
}

void add_window_options(CLI::App& app, Typed& typed) {
    app.add_option("--scale", typed.scale,
                   "scale of text and controls, such as 1.5; default: chosen from the screen's pixel density");
    app.add_option("--window", typed.window, "size of the window at the start, such as 1280x720");
}

double number_option(const std::string& option, std::string text, std::string_view unit = "") {
    if (!unit.empty() && text.ends_with(unit)) text.resize(text.size() - unit.size());
    const auto value = parse_number(text);
    if (!value) throw InputError(option + " '" + text + "': not a number");
    return *value;
}

std::uint32_t whole_option(const std::string& option, const std::string& text, const char* what) {
    const auto value = parse_whole(text);
    if (!value) throw InputError(option + " '" + text + "': not a " + what);
    return *value;
}

void read_numbers(const Typed& typed, Options& o) {
    if (!typed.fov.empty()) o.fov = number_option("--fov", typed.fov);
    if (!typed.font.empty()) o.font_pt = number_option("--font", typed.font, "pt");
    if (!typed.dpi.empty()) o.dpi = number_option("--dpi", typed.dpi, "dpi");
    if (!typed.columns.empty()) o.columns = whole_option("--columns", typed.columns, "number of columns");
    if (!typed.steps.empty()) o.steps = whole_option("--steps", typed.steps, "number of steps");
    if (!typed.frame.empty()) o.frame = whole_option("--frame", typed.frame, "whole number");
    if (!typed.frames.empty()) o.frames = whole_option("--frames", typed.frames, "whole number");
}

void check_path(const Options& o) {
    if ((o.frame || o.frames) && o.path.empty()) throw InputError("--frame and --frames need --path");
    if (!o.path.empty() && !(o.eye.empty() && o.look_at.empty()))
        throw InputError("--path sets the view: leave out --eye and --look-at");
    if (o.frames && (*o.frames == 0 || o.frame || !o.headless || o.stats.empty() || o.steps || !o.until.empty() ||
                     !o.commands.empty() || !o.shots.empty() || !o.trace.empty()))
        throw InputError(
            "--frames: at least one frame, with --headless and --stats; without --frame, --steps, --until, --do, "
            "--shot and --trace");
}

void read_window(const Typed& typed, Options& o) {
    if (!typed.scale.empty()) {
        o.scale = number_option("--scale", typed.scale);
        if (!(*o.scale >= smallest_scale && *o.scale <= largest_scale))
            throw InputError("--scale '" + typed.scale + "': not between " + short_number(smallest_scale) + " and " +
                             short_number(largest_scale));
    }
    if (!typed.window.empty()) o.window = window_size(typed.window);
    if (o.headless && (o.scale || o.window)) throw InputError("--scale and --window need a window; remove --headless");
}

/// What is given and empty would be ignored without a word.
void check_given(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_name() == "--do") continue;  // a script may have nothing to do
        for (const std::string& value : option->results())
            if (value.empty()) throw InputError(option->get_name() + " '': is empty");
    }
}

void check_scene(const Options& o) {
    for (const std::string& shot : o.shots) check_figure_name(shot);  // not after a long run
    if (!o.state.empty() && !o.cells.empty()) throw InputError("--cells needs a scene of its own: leave out --state");
    if (!o.cells.empty() && o.scene.empty()) throw InputError("--cells needs a scene: name the scene, too");
}

}  // namespace

template <int D>
std::optional<Options> parse_options(int argc, const char* const* argv, std::span<const Method<D>> methods) {
    Options o;
    Typed typed;
    CLI::App app{
        std::string("Steps occlusion-culling methods through a scene of ") + (D == 2 ? "line segments" : "triangles") +
            ", forward and back, explains every number, measures it against the exact visible set, and writes figures.",
        D == 2 ? "viewer2d" : "viewer3d"};
    app.get_formatter()->column_width(34);
    add_scene_options<D>(app, o, typed);
    add_setting_options(app, o);
    add_step_options<D>(app, o, typed);
    add_file_options(app, o, typed);
    add_window_options(app, typed);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help() << tables<D>(methods);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        throw InputError(std::string(error.what()) + " (--help lists the options)");
    }
    check_given(app);
    read_numbers(typed, o);
    check_path(o);
    read_window(typed, o);
    check_scene(o);
    return o;
}

template std::optional<Options> parse_options<2>(int, const char* const*, std::span<const Method<2>>);
template std::optional<Options> parse_options<3>(int, const char* const*, std::span<const Method<3>>);

}  // namespace sightline
