// The insets (core/draw/insets.h) in the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "shell/gl/handles.h"
#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"
#include "shell/window/ui.h"

namespace sightline {

/// Made, used and destroyed while one OpenGL context is current.
class InsetPicture {
public:
    /// As the setting `inset` asks. A new revision says that the session may have changed. Draws off screen; leaves the
    /// default framebuffer bound.
    void update(const Session<3>& session, std::uint64_t revision);
    /// In the upper right corner of the area.
    void draw(ImDrawList& list, const Ui& ui, const Area& area) const;

private:
    struct Shown {
        std::string title;
        float aspect = 1;
        bool rendered = false;  ///< in image_, else in pixels_
    };

    std::uint64_t revision_ = 0;
    std::vector<Shown> shown_;
    SolidRenderer renderer_;
    std::optional<GlTarget> image_;
    GlTexture pixels_;
};

}  // namespace sightline
