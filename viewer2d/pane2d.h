// One session's picture in the window: lists, OpenGL and labels, made again only when they change.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/eye_strip.h"
#include "core/draw/picture.h"
#include "shell/gl/list_renderer.h"
#include "shell/gl/target.h"
#include "shell/gl/texture_quad.h"
#include "shell/pane/fade.h"
#include "shell/pane/pane_texts.h"
#include "viewer2d/camera.h"

namespace sightline {

class Pane2d {
public:
    /// Brings everything up to date. `options.world` fills the area. Draws off screen; leaves the default framebuffer
    /// bound.
    void update(const Ui& ui, const Session<2>& session, const PictureOptions& options, const PaneFrame& frame,
                const Area& area);

    /// Lays the picture onto the default framebuffer.
    void draw() const;
    bool fading() const { return fade_.running(ImGui::GetTime()); }
    /// Labels of the picture and texts of the legend.
    void draw_texts(ImDrawList& list, const Ui& ui) const;

    const Camera& camera() const { return camera_; }
    /// Where the labels stand; those of notes have the numbers of the current notes (core/draw/notes.h).
    const std::vector<LabelSpot>& spots() const { return texts_.spots(); }
    /// What the eye sees in this picture; nullptr where that is not shown.
    const EyeStrip* strip() const { return strip_ ? &*strip_ : nullptr; }

private:
    /// What the layer of borders was drawn from.
    struct Borders {
        std::vector<Vec<2>> points;
        std::vector<std::uint32_t> facet_points;
        Palette palette{};
        Box<2> world;
        PaneSize size;
    };

    void add_legend(const Ui& ui, const Session<2>& session, const PictureOptions& options);
    void draw_borders(const Session<2>& session, const PictureOptions& options, const ListView& view);
    void render(const Session<2>& session, const PictureOptions& options);
    ListView view(const Box<2>& world) const;

    Camera camera_;
    PaneSize size_;
    std::uint64_t revision_ = 0;
    std::optional<EyeStrip> strip_;
    DrawList below_, above_;
    ListRenderer below_renderer_, border_renderer_, above_renderer_;
    TextureQuad quad_;
    std::optional<GlTarget> picture_, border_picture_;
    Fade fade_;
    Borders borders_;
    PaneTexts texts_;
};

}  // namespace sightline
