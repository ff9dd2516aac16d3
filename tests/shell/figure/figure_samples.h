// Figures that the figure tests share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/draw/draw_list.h"

namespace sightline {

/// A square with cells in every hatch, lines, marks and labels.
inline DrawList sample_list() {
    DrawList list;
    list.world = {Vec<2>(0), Vec<2>(1)};
    for (const Hatch hatch :
         {Hatch::none, Hatch::diagonal, Hatch::back_diagonal, Hatch::cross, Hatch::horizontal, Hatch::dots})
        list.styles.push_back({"cell", {230, 240, 250}, hatch, {200, 80, 0}, {120, 120, 120}, 0.1, Dash::solid});
    list.styles.push_back({"line", transparent, Hatch::none, transparent, {200, 0, 0}, 1.2, Dash::dashed});
    list.styles.push_back({"mark", {0, 0, 0}, Hatch::none, transparent, {0, 0, 160}, 0, Dash::dotted});
    list.styles.push_back({"cone", {255, 220, 0, 60}, Hatch::none, transparent, transparent, 0, Dash::solid});
    for (std::uint16_t i = 0; i < 6; ++i) {
        const double x = i / 6.0, w = 1 / 6.0;
        list.add(ShapeKind::polygon, i, {{x, 0}, {x + w, 0.1}, {x + w, 0.5}, {x, 0.6}});
    }
    list.add(ShapeKind::polyline, 6, {{0.1, 0.7}, {0.5, 0.9}, {2, 0.7}});
    list.add(ShapeKind::arrow, 6, {{0.1, 0.8}, {0.4, 0.85}}, 5);
    list.add(ShapeKind::disc, 7, {{0.7, 0.8}}, 3);
    list.add(ShapeKind::ring, 7, {{0.8, 0.8}}, 3);
    list.add(ShapeKind::cross, 7, {{0.9, 0.8}}, 3);
    list.add(ShapeKind::polygon, 8, {{0.1, 0.1}, {3, 0.2}, {3, 2}});
    list.labels.push_back(
        {{0.5, 0.5}, {0, 4}, "\u03c1 = 0.37 & <\u03b6>", TextAlign::left, 1, {0, 0, 0}, {255, 255, 255}, {}});
    list.labels.push_back({{0.2, 0.3}, {0, 0}, "12", TextAlign::centre, 0.9, {255, 255, 255}, transparent, Colour{}});
    return list;
}

inline Figure sample_figure(std::size_t panels, LegendPlace place) {
    Figure figure;
    for (std::size_t i = 0; i < panels; ++i)
        figure.panels.push_back({sample_list(), "(" + std::string(1, static_cast<char>('a' + i)) + ") step 12"});
    const DrawList list = sample_list();
    figure.legend.resize(3);
    figure.legend[0] = {ShapeKind::polygon, list.styles[1], "enqueued"};
    figure.legend[1] = {ShapeKind::polyline, list.styles[6], "visible, \u03b6 = 1"};
    figure.legend[2] = {ShapeKind::disc, list.styles[7], "eye"};
    figure.bar = ColourBar{"accumulated solidity \u03c1", "0", "1.84", {{255, 255, 255}, {0, 60, 130}}};
    figure.legend_place = place;
    figure.caption = "Coverage \u03b5\u2085\u2080\u2080 = |V\u2229T| / |V| rises from 0.41 \u2192 0.93 & stays there.";
    return figure;
}

inline std::string random_words(Random& random, std::size_t most) {
    std::string text;
    for (std::size_t n = random.below(most + 1); n > 0; --n) {
        for (std::size_t k = 1 + random.below(random.below(20) == 0 ? 60 : 9); k > 0; --k)
            text += random.below(8) == 0 ? std::string("\u03c1")
                                         : std::string(1, static_cast<char>('a' + random.below(26)));
        text += random.below(30) == 0 ? '\n' : ' ';
    }
    return text;
}

inline Figure random_figure(Random& random) {
    Figure figure;
    for (std::size_t i = random.below(9); i > 0; --i) {
        Figure::Panel panel;
        const Vec<2> corner(random.uniform(-9, 9), random.uniform(-9, 9));
        panel.list.world = {corner, corner + Vec<2>(random.uniform(0, 3), random.uniform(0, 3))};
        if (random.below(3) > 0) panel.title = random_words(random, 5);
        figure.panels.push_back(panel);
    }
    figure.legend.resize(random.below(9));
    for (LegendRow& row : figure.legend) row.text = random_words(random, 4);
    if (random.below(2) == 0)
        figure.bar = ColourBar{random_words(random, 3), "0", "123456", {{0, 0, 0}, {255, 255, 255}}};
    figure.legend_place = static_cast<LegendPlace>(random.below(3));
    figure.caption = random_words(random, 30);
    return figure;
}

}  // namespace sightline
