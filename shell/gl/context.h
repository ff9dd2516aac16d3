// A window with an OpenGL 3.3 core context, or a context without one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SDL.h>

#include <memory>
#include <string>
#include <vector>

namespace sightline {

/// A window system (X11, Wayland, …) that windows can be opened on, if SDL finds one, and the connection to it: not
/// given up and taken again between looking and opening a window, which some servers do not bear. SDL's off-screen
/// drivers do not count, nor does the bare console, which a program started from a distance must not seize.
/// SDL_VIDEODRIVER narrows the choice as usual. None is found during the life of a GlContext off screen.
class Display {
public:
    Display();
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    bool found() const { return found_; }

private:
    bool found_ = false;
};

/// Whether some OpenGL context is current in this thread.
bool has_current_context();

class GlContext {
public:
    enum class Place { window, off_screen };

    /// Opens a window of this size in screen units (which may be several pixels), resizable, or a context that shows
    /// nothing and needs no display. The context is current afterwards. Throws WorkError that says what was found and
    /// what to install when there is no display or no OpenGL 3.3.
    GlContext(Place place, const std::string& title, int width, int height);
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    SDL_Window* window() const { return window_.get(); }
    SDL_GLContext handle() const { return context_.get(); }
    void make_current() const;
    /// The OpenGL version and the renderer's name, for reports.
    std::string description() const;

    /// What the driver complained about since the start: errors, and messages of medium or high severity. Each text
    /// once. Empty for a driver without KHR_debug.
    const std::vector<std::string>& messages() const { return *messages_; }

private:
    struct Video {
        explicit Video(Place place);
        ~Video();
        Video(const Video&) = delete;
        Video& operator=(const Video&) = delete;
    };
    struct WindowDestroy {
        void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    };
    struct ContextDestroy {
        void operator()(void* context) const { SDL_GL_DeleteContext(context); }
    };

    Video video_;
    std::unique_ptr<SDL_Window, WindowDestroy> window_;
    std::unique_ptr<void, ContextDestroy> context_;
    std::unique_ptr<std::vector<std::string>> messages_;  ///< at an address that the driver may keep
};

}  // namespace sightline
