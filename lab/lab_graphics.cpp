// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/lab_graphics.h"

#include <optional>

#include "core/settings/settings_table.h"
#include "shell/gl/context.h"
#include "shell/gl/id_renderer.h"
#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"

namespace sightline::lab {

struct LabGraphics::Made {
    GlContext context{GlContext::Place::off_screen, "sightline lab", 64, 64};
    IdRenderer ids;
    SolidRenderer solids;
    std::optional<GlTarget> target;
    std::shared_ptr<const Scene<3>> scene;
};

LabGraphics::LabGraphics() = default;
LabGraphics::~LabGraphics() = default;

LabGraphics::Made& LabGraphics::made() {
    if (!made_) made_ = std::make_unique<Made>();
    return *made_;
}

DrawIds LabGraphics::draw_ids() {
    return [this](const Scene<3>& scene, const View<3>& view, const ImageSize& size, int layers) {
        return made().ids.draw(scene, view, size, layers);
    };
}

DrawSolid LabGraphics::draw_solid() {
    return [this](const SolidList& list, int width, int height, double px_per_pt) {
        Made& gl = made();
        gl.scene.reset();  // time_drawing starts anew
        return gl.solids.picture(list, width, height, px_per_pt);
    };
}

TimeDrawing LabGraphics::time_drawing(const ImageSize& asked) {
    return [this, size = image_size<3>(asked)](const std::shared_ptr<const Scene<3>>& scene, const View<3>& view,
                                               std::span<const std::uint32_t> triangles, std::uint32_t repeats) {
        Made& gl = made();
        if (!gl.target || gl.target->width() != size.width || gl.target->height() != size.height)
            gl.target.emplace(size.width, size.height, 1, true);
        if (gl.scene != scene) {
            SolidList list;
            list.styles = {{"rendered", {190, 190, 195}}};
            list.scene = gl.scene = scene;
            gl.solids.set(list);
        }
        const SolidList::Run one{0, 0, static_cast<std::uint32_t>(triangles.size())};
        std::vector<double> uploads, draws;
        for (std::uint32_t i = 0; i <= repeats; ++i) {
            const Stopwatch upload;
            gl.solids.set_triangles({&one, 1}, triangles);
            glFinish();
            const double uploaded = upload.milliseconds();
            const Stopwatch draw;
            gl.target->bind();
            gl.solids.draw(view, 0, 0, size.width, size.height, 4.0 / 3);
            gl.target->resolve();
            glFinish();
            if (i == 0) continue;
            uploads.push_back(uploaded);
            draws.push_back(draw.milliseconds());
        }
        return DrawTimes{median(std::move(uploads)), median(std::move(draws))};
    };
}

std::string LabGraphics::description() const { return made_ ? made_->context.description() : std::string(); }

}  // namespace sightline::lab
