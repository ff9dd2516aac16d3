// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"
#include "core/base/text.h"

namespace sightline {

namespace {

std::string read_number(const ParameterRow& row, std::string_view text) {
    const auto number = parse_number(text);
    if (!number || *number < row.low || *number > row.high)
        throw InputError("'" + excerpt(text) + "' is not a number in " + std::string(row.values));
    return number_text(*number);
}

std::string read_whole(const ParameterRow& row, std::string_view text) {
    const auto number = parse_number(text);
    if (!number || *number < row.low || *number > row.high || *number != std::floor(*number))
        throw InputError("'" + excerpt(text) + "' is not a whole number in " + std::string(row.values));
    return std::to_string(static_cast<std::uint64_t>(*number));
}

auto place_of(auto& values, std::string_view name) {
    return std::lower_bound(values.begin(), values.end(), name,
                            [](const auto& value, std::string_view n) { return value.first < n; });
}

}  // namespace

std::string detail::read_choice(const ParameterRow& row, std::string_view text) {
    if (std::find(row.words.begin(), row.words.end(), text) == row.words.end())
        throw InputError("'" + excerpt(text) + "' is not one of " + std::string(row.values));
    return std::string(text);
}

ParameterRow number_row(std::string_view name, std::string_view otherwise, double low, double high,
                        std::string_view values, std::string_view source, std::string_view help) {
    return {name, help, source, values, otherwise, {}, read_number, low, high};
}

ParameterRow whole_row(std::string_view name, std::string_view otherwise, double low, double high,
                       std::string_view values, std::string_view source, std::string_view help) {
    return {name, help, source, values, otherwise, {}, read_whole, low, high};
}

ParameterRow text_row(std::string_view name, std::string_view otherwise, std::string_view values,
                      std::string_view source, std::string_view help,
                      std::string (*check)(const ParameterRow&, std::string_view)) {
    return {name, help, source, values, otherwise, {}, check};
}

std::string_view Parameters::text(const ParameterRow& row) const {
    const auto at = place_of(values_, row.name);
    return at != values_.end() && at->first == row.name ? std::string_view(at->second) : row.otherwise;
}

double Parameters::number(const ParameterRow& row) const { return parse_number(text(row)).value(); }

void Parameters::set(const ParameterRow& row, std::string_view value) {
    std::string read;
    try {
        read = row.read(row, value);
    } catch (const InputError& error) {
        throw InputError("setting " + std::string(row.name) + ": " + error.what());
    }
    if (read != row.otherwise) return put(row.name, std::move(read));
    const auto at = place_of(values_, row.name);
    if (at != values_.end() && at->first == row.name) values_.erase(at);
}

void Parameters::put(std::string_view name, std::string value) {
    const auto at = place_of(values_, name);
    if (at != values_.end() && at->first == name)
        at->second = std::move(value);
    else
        values_.emplace(at, name, std::move(value));
}

}  // namespace sightline
