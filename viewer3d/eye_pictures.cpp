// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/eye_pictures.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/draw/depth_picture.h"
#include "core/draw/insets.h"
#include "core/draw/palette.h"
#include "core/draw/shown_cells.h"
#include "core/draw/wrong_picture.h"
#include "core/session/settings_table.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Of the image at this step and of the plan, in pixels.
constexpr int image_side = 480, plan_side = 640;
/// Of the plan, for widths of lines.
constexpr double plan_pixels_a_point = 2;

/// Over what is of an earlier frame.
constexpr ImU32 veil = IM_COL32(255, 255, 255, 150);

bool shows_image(const Settings& s) { return s.inset == Inset::image || s.inset == Inset::both; }
bool shows_missed(const Settings& s) {
    return s.inset == Inset::missed || s.inset == Inset::both || s.split == Split::missed;
}
bool shows_exact(const Settings& s) { return s.inset == Inset::exact || s.split == Split::exact; }

void make(std::optional<GlTarget>& target, const ImageSize& size) {
    if (!target || target->width() != size.width || target->height() != size.height)
        target.emplace(size.width, size.height, 1, true);
}

void upload(const GlTexture& texture, const Pixels& pixels) {
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.colours.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

void add_image(ImDrawList& list, GLuint texture, bool upside_down, const Area& area) {
    const ImVec2 low{0, upside_down ? 1.0f : 0.0f}, high{1, upside_down ? 0.0f : 1.0f};
    list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), area.min(), area.max(), low,
                  high);
}

/// Of the reference's shape, in the middle of the area.
Area place_in(const Area& area, const ImageSize& size) {
    const float scale = std::min(area.w / static_cast<float>(size.width), area.h / static_cast<float>(size.height));
    const float w = static_cast<float>(size.width) * scale, h = static_cast<float>(size.height) * scale;
    return {area.x + (area.w - w) / 2, area.y + (area.h - h) / 2, w, h};
}

}  // namespace

void EyePictures::draw(GlTarget& target, const SolidList& list) {
    renderer_.set(list);
    target.bind();
    renderer_.draw(list.camera, 0, 0, target.width(), target.height(), 1);
    target.resolve();
}

