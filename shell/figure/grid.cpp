// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sightline {

namespace {

/// Extents and titles of a grid with a given number of columns.
struct Table {
    std::size_t columns = 1, rows = 1;
    std::vector<double> column_w, row_h;  ///< scene units
    std::vector<double> title_w;          ///< per column: the longest title on one line, points
};

Table make_table(std::span<const Vec<2>> extents, std::span<const double> title_w, std::size_t columns) {
    Table t;
    t.columns = columns;
    t.rows = (extents.size() + columns - 1) / columns;
    t.column_w.assign(t.columns, 0);
    t.title_w.assign(t.columns, 0);
    t.row_h.assign(t.rows, 0);
    for (std::size_t i = 0; i < extents.size(); ++i) {
        const std::size_t c = i % columns, r = i / columns;
        t.column_w[c] = std::max(t.column_w[c], extents[i].x);
        t.row_h[r] = std::max(t.row_h[r], extents[i].y);
        t.title_w[c] = std::max(t.title_w[c], title_w[i]);
    }
    return t;
}

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

double scale_of(const Table& t, const Vec<2>& room, double gap, double titles_h) {
    const double w = room.x - gap * static_cast<double>(t.columns - 1);
    const double h = room.y - gap * static_cast<double>(t.rows - 1) - titles_h;
    return std::min(w / sum(t.column_w), h / sum(t.row_h));
}

/// Column widths in points: a column may be wider than its panels when its titles need it and there is room.
std::vector<double> cell_widths(const Table& t, double scale, double room_w, double gap) {
    const double used = scale * sum(t.column_w) + gap * static_cast<double>(t.columns - 1);
    const double spare = std::max(0.0, room_w - used) / static_cast<double>(t.columns);
    std::vector<double> widths;
    for (std::size_t c = 0; c < t.columns; ++c) {
        const double w = scale * t.column_w[c];
        widths.push_back(w + std::clamp(t.title_w[c] - w, 0.0, spare));
    }
    return widths;
}

Grid place(const Table& t, std::span<const Vec<2>> extents, double scale, double gap, double size,
           const std::vector<double>& cells, const std::vector<std::size_t>& title_rows, std::vector<Slot> titles) {
    Grid grid;
    grid.scale = scale;
    grid.columns = t.columns;
    grid.w = sum(cells) + gap * static_cast<double>(t.columns - 1);
    double y = 0;
    for (std::size_t r = 0; r < t.rows; ++r) {
        const double title_h = static_cast<double>(title_rows[r]) * line_pitch * size;
        const double top = y + title_h + (title_h > 0 ? 0.2 * size : 0);
        double x = 0;
        for (std::size_t c = 0; c < t.columns && r * t.columns + c < extents.size(); ++c) {
            const std::size_t i = r * t.columns + c;
            grid.frames.push_back({x, top, extents[i].x * scale, extents[i].y * scale});
            // Titles stand on the frame, so that a short one beside a long one keeps to its panel.
            const double h = static_cast<double>(titles[i].rows) * line_pitch * size;
            grid.title_boxes.push_back(h > 0 ? Rect{x, y + title_h - h, cells[c], h} : Rect{});
            x += cells[c] + gap;
        }
        if (r + 1 == t.rows && extents.size() < t.columns * t.rows)
            grid.free = {x, top, grid.w - x, t.row_h[r] * scale};
        y = top + t.row_h[r] * scale + gap;
    }
    grid.h = y - gap;
    grid.titles = std::move(titles);
    return grid;
}

}  // namespace

std::optional<Grid> arrange_panels(const Font& font, std::span<const Vec<2>> extents,
                                   std::span<const std::vector<std::string>> titles, double size, const Vec<2>& room,
                                   GridAim aim, std::size_t forced) {
    if (extents.empty()) return Grid{};
    const double gap = 1.2 * size, title_gap = 0.2 * size;
    std::vector<double> title_w;
    for (const auto& title : titles) title_w.push_back(fit_text(font, title, size, 1e9).width * 1.0001);

    std::optional<Grid> best;
    double best_score = 0;
    for (std::size_t columns = std::min<std::size_t>(extents.size(), 64); columns > 0; --columns) {
        if (forced != 0 && columns != forced) continue;
        const Table t = make_table(extents, title_w, columns);
        // Between equals, fewer rows: the later one must be clearly larger.
        const double worth =
            aim == GridAim::largest ? 1 : static_cast<double>(extents.size()) / static_cast<double>(t.columns * t.rows);
        std::vector<std::size_t> title_rows(t.rows, 0);
        for (;;) {
            double titles_h = 0;
            for (const std::size_t n : title_rows)
                if (n > 0) titles_h += static_cast<double>(n) * line_pitch * size + title_gap;
            const double scale = scale_of(t, room, gap, titles_h);
            if (!(scale * worth > best_score * 1.001)) break;
            const std::vector<double> cells = cell_widths(t, scale, room.x, gap);
            std::vector<Slot> slots;
            bool stable = true, fits = true;
            for (std::size_t i = 0; i < extents.size(); ++i) {
                slots.push_back(fit_text(font, titles[i], size, cells[i % columns]));
                fits &= slots[i].width <= cells[i % columns] + 1e-6;
                std::size_t& rows = title_rows[i / columns];
                stable &= slots[i].rows <= rows;
                rows = std::max(rows, slots[i].rows);
            }
            if (!fits) break;
            if (!stable) continue;
            best = place(t, extents, scale, gap, size, cells, title_rows, std::move(slots));
            best_score = scale * worth;
            break;
        }
    }
    return best;
}

}  // namespace sightline
