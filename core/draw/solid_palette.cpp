// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/solid_palette.h"

#include <array>

namespace sightline {

namespace {

SolidStyle solid(const char* name, Colour colour, double width_pt = 0.8) { return {name, colour, true, width_pt}; }

SolidStyle edge(const char* name, Colour colour, double width_pt) { return {name, colour, false, width_pt}; }

/// The states' colours are those of pictures in 2D; the triangles are of stone, so that a class with a hue stands out.
std::vector<SolidStyle> standard_solids() {
    return {
        solid("clean", {150, 165, 180}, 0.5),  solid("enqueued", {36, 86, 150}),
        solid("projected", {166, 203, 187}),   solid("unseen", {140, 140, 140}),
        edge("only_here", {215, 0, 130}, 1.4), edge("only_there", {240, 165, 210}, 0.6),
        edge("border", {90, 110, 130}, 0.5),   solid("plain", {205, 200, 190}),
        solid("rest", {228, 230, 234}),        solid("rendered", {205, 200, 190}),
        solid("missed", {200, 70, 0}),         solid("wasted", {185, 135, 175}),
        solid("other", {228, 230, 234}),       solid("fresh", {240, 175, 20}),
        solid("completed", {95, 160, 140}),    solid("hidden", {120, 150, 190}),
        solid("added", {95, 160, 140}),        solid("level_1", {165, 190, 215}),
        solid("level_2", {125, 160, 200}),     solid("level_3", {85, 125, 185}),
        solid("postponed", {214, 160, 96}),
    };
}

/// TVCG fig. 1: projected cells red, others green; the front blue as in TR figs 1 and 4; missed pixels red (TVCG fig.
/// 14).
std::vector<SolidStyle> paper_solids() {
    const Colour red{255, 60, 60}, green{60, 220, 60}, blue{90, 130, 255};
    return {
        solid("clean", green, 0.5),
        solid("enqueued", blue),
        solid("projected", red),
        solid("unseen", {110, 110, 110}),
        edge("only_here", {0, 220, 220}, 1.4),
        edge("only_there", {0, 130, 130}, 0.6),
        edge("border", {120, 20, 20}, 0.5),
        solid("plain", {215, 215, 215}),
        solid("rest", {90, 90, 100}),
        solid("rendered", {215, 215, 215}),
        solid("missed", red),
        solid("wasted", {255, 160, 160}),
        solid("other", {90, 90, 100}),
        solid("fresh", {255, 220, 0}),
        solid("completed", {255, 160, 60}),
        solid("hidden", {50, 80, 160}),
        solid("added", {255, 160, 60}),
        solid("level_1", {170, 205, 255}),
        solid("level_2", {120, 165, 255}),
        solid("level_3", {80, 120, 235}),
        solid("postponed", {140, 90, 20}),
    };
}

/// Greys only.
std::vector<SolidStyle> print_solids() {
    const auto grey = [](std::uint8_t v) { return Colour{v, v, v}; };
    return {
        solid("clean", grey(165), 0.5), solid("enqueued", grey(60)),     solid("projected", grey(225)),
        solid("unseen", grey(125)),     edge("only_here", grey(0), 1.6), edge("only_there", grey(90), 0.6),
        edge("border", grey(110), 0.5), solid("plain", grey(190)),       solid("rest", grey(235)),
        solid("rendered", grey(175)),   solid("missed", grey(30)),       solid("wasted", grey(120)),
        solid("other", grey(235)),      solid("fresh", grey(70)),        solid("completed", grey(175)),
        solid("hidden", grey(100)),     solid("added", grey(175)),       solid("level_1", grey(150)),
        solid("level_2", grey(125)),    solid("level_3", grey(95)),      solid("postponed", grey(145)),
    };
}

}  // namespace

const std::vector<SolidStyle>& solid_styles(Palette palette) {
    static const std::array table{standard_solids(), paper_solids(), print_solids()};
    return table[static_cast<std::size_t>(palette)];
}

}  // namespace sightline
