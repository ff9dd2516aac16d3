// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/formula.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/text.h"
#include "tests/base/formula_trees.h"
#include "tests/fuzz/formula_bytes.h"

namespace sightline {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view abc[] = {"a", "b", "c"};

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

double value(std::string_view text, std::vector<double> values = {2, 3, nan}) {
    return Formula(text, abc).value(values);
}

std::string error_of(std::string_view text, std::span<const std::string_view> names = abc) {
    try {
        const Formula formula(text, names);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Formula, AnyExpressionHasTheValueOfItsTree) {
    Random random(41);
    std::set<std::string> words;
    int compared = 0, nans = 0, infinite = 0, longest = 0;
    for (int i = 0; i < 20000; ++i) {
        const test::FormulaTree tree = test::random_tree(random, 1 + static_cast<int>(random.below(6)));
        const std::string text = test::written(tree, test::loosest, random);
        if (text.size() > Formula::longest_text) continue;
        longest = std::max(longest, static_cast<int>(text.size()));
        words.insert(tree.word);
        const Formula formula(text, test::formula_names);
        ASSERT_EQ(formula.text(), text);
        for (int k = 0; k < 20; ++k) {
            const std::vector<double> values = test::random_values(random);
            const double wanted = test::value_of(tree, values), got = formula.value(values);
            ASSERT_EQ(bits(got), bits(wanted != wanted ? nan : wanted)) << text << " is " << got << ", not " << wanted;
            ASSERT_EQ(formula.holds(values), wanted < 0 || wanted > 0);
            nans += wanted != wanted;
            infinite += wanted == inf || wanted == -inf;
            ++compared;
        }
    }
    EXPECT_EQ(words.size(), 1 + std::size(test::formula_names) + std::size(test::formula_signs) + 1 + 1 + 1 + 3);
    EXPECT_GT(longest, 500);
    EXPECT_GT(nans, compared / 40);
    EXPECT_GT(infinite, compared / 50);
}

/// Values that every compiler and every machine must give: their bits, hashed.
TEST(Formula, TheBitsAreTheSameEverywhere) {
    Random random(42);
    Hash hash;
    for (int i = 0; i < 2000; ++i) {
        const std::string text = test::written(test::random_tree(random, 4), test::loosest, random);
        const std::vector<double> values = test::random_values(random);
        hash.add(Formula(text, test::formula_names).value(values));
    }
    EXPECT_EQ(hash_text(hash.value()), "ff8cea106a447120");
}

TEST(Formula, OperatorsBindAsInC) {
    const std::pair<const char*, double> cases[] = {
        {"1 + 2 * 3", 7},
        {"(1 + 2) * 3", 9},
        {"7 - 2 - 1", 4},
        {"8 / 4 / 2", 1},
        {"-a ^ 2", -4},
        {"2 ^ 3 ^ 2", 512},
        {"-a * b", -6},
        {"!a + 1", 1},
        {"!!b", 1},
        {"- -a", 2},
        {"+a", 2},
        {"a < b == 1", 1},
        {"1 < 3 < 2", 1},
        {"a == 2 || 0 && 0", 1},
        {"a ? b : c ? 1 : 2", 3},
        {"0 ? 1 : 0 ? 2 : 3", 3},
        {"1 ? 0 ? 4 : 5 : 6", 5},
        {"1 || 0 ? 8 : 9", 8},
        {"min(b, a)", 2},
        {"max(1, b, a)", 3},
        {"min(b)", 3},
        {"sqrt(a + 2)", 2},
        {"sqrt (9)", 3},
        {".5 + 1. + 1e1 + 2.5e-1", 11.75},
        {"\ta\n", 2},
        {"b ^ 4", 81},
        {"(a + 1) ^ 3 - (b ^ 1)", 24},
        {"a ^ 64", 18446744073709551616.0},
        {"a - b * (a - b * (a - b))", 2 - 3 * (2 - 3 * (2 - 3.0))},
    };
    for (const auto& [text, wanted] : cases) EXPECT_EQ(value(text), wanted) << text;
}

TEST(Formula, NanAndZeroes) {
    // c is NaN.
    for (const char* text : {"c == c", "c < 1", "c >= 1", "!c", "c != c && 0", "c == 1 || c > 0"})
        EXPECT_EQ(value(text), 0) << text;
    for (const char* text : {"c != c", "c != 1", "!(c > 1)", "c && 1", "c || 0", "c ? 1 : 0"})
        EXPECT_EQ(value(text), 1) << text;
    for (const char* text : {"c", "-c", "0 / 0", "-(0 / 0)", "sqrt(-1)", "min(c, 1)", "1 / 0 - 1 / 0", "c * 0", "+c"})
        EXPECT_EQ(bits(value(text)), bits(nan)) << text;
    EXPECT_EQ(value("min(1, c)"), 1);
    EXPECT_EQ(value("max(1, c)"), 1);
    EXPECT_EQ(value("1 / 0"), inf);
    EXPECT_EQ(value("1 / -0"), -inf);
    EXPECT_EQ(value("1 / (0 * -a)"), -inf);
    EXPECT_EQ(value("c ^ 0"), 1);
    const Formula formula("c", abc);
    EXPECT_FALSE(formula.holds(std::vector<double>{0, 0, nan}));
    EXPECT_FALSE(formula.holds(std::vector<double>{0, 0, -0.0}));
    EXPECT_TRUE(formula.holds(std::vector<double>{0, 0, -1}));
}

TEST(Formula, UsedNamesAreThoseOfTheTextAndTheirPlacesDoNotMatter) {
    const auto used = [](std::string_view text) {
        const Formula formula(text, abc);
        return std::vector<std::size_t>(formula.used().begin(), formula.used().end());
    };
    EXPECT_EQ(used("c + a * c"), (std::vector<std::size_t>{2, 0}));
    EXPECT_EQ(used("b"), (std::vector<std::size_t>{1}));
    EXPECT_EQ(used("1 + 2"), std::vector<std::size_t>());
    EXPECT_EQ(Formula("1 + 2", {}).value({}), 3);
    // A copy stands on its own.
    std::optional<Formula> first(std::in_place, "a + 10 * b", abc);
    const Formula copy = *first;
    first.reset();
    EXPECT_EQ(copy.value(std::vector<double>{1, 2, 0}), 21);
}

TEST(Formula, ErrorsSayWhatWhereAndWhy) {
    const std::pair<const char*, const char*> cases[] = {
        {"", "it is empty"},
        {" \n ", "it is empty"},
        {"a +", "column 4: it ends, but a number, a name or ( is needed here"},
        {"a + * b", "column 5: found '*' where a number, a name or ( is needed"},
        {"min()", "column 5: found ')' where a number, a name or ( is needed"},
        {"a b", "column 3: an operator is missing before 'b'"},
        {"2a", "column 2: an operator is missing before 'a'"},
        {"1..2", "column 3: an operator is missing before '.2'"},
        {"a (b)", "column 1: there is no function 'a' (functions: sqrt, min, max)"},
        {"(a + 1", "column 1: ( without )"},
        {"max(a, b", "column 4: ( without )"},
        {"a + 1)", "column 6: ) without ("},
        {"a ? b", "column 3: ? without :"},
        {"(a ? b) : c", "column 7: ) without ("},
        {"a : b", "column 3: : without ?"},
        {"a, b", "column 2: write one expression, not several"},
        {"a = 1", "column 3: write == for '='"},
        {"a & b", "column 3: write && for '&'"},
        {"a or b", "column 3: write || for 'or'"},
        {"not a", "column 1: there is no name 'not'; write ! (names: a, b, c)"},
        {"abs(a)", "column 1: there is no function 'abs'; write max(x, -x) (functions: sqrt, min, max)"},
        {"sqr(a)", "column 1: there is no function 'sqr' (functions: sqrt, min, max)"},
        {"sin(a)", "column 1: there is no function 'sin' (functions: sqrt, min, max)"},
        {"sqrt + 1", "column 1: sqrt is a function: write sqrt(...)"},
        {"1 + sqrt(a, b)", "column 5: sqrt takes one number, not 2"},
        {"a ^ b", "column 5: ^ takes a whole number from 0 to 64; sqrt(x) and 1 / x are others"},
        {"a ^ -1", "column 5: ^ takes a whole number from 0 to 64; sqrt(x) and 1 / x are others"},
        {"a ^ 0.5", "column 5: ^ takes a whole number from 0 to 64; sqrt(x) and 1 / x are others"},
        {"a ^ 65", "column 5: ^ takes a whole number from 0 to 64; sqrt(x) and 1 / x are others"},
        {"1e999", "column 1: the number '1e999' is too large or too small"},
        {"a > @", "column 5: '@' is not allowed here"},
        {"a \xe2\x89\xa4 b", "column 3: '\xe2\x89\xa4' is not allowed here"},  // ≤
        {"d", "column 1: there is no name 'd' (names: a, b, c)"},
    };
    for (const auto& [text, why] : cases) EXPECT_EQ(error_of(text), "formula '" + one_line(text) + "': " + why) << text;
    constexpr std::string_view names[] = {"content", "own_content", "angle"};
    EXPECT_EQ(error_of("contnet > 1", names),
              "formula 'contnet > 1': column 1: there is no name 'contnet'; did you mean content? (names: content, "
              "own_content, angle)");
    try {
        const Formula formula("step == x + 1", abc, "condition", "step:x + 1");
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "condition 'step:x + 1': column 1: there is no name 'step' (names: a, b, c)");
    }
    try {
        const Formula formula("a == x", abc, "condition", "a:x");
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "condition 'a:x': column 3: there is no name 'x' (names: a, b, c)");
    }
}

