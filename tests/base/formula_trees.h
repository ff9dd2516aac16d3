// Random expressions as trees, written as text with as few or as many parentheses as chance wants, and their values
// worked out from the tree: what a formula is held against.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number.h"
#include "core/base/random.h"

namespace sightline::test {

inline constexpr std::string_view formula_names[] = {"content", "angle", "handed_on", "e1", "min_", "_x"};

/// How tightly operators bind; a leaf or a call binds most.
enum Binding { loosest, of_or, of_and, of_compare, of_sum, of_product, of_sign, of_power, of_leaf };

struct FormulaTree {
    std::string word;  ///< operator, function, name, or empty for a number
    double number = 0;
    std::size_t name = 0;
    std::vector<FormulaTree> parts;
    Binding binding = of_leaf;
};

struct FormulaSign {
    const char* sign;
    Binding binding;
};
inline constexpr FormulaSign formula_signs[] = {{"||", of_or},      {"&&", of_and},     {"<", of_compare},
                                                {"<=", of_compare}, {">", of_compare},  {">=", of_compare},
                                                {"==", of_compare}, {"!=", of_compare}, {"+", of_sum},
                                                {"-", of_sum},      {"*", of_product},  {"/", of_product}};

inline FormulaTree random_tree(Random& random, int depth) {
    FormulaTree tree;
    const auto part = [&] { tree.parts.push_back(random_tree(random, depth - 1)); };
    const std::uint64_t kind = depth > 0 ? random.below(20) : random.below(3);
    if (kind == 0) {
        constexpr double numbers[] = {0, 1, 2, 0.5, 3, 1e-3, 1e200, 12345.678};
        tree.number = numbers[random.below(std::size(numbers))];
    } else if (kind < 3) {
        tree.name = random.below(std::size(formula_names));
        tree.word = formula_names[tree.name];
    } else if (kind < 5) {
        constexpr const char* signs[] = {"-", "+", "!"};
        tree.word = signs[random.below(3)];
        tree.binding = of_sign;
        part();
    } else if (kind < 14) {
        const FormulaSign& sign = formula_signs[random.below(std::size(formula_signs))];
        tree.word = sign.sign;
        tree.binding = sign.binding;
        part();
        part();
    } else if (kind < 16) {
        tree.word = "?";
        tree.binding = loosest;
        for (int i = 0; i < 3; ++i) part();
    } else if (kind < 17) {
        tree.word = "^";
        tree.binding = of_power;
        tree.number = static_cast<double>(random.below(6));
        part();
    } else {
        constexpr const char* functions[] = {"sqrt", "min", "max"};
        tree.word = functions[random.below(3)];
        for (std::uint64_t i = tree.word == "sqrt" ? 1 : 1 + random.below(3); i > 0; --i) part();
    }
    return tree;
}

/// One random number after the other: compilers differ in the order of operands.
inline std::string written(const FormulaTree& tree, Binding least, Random& random) {
    std::string text;
    const auto blank = [&] { text.append(random.below(4) == 0 ? random.below(3) : 0, ' '); };
    const auto part = [&](std::size_t i, int binding) {
        text += written(tree.parts[i], static_cast<Binding>(binding), random);
    };
    blank();
    if (tree.word.empty()) {
        text += number_text(tree.number);
    } else if (tree.word == "?") {
        part(0, of_or);
        text += "?";
        part(1, loosest);
        text += ":";
        part(2, loosest);
    } else if (tree.word == "^") {
        part(0, of_leaf);
        text += "^" + number_text(tree.number);
    } else if (tree.binding == of_sign) {
        text += tree.word;
        part(0, of_sign);
    } else if (tree.binding != of_leaf) {
        part(0, tree.binding);
        text += tree.word;
        part(1, tree.binding + 1);
    } else if (tree.parts.empty()) {
        text += tree.word;
    } else {
        text += tree.word;
        blank();
        for (std::size_t i = 0; i < tree.parts.size(); ++i) {
            text += i == 0 ? "(" : ",";
            part(i, loosest);
        }
        text += ")";
    }
    blank();
    return tree.binding < least || random.below(12) == 0 ? " (" + text + ")" : text;
}

inline double value_of(const FormulaTree& tree, std::span<const double> values) {
    std::vector<double> v;
    for (const FormulaTree& part : tree.parts) v.push_back(value_of(part, values));
    const std::string& w = tree.word;
    if (w.empty()) return tree.number;
    if (w == "?") return v[0] != 0 ? v[1] : v[2];
    if (w == "||") return v[0] != 0 || v[1] != 0;
    if (w == "&&") return v[0] != 0 && v[1] != 0;
    if (w == "<") return v[0] < v[1];
    if (w == "<=") return v[0] <= v[1];
    if (w == ">") return v[0] > v[1];
    if (w == ">=") return v[0] >= v[1];
    if (w == "==") return v[0] == v[1];
    if (w == "!=") return v[0] != v[1];
    if (w == "*") return v[0] * v[1];
    if (w == "/") return v[0] / v[1];
    if (w == "!") return v[0] == 0;
    if (w == "+") return v.size() == 1 ? v[0] : v[0] + v[1];
    if (w == "-") return v.size() == 1 ? -v[0] : v[0] - v[1];
    if (w == "sqrt") return std::sqrt(v[0]);
    if (w == "min" || w == "max") {
        double best = v[0];
        for (const double other : v) best = w == "min" ? std::min(best, other) : std::max(best, other);
        return best;
    }
    if (w == "^") {
        double product = 1;
        for (int i = 0; i < tree.number; ++i) product = i == 0 ? v[0] : product * v[0];
        return product;
    }
    return values[tree.name];
}

/// With zeros of both signs, infinities and NaN among them.
inline std::vector<double> random_values(Random& random) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double special[] = {0, -0.0, 1, -1, 2, inf, -inf, std::nan(""), 1e308, -5e-324};
    std::vector<double> values(std::size(formula_names));
    for (double& value : values)
        value = random.below(2) ? special[random.below(std::size(special))] : random.uniform(-3, 3);
    return values;
}

}  // namespace sightline::test
