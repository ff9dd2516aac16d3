// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/drawn_image.h"

#include <algorithm>

#include "core/measure/metrics.h"
#include "core/measure/wrong_region.h"
#include "core/raster/pixel_line.h"
#include "core/run/drawn_levels.h"
#include "core/truth/software_ids.h"

namespace sightline {

namespace {

/// Per pixel the place in `drawn` of what it shows; none: nothing.
std::vector<std::uint32_t> image_of(const Scene<2>& drawn, const View<2>& view, const IdImage& like, const DrawIds&) {
    PixelLine line(view, like.width);
    draw_line(line, drawn.primitives, view);
    return std::move(line.ids);
}
std::vector<std::uint32_t> image_of(const Scene<3>& drawn, const View<3>& view, const IdImage& like,
                                    const DrawIds& draw_ids) {
    const ImageSize size{like.width, like.height};
    auto images = draw_ids ? draw_ids(drawn, view, size, 1) : draw_ids_in_software(drawn, view, size, 1);
    return std::move(images.front().ids);
}

/// What is drawn, as a scene of its own.
template <int D>
Scene<D> scene_of(const Run<D>& run) {
    const std::shared_ptr<const Scene<D>> all = scene_with_levels(*run.problem().cells, *run.problem().scene);
    std::vector<std::uint32_t> ids;
    drawn_ids(run, ids);
    std::sort(ids.begin(), ids.end());  // of equally near ones the lowest is seen
    Scene<D> drawn;
    drawn.objects.of.resize(ids.size());
    if (!all->two_sided.empty()) drawn.two_sided.resize(ids.size());
    drawn.primitives.resize(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        drawn.primitives[i] = all->primitives[ids[i]];
        copy_facts(*all, ids[i], drawn, i);
    }
    return drawn;
}

}  // namespace

template <int D>
std::vector<std::uint8_t> wrong_mask(const Reference& reference, const Run<D>& run, const DrawIds& draw_ids) {
    const IdImage& exact = reference.image;
    if (run.stand_ins().empty() || exact.ids.empty())
        return wrong_mask(exact, rendered_mask(run.met(), run.problem().primitives().size()));
    const Scene<D> drawn = scene_of(run);
    const std::vector<std::uint32_t> shown = image_of(drawn, run.problem().view, exact, draw_ids);
    const std::vector<std::uint32_t>& object_of = run.levels()->objects.of;
    std::vector<std::uint8_t> wrong(exact.ids.size());
    for (std::size_t pixel = 0; pixel < wrong.size(); ++pixel) {
        const std::uint32_t wanted = exact.ids[pixel] == none ? none : object_of[exact.ids[pixel]];
        wrong[pixel] = wanted != (shown[pixel] == none ? none : drawn.objects.of[shown[pixel]]);
    }
    return wrong;
}

template <int D>
double wrong_pixels(const Reference& reference, const Run<D>& run, const DrawIds& draw_ids) {
    if (run.stand_ins().empty() || reference.image.ids.empty()) return wrong_pixels(reference, run.met());
    const std::vector<std::uint8_t> wrong = wrong_mask(reference, run, draw_ids);
    return static_cast<double>(std::count(wrong.begin(), wrong.end(), 1)) / static_cast<double>(wrong.size());
}

template <int D>
std::size_t visible_found(const Reference& reference, const Run<D>& run) {
    std::size_t count = visible_rendered(reference, run.met());
    for_stood_in(run, [&](std::uint32_t primitive) { count += reference.visible[primitive]; });
    return count;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                       \
    template std::vector<std::uint8_t> wrong_mask<D>(const Reference&, const Run<D>&, const DrawIds&); \
    template double wrong_pixels<D>(const Reference&, const Run<D>&, const DrawIds&);                  \
    template std::size_t visible_found<D>(const Reference&, const Run<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
