// The picture of a step comes out of the one before it: what is new fades in.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "shell/gl/target.h"
#include "shell/gl/texture_quad.h"
#include "shell/pane/pane_area.h"

namespace sightline {

/// What a picture shows, as far as it decides whether a new one fades in: only another place in the same run does.
struct FadeOf {
    std::uint64_t run = 0;  ///< Workbench::run
    std::uint32_t position = 0;
    PaneSize size;
    bool animate = false;  ///< Desk::animate
};

class Fade {
public:
    /// Before a picture is drawn anew. Where it will fade in, takes the one before out of `picture`.
    void next(std::optional<GlTarget>& picture, const FadeOf& what, double now);
    /// Over the new picture, in the default framebuffer. `now` in seconds.
    void draw(const TextureQuad& quad, const PaneSize& size, double now) const;
    bool running(double now) const { return before_ && now - started_ < seconds; }

    static constexpr double seconds = 0.15;

private:
    std::optional<GlTarget> before_;
    double started_ = 0;
    FadeOf shown_;
};

}  // namespace sightline
