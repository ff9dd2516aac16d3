// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/variant_look.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/methods/method_table.h"

namespace sightline {

namespace {

constexpr std::size_t hue_count = 8, shade_count = 3;

/// Hues from Okabe and Ito's palette and three dark ones, each with two shades more. Chosen by search: hues differ by
/// 16 and more in CIELAB for every kind of colour vision, shades of a hue by 18, and each has a contrast of 3 to white.
constexpr Colour shades[hue_count][shade_count] = {{{0, 114, 178}, {0, 68, 107}, {0, 0, 255}},         // blue
                                                   {{213, 94, 0}, {149, 66, 0}, {75, 33, 0}},          // vermillion
                                                   {{0, 158, 115}, {0, 103, 75}, {0, 47, 34}},         // green
                                                   {{204, 121, 167}, {122, 73, 100}, {51, 30, 42}},    // purple
                                                   {{0, 0, 0}, {64, 64, 64}, {140, 140, 140}},         // black
                                                   {{153, 51, 238}, {76, 26, 119}, {255, 45, 225}},    // violet
                                                   {{119, 51, 17}, {160, 112, 88}, {48, 20, 7}},       // brown
                                                   {{51, 17, 136}, {102, 76, 166}, {153, 136, 196}}};  // indigo

constexpr std::array dashed{6.0f, 3.0f}, dotted{1.5f, 2.5f}, long_dashed{14.0f, 4.0f};
constexpr std::array dash_dot{8.0f, 2.5f, 1.5f, 2.5f};
constexpr std::array dash_dot_dot{8.0f, 2.5f, 1.5f, 2.5f, 1.5f, 2.5f};
constexpr std::array<std::span<const float>, 5> dashes{dashed, dotted, dash_dot, long_dashed, dash_dot_dot};

constexpr std::size_t line_count = shade_count * dashes.size();

/// Of a method alone; numbers differ up to 8 hues x 3 shades. Shades of one hue have different markers, and so have
/// hues that are near each other in different shades.
VariantLook look_of_method(std::size_t number) {
    VariantLook look{shades[number % hue_count][number / hue_count % shade_count],
                     {},
                     static_cast<ChartMarker>((number + number / hue_count) % marker_count)};
    if (number == 14) look.marker = ChartMarker::triangle_down;  // to some eyes near to 3, whose marker it would have
    return look;
}

/// Of a variant: `line` and `marker` count on from any number.
VariantLook look_of_variant(std::size_t method, std::size_t line, std::size_t marker) {
    const std::size_t at = line % line_count;
    return {shades[method % hue_count][at / dashes.size()], dashes[at % dashes.size()],
            static_cast<ChartMarker>(marker % marker_count)};
}

std::uint64_t hash_of(std::string_view text) {
    Hash hash;
    for (const char c : text) hash.add(c);
    return hash.value();
}

/// The ids of both tables, those of 2D first.
std::vector<std::string> ids_of_tables() {
    std::vector<std::string> ids;
    const auto add = [&](const auto& table) {
        for (const auto& method : table)
            if (std::find(ids.begin(), ids.end(), method.id) == ids.end()) ids.emplace_back(method.id);
    };
    add(method_table<2>());
    add(method_table<3>());
    return ids;
}

/// The variant as it is written in one way only: the method's id, then assignments by name. A method of somebody
/// else's table keeps its words.
template <int D>
bool write_canonically(VariantText& variant) {
    for (const Method<D>& method : method_table<D>()) {
        if (!method.is_called(variant.id)) continue;
        variant.id = method.id;
        for (auto& [name, value] : variant.assignments)
            if (const ParameterRow* row = method.parameter(name)) value = row->read(*row, value);
        return true;
    }
    return false;
}
VariantText canonical(const std::string& text) {
    VariantText variant;
    try {
        variant = read_variant(text);
        if (!write_canonically<2>(variant)) write_canonically<3>(variant);
    } catch (const InputError&) {
        return {text, {}};  // from somebody else's results: a name like any other
    }
    std::stable_sort(variant.assignments.begin(), variant.assignments.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    return variant;
}

}  // namespace

bool VariantLook::same_line(const VariantLook& other) const {
    return colour == other.colour && std::equal(dash.begin(), dash.end(), other.dash.begin(), other.dash.end());
}

bool VariantLook::operator==(const VariantLook& other) const {
    return same_line(other) && marker == other.marker && filled == other.filled;
}

std::vector<VariantLook> variant_looks(std::span<const std::string> variants) {
    std::vector<std::string> texts;
    std::map<std::string, VariantText> shown;  // by text, so that the order of the list does not matter
    std::map<std::string, std::size_t> numbers;
    // From 14 on most numbers look like one before them to some eyes; the first six of these do not, and the others are
    // for methods that stand in no chart unless they are asked for.
    constexpr std::size_t first_alike = 14;
    constexpr std::array<std::size_t, 10> apart{19, 21, 16, 17, 22, 14, 15, 18, 20, 23};
    for (const std::string& id : ids_of_tables()) {
        const std::size_t number = numbers.size();
        numbers.emplace(id, number < first_alike                  ? number
                            : number - first_alike < apart.size() ? apart[number - first_alike]
                                                                  : number + apart.size());
    }
    constexpr std::size_t look_count = hue_count * shade_count;
    std::set<std::string> others;
    for (const std::string& variant : variants) {
        VariantText text = canonical(variant);
        texts.push_back(text.text());
        if (!numbers.contains(text.id)) others.insert(text.id);
        shown.emplace(texts.back(), std::move(text));
    }
    std::set<std::size_t> taken;
    for (const std::string& id : others) {
        std::size_t number = hash_of(id) % look_count;
        while (!taken.insert(number).second)
            number = taken.size() < look_count ? (number + 1) % look_count : number + 1;
        numbers.emplace(id, look_count + number);
    }

    std::map<std::string, VariantLook> looks;
    const auto is_taken = [&](const VariantLook& look, bool by_line) {
        return std::any_of(looks.begin(), looks.end(), [&](const auto& other) {
            return by_line ? look.same_line(other.second) : look == other.second;
        });
    };
    for (const auto& [text, variant] : shown) {
        const std::size_t number = numbers.at(variant.id);
        if (variant.assignments.empty()) {
            looks.emplace(text, look_of_method(number));
            continue;
        }
        const std::size_t line = hash_of(text) % line_count, marker = hash_of(text) / line_count;
        VariantLook look = look_of_variant(number, line, marker);
        const auto finds_free = [&](bool by_line) {
            for (std::size_t i = 0; i < (by_line ? 1 : marker_count) * line_count; ++i) {
                look = look_of_variant(number, line + i, marker + i / line_count);
                if (!is_taken(look, by_line)) return true;
            }
            return false;
        };
        if (!finds_free(true)) finds_free(false);
        looks.emplace(text, look);
    }
    std::vector<VariantLook> found;
    for (const std::string& text : texts) found.push_back(looks.at(text));
    return found;
}

std::string hex_colour(const Colour& colour) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.r, colour.g, colour.b);
    return text;
}

}  // namespace sightline
