// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/depth_strip.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/draw/eye_strip.h"
#include "core/draw/shown_boxes.h"
#include "core/run/drawn_levels.h"
#include "core/space/box_tree.h"

namespace sightline {

namespace {

constexpr int columns = 192, depth_shades = 12;

std::uint16_t add_fill(const char* name, Colour fill, DrawList& list) {
    Style style{name};
    style.fill = fill;
    list.styles.push_back(style);
    return static_cast<std::uint16_t>(list.styles.size() - 1);
}

LineShape line_shape_of(const Session<2>& session, const Item& item, int width) {
    const View<2>& view = session.problem().view;
    if (item.kind == Kind::primitive) return seen_polygon(view, width, session.scene().primitives[item.id]);
    if (item.kind == Kind::node) return seen_box(view, width, session.traversal().boxes()->nodes[item.id].box);
    return seen_cell(view, width, session.cells(), item.id);
}

class Strip {
public:
    Strip(const PixelLine& line, bool under_eye_strip, DrawList& list) : line_(line), list_(list) {
        const Vec<2> extent = list.world.extent();
        low_ = list.world.min.y + 0.012 * extent.y;
        height_ = 0.035 * extent.y;
        left_ = list.world.min.x + 0.02 * extent.x;
        width_ = 0.96 * extent.x;
        top_ = low_ + height_;
        label_left_ = left_ + 0.3 * width_;  // a window keeps its legend in the left corner
        if (!under_eye_strip) return;
        const EyeStripPlace above = eye_strip_place(list.world, true);
        left_ = above.left;
        width_ = above.right - above.left;
        top_ = above.top;
        label_left_ = left_;
    }

    void depths(const Colours& colours) {
        const auto background = add_fill("depth_none", colours.background, list_);
        bar(0, columns, low_, height_, background);
        const auto first = static_cast<std::uint16_t>(list_.styles.size());
        for (int i = 0; i < depth_shades; ++i)
            add_fill("depth", between({colours.background, colours.ink}, (i + 2.0) / (depth_shades + 1)), list_);
        double nearest = 0;
        for (const double nearness : line_.nearness) nearest = std::max(nearest, nearness);
        for (int column = 0; column < columns; ++column) {
            double here = 0;
            for_pixels(column, [&](int x) { here = std::max(here, line_.nearness[static_cast<std::size_t>(x)]); });
            if (here <= 0) continue;
            const auto shade = static_cast<int>(here / nearest * depth_shades);
            bar(column, column + 1, low_, height_,
                static_cast<std::uint16_t>(first + std::min(shade, depth_shades - 1)));
        }
        Style rim{"depth_rim"};
        rim.stroke = colours.ink;
        list_.styles.push_back(rim);
        bar(0, columns, low_, height_, static_cast<std::uint16_t>(list_.styles.size() - 1));
    }

    /// How many pixels of the shape are seen, and how many hidden.
    std::array<int, 2> mark(const LineShape& shape, const Colours& colours) {
        const auto seen = add_fill("depth_seen", colours.looks[static_cast<std::size_t>(Look::last)].stroke, list_),
                   hidden = add_fill("depth_hidden", colours.looks[static_cast<std::size_t>(Look::hidden)].fill, list_);
        std::array<int, 2> pixels{};
        for (int column = 0; column < columns; ++column) {
            bool any = false, any_seen = false;
            for_pixels(column, [&](int x) {
                if (!covers_pixel(shape, x)) return;
                const bool here = shows_pixel(shape, line_, x);
                any = true;
                any_seen |= here;
                ++pixels[here ? 0 : 1];
            });
            if (any) bar(column, column + 1, low_ + height_, 0.35 * height_, any_seen ? seen : hidden);
        }
        return pixels;
    }

    /// A bar under the pixels of each tile that is read.
    void tiles(std::span<const ReadTile> tiles, const Colours& colours) {
        const auto style = add_fill("tile_read", colours.ink, list_);
        const double gap = 0.1 * width_ / static_cast<double>(tiles.size());
        for (const auto& [tile, is_read] : tiles) {
            if (!is_read) continue;
            const double end_x = left_ + width_ * (1 - static_cast<double>(tile.left) / line_.width()) - gap,
                         x = left_ + width_ * (1 - static_cast<double>(tile.right) / line_.width()) + gap,
                         top = low_ - 0.1 * height_, low = low_ - 0.22 * height_;
            list_.add(ShapeKind::polygon, style, {{x, low}, {end_x, low}, {end_x, top}, {x, top}});
        }
    }

