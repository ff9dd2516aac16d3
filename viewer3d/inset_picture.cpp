// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/inset_picture.h"

#include <algorithm>
#include <cmath>

#include "core/draw/insets.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Of the rendered image, in pixels.
constexpr int image_width = 480;

}  // namespace

void InsetPicture::update(const Session<3>& session, std::uint64_t revision) {
    if (revision == revision_) return;
    revision_ = revision;
    shown_.clear();
    for (const Figure::Inset& inset : make_insets(session)) {
        shown_.push_back({inset.title, static_cast<float>(inset.aspect), inset.solid != nullptr});
        if (inset.solid) {
            const int height = std::max(1, static_cast<int>(image_width / inset.aspect));
            if (!image_ || image_->height() != height) image_.emplace(image_width, height, 1, true);
            renderer_.set(*inset.solid);
            image_->bind();
            renderer_.draw(inset.solid->camera, 0, 0, image_width, height, 1);
            image_->resolve();
        } else {
            const Pixels& pixels = *inset.pixels;
            glBindTexture(GL_TEXTURE_2D, pixels_.name());
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         pixels.colours.data());
            glBindTexture(GL_TEXTURE_2D, 0);
        }
    }
}

void InsetPicture::draw(ImDrawList& list, const Ui& ui, const Area& area) const {
    const float w = std::min(area.w * 0.28f, 320 * ui.unit), margin = 10 * ui.unit;
    float y = area.y + margin;
    for (const Shown& shown : shown_) {
        const ImVec2 min{area.x + area.w - margin - w, y}, max{area.x + area.w - margin, y + w / shown.aspect};
        const ImVec2 low{0, shown.rendered ? 1.0f : 0.0f}, high{1, shown.rendered ? 0.0f : 1.0f};
        const GLuint texture = shown.rendered ? image_->texture() : pixels_.name();
        list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), min, max, low, high);
        list.AddRect(min, max, colour(theme::ink), 0, 0, 1.5f * ui.unit);
        const ImVec2 text = ImGui::CalcTextSize(shown.title.c_str());
        list.AddRectFilled({min.x, max.y - text.y - 4 * ui.unit}, {min.x + text.x + 8 * ui.unit, max.y},
                           IM_COL32(255, 255, 255, 225));
        list.AddText({min.x + 4 * ui.unit, max.y - text.y - 2 * ui.unit}, IM_COL32(0, 0, 0, 255), shown.title.c_str());
        y = max.y + margin;
    }
}

}  // namespace sightline
