// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/formula.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/formula_token.h"
#include "core/base/text.h"

namespace sightline {

namespace {

constexpr std::array functions{std::string_view("sqrt"), std::string_view("min"), std::string_view("max")};

/// A number, a name's value, or a result in between; registers are given out at the end.
struct Operand {
    enum class Place : std::uint8_t { number, name, result } place = Place::number;
    std::size_t index = 0;  ///< of the used name or the result
    double number = 0;
};

}  // namespace

/// Recursive descent, a function per level of precedence. Results in between lie on a stack: operands are on its top.
class FormulaCompiler {
public:
    FormulaCompiler(Formula& formula, std::span<const std::string_view> names, std::string_view kind,
                    std::string_view shown)
        : formula_(formula), text_(formula.text_), names_(names), kind_(kind), shown_(shown.empty() ? text_ : shown) {}

    void compile() {
        if (text_.size() > Formula::longest_text)
            fail(std::nullopt, "it has " + std::to_string(text_.size()) + " characters; at most " +
                                   std::to_string(Formula::longest_text) + " are read");
        next();
        if (token_.kind == TokenKind::end) fail(std::nullopt, "it is empty");
        const Operand result = choice();
        if (token_.kind != TokenKind::end) fail_after_operand();
        write(result);
    }

private:
    using Op = Formula::Op;
    struct Draft {
        Op op;
        Operand to, a, b, c;
    };

    // Errors

    [[noreturn]] void fail(std::optional<std::size_t> at, const std::string& reason) const {
        std::string place;
        if (at) place = "column " + std::to_string(column(*at)) + ": ";
        throw InputError(std::string(kind_) + " '" + one_line(shown_, Formula::longest_text) + "': " + place +
                         one_line(reason, 4096));
    }
    std::size_t column(std::size_t at) const {
        const std::size_t from_shown = at + shown_.size();
        return from_shown < text_.size() ? 1 : from_shown - text_.size() + 1;
    }
    std::string quoted() const { return "'" + std::string(token_.text) + "'"; }

    [[noreturn]] void fail_at_operand() const {
        const std::string wanted = "a number, a name or (";
        if (token_.kind == TokenKind::end) fail(token_.at, "it ends, but " + wanted + " is needed here");
        if (token_.kind == TokenKind::unknown) fail_unknown_sign();
        fail(token_.at, "found " + quoted() + " where " + wanted + " is needed");
    }
    [[noreturn]] void fail_after_operand() const {
        if (token_.kind == TokenKind::unknown || token_.text == "=") fail_unknown_sign();
        if (token_.text == ")") fail(token_.at, ") without (");
        if (token_.text == ":") fail(token_.at, ": without ?");
        if (token_.text == ",") fail(token_.at, "write one expression, not several");
        if (token_.text == "and" || token_.text == "or") fail_unknown_sign();
        fail(token_.at, "an operator is missing before " + quoted());
    }
    [[noreturn]] void fail_unknown_sign() const {
        const std::string instead(written_instead(token_.text));
        if (!instead.empty()) fail(token_.at, "write " + instead + " for " + quoted());
        fail(token_.at, quoted() + " is not allowed here");
    }
    [[noreturn]] void fail_unknown_word(const Token& word, bool is_call) const {
        std::string reason =
            "there is no " + std::string(is_call ? "function '" : "name '") + std::string(word.text) + "'";
        const std::string instead(written_instead(word.text));
        const std::span<const std::string_view> known = is_call ? std::span<const std::string_view>(functions) : names_;
        const std::string_view close = is_call ? std::string_view() : closest(word.text, known);
        if (!instead.empty())
            reason += "; write " + instead;
        else if (!close.empty())
            reason += "; did you mean " + std::string(close) + "?";
        std::string list;
        for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string(name);
        fail(word.at, reason + (is_call ? " (functions: " : " (names: ") + list + ")");
    }

    // Tokens

    void next() {
        token_ = next_token(text_, token_.at + token_.text.size());
        if (token_.kind == TokenKind::number && token_.number != token_.number)
            fail(token_.at, "the number " + quoted() + " is too large or too small");
    }
    bool is(std::string_view sign) const { return token_.kind == TokenKind::sign && token_.text == sign; }
    bool take(std::string_view sign) {
        if (!is(sign)) return false;
        next();
        return true;
    }

