// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/thumbnails.h"

#include <exception>
#include <numeric>

#include "core/draw/solid_palette.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"

namespace sightline {

namespace {

constexpr int samples = 4;

/// All of its triangles; those that turn their back are there as well.
SolidList whole_scene(const std::string& name, double aspect) {
    const CatalogueRow<3>* const row = find_in_catalogue<3>(name);
    const std::string small = row && row->triangles > 0 ? name + ":" + std::to_string(fewest_triangles) : name;
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

GLuint Thumbnails3d::texture(const SceneChoice& scene, int width, int height) {
    const auto found = made_.find(scene.name);
    const bool there = found != made_.end() &&
                       (!found->second || (found->second->width() == width && found->second->height() == height));
    if (there) return found->second ? found->second->texture() : 0;
    if (made_one_ || width < 1 || height < 1) return 0;
    made_one_ = true;
    std::unique_ptr<GlTarget>& target = made_[scene.name];
    target.reset();
    try {
        const SolidList list = whole_scene(scene.name, static_cast<double>(width) / height);
        if (!renderer_) renderer_ = std::make_unique<SolidRenderer>();
        target = std::make_unique<GlTarget>(width, height, samples, true);
        renderer_->set(list);
        target->bind();
        renderer_->draw(list.camera, 0, 0, width, height, 1);
        target->resolve();
    } catch (const std::exception&) {
        target.reset();
        return 0;  // the chooser shows an empty frame; opening the scene says why
    }
    return target->texture();
}

}  // namespace sightline
