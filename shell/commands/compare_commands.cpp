// Commands for two sessions beside each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/compare.h"
#include "shell/desk/open.h"

namespace sightline {

namespace {

/// METHOD_ID, FIELD=VALUE,…, preset:ID, a file or a scene, same or off.
template <int D>
void compare(Workbench<D>& bench, Text text) {
    if (text.empty()) throw InputError("write a method, FIELD=VALUE, preset:ID, a file, same or off");
    if (text == "off") return compare_off(bench);
    Settings settings = bench.session.settings();
    const auto is_method = [&](const Method<D>& method) { return method.is_called(text.substr(0, text.find(' '))); };
    std::error_code error;
    if (text.starts_with("preset:")) {
        apply_preset(settings, text.substr(7));
    } else if (std::any_of(bench.methods.begin(), bench.methods.end(), is_method)) {
        settings.method = text;
    } else if (text.find('=') != std::string::npos && !std::filesystem::exists(text, error)) {
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find(',', begin), text.size());
            apply_setting(settings, text.substr(begin, end - begin));
            begin = end + 1;
        }
        if (difference(bench.session.settings(), settings) == Invalidates::scene)
            throw InputError("'" + text + "' decides how the scene is read; compare with a state file instead");
    } else if (text != "same") {
        return compare_file(bench, text);
    }
    compare_settings(bench, settings, text);
}

template <int D>
void align(Workbench<D>& bench, Text text) {
    align_with(bench, static_cast<Align>(word_argument(text, align_words)));
}

}  // namespace

template <int D>
std::span<const Command<D>> compare_commands() {
    static constexpr std::array table{
        Command<D>{"compare", "Compare with", "METHOD | FIELD=VALUE,… | preset:ID | FILE | same | off",
                   "open a second session beside this one: with one change, or from a file", "", compare<D>},
        Command<D>{"align", "Align by", "step | rendered",
                   "keep both sides at the same step, or at the same number of rendered primitives", "", align<D>},
        Command<D>{"difference", "First difference", "", "go to the first step that differs, on both sides", "D",
                   [](Workbench<D>& bench, Text) { go_to_difference(bench); }},
        Command<D>{"swap", "Swap sides", "", "swap the left and right sides", "",
                   [](Workbench<D>& bench, Text) { swap_sides(bench); }},
    };
    return table;
}

template std::span<const Command<2>> compare_commands<2>();
template std::span<const Command<3>> compare_commands<3>();

}  // namespace sightline
