// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/conceal.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number.h"

namespace sightline {

namespace {

constexpr int least_digits = 3, most_digits = 17;  // those that keys are written with
constexpr auto before_a_key =
    std::to_array<std::string_view>({"= ", "key ", "(", "with ", "→ ", "before ", "now ", "front, ", "against "});

bool writes(std::string_view word, double key) {
    for (int digits = least_digits; digits <= most_digits; ++digits)
        if (word == short_number(key, digits)) return true;
    return false;
}

}  // namespace

template <int D>
std::uint32_t concealed_cell(const Workbench<D>& bench) {
    const Beat* const next = bench.teaching ? bench.teaching->next() : nullptr;
    if (!next || !next->key_of || *next->key_of >= bench.session.cells().cell_count()) return none;
    return bench.session.mark(*next->key_of).state == CellState::enqueued ? *next->key_of : none;
}

template <int D>
bool asks_for_cell(const Workbench<D>& bench) {
    const Beat* const next = bench.teaching ? bench.teaching->next() : nullptr;
    return next && next->guess;
}

template <int D>
std::string conceal(const Workbench<D>& bench, std::string text) {
    const std::uint32_t cell = concealed_cell(bench);
    if (cell == none) return text;
    const double key = bench.session.mark(cell).key;
    const bool common = key == std::floor(key);
    constexpr std::string_view digits = "0123456789";
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        if (digits.find(text[at]) == digits.npos) {
            shown += text[at++];
            continue;
        }
        std::size_t end = std::min(text.find_first_not_of("0123456789.", at), text.size());
        while (text[end - 1] == '.') --end;  // of a sentence
        const std::string word = text.substr(at, end - at);
        const bool place = !common || std::any_of(before_a_key.begin(), before_a_key.end(),
                                                  [&](std::string_view words) { return shown.ends_with(words); });
        shown += place && writes(word, key) ? "?" : word;
        at = end;
    }
    return shown;
}

template bool asks_for_cell<2>(const Workbench<2>&);
template bool asks_for_cell<3>(const Workbench<3>&);
template std::uint32_t concealed_cell<2>(const Workbench<2>&);
template std::uint32_t concealed_cell<3>(const Workbench<3>&);
template std::string conceal<2>(const Workbench<2>&, std::string);
template std::string conceal<3>(const Workbench<3>&, std::string);

}  // namespace sightline
