// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/box_palette.h"

#include <algorithm>
#include <array>

#include "core/draw/palette.h"

namespace sightline {

namespace {

/// In the order of legends.
constexpr std::array box_entries{
    BoxEntry{"invisible", ShapeKind::polygon, "INVISIBLE: dropped"},
    BoxEntry{"shown", ShapeKind::polygon, "PARTIAL or VISIBLE"},
    BoxEntry{"outside", ShapeKind::polygon, "box outside the view"},
    BoxEntry{"eye_leaf", ShapeKind::polygon, "leaf with the eye"},
    BoxEntry{"last_box", ShapeKind::polygon, "box tested last"},
    BoxEntry{"selected_box", ShapeKind::polygon, "selected box"},
    BoxEntry{"actual", ShapeKind::polyline, "occluder"},
    BoxEntry{"potential", ShapeKind::polyline, "potential occluder"},
    BoxEntry{"hidden_eyes", ShapeKind::polygon, "3: from here it hides the box"},
    BoxEntry{"partial_eyes", ShapeKind::polygon, "2: from here a part of it"},
    BoxEntry{"supporting", ShapeKind::polyline, "supporting, satisfied"},
    BoxEntry{"supporting_fails", ShapeKind::polyline, "supporting, not satisfied"},
    BoxEntry{"separating", ShapeKind::polyline, "separating, satisfied"},
    BoxEntry{"separating_fails", ShapeKind::polyline, "separating, not satisfied"},
    BoxEntry{"satisfied", ShapeKind::polygon, "plane, satisfied"},
    BoxEntry{"fails", ShapeKind::polygon, "plane, not satisfied"},
    BoxEntry{"own", ShapeKind::polyline, "the occluder's plane"},
    BoxEntry{"own_fails", ShapeKind::polyline, "the occluder's plane: box before it"},
    BoxEntry{"lit", ShapeKind::polyline, "selected plane"},
    BoxEntry{"region", ShapeKind::polyline, "from here it is an occluder"},
    BoxEntry{"region_box", ShapeKind::polyline, "box around that"},
};

Style box_area(const char* name, Colour fill, Colour rim, Hatch hatch = Hatch::none, Colour hatch_colour = transparent,
               double width_pt = 0.6) {
    Style style{name};
    style.fill = fill;
    style.hatch = hatch;
    style.hatch_colour = hatch_colour;
    style.stroke = rim;
    style.width_pt = width_pt;
    return style;
}

Style box_line(const char* name, Colour stroke, double width_pt, Dash dash = Dash::solid) {
    Style style{name};
    style.stroke = stroke;
    style.width_pt = width_pt;
    style.dash = dash;
    return style;
}

Style named(const char* name, Palette palette, Look look) {
    Style style = colours(palette).looks[static_cast<std::size_t>(look)];
    style.name = name;
    return style;
}

struct PlaneColours {
    Colour satisfied, fails, own, lit, region;
};

/// A plane that is not satisfied is dashed, a separating one thin: both can be told without colours.
void add_planes(const PlaneColours& c, std::vector<Style>& styles) {
    styles.push_back(box_line("supporting", c.satisfied, 1.6));
    styles.push_back(box_line("supporting_fails", c.fails, 1.6, Dash::dashed));
    styles.push_back(box_line("separating", c.satisfied, 0.8));
    styles.push_back(box_line("separating_fails", c.fails, 0.8, Dash::dashed));
    styles.push_back(box_line("own", c.own, 0.6, Dash::dotted));
    styles.push_back(box_line("own_fails", c.fails, 0.6, Dash::dotted));
    styles.push_back(box_line("lit", c.lit, 3.2));
    styles.push_back(box_line("region", c.region, 1.1, Dash::dotted));
    styles.push_back(box_line("region_box", c.region, 0.7));
}

/// INVISIBLE, shown, outside and waiting boxes at L* of about 51, 88, 72 and 36.
std::vector<Style> standard_boxes() {
    std::vector<Style> styles{
        box_area("invisible", {55, 140, 75}, {25, 85, 40}, Hatch::back_diagonal, {130, 200, 145}),
        box_area("shown", {176, 232, 240}, {0, 125, 150}),
        box_area("outside", {150, 175, 240}, {70, 100, 190}, Hatch::dots, {95, 125, 210}),
        box_area("eye_leaf", {255, 228, 60, 150}, {190, 145, 0}, Hatch::none, transparent, 1.2),
        named("last_box", Palette::standard, Look::last),
        named("selected_box", Palette::standard, Look::selected),
        box_line("actual", {0, 0, 0}, 4),
        box_line("potential", {185, 185, 185}, 2.4),
        box_area("partial_eyes", {255, 190, 70, 70}, transparent),
        box_area("hidden_eyes", {70, 170, 90, 85}, transparent),
    };
    add_planes({{0, 120, 60}, {205, 40, 30}, {110, 110, 110}, {215, 0, 130}, {125, 60, 160}}, styles);
    return styles;
}

/// As printed; what is black there is white on the black of this palette.
std::vector<Style> paper_boxes() {
    std::vector<Style> styles{
        box_area("invisible", {0, 110, 0}, {0, 255, 0}),
        box_area("shown", {0, 110, 110}, {0, 255, 255}),
        box_area("outside", {0, 0, 150}, {70, 70, 255}, Hatch::dots, {70, 70, 255}),
        box_area("eye_leaf", {255, 255, 0, 110}, {255, 255, 0}, Hatch::none, transparent, 1.2),
        named("last_box", Palette::paper, Look::last),
        named("selected_box", Palette::paper, Look::selected),
        box_line("actual", {255, 255, 255}, 4),
        box_line("potential", {125, 125, 125}, 2.4),
        box_area("partial_eyes", {255, 190, 70, 60}, transparent),
        box_area("hidden_eyes", {70, 255, 90, 70}, transparent),
    };
    add_planes({{110, 255, 110}, {255, 80, 80}, {170, 170, 170}, {255, 110, 255}, {210, 140, 255}}, styles);
    return styles;
}

std::vector<Style> print_boxes() {
    const auto grey = [](std::uint8_t v) { return Colour{v, v, v}; };
    std::vector<Style> styles{
        box_area("invisible", grey(130), grey(60), Hatch::back_diagonal, grey(215)),
        box_area("shown", grey(238), grey(90)),
        box_area("outside", grey(185), grey(120), Hatch::dots, grey(120)),
        box_area("eye_leaf", {255, 255, 255, 150}, grey(0), Hatch::none, transparent, 1.6),
        named("last_box", Palette::print, Look::last),
        named("selected_box", Palette::print, Look::selected),
        box_line("actual", grey(0), 4.4),
        box_line("potential", grey(180), 2.4),
        box_area("partial_eyes", {150, 150, 150, 50}, transparent),
        box_area("hidden_eyes", {60, 60, 60, 80}, transparent),
    };
    add_planes({grey(0), grey(90), grey(110), grey(0), grey(70)}, styles);
    return styles;
}

constexpr std::uint8_t glass = 70;

std::vector<SolidStyle> solids(Colour invisible, Colour shown, Colour outside, Colour actual, Colour potential,
                               Colour satisfied, Colour fails) {
    satisfied.a = fails.a = glass;
    return {
        {"invisible", invisible, true, 0.8}, {"shown", shown, true, 0.5},         {"outside", outside, true, 0.5},
        {"actual", actual, true, 0.8},       {"potential", potential, true, 0.8}, {"satisfied", satisfied, false, 0.8},
        {"fails", fails, false, 0.8},
    };
}

}  // namespace

const std::vector<Style>& box_looks(Palette palette) {
    static const std::array table{standard_boxes(), paper_boxes(), print_boxes()};
    return table[static_cast<std::size_t>(palette)];
}

const std::vector<SolidStyle>& solid_box_looks(Palette palette) {
    static const std::array table{
        solids({75, 165, 95}, {0, 140, 165}, {95, 125, 220}, {35, 35, 40}, {150, 150, 150}, {0, 150, 70},
               {215, 40, 30}),
        solids({0, 200, 0}, {0, 255, 255}, {70, 70, 255}, {70, 70, 75}, {150, 150, 150}, {110, 255, 110},
               {255, 80, 80}),
        solids({150, 150, 150}, {70, 70, 70}, {185, 185, 185}, {25, 25, 25}, {165, 165, 165}, {120, 120, 120},
               {30, 30, 30}),
    };
    return table[static_cast<std::size_t>(palette)];
}

const BoxEntry* box_entry(std::string_view name) {
    const auto found =
        std::find_if(box_entries.begin(), box_entries.end(), [&](const BoxEntry& entry) { return entry.name == name; });
    return found == box_entries.end() ? nullptr : &*found;
}

std::size_t row_of(const BoxEntry& entry) { return static_cast<std::size_t>(&entry - box_entries.data()); }

}  // namespace sightline
