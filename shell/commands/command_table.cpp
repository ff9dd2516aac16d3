// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/command_table.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/text.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"

namespace sightline {

namespace {

std::vector<std::string> split_commands(std::string_view text) {
    std::vector<std::string> parts(1);
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && text.substr(i, 2) == "\"\"") {
            parts.back() += c;
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ';' && !quoted) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    if (quoted) throw InputError("commands: a quote is not closed");
    for (std::string& part : parts) {
        const std::size_t begin = part.find_first_not_of(" \t\n"), end = part.find_last_not_of(" \t\n");
        part = begin == std::string::npos ? "" : part.substr(begin, end - begin + 1);
    }
    std::erase(parts, "");
    return parts;
}

}  // namespace

std::string quote_command(std::string_view command) {
    std::string text = "\"";
    for (const char c : command) text += c == '"' ? "\"\"" : std::string(1, c);
    return text + "\"";
}

template <int D>
std::span<const CommandGroup<D>> command_groups() {
    static const std::vector<CommandGroup<D>> all{
        CommandGroup<D>{"Move", move_commands<D>()},       CommandGroup<D>{"Lesson", lesson_commands<D>()},
        CommandGroup<D>{"View", view_commands<D>()},       CommandGroup<D>{"Fly", flight_commands<D>()},
        CommandGroup<D>{"Path", path_commands<D>()},       CommandGroup<D>{"Change", change_commands<D>()},
        CommandGroup<D>{"Compare", compare_commands<D>()}, CommandGroup<D>{"Measure", trade_off_commands<D>()},
        CommandGroup<D>{"Edit", edit_commands<D>()},       CommandGroup<D>{"Mark", mark_commands<D>()},
        CommandGroup<D>{"Note", note_commands<D>()},       CommandGroup<D>{"Explain", say_commands<D>()},
        CommandGroup<D>{"File", file_commands<D>()},       CommandGroup<D>{"Window", desk_commands<D>()},
    };
    // 2D has nothing to fly with.
    static const std::vector<CommandGroup<D>> groups = [] {
        std::vector<CommandGroup<D>> some = all;
        std::erase_if(some, [](const CommandGroup<D>& group) { return group.commands.empty(); });
        return some;
    }();
    return groups;
}

template <int D>
std::span<const Command<D>> command_table() {
    static const std::vector<Command<D>> table = [] {
        std::vector<Command<D>> all;
        for (const CommandGroup<D>& group : command_groups<D>())
            all.insert(all.end(), group.commands.begin(), group.commands.end());
        return all;
    }();
    return table;
}

namespace {

/// A list of all of them would help nobody.
InputError unknown_command(const std::string& word, std::span<const std::string_view> known) {
    if (!closest(word, known).empty()) return unknown_word("command", word, known);
    constexpr std::size_t some = 12;
    std::string text = "command '" + word + "' does not exist; there are ";
    for (const std::string_view id : known.first(some)) text += std::string(id) + ", ";
    return InputError(text + "and " + std::to_string(known.size() - some) + " more: Tab lists them, as does --help");
}

/// The command and its arguments; without the colon that opens the line, which people type in it as well.
std::array<std::string, 2> words_of(std::string_view part) {
    return split_word(std::string(part.starts_with(':') ? part.substr(1) : part));
}

/// nullptr when there is no command of this id.
template <int D>
const Command<D>* find_command(std::string_view id) {
    const auto table = command_table<D>();
    const auto found = std::find_if(table.begin(), table.end(), [&](const Command<D>& c) { return c.id == id; });
    return found == table.end() ? nullptr : &*found;
}

}  // namespace

template <int D>
std::string_view slow_word(std::string_view text) try {
    for (const std::string& part : split_commands(text))
        if (const Command<D>* const command = find_command<D>(words_of(part)[0]); command && !command->slow.empty())
            return command->slow;
    return {};
} catch (const InputError&) {
    return {};  // run_commands says what is wrong
}

template <int D>
void run_commands(Workbench<D>& bench, std::string_view text) {
    for (const std::string& part : split_commands(text)) {
        const auto words = words_of(part);
        const std::string &word = words[0], &argument = words[1];
        const Command<D>* const found = find_command<D>(word);
        if (!found) {
            std::vector<std::string_view> known;
            for (const Command<D>& command : command_table<D>()) known.push_back(command.id);
            throw unknown_command(word, known);
        }
        try {
            found->run(bench, argument);
        } catch (const InputError& error) {
            throw InputError("command '" + part + "': " + error.what());
        }
        if (bench.quit) return;
    }
}

template std::span<const CommandGroup<2>> command_groups<2>();
template std::span<const CommandGroup<3>> command_groups<3>();
template std::span<const Command<2>> command_table<2>();
template std::span<const Command<3>> command_table<3>();
template std::string_view slow_word<2>(std::string_view);
template std::string_view slow_word<3>(std::string_view);
template void run_commands<2>(Workbench<2>&, std::string_view);
template void run_commands<3>(Workbench<3>&, std::string_view);

}  // namespace sightline
