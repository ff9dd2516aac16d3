// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/label.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/draw/label_place.h"

namespace sightline {

std::optional<PlacedLabel> place_label(const Label& label, const Layout::Panel& panel, const Layout& layout,
                                       const Font& font) {
    const Vec<2> anchor = to_page(panel, layout.scale, label.at);
    const Vec<2> point = anchor + Vec<2>(label.offset_pt.x, -label.offset_pt.y);
    if (!panel.frame.grown(0.5).contains(anchor) || !is_finite<2>(point)) return std::nullopt;
    if (!(label.scale > 0 && label.scale < 1000)) return std::nullopt;
    PlacedLabel placed;
    TextRun& run = placed.run;
    for (const char c : clean_text(label.text)) run.text += c == '\n' ? ' ' : c;
    if (run.text.empty() && !label.disc) return std::nullopt;
    run.size = layout.font_pt * label.scale;
    run.width = text_width(font, run.text) * run.size;
    if (label.disc) placed.radius = std::max(0.72 * run.size, run.width / 2 + 0.25 * run.size);
    const LabelSize size{run.width, 0.6 * run.size, label.halo.a > 0 ? 1 : 0.5, placed.radius};
    const Rect& frame = panel.frame;
    const Box<2> box = label_box(label, point, size, {{frame.x, frame.y}, {frame.right(), frame.bottom()}});
    placed.box = {box.min.x, box.min.y, box.extent().x, box.extent().y};
    placed.centre = box.centre();
    // The end that the alignment fixes stays where it is even if a viewer's font is wider.
    run.align = label.disc ? TextAlign::centre : label.align;
    run.x = placed.centre.x;
    if (run.align != TextAlign::centre) run.x += (run.align == TextAlign::left ? -0.5 : 0.5) * run.width;
    run.baseline = placed.centre.y + font.cap_height * run.size / 2;
    return placed;
}

}  // namespace sightline
