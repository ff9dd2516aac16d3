// The key of a figure: its legend's rows and its colour bar as one block that layout puts somewhere.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "shell/figure/font.h"
#include "shell/figure/page.h"

namespace sightline {

/// A place for text. Every page fills it with its own lines, and it is big enough for the longest.
struct Slot {
    std::vector<std::vector<Line>> pages;
    std::size_t rows = 0;
    double width = 0;  ///< points
};

/// Distance of two baselines, times the font size.
inline constexpr double line_pitch = 1.25;

Slot fit_text(const Font& font, std::span<const std::string> texts, double size, double width);

/// What the key says, cleaned, for each page.
struct KeyTexts {
    std::vector<std::vector<std::string>> rows;  ///< [row][page]
    bool bar = false, swatches = false;          ///< whether there are any
    std::vector<std::string> title, low, high;   ///< [page]

    bool empty() const { return rows.empty() && !bar; }
};

KeyTexts key_texts(std::span<const Figure> pages);

/// Rectangles relative to the block's top left corner.
struct Key {
    struct Row {
        Rect box, swatch;
        Slot text;
    };
    struct Bar {
        Rect box, strip;
        Slot title, low, high;
    };
    double w = 0, h = 0;
    double text_x = 0;  ///< of a row's text from its left end
    std::vector<Row> rows;
    std::optional<Bar> bar;
};

enum class KeyShape : std::uint8_t {
    tall,  ///< as few columns as max_h allows, the bar below
    wide,  ///< as many columns as max_w allows, the bar beside the rows when that is lower
};

/// The block, or nothing when it cannot be made to fit.
std::optional<Key> arrange_key(const Font& font, const KeyTexts& texts, double size, double max_w, double max_h,
                               KeyShape shape);

}  // namespace sightline
