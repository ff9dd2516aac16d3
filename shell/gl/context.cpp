// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/context.h"

#include <dlfcn.h>
#include <epoxy/gl.h>
#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "core/base/error.h"

namespace sightline {

namespace {

constexpr const char* remedy = " (on Debian install libgl1-mesa-dri and libegl1, or the driver of the graphics card)";
constexpr std::size_t most_messages = 100;  // an error in every frame must not fill the memory

bool is_window_system(std::string_view driver) {
    return driver != "offscreen" && driver != "dummy" && driver != "evdev" && driver != "KMSDRM";
}

bool is_complaint(GLenum type, GLenum severity) {
    return type == GL_DEBUG_TYPE_ERROR || severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM;
}

void APIENTRY collect(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                      const void* messages) {
    if (!is_complaint(type, severity)) return;
    auto& all = *static_cast<std::vector<std::string>*>(const_cast<void*>(messages));
    std::string words(text, length >= 0 ? static_cast<std::size_t>(length) : std::string_view(text).size());
    if (all.size() < most_messages && std::find(all.begin(), all.end(), words) == all.end())
        all.push_back(std::move(words));
}

std::string string_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

void ask_for_core_profile() {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, SDL_GL_CONTEXT_FORWARD_COMPATIBLE_FLAG | SDL_GL_CONTEXT_DEBUG_FLAG);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
}

/// Mesa's software renderer takes tens of megabytes for a frame and frees them after it. Going back to the system and
/// coming again as empty pages, they cost up to a quarter of the frame.
void keep_freed_memory() {
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, 128 << 20);
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
#endif
}

/// The version of whatever context the driver gives when nothing is asked for.
std::string version_found(SDL_Window* window) {
    SDL_GL_ResetAttributes();
    void* const context = SDL_GL_CreateContext(window);
    if (!context) return "no OpenGL at all";
    const std::string version = "OpenGL " + string_of(GL_VERSION);
    SDL_GL_DeleteContext(context);
    return version;
}

using X11ErrorHandler = int (*)(void* display, void* error);

/// Where SDL uses X11. Returns the handler before.
X11ErrorHandler set_x11_error_handler(X11ErrorHandler handler) {
    void* const x11 = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
    if (!x11) return nullptr;
    const auto set = reinterpret_cast<X11ErrorHandler (*)(X11ErrorHandler)>(dlsym(x11, "XSetErrorHandler"));
    const X11ErrorHandler before = set ? set(handler) : nullptr;
    dlclose(x11);
    return before;
}

int ignore_x11_error(void*, void*) { return 0; }

}  // namespace

Display::Display() {
    const char* before = SDL_GetHint(SDL_HINT_VIDEODRIVER);
    const std::string asked = before ? before : "";
    const auto connect = [&](const std::string& driver) {
        // Its library complains on standard error where it cannot be at all.
        if (driver == "wayland" && !std::getenv("XDG_RUNTIME_DIR")) return false;
        if (!is_window_system(driver)) return false;
        SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, driver.c_str(), SDL_HINT_OVERRIDE);
        const bool good = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
        SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, asked.c_str(), SDL_HINT_OVERRIDE);
        if (!good || is_window_system(SDL_GetCurrentVideoDriver())) return good;
        SDL_QuitSubSystem(SDL_INIT_VIDEO);  // that of a context off screen
        return false;
    };
    if (!asked.empty()) {
        found_ = connect(asked);
        return;
    }
    for (int i = 0; i < SDL_GetNumVideoDrivers() && !found_; ++i) found_ = connect(SDL_GetVideoDriver(i));
}

Display::~Display() {
    if (found_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

GlContext::Video::Video(Place place) {
    // SDL has one video driver per process: the first context chooses it, later ones share it.
    const char* before = SDL_GetHint(SDL_HINT_VIDEODRIVER);
    const std::string kept = before ? before : "";
    if (place == Place::off_screen) SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "offscreen", SDL_HINT_OVERRIDE);
    const bool good = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
    const std::string why = good ? "" : SDL_GetError();
    if (place == Place::off_screen) SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, kept.c_str(), SDL_HINT_OVERRIDE);
    if (!good) throw WorkError("SDL finds no video driver for a window or an OpenGL context: " + why + remedy);
    // Without a display SDL falls back on drivers that show nothing.
    if (place == Place::window && !is_window_system(SDL_GetCurrentVideoDriver())) {
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
        throw WorkError("there is no display to open a window on (neither X11 nor Wayland answers)");
    }
}

GlContext::Video::~Video() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }

bool has_current_context() { return SDL_GL_GetCurrentContext() != nullptr; }

GlContext::GlContext(Place place, const std::string& title, int width, int height)
    : video_(place), messages_(std::make_unique<std::vector<std::string>>()) {
    ask_for_core_profile();
    const Uint32 shown =
        place == Place::window ? SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI : Uint32{SDL_WINDOW_HIDDEN};
    // Without a driver X11 complains late, and its own handler ends the program before anything is said.
    const X11ErrorHandler handler = set_x11_error_handler(ignore_x11_error);
    window_.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, width, height,
                                   SDL_WINDOW_OPENGL | shown));
    if (!window_) throw WorkError("SDL cannot open a window for OpenGL: " + std::string(SDL_GetError()) + remedy);
    context_.reset(SDL_GL_CreateContext(window_.get()));
    const std::string why = context_ ? "" : SDL_GetError();
    if (!context_ || epoxy_gl_version() < 33)
        throw WorkError("OpenGL 3.3 is needed; found: " +
                        (context_ ? string_of(GL_VERSION) : version_found(window_.get()) + " (" + why + ")") + remedy);
    set_x11_error_handler(handler);
    if (string_of(GL_RENDERER).find("llvmpipe") != std::string::npos) keep_freed_memory();
    if (epoxy_has_gl_extension("GL_KHR_debug")) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(collect, messages_.get());
    }
}

GlContext::~GlContext() = default;

void GlContext::make_current() const {
    if (SDL_GL_MakeCurrent(window_.get(), context_.get()) != 0)
        throw WorkError("the OpenGL context cannot be used: " + std::string(SDL_GetError()));
}

std::string GlContext::description() const { return "OpenGL " + string_of(GL_VERSION) + ", " + string_of(GL_RENDERER); }

}  // namespace sightline
