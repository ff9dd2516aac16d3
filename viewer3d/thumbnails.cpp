// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/thumbnails.h"

#include <numeric>

#include "core/draw/solid_palette.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "shell/gl/solid_renderer.h"

namespace sightline {

namespace {

constexpr int samples = 4;

/// All of its triangles; those that turn their back are there as well.
SolidList whole_scene(const std::string& name, double aspect) {
    const CatalogueRow<3>* const row = find_in_catalogue<3>(name);
    const std::string small = row && row->triangles > 0 ? name + ":" + std::to_string(fewest_triangles(*row)) : name;
    const auto scene = std::make_shared<const Scene<3>>(load_scene<3>(small, {}));
    SolidList list;
    list.camera = make_view(scene->start_view.value(), aspect, scene->up_axis);
    list.styles = {solid_styles(Palette::standard)[static_cast<std::size_t>(SolidLook::plain)]};
    list.scene = scene;
    list.triangles.resize(scene->primitives.size());
    std::iota(list.triangles.begin(), list.triangles.end(), 0u);
    list.runs = {{0, 0, static_cast<std::uint32_t>(list.triangles.size())}};
    return list;
}

}  // namespace

Thumbnails::Make thumbnails3d() {
    const auto kept = std::make_shared<std::unique_ptr<SolidRenderer>>();  // made on first use
    return [kept](const std::string& scene, int width, int height) {
        const SolidList list = whole_scene(scene, static_cast<double>(width) / height);
        if (!*kept) *kept = std::make_unique<SolidRenderer>();
        SolidRenderer& renderer = **kept;
        auto target = std::make_unique<GlTarget>(width, height, samples, true);
        renderer.set(list);
        target->bind();
        renderer.draw(list.camera, 0, 0, width, height, 1);
        target->resolve();
        return target;
    };
}

}  // namespace sightline
