// One session's 3D picture in the window: solids, lines and labels, each made again only when it changes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/picture_3d.h"
#include "shell/gl/list_renderer.h"
#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"
#include "shell/gl/texture_quad.h"
#include "shell/pane/fade.h"
#include "shell/pane/pane_texts.h"

namespace sightline {

/// The small pictures over a pane: where they stand, and the one that is a list, which the legend explains too.
struct PaneInsets {
    std::vector<Area> areas;
    const DrawList* plan = nullptr;  ///< nullptr: none is
};

class Pane3d {
public:
    /// Brings everything up to date. `moving`: fast rather than smooth. Draws off screen; leaves the default
    /// framebuffer bound. Labels and legend keep off the insets. False: there was nothing to draw again.
    bool update(const Ui& ui, const Session<3>& session, const PictureOptions3& options, const PaneFrame& frame,
                const Area& area, bool moving, const PaneInsets& insets);

    /// Lays the picture onto the default framebuffer.
    void draw() const;
    bool fading() const { return fade_.running(ImGui::GetTime()); }
    /// Labels of the picture and texts of the legend.
    void draw_texts(ImDrawList& list, const Ui& ui) const;

    const View<3>& camera() const { return solid_.camera; }
    const SolidList& solid() const { return solid_; }
    const Area& area() const { return area_; }
    ImVec2 to_window(const Vec<2>& plane) const;
    /// The point of the picture's plane under a point of the window.
    Vec<2> to_plane(const ImVec2& window) const;
    const std::vector<LabelSpot>& spots() const { return texts_.spots(); }
    double draw_ms() const { return draw_ms_; }  ///< of the last time

private:
    /// What the solids were made from, but for the camera.
    struct SolidKey {
        const Scene<3>* scene = nullptr;
        std::uint64_t run = 0;
        std::uint32_t position = 0, cell = none, primitive = none, node = none, plane = none;
        bool outside = false, frozen = false, flying = false;
        std::vector<Differs> differences;
        Settings settings;
        std::optional<std::uint32_t> facet;
        std::optional<ViewSpec<3>> made_from;  ///< where what is shown turns with the view
        std::optional<std::array<double, 2>> heat;
        bool operator==(const SolidKey&) const = default;
    };

    void make_solid_list(const Session<3>& session, const PictureOptions3& options, std::uint64_t run);
    void add_legend(const Ui& ui, const Session<3>& session, const PictureOptions3& options, const PaneInsets& insets);
    void render(bool moving);

    Area area_;
    PaneSize size_;
    std::uint64_t revision_ = 0;
    std::optional<SolidKey> key_;
    SolidList solid_;
    DrawList over_;
    SolidRenderer solid_renderer_;
    ListRenderer over_renderer_;
    TextureQuad quad_;
    std::optional<GlTarget> picture_;
    Fade fade_;
    PaneTexts texts_;
    double draw_ms_ = 0;
};

}  // namespace sightline