    /// Counts what lies inside each other, so that no text overflows the stack of the program.
    struct Deeper {
        explicit Deeper(FormulaCompiler& c) : compiler(c) {
            if (++compiler.depth_ > Formula::deepest)
                compiler.fail(compiler.token_.at,
                              "more than " + std::to_string(Formula::deepest) + " levels lie inside each other");
        }
        ~Deeper() { --compiler.depth_; }
        FormulaCompiler& compiler;
    };

    // Grammar

    Operand choice() {
        const Deeper deeper(*this);
        const Operand condition = chain(0);
        const std::size_t at = token_.at;
        if (!take("?")) return condition;
        const Operand yes = choice();
        if (token_.kind == TokenKind::end) fail(at, "? without :");
        if (!take(":")) fail_after_operand();
        const Operand no = choice();
        return emit(Op::choose, condition, yes, no);
    }

    struct Binary {
        std::string_view sign;
        Op op;
        int level;
    };
    static constexpr int levels = 5;
    static constexpr Binary binaries[] = {
        {"||", Op::either, 0}, {"&&", Op::both, 1},          {"<", Op::less, 2},     {"<=", Op::less_equal, 2},
        {">", Op::greater, 2}, {">=", Op::greater_equal, 2}, {"==", Op::equal, 2},   {"!=", Op::unequal, 2},
        {"+", Op::add, 3},     {"-", Op::subtract, 3},       {"*", Op::multiply, 4}, {"/", Op::divide, 4}};

    Operand chain(int level) {
        if (level == levels) return sign();
        Operand left = chain(level + 1);
        for (;;) {
            const auto binary = std::find_if(std::begin(binaries), std::end(binaries),
                                             [&](const Binary& b) { return b.level == level && is(b.sign); });
            if (binary == std::end(binaries)) return left;
            next();
            const Operand right = chain(level + 1);
            left = emit(binary->op, left, right);
        }
    }

    Operand sign() {
        if (!is("+") && !is("-") && !is("!")) return power();
        const Deeper deeper(*this);
        if (take("+")) return sign();
        if (take("-")) return emit(Op::negate, sign());
        next();
        return emit(Op::negation, sign());
    }

    Operand power() {
        const Operand base = primary();
        if (!take("^")) return base;
        const Deeper deeper(*this);
        const std::size_t at = token_.at;
        const Operand exponent = sign();
        const double n = exponent.number;
        if (exponent.place != Operand::Place::number || !(n >= 0 && n <= Formula::largest_power) || n != std::floor(n))
            fail(at, "^ takes a whole number from 0 to " + std::to_string(Formula::largest_power) +
                         "; sqrt(x) and 1 / x are others");
        if (n == 0) {
            release(base);
            return number(1);
        }
        if (base.place == Operand::Place::number) {
            double product = base.number;
            for (int i = 1; i < n; ++i) product = product * base.number;
            return number(product);
        }
        Operand product = base;
        for (int i = 1; i < n; ++i) {
            // The last one may write over the base.
            const Operand to = i + 1 == n ? reuse(base) : Operand{Operand::Place::result, results_, 0};
            most_results_ = std::max(most_results_, to.index + 1);
            drafts_.push_back({Op::multiply, to, product, base, base});
            product = to;
        }
        return product;
    }

    Operand primary() {
        const Token token = token_;
        if (token.kind == TokenKind::number) {
            next();
            return number(token.number);
        }
        if (token.kind == TokenKind::word) {
            next();
            return is("(") ? call(token) : name(token);
        }
        if (!take("(")) fail_at_operand();
        const Operand inner = choice();
        close(token);
        return inner;
    }

    void close(const Token& open) {
        if (token_.kind == TokenKind::end) fail(open.at, "( without )");
        if (!take(")")) fail_after_operand();
    }

    Operand name(const Token& word) {
        const auto found = std::find(names_.begin(), names_.end(), word.text);
        if (found == names_.end()) {
            if (std::find(functions.begin(), functions.end(), word.text) != functions.end())
                fail(word.at, std::string(word.text) + " is a function: write " + std::string(word.text) + "(...)");
            fail_unknown_word(word, false);
        }
        const auto index = static_cast<std::size_t>(found - names_.begin());
        std::vector<std::size_t>& used = formula_.used_;
        const auto place = std::find(used.begin(), used.end(), index);
        const auto slot = static_cast<std::size_t>(place - used.begin());
        if (place == used.end()) used.push_back(index);
        return {Operand::Place::name, slot, 0};
    }