    /// Line 0 is the lowest.
    void label(std::string text, int line, const Colours& colours) {
        Label label;
        label.at = {label_left_, top_};
        label.offset_pt = {0, 9.0 + 10 * line};
        label.align = TextAlign::left;
        label.text = std::move(text);
        label.scale = 0.8;
        label.fixed = true;
        label.colour = colours.ink;
        label.halo = colours.halo;
        list_.labels.push_back(std::move(label));
    }

private:
    /// Pixel 0 is at the right border of the view, column 0 at its left.
    template <typename Each>
    void for_pixels(int column, Each each) const {
        const std::int64_t pixels = line_.width();
        const auto end = pixels - pixels * column / columns, begin = pixels - pixels * (column + 1) / columns;
        for (std::int64_t x = begin; x < std::max(end, begin + 1) && x < pixels; ++x) each(static_cast<int>(x));
    }
    void bar(int from, int to, double low, double height, std::uint16_t style) {
        const double x = left_ + width_ * from / columns, end_x = left_ + width_ * to / columns;
        list_.add(ShapeKind::polygon, style, {{x, low}, {end_x, low}, {end_x, low + height}, {x, low + height}});
    }

    const PixelLine& line_;
    DrawList& list_;
    double low_, height_, left_, width_, top_, label_left_;
};

}  // namespace

namespace {

/// What is rendered, and `ahead`, as so many pixels of the view show it.
PixelLine drawn_line(const Session<2>& session, int width, std::span<const std::uint32_t> ahead) {
    const View<2>& view = session.problem().view;
    PixelLine line(view, pixels_of_line(view, width));
    std::vector<std::uint32_t> ids;
    drawn_ids(session.traversal(), ids);
    ids.insert(ids.end(), ahead.begin(), ahead.end());
    const std::shared_ptr<const Scene<2>> drawn = drawn_scene(session.traversal(), session.shared_scene());
    draw_line(line, drawn->primitives, view, ids);
    for (std::uint32_t& id : line.ids)
        if (id != none && id >= session.scene().primitives.size())
            id = session.traversal().levels()->primitives_of(drawn->objects.of[id]).front();
    return line;
}

int width_of_reference(const Session<2>& session) { return image_size<2>(session.settings().reference_size).width; }

}  // namespace

PixelLine line_so_far(const Session<2>& session) { return drawn_line(session, width_of_reference(session), {}); }

PixelLine line_that_decides(const Session<2>& session) {
    const Run<2>& run = session.traversal().worker();
    const int width = run.postpones() ? image_size<2>(run.deciding_size()).width : width_of_reference(session);
    return drawn_line(session, width, run.drawn_ahead());
}

std::string behind_text(std::string_view one, std::span<const std::uint32_t> hidden_by) {
    constexpr std::size_t named = 2;
    return hidden_by.empty() ? std::string() : " behind " + some_of(one, hidden_by, named);
}

void add_depth_strip(const Session<2>& session, const Colours& colours, DrawList& list) {
    const PixelLine line = line_that_decides(session);
    Strip strip(line, session.settings().show_eye == Switch::on, list);
    strip.depths(colours);
    const auto covered = line.width() - std::count(line.ids.begin(), line.ids.end(), none);
    // In two lines: one would be wider than the picture.
    std::string told = (session.traversal().worker().postpones() ? "depths in the small picture: " : "depths: ") +
                       std::to_string(covered) + " of " + std::to_string(line.width()) + " pixels covered";
    if (const auto tiles = session.traversal().tiles(); !tiles.empty()) {
        strip.tiles(tiles, colours);
        const auto read = std::count_if(tiles.begin(), tiles.end(), [](const ReadTile& tile) { return tile.read; });
        told += ", " + std::to_string(read) + " of " + std::to_string(tiles.size()) + " tiles read";
    }
    strip.label(std::move(told), 1, colours);
    if (const Item what = marked_item(session)) {
        const LineShape shape = line_shape_of(session, what, line.width());
        const auto [seen, hidden] = strip.mark(shape, colours);
        strip.label(item_name(what) + ": " + std::to_string(seen) + " seen, " + std::to_string(hidden) + " hidden" +
                        behind_text("segment", look_at(shape, line).hidden_by),
                    0, colours);
    }
}

}  // namespace sightline
