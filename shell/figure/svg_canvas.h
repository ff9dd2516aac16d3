// An SVG that stays small and keeps its text: a class for each pen, <text> elements, the font's used part embedded.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>

#include "shell/figure/canvas.h"
#include "shell/figure/font.h"

namespace sightline {

class SvgCanvas final : public Canvas {
public:
    /// Embedded images have `dpi` pixels to the inch.
    SvgCanvas(double dpi, const Font& font) : font_(font), dpi_(dpi) {}

    void clip(const Rect& rect) override;
    void unclip() override;
    void draw(const Path& path, const Pen& pen) override;
    void circle(const Vec<2>& centre, double radius, const Pen& pen) override;
    void gradient(const Rect& rect, std::span<const Colour> stops) override;
    void image(const Rect& rect, const DrawImage& draw) override;
    void text(const TextRun& run, const Colour& colour, const Colour& halo) override;

    /// The whole document. `width` and `height` are written as they are ("84mm", "1280"); the view box is in points.
    std::string document(const std::string& width, const std::string& height, double width_pt, double height_pt);

private:
    std::string class_of(const std::string& declarations);
    void end_path();

    const Font& font_;
    double dpi_;
    bool has_image_ = false;
    std::string body_, defs_;
    std::set<std::string> defined_;  ///< ids in defs_
    std::set<char32_t> used_;
    std::map<std::string, std::string> classes_;  ///< CSS declarations -> class
    std::string path_class_;                      ///< of the path that the next run may join; empty when there is none
    std::size_t path_begin_ = 0;                  ///< where it begins in body_
};

}  // namespace sightline
