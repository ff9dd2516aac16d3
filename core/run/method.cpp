// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/method.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/text.h"

namespace sightline {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Walks over a text and knows whether a place lies inside quotes or parentheses.
struct Depth {
    char quote = 0;
    int parentheses = 0;

    void pass(char c) {
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else {
            parentheses += (c == '(') - (c == ')');
        }
    }
    bool inside() const { return quote || parentheses > 0; }
};

std::vector<std::string> split(std::string_view text, char at) {
    std::vector<std::string> parts(1);
    Depth depth;
    for (const char c : text) {
        depth.pass(c);
        if (c == at && !depth.inside())
            parts.emplace_back();
        else
            parts.back() += c;
    }
    for (std::string& part : parts) {
        while (!part.empty() && is_space(part.front())) part.erase(part.begin());
        while (!part.empty() && is_space(part.back())) part.pop_back();
    }
    std::erase_if(parts, [](const std::string& part) { return part.empty(); });
    return parts;
}

std::string without_quotes(std::string value) {
    const bool quoted =
        value.size() >= 2 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
    return quoted ? value.substr(1, value.size() - 2) : value;
}

std::string in_quotes(const std::string& value) {
    const bool plain = !value.empty() && std::none_of(value.begin(), value.end(), [](char c) {
        return is_space(c) || c == ';' || c == ',' || c == '"' || c == '\'' || c == '(' || c == ')';
    });
    if (plain) return value;
    const char quote = value.find('"') == std::string::npos ? '"' : '\'';
    return quote + value + quote;
}

}  // namespace

template <int D>
const Method<D>& find_method(std::span<const Method<D>> table, std::string_view id) {
    std::vector<std::string_view> known;
    for (const Method<D>& method : table) {
        if (method.is_called(id)) return method;
        known.push_back(method.id);
    }
    throw unknown_word("method", id, known);
}

std::string VariantText::text() const {
    std::string text = id;
    for (const auto& [name, value] : assignments) text += " " + name + "=" + in_quotes(value);
    return text;
}

VariantText read_variant(std::string_view text) {
    VariantText variant;
    for (const std::string& part : split(text, ' ')) {
        if (variant.id.empty()) {
            variant.id = part;
            continue;
        }
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError("method '" + excerpt(text) + "': '" + excerpt(part) +
                             "' is not a parameter: write NAME=VALUE, with quotes around a value that has spaces");
        variant.assignments.emplace_back(part.substr(0, equals), without_quotes(part.substr(equals + 1)));
    }
    if (variant.id.empty()) throw InputError("no method given");
    return variant;
}

std::vector<std::string> split_variants(std::string_view text) {
    std::vector<std::string> variants = split(text, ';');
    return variants.size() == 1 && text.find(';') == std::string_view::npos ? split(text, ',') : variants;
}

template <int D>
const Method<D>& find_variant(std::span<const Method<D>> table, const VariantText& variant, Parameters& parameters) {
    const Method<D>& method = find_method<D>(table, variant.id);
    Parameters with = parameters;
    for (const auto& [name, value] : variant.assignments) {
        const ParameterRow* row = method.parameter(name);
        if (!row) {
            std::string known;
            for (const ParameterRow* other : method.parameters)
                known += (known.empty() ? "" : ", ") + std::string(other->name);
            throw InputError("method '" + std::string(method.id) + "' has no parameter '" + excerpt(name) + "'; " +
                             (known.empty() ? "it has none" : "there are " + known));
        }
        with.set(*row, value);
    }
    parameters = std::move(with);
    return method;
}

template <int D>
Variant<D> variant_of(const Method<D>& method, const Parameters& parameters, const Parameters& base) {
    VariantText text{std::string(method.id), {}};
    Parameters own;
    for (const ParameterRow* row : method.parameters) {
        const std::string_view value = parameters.text(*row);
        own.set(*row, value);
        if (value != base.text(*row)) text.assignments.emplace_back(row->name, value);
    }
    return {method, std::move(own), text.text()};
}

template <int D>
std::string guarantee_words(const Method<D>& method, const Run<D>& run) {
    if (method.promise_with(run.problem().parameters) == Misses::may)
        return run.counters().stood_in > 0 ? "approximate: levels of detail" : "approximate";
    if (run.misses() == Misses::none) return "conservative";
    if (run.misses() == Misses::none_at_this_resolution) return "conservative at this resolution";
    return run.finished() ? "conservative, cut short by the budget" : "conservative, not finished";
}

#define SIGHTLINE_INSTANTIATE(D)                                                                            \
    template const Method<D>& find_method<D>(std::span<const Method<D>>, std::string_view);                 \
    template const Method<D>& find_variant<D>(std::span<const Method<D>>, const VariantText&, Parameters&); \
    template Variant<D> variant_of<D>(const Method<D>&, const Parameters&, const Parameters&);              \
    template std::string guarantee_words<D>(const Method<D>&, const Run<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
