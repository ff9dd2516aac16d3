// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/inset.h"

#include <algorithm>

#include "core/base/text.h"
#include "shell/figure/key.h"

namespace sightline {

namespace {

/// Of the width of the panel, as in the window.
constexpr double share_of_width = 0.28;

}  // namespace

std::vector<PlacedInset> place_insets(const Figure::Panel& content, const Layout::Panel& panel, const Layout& layout,
                                      const Font& font) {
    std::vector<PlacedInset> placed;
    const Rect& frame = panel.frame;
    const double margin = std::min(0.6 * layout.font_pt, 0.02 * frame.w);
    double stacked = 0;  // heights of all, one wide
    for (const Figure::Inset& inset : content.insets) stacked += 1 / inset.aspect;
    const double room = frame.h - margin * static_cast<double>(content.insets.size() + 1);
    const double w = std::min(share_of_width * frame.w, std::max(0.0, room) / stacked);
    double y = frame.y + margin;
    for (const Figure::Inset& inset : content.insets) {
        PlacedInset& own = placed.emplace_back();
        own.box = {frame.right() - margin - w, y, w, w / inset.aspect};
        TextRun& run = own.title;
        run.text = clean_text(inset.title);
        const double unit_width = text_width(font, run.text), pad = 0.3;  // of the text's size
        run.size = std::min(0.8 * layout.font_pt, w / (unit_width + 2 * pad));
        run.width = unit_width * run.size;
        const double h = line_pitch * run.size;
        own.paper = {own.box.x, own.box.bottom() - h, run.width + 2 * pad * run.size, h};
        run.x = own.box.x + pad * run.size;
        run.baseline = own.paper.y + (h + (font.ascent - font.descent) * run.size) / 2;
        y = own.box.bottom() + margin;
    }
    return placed;
}

}  // namespace sightline
