// Whether all that a figure says can be read: used by the tests of layouts and of figures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "shell/figure/label.h"

namespace sightline::test {

inline Rect box_of(const TextRun& run) {
    return {run.left(), run.baseline - 0.93 * run.size, run.width, (0.93 + 0.24) * run.size};
}

struct Named {
    std::string name;
    Rect box;
};

/// Everything that must keep apart.
inline std::vector<Named> blocks(const Layout& layout) {
    std::vector<Named> all;
    const auto runs = [&](const std::string& name, const std::vector<TextRun>& texts) {
        for (const TextRun& run : texts) all.push_back({name + " \"" + run.text + "\"", box_of(run)});
    };
    for (const Layout::Panel& panel : layout.panels) {
        all.push_back({"panel", panel.frame});
        runs("title", panel.title);
    }
    if (layout.legend_box) return runs("caption", layout.caption), all;
    for (const Layout::Row& row : layout.legend) {
        all.push_back({"swatch", row.swatch});
        runs("legend", row.text);
    }
    if (layout.bar) {
        all.push_back({"bar", layout.bar->strip});
        runs("bar text", layout.bar->text);
    }
    runs("caption", layout.caption);
    return all;
}

inline const Font& figure_font() {
    static const Font font = find_font();
    return font;
}

/// What stands over the panels' pictures keeps apart, too, and inside.
inline void expect_tidy_panel(const Figure::Panel& content, const Layout::Panel& panel, const Layout& layout) {
    const double slack = 0.01;
    const PlacedTexts texts = place_texts(content, panel, layout, figure_font());
    std::vector<Named> all;
    for (const PlacedInset& inset : texts.insets) all.push_back({"inset " + inset.title.text, inset.box});
    if (layout.legend_box && panel.frame.overlaps(*layout.legend_box)) all.push_back({"legend", *layout.legend_box});
    for (const PlacedLabel& placed : texts.labels) {
        const std::string name = "label \"" + content.list.labels[placed.label].text + "\"";
        all.push_back({name, placed.box});
        for (const TextRun& run : placed.runs)
            EXPECT_TRUE(placed.box.contains({run.left(), run.baseline - figure_font().cap_height * run.size, run.width,
                                             figure_font().cap_height * run.size},
                                            slack))
                << name << " leaves its box";
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(panel.frame.contains(all[i].box, slack)) << all[i].name << " leaves its panel";
        for (std::size_t k = i + 1; k < all.size(); ++k)
            EXPECT_FALSE(all[i].box.overlaps(all[k].box, slack)) << all[i].name << " overlaps " << all[k].name;
    }
}

/// Nothing leaves the page, is cut off or overlaps.
inline void expect_tidy(const Figure& figure, const Layout& layout) {
    const Rect page{0, 0, layout.width, layout.height};
    // Line boxes are 1.25 of the size apart, glyph boxes 1.17 high.
    const double slack = 0.01;
    const std::vector<Named> all = blocks(layout);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(page.contains(all[i].box, slack)) << all[i].name << " leaves the page";
        for (std::size_t k = i + 1; k < all.size(); ++k)
            EXPECT_FALSE(all[i].box.overlaps(all[k].box, slack)) << all[i].name << " overlaps " << all[k].name;
    }
    for (const Layout::Panel& panel : layout.panels) {
        EXPECT_GT(panel.frame.w, 0);
        EXPECT_GT(panel.frame.h, 0);
        EXPECT_NEAR(panel.frame.w, panel.world.extent().x * layout.scale, 1e-6 * panel.frame.w);
        EXPECT_NEAR(panel.frame.h, panel.world.extent().y * layout.scale, 1e-6 * panel.frame.h);
    }
    for (std::size_t i = 0; i < layout.panels.size(); ++i)
        expect_tidy_panel(figure.panels[i], layout.panels[i], layout);
    if (!layout.legend_box) return;
    int hosts = 0;
    for (const Layout::Panel& panel : layout.panels) hosts += panel.frame.contains(*layout.legend_box);
    EXPECT_EQ(hosts, 1);
    for (const Layout::Row& row : layout.legend) {
        EXPECT_TRUE(layout.legend_box->contains(row.box));
        for (const TextRun& run : row.text) EXPECT_TRUE(layout.legend_box->contains(box_of(run)));
    }
    if (layout.bar) {
        EXPECT_TRUE(layout.legend_box->contains(layout.bar->box));
    }
}

}  // namespace sightline::test
