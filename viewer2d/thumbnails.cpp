// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/thumbnails.h"

#include "core/base/file.h"
#include "core/draw/palette.h"
#include "core/draw/picture.h"
#include "core/draw/shown_world.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/session/state_file.h"
#include "shell/desk/open_scene.h"
#include "shell/gl/list_renderer.h"

namespace sightline {

namespace {

constexpr int samples = 4;

DrawList finished_run(const CatalogueRow<2>& row, double aspect) {
    Settings settings = start_settings<2>(row.id);
    settings.show_tessellation = Switch::off;
    Session<2> session(std::make_shared<const Scene<2>>(make_scene(row)), row.view, settings);
    session.run();
    PictureOptions options;
    options.aspect = aspect;
    return make_picture(session, options);
}

/// What a state file shows.
DrawList picture_of_state(const std::string& file, double aspect) {
    const OpenedState opened = open_state(read_file(file), file);
    PictureOptions options;
    options.aspect = aspect;
    return make_picture(opened.session, options);
}

DrawList segments_alone(const Scene<2>& scene, double aspect) {
    DrawList list;
    list.world = widened(bounds<2>(scene.primitives), aspect);
    list.styles = colours(Palette::standard).looks;
    for (const Primitive<2>& segment : scene.primitives)
        list.add(ShapeKind::polyline, static_cast<std::uint16_t>(Look::other), {segment[0], segment[1]});
    return list;
}

}  // namespace

Thumbnails::Make thumbnails2d() {
    return [renderer = std::make_shared<ListRenderer>()](const std::string& scene, int width, int height) {
        const double aspect = static_cast<double>(width) / height;
        const CatalogueRow<2>* const row = find_in_catalogue(scene);
        const DrawList list = row                        ? finished_run(*row, aspect)
                              : scene.ends_with(".json") ? picture_of_state(scene, aspect)
                                                         : segments_alone(load_scene(scene), aspect);
        auto target = std::make_unique<GlTarget>(width, height, samples);
        target->bind();
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        renderer->set(list);
        // Thinner than in a picture of full size.
        renderer->draw({list.world, 0, 0, width, height, 0.7, 1});
        target->resolve();
        return target;
    };
}

}  // namespace sightline