TEST(Formula, LengthDepthAndSizeAreLimited) {
    const auto nested = [](const std::string& open, const std::string& close, int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += open;
        text += "a";
        for (int i = 0; i < count; ++i) text += close;
        return text;
    };
    const int d = Formula::deepest;
    for (const auto& [open, close] : {std::pair("(", ")"), std::pair("-", ""), std::pair("!", ""),
                                      std::pair("1?a:", ""), std::pair("min(1,", ")")}) {
        EXPECT_EQ(error_of(nested(open, close, d - 1)), "") << open;
        EXPECT_NE(error_of(nested(open, close, d + 1)).find("more than 64 levels lie inside each other"),
                  std::string::npos)
            << open;
    }
    EXPECT_NE(error_of(nested("1^", "", 100)).find("levels"), std::string::npos);
    std::string sum = "a";
    while (sum.size() + 2 <= Formula::longest_text) sum += "+a";
    EXPECT_EQ(value(sum), 2.0 * static_cast<double>((sum.size() + 1) / 2));
    EXPECT_EQ(error_of(sum + " "), "");
    // Registers of results are used again: 250 products would not fit beside 10 numbers.
    std::string products = "a*0";
    double wanted = 0;
    for (int i = 1; i < 250; ++i) {
        products += "+a*" + std::to_string(i % 10);
        wanted += 2 * (i % 10);
    }
    EXPECT_EQ(value(products), wanted);
    EXPECT_NE(error_of(sum + "+ a").find("': it has 1002 characters; at most 1000 are read"), std::string::npos);
    EXPECT_LT(error_of(std::string(100000, '(')).size(), 1200u);
    // As many different numbers as there is room for, then more.
    const auto numbers = [](int count) {
        std::string text = "a";
        for (int i = 0; i < count; ++i) text += "<" + std::to_string(i);
        return text;
    };
    EXPECT_EQ(error_of(numbers(254)), "");
    EXPECT_NE(error_of(numbers(255)).find("it has more than 256 numbers, names and results"), std::string::npos);
}

