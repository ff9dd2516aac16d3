// The figure's font: found through fontconfig, measured and subset with HarfBuzz. No hinting, so that a text is as wide
// on the screen as in print.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

struct hb_font_t;

namespace sightline {

struct HbFontDestroy {
    void operator()(hb_font_t* font) const;
};

/// A font file and its vertical measures in em.
struct Font {
    std::string family;
    std::string file;
    int index = 0;  ///< of the face within the file
    double ascent = 0.93, descent = 0.24, cap_height = 0.73;
    std::unique_ptr<hb_font_t, HbFontDestroy> handle;
};

/// Finds an installed font. Throws WorkError that names the package to install when there is none of this family.
Font find_font(const std::string& family = "DejaVu Sans");

struct Glyph {
    std::uint32_t id = 0;
    double x = 0, y = 0;        ///< em, y up
    std::uint32_t text_at = 0;  ///< byte offset of its first character
};

struct ShapedText {
    std::vector<Glyph> glyphs;
    double width = 0;  ///< em
};

/// Glyphs with kerning but no ligatures, left to right. The text must be valid UTF-8.
ShapedText shape(const Font& font, std::string_view text);

/// Width in em.
double text_width(const Font& font, std::string_view text);

/// The code points of valid UTF-8.
std::u32string code_points(std::string_view text);

struct Line {
    std::string text;
    double width = 0;  ///< points
};

/// Breaks cleaned text into lines of at most `width` points: at spaces, at line feeds, and inside words that are too
/// long. A single character wider than `width` stays on a line of its own.
std::vector<Line> wrap_text(const Font& font, std::string_view text, double size, double width);

/// A TrueType file with only these characters, for embedding.
std::string subset_font(const Font& font, const std::set<char32_t>& characters);

}  // namespace sightline
