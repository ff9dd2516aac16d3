// Looks of variants: one each, the same whatever else is shown, and apart for every eye.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/variant_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/draw/palette.h"
#include "core/methods/method_table.h"

namespace sightline {
namespace {

VariantLook look_alone(const std::string& variant) { return variant_looks(std::array{variant}).front(); }

std::vector<std::string> methods() {
    std::vector<std::string> ids;
    for (const Method<3>& method : method_table<3>()) ids.emplace_back(method.id);
    return ids;
}

/// The table, and for each method all values of its choices.
std::vector<std::string> methods_and_variants() {
    std::vector<std::string> all = methods();
    for (const Method<3>& method : method_table<3>())
        for (const ParameterRow* row : method.parameters)
            for (const std::string_view word : row->words)
                all.push_back(std::string(method.id) + " " + std::string(row->name) + "=" + std::string(word));
    return all;
}

void expect_all_differ(const std::vector<std::string>& variants) {
    const std::vector<VariantLook> looks = variant_looks(variants);
    ASSERT_EQ(looks.size(), variants.size());
    for (std::size_t i = 0; i < looks.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(looks[i] == looks[j]) << variants[i] << " and " << variants[j];
}

TEST(VariantLook, AllOfTheTableAndTheirVariantsDiffer) {
    const std::vector<std::string> all = methods_and_variants();
    EXPECT_GT(all.size(), 30u);
    expect_all_differ(all);
    std::vector<std::string> many = methods();
    for (int i = 0; i < 90; ++i) many.push_back("published penalty_amount=" + std::to_string(1 + 0.1 * i));
    expect_all_differ(many);
    std::vector<std::string> others = methods();
    for (int i = 0; i < 24; ++i) others.push_back("of_ones_own_" + std::to_string(i));
    expect_all_differ(others);
}

TEST(VariantLook, AFewVariantsOfAMethodDifferByTheirLinesAlone) {
    std::vector<std::string> few{"published"};
    for (int i = 0; i < 15; ++i) few.push_back("published penalty_amount=" + std::to_string(2 + i));
    const std::vector<VariantLook> looks = variant_looks(few);
    for (std::size_t i = 0; i < looks.size(); ++i) {
        EXPECT_EQ(looks[i].dash.empty(), i == 0) << few[i];
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(looks[i].same_line(looks[j])) << few[i] << ", " << few[j];
    }
}

TEST(VariantLook, AMethodOfTheTableLooksTheSameWhateverElseIsShown) {
    const std::vector<std::string> all = methods_and_variants();
    const std::vector<VariantLook> looks = variant_looks(all);
    for (std::size_t i = 0; i < methods().size(); ++i) EXPECT_TRUE(looks[i] == look_alone(all[i])) << all[i];
    EXPECT_EQ(hex_colour(look_alone("published").colour), "#0072b2") << "as in the charts so far";
    EXPECT_TRUE(look_alone("distance") == look_alone("centroid")) << "an alias";
}

TEST(VariantLook, NeitherTheOrderOfTheListNorHowAVariantIsWrittenMatters) {
    std::vector<std::string> all = methods_and_variants();
    const std::vector<VariantLook> looks = variant_looks(all);
    std::vector<std::string> backwards(all.rbegin(), all.rend());
    std::vector<VariantLook> again = variant_looks(backwards);
    std::reverse(again.begin(), again.end());
    EXPECT_TRUE(looks == again);
    EXPECT_TRUE(look_alone("published penalty=add on_reenqueue=min") ==
                look_alone("published on_reenqueue=min  penalty=add"));
    EXPECT_TRUE(look_alone("published penalty_amount=3") == look_alone("published penalty_amount=3.0"));
    // No method at all, as results from somebody else may name one.
    EXPECT_TRUE(look_alone("`a\" b=") == look_alone("`a\" b="));
}

TEST(VariantLook, AVariantKeepsItsLookWhileNobodyHasIt) {
    const std::string variant = "published on_reenqueue=min";
    std::vector<std::string> with = methods();
    with.push_back(variant);
    EXPECT_TRUE(variant_looks(with).back() == look_alone(variant));
    std::size_t kept = 0;
    for (int i = 0; i < 100; ++i) {
        const std::array both{variant, "published penalty_amount=" + std::to_string(2 + i)};
        const std::vector<VariantLook> looks = variant_looks(both);
        EXPECT_FALSE(looks[0].same_line(looks[1]));
        EXPECT_TRUE(looks[0] == look_alone(both[0])) << "it comes first";
        kept += looks[1] == look_alone(both[1]);
    }
    EXPECT_GE(kept, 80u) << "14 in 15, by chance";
}

using Lab = std::array<double, 3>;

double linear(std::uint8_t part) {
    const double c = part / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// As seen with a kind of colour vision, in CIELAB (D65). Matrices: Machado, Oliveira, Fernandes 2009, severity 1.
Lab seen(const Colour& colour, const std::array<double, 9>& m) {
    const std::array in{linear(colour.r), linear(colour.g), linear(colour.b)};
    std::array<double, 3> c{};
    for (std::size_t i = 0; i < 3; ++i)
        c[i] = std::clamp(m[3 * i] * in[0] + m[3 * i + 1] * in[1] + m[3 * i + 2] * in[2], 0.0, 1.0);
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double x = f((0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2]) / 0.95047),
                 y = f(0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2]),
                 z = f((0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

constexpr std::array<std::array<double, 9>, 4> eyes{
    {{1, 0, 0, 0, 1, 0, 0, 0, 1},
     {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998},
     {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},
     {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}}};

double least_difference(const Colour& a, const Colour& b) {
    double least = 1e9;
    for (const auto& eye : eyes) {
        const Lab x = seen(a, eye), y = seen(b, eye);
        least = std::min(least, std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
    }
    return least;
}

TEST(VariantLook, ColoursStayApartForEveryEyeAndStandOutOnPaper) {
    std::vector<std::string> all;
    for (int i = 0; i < 30; ++i) all.push_back("m" + std::to_string(i));
    std::vector<Colour> colours;
    for (const VariantLook& look : variant_looks(all))
        if (std::find(colours.begin(), colours.end(), look.colour) == colours.end()) colours.push_back(look.colour);
    EXPECT_EQ(colours.size(), 24u);
    for (const Colour& colour : colours) EXPECT_GE(contrast(colour, {255, 255, 255}), 3) << hex_colour(colour);
    const std::vector<VariantLook> table = variant_looks(methods());
    for (std::size_t i = 0; i < table.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (const double apart = least_difference(table[i].colour, table[j].colour); apart < 16) {
                // There are eight hues; from the ninth method on markers help.
                EXPECT_GE(std::max(i, j), 8u) << methods()[i] << ", " << methods()[j];
                EXPECT_NE(table[i].marker, table[j].marker) << methods()[i] << ", " << methods()[j];
                // From the twenty-first on there are no more such colours: those methods are shown when asked for.
                if (std::max(i, j) < 20) {
                    EXPECT_GE(apart, 10) << methods()[i] << ", " << methods()[j];
                }
            }
}

}  // namespace
}  // namespace sightline
