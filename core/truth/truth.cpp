// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/truth.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/settings/settings_table.h"
#include "core/truth/item_buffer.h"

namespace sightline {

template <>
std::vector<Truth> make_truths<2>(const Scene<2>& scene, std::span<const CellComplex<2>* const> tessellations,
                                  const View<2>& view, const ImageSize& size, const DrawIds&, bool with_zeta) {
    // An all-round view has four image lines of equal width.
    int width = image_size<2>(size).width;
    if (view.all_round) width = std::max(4, width / 4 * 4);
    const IdImage image{width, 1, item_buffer(scene.primitives, view, width).ids};
    std::vector<std::uint32_t> pixels(scene.primitives.size());
    for (const std::uint32_t id : image.ids)
        if (id != no_primitive) ++pixels[id];
    auto zeta = std::make_shared<std::vector<std::uint32_t>>(scene.primitives.size());
    if (with_zeta) *zeta = layering_numbers(scene.primitives, view);
    std::vector<Truth> truths;
    for (const CellComplex<2>* cells : tessellations) {
        truths.push_back({exact_reference(scene.primitives, *cells, view), zeta});
        truths.back().reference.image = image;
        truths.back().reference.pixels = pixels;
    }
    return truths;
}

template <>
std::vector<Truth> make_truths<3>(const Scene<3>& scene, std::span<const CellComplex<3>* const> tessellations,
                                  const View<3>& view, const ImageSize& size, const DrawIds& draw_ids, bool with_zeta) {
    if (!draw_ids) throw WorkError("the exact image cannot be drawn: there is no OpenGL");
    const std::vector<IdImage> layers = draw_ids(scene, view, image_size<3>(size), with_zeta ? most_layers : 1);
    auto zeta = std::make_shared<std::vector<std::uint32_t>>(scene.primitives.size());
    if (with_zeta) *zeta = layering_numbers(layers, scene.primitives.size());
    std::vector<Truth> truths;
    for (const CellComplex<3>* cells : tessellations)
        truths.push_back({image_reference(layers.front(), scene, *cells, view), zeta});
    return truths;
}

}  // namespace sightline
