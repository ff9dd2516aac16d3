// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/depth_picture.h"

#include <algorithm>
#include <cmath>

#include "core/draw/palette.h"
#include "core/draw/shown_boxes.h"
#include "core/raster/query.h"
#include "core/run/drawn_levels.h"
#include "core/space/box_tree.h"

namespace sightline {

namespace {

/// As the red of wrong pixels they are not the palette's: the depths are grey.
constexpr Colour nothing_there{22, 30, 66}, seen_there{30, 200, 80}, hidden_there{60, 110, 255},
    tile_border{255, 170, 60};
constexpr int widest_level = 64;

SeenShape shape_of(const Session<3>& session, const Item& item, const ImageSize& size) {
    const View<3>& view = session.problem().view;
    if (item.kind == Kind::primitive) return seen_polygon(view, size, session.scene().primitives[item.id]);
    if (item.kind == Kind::node) return seen_box(view, size, session.traversal().boxes()->nodes[item.id].box);
    return seen_cell(view, size, session.cells(), item.id);
}

/// Roots keep what is far apart: else one near wall leaves all behind it black.
Colour shade(float nearness, float nearest) {
    if (nearness <= 0) return nothing_there;
    const double share = std::sqrt(static_cast<double>(nearness) / static_cast<double>(nearest));
    const auto grey = static_cast<std::uint8_t>(50 + 205 * std::min(share, 1.0));
    return {grey, grey, grey};
}

/// Of each pixel, as it is or as far as the farthest of its block.
std::vector<float> nearness_shown(const DepthImage& image, bool blocks) {
    if (!blocks) return image.nearness;
    const DepthPyramid pyramid(image);
    std::size_t level = 0;
    while (level + 1 < pyramid.levels.size() && pyramid.levels[level].width > widest_level) ++level;
    const int side = DepthPyramid::block << level;
    std::vector<float> shown;
    shown.reserve(image.nearness.size());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) shown.push_back(pyramid.levels[level].at(x / side, y / side));
    return shown;
}

/// Tints leave the depth to be made out.
void tint(const SeenShape& shape, const DepthImage& image, Pixels& pixels) {
    for_covered(shape, image, [&](int x, int y, bool shows) {
        Colour& colour = pixels.colours[image.index(x, y)];
        colour = between({colour, shows ? seen_there : hidden_there}, 0.65);
    });
}

/// The border of each tile, and a shade over those that are not read. How many are read.
std::size_t show_tiles(std::span<const ReadTile> tiles, Pixels& pixels) {
    std::size_t read = 0;
    for (const auto& [tile, is_read] : tiles) {
        read += is_read;
        for (int y = tile.top; y < tile.bottom; ++y)
            for (int x = tile.left; x < tile.right; ++x) {
                Colour& colour = pixels.colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                                                static_cast<std::size_t>(x)];
                if (!is_read) colour = between({colour, nothing_there}, 0.7);
                if (x == tile.left || y == tile.top) colour = between({colour, tile_border}, 0.6);
            }
    }
    return read;
}

}  // namespace

DepthPicture depth_picture(const Session<3>& session, bool blocks) {
    const Run<3>& run = session.traversal().worker();
    const bool small = run.postpones();
    DepthImage image(image_size<3>(small ? run.deciding_size() : session.settings().reference_size));
    std::vector<std::uint32_t> ids;
    drawn_ids(session.traversal(), ids);
    const auto ahead = run.drawn_ahead();
    ids.insert(ids.end(), ahead.begin(), ahead.end());
    draw_depth(image, *drawn_scene(session.traversal(), session.shared_scene()), session.problem().view, ids);
    const float nearest = *std::max_element(image.nearness.begin(), image.nearness.end());
    DepthPicture picture{{image.width, image.height, {}}, {}};
    picture.pixels.colours.reserve(image.nearness.size());
    for (const float nearness : nearness_shown(image, blocks))
        picture.pixels.colours.push_back(shade(nearness, nearest));
    const auto free = static_cast<std::size_t>(std::count(image.ids.begin(), image.ids.end(), none));
    picture.text =
        std::to_string(image.ids.size() - free) + " of " + std::to_string(image.ids.size()) + " pixels covered";
    if (const auto tiles = session.traversal().tiles(); !tiles.empty()) {
        const std::size_t read = show_tiles(tiles, picture.pixels);
        picture.text = std::to_string(read) + " of " + std::to_string(tiles.size()) + " tiles read";
    }
    if (const Item what = marked_item(session)) {
        const SeenShape shape = shape_of(session, what, image.size());
        tint(shape, image, picture.pixels);
        const ShapeSight sight = look_at(shape, image);
        picture.text = item_name(what) + ": " + std::to_string(sight.seen) + " seen, " +
                       std::to_string(sight.pixels - sight.seen) + " hidden";
    }
    if (small) picture.text = "small picture, " + picture.text;
    return picture;
}

}  // namespace sightline
