// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/fade.h"

#include <utility>

namespace sightline {

void Fade::next(std::optional<GlTarget>& picture, const FadeOf& what, double now) {
    const bool same_place = what.run == shown_.run && what.size == shown_.size;
    const bool steps = same_place && what.position != shown_.position && picture && what.animate;
    if (steps) {
        std::swap(picture, before_);
        started_ = now;
    } else if (!same_place || !what.animate) {
        before_.reset();
    }
    shown_ = what;
}

void Fade::draw(const TextureQuad& quad, const PaneSize& size, double now) const {
    if (!running(now)) return;
    const auto left = static_cast<float>(1 - (now - started_) / seconds);
    quad.draw(before_->texture(), size.x, size.y, size.w, size.h, true, left);
}

}  // namespace sightline
