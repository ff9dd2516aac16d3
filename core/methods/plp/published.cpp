// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/plp/published.h"

#include <algorithm>

#include "core/base/number.h"

namespace sightline {

namespace {

/// The part of a key that weighs most, for people.
std::string weightiest(const SolidityTerms& t) {
    const double passed = t.angle * t.handed_on, penalty = t.key - t.unpenalised;
    const double most = std::max({t.content, passed, t.own_content, penalty});
    if (!(most > 0)) return "only its stamp: no term of its key, " + short_number(t.key) + ", is above 0";
    std::string parts;
    const auto add = [&](double part, const std::string& words) {
        if (part == most) parts += (parts.empty() ? "" : ", and as much ") + words;
    };
    add(penalty, "the penalty (+" + short_number(penalty) + "): the ray from the eye to its centre misses the facet");
    add(passed, "what was handed on (" + short_number(passed) + "): the key of the cell that it was reached " +
                    "from, " + short_number(t.handed_on) + ", times the angle, " + short_number(t.angle));
    add(t.content, "the content (" + short_number(t.content) +
                       ") of the cell that it was reached from: |A| = " + std::to_string(t.count));
    add(t.own_content, "its own content (" + short_number(t.own_content) + "): |B| = " + std::to_string(t.own_count));
    return parts;
}

/// By the names of KeyExplanation::terms, which the lines of code read back.
const Term& term(const KeyExplanation& e, std::string_view name) {
    for (const Term& t : e.terms)
        if (t.name == name) return t;
    return e.terms.back();
}

std::string after_equals(const std::string& sum) { return sum.substr(sum.find('=') + 2); }

std::string penalty_sign(const PlpParameters& parameters) {
    return parameters.penalty == Penalty::multiply ? "× " : "+ ";
}

}  // namespace

KeyExplanation explain_solidity(const SolidityTerms& t, const PlpParameters& parameters, int digits) {
    const auto number = [&](double v) { return short_number(v, digits); };
    KeyExplanation e;
    e.key = t.key;
    e.tested = t.star_tested;
    e.penalised = !t.star_shaped;
    e.parts = {{"ρ = "}, {number(t.content), KeyAbout::content, "content"},
               {" + "},  {number(t.angle), KeyAbout::angle, "angle"},
               {" · "},  {number(t.handed_on), KeyAbout::handed_on, "handed on"}};
    if (parameters.own_content)
        e.parts.insert(e.parts.end(), {{" + "}, {number(t.own_content), KeyAbout::own, "own content"}});
    e.parts.push_back({" = " + number(t.unpenalised)});
    if (e.penalised)
        e.penalty =
            penalty_sign(parameters) + number(parameters.penalty_amount) + " (not star-shaped) = " + number(t.key);
    e.tip = "content |A| / ρ_max, plus angle v·n times the solidity handed on by the cell it was reached from";
    if (parameters.own_content) e.tip += ", plus its own content |B| / ρ_max";
    e.weightiest = weightiest(t);
    e.terms = {{"rho_a", t.handed_on, {}},
               {"count", static_cast<double>(t.count), {}},
               {"density", t.content, {}},
               {"alignment", t.alignment, {}},
               {"weight", t.angle, {}},
               {"star_shaped", t.star_shaped ? 1.0 : 0.0,
                !t.star_tested  ? "null"
                : t.star_shaped ? "true"
                                : "false"},
               {"unpenalised", t.unpenalised, {}},
               {"key", t.key, {}}};
    if (parameters.own_content)  // before the key
        e.terms.insert(e.terms.end() - 1,
                       {{"own_count", static_cast<double>(t.own_count), {}}, {"own_content", t.own_content, {}}});
    return e;
}

void add_solidity_lines(std::vector<CodeLine>& lines, const KeyExplanation* e, const PlpParameters& parameters,
                        double scale, int digits) {
    const auto number = [&](double v) { return short_number(v, digits); };
    const auto value = [&](std::string_view name) { return term(*e, name).value; };
    const auto add = [&](std::string text, const auto& values, std::string_view source) {
        lines.push_back({std::move(text), 1, false, e ? values() : std::string(), std::string(source)});
    };
    lines.push_back({"key(n, c): the solidity ρ that c hands on to n", 0, false, {}, {}});
    const std::string over = parameters.solidity_scale == SolidityScale::p95 ? " / ρ95, at most 1" : " / ρ_max";
    const auto division = [&](std::string_view of, std::string_view result) {
        const double count = value(of);
        return number_text(count) + " / " + number(scale) + (count > scale ? ", cut to " : " = ") +
               number(value(result));
    };
    add(
        "content = |c|" + over, [&] { return division("count", "density"); }, "TVCG fig. 5, line 1");
    const TransferSign sign = parameters.transfer_sign;
    add(
        sign == TransferSign::clamp ? "angle = v · normal of the facet, at least 0"
        : sign == TransferSign::abs ? "angle = |v · normal of the facet|"
                                    : "angle = v · normal of the facet",
        [&] {
            const double alignment = value("alignment"), angle = value("weight");
            return number(alignment) + (angle == alignment ? "" : ", taken as " + number(angle));
        },
        "TVCG fig. 5, line 1");
    if (parameters.own_content)
        add(
            "own content = |n|" + over, [&] { return division("own_count", "own_content"); },
            "docs/algorithm.md, keys of 0");
    add(
        parameters.own_content ? "ρ = content + angle · ρ of c + own content" : "ρ = content + angle · ρ of c",
        [&] { return after_equals(e->sum()); }, "TVCG fig. 5, line 1");
    if (parameters.tests_star_shape) {
        add(
            "the ray from the eye to the centre of n misses the facet?",
            [&] { return std::string(e->penalised ? "yes: not star-shaped" : "no: star-shaped"); },
            "TVCG fig. 5, line 2");
        add(
            "then ρ = ρ " + penalty_sign(parameters) + number(parameters.penalty_amount),
            [&] { return e->penalised ? number(value("unpenalised")) + " " + e->penalty : std::string(); },
            "TVCG fig. 5, line 3");
        lines.back().indent = 2;
    }
    add(
        "the key is ρ", [&] { return number(e->key); }, "TVCG fig. 5, line 4");
}

}  // namespace sightline
