// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/draw_clock.h"

namespace sightline {

DrawTimes DrawClock::time(const ImageSize& size, const std::shared_ptr<const Scene<3>>& scene, const View<3>& view,
                          std::span<const std::uint32_t> triangles) {
    if (!target_ || target_->width() != size.width || target_->height() != size.height)
        target_.emplace(size.width, size.height, 1, true);
    if (scene_ != scene) {
        SolidList list;
        list.styles = {{"rendered", {190, 190, 195}}};
        list.scene = scene_ = scene;
        solids_.set(list);
    }
    const SolidList::Run one{0, 0, static_cast<std::uint32_t>(triangles.size())};
    DrawTimes times;
    glFinish();
    const Stopwatch upload;
    solids_.set_triangles({&one, 1}, triangles);
    glFinish();
    times.upload = upload.milliseconds();
    const Stopwatch draw;
    target_->bind();
    solids_.draw(view, 0, 0, size.width, size.height, 4.0 / 3);
    target_->resolve();
    glFinish();
    times.draw = draw.milliseconds();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return times;
}

}  // namespace sightline
