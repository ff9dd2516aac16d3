// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/key.h"

#include <algorithm>

#include "core/base/text.h"

namespace sightline {

namespace {

constexpr double slack = 1e-6;

/// Rows spread evenly over columns, filled column by column.
Key place_rows(std::vector<Key::Row> rows, std::size_t columns, double size, double text_x) {
    const double swatch_w = 2.2 * size, swatch_h = 0.85 * size, column_gap = 1.5 * size;
    const auto first_of = [&](std::size_t c) {
        return c * (rows.size() / columns) + std::min(c, rows.size() % columns);
    };
    std::vector<double> heights(first_of(1), 1.3 * size);
    for (std::size_t c = 0; c < columns; ++c)
        for (std::size_t i = first_of(c); i < first_of(c + 1); ++i) {
            double& h = heights[i - first_of(c)];
            h = std::max(h, static_cast<double>(rows[i].text.rows) * line_pitch * size);
        }
    Key key;
    key.text_x = text_x;
    double x = 0;
    for (std::size_t c = 0; c < columns; ++c) {
        if (c > 0) x += column_gap;
        double column_w = 0, y = 0;
        for (std::size_t i = first_of(c); i < first_of(c + 1); ++i) {
            const double w = text_x + rows[i].text.width, h = heights[i - first_of(c)];
            rows[i].box = {x, y, w, h};
            // Beside the first line of a long text.
            const double line_h = rows[i].text.rows > 1 ? line_pitch * size : h;
            if (text_x > 0) rows[i].swatch = {x, y + (line_h - swatch_h) / 2, swatch_w, swatch_h};
            column_w = std::max(column_w, w);
            y += h + 0.1 * size;
        }
        x += column_w;
        key.h = std::max(key.h, y - 0.1 * size);
    }
    key.w = x;
    key.rows = std::move(rows);
    return key;
}

std::optional<Key> arrange_rows(const Font& font, const KeyTexts& texts, double size, double max_w, double max_h,
                                KeyShape shape) {
    if (texts.rows.empty()) return Key{};
    const double text_x = texts.swatches ? 2.7 * size : 0, text_w = max_w - text_x;
    std::vector<Key::Row> rows;
    for (const auto& text : texts.rows) {
        rows.push_back({{}, {}, fit_text(font, text, size, text_w)});
        if (rows.back().text.width > text_w + slack) return std::nullopt;
    }
    std::optional<Key> best;
    for (std::size_t columns = 1; columns <= std::min<std::size_t>(rows.size(), 100); ++columns) {
        Key key = place_rows(rows, columns, size, text_x);
        if (key.w > max_w + slack) break;
        // Another column that makes it no lower would only make it wider.
        if (key.h <= max_h + slack && (!best || key.h < best->h - slack)) best = std::move(key);
        if (best && shape == KeyShape::tall) break;
    }
    return best;
}

std::optional<Key::Bar> arrange_bar(const Font& font, const KeyTexts& texts, double size, double max_w) {
    Key::Bar bar;
    bar.title = fit_text(font, texts.title, size, std::min(max_w, 18 * size));
    bar.low = fit_text(font, texts.low, size, max_w);
    bar.high = fit_text(font, texts.high, size, max_w);
    const double ends_w = bar.low.width + bar.high.width + (bar.low.rows && bar.high.rows ? size : 0);
    const double w = std::max({std::min(10 * size, max_w), bar.title.width, ends_w});
    if (w > max_w + slack || bar.low.rows > 1 || bar.high.rows > 1) return std::nullopt;
    const double line = line_pitch * size;
    const double title_h = static_cast<double>(bar.title.rows) * line;
    bar.strip = {0, title_h + (title_h > 0 ? 0.15 * size : 0), w, 0.85 * size};
    bar.box = {0, 0, w, bar.strip.bottom() + (bar.low.rows + bar.high.rows > 0 ? 0.1 * size + line : 0)};
    return bar;
}

void move_bar(Key::Bar& bar, double x, double y) {
    for (Rect* r : {&bar.box, &bar.strip}) {
        r->x += x;
        r->y += y;
    }
}

/// Rows and bar one under the other, or side by side.
Key join(Key rows, Key::Bar bar, bool side_by_side, double size) {
    Key key = std::move(rows);
    const bool alone = key.rows.empty();
    if (side_by_side) {
        move_bar(bar, alone ? 0 : key.w + 2 * size, 0);
        key.h = std::max(key.h, bar.box.bottom());
    } else {
        move_bar(bar, 0, alone ? 0 : key.h + 0.7 * size);
        key.h = bar.box.bottom();
    }
    key.w = std::max(key.w, bar.box.right());
    key.bar = std::move(bar);
    return key;
}

}  // namespace

Slot fit_text(const Font& font, std::span<const std::string> texts, double size, double width) {
    Slot slot;
    for (const std::string& text : texts) {
        slot.pages.push_back(wrap_text(font, text, size, width));
        slot.rows = std::max(slot.rows, slot.pages.back().size());
        for (const Line& line : slot.pages.back()) slot.width = std::max(slot.width, line.width);
    }
    return slot;
}

KeyTexts key_texts(std::span<const Figure> pages) {
    KeyTexts texts;
    for (const Figure& page : pages) {
        if (page.legend.size() > texts.rows.size()) texts.rows.resize(page.legend.size());
        texts.bar |= page.bar.has_value();
    }
    for (auto& row : texts.rows) row.resize(pages.size());
    for (auto* slot : {&texts.title, &texts.low, &texts.high}) slot->resize(pages.size());
    for (std::size_t p = 0; p < pages.size(); ++p) {
        for (std::size_t r = 0; r < pages[p].legend.size(); ++r) {
            const Style& style = pages[p].legend[r].style;
            texts.rows[r][p] = clean_text(pages[p].legend[r].text);
            texts.swatches |= style.fill.a > 0 || style.stroke.a > 0 || style.hatch_colour.a > 0;
        }
        if (!pages[p].bar) continue;
        texts.title[p] = clean_text(pages[p].bar->title);
        texts.low[p] = clean_text(pages[p].bar->low);
        texts.high[p] = clean_text(pages[p].bar->high);
    }
    return texts;
}

std::optional<Key> arrange_key(const Font& font, const KeyTexts& texts, double size, double max_w, double max_h,
                               KeyShape shape) {
    std::optional<Key::Bar> bar;
    if (texts.bar) {
        bar = arrange_bar(font, texts, size, max_w);
        if (!bar) return std::nullopt;
    }
    const double bar_w = bar ? bar->box.w + 2 * size : 0, bar_h = bar ? bar->box.h + 0.7 * size : 0;
    const auto arrange = [&](double w, double h) { return arrange_rows(font, texts, size, w, h, shape); };
    std::optional<Key> stacked = arrange(max_w, max_h - bar_h);
    if (!bar) return stacked;
    if (stacked) stacked = join(std::move(*stacked), *bar, false, size);
    if (shape == KeyShape::tall && stacked) return stacked;
    std::optional<Key> beside = arrange(max_w - bar_w, max_h);
    if (beside && bar->box.h <= max_h + slack) {
        beside = join(std::move(*beside), *bar, true, size);
        if (!stacked || beside->h < stacked->h) return beside;
    }
    return stacked;
}

}  // namespace sightline
