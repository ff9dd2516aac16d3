// What the culling eye sees: at this very step, of everything, and which pixels it misses; as insets, or in the second
// half of a split picture. And the plan of a method that chooses by viewpoint.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/draw/viewpoint_plan.h"
#include "core/session/session.h"
#include "shell/gl/handles.h"
#include "shell/gl/list_renderer.h"
#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"
#include "shell/window/ui.h"

namespace sightline {

/// Made, used and destroyed while one OpenGL context is current.
class EyePictures {
public:
    /// As the settings `inset`, `split` and `show_regions` ask. A new revision says that the session may have changed.
    /// What needs the reference stays as it was during a flight without one. Draws off screen; leaves the default
    /// framebuffer bound.
    void update(const Session<3>& session, std::uint64_t revision);

    /// Where the insets stand: in the upper right corner of the area, below each other. Empty without one.
    std::vector<Area> insets(const Ui& ui, const Area& area, const Session<3>& session) const;
    void draw_insets(ImDrawList& list, const Ui& ui, const Area& area, const Session<3>& session) const;

    /// The picture that `split` asks for, in the middle of the area; its words are split_title.
    void draw_split(ImDrawList& list, const Area& area, const Session<3>& session) const;
    std::string split_title(const Session<3>& session) const;

    /// The pixel of the reference's image, column and row from the top, that an inset or the split half shows at a
    /// place of the window; nothing elsewhere, and while the reference is not there.
    std::optional<std::array<int, 2>> pixel_at(const Ui& ui, const ImVec2& at, const Area& area,
                                               const std::optional<Area>& split, const Session<3>& session) const;

    /// The plan that stands among the insets, for legends; nullptr without one.
    const DrawList* plan() const { return plan_ ? &plan_->list : nullptr; }

private:
    struct Shown {
        GLuint texture = 0;
        bool upside_down = false;  ///< rows from the bottom
        std::string title;
        bool measured = false;  ///< needs the reference
        double aspect = 1;      ///< width / height
        bool of_eye = true;     ///< an image of the culling eye
    };
    std::vector<Shown> inset_pictures(const Session<3>& session) const;
    void draw(GlTarget& target, const SolidList& list);
    void draw_plan(const Session<3>& session);

    std::uint64_t revision_ = 0;
    SolidRenderer renderer_;
    std::optional<GlTarget> image_, exact_;
    GlTexture missed_, depth_;
    std::string depth_title_;
    std::optional<ViewpointPlan> plan_;
    ListRenderer plan_renderer_;
    std::optional<GlTarget> plan_image_;
    bool stale_ = false;  ///< what needs the reference is of an earlier frame of the flight
};

}  // namespace sightline