    Operand call(const Token& word) {
        if (std::find(functions.begin(), functions.end(), word.text) == functions.end()) fail_unknown_word(word, true);
        const Token open = token_;
        next();
        Operand result = choice();
        std::size_t count = 1;
        for (; take(","); ++count) {
            const Operand other = choice();
            result = emit(word.text == "max" ? Op::max : Op::min, result, other);
        }
        close(open);
        if (word.text != "sqrt") return result;
        if (count != 1) fail(word.at, "sqrt takes one number, not " + std::to_string(count));
        return emit(Op::sqrt, result);
    }

    // Code

    /// By the very code that evaluates.
    static double fold(Op op, double a, double b, double c) {
        Formula formula;
        formula.numbers_ = {a, b, c};
        formula.program_ = {{op, 3, 0, 1, 2}};
        formula.result_ = 3;
        return formula.value({});
    }
    static Operand number(double value) { return {Operand::Place::number, 0, value}; }
    void release(const Operand& operand) { results_ -= operand.place == Operand::Place::result; }
    /// Where a result goes whose last operand on the stack is this one.
    Operand reuse(const Operand& operand) {
        if (operand.place == Operand::Place::result) return operand;
        return {Operand::Place::result, results_++, 0};
    }

    Operand emit(Op op, const Operand& a) { return emit(op, a, a, a, 1); }
    Operand emit(Op op, const Operand& a, const Operand& b) { return emit(op, a, b, b, 2); }
    Operand emit(Op op, const Operand& a, const Operand& b, const Operand& c) { return emit(op, a, b, c, 3); }
    Operand emit(Op op, const Operand& a, const Operand& b, const Operand& c, int operands) {
        constexpr auto fixed = Operand::Place::number;
        if (a.place == fixed && b.place == fixed && c.place == fixed)
            return number(fold(op, a.number, b.number, c.number));
        release(a);
        if (operands > 1) release(b);
        if (operands > 2) release(c);
        const Operand to{Operand::Place::result, results_++, 0};
        most_results_ = std::max(most_results_, results_);
        drafts_.push_back({op, to, a, b, c});
        return to;
    }

    void write(const Operand& result) {
        std::vector<double>& numbers = formula_.numbers_;
        const auto slot = [&](const Operand& operand) {                      // of a number, after it was put there
            const auto bits = std::bit_cast<std::uint64_t>(operand.number);  // 0 and -0 are two
            const auto same = [&](double n) { return std::bit_cast<std::uint64_t>(n) == bits; };
            const auto found = std::find_if(numbers.begin(), numbers.end(), same);
            const auto index = static_cast<std::size_t>(found - numbers.begin());
            if (found == numbers.end()) numbers.push_back(operand.number);
            return index;
        };
        const auto put = [&](const Operand& operand) {
            if (operand.place == Operand::Place::number) slot(operand);
        };
        for (const Draft& draft : drafts_)
            for (const Operand* operand : {&draft.a, &draft.b, &draft.c}) put(*operand);
        put(result);
        const std::size_t first_name = numbers.size(), first_result = first_name + formula_.used_.size();
        if (first_result + most_results_ > Formula::registers)
            fail(std::nullopt,
                 "it has more than " + std::to_string(Formula::registers) + " numbers, names and results");
        const auto place = [&](const Operand& operand) {
            if (operand.place == Operand::Place::number) return static_cast<std::uint8_t>(slot(operand));
            const bool is_name = operand.place == Operand::Place::name;
            return static_cast<std::uint8_t>((is_name ? first_name : first_result) + operand.index);
        };
        formula_.program_.reserve(drafts_.size());
        for (const Draft& d : drafts_)
            formula_.program_.push_back({d.op, place(d.to), place(d.a), place(d.b), place(d.c)});
        formula_.result_ = place(result);
    }

    Formula& formula_;
    std::string_view text_;
    std::span<const std::string_view> names_;
    std::string_view kind_, shown_;
    Token token_;
    int depth_ = 0;
    std::vector<Draft> drafts_;
    std::size_t results_ = 0, most_results_ = 0;  ///< on the stack now, at most
};

Formula::Formula(std::string_view text, std::span<const std::string_view> names, std::string_view kind,
                 std::string_view shown)
    : text_(text) {
    FormulaCompiler(*this, names, kind, shown).compile();
}

}  // namespace sightline
