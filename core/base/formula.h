// A formula over named numbers, compiled once and then quick to evaluate, with the same result on every machine.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sightline {

/// Numbers, names, parentheses, sqrt(x), min(a, b, ...), max(a, b, ...), and from loose to tight
///
///     ? :    ||    &&    < <= > >= == !=    + -    * /    unary - + !    ^
///
/// where ^ takes a whole number from 0 to 64 and ties to the right, as ?: does; all others tie to the left. Arithmetic
/// is IEEE 754 doubles, x ^ 3 is x * x * x, and nothing else of libm than sqrt is called. Comparisons, ! && || give 1
/// or 0; what is not 0 counts as true. With NaN, != is true and the other comparisons are false; min(a, b) is b < a ? b
/// : a and max(a, b) is a < b ? b : a. Everything is evaluated, also the branch that is not taken.
///
/// A value type; evaluation reads it only, so threads may share one.
class Formula {
public:
    static constexpr std::size_t longest_text = 1000;  ///< in bytes
    static constexpr int deepest = 64;                 ///< parentheses, signs and branches inside each other
    static constexpr int largest_power = 64;

    /// Throws InputError "KIND 'TEXT': column 7: reason", which lists the names where one is unknown. `shown` stands
    /// for the text in it, unless it is empty; both end alike, so that columns can be counted in it.
    Formula(std::string_view text, std::span<const std::string_view> names, std::string_view kind = "formula",
            std::string_view shown = {});

    /// Indices of the names that the text mentions, in the order of their first mention: the other values are not
    /// looked at.
    std::span<const std::size_t> used() const { return used_; }
    /// A value per name. A NaN has always the same bits.
    double value(std::span<const double> values) const noexcept;
    /// Whether the value is neither 0 nor NaN.
    bool holds(std::span<const double> values) const noexcept;
    const std::string& text() const { return text_; }

private:
    friend class FormulaCompiler;
    enum class Op : std::uint8_t {
        negate,
        negation,
        sqrt,
        add,
        subtract,
        multiply,
        divide,
        min,
        max,
        less,
        less_equal,
        greater,
        greater_equal,
        equal,
        unequal,
        both,
        either,
        choose
    };
    static constexpr std::size_t registers = 256;  // as far as their numbers reach
    /// to = op(a, b, c), all of them numbers of registers.
    struct Instruction {
        Op op;
        std::uint8_t to, a, b, c;
    };
    Formula() = default;

    std::string text_;
    // The registers begin with the numbers, then come the values that are used, then results in between.
    std::vector<double> numbers_;
    std::vector<std::size_t> used_;
    std::vector<Instruction> program_;
    std::uint8_t result_ = 0;  ///< register
};

}  // namespace sightline
