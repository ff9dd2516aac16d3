// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sightline {

namespace {

constexpr Colour white{255, 255, 255}, black{0, 0, 0};

Style area(const char* name, Colour fill, Hatch hatch = Hatch::none, Colour hatch_colour = transparent) {
    Style style{name};
    style.fill = fill;
    style.hatch = hatch;
    style.hatch_colour = hatch_colour;
    return style;
}

Style line(const char* name, Colour stroke, double width_pt, Dash dash = Dash::solid) {
    Style style{name};
    style.stroke = stroke;
    style.width_pt = width_pt;
    style.dash = dash;
    return style;
}

Style mark(const char* name, Colour fill, Colour stroke, double width_pt) {
    Style style = line(name, stroke, width_pt);
    style.fill = fill;
    return style;
}

/// Relative luminance in [0, 1].
double luminance(const Colour& colour) {
    const auto linear = [](std::uint8_t part) {
        const double v = part / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
}

/// Safe for colour-blind readers: after Okabe and Ito's set; the four states at L* of about 100, 79, 58 and 36.
Colours standard() {
    const Colour blue{0, 90, 170}, vermilion{200, 70, 0}, grey{120, 120, 120}, purple{140, 50, 120},
        magenta{215, 0, 130}, violet{100, 30, 210};
    return {white,
            black,
            white,
            vermilion,
            {
                area("clean", white),
                area("enqueued", {36, 86, 150}, Hatch::diagonal, {150, 190, 235}),
                area("projected", {166, 203, 187}),
                area("unseen", {140, 140, 140}, Hatch::dots, {205, 205, 205}),
                line("only_here", magenta, 2.2),
                area("only_there", transparent, Hatch::dots, magenta),
                line("tessellation", {105, 125, 145}, 0.5),
                line("other", {125, 125, 125}, 0.7),
                line("rendered", black, 1.6),
                line("missed", vermilion, 1.8),
                line("wasted", purple, 1.1, Dash::dashed),
                line("view", blue, 0.9, Dash::dashed),
                line("display_view", grey, 0.7, Dash::dotted),
                mark("eye", {230, 160, 0}, black, 0.7),
                line("seed", {230, 160, 0}, 1.6),
                line("selected", violet, 2.0),
                line("last", {0, 125, 105}, 2.0),
                line("eye_ray", blue, 0.6, Dash::dotted),
                line("normal", {235, 110, 0}, 1.3),
                line("penalty", vermilion, 1.1),
                line("chain", vermilion, 1.3),
                line("selected_primitive", violet, 3.4),
                line("note", black, 0.8),
                area("completed", {166, 203, 187}, Hatch::cross, {90, 150, 130}),
                area("hidden", {36, 86, 150}, Hatch::dots, {150, 190, 235}),
                line("next", {0, 125, 105}, 1.6, Dash::dashed),
                line("level_1", {100, 185, 225}, 1.4),
                line("level_2", {0, 140, 205}, 1.4),
                line("level_3", {0, 90, 170}, 1.4),
                area("postponed", {214, 160, 96}, Hatch::back_diagonal, {150, 95, 35}),
            },
            // Solid is dark: black lines stay legible on the many cells of low numbers.
            {{255, 251, 232}, {252, 222, 150}, {240, 165, 85}, {205, 90, 80}, {120, 30, 90}},
            {{112, 140, 180},
             {150, 165, 110},
             {150, 130, 175},
             {95, 160, 155},
             {185, 165, 115},
             {130, 140, 150},
             {115, 165, 195}},
            {255, 0, 0}};
}

/// The colours of TR figs 1, 2 and 4: white input, blue tessellation and front, green cells, red rendered geometry.
Colours paper() {
    const Colour green{60, 220, 60}, red{255, 60, 60}, cyan{0, 220, 220};
    return {black,
            white,
            black,
            red,
            {
                area("clean", black),
                area("enqueued", {25, 50, 170}, Hatch::diagonal, {90, 130, 255}),
                mark("projected", {0, 75, 0}, green, 0.6),
                area("unseen", {58, 58, 58}, Hatch::dots, {110, 110, 110}),
                line("only_here", cyan, 2.0),
                area("only_there", transparent, Hatch::dots, cyan),
                line("tessellation", {50, 80, 200}, 0.5),
                line("other", {215, 215, 215}, 0.7),
                line("rendered", red, 1.6),
                line("missed", {255, 220, 0}, 1.8),
                line("wasted", {255, 140, 140}, 1.1, Dash::dashed),
                line("view", red, 0.9),
                line("display_view", white, 0.7, Dash::dotted),
                mark("eye", {255, 220, 0}, white, 0.7),
                line("seed", green, 1.6),
                line("selected", {255, 220, 0}, 2.0),
                line("last", white, 1.4),
                line("eye_ray", {255, 220, 0}, 0.6, Dash::dotted),
                line("normal", white, 1.0),
                line("penalty", {255, 220, 0}, 1.1),
                line("chain", {255, 220, 0}, 1.3),
                line("selected_primitive", {255, 220, 0}, 3.4),
                line("note", white, 0.8),
                mark("completed", {0, 75, 0}, {255, 220, 0}, 0.6),
                area("hidden", {25, 50, 170}, Hatch::dots, {90, 130, 255}),
                line("next", white, 1.4, Dash::dashed),
                line("level_1", {190, 235, 255}, 1.4),
                line("level_2", {110, 210, 255}, 1.4),
                line("level_3", {0, 170, 255}, 1.4),
                area("postponed", {110, 70, 15}, Hatch::back_diagonal, {215, 150, 60}),
            },
            {{0, 0, 90}, {60, 30, 170}, {190, 50, 120}, {240, 140, 50}, {255, 240, 120}},
            {{70, 100, 160},
             {100, 130, 70},
             {120, 90, 150},
             {50, 125, 120},
             {140, 120, 70},
             {105, 105, 115},
             {65, 125, 165}},
            {255, 220, 0}};
}

/// Greys only.
Colours print() {
    const Colour dark{70, 70, 70};
    return {white,
            black,
            white,
            black,
            {
                area("clean", white),
                area("enqueued", {86, 86, 86}, Hatch::diagonal, {215, 215, 215}),
                area("projected", {195, 195, 195}),
                area("unseen", {140, 140, 140}, Hatch::cross, {205, 205, 205}),
                line("only_here", black, 2.6, Dash::dotted),
                area("only_there", transparent, Hatch::horizontal, black),
                line("tessellation", {110, 110, 110}, 0.5),
                line("other", {120, 120, 120}, 0.7),
                line("rendered", black, 1.8),
                line("missed", black, 1.8, Dash::dotted),
                line("wasted", dark, 1.1, Dash::dashed),
                line("view", black, 0.8, Dash::dashed),
                line("display_view", dark, 0.7, Dash::dotted),
                mark("eye", white, black, 0.9),
                line("seed", {120, 120, 120}, 2.8),
                line("selected", black, 2.2),
                line("last", black, 1.6),
                line("eye_ray", dark, 0.6, Dash::dotted),
                line("normal", dark, 1.0),
                line("penalty", black, 1.1),
                line("chain", black, 1.4),
                line("selected_primitive", black, 3.4),
                line("note", black, 0.8),
                area("completed", {195, 195, 195}, Hatch::cross, {120, 120, 120}),
                area("hidden", {86, 86, 86}, Hatch::dots, {215, 215, 215}),
                line("next", black, 1.6, Dash::dashed),
                line("level_1", {160, 160, 160}, 1.4),
                line("level_2", {115, 115, 115}, 1.4),
                line("level_3", {70, 70, 70}, 1.4),
                area("postponed", {168, 168, 168}, Hatch::back_diagonal, {80, 80, 80}),
            },
            {{250, 250, 250}, {205, 205, 205}, {155, 155, 155}, {110, 110, 110}, {75, 75, 75}},
            {{150, 150, 150},
             {210, 210, 210},
             {125, 125, 125},
             {185, 185, 185},
             {105, 105, 105},
             {230, 230, 230},
             {168, 168, 168}},
            black};
}

}  // namespace

const Colours& colours(Palette palette) {
    static const std::array table{standard(), paper(), print()};
    return table[static_cast<std::size_t>(palette)];
}

double lightness(const Colour& colour) {
    const double y = luminance(colour);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

double contrast(const Colour& a, const Colour& b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

Colour between(const std::vector<Colour>& stops, double share) {
    const double at = share * static_cast<double>(stops.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const double t = at - static_cast<double>(i);
    const auto mix = [&](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a + (b - a) * t + 0.5); };
    return {mix(stops[i].r, stops[i + 1].r), mix(stops[i].g, stops[i + 1].g), mix(stops[i].b, stops[i + 1].b)};
}

}  // namespace sightline
