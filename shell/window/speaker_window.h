// A second window for the one who speaks: notes, what comes next, and the time. It shares the OpenGL context.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <memory>
#include <vector>

#include "shell/gl/context.h"
#include "shell/panels/panel.h"

namespace sightline {

class SpeakerWindow {
public:
    /// Opens it. The context must live longer, and is current in its own window afterwards. Throws WorkError.
    explicit SpeakerWindow(const GlContext& context);
    ~SpeakerWindow();
    SpeakerWindow(const SpeakerWindow&) = delete;
    SpeakerWindow& operator=(const SpeakerWindow&) = delete;

    Uint32 id() const { return SDL_GetWindowID(window_.get()); }
    /// The rows, the first of them large. Leaves the context current in its own window.
    void draw(const std::vector<Row>& rows);

private:
    struct WindowDestroy {
        void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    };
    class InUse;

    const GlContext& context_;
    std::unique_ptr<SDL_Window, WindowDestroy> window_;
    ImGuiContext* gui_ = nullptr;
    ImFont *text_ = nullptr, *large_ = nullptr;
};

}  // namespace sightline