TEST(Formula, AnyBytesAreAFormulaOrAnInputError) {
    constexpr std::string_view pieces[] = {"content", "angle", "handed_on", " ",    "==", "=",   "<",   "&&",
                                           "||",      "!",     "(",         ")",    "1",  ".5",  "-",   "+",
                                           "*",       "/",     "^",         "^2",   "?",  ":",   ",",   "1e9",
                                           "min(",    "sqrt(", "1e999",     "\xff", "\n", "sin", "0x1", "\xe2\x89"};
    Random random(43);
    int taken = 0;
    for (int i = 0; i < 100000; ++i) {
        std::string text;
        for (std::uint64_t k = 1 + random.below(12); k > 0; --k) text += pieces[random.below(std::size(pieces))];
        taken += fuzz::fuzz_formula(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    }
    EXPECT_GT(taken, 2000);
}

TEST(Text, ClosestIsAWordFewLettersAway) {
    constexpr std::string_view words[] = {"rendered", "rendered_now", "rho", "front", "a"};
    EXPECT_EQ(closest("renderd", words), "rendered");
    EXPECT_EQ(closest("renderednow", words), "rendered_now");
    EXPECT_EQ(closest("rhoo", words), "rho");
    EXPECT_EQ(closest("frnot", words), "front");
    EXPECT_EQ(closest("fortn", words), "front") << "letters that have changed places count once";
    EXPECT_EQ(closest("rend", words), "rendered") << "half a word";
    EXPECT_EQ(closest("qzxfk", words), "");
    EXPECT_EQ(closest("b", words), "");
    EXPECT_EQ(closest("", words), "");
    EXPECT_EQ(closest("xyz", {}), "");
}

}  // namespace
}  // namespace sightline
