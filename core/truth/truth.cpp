// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/truth.h"

#include <algorithm>
#include <mutex>

#include "core/raster/pixel_line.h"
#include "core/truth/hiding.h"
#include "core/truth/item_buffer.h"
#include "core/truth/software_ids.h"

namespace sightline {

namespace {

std::vector<IdImage> draw_images(const Scene<3>& scene, const View<3>& view, const ImageSize& size,
                                 const DrawIds& draw_ids, int layers) {
    return drawing_of(ReferenceBy::opengl, draw_ids)(scene, view, image_size<3>(size), layers);
}

}  // namespace

std::vector<std::uint32_t> pixels_of(const IdImage& image, std::size_t primitive_count) {
    std::vector<std::uint32_t> pixels(primitive_count);
    for (const std::uint32_t id : image.ids)
        if (id != none) ++pixels[id];
    return pixels;
}

IdImage item_row(const Scene<2>& scene, const View<2>& view, const ImageSize& size) {
    const int width = pixels_of_line(view, image_size<2>(size).width);
    return {width, 1, item_buffer(scene.primitives, view, width).ids};
}

template <>
std::vector<std::uint8_t> visible_set<2>(const Scene<2>& scene, const View<2>& view, const ImageSize&, const DrawIds&) {
    return exact_visible_set(scene.primitives, view).visible;
}

template <>
std::vector<std::uint8_t> visible_set<3>(const Scene<3>& scene, const View<3>& view, const ImageSize& size,
                                         const DrawIds& draw_ids) {
    std::vector<std::uint8_t> visible(scene.primitives.size());
    const std::vector<IdImage> images = draw_images(scene, view, size, draw_ids, 1);
    for (const std::uint32_t id : images.front().ids)
        if (id != none) visible[id] = 1;
    return visible;
}

template <int D>
Services exact_services(const Scene<D>& scene, const View<D>& view, const ImageSize& size, const DrawIds& draw_ids) {
    struct Kept {
        std::once_flag once;
        std::vector<std::uint8_t> visible;
    };
    const auto kept = std::make_shared<Kept>();
    return {[&scene, view, size, draw_ids, kept] {
                std::call_once(kept->once, [&] { kept->visible = visible_set<D>(scene, view, size, draw_ids); });
                return std::shared_ptr<const std::vector<std::uint8_t>>(kept, &kept->visible);
            },
            size};
}
template Services exact_services<2>(const Scene<2>&, const View<2>&, const ImageSize&, const DrawIds&);
template Services exact_services<3>(const Scene<3>&, const View<3>&, const ImageSize&, const DrawIds&);

Services known_services(std::shared_ptr<const std::vector<std::uint8_t>> visible, const ImageSize& size) {
    return {[visible = std::move(visible)] { return visible; }, size};
}

template <>
Reference make_reference<2>(const Scene<2>& scene, const CellComplex<2>& cells, const View<2>& view,
                            const ImageSize& size, const DrawIds&) {
    Reference reference = exact_reference(scene.primitives, cells, view);
    reference.image = item_row(scene, view, size);
    reference.pixels = pixels_of(reference.image, scene.primitives.size());
    return reference;
}

template <>
Reference make_reference<3>(const Scene<3>& scene, const CellComplex<3>& cells, const View<3>& view,
                            const ImageSize& size, const DrawIds& draw_ids) {
    return image_reference(std::move(draw_images(scene, view, size, draw_ids, 1).front()), scene, cells, view);
}

template <>
std::vector<std::uint32_t> make_layering<2>(const Scene<2>& scene, const View<2>& view, const ImageSize&,
                                            const DrawIds&) {
    return layering_numbers(scene.primitives, view);
}

template <>
std::vector<std::uint32_t> make_layering<3>(const Scene<3>& scene, const View<3>& view, const ImageSize& size,
                                            const DrawIds& draw_ids) {
    return layering_numbers(draw_images(scene, view, size, draw_ids, most_layers), scene.primitives.size());
}

template <>
std::vector<Truth> make_truths<2>(const Scene<2>& scene, std::span<const CellComplex<2>* const> tessellations,
                                  const View<2>& view, const ImageSize& size, const DrawIds& draw_ids, bool with_zeta) {
    auto zeta = std::make_shared<std::vector<std::uint32_t>>(scene.primitives.size());
    double fused = std::numeric_limits<double>::quiet_NaN();
    if (with_zeta) {
        *zeta = make_layering(scene, view, size, draw_ids);
        fused = fused_share(hiding(scene.primitives, view, *zeta));
    }
    std::vector<Truth> truths;
    for (const CellComplex<2>* cells : tessellations)
        truths.push_back({make_reference(scene, *cells, view, size, draw_ids), zeta, fused});
    return truths;
}

template <>
std::vector<Truth> make_truths<3>(const Scene<3>& scene, std::span<const CellComplex<3>* const> tessellations,
                                  const View<3>& view, const ImageSize& size, const DrawIds& draw_ids, bool with_zeta) {
    const std::vector<IdImage> layers = draw_images(scene, view, size, draw_ids, with_zeta ? most_layers : 1);
    auto zeta = std::make_shared<std::vector<std::uint32_t>>(scene.primitives.size());
    double fused = std::numeric_limits<double>::quiet_NaN();
    if (with_zeta) {
        *zeta = layering_numbers(layers, scene.primitives.size());
        fused = fused_share(hiding(layers, scene.primitives.size()));
    }
    std::vector<Truth> truths;
    for (const CellComplex<3>* cells : tessellations)
        truths.push_back({image_reference(layers.front(), scene, *cells, view), zeta, fused});
    return truths;
}

}  // namespace sightline
