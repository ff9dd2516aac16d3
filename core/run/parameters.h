// The parameters of a method: rows that declare them, and values as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/words.h"

namespace sightline {

/// One parameter. A name means the same row in every method that has it. Rows are static data: all views outlive them.
struct ParameterRow {
    std::string_view name;
    std::string_view help;                         ///< one line
    std::string_view source;                       ///< where the question comes from, e.g. "TVCG fig. 5, line 1"
    std::string_view values;                       ///< the words or the range
    std::string_view otherwise;                    ///< the default
    std::span<const std::string_view> words = {};  ///< of a choice
    /// The text in its one form; throws InputError that says what is allowed.
    std::string (*read)(const ParameterRow&, std::string_view);
    double low = 0, high = 0;  ///< of a number
};

/// A row of words<E>.
template <typename E>
ParameterRow choice_row(std::string_view name, E otherwise, std::string_view source, std::string_view help);
/// A number in [low, high]; `values` says so.
ParameterRow number_row(std::string_view name, std::string_view otherwise, double low, double high,
                        std::string_view values, std::string_view source, std::string_view help);
/// A whole number in [low, high], from 0 to 2^53.
ParameterRow whole_row(std::string_view name, std::string_view otherwise, double low, double high,
                       std::string_view values, std::string_view source, std::string_view help);
/// Any text; `check` throws InputError for what cannot be.
ParameterRow text_row(std::string_view name, std::string_view otherwise, std::string_view values,
                      std::string_view source, std::string_view help,
                      std::string (*check)(const ParameterRow&, std::string_view));

/// Values that differ from the defaults. They may belong to several methods: each reads those of its own rows.
class Parameters {
public:
    /// The value, or the default.
    std::string_view text(const ParameterRow& row) const;
    double number(const ParameterRow& row) const;
    template <typename E>
    E choice(const ParameterRow& row) const {
        const std::string_view value = text(row);
        std::size_t i = 0;
        while (i + 1 < words<E>.size() && words<E>[i] != value) ++i;
        return static_cast<E>(i);
    }
    /// Throws InputError naming the parameter, the value and what is allowed; then nothing is changed.
    void set(const ParameterRow& row, std::string_view value);

    /// Those that are not the default, by name.
    const std::vector<std::pair<std::string, std::string>>& values() const { return values_; }
    bool operator==(const Parameters&) const = default;

private:
    void put(std::string_view name, std::string value);
    std::vector<std::pair<std::string, std::string>> values_;
};

namespace detail {
std::string read_choice(const ParameterRow& row, std::string_view text);
}

template <typename E>
ParameterRow choice_row(std::string_view name, E otherwise, std::string_view source, std::string_view help) {
    static_assert(!words<E>.empty(), "the enum needs its words: template <> inline constexpr auto words<E> = …");
    return {name, help, source, word_list<E>(), word(otherwise), words<E>, detail::read_choice};
}

}  // namespace sightline
