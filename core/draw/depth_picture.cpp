// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/depth_picture.h"

#include <algorithm>
#include <cmath>

#include "core/draw/palette.h"
#include "core/draw/shown_boxes.h"
#include "core/raster/query.h"

namespace sightline {

namespace {

/// As the red of wrong pixels they are not the palette's: the depths are grey.
constexpr Colour nothing_there{22, 30, 66}, seen_there{30, 200, 80}, hidden_there{60, 110, 255};
constexpr int widest_level = 64;

struct MarkedShape {
    SeenShape shape;
    std::string name;
};

std::optional<MarkedShape> marked_shape(const Session<3>& session, const ImageSize& size) {
    const View<3>& view = session.problem().view;
    if (const std::uint32_t one = session.selected_primitive; one != none && session.selected_cell == none)
        return MarkedShape{seen_polygon(view, size, session.scene().primitives[one]), item_name(primitive_item(one))};
    if (const auto box = last_box(session); box && session.selected_cell == none)
        return MarkedShape{seen_box(view, size, *box),
                           item_name(session.timeline().steps[session.position() - 1].item)};
    const std::uint32_t cell = session.selected_cell != none ? session.selected_cell : last_cell(session);
    if (cell == none) return {};
    return MarkedShape{seen_cell(view, size, session.cells(), cell), item_name(cell_item(cell))};
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
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::size_t at = image.index(x, y);
            bool covers = shape.everywhere, shows = shape.everywhere;
            for (const SeenFace& face : shape.faces)
                if (face.holds(x, y)) {
                    covers = true;
                    shows |= face.nearness(x, y) >= static_cast<double>(image.nearness[at]);
                }
            if (!covers) continue;
            pixels.colours[at] = between({pixels.colours[at], shows ? seen_there : hidden_there}, 0.65);
        }
}

}  // namespace

DepthPicture depth_picture(const Session<3>& session, bool blocks) {
    DepthImage image(image_size<3>(session.settings().reference_size));
    draw_depth(image, session.scene(), session.problem().view, rendered_ids(session.met()));
    const float nearest = *std::max_element(image.nearness.begin(), image.nearness.end());
    DepthPicture picture{{image.width, image.height, {}}, {}};
    picture.pixels.colours.reserve(image.nearness.size());
    for (const float nearness : nearness_shown(image, blocks))
        picture.pixels.colours.push_back(shade(nearness, nearest));
    const auto free = static_cast<std::size_t>(std::count(image.ids.begin(), image.ids.end(), none));
    picture.text =
        std::to_string(image.ids.size() - free) + " of " + std::to_string(image.ids.size()) + " pixels covered";
    if (const auto what = marked_shape(session, image.size())) {
        tint(what->shape, image, picture.pixels);
        const ShapeSight sight = look_at(what->shape, image);
        picture.text = what->name + ": " + std::to_string(sight.seen) + " seen, " +
                       std::to_string(sight.pixels - sight.seen) + " hidden";
    }
    return picture;
}

}  // namespace sightline
