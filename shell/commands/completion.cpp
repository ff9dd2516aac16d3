// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/completion.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/glossary.h"
#include "core/methods/techniques.h"
#include "core/scene/make/catalogue.h"
#include "core/session/settings_table.h"
#include "shell/commands/command_table.h"
#include "shell/panels/panel.h"

namespace sightline {

namespace {

using Words = std::vector<std::string>;

/// "[all | eye | direction]" has three words; what is written in capitals stands for something else.
void add_literal_words(std::string_view arguments, Words& words) {
    std::string word;
    const auto end = [&] {
        const bool literal = !word.empty() && std::islower(static_cast<unsigned char>(word[0]));
        if (literal && word.find('=') == std::string::npos) words.push_back(word);
        word.clear();
    };
    for (const char c : arguments)
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '=')
            word += c;
        else
            end();
    end();
}

/// Files and folders that the typed path may become.
void add_files(const std::string& typed, Words& words) {
    const std::size_t slash = typed.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : typed.substr(0, slash + 1);
    std::error_code error;
    for (std::filesystem::directory_iterator i(folder.empty() ? "." : folder, error), end; !error && i != end;
         i.increment(error)) {
        const std::string name = i->path().filename().string();
        std::error_code none_of_ours;
        if (!name.starts_with('.')) words.push_back(folder + name + (i->is_directory(none_of_ours) ? "/" : ""));
    }
}

template <int D>
void add_settings(const Workbench<D>& bench, const std::string& typed, bool values, Words& words) {
    const std::size_t equals = typed.find('=');
    for (const SettingRow& row : settings_table()) {
        if (!applies(row, bench.session.method())) continue;
        const std::string name(row.name);
        if (!values)
            words.push_back(name);
        else if (equals == std::string::npos)
            words.push_back(name + "=");
        else if (name == typed.substr(0, equals))
            for (const std::string_view word : row.words) words.push_back(name + "=" + std::string(word));
    }
}

template <int D>
void add_words(const Workbench<D>& bench, std::string_view command, const std::string& typed, Words& words) {
    if (command == "method" || command == "compare")
        for (const Method<D>& method : bench.methods) words.emplace_back(method.id);
    if (command == "set" || command == "compare") add_settings(bench, typed, true, words);
    if (command == "cycle") add_settings(bench, typed, false, words);
    if (command == "show")
        for (const Panel<D>& panel : panel_table<D>()) words.emplace_back(panel.id);
    if (command == "glossary")
        for (const GlossaryEntry& entry : glossary()) words.emplace_back(entry.term);
    if (command == "techniques")
        for (const Technique& technique : techniques()) words.emplace_back(technique.id);
    if (command == "open")
        for (const CatalogueRow<D>& row : catalogue<D>()) words.emplace_back(row.id);
    if (command == "open" || command == "compare" || command == "lesson") add_files(typed, words);
    if (command == "lesson") try {
            for (const Lesson& lesson : read_lessons(lessons_of_the_project()))
                if (lesson.dimension == D) words.push_back(lesson.id);
        } catch (const InputError&) {  // the command itself says what is wrong with them
        }
}

}  // namespace

template <int D>
Completion completions(const Workbench<D>& bench, const std::string& line) {
    const std::size_t semicolon = line.rfind(';'), begin = semicolon == std::string::npos ? 0 : semicolon + 1;
    const std::size_t first = std::min(line.find_first_not_of(' ', begin), line.size());
    const std::size_t space = line.rfind(' ');
    const bool is_command = space == std::string::npos || space < first;
    Completion completion{is_command ? first : space + 1, {}};
    const std::string typed = line.substr(completion.from);
    Words words;
    if (is_command) {
        for (const Command<D>& command : command_table<D>()) words.emplace_back(command.id);
    } else {
        const std::string id = line.substr(first, line.find(' ', first) - first);
        for (const Command<D>& command : command_table<D>())
            if (command.id == id) add_literal_words(command.arguments, words);
        add_words(bench, id, typed, words);
    }
    std::erase_if(words, [&](const std::string& word) { return !word.starts_with(typed); });
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    completion.words = std::move(words);
    return completion;
}

std::string completed(const std::string& line, const Completion& completion) {
    const auto& words = completion.words;
    if (words.empty()) return line;
    std::string shared = words.front();
    for (const std::string& word : words)
        shared.resize(static_cast<std::size_t>(
            std::mismatch(shared.begin(), shared.end(), word.begin(), word.end()).first - shared.begin()));
    const bool whole = words.size() == 1 && !shared.ends_with('=') && !shared.ends_with('/');
    return line.substr(0, completion.from) + shared + (whole ? " " : "");
}

template Completion completions<2>(const Workbench<2>&, const std::string&);
template Completion completions<3>(const Workbench<3>&, const std::string&);

}  // namespace sightline