void EyePictures::draw_plan(const Session<3>& session) {
    plan_ = viewpoint_plan(session);
    if (!plan_) return;
    const double aspect = plan_->aspect();
    const auto pixels = [](double share) { return std::max(1, static_cast<int>(plan_side * std::min(1.0, share))); };
    make(plan_image_, {pixels(aspect), pixels(1 / aspect)});
    plan_image_->bind();
    const Colour& paper = colours(session.settings().palette).background;
    glDisable(GL_SCISSOR_TEST);
    glClearColor(paper.r / 255.0f, paper.g / 255.0f, paper.b / 255.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    plan_renderer_.set(plan_->list);
    plan_renderer_.draw({plan_->list.world, 0, 0, plan_image_->width(), plan_image_->height(), plan_pixels_a_point, 1});
    plan_image_->resolve();
}

void EyePictures::update(const Session<3>& session, std::uint64_t revision) {
    if (revision == revision_) return;
    revision_ = revision;
    draw_plan(session);
    const Settings& settings = session.settings();
    const ImageSize size = image_size<3>(settings.reference_size);
    if (shows_image(settings)) {
        const int longer = std::max(size.width, size.height);
        make(image_, {std::max(1, image_side * size.width / longer), std::max(1, image_side * size.height / longer)});
        draw(*image_, image_so_far(session));
    }
    if (shows_depth(settings)) {
        const DepthPicture depth = depth_picture(session, settings.inset == Inset::pyramid);
        upload(depth_, depth.pixels);
        depth_title_ = depth_title(settings, depth.text);
    }
    if (!shows_missed(settings) && !shows_exact(settings)) return;
    stale_ = session.flying() && !session.has_reference();
    if (stale_) return;
    if (shows_exact(settings)) {
        make(exact_, size);
        draw(*exact_, exact_image(session));
    }
    if (shows_missed(settings)) {
        const Pixels pixels = wrong_picture(session.reference(), session.wrong_mask(), session.scene());
        upload(missed_, pixels);
    }
}

std::vector<EyePictures::Shown> EyePictures::inset_pictures(const Session<3>& session) const {
    const Settings& s = session.settings();
    const ImageSize size = image_size<3>(s.reference_size);
    std::vector<Shown> pictures;
    if (shows_image(s) && image_) pictures.push_back({image_->texture(), true, title_of_image, false});
    if (s.inset == Inset::exact && exact_) pictures.push_back({exact_->texture(), true, title_of_exact, true});
    if (s.inset == Inset::missed || s.inset == Inset::both)
        pictures.push_back({missed_.name(), false, title_of_missed, true});
    if (shows_depth(s)) pictures.push_back({depth_.name(), false, depth_title_, false});
    for (Shown& shown : pictures) shown.aspect = static_cast<double>(size.width) / size.height;
    if (plan_ && plan_image_)
        pictures.push_back({plan_image_->texture(), true, plan_->title, false, plan_->aspect(), false});
    return pictures;
}

std::vector<Area> EyePictures::insets(const Ui& ui, const Area& area, const Session<3>& session) const {
    const std::vector<Shown> pictures = inset_pictures(session);
    const float margin = 10 * ui.unit;
    float stacked = 0;  // heights of all, one wide
    for (const Shown& shown : pictures) stacked += static_cast<float>(1 / shown.aspect);
    // All of them fit below each other.
    const float room = area.h - margin * static_cast<float>(pictures.size() + 1);
    const float w = std::max(1.0f, std::min({area.w * 0.28f, 320 * ui.unit, room / stacked}));
    std::vector<Area> areas;
    float y = area.y + margin;
    for (const Shown& shown : pictures) {
        const float h = w / static_cast<float>(shown.aspect);
        areas.push_back({area.x + area.w - margin - w, y, w, h});
        y += h + margin;
    }
    return areas;
}

void EyePictures::draw_insets(ImDrawList& list, const Ui& ui, const Area& area, const Session<3>& session) const {
    const std::vector<Shown> pictures = inset_pictures(session);
    const std::vector<Area> areas = insets(ui, area, session);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Shown& shown = pictures[i];
        const Area& at = areas[i];
        add_image(list, shown.texture, shown.upside_down, at);
        if (shown.measured && stale_) list.AddRectFilled(at.min(), at.max(), veil);
        list.AddRect(at.min(), at.max(), colour(theme::ink), 0, 0, 1.5f * ui.unit);
        const char* const title = shown.measured && stale_ ? "measured when the eye stops" : shown.title.c_str();
        ImVec2 text = ImGui::CalcTextSize(title);
        const float shrunk = std::min(1.0f, (at.w - 8 * ui.unit) / text.x);  // into a narrow one
        text = {text.x * shrunk, text.y * shrunk};
        const float top = at.y + at.h - text.y - 4 * ui.unit;
        list.AddRectFilled({at.x, top}, {at.x + text.x + 8 * ui.unit, at.y + at.h}, IM_COL32(255, 255, 255, 225));
        list.AddText(ui.fonts.text, ImGui::GetFontSize() * shrunk, {at.x + 4 * ui.unit, top + 2 * ui.unit},
                     IM_COL32(0, 0, 0, 255), title);
    }
}

void EyePictures::draw_split(ImDrawList& list, const Area& area, const Session<3>& session) const {
    const bool exact = session.settings().split == Split::exact;
    if (exact && !exact_) return;
    const ImageSize size = image_size<3>(session.settings().reference_size);
    const Area at = place_in(area, size);
    add_image(list, exact ? exact_->texture() : missed_.name(), exact, at);
    if (stale_) list.AddRectFilled(at.min(), at.max(), veil);
    list.AddRect(at.min(), at.max(), colour(theme::line));
}

std::optional<std::array<int, 2>> EyePictures::pixel_at(const Ui& ui, const ImVec2& at, const Area& area,
                                                        const std::optional<Area>& split,
                                                        const Session<3>& session) const {
    if (session.flying() || stale_) return std::nullopt;
    const ImageSize size = image_size<3>(session.settings().reference_size);
    const std::vector<Shown> pictures = inset_pictures(session);
    std::vector<Area> places = insets(ui, area, session);
    while (!places.empty() && !pictures[places.size() - 1].of_eye) places.pop_back();  // the plan is the last one
    if (split) places.push_back(place_in(*split, size));
    for (const Area& place : places) {
        if (!place.contains(at)) continue;
        const auto pixel = [](float share, int count) {
            return std::clamp(static_cast<int>(share * static_cast<float>(count)), 0, count - 1);
        };
        return std::array{pixel((at.x - place.x) / place.w, size.width),
                          pixel((at.y - place.y) / place.h, size.height)};
    }
    return std::nullopt;
}

std::string EyePictures::split_title(const Session<3>& session) const {
    const bool exact = session.settings().split == Split::exact;
    std::string title = seen_from_outside(session) ? "frozen eye: " : "";
    title += exact ? title_of_exact : title_of_missed;
    if (stale_) return title + ", when the eye stops";
    if (exact) return title + ", " + std::to_string(session.reference().count) + " visible triangles";
    return title;
}

}  // namespace sightline
