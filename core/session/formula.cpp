// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/formula.h"

#include <muParser.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"

namespace sightline {

struct Formula::Parsed {
    mu::Parser parser;
    std::vector<double> values;  // one per name, filled before an evaluation
    std::vector<std::size_t> used;
};

namespace {

/// muParser would take "step = 5" for an assignment, which holds at once.
bool assigns(std::string_view formula) {
    for (std::size_t at = formula.find('='); at != std::string_view::npos; at = formula.find('=', at + 1)) {
        if (formula.substr(at, 2) == "==")
            ++at;
        else if (at == 0 || std::string_view("<>!").find(formula[at - 1]) == std::string_view::npos)
            return true;
    }
    return false;
}

}  // namespace

Formula::Formula(const std::string& text, std::vector<std::string> names, const std::string& shown)
    : parsed_(std::make_unique<Parsed>()) {
    const auto fail = [&](const std::string& why) {
        return InputError(one_line("condition '" + shown + "': " + why, 4096));
    };
    if (assigns(text)) throw fail("write == to compare");
    mu::Parser& parser = parsed_->parser;
    parsed_->values.resize(names.size());
    try {
        parser.DefineInfixOprt("!", [](double v) -> double { return v == 0; });
        for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &parsed_->values[i]);
        parser.SetExpr(text);
        for (const auto& [name, variable] : parser.GetUsedVar())
            parsed_->used.push_back(static_cast<std::size_t>(variable - parsed_->values.data()));
        parser.Eval();
        if (parser.GetNumResults() != 1) throw fail("write one expression, not several");
    } catch (const mu::Parser::exception_type& error) {
        std::string known;
        for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
        std::string why = error.GetMsg();
        while (!why.empty() && (why.back() == '\n' || why.back() == '.')) why.pop_back();
        throw fail(why + " (fields: " + known + ")");
    }
}

Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;
Formula::~Formula() = default;

std::span<const std::size_t> Formula::used() const { return parsed_->used; }

bool Formula::holds(std::span<const double> values) const {
    std::copy(values.begin(), values.end(), parsed_->values.begin());
    const double result = parsed_->parser.Eval();
    return result == result && result != 0;
}

}  // namespace sightline
