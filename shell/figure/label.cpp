// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/label.h"

#include <algorithm>

#include "core/base/text.h"

namespace sightline {

namespace {

double kept_inside(double low, double extent, double frame_low, double frame_extent) {
    if (extent > frame_extent) return frame_low + (frame_extent - extent) / 2;
    return std::clamp(low, frame_low, frame_low + frame_extent - extent);
}

}  // namespace

std::optional<PlacedLabel> place_label(const Label& label, const Layout::Panel& panel, const Layout& layout,
                                       const Font& font) {
    const Vec<2> anchor = to_page(panel, layout.scale, label.at);
    Vec<2> centre = anchor + Vec<2>(label.offset_pt.x, -label.offset_pt.y);
    if (!panel.frame.grown(0.5).contains(anchor) || !is_finite<2>(centre)) return std::nullopt;
    if (!(label.scale > 0 && label.scale < 1000)) return std::nullopt;
    PlacedLabel placed;
    TextRun& run = placed.run;
    for (const char c : clean_text(label.text)) run.text += c == '\n' ? ' ' : c;
    if (run.text.empty() && !label.disc) return std::nullopt;
    run.size = layout.font_pt * label.scale;
    run.width = text_width(font, run.text) * run.size;
    if (label.disc) placed.radius = std::max(0.72 * run.size, run.width / 2 + 0.25 * run.size);
    if (label.align == TextAlign::left) centre.x += run.width / 2;
    if (label.align == TextAlign::right) centre.x -= run.width / 2;
    const double margin = label.halo.a > 0 ? 1 : 0.5;
    const Vec<2> half(std::max(run.width / 2 + margin, placed.radius), std::max(0.6 * run.size, placed.radius));
    const Rect& frame = panel.frame;
    placed.box = {kept_inside(centre.x - half.x, 2 * half.x, frame.x, frame.w),
                  kept_inside(centre.y - half.y, 2 * half.y, frame.y, frame.h), 2 * half.x, 2 * half.y};
    placed.centre = {placed.box.x + half.x, placed.box.y + half.y};
    // The end that the alignment fixes stays where it is even if a viewer's font is wider.
    run.align = label.disc ? TextAlign::centre : label.align;
    run.x = placed.centre.x;
    if (run.align != TextAlign::centre) run.x += (run.align == TextAlign::left ? -0.5 : 0.5) * run.width;
    run.baseline = placed.centre.y + font.cap_height * run.size / 2;
    return placed;
}

}  // namespace sightline
