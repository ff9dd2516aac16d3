// Commands for two sessions beside each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/plp/plp_parameters.h"
#include "core/scene/make/catalogue.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/compare.h"
#include "shell/desk/open.h"

namespace sightline {

namespace {

/// What a person may call a method here, beside its id, aliases and title.
struct Name {
    std::string_view name, method;
};
constexpr std::array names{Name{"by distance", "centroid"}, Name{"oracle", "perfect"}, Name{"view only", "view"}};

constexpr std::array compared{NamedArgument{"Penalty on or off", "penalty"}, NamedArgument{"By distance", "distance"},
                              NamedArgument{"Perfect order", "perfect order"}, NamedArgument{"View only", "view only"},
                              NamedArgument{"Stop comparing", "off"}};
constexpr std::array alignments{NamedArgument{"By steps", "step"}, NamedArgument{"By drawn", "drawn"}};

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
    return small;
}

/// The method, or the variant of one, that the text names; empty: it names none.
template <int D>
std::string method_called(const Workbench<D>& bench, const std::string& text) {
    const std::string small = lower(text);
    for (const Name& name : names)
        if (small == name.name) return std::string(name.method);
    for (const Method<D>& method : bench.methods)
        if (small == lower(method.title)) return std::string(method.id);
    for (const Method<D>& method : bench.methods)
        if (method.is_called(text.substr(0, text.find(' ')))) return text;
    return "";
}

/// The penalty off where it is paid, and on where it is not.
template <int D>
void turn_penalty(const Workbench<D>& bench, Settings& settings) {
    const Method<D>& method = bench.session.method();
    if (!method.parameter("penalty")) throw InputError(std::string(method.title) + " knows no penalty");
    if (settings.parameters.choice<Penalty>(penalty_row()) == Penalty::none ||
        settings.parameters.choice<Switch>(star_shaped_row()) == Switch::off) {
        settings.parameters.set(star_shaped_row(), "on");
        if (settings.parameters.choice<Penalty>(penalty_row()) == Penalty::none)
            settings.parameters.set(penalty_row(), penalty_row().otherwise);
    } else {
        settings.parameters.set(penalty_row(), "none");
    }
}

/// Of a text that may name a scene or a file: where it names none, says all that could have been meant.
template <int D>
void compare_with_file(Workbench<D>& bench, const std::string& text) try {
    compare_file(bench, text);
} catch (const InputError&) {
    std::error_code error;
    if (std::filesystem::exists(text, error) || find_in_catalogue<D>(text)) throw;
    std::string ids;
    std::vector<std::string_view> known;
    for (const Method<D>& method : bench.methods) {
        ids += ", " + std::string(method.id);
        known.push_back(method.id);
    }
    for (const NamedArgument& named : compared) known.push_back(named.argument);
    if (const std::string_view meant = closest(text, known); !meant.empty())
        throw InputError("'" + text + "' cannot be compared with; did you mean " + std::string(meant) + "?");
    throw InputError("'" + text +
                     "' cannot be compared with; write penalty, distance, perfect order, view only, another method (" +
                     ids.substr(2) + "), FIELD=VALUE, preset:ID, a scene, a file, same or off");
}

/// What the help says: words, METHOD, FIELD=VALUE,…, preset:ID, a file or a scene, same or off.
template <int D>
void compare(Workbench<D>& bench, Text argument) {
    std::string text = argument;
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    if (text.empty()) throw InputError("write a method, penalty, FIELD=VALUE, preset:ID, a file, same or off");
    if (text == "off") return compare_off(bench);
    Settings settings = bench.session.settings();
    std::error_code error;
    if (text == "penalty") {
        turn_penalty(bench, settings);
    } else if (text.starts_with("preset:")) {
        apply_preset(settings, text.substr(7));
    } else if (const std::string method = method_called(bench, text); !method.empty()) {
        settings.method = method;
    } else if (text.find('=') != std::string::npos && !std::filesystem::exists(text, error)) {
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find(',', begin), text.size());
            apply_setting(settings, text.substr(begin, end - begin));
            begin = end + 1;
        }
        if (difference(bench.session.settings(), settings) == Invalidates::scene)
            throw InputError("'" + text + "' decides how the scene is read; compare with a state file instead");
    } else if (text != "same") {
        return compare_with_file(bench, text);
    }
    compare_settings(bench, settings, text);
}

template <int D>
void align(Workbench<D>& bench, Text text) {
    align_with(bench, text == "drawn" ? Align::rendered : static_cast<Align>(word_argument(text, align_words)));
}

}  // namespace

template <int D>
std::span<const Command<D>> compare_commands() {
    static constexpr std::array table{
        Command<D>{"compare", "Compare with", "METHOD | penalty | FIELD=VALUE,… | preset:ID | FILE | same | off",
                   "open a second session beside this one: with one change, or from a file", "", compare<D>, "",
                   compared},
        Command<D>{"align", "Align by", "step | drawn",
                   "keep both sides at the same step, or at the same number of drawn primitives", "", align<D>, "",
                   alignments},
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
