// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/compare/fail_if.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "lab/compare/compare_report.h"

namespace sightline::lab {

namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& reason) {
    throw InputError("--fail-if '" + excerpt(text) + "': " + reason);
}

/// The next word, which is taken off.
std::string_view next_word(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end);
    return word;
}

const MeasureRow& comparable(std::string_view text, std::string_view name) {
    std::vector<std::string_view> names{"time"};
    for (const MeasureRow& row : measure_table()) {
        if (row.better == Better::neither) continue;
        if (row.id == name || (name == "time" && row.measure == Measure::total_ms)) return row;
        names.push_back(row.id);
    }
    refuse(text, unknown_word("measure", excerpt(name), names).what());
}

}  // namespace

FailIf parse_fail_if(std::string_view text) {
    std::string_view rest = text;
    const std::string_view name = next_word(rest), worse = next_word(rest), than = next_word(rest);
    if (name.empty() || worse != "worse" || than != "than")
        refuse(text, "write MEASURE worse than NUMBER, such as \"wrong worse than 0.5 %\"");
    const MeasureRow& row = comparable(text, name);
    std::string_view number = next_word(rest);
    std::string_view unit = next_word(rest);
    if (const std::size_t end = number.find_first_not_of("0123456789.+-eE"); unit.empty() && end < number.size()) {
        unit = number.substr(end);
        number = number.substr(0, end);
    }
    const auto limit = parse_number(number);
    if (!limit || *limit < 0) refuse(text, "'" + excerpt(number) + "' is no number from 0 on");
    if (!next_word(rest).empty()) refuse(text, "nothing may follow the unit");
    if (!unit.empty() && unit != "%" && unit != row.unit)
        refuse(text, "the unit of " + std::string(row.id) + " is " +
                         (row.unit == "share" ? "%" : std::string(row.unit) + ", or % of A's value"));
    const bool share = row.unit == "share", per_cent = unit == "%";
    return {std::string(text), row.measure, per_cent ? *limit / 100 : *limit, per_cent && !share};
}

std::vector<std::string> failures(const FailIf& condition, const std::vector<Pair>& pairs) {
    const MeasureRow& row = measure_row(condition.measure);
    bool any = false;
    std::vector<std::string> lines;
    for (const Pair& pair : pairs)
        for (const Change& change : pair.changes) {
            if (change.measure != condition.measure) continue;
            any = true;
            const double worse = row.better == Better::higher ? -change.mean : change.mean;
            if (!(worse > condition.limit * (condition.of_a ? change.a : 1))) continue;
            if (row.is_time && !change.significant()) continue;
            lines.push_back(pair_title(pair) + ": " + change_text(change));
        }
    if (!any) refuse(condition.text, "neither side has a value of " + std::string(row.id) + " to compare");
    return lines;
}

}  // namespace sightline::lab
