// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/inset_picture.h"

#include <algorithm>

#include "core/draw/wrong_picture.h"
#include "core/settings/settings_table.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Of the rendered image, in pixels.
constexpr int image_width = 480;

/// What is rendered so far, as the culling view sees it.
SolidList rendered_so_far(const Session<3>& session) {
    SolidList list;
    list.camera = session.frame().view;
    list.styles = {{"rendered", {200, 200, 205}, true}};
    list.scene = session.shared_scene();
    const State<3>& state = session.state();
    for (const std::uint32_t entry : std::span(state.touched).first(state.touched_count))
        if (!(entry & State<3>::culled_bit)) list.triangles.push_back(entry);
    list.runs = {{0, 0, static_cast<std::uint32_t>(list.triangles.size())}};
    return list;
}

bool shows_image(const Session<3>& s) {
    return s.settings().inset == Inset::image || s.settings().inset == Inset::both;
}
bool shows_missed(const Session<3>& s) {
    return s.settings().inset == Inset::missed || s.settings().inset == Inset::both;
}

}  // namespace

void InsetPicture::update(const Session<3>& session, std::uint64_t revision) {
    if (revision == revision_) return;
    revision_ = revision;
    if (shows_image(session)) {
        const ImageSize size = image_size<3>(session.settings().reference_size);
        const int height = std::max(1, image_width * size.height / size.width);
        if (!image_ || image_->height() != height) image_.emplace(image_width, height, 1, true);
        const SolidList list = rendered_so_far(session);
        renderer_.set(list);
        image_->bind();
        renderer_.draw(list.camera, 0, 0, image_width, height, 1);
        image_->resolve();
    }
    if (shows_missed(session)) {
        const State<3>& state = session.state();
        const Pixels pixels = wrong_picture(session.reference(), std::span(state.touched).first(state.touched_count));
        glBindTexture(GL_TEXTURE_2D, missed_.name());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     pixels.colours.data());
        glBindTexture(GL_TEXTURE_2D, 0);
    }
}

void InsetPicture::draw(ImDrawList& list, const Ui& ui, const Area& area, const Session<3>& session) const {
    const ImageSize size = image_size<3>(session.settings().reference_size);
    const float w = std::min(area.w * 0.28f, 320 * ui.unit), h = w * static_cast<float>(size.height) / size.width;
    const float margin = 10 * ui.unit;
    float y = area.y + margin;
    const auto show = [&](GLuint texture, bool upside_down, const char* title) {
        const ImVec2 min{area.x + area.w - margin - w, y}, max{area.x + area.w - margin, y + h};
        const ImVec2 low{0, upside_down ? 1.0f : 0.0f}, high{1, upside_down ? 0.0f : 1.0f};
        list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), min, max, low, high);
        list.AddRect(min, max, colour(theme::ink), 0, 0, 1.5f * ui.unit);
        const ImVec2 text = ImGui::CalcTextSize(title);
        list.AddRectFilled({min.x, max.y - text.y - 4 * ui.unit}, {min.x + text.x + 8 * ui.unit, max.y},
                           IM_COL32(255, 255, 255, 225));
        list.AddText({min.x + 4 * ui.unit, max.y - text.y - 2 * ui.unit}, IM_COL32(0, 0, 0, 255), title);
        y += h + margin;
    };
    if (shows_image(session) && image_) show(image_->texture(), true, "the culling eye, so far");
    if (shows_missed(session)) show(missed_.name(), false, "missed pixels");
}

}  // namespace sightline
