// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/scene_filter.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace sightline {

namespace {

std::string small_letters(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
    return small;
}

}  // namespace

std::size_t SceneRows::count() const {
    std::size_t n = 0;
    for (const auto& row : rows) n += row.size();
    return n;
}

SceneRows scene_rows(const std::vector<SceneChoice>& choices, std::string_view filter, std::size_t columns) {
    std::vector<std::string> words;
    std::istringstream typed(small_letters(filter));
    for (std::string word; typed >> word;) words.push_back(word);
    SceneRows found;
    const std::string* group = nullptr;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const SceneChoice& choice = choices[i];
        const std::string text =
            small_letters(choice.name + "\n" + choice.title + "\n" + choice.sentence + "\n" + choice.group);
        const auto is_there = [&](const std::string& word) { return text.find(word) != std::string::npos; };
        if (!std::all_of(words.begin(), words.end(), is_there)) continue;
        if (!group || *group != choice.group || found.rows.back().size() == columns) found.rows.emplace_back();
        group = &choice.group;
        found.rows.back().push_back(i);
    }
    return found;
}

SceneSpot moved_spot(const SceneRows& rows, SceneSpot from, int down, int right) {
    if (rows.rows.empty()) return {};
    const std::size_t last = rows.rows.size() - 1;
    SceneSpot to{std::min(from.row, last), from.column};
    to.column = std::min(to.column, rows.rows[to.row].size() - 1);
    for (; right > 0; --right) {
        if (to.column + 1 < rows.rows[to.row].size())
            ++to.column;
        else if (to.row < last)
            to = {to.row + 1, 0};
    }
    for (; right < 0; ++right) {
        if (to.column > 0)
            --to.column;
        else if (to.row > 0)
            to = {to.row - 1, rows.rows[to.row - 1].size() - 1};
    }
    if (down != 0) {
        const auto row = static_cast<long>(to.row) + down;
        to.row = static_cast<std::size_t>(std::clamp<long>(row, 0, static_cast<long>(last)));
        to.column = std::min(std::max(from.column, to.column), rows.rows[to.row].size() - 1);
    }
    return to;
}

}  // namespace sightline
