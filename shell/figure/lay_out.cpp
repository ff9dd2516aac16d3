// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/lay_out.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"
#include "shell/figure/cover.h"
#include "shell/figure/grid.h"

namespace sightline {

namespace {

using Texts = std::vector<std::vector<std::string>>;  ///< [thing][page]

/// What the pages have in common, before anything has a place.
struct Content {
    std::vector<std::vector<Box<2>>> worlds;  ///< [panel][page], finite
    std::vector<Vec<2>> extents;              ///< [panel], the largest of its pages, > 0
    Texts titles;                             ///< [panel][page]
    KeyTexts key;
    std::vector<std::string> captions;  ///< [page]
    LegendPlace place = LegendPlace::outside;
    std::size_t columns = 0;  ///< asked for; 0: free
};

/// Where a key outside the panels stands.
enum class KeySide : std::uint8_t { right, below, slot };  // slot: what the last row of panels leaves

/// The page before its parts are in place; millimetres leave the height open.
struct Page {
    double w = 0, margin = 0;
    std::optional<double> h;
};

Box<2> finite_box(const Box<2>& box) {
    const double limit = 1e300;
    const bool usable = !box.empty() && box.min.y <= box.max.y && is_finite<2>(box.min) && is_finite<2>(box.max);
    if (!usable) return {Vec<2>(0), Vec<2>(1)};
    return {glm::clamp(box.min, Vec<2>(-limit), Vec<2>(limit)), glm::clamp(box.max, Vec<2>(-limit), Vec<2>(limit))};
}

Content collect(std::span<const Figure> pages, std::size_t columns) {
    Content c;
    c.place = pages.front().legend_place;
    c.columns = columns;
    if (c.place != LegendPlace::off) c.key = key_texts(pages);
    std::size_t panels = 0;
    for (const Figure& page : pages) panels = std::max(panels, page.panels.size());
    c.titles.assign(panels, std::vector<std::string>(pages.size()));
    c.worlds.assign(panels, {});
    c.extents.assign(panels, Vec<2>(0));
    for (std::size_t p = 0; p < pages.size(); ++p) {
        c.captions.push_back(clean_text(pages[p].caption));
        for (std::size_t i = 0; i < panels; ++i) {
            if (i >= pages[p].panels.size()) {
                c.worlds[i].push_back({Vec<2>(0), Vec<2>(0)});
                continue;
            }
            c.titles[i][p] = clean_text(pages[p].panels[i].title);
            c.worlds[i].push_back(finite_box(pages[p].panels[i].list.world));
            c.extents[i] = glm::max(c.extents[i], c.worlds[i].back().extent());
        }
    }
    // A world without area, or one too thin to see beside the others, shows more around it.
    double longest = 0;
    for (const Vec<2>& e : c.extents) longest = std::max({longest, e.x, e.y});
    const double least = longest > 1e-290 ? longest / 20 : 1;
    for (Vec<2>& e : c.extents) e = glm::max(e, Vec<2>(least));
    c.columns = std::min(c.columns, panels);
    return c;
}

/// Everything placed relative to the content's top left corner.
struct Draft {
    Grid grid;
    std::optional<Key> key;
    LegendPlace place = LegendPlace::off;
    KeySide side = KeySide::below;
    Slot caption;
    double caption_h = 0, body_w = 0, body_h = 0;
    bool roomy = true;  ///< texts leave the panels a fair share of the page
};

/// The longest side of a panel.
double widest(const Grid& grid) {
    double side = 0;
    for (const Rect& f : grid.frames) side = std::max({side, f.w, f.h});
    return side;
}

/// Panels in a room. On a page of open height the columns are those of a figure wider than tall, if the panels stay
/// readable; then the panels take the width, up to a figure somewhat taller than wide or, for many, a printed page.
std::optional<Grid> panels_in(const Content& c, const Font& font, double size, double w, std::optional<double> h,
                              std::size_t columns) {
    if (w <= 0 || (h && *h <= 0)) return std::nullopt;
    const auto arrange = [&](double height, GridAim aim, std::size_t n) {
        return arrange_panels(font, c.extents, c.titles, size, {w, height}, aim, n);
    };
    if (h) return arrange(*h, GridAim::largest, columns);
    const double readable = 10 * size, tall = 1.25 * w, printed_page = std::max(680.0, tall);
    std::optional<Grid> grid;
    for (const auto& [choose_in, fit_in] :
         {std::pair(0.75 * w, tall), std::pair(tall, tall), std::pair(printed_page, printed_page)}) {
        const auto choice = arrange(choose_in, GridAim::full, columns);
        if (!choice) continue;
        auto fitted = arrange(fit_in, GridAim::full, choice->columns);
        if (fitted && (!grid || widest(*fitted) > widest(*grid) * 1.001)) grid = std::move(fitted);
        if (grid && widest(*grid) >= readable) break;
    }
    return grid;
}

std::optional<Draft> draft(const Content& c, const Font& font, double size, const Page& page, LegendPlace place,
                           KeySide side, std::size_t columns) {
    Draft d;
    d.place = place;
    d.side = side;
    const double inner_w = page.w - 2 * page.margin, gap = size;
    std::optional<double> body_h;
    d.caption = fit_text(font, c.captions, size, inner_w);
    if (d.caption.width > inner_w + 1e-6) return std::nullopt;
    d.caption_h = static_cast<double>(d.caption.rows) * line_pitch * size;
    if (page.h) body_h = *page.h - 2 * page.margin - (d.caption_h > 0 ? d.caption_h + gap : 0);

    double room_w = inner_w;
    std::optional<double> room_h = body_h;
    const bool panels = !c.extents.empty(), right = side == KeySide::right;
    const auto key_in = [&](double w, double h, KeyShape shape) { return arrange_key(font, c.key, size, w, h, shape); };
    if (place == LegendPlace::outside && side != KeySide::slot) {
        const double max_w = right && panels ? 0.4 * inner_w : inner_w;
        d.key = key_in(max_w, body_h.value_or(1e9), right ? KeyShape::tall : KeyShape::wide);
        if (!d.key) return std::nullopt;
        if (right) room_w -= d.key->w + 1.5 * gap;
        if (!right && room_h) *room_h -= d.key->h + gap;
    }
    if (panels) {
        auto grid = panels_in(c, font, size, room_w, room_h, columns);
        if (!grid) return std::nullopt;
        d.grid = std::move(*grid);
        d.roomy = room_w > 0.35 * page.w && (!page.h || *room_h > 0.35 * *page.h);
    }
    d.body_w = d.grid.w;
    d.body_h = d.grid.h;
    if (place == LegendPlace::outside && side == KeySide::slot) {
        if (d.grid.free.w <= 0) return std::nullopt;
        d.key = key_in(d.grid.free.w, body_h ? d.grid.free.h : 1e9, KeyShape::tall);
        if (!d.key) return std::nullopt;
        d.body_h = std::max(d.body_h, d.grid.free.y + d.key->h);
    } else if (d.key && place == LegendPlace::outside) {
        const double between = panels ? (right ? 1.5 : 1) * gap : 0;
        d.body_w = right ? d.body_w + between + d.key->w : std::max(d.body_w, d.key->w);
        d.body_h = right ? std::max(d.body_h, d.key->h) : d.body_h + between + d.key->h;
    }
    if (body_h && d.body_h > *body_h + 1e-6) return std::nullopt;
    return d;
}

/// How much of the page its panels take.
double panel_share(const Draft& d) {
    double area = 0;
    for (const Rect& f : d.grid.frames) area += f.w * f.h;
    return d.body_h > 0 ? area / d.body_h : 0;
}

/// The best place for a key outside panels in so many columns.
std::optional<Draft> draft_outside(const Content& c, const Font& font, double size, const Page& page,
                                   std::size_t columns) {
    const auto beside = [&](KeySide side) { return draft(c, font, size, page, LegendPlace::outside, side, columns); };
    if (c.key.empty()) return draft(c, font, size, page, LegendPlace::off, KeySide::below, columns);
    std::optional<Draft> right = beside(KeySide::right), below = beside(KeySide::below), slot = beside(KeySide::slot);
    std::optional<Draft> best;
    if (!below || !right) {
        best = below ? std::move(below) : std::move(right);
    } else if (right->roomy != below->roomy) {
        best = right->roomy ? std::move(right) : std::move(below);
    } else {
        // With an open height, panels beside the key could only be larger by making the figure taller.
        const bool taller = !page.h && right->body_h > below->body_h;
        best = right->grid.scale >= below->grid.scale * 0.999 && !taller ? std::move(right) : std::move(below);
    }
    if (!slot || (best && best->roomy && !slot->roomy)) return best;
    const auto worth = [&](const Draft& d) { return page.h ? d.grid.scale : panel_share(d); };
    return !best || worth(*slot) > worth(*best) ? std::move(slot) : std::move(best);
}

/// The best draft with texts of this size.
std::optional<Draft> best_draft(const Content& c, const Font& font, double size, const Page& page) {
    const std::size_t panels = c.extents.size();
    if (!c.key.empty() && c.place == LegendPlace::inside && panels > 0) {
        auto d = draft(c, font, size, page, LegendPlace::inside, KeySide::below, c.columns);
        if (d) {
            Vec<2> largest(0);
            for (const Rect& f : d->grid.frames)
                if (f.w * f.h > largest.x * largest.y) largest = {f.w, f.h};
            // Padding included, the box leaves at least a third of its panel free in each direction.
            const Vec<2> room = largest * 0.67 - Vec<2>(2.2 * size);
            d->key = arrange_key(font, c.key, size, room.x, room.y, KeyShape::tall);
            if (d->key) return d;
        }
    }
    std::optional<Draft> best = draft_outside(c, font, size, page, c.columns);
    if (page.h || c.columns > 0 || !best || best->grid.free.w <= 0) return best;
    // Rather than with an empty place, in one row, where that makes better use of the page.
    auto row = draft_outside(c, font, size, page, panels);
    const double readable = 8.5 * size;
    return row && row->roomy && widest(row->grid) >= readable && panel_share(*row) > panel_share(*best) ? row : best;
}

std::vector<TextRun> place_text(const Slot& slot, std::size_t page, const Rect& box, double size, const Font& font,
                                TextAlign align = TextAlign::left) {
    std::vector<TextRun> runs;
    const double x = align == TextAlign::left ? box.x : align == TextAlign::centre ? box.x + box.w / 2 : box.right();
    const double pitch = line_pitch * size;
    // Letters stand in the middle of their line; fewer lines than there is room for stand at the bottom.
    const double first = box.bottom() - static_cast<double>(slot.pages[page].size()) * pitch;
    for (const Line& line : slot.pages[page]) {
        const double top = first + static_cast<double>(runs.size()) * pitch;
        const double baseline = top + (pitch + (font.ascent - font.descent) * size) / 2;
        runs.push_back({line.text, x, baseline, size, line.width, align});
    }
    return runs;
}

Rect moved(const Rect& r, double x, double y) { return {r.x + x, r.y + y, r.w, r.h}; }

void place_key(Layout& out, const Key& key, const Vec<2>& at, const Figure& figure, std::size_t p, const Font& font) {
    const double size = out.font_pt, line = line_pitch * size;
    for (std::size_t i = 0; i < figure.legend.size(); ++i) {
        const Key::Row& row = key.rows[i];
        const Rect box = moved(row.box, at.x, at.y);
        const double text_h = static_cast<double>(row.text.pages[p].size()) * line;
        const Rect text{box.x + key.text_x, box.y + (row.text.rows > 1 ? 0 : (box.h - text_h) / 2), box.w, text_h};
        out.legend.push_back({box, moved(row.swatch, at.x, at.y), place_text(row.text, p, text, size, font)});
    }
    if (!key.bar || !figure.bar) return;
    const Rect box = moved(key.bar->box, at.x, at.y), strip = moved(key.bar->strip, at.x, at.y);
    Layout::Bar bar{box, strip, {}};
    const Rect title{box.x, box.y, box.w, static_cast<double>(key.bar->title.rows) * line};
    const Rect ends{box.x, box.bottom() - line, box.w, line};
    for (const auto& runs :
         {place_text(key.bar->title, p, title, size, font), place_text(key.bar->low, p, ends, size, font),
          place_text(key.bar->high, p, ends, size, font, TextAlign::right)})
        bar.text.insert(bar.text.end(), runs.begin(), runs.end());
    out.bar = std::move(bar);
}

std::vector<Layout> finish(const Content& c, const Draft& d, std::span<const Figure> pages, const Page& page,
                           double size, const Font& font) {
    const double gap = size, total_h = d.body_h + (d.caption_h > 0 ? d.caption_h + (d.body_h > 0 ? gap : 0) : 0);
    Layout common;
    common.width = page.w;
    common.height = page.h.value_or(total_h + 2 * page.margin);
    common.font_pt = size;
    common.scale = d.grid.scale;
    const double left = (page.w - d.body_w) / 2, top = (common.height - total_h) / 2;
    const bool outside = d.key && d.place == LegendPlace::outside, below = outside && d.side == KeySide::below;
    const Vec<2> grid_at(below ? (page.w - d.grid.w) / 2 : left, top);
    common.caption_box = {page.margin, top + total_h - d.caption_h, page.w - 2 * page.margin, d.caption_h};

    std::vector<Layout> layouts(pages.size(), common);
    for (std::size_t p = 0; p < pages.size(); ++p) {
        Layout& out = layouts[p];
        for (std::size_t i = 0; i < pages[p].panels.size(); ++i) {
            const Vec<2> centre = c.worlds[i][p].min * 0.5 + c.worlds[i][p].max * 0.5;
            const Rect frame = moved(d.grid.frames[i], grid_at.x, grid_at.y);
            const Rect title = moved(d.grid.title_boxes[i], grid_at.x, grid_at.y);
            out.panels.push_back({frame,
                                  {centre - c.extents[i] * 0.5, centre + c.extents[i] * 0.5},
                                  d.grid.titles[i].rows > 0 ? title : Rect{},
                                  place_text(d.grid.titles[i], p, title, size, font)});
        }
        const bool short_caption = d.caption.rows == 1;
        out.caption =
            place_text(d.caption, p, out.caption_box, size, font, short_caption ? TextAlign::centre : TextAlign::left);
    }
    if (!d.key) return layouts;
    Vec<2> key_at(left + (d.grid.w > 0 ? d.grid.w + 1.5 * gap : 0), top);
    // Beside panels the key begins where their frames do.
    if (outside && d.side == KeySide::right && !d.grid.frames.empty())
        key_at.y += std::min(d.grid.frames[0].y, d.body_h - d.key->h);
    if (below) key_at = {(page.w - d.key->w) / 2, top + d.body_h - d.key->h};
    if (outside && d.side == KeySide::slot) key_at = grid_at + Vec<2>(d.grid.free.x, d.grid.free.y);
    if (d.place == LegendPlace::inside) {
        const double pad = 0.5 * size;
        const Rect box = emptiest_corner(pages, layouts, font, d.key->w + 2 * pad, d.key->h + 2 * pad, 0.6 * size);
        for (Layout& out : layouts) out.legend_box = box;
        key_at = {box.x + pad, box.y + pad};
    }
    for (std::size_t p = 0; p < pages.size(); ++p) place_key(layouts[p], *d.key, key_at, pages[p], p, font);
    return layouts;
}

std::string number(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

void check_size(const FigureSize& size) {
    const auto in = [](double value, double low, double high) { return value >= low && value <= high; };
    const bool pixels = size.width_px != 0 || size.height_px != 0;
    if (pixels && !(in(size.width_px, 1, 20000) && in(size.height_px, 1, 20000)))
        throw InputError("figure size " + std::to_string(size.width_px) + "x" + std::to_string(size.height_px) +
                         " px: each side must be between 1 and 20000 px");
    if (!pixels && !in(size.width_mm, 1, 2000))
        throw InputError("figure width " + number(size.width_mm) + " mm: must be between 1 and 2000 mm");
    if (!in(size.font_pt, 1, 200))
        throw InputError("font size " + number(size.font_pt) + " pt: must be between 1 and 200 pt");
    if (!pixels && !in(size.dpi, 10, 4800))
        throw InputError("resolution " + number(size.dpi) + " dpi: must be between 10 and 4800 dpi");
}

std::vector<Layout> lay_out(std::span<const Figure> pages, const FigureSize& size, const Font& font) {
    check_size(size);
    if (pages.empty()) return {};
    const Content content = collect(pages, size.columns);
    const bool pixels = size.width_px > 0;
    Page page;
    page.w = pixels ? size.width_px * 0.75 : size.width_mm * 72 / 25.4;
    // In print the figure's width is the column's: only strokes need a margin.
    page.margin = pixels ? std::min({size.font_pt, 0.03 * page.w, 0.03 * size.height_px * 0.75}) : 1;
    page.margin = std::min(page.margin, 0.03 * page.w);
    if (pixels) page.h = size.height_px * 0.75;

    std::optional<Draft> best;
    double best_size = size.font_pt;
    for (const double shrink : {1.0, 0.85, 0.7, 0.6, 0.5}) {
        auto d = best_draft(content, font, size.font_pt * shrink, page);
        if (!d) continue;
        best = std::move(d);
        best_size = size.font_pt * shrink;
        if (best->roomy) break;
    }
    if (!best) {
        const std::string what = pixels ? std::to_string(size.width_px) + "x" + std::to_string(size.height_px) + " px"
                                        : number(size.width_mm) + " mm";
        throw InputError("the figure's texts and panels do not fit into " + what + " at " + number(size.font_pt) +
                         " pt: ask for a larger size or a smaller font");
    }
    return finish(content, *best, pages, page, best_size, font);
}

}  // namespace sightline
